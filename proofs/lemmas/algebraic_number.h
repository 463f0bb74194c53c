// SPDX-License-Identifier: GPL-3.0-or-later
// Real algebraic numbers (CORE) with what decides most signs before they are needed. For one translation unit: algebraic_instance.cpp.
#pragma once

#include <CGAL/CORE_Expr.h>
#include <fmt/format.h>
#include <gmpxx.h>

#include <array>
#include <map>

#include "proofs/lemmas/algebraic_instance.h"
#include "proofs/lemmas/bounded.h"
#include "proofs/lemmas/rational_geometry.h"

namespace confidel::algebraic {

using Number = CORE::Expr;
using Vector = std::array<Number, 3>;

inline Number number(const mpq_class& q) { return Number(CORE::BigRat(q.get_mpq_t())); }

inline Vector minus(const Vector& a, const Vector& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
inline Vector plus(const Vector& a, const Vector& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
inline Vector times(const Number& t, const Vector& a) { return {t * a[0], t * a[1], t * a[2]}; }
inline Number dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
inline Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
inline Vector vector(const RationalVector& a) { return {number(a[0]), number(a[1]), number(a[2])}; }

/// Square roots of rationals. Equal radicands up to small square factors share one root: the degree of a sign counts roots.
class Roots {
 public:
  Number root(const mpq_class& square) {
    if (square == 0) return Number(0);
    // sqrt(p/q) = sqrt(p q)/q.
    mpz_class radicand = square.get_num() * square.get_den(), factor = 1;
    for (unsigned long prime = 2; prime < 1000; ++prime) {
      const mpz_class squared = mpz_class(prime) * prime;
      while (radicand % squared == 0) {
        radicand /= squared;
        factor *= prime;
      }
    }
    if (mpz_perfect_square_p(radicand.get_mpz_t()) != 0) {
      factor *= sqrt(radicand);
      radicand = 1;
    }
    mpq_class outside(factor, square.get_den());
    outside.canonicalize();
    if (radicand == 1) return number(outside);
    auto place = roots_.find(radicand);
    if (place == roots_.end()) place = roots_.emplace(radicand, CORE::sqrt(number(mpq_class(radicand)))).first;
    return number(outside) * place->second;
  }

 private:
  std::map<mpz_class, Number> roots_;
};

/// Exact, by the root separation bound. Throws AlgebraicLimit where that is out of reach.
inline int exact_sign(const Number& x) {
  auto* node = x.Rep();
  if (node->nodeInfo == nullptr) node->initNodeInfo();
  const auto degree = node->degreeBound();
  if (degree.isInfty() || degree.asLong() > greatest_algebraic_degree)
    throw AlgebraicLimit(fmt::format("a sign needs a degree above {}", greatest_algebraic_degree));
  return x.sign();
}

/// Within 2^-bits, absolutely.
inline mpq_class approximation(const Number& x, long bits) {
  x.approx(CORE::extLong::getPosInfty(), CORE::extLong(bits));
  const CORE::BigRat value = x.BigRatValue();
  return mpq_class(value.get_mp());
}

/// A number as both kernels see it.
struct Constant {
  Number exact;
  Bounded bounded;
  Constant() = default;
  explicit Constant(Number x) : exact(std::move(x)) {
    const double value = exact.doubleValue();
    bounded = {value, std::abs(value) * 0x1p-50};
  }
};

/// cos and sin of an angle.
struct Angle {
  Number cosine, sine;
};
/// Below 180 degrees. One new root.
inline Angle half(const Angle& a) {
  const Number cosine = CORE::sqrt((1 + a.cosine) / 2);
  return {cosine, a.sine / (2 * cosine)};
}
inline Angle sum(const Angle& a, const Angle& b) { return {a.cosine * b.cosine - a.sine * b.sine, a.sine * b.cosine + a.cosine * b.sine}; }

/// A point of the unit circle with rational coordinates, at the angle within 2^-45.
inline std::array<mpq_class, 2> rational_direction(double angle) {
  const double turn = std::atan(1.0) * 2;
  const long quarter = std::lround(angle / turn);
  const mpq_class t(std::ldexp(std::round(std::ldexp(std::tan((angle - static_cast<double>(quarter) * turn) / 2), 50)), -50));
  std::array<mpq_class, 2> at{(1 - t * t) / (1 + t * t), 2 * t / (1 + t * t)};
  for (long i = ((quarter % 4) + 4) % 4; i > 0; --i) at = {-at[1], at[0]};
  return at;
}

}  // namespace confidel::algebraic
