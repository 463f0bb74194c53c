// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/planar/frame.h"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <random>

#include "core/numbers/predicates.h"
#include "tests/support/complexes.h"
#include "tests/support/rationals.h"

using namespace confidel;
using namespace confidel::test;
using support::Coordinates;

namespace {

using Generator = std::mt19937_64;

double real(Generator& generator) { return std::ldexp(static_cast<double>(generator() >> 11), -52) - 1; }
int integer(Generator& generator, int low, int high) {
  return low + static_cast<int>(generator() % static_cast<std::uint64_t>(high - low + 1));
}

mpq_class value(const Dyadic& t) { return t.numerator * power_of_two(-t.exponent); }

Dyadic random_dyadic(Generator& generator) {
  mpz_class numerator = static_cast<unsigned long>(generator() >> integer(generator, 0, 62));
  if (generator() % 2) numerator = -numerator;
  return {numerator, integer(generator, -40, 90)};
}

Point random_point(Generator& generator) {
  return translate(Point::from_doubles(real(generator), real(generator), real(generator)), random_dyadic(generator),
                   {integer(generator, -3, 3), integer(generator, -3, 3), 1});
}

/// Points of one triangle's plane, rounded over and over from places that were rounded before.
void check_rounding(Generator& generator, const std::array<Coordinates, 3>& corners, const std::string& name) {
  const Complex complex = support::triangle_complex({corners.begin(), corners.end()}, {{0, 1, 2}});
  const PlaneFrame frame(complex, complex.facets[0]);
  const std::array<const Point*, 3> plane{&complex.vertices[0], &complex.vertices[1], &complex.vertices[2]};
  BOOST_TEST((frame.normal() == complex.facets[0].normal));
  BOOST_TEST(std::abs(length(frame.unit_normal()) - 1) < 1e-15);

  // Directions in the plane, to double precision.
  const Double3 x = unit_vector(direction(*plane[0], *plane[1])), y = cross(frame.unit_normal(), x);
  std::vector<Point> bases(complex.vertices.begin(), complex.vertices.end());
  for (int round = 0; round < 40; ++round) {
    const Point base = bases[generator() % bases.size()];
    const double size = std::ldexp(1.0, -integer(generator, 0, 60));
    const double tolerance = size * std::ldexp(1 + std::abs(real(generator)), -integer(generator, 2, 44));
    const Double3 offset = (size * real(generator)) * x + (size * real(generator)) * y;
    const Point result = frame.round(base, offset, tolerance);
    BOOST_TEST_INFO(name << ", size " << size << ", tolerance " << tolerance);
    BOOST_TEST(orientation(*plane[0], *plane[1], *plane[2], result) == 0);
    // The offset is in the plane to within about 4 ulp only.
    const mpq_class reach = mpq_class(tolerance) + mpq_class(2e-15 * length(offset));
    BOOST_TEST_INFO(name << ", size " << size << ", tolerance " << tolerance);
    BOOST_TEST((squared(minus(rational(result), plus(rational(base), rational(offset)))) <= reach * reach));
    if (round % 4 == 0) bases.push_back(result);
  }
}

}  // namespace

BOOST_AUTO_TEST_SUITE(frame)

BOOST_AUTO_TEST_CASE(round_to_the_nearest_multiple) {
  Generator generator(1);
  for (int round = 0; round < 2000; ++round) {
    const double magnitude = std::ldexp(real(generator), integer(generator, -60, 60));
    const double tolerance = std::ldexp(0.5 + std::abs(real(generator)), integer(generator, -100, 10));
    const Dyadic rounded = round_to(magnitude, tolerance);
    const mpq_class unit = power_of_two(-rounded.exponent);
    BOOST_TEST((unit <= mpq_class(tolerance) && mpq_class(tolerance) < 2 * unit));
    BOOST_TEST((abs(value(rounded) - mpq_class(magnitude)) * 2 <= unit));
    BOOST_TEST(std::abs(rounded.approximate() - value(rounded).get_d()) <= 1e-15 * std::abs(value(rounded).get_d()));
  }
}

BOOST_AUTO_TEST_CASE(rounding_below_the_range_of_doubles_is_refused) {
  BOOST_TEST(round_to(1e-300L, 0x1p-1000).exponent == 1000);
  BOOST_CHECK_THROW(round_to(1, 0x1p-1001), std::range_error);
  BOOST_CHECK_THROW(round_to(std::nan(""), 1), std::range_error);
  BOOST_CHECK_THROW(round_to(1, 0), std::range_error);
  BOOST_CHECK_THROW(round_to(1, std::nan("")), std::range_error);
}

