// SPDX-License-Identifier: GPL-3.0-or-later
// Vectors of rationals, and cosines of multiples of angles (docs/lemma-claims.md section 2).
#pragma once

#include <cmath>
#include <vector>

#include "proofs/lemmas/instance.h"

namespace confidel {

inline RationalVector minus(const RationalVector& a, const RationalVector& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
inline RationalVector plus(const RationalVector& a, const RationalVector& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
inline RationalVector times(const mpq_class& t, const RationalVector& a) { return {t * a[0], t * a[1], t * a[2]}; }
inline mpq_class dot(const RationalVector& a, const RationalVector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
inline mpq_class square(const mpq_class& a) { return a * a; }
inline mpq_class squared(const RationalVector& a) { return dot(a, a); }
inline RationalVector cross(const RationalVector& a, const RationalVector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// cos(j psi) for cos psi = cosine.
inline mpq_class multiple_cosine(const mpq_class& cosine, int j) {
  mpq_class before = 1, value = cosine;
  if (j == 0) return before;
  for (int i = 1; i < j; ++i) {
    mpq_class next = 2 * cosine * value - before;
    before = std::move(value);
    value = std::move(next);
  }
  return value;
}

/// Is j psi < pi? (sin((i+1) psi) / sin psi > 0 for all i < j.)
inline bool below_straight(const mpq_class& cosine, int j) {
  mpq_class before = 0, value = 1;
  for (int i = 0; i < j; ++i) {
    if (value <= 0) return false;
    mpq_class next = 2 * cosine * value - before;
    before = std::move(value);
    value = std::move(next);
  }
  return true;
}

/// bound |x| |y| >= x.y
inline bool cosine_at_most(const mpq_class& bound, const RationalVector& x, const RationalVector& y) {
  const mpq_class product = dot(x, y);
  if (bound >= 0 && product <= 0) return true;
  if (bound < 0 && product >= 0) return false;
  const mpq_class left = square(bound) * squared(x) * squared(y), right = square(product);
  return bound >= 0 ? left >= right : left <= right;
}

/// Rounded, for slacks only.
inline double approximate_cosine(const RationalVector& x, const RationalVector& y) {
  const mpq_class product = dot(x, y);
  const mpq_class ratio = square(product) / (squared(x) * squared(y));
  return sgn(product) * std::sqrt(ratio.get_d());
}

}  // namespace confidel
