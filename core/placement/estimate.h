// SPDX-License-Identifier: GPL-3.0-or-later
// How many points the graded strategy is going to place: floating point, for the reader and for limits only.
#pragma once

#include "core/complex/complex.h"
#include "core/placement/buffer_zones.h"

namespace confidel {

/// A piece of a segment with its rows that is still encroached.
struct OpenInterval {
  SegmentId segment;
  int rows;  ///< points per station: one on the segment and one per protector
  Double3 first, second;
};

/// The expected number of further points: the grading of theory.md section 4 as a number. Per open interval the integral of 1/g
/// along it, g the distance to what does not contain its segment; over the facets the integral of 1/D^2, D the distance to what is not
/// coplanar (in balls and strips, which have no such triangles, not below its value at their rim). Integrals by random descents into
/// halved intervals and quartered triangles (Knuth's estimator of tree sizes) with a fixed seed: the time does not depend on the result.
/// The constants are calibrated on the inputs of docs/results.md.
double estimate_further_points(const Complex& complex, const BufferSizes& sizes, const std::vector<OpenInterval>& intervals);

}  // namespace confidel
