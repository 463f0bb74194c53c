// SPDX-License-Identifier: GPL-3.0-or-later
// The fallback of the filtered distances: integers all the way, one square root at the end.
#include <algorithm>
#include <cmath>
#include <limits>

#include "core/features/distances.h"

namespace confidel {

namespace {

IntegerVector minus(const IntegerVector& a, const IntegerVector& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }

/// numerator / denominator, not negative; starts as infinity (1/0).
struct Square {
  mpz_class numerator = 1;
  mpz_class denominator = 0;

  void improve(mpz_class other_numerator, mpz_class other_denominator) {
    if (other_numerator * denominator < numerator * other_denominator || denominator == 0) {
      numerator = std::move(other_numerator);
      denominator = std::move(other_denominator);
    }
  }
};

/// From the origin to the segment ab.
void improve_by_segment(Square& square, const IntegerVector& a, const IntegerVector& b) {
  const IntegerVector along = minus(b, a);
  mpz_class squared_length = dot(along, along);
  const mpz_class projection = -dot(a, along);
  if (projection <= 0) {
    square.improve(dot(a, a), 1);
  } else if (projection >= squared_length) {
    square.improve(dot(b, b), 1);
  } else {
    const IntegerVector normal = cross(a, along);
    square.improve(dot(normal, normal), std::move(squared_length));
  }
}

/// From the origin to the triangle abc.
void improve_by_triangle(Square& square, const IntegerVector& a, const IntegerVector& b, const IntegerVector& c) {
  const IntegerVector normal = cross(minus(b, a), minus(c, a));
  // The origin's foot is inside iff the origin is on the inner side of the three planes through the sides, along the
  // normal.
  if (dot(cross(a, b), normal) >= 0 && dot(cross(b, c), normal) >= 0 && dot(cross(c, a), normal) >= 0) {
    const mpz_class height = dot(a, normal);
    square.improve(height * height, dot(normal, normal));
    return;
  }
  improve_by_segment(square, a, b);
  improve_by_segment(square, b, c);
  improve_by_segment(square, c, a);
}

/// Between the insides of segments pq and ab, if the nearest points are there; lines that are parallel add nothing to
/// the ends.
void improve_by_crossing(Square& square, const IntegerVector& p, const IntegerVector& q, const IntegerVector& a,
                         const IntegerVector& b) {
  const IntegerVector u = minus(q, p);
  const IntegerVector v = minus(b, a);
  const IntegerVector normal = cross(u, v);
  mpz_class squared_normal = dot(normal, normal);
  if (squared_normal == 0) return;
  const IntegerVector between = minus(a, p);
  const mpz_class s = dot(cross(between, v), normal);
  const mpz_class t = dot(cross(between, u), normal);
  if (s < 0 || s > squared_normal || t < 0 || t > squared_normal) return;
  const mpz_class height = dot(between, normal);
  square.improve(height * height, std::move(squared_normal));
}

/// True iff the segment pq meets the plane of abc in a point of the triangle.
bool pierces(const IntegerVector& p, const IntegerVector& q, const IntegerVector& a, const IntegerVector& b,
             const IntegerVector& c) {
  const IntegerVector normal = cross(minus(b, a), minus(c, a));
  const int side_p = sgn(dot(minus(p, a), normal));
  const int side_q = sgn(dot(minus(q, a), normal));
  if (side_p * side_q > 0 || (side_p == 0 && side_q == 0)) return false;  // ends and sides decide the coplanar case
  const IntegerVector along = minus(q, p);
  const auto side = [&](const IntegerVector& x, const IntegerVector& y) {
    return sgn(dot(along, cross(minus(x, p), minus(y, p))));
  };
  const int ab = side(a, b);
  const int bc = side(b, c);
  const int ca = side(c, a);
  return (ab >= 0 && bc >= 0 && ca >= 0) || (ab <= 0 && bc <= 0 && ca <= 0);
}

void improve_from_point(Square& square, const IntegerVector& p, const std::vector<IntegerVector>& corners) {
  std::vector<IntegerVector> seen;
  for (const auto& corner : corners) seen.push_back(minus(corner, p));
  if (seen.size() == 1) {
    square.improve(dot(seen[0], seen[0]), 1);
  } else if (seen.size() == 2) {
    improve_by_segment(square, seen[0], seen[1]);
  } else {
    improve_by_triangle(square, seen[0], seen[1], seen[2]);
  }
}

}  // namespace

double exact_distance_below(Simplex a, Simplex b) {
  int exponent = std::numeric_limits<int>::min();
  for (const Corner* corner : a) exponent = std::max(exponent, corner->point->exponent());
  for (const Corner* corner : b) exponent = std::max(exponent, corner->point->exponent());
  const auto integers = [&](Simplex simplex) {
    std::vector<IntegerVector> corners;
    for (const Corner* corner : simplex) {
      auto& position = corners.emplace_back();
      const Point& point = *corner->point;
      for (int k = 0; k < 3; ++k) position[k] = point.numerator(k) << (exponent - point.exponent());
    }
    return corners;
  };
  const auto p = integers(a);
  const auto q = integers(b);
  Square square;
  for (const auto& end : p) improve_from_point(square, end, q);
  if (p.size() == 2) {
    for (const auto& corner : q) improve_from_point(square, corner, p);
    if (q.size() == 2) improve_by_crossing(square, p[0], p[1], q[0], q[1]);
    if (q.size() == 3) {
      if (pierces(p[0], p[1], q[0], q[1], q[2])) return 0;
      for (int j = 0; j < 3; ++j) improve_by_crossing(square, p[0], p[1], q[j], q[(j + 1) % 3]);
    }
  }
  return square_root_below(square.numerator, square.denominator, exponent);
}

double square_root_below(const mpz_class& numerator, const mpz_class& denominator, int exponent) {
  if (numerator == 0) return 0;
  // At least 126 bits of quotient, hence 63 of root; an even shift.
  const long bits = static_cast<long>(mpz_sizeinbase(numerator.get_mpz_t(), 2)) -
                    static_cast<long>(mpz_sizeinbase(denominator.get_mpz_t(), 2));
  const long half = bits < 128 ? (129 - bits) / 2 : 0;
  mpz_class root = (numerator << (2 * half)) / denominator;
  mpz_sqrt(root.get_mpz_t(), root.get_mpz_t());
  long power = 0;
  const double fraction = mpz_get_d_2exp(&power, root.get_mpz_t());  // truncates
  power -= half + exponent;
  if (power > 1024) return std::numeric_limits<double>::max();
  const double value = std::ldexp(fraction, static_cast<int>(std::max(power, -2000L)));
  // Among the subnormal numbers ldexp rounds to nearest.
  return power > -1021 || value == 0 ? value : std::nextafter(value, 0.0);
}

}  // namespace confidel
