// SPDX-License-Identifier: GPL-3.0-or-later
// Every predicate against an independent evaluation in rationals, on points that are nasty in the ways that occur:
// random, nearly degenerate, exactly degenerate, tiny features far from the origin, long numerators.
#include "core/numbers/predicates.h"

#include <boost/test/unit_test.hpp>
#include <gmpxx.h>

#include <random>

#include "core/numbers/point.h"

using namespace confidel;

namespace {

using Rational = std::array<mpq_class, 3>;

Rational rational(const Point& p) {
  Rational result;
  for (int i = 0; i < 3; ++i) {
    result[i] = mpq_class(p.numerator(i));
    if (p.exponent() >= 0)
      mpq_div_2exp(result[i].get_mpq_t(), result[i].get_mpq_t(), p.exponent());
    else
      mpq_mul_2exp(result[i].get_mpq_t(), result[i].get_mpq_t(), -p.exponent());
  }
  return result;
}
Rational operator-(const Rational& a, const Rational& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
Rational operator+(const Rational& a, const Rational& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
Rational operator*(const mpq_class& s, const Rational& a) { return {s * a[0], s * a[1], s * a[2]}; }
mpq_class dot(const Rational& a, const Rational& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Rational cross(const Rational& a, const Rational& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

// The circumcentre of a triangle, from its definition.
Rational circumcentre(const Rational& a, const Rational& b, const Rational& c) {
  const Rational u = b - a, w = c - a, n = cross(u, w);
  const mpq_class n2 = dot(n, n);
  return a + (dot(u, u) / (2 * n2)) * cross(w, n) + (dot(w, w) / (2 * n2)) * cross(n, u);
}

class Nasty {
 public:
  explicit Nasty(unsigned seed) : engine_(seed) {}
  double coordinate() {
    switch (engine_() % 6) {
      case 0: return std::ldexp(static_cast<double>(static_cast<int>(engine_() % 17) - 8), -4);
      case 1: return std::ldexp(static_cast<double>(engine_() % 1000003), -20);
      case 2: return 0.5 + std::ldexp(static_cast<double>(engine_() % 5), -52);
      case 3: return std::ldexp(static_cast<double>(engine_() % 7) - 3, -60);
      case 4: return 0;
      default: return std::ldexp(static_cast<double>(engine_()), -32) - 0.5;
    }
  }
  Point point() { return Point::from_doubles(coordinate(), coordinate(), coordinate()); }
  mpz_class parameter(int bits) {
    mpz_class value = 0;
    for (int i = 0; i < bits; i += 16) value = (value << 16) + engine_() % 65536;
    return value;
  }
  // An exact affine combination a + s (b-a) + t (c-a) with dyadic s, t: coplanar, with long numerators.
  Point combination(const Point& a, const Point& b, const Point& c, int bits) {
    const mpz_class s = parameter(bits), t = parameter(bits);
    const int e = std::max({a.exponent(), b.exponent(), c.exponent()});
    std::array<mpz_class, 3> x;
    for (int i = 0; i < 3; ++i) {
      const mpz_class ai = a.numerator(i) << (e - a.exponent());
      const mpz_class bi = b.numerator(i) << (e - b.exponent());
      const mpz_class ci = c.numerator(i) << (e - c.exponent());
      x[i] = (ai << bits) + s * (bi - ai) + t * (ci - ai);
    }
    return Point(x[0], x[1], x[2], e + bits);
  }
  unsigned next() { return static_cast<unsigned>(engine_()); }

 private:
  std::mt19937 engine_;
};

}  // namespace

BOOST_AUTO_TEST_SUITE(predicates)

BOOST_AUTO_TEST_CASE(points_are_normalised_and_their_approximations_close) {
  BOOST_TEST((Point::from_doubles(0.5, 0.25, 3) == Point(2, 1, 12, 2)));
  BOOST_TEST(Point(8, 4, 48, 4).exponent() == 2);
  BOOST_TEST(Point(8, 16, 24, 0).exponent() == -3);
  BOOST_TEST((Point::from_doubles(-0.0, 0, 0) == Point()));
  BOOST_TEST((Point::from_doubles(1e300, 1e-300, 0) == Point::from_doubles(1e300, 1e-300, 0)));
  Nasty nasty(1);
  for (int round = 0; round < 2000; ++round) {
    const Point a = nasty.point(), b = nasty.point(), c = nasty.point();
    const Point p = nasty.combination(a, b, c, 16 * (1 + round % 8));
    const Rational exact = rational(p);
    for (int i = 0; i < 3; ++i) {
      const mpq_class error = abs(exact[i] - mpq_class(p.high(i)) - mpq_class(p.low(i)));
      mpq_class allowed = abs(exact[i]);
      mpq_div_2exp(allowed.get_mpq_t(), allowed.get_mpq_t(), 104);
      BOOST_REQUIRE(error <= allowed);
      BOOST_REQUIRE(p.magnitude() >= Point::least_magnitude);
      BOOST_REQUIRE(mpq_class(p.magnitude()) >= abs(exact[i]));
    }
    BOOST_REQUIRE(Point::compare(a, b) == -Point::compare(b, a));
    const Rational ra = rational(a), rb = rational(b);
    const int expected = ra[0] != rb[0] ? (ra[0] < rb[0] ? -1 : 1) : ra[1] != rb[1] ? (ra[1] < rb[1] ? -1 : 1) : cmp(ra[2], rb[2]) < 0 ? -1 : cmp(ra[2], rb[2]) > 0;
    BOOST_REQUIRE(Point::compare(a, b) == expected);
    BOOST_REQUIRE((a.scaled(7).scaled(-7) == a));
    if (a == b) BOOST_REQUIRE(a.hash() == b.hash());
  }
}

BOOST_AUTO_TEST_CASE(predicates_agree_with_rationals) {
  Nasty nasty(2);
  int zeros = 0, tests = 0;
  for (int round = 0; round < 20000; ++round) {
    // One in eight large, one tiny: the filters' floor must scale.
    const int power = round % 8 == 0 ? 20 : round % 8 == 1 ? -(round % 150) : 0;
    Point a = nasty.point().scaled(power), b = nasty.point().scaled(power), c = nasty.point().scaled(power);
    Point x = nasty.point().scaled(power), y = nasty.point().scaled(power);
    if (round % 3 == 0) x = nasty.combination(a, b, c, 16 * (1 + round % 5));
    if (round % 9 == 0) y = nasty.combination(a, b, c, 48);
    const Rational ra = rational(a), rb = rational(b), rc = rational(c), rx = rational(x), ry = rational(y);
    const Rational n = cross(rb - ra, rc - ra);
    const int o = sgn(dot(n, rx - ra));
    BOOST_REQUIRE(orientation(a, b, c, x) == o);
    zeros += o == 0;
    ++tests;
    BOOST_REQUIRE(diametral_power(a, b, x) == sgn(dot(rx - ra, rx - rb)));
    BOOST_REQUIRE(compare_distance(x, a, b) == sgn(mpq_class(dot(rx - ra, rx - ra) - dot(rx - rb, rx - rb))));
    const bool flat = n[0] == 0 && n[1] == 0 && n[2] == 0;
    BOOST_REQUIRE(collinear(a, b, c) == flat);
    const int volume = sgn(dot(n, ry - ra));
    if (volume != 0) {
      // The sphere through a, b, c, y: its centre from the circumcentre and the condition for y.
      const Rational z0 = circumcentre(ra, rb, rc);
      const mpq_class p0 = dot(ry - z0, ry - z0) - dot(ra - z0, ra - z0);
      const Rational z = z0 + mpq_class(p0 / (2 * dot(n, ry - ra))) * n;
      const mpq_class power_of_x = dot(rx - z, rx - z) - dot(ra - z, ra - z);
      BOOST_REQUIRE(in_sphere(a, b, c, y, x) == -sgn(power_of_x) * volume);
    }
    if (flat) continue;
    const Rational z = circumcentre(ra, rb, rc);
    const int power_sign = sgn(mpq_class(dot(rx - z, rx - z) - dot(ra - z, ra - z)));
    BOOST_REQUIRE(diametral_power(a, b, c, x) == power_sign);
    if (o == 0) {
      const IntegerVector normal = plane_normal(a, b, c);
      const Projection projection = projection_of(normal);
      BOOST_REQUIRE(planar_orientation(projection, a, b, c) == 1);
      BOOST_REQUIRE(planar_orientation(projection, a, b, x) == sgn(dot(n, cross(rb - ra, rx - ra))));
      BOOST_REQUIRE(planar_in_circle(projection, a, b, c, x) == -power_sign);
      BOOST_REQUIRE((planar_compare(projection, a, x) == 0) == (a == x));
    }
  }
  BOOST_TEST(zeros > tests / 10);
}

// Grids of all sizes: the stage for short coordinates has to know when it may decide.
BOOST_AUTO_TEST_CASE(predicates_agree_with_rationals_on_grids) {
  std::mt19937 engine(5);
  int zeros = 0, others = 0;
  for (int round = 0; round < 40000; ++round) {
    const int bits = 1 + round % 30, fraction = static_cast<int>(engine() % 40);
    const auto number = [&] { return static_cast<long>(engine() >> (32 - bits)) * (engine() % 4 != 0 ? 1 : 0); };
    const auto at = [&](const std::array<long, 3>& x) { return Point(x[0], x[1], x[2], fraction); };
    const std::array<long, 3> origin{number(), number(), number()}, u{number(), number(), number()}, w{-u[1], u[0], 0}, t{0, 0, number()};
    const long change = engine() % 2;  // ties, and points one unit beside them
    const auto corner = [&](int i, int j, int k) {
      std::array<long, 3> x;
      for (int axis = 0; axis < 3; ++axis) x[axis] = origin[axis] + i * u[axis] + j * w[axis] + k * t[axis];
      return x;
    };
    auto last = corner(1, 1, 0), top = corner(1, 1, 1);
    last[round % 3] += change;
    top[round % 3] += change;
    const Point a = at(corner(0, 0, 0)), b = at(corner(1, 0, 0)), c = at(corner(0, 1, 0)), y = at(corner(0, 0, 1)), x = at(last), z = at(top);
    const Rational ra = rational(a), rb = rational(b), rc = rational(c), rx = rational(x), ry = rational(y), rz = rational(z);
    const Rational n = cross(rb - ra, rc - ra);
    const int o = sgn(dot(n, rx - ra));
    BOOST_REQUIRE(orientation(a, b, c, x) == o);
    if (n[0] == 0 && n[1] == 0 && n[2] == 0) continue;
    const Rational centre = circumcentre(ra, rb, rc);
    const int power = sgn(mpq_class(dot(rx - centre, rx - centre) - dot(ra - centre, ra - centre)));
    BOOST_REQUIRE(diametral_power(a, b, c, x) == power);
    if (o == 0) {
      const Projection projection = projection_of(plane_normal(a, b, c));
      BOOST_REQUIRE(planar_orientation(projection, a, b, x) == sgn(dot(n, cross(rb - ra, rx - ra))));
      BOOST_REQUIRE(planar_in_circle(projection, a, b, c, x) == -power);
    }
    const mpq_class volume = dot(n, ry - ra);
    if (volume != 0) {
      const mpq_class lift = mpq_class(dot(ry - centre, ry - centre) - dot(ra - centre, ra - centre)) / (2 * volume);
      const Rational middle = centre + lift * n;
      const mpq_class inside = dot(ra - middle, ra - middle) - dot(rz - middle, rz - middle);
      BOOST_REQUIRE(in_sphere(a, b, c, y, z) == sgn(inside) * sgn(volume));
      (inside == 0 ? zeros : others) += 1;
    }
  }
  BOOST_TEST(zeros > 3000);
  BOOST_TEST(others > 5000);
}

BOOST_AUTO_TEST_CASE(cocircular_points_tie_exactly) {
  const Point a = Point::from_doubles(0, 0, 0), b = Point::from_doubles(0.3, 0, 0), c = Point::from_doubles(0.3, 0.7, 0),
              d = Point::from_doubles(0, 0.7, 0);
  BOOST_TEST(planar_in_circle({2, 1}, a, b, c, d) == 0);
  BOOST_TEST(diametral_power(a, b, c, d) == 0);
  BOOST_TEST(diametral_power(a, c, b) == 0);
  // one unit in the last place inside and outside
  BOOST_TEST(planar_in_circle({2, 1}, a, b, c, Point::from_doubles(0, std::nextafter(0.7, 0), 0)) == 1);
  BOOST_TEST(planar_in_circle({2, 1}, a, b, c, Point::from_doubles(0, std::nextafter(0.7, 1), 0)) == -1);
  // The power does not depend on which side of the plane the point lies.
  BOOST_TEST(diametral_power(a, b, c, Point::from_doubles(0, 0.7, 1e-30)) == 1);
}

BOOST_AUTO_TEST_CASE(huge_and_tiny_coordinates_stay_exact) {
  const Point a = Point::from_doubles(1e300, 0, 0), b = Point::from_doubles(0, 1e300, 0), c = Point::from_doubles(0, 0, 1e300);
  BOOST_TEST(orientation(a, b, c, Point()) == -1);
  BOOST_TEST(orientation(a, b, c, Point::from_doubles(1e300, 1e-300, 0)) == 1);
  BOOST_TEST(orientation(a, b, c, Point::from_doubles(1e300, -1e-300, 0)) == -1);
  const Point t = Point::from_doubles(1e-320, 0, 0), s = Point::from_doubles(0, 1e-320, 0);
  BOOST_TEST(planar_orientation({2, 1}, Point(), t, s) == 1);
  BOOST_TEST(planar_orientation({2, -1}, Point(), t, s) == -1);
}

BOOST_AUTO_TEST_SUITE_END()
