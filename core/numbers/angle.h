// SPDX-License-Identifier: GPL-3.0-or-later
// Angles as rational witnesses: an angle psi is named by a rational C = cos psi, its multiples by Chebyshev polynomials, so that
// inequalities between angles are decided by rational arithmetic alone (lemma-claims.md section 2).
#pragma once

#include <gmpxx.h>

#include <array>

namespace confidel {

/// T_multiple(c) = cos(multiple arccos c). Exact. Pre: multiple >= 0.
mpq_class cosine_of_multiple(int multiple, const mpq_class& c);

/// Is multiple * arccos c < pi? Exact (U_0, ..., U_{multiple-1} are positive). Pre: 0 < c < 1.
bool multiple_below_pi(int multiple, const mpq_class& c);

/// A rational c with angle (1 - 2^-30) <= arccos c <= angle, with as few bits as that takes. Enclosed with MPFR.
/// Pre: 0 < angle < pi/2.
mpq_class witness_of_angle(double angle);

/// Is t >= cos(x, y), the cosine of the angle between two vectors that are not zero? Exact, by signs and squares.
bool at_least_cosine(const mpq_class& t, const std::array<mpq_class, 3>& x, const std::array<mpq_class, 3>& y);

/// The greatest rational with at most `bits` significant bits that is <= value > 0.
mpq_class rounded_down(double value, int bits);

}  // namespace confidel
