// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/numbers/point.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace confidel {
namespace {

// value = mantissa * 2^exponent with an odd or zero mantissa.
std::pair<mpz_class, int> decompose(double value) {
  int exponent = 0;
  const double fraction = std::frexp(value, &exponent);  // |fraction| in [1/2, 1)
  mpz_class mantissa(std::ldexp(fraction, 53));
  if (mantissa == 0) return {mantissa, 0};
  exponent -= 53;
  const auto zeros = mpz_scan1(mantissa.get_mpz_t(), 0);
  mantissa >>= zeros;
  return {mantissa, exponent + static_cast<int>(zeros)};
}

// Truncates the integer to 53 bits: high = value rounded towards zero, rest = value - high.
double leading_double(const mpz_class& value, int exponent, mpz_class& rest) {
  long shift = 0;
  const double fraction = mpz_get_d_2exp(&shift, value.get_mpz_t());  // truncates to 53 bits
  const long low_bits = shift - 53;
  if (low_bits > 0) {
    mpz_class head;
    mpz_set_d(head.get_mpz_t(), std::ldexp(fraction, 53));
    head <<= low_bits;
    rest = value - head;
  } else {
    rest = 0;
  }
  const long power = shift - exponent;
  return std::ldexp(fraction, static_cast<int>(std::clamp<long>(power, -100000, 100000)));
}

}  // namespace

Point::Point() = default;

Point::Point(mpz_class x, mpz_class y, mpz_class z, int exponent)
    : numerator_{std::move(x), std::move(y), std::move(z)}, exponent_(exponent) {
  mp_bitcnt_t zeros = std::numeric_limits<mp_bitcnt_t>::max();
  for (const auto& value : numerator_)
    if (value != 0) zeros = std::min(zeros, mpz_scan1(value.get_mpz_t(), 0));
  if (zeros == std::numeric_limits<mp_bitcnt_t>::max()) {
    exponent_ = 0;
  } else if (zeros > 0) {
    for (auto& value : numerator_) value >>= zeros;
    exponent_ -= static_cast<int>(zeros);
  }
  approximate_coordinates();
}

Point Point::from_doubles(double x, double y, double z) {
  std::array<std::pair<mpz_class, int>, 3> parts{decompose(x), decompose(y), decompose(z)};
  int lowest = std::numeric_limits<int>::max();
  for (const auto& [mantissa, power] : parts)
    if (mantissa != 0) lowest = std::min(lowest, power);
  if (lowest == std::numeric_limits<int>::max()) return Point();
  for (auto& [mantissa, power] : parts)
    if (mantissa != 0) mantissa <<= (power - lowest);
  return Point(parts[0].first, parts[1].first, parts[2].first, -lowest);
}

void Point::approximate_coordinates() {
  mpz_class rest, ignored;
  double greatest = least_magnitude;
  for (int axis = 0; axis < 3; ++axis) {
    high_[axis] = leading_double(numerator_[axis], exponent_, rest);
    low_[axis] = rest == 0 ? 0.0 : leading_double(rest, exponent_, ignored);
    greatest = std::max(greatest, std::abs(high_[axis]));
  }
  magnitude_ = greatest == 1 ? 1.0F : static_cast<float>(greatest * (1 + 0x1p-20));  // rounding to float loses less
}

Point Point::scaled(int power) const {
  return Point(numerator_[0], numerator_[1], numerator_[2], exponent_ - power);
}

bool Point::operator==(const Point& other) const {
  return exponent_ == other.exponent_ && numerator_ == other.numerator_;
}

int Point::compare(const Point& a, const Point& b) {
  for (int axis = 0; axis < 3; ++axis) {
    // Truncated approximations are monotone: different leading doubles decide.
    if (a.high_[axis] != b.high_[axis]) return a.high_[axis] < b.high_[axis] ? -1 : 1;
    int sign = 0;
    if (a.exponent_ == b.exponent_) {
      sign = cmp(a.numerator_[axis], b.numerator_[axis]);
    } else if (a.exponent_ < b.exponent_) {
      const mpz_class lifted = a.numerator_[axis] << (b.exponent_ - a.exponent_);
      sign = cmp(lifted, b.numerator_[axis]);
    } else {
      const mpz_class lifted = b.numerator_[axis] << (a.exponent_ - b.exponent_);
      sign = cmp(a.numerator_[axis], lifted);
    }
    if (sign != 0) return sign < 0 ? -1 : 1;
  }
  return 0;
}

std::size_t Point::hash() const {
  std::size_t result = static_cast<std::size_t>(exponent_) * 0x9e3779b97f4a7c15ULL;
  for (const auto& value : numerator_) {
    const std::size_t limbs = mpz_size(value.get_mpz_t());
    for (std::size_t i = 0; i < limbs; ++i)
      result = (result ^ mpz_getlimbn(value.get_mpz_t(), static_cast<mp_size_t>(i))) * 0x9e3779b97f4a7c15ULL;
    result = (result ^ (result >> 29)) + static_cast<std::size_t>(sgn(value));
  }
  return result ^ (result >> 32);
}

Difference difference(const Point& to, const Point& from) {
  Difference result;
  result.exponent = std::max(to.exponent(), from.exponent());
  for (int axis = 0; axis < 3; ++axis) {
    result.vector[axis] = to.numerator(axis) << (result.exponent - to.exponent());
    result.vector[axis] -= from.numerator(axis) << (result.exponent - from.exponent());
  }
  return result;
}

IntegerVector cross(const IntegerVector& a, const IntegerVector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

mpz_class dot(const IntegerVector& a, const IntegerVector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

void make_primitive(IntegerVector& vector) {
  mpz_class divisor = gcd(gcd(vector[0], vector[1]), vector[2]);
  if (divisor > 1)
    for (auto& value : vector) mpz_divexact(value.get_mpz_t(), value.get_mpz_t(), divisor.get_mpz_t());
}

mpq_class times_power_of_two(mpq_class value, long power) {
  if (power >= 0)
    mpq_mul_2exp(value.get_mpq_t(), value.get_mpq_t(), static_cast<mp_bitcnt_t>(power));
  else
    mpq_div_2exp(value.get_mpq_t(), value.get_mpq_t(), static_cast<mp_bitcnt_t>(-power));
  return value;
}

mpq_class rational_coordinate(const Point& point, int axis) { return times_power_of_two(point.numerator(axis), -static_cast<long>(point.exponent())); }

mpz_class rounded(double value) {
  // mpz_set_d truncates: round first; beyond 2^53 every double is an integer.
  return mpz_class(std::abs(value) < 0x1p53 ? std::nearbyint(value) : value);
}

IntegerVector direction(const Point& from, const Point& to) {
  IntegerVector result = difference(to, from).vector;
  make_primitive(result);
  return result;
}

IntegerVector plane_normal(const Point& a, const Point& b, const Point& c) {
  // Each direction may be scaled on its own: the normal's direction stays.
  IntegerVector result = cross(direction(a, b), direction(a, c));
  make_primitive(result);
  return result;
}

}  // namespace confidel
