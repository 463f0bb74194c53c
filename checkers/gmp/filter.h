// SPDX-License-Identifier: Apache-2.0
// The float filter: balls in doubles that contain the exact ones, and signs that no rounding can change. Whatever is in doubt is left to
// the integers. Each bound is derived in docs/trust.md, section "The float filter"; (1) to (6) refer to its steps.
#pragma once

#include "certificate.h"

#include <cfloat>
#include <limits>

#ifdef __FAST_MATH__
#error "the float filter needs IEEE arithmetic: compile without -ffast-math"
#endif
static_assert(std::numeric_limits<double>::is_iec559 && std::numeric_limits<double>::digits == 53 && FLT_EVAL_METHOD == 0,
              "the float filter needs doubles that are rounded after each operation");

// Rounding to nearest, for this thread and those that it starts. False: there has to be no filter.
bool setRoundingToNearest();

// The normals n of facets in units of the grid, as doubles: t n is the part of a cell's offset t.
class FloatNormals {
public:
    FloatNormals() = default;
    explicit FloatNormals(const Certificate&);
    // t n, every component within 12 units of relative rounding error; false: out of range.
    bool offset(const Certificate&, const Cell&, double (&result)[3]) const;

private:
    std::vector<std::array<double, 3>> normals_;  // NaN: out of range
};

// Contains the exact ball of a cell or subsegment on the grid of Points.
struct FloatBall {
    double centre[3] = {}, radius2 = 0;

    // The smallest circle through the corners, moved by the offset. False: in doubt.
    bool setCell(const Certificate&, const FloatNormals&, const Cell&);
    // The diametral ball of a subsegment.
    void setBall(const Points&, std::uint32_t a, std::uint32_t b);
};

// The sign of (q-p) x (r-p) along axis i, with j and k the other axes in cyclic order; 0: in doubt.
int floatOrientation(const Points&, std::uint32_t p, std::uint32_t q, std::uint32_t r, int j, int k);