BOOST_AUTO_TEST_CASE(arithmetic_of_dyadics_is_exact) {
  Generator generator(2);
  for (int round = 0; round < 500; ++round) {
    const Dyadic a = random_dyadic(generator), b = random_dyadic(generator);
    BOOST_TEST((2 * value(midpoint(a, b)) == value(a) + value(b)));
    const Point base = random_point(generator), other = random_point(generator);
    IntegerVector step{integer(generator, -9, 9), integer(generator, -9, 9), integer(generator, -9, 9)};
    BOOST_TEST((rational(translate(base, a, step)) == plus(rational(base), scaled(value(a), rational(step)))));
    const Rational3 difference = minus(rational(other), rational(base));
    BOOST_TEST((rational(along(base, other, a)) == plus(rational(base), scaled(value(a), difference))));
    BOOST_TEST(collinear(base, other, along(base, other, a)));
  }
  const Point p = random_point(generator), q = random_point(generator);
  BOOST_TEST((along(p, q, {0, 0}) == p));
  BOOST_TEST((along(p, q, {1, 0}) == q));
  BOOST_TEST((along(p, q, {4, 2}) == q));
  const Dyadic half = midpoint({0, 0}, {1, 0});
  BOOST_TEST((half.numerator == 1 && half.exponent == 1));
  const Dyadic zero = midpoint({-5, 3}, {5, 3});
  BOOST_TEST(zero.numerator == 0);
}

BOOST_AUTO_TEST_CASE(differences_survive_cancellation) {
  Generator generator(3);
  for (int round = 0; round < 300; ++round) {
    const Point base = Point::from_doubles(real(generator), real(generator), real(generator));
    const Double3 small{std::ldexp(real(generator), -50), std::ldexp(real(generator), -45), std::ldexp(real(generator), -30)};
    const Rational3 there = plus(rational(base), rational(small));
    std::array<mpz_class, 3> numerators;
    for (int i = 0; i < 3; ++i) numerators[i] = mpz_class(there[i] * power_of_two(200));
    const Point other(numerators[0], numerators[1], numerators[2], 200);
    const Double3 result = approximate_difference(other, base);
    for (int i = 0; i < 3; ++i) BOOST_TEST(std::abs(result[i] - small[i]) <= 1e-15 * std::abs(small[i]));
  }
}

BOOST_AUTO_TEST_CASE(unit_vectors_of_huge_integers) {
  const mpz_class huge = mpz_class(1) << 3000;
  const Double3 unit = unit_vector({3 * huge, -4 * huge, 1});
  BOOST_TEST(std::abs(unit[0] - 0.6) < 1e-15);
  BOOST_TEST(std::abs(unit[1] + 0.8) < 1e-15);
  BOOST_TEST(std::abs(unit[2]) < 1e-300);
}

BOOST_AUTO_TEST_CASE(rounding_stays_in_the_plane) {
  Generator generator(4);
  for (int round = 0; round < 60; ++round) {
    std::array<Coordinates, 3> corners;
    for (auto& corner : corners) corner = {real(generator), real(generator), real(generator)};
    check_rounding(generator, corners, "random " + std::to_string(round));
  }
}

BOOST_AUTO_TEST_CASE(rounding_in_needles) {
  // The frame's directions are nearly parallel, down to what doubles can say.
  Generator generator(5);
  for (int round = 0; round < 80; ++round) {
    const double width = std::ldexp(1.0, -integer(generator, 1, 45));
    const Coordinates a{real(generator), real(generator), real(generator)}, b{real(generator), real(generator), real(generator)};
    Coordinates c;
    for (int i = 0; i < 3; ++i) c[i] = a[i] + 0.7 * (b[i] - a[i]) + width * real(generator);
    check_rounding(generator, {a, b, c}, "needle " + std::to_string(width));
    check_rounding(generator, {c, a, b}, "flat needle " + std::to_string(width));
  }
}

BOOST_AUTO_TEST_CASE(rounding_far_from_the_origin) {
  Generator generator(6);
  for (int round = 0; round < 30; ++round) {
    const double size = std::ldexp(1.0, -integer(generator, 5, 35));
    std::array<Coordinates, 3> corners;
    for (auto& corner : corners) corner = {0.9 + size * real(generator), -0.7 + size * real(generator), 0.5 + size * real(generator)};
    check_rounding(generator, corners, "offset " + std::to_string(size));
  }
}

BOOST_AUTO_TEST_CASE(numerators_stay_short) {
  // Rounding costs log2(size / tolerance) bits beyond the frame's: refinement must not grow them step by step.
  const Complex complex = support::triangle_complex({{0, 0, 0}, {4, 0, 1}, {1, 3, 0}}, {{0, 1, 2}});
  const PlaneFrame frame(complex, complex.facets[0]);
  Generator generator(7);
  Point base = complex.vertices[0];
  for (int round = 0; round < 200; ++round) {
    const Double3 target = 0.3 * approximate_difference(complex.vertices[1], base) + 0.2 * approximate_difference(complex.vertices[2], base);
    base = frame.round(base, target, 0x1p-20);
    BOOST_TEST(base.exponent() <= 20 + 5);
  }
}

BOOST_AUTO_TEST_SUITE_END()
