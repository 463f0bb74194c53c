// SPDX-License-Identifier: GPL-3.0-or-later
// Doubles with a bound on their error (running error analysis): what decides most comparisons before rationals are needed.
#pragma once

#include <array>
#include <cmath>
#include <limits>

namespace confidel {

/// The true value is within error of value; error is infinite or not a number when nothing is known.
struct Bounded {
  double value = 0, error = 0;

  double lower() const { return value - error; }
  double upper() const { return value + error; }
};

// 1 + 2^-49 covers the roundings within the error's own computation, 2^-1000 what underflows.
inline Bounded rounded(double value, double error) { return {value, (error + std::abs(value) * 0x1p-52) * (1 + 0x1p-49) + 0x1p-1000}; }
inline Bounded operator+(const Bounded& a, const Bounded& b) { return rounded(a.value + b.value, a.error + b.error); }
inline Bounded operator-(const Bounded& a, const Bounded& b) { return rounded(a.value - b.value, a.error + b.error); }
inline Bounded operator*(const Bounded& a, const Bounded& b) {
  return rounded(a.value * b.value, std::abs(a.value) * b.error + std::abs(b.value) * a.error + a.error * b.error);
}
inline Bounded operator/(const Bounded& a, const Bounded& b) {
  const double least = std::abs(b.value) - b.error;
  if (!(least > 0)) return {0, std::numeric_limits<double>::infinity()};
  const double quotient = a.value / b.value;
  return rounded(quotient, (a.error + std::abs(quotient) * b.error) / (least * (1 - 0x1p-50)));
}

using BoundedVector = std::array<Bounded, 3>;

inline BoundedVector minus(const BoundedVector& a, const BoundedVector& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
inline BoundedVector plus(const BoundedVector& a, const BoundedVector& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
inline BoundedVector times(const Bounded& t, const BoundedVector& a) { return {t * a[0], t * a[1], t * a[2]}; }
inline Bounded dot(const BoundedVector& a, const BoundedVector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
inline BoundedVector cross(const BoundedVector& a, const BoundedVector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

}  // namespace confidel
