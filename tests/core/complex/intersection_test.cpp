// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/complex/intersection.h"

#include <rapidcheck.h>

#include <boost/test/unit_test.hpp>

#include "tests/core/complex/brute_force.h"
#include "tests/core/complex/generators.h"

using namespace confidel;
using namespace confidel::building;
using namespace confidel::test;

namespace {

/// Points of a small grid meet in every degenerate way.
std::vector<Point> grid_points(int count) {
  const auto coordinates =
      *rc::gen::container<std::vector<int>>(static_cast<std::size_t>(3 * count), whole_range(0, 4));
  std::vector<Point> points;
  for (int i = 0; i < count; ++i)
    points.push_back(Point::from_doubles(coordinates[3 * i], coordinates[3 * i + 1], coordinates[3 * i + 2]));
  return points;
}

Rational3 rational(const Point& point) {
  Rational3 result;
  for (int axis = 0; axis < 3; ++axis) result[axis] = point.approximate(axis);
  return result;
}

Meeting brute_force_meeting(const Corners& first, const Corners& second) {
  Shape a, b;
  for (int i = 0; i < 3; ++i) a.push_back(rational(*first[i])), b.push_back(rational(*second[i]));
  const Shape common = common_part(a, b);
  if (has_area(common)) return Meeting::area;
  if (common.size() < 2) return Meeting::none;
  // In one plane, a common piece of a line belongs to the boundaries of both.
  const Rational3 normal = times(minus(a[1], a[0]), minus(a[2], a[0]));
  for (const Rational3& corner : b)
    if (scalar(normal, minus(corner, a[0])) != 0) return Meeting::line;
  return Meeting::none;
}

/// Every corner of the common part is a common corner or between two of them.
bool meets_in_common_corners(const Corners& first, const Corners& second) {
  Shape a, b, common;
  for (int i = 0; i < 3; ++i) {
    a.push_back(rational(*first[i])), b.push_back(rational(*second[i]));
    if (std::find(second.begin(), second.end(), first[i]) != second.end()) common.push_back(a.back());
  }
  for (const Rational3& point : common_part(a, b))
    if (common.empty() || !on_segment(point, common.front(), common.back())) return false;
  return true;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(complex_intersection)

BOOST_AUTO_TEST_CASE(triangles_meet_as_in_rationals) {
  int met[3] = {0, 0, 0}, quick = 0;
  const bool passed = rc::check("meeting_of", [&] {
    // Six triangles at once: many pairs per case.
    auto p = grid_points(18);
    if (*rc::gen::arbitrary<bool>())
      for (Point& point : p) point = Point::from_doubles(point.approximate(0), 1, point.approximate(2));
    const bool linked = *rc::gen::arbitrary<bool>();
    for (int i = 0; i < 6; ++i)
      for (int j = 0; j < i; ++j) {
        const Corners a{&p[3 * i], &p[3 * i + 1], &p[3 * i + 2]},
            b{linked ? a[i % 3] : &p[3 * j], &p[3 * j + 1], i == 3 ? a[0] : &p[3 * j + 2]};
        if (collinear(*a[0], *a[1], *a[2]) || collinear(*b[0], *b[1], *b[2])) continue;
        const Meeting expected = brute_force_meeting(a, b);
        ++met[static_cast<int>(expected)];
        RC_ASSERT(meeting_of(a, b) == expected);
        if (meet_in_common_corners(a, b)) {
          ++quick;
          RC_ASSERT(meets_in_common_corners(a, b));
        }
        RC_ASSERT(meeting_of(b, {a[2], a[0], a[1]}) == expected);
        RC_ASSERT(meeting_of({b[1], b[0], b[2]}, a) == expected);
      }
  });
  BOOST_TEST(passed);
  // The property means something only if all outcomes occur.
  BOOST_TEST_MESSAGE("none " << met[0] << ", line " << met[1] << ", area " << met[2]);
  BOOST_TEST(quick > 50);
  BOOST_TEST(met[0] > 50);
  BOOST_TEST(met[1] > 50);
  BOOST_TEST(met[2] > 50);
}

BOOST_AUTO_TEST_CASE(segments_pierce_as_in_rationals) {
  int pierced = 0;
  const bool passed = rc::check("segment_pierces", [&] {
    const auto p = grid_points(15);
    const Corners triangle{&p[0], &p[1], &p[2]};
    if (collinear(p[0], p[1], p[2])) return;
    const Shape corners{rational(p[0]), rational(p[1]), rational(p[2])};
    const Rational3 normal = times(minus(corners[1], corners[0]), minus(corners[2], corners[0]));
    for (int i = 3; i + 1 < 15; i += 2) {
      const Rational3 a = rational(p[i]), b = rational(p[i + 1]);
      const bool transversal = scalar(normal, minus(a, corners[0])) * scalar(normal, minus(b, corners[0])) < 0;
      const bool expected = transversal && !common_part({a, b}, corners).empty();
      pierced += expected;
      RC_ASSERT(segment_pierces(p[i], p[i + 1], triangle) == expected);
      RC_ASSERT(segment_pierces(p[i + 1], p[i], {triangle[1], triangle[0], triangle[2]}) == expected);
    }
  });
  BOOST_TEST(passed);
  BOOST_TEST(pierced > 0);
}

BOOST_AUTO_TEST_CASE(segments_cross_as_in_rationals) {
  int crossed = 0;
  const bool passed = rc::check("segments_cross", [&] {
    auto p = grid_points(40);
    const bool planar = *rc::gen::arbitrary<bool>();
    if (planar)
      for (Point& point : p) point = Point::from_doubles(point.approximate(0), point.approximate(1), 0);
    for (int i = 0; i + 3 < 40; i += 4) {
      const Point &a = p[i], &b = p[i + 1], &c = p[i + 2], &d = p[i + 3];
      if (a == b || c == d || (collinear(a, b, c) && collinear(a, b, d))) continue;
      // The common point, if there is one: where cd meets the line ab, by Cramer's rule in the plane of both.
      const Rational3 u = minus(rational(b), rational(a)), v = minus(rational(d), rational(c)),
                      w = minus(rational(c), rational(a)), n = times(u, v);
      bool expected = false;
      if (n != Rational3{0, 0, 0} && scalar(n, w) == 0) {
        const mpq_class s = scalar(times(w, v), n) / scalar(n, n), t = scalar(times(w, u), n) / scalar(n, n);
        expected = s > 0 && s < 1 && t > 0 && t < 1;
        if (expected) {
          const auto point = crossing_point(a, b, c, d);
          RC_ASSERT(point == between(rational(a), rational(b), s));
          RC_ASSERT(point == between(rational(c), rational(d), t));
        }
      }
      crossed += expected;
      RC_ASSERT(segments_cross(a, b, c, d) == expected);
      RC_ASSERT(segments_cross(d, c, a, b) == expected);
      if (planar) RC_ASSERT(planar_segments_cross(a, b, c, d) == expected);
    }
  });
  BOOST_TEST(passed);
  BOOST_TEST(crossed > 10);
}

BOOST_AUTO_TEST_SUITE_END()
