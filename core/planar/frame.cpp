// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/planar/frame.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace confidel {
namespace {

using Long3 = std::array<long double, 3>;

long double dot(const Long3& a, const Long3& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Long3 cross(const Long3& a, const Long3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

long double to_long_double(const mpz_class& value) {
  const double high = value.get_d();
  if (!std::isfinite(high)) return high;
  const mpz_class rest = value - mpz_class(high);
  return static_cast<long double>(high) + static_cast<long double>(rest.get_d());
}

// The integers may exceed the range of doubles: common factor 2^-shift.
Long3 to_long_double(const IntegerVector& vector, long& shift) {
  std::size_t bits = 0;
  for (const auto& value : vector) bits = std::max(bits, mpz_sizeinbase(value.get_mpz_t(), 2));
  shift = bits > 900 ? static_cast<long>(bits) - 900 : 0;
  Long3 result;
  for (int i = 0; i < 3; ++i) result[i] = to_long_double(mpz_class(vector[i] >> shift));
  return result;
}

mpz_class rounded_integer(long double value) {
  const double high = static_cast<double>(value);
  const double low = static_cast<double>(value - static_cast<long double>(high));
  return std::abs(high) < 0x1p53 ? mpz_class(static_cast<double>(std::rint(value))) : mpz_class(high) + rounded(low);
}

}  // namespace

double length(const Double3& a) { return std::hypot(a[0], a[1], a[2]); }

Double3 approximate_difference(const Point& to, const Point& from) {
  Double3 result;
  for (int i = 0; i < 3; ++i) result[i] = (to.high(i) - from.high(i)) + (to.low(i) - from.low(i));
  return result;
}

Double3 unit_vector(const IntegerVector& vector) {
  long shift = 0;
  const Long3 approximate = to_long_double(vector, shift);
  const long double size = std::sqrt(dot(approximate, approximate));
  return {static_cast<double>(approximate[0] / size), static_cast<double>(approximate[1] / size),
          static_cast<double>(approximate[2] / size)};
}

double Dyadic::approximate() const {
  long power = 0;
  const double fraction = mpz_get_d_2exp(&power, numerator.get_mpz_t());
  return std::ldexp(fraction, static_cast<int>(power - exponent));
}

Dyadic round_to(long double value, double tolerance) {
  if (!(tolerance >= 0x1p-1000) || !std::isfinite(value)) throw std::range_error("a position asks for more than doubles can say");
  const int bits = -static_cast<int>(std::floor(std::log2(tolerance)));
  return {rounded_integer(std::ldexp(value, bits)), bits};
}

Dyadic midpoint(const Dyadic& a, const Dyadic& b) {
  const int exponent = std::max(a.exponent, b.exponent);
  Dyadic result{(a.numerator << (exponent - a.exponent)) + (b.numerator << (exponent - b.exponent)), exponent + 1};
  if (result.numerator == 0) return {0, 0};
  const auto zeros = mpz_scan1(result.numerator.get_mpz_t(), 0);
  result.numerator >>= zeros;
  result.exponent -= static_cast<int>(zeros);
  return result;
}

Point translate(const Point& base, const Dyadic& factor, const IntegerVector& direction) {
  const int exponent = std::max(base.exponent(), factor.exponent);
  std::array<mpz_class, 3> x;
  for (int i = 0; i < 3; ++i) {
    x[i] = base.numerator(i) << (exponent - base.exponent());
    x[i] += (factor.numerator * direction[i]) << (exponent - factor.exponent);
  }
  return Point(std::move(x[0]), std::move(x[1]), std::move(x[2]), exponent);
}

Point along(const Point& from, const Point& to, const Dyadic& t) {
  const Difference step = difference(to, from);
  return translate(from, {t.numerator, t.exponent + step.exponent}, step.vector);
}

PlaneFrame::PlaneFrame(const Complex& complex, const Facet& facet) : normal_(facet.normal), unit_normal_(unit_vector(facet.normal)) {
  const auto edge_direction = [&](int from, int to) { return direction(complex.vertices[from], complex.vertices[to]); };
  directions_[0] = edge_direction(facet.frame[0], facet.frame[1]);
  directions_[1] = edge_direction(facet.frame[0], facet.frame[2]);
  const auto sine = [](const IntegerVector& a, const IntegerVector& b) { return length(cross(unit_vector(a), unit_vector(b))); };
  if (sine(directions_[0], directions_[1]) < 1.0 / 64) {
    directions_[1] = cross(normal_, directions_[0]);
    make_primitive(directions_[1]);
  }
  for (int i = 0; i < 2; ++i) {
    long shift = 0;
    approximate_[i] = to_long_double(directions_[i], shift);
    // Exponents beyond doubles: scale the direction itself is not needed in practice; such frames are still exact,
    // only the approximation would overflow.
    if (shift != 0)
      for (auto& value : approximate_[i]) value = std::ldexp(value, static_cast<int>(shift));
    lengths_[i] = static_cast<double>(std::sqrt(dot(approximate_[i], approximate_[i])));
  }
  const Long3 normal = cross(approximate_[0], approximate_[1]);
  const long double square = dot(normal, normal);
  dual_[0] = cross(approximate_[1], normal);
  dual_[1] = cross(normal, approximate_[0]);
  for (int i = 0; i < 2; ++i)
    for (auto& value : dual_[i]) value /= square;
}

Point PlaneFrame::round(const Point& base, const Double3& offset, double tolerance) const {
  Long3 rest{offset[0], offset[1], offset[2]};
  long double coefficient[2] = {0, 0};
  // The second round removes what the ill-conditioning of the frame left in the first.
  for (int round = 0; round < 2; ++round) {
    const long double step[2] = {dot(rest, dual_[0]), dot(rest, dual_[1])};
    for (int i = 0; i < 2; ++i) {
      coefficient[i] += step[i];
      for (int axis = 0; axis < 3; ++axis) rest[axis] -= step[i] * approximate_[i][axis];
    }
  }
  const Dyadic s = round_to(coefficient[0], tolerance / (2 * lengths_[0]));
  const Dyadic t = round_to(coefficient[1], tolerance / (2 * lengths_[1]));
  return translate(translate(base, s, directions_[0]), t, directions_[1]);
}

}  // namespace confidel
