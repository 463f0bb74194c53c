// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/numbers/angle.h"

#include <boost/test/unit_test.hpp>

#include <cmath>

using namespace confidel;

BOOST_AUTO_TEST_SUITE(angle)

BOOST_AUTO_TEST_CASE(multiples_are_chebyshev_polynomials) {
  const mpq_class c(4, 5);
  BOOST_TEST((cosine_of_multiple(0, c) == 1));
  BOOST_TEST((cosine_of_multiple(1, c) == c));
  BOOST_TEST((cosine_of_multiple(2, c) == 2 * c * c - 1));
  BOOST_TEST((cosine_of_multiple(3, c) == 4 * c * c * c - 3 * c));
  for (int j = 0; j < 9; ++j) BOOST_TEST((std::abs(cosine_of_multiple(j, c).get_d() - std::cos(j * std::acos(0.8))) < 1e-12));
  // arccos(4/5) = 36.87 degrees: four of them are below pi, five are not.
  BOOST_TEST((multiple_below_pi(4, c)));
  BOOST_TEST((!multiple_below_pi(5, c)));
  BOOST_TEST((!multiple_below_pi(10, c)));  // 368.7 degrees: the sine is positive again
}

BOOST_AUTO_TEST_CASE(witnesses_are_below_their_angle_and_close) {
  for (const double angle : {1e-7, 1e-4, 0.01, 0.0654498469, 0.5, 1.5}) {
    const mpq_class c = witness_of_angle(angle);
    // 1 - c = 2 sin^2(angle/2): compared where doubles have digits.
    const double half = std::sin(angle / 2), got = std::sqrt(mpq_class((1 - c) / 2).get_d());
    BOOST_TEST((got <= half * (1 + 1e-15)));
    BOOST_TEST((got >= half * (1 - 1e-9)));
  }
}

BOOST_AUTO_TEST_CASE(comparison_with_a_cosine_is_exact) {
  const std::array<mpq_class, 3> x{3, 4, 0}, y{1, 0, 0}, z{-1, 0, 0}, up{0, 0, 2};
  const mpq_class hair(1, mpz_class("1000000000000000000000000"));
  BOOST_TEST((at_least_cosine(mpq_class(3, 5), x, y)));
  BOOST_TEST((!at_least_cosine(mpq_class(3, 5) - hair, x, y)));
  BOOST_TEST((at_least_cosine(mpq_class(-3, 5), x, z)));
  BOOST_TEST((!at_least_cosine(mpq_class(-3, 5) - hair, x, z)));
  BOOST_TEST((at_least_cosine(0, x, up)));
  BOOST_TEST((!at_least_cosine(-hair, x, up)));
  BOOST_TEST((at_least_cosine(hair, x, z)));
}

BOOST_AUTO_TEST_CASE(rounding_goes_down) {
  BOOST_TEST((rounded_down(0.7, 3) == mpq_class(5, 8)));
  BOOST_TEST((rounded_down(12, 4) == 12));
  BOOST_TEST((rounded_down(1e-20, 24) <= mpq_class(1e-20)));
}

BOOST_AUTO_TEST_SUITE_END()
