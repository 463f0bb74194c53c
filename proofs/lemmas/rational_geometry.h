// SPDX-License-Identifier: GPL-3.0-or-later
// Vectors of rationals.
#pragma once

#include <cmath>

#include "core/numbers/angle.h"
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

/// Of the point x and the closed segment ab.
inline mpq_class squared_distance_to_segment(const RationalVector& x, const RationalVector& a, const RationalVector& b) {
  const RationalVector along = minus(b, a), from = minus(x, a);
  const mpq_class t = dot(along, from), length = squared(along);
  if (t <= 0) return squared(from);
  if (t >= length) return squared(minus(x, b));
  return squared(from) - square(t) / length;
}

/// Rounded, for slacks only.
inline double approximate_cosine(const RationalVector& x, const RationalVector& y) {
  const mpq_class product = dot(x, y);
  const mpq_class ratio = square(product) / (squared(x) * squared(y));
  return sgn(product) * std::sqrt(ratio.get_d());
}

}  // namespace confidel
