// SPDX-License-Identifier: GPL-3.0-or-later
// Exact points with dyadic coordinates, and their double-double approximations for filters.
#pragma once

#include <gmpxx.h>

#include <array>
#include <cstdint>
#include <vector>

namespace confidel {

/// An exact vector of three integers. Used for normals and directions, whose length is irrelevant.
using IntegerVector = std::array<mpz_class, 3>;

/// A point (x, y, z) / 2^exponent with integers x, y, z. Every finite double, and every position that is
/// computed from doubles with dyadic parameters, is such a point; planar inputs have z = 0.
///
/// Invariant: normalised, i.e. exponent is the smallest one for which x, y and z are integers
/// (exponent may be negative; the origin has exponent 0). Equal points have equal representations.
class Point {
 public:
  Point();
  Point(mpz_class x, mpz_class y, mpz_class z, int exponent);

  /// Exact. Precondition: the arguments are finite.
  static Point from_doubles(double x, double y, double z);

  const mpz_class& numerator(int axis) const { return numerator_[axis]; }
  int exponent() const { return exponent_; }

  /// Double-double approximation: |coordinate - (high + low)| <= 2^-104 |coordinate|, provided that the
  /// coordinate is 0 or has a magnitude in [2^-900, 2^1000]; an absolute error below 2^-1000 under, infinite beyond.
  double high(int axis) const { return high_[axis]; }
  double low(int axis) const { return low_[axis]; }

  /// The nearest double, up to one unit in the last place: steering only.
  double approximate(int axis) const { return high_[axis]; }
  std::array<double, 3> approximate() const { return {high_[0], high_[1], high_[2]}; }

  /// At least max(2^-100, |x|, |y|, |z|): the filters' floor scales with it.
  static constexpr float least_magnitude = 0x1p-100F;
  float magnitude() const { return magnitude_; }

  /// The same point times 2^power: exact.
  Point scaled(int power) const;

  bool operator==(const Point& other) const;
  /// Exact lexicographic comparison by (x, y, z).
  static int compare(const Point& a, const Point& b);
  bool operator<(const Point& other) const { return compare(*this, other) < 0; }

  /// Equal points have equal hashes.
  std::size_t hash() const;

 private:
  void approximate_coordinates();

  std::array<mpz_class, 3> numerator_;
  std::array<double, 3> high_{};
  std::array<double, 3> low_{};
  int exponent_ = 0;
  float magnitude_ = least_magnitude;
};

struct PointHash {
  std::size_t operator()(const Point& point) const { return point.hash(); }
};

/// The differences to - from as integers over a common power of two: to_i - from_i = difference[i] / 2^exponent.
struct Difference {
  IntegerVector vector;
  int exponent = 0;
};
Difference difference(const Point& to, const Point& from);

IntegerVector cross(const IntegerVector& a, const IntegerVector& b);
mpz_class dot(const IntegerVector& a, const IntegerVector& b);

/// Divides by the gcd of the entries (nothing for the zero vector). Keeps the direction.
void make_primitive(IntegerVector& vector);

/// value * 2^power, exactly.
mpq_class times_power_of_two(mpq_class value, long power);

/// A coordinate as a rational number, exactly.
mpq_class rational_coordinate(const Point& point, int axis);

/// The nearest integer to value, exactly for every finite double beyond 2^53.
mpz_class rounded(double value);

/// The primitive integer normal of the plane through a, b, c, in the direction of (b-a) x (c-a).
/// Zero if the points are collinear.
IntegerVector plane_normal(const Point& a, const Point& b, const Point& c);

/// The primitive integer vector in the direction of to - from.
IntegerVector direction(const Point& from, const Point& to);

}  // namespace confidel
