// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/placement/pencil.h"

#include <algorithm>
#include <cmath>

namespace confidel {
namespace {

// The multiple of 2^-k in [low, high] for the smallest k that has one; of several the one of least magnitude.
mpq_class simplest_dyadic(const mpq_class& low, const mpq_class& high) {
  if (low <= 0 && high >= 0) return 0;
  if (high < 0) return -simplest_dyadic(-high, -low);
  const mpq_class width = high - low;
  int k = 0;
  // Start coarser than the interval and refine.
  const double size = high.get_d();
  if (size > 0 && std::isfinite(size)) k = -static_cast<int>(std::ceil(std::log2(size))) - 1;
  for (;; ++k) {
    const mpq_class grid = low * times_power_of_two(1, k);
    mpz_class multiple;
    mpz_cdiv_q(multiple.get_mpz_t(), grid.get_num().get_mpz_t(), grid.get_den().get_mpz_t());
    const mpq_class candidate = mpq_class(multiple) * times_power_of_two(1, -k);
    if (candidate <= high) return candidate;
  }
}

}  // namespace

Difference certificate_normal(const Complex& complex, const Facet& facet) {
  const Point& base = complex.vertices[facet.frame[0]];
  const Difference u = difference(complex.vertices[facet.frame[1]], base), w = difference(complex.vertices[facet.frame[2]], base);
  return {cross(u.vector, w.vector), u.exponent + w.exponent};
}

namespace {

// Over one common exponent e: P0 = power / square / 2^(2e), x - a = to_x / 2^e.
struct ScaledPower {
  int e;
  IntegerVector to_x;
  mpz_class power, square;
};

ScaledPower scaled_power(const Point& a, const Point& b, const Point& c, const Point& x) {
  const int e = std::max({a.exponent(), b.exponent(), c.exponent(), x.exponent()});
  const auto to = [&](const Point& p) {
    IntegerVector result;
    for (int i = 0; i < 3; ++i)
      result[i] = (p.numerator(i) << (e - p.exponent())) - (a.numerator(i) << (e - a.exponent()));
    return result;
  };
  const IntegerVector u = to(b), w = to(c), d = to(x), n = cross(u, w);
  const mpz_class nn = dot(n, n);
  // |n|^2 P0 = |n|^2 |d|^2 - |u|^2 (d x w).n - |w|^2 (u x d).n, as in predicates.cpp.
  return {e, d, nn * dot(d, d) - dot(u, u) * dot(cross(d, w), n) - dot(w, w) * dot(cross(u, d), n), nn};
}

// value / 2^exponent.
mpq_class divided(mpq_class value, int exponent) {
  value.canonicalize();
  return times_power_of_two(std::move(value), -exponent);
}

}  // namespace

mpq_class pencil_parameter(const Point& a, const Point& b, const Point& c, const Point& x, const Difference& normal) {
  const ScaledPower p = scaled_power(a, b, c, x);
  // n.(x-a) is the product below / 2^(normal.exponent + e).
  return divided(mpq_class(p.power, mpz_class(2 * p.square * dot(normal.vector, p.to_x))), 2 * p.e - (normal.exponent + p.e));
}

mpq_class power_of(const Point& a, const Point& b, const Point& c, const Point& x) {
  const ScaledPower p = scaled_power(a, b, c, x);
  return divided(mpq_class(p.power, p.square), 2 * p.e);
}

mpq_class choose_offset(const std::optional<mpq_class>& low, const std::optional<mpq_class>& high, double scale) {
  if (!low && !high) return 0;
  mpq_class margin;
  if (low && high)
    margin = (*high - *low) / 4;
  else
    margin = times_power_of_two(1, static_cast<int>(std::floor(std::log2(std::max(scale, 1e-300)))) - 2);
  if (low && high) return simplest_dyadic(*low + margin, *high - margin);
  // One side is open: not farther away than needed, or the sphere becomes huge.
  if (low) return *low + margin <= 0 ? mpq_class(0) : simplest_dyadic(*low + margin, *low + 2 * margin);
  return *high - margin >= 0 ? mpq_class(0) : simplest_dyadic(*high - 2 * margin, *high - margin);
}

}  // namespace confidel
