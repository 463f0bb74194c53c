// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/placement/circle.h"

#include <cmath>
#include <numbers>

#include "core/numbers/point.h"

namespace confidel {

RationalPoint2 operator+(const RationalPoint2& a, const RationalPoint2& b) { return {a[0] + b[0], a[1] + b[1]}; }
RationalPoint2 operator-(const RationalPoint2& a, const RationalPoint2& b) { return {a[0] - b[0], a[1] - b[1]}; }
RationalPoint2 operator*(const mpq_class& factor, const RationalPoint2& a) { return {factor * a[0], factor * a[1]}; }
mpq_class dot(const RationalPoint2& a, const RationalPoint2& b) { return a[0] * b[0] + a[1] * b[1]; }
mpq_class cross(const RationalPoint2& a, const RationalPoint2& b) { return a[0] * b[1] - a[1] * b[0]; }

RationalPoint2 point_of_unit_circle(double angle, int bits) {
  const double quarter = std::numbers::pi / 2;
  const double turns = std::nearbyint(angle / quarter);
  const mpq_class t = times_power_of_two(mpz_class(std::nearbyint(std::ldexp(std::tan((angle - turns * quarter) / 2), bits))), -bits);
  const mpq_class square = t * t, scale = 1 + square;
  mpq_class x = (1 - square) / scale, y = 2 * t / scale;
  switch (static_cast<long>(turns) & 3) {
    case 0: return {x, y};
    case 1: return {-y, x};
    case 2: return {-x, -y};
    default: return {y, -x};
  }
}

RationalPoint2 projected(const RationalPoint2& p, const RationalPoint2& a, const RationalPoint2& b) {
  const RationalPoint2 e = b - a;
  return a + (dot(p - a, e) / dot(e, e)) * e;
}

RationalPoint2 reflected(const RationalPoint2& p, const RationalPoint2& a, const RationalPoint2& b) {
  const RationalPoint2 e = b - a;
  return p + (1 - 2 * dot(p - a, e) / dot(e, e)) * e;
}

}  // namespace confidel
