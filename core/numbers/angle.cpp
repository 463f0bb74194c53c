// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/numbers/angle.h"

#include <mpfr.h>

#include <cmath>
#include <stdexcept>

#include "core/numbers/point.h"

namespace confidel {

namespace {

mpq_class dot(const std::array<mpq_class, 3>& x, const std::array<mpq_class, 3>& y) { return x[0] * y[0] + x[1] * y[1] + x[2] * y[2]; }

}  // namespace

mpq_class cosine_of_multiple(int multiple, const mpq_class& c) {
  mpq_class before = 1, now = c;
  if (multiple == 0) return before;
  for (int j = 1; j < multiple; ++j) {
    mpq_class next = 2 * c * now - before;
    before = std::move(now);
    now = std::move(next);
  }
  return now;
}

bool multiple_below_pi(int multiple, const mpq_class& c) {
  mpq_class before = 0, now = 1;
  for (int j = 0; j < multiple; ++j) {
    if (sgn(now) <= 0) return false;
    mpq_class next = 2 * c * now - before;
    before = std::move(now);
    now = std::move(next);
  }
  return true;
}

mpq_class witness_of_angle(double angle) {
  if (!(angle > 0 && angle < 1.5707963267948966)) throw std::logic_error("witness_of_angle: not an acute angle");
  // cos psi = 1 - 2 sin^2(psi/2); rounding the sine downwards rounds psi downwards, by a relative 2^-31 at most.
  mpfr_t sine;
  mpfr_init2(sine, 128);
  mpfr_set_d(sine, angle / 2, MPFR_RNDD);
  mpfr_sin(sine, sine, MPFR_RNDD);
  mpfr_sqr(sine, sine, MPFR_RNDD);
  mpfr_prec_round(sine, 33, MPFR_RNDD);
  mpz_class mantissa;
  const mpfr_exp_t exponent = mpfr_get_z_2exp(mantissa.get_mpz_t(), sine);
  mpfr_clear(sine);
  return 1 - times_power_of_two(mantissa, exponent + 1);
}

bool at_least_cosine(const mpq_class& t, const std::array<mpq_class, 3>& x, const std::array<mpq_class, 3>& y) {
  const mpq_class product = dot(x, y);
  const int left = sgn(t), right = sgn(product);
  if (left != right) return left > right;
  const int squares = cmp(mpq_class(t * t * dot(x, x) * dot(y, y)), mpq_class(product * product));
  return left >= 0 ? squares >= 0 : squares <= 0;
}

mpq_class rounded_down(double value, int bits) {
  int exponent = 0;
  const double mantissa = std::floor(std::ldexp(std::frexp(value, &exponent), bits));
  return times_power_of_two(mpz_class(mantissa), exponent - bits);
}

}  // namespace confidel
