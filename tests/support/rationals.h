// SPDX-License-Identifier: GPL-3.0-or-later
// Points in rationals, for tests that recompute things with code of their own.
#pragma once

#include "core/numbers/point.h"
#include "tests/core/complex/canonical_reader.h"

namespace confidel::test {

inline mpq_class power_of_two(int exponent) {
  mpq_class result(1);
  if (exponent >= 0)
    mpq_mul_2exp(result.get_mpq_t(), result.get_mpq_t(), static_cast<unsigned long>(exponent));
  else
    mpq_div_2exp(result.get_mpq_t(), result.get_mpq_t(), static_cast<unsigned long>(-exponent));
  return result;
}

inline Rational3 rational(const Point& point) {
  const mpq_class unit = power_of_two(-point.exponent());
  return {point.numerator(0) * unit, point.numerator(1) * unit, point.numerator(2) * unit};
}

inline Rational3 rational(const IntegerVector& vector) { return {vector[0], vector[1], vector[2]}; }

inline Rational3 rational(const std::array<double, 3>& vector) {
  return {mpq_class(vector[0]), mpq_class(vector[1]), mpq_class(vector[2])};
}

inline Rational3 plus(const Rational3& a, const Rational3& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
inline Rational3 scaled(const mpq_class& factor, const Rational3& a) {
  return {factor * a[0], factor * a[1], factor * a[2]};
}
inline mpq_class squared(const Rational3& a) { return scalar(a, a); }
inline bool is_zero(const Rational3& a) { return a[0] == 0 && a[1] == 0 && a[2] == 0; }

/// t with point = from + t (to - from), or false if the point is not on the line. Pre: from != to.
inline bool parameter_on_line(const Rational3& from, const Rational3& to, const Rational3& point, mpq_class& t) {
  const Rational3 along = minus(to, from), step = minus(point, from);
  if (!is_zero(times(along, step))) return false;
  t = scalar(along, step) / squared(along);
  return true;
}

}  // namespace confidel::test
