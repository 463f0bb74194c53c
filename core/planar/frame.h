// SPDX-License-Identifier: GPL-3.0-or-later
// Exact positions in a plane: rounding moves a point only within its carrier (theory.md section 5).
#pragma once

#include <array>

#include "core/complex/complex.h"
#include "core/numbers/point.h"

namespace confidel {

using Double3 = std::array<double, 3>;

inline Double3 operator+(const Double3& a, const Double3& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
inline Double3 operator-(const Double3& a, const Double3& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
inline Double3 operator*(double s, const Double3& a) { return {s * a[0], s * a[1], s * a[2]}; }
inline double dot(const Double3& a, const Double3& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
inline Double3 cross(const Double3& a, const Double3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
double length(const Double3& a);

/// Where to look for points: for pruning only. Of unknown size while the radius is negative.
struct Ball {
  Double3 centre{};
  double radius = -1;
};

/// The difference to - from, each component with a relative error of about 2^-52: cancellation does no harm.
Double3 approximate_difference(const Point& to, const Point& from);

/// The unit vector of an integer vector, to double precision, whatever the integers' size.
Double3 unit_vector(const IntegerVector& vector);

/// A dyadic rational numerator / 2^exponent.
struct Dyadic {
  mpz_class numerator;
  int exponent = 0;
  double approximate() const;
};

/// The multiple of 2^-bits that is nearest to value, for bits with 2^-bits <= tolerance < 2^(1-bits).
/// Throws std::range_error if the tolerance is below 2^-1000, or the value is none.
Dyadic round_to(long double value, double tolerance);
/// The exact arithmetic mean.
Dyadic midpoint(const Dyadic& a, const Dyadic& b);

/// from + t (to - from), exactly: on the line through the two points, whatever they are.
Point along(const Point& from, const Point& to, const Dyadic& t);

/// base + factor * direction, exactly.
Point translate(const Point& base, const Dyadic& factor, const IntegerVector& direction);

/// The affine frame of a plane: two integer directions that span it.
class PlaneFrame {
 public:
  /// Prefers directions of input edges (few bits); falls back on an orthogonal pair where those are nearly parallel.
  PlaneFrame(const Complex& complex, const Facet& facet);

  /// A point of the plane within tolerance of base + offset. Pre: base lies in the plane, offset is (nearly) parallel to it.
  /// Exactness: the result lies in the plane exactly. Its numerators have about log2(|offset| / tolerance) bits beyond the frame's.
  Point round(const Point& base, const Double3& offset, double tolerance) const;

  const IntegerVector& normal() const { return normal_; }
  const Double3& unit_normal() const { return unit_normal_; }

 private:
  IntegerVector normal_;
  Double3 unit_normal_{};
  IntegerVector directions_[2];
  std::array<long double, 3> approximate_[2]{};
  std::array<long double, 3> dual_[2]{};  ///< offset . dual_[i] = coefficient of directions_[i]
  double lengths_[2]{};
};

}  // namespace confidel
