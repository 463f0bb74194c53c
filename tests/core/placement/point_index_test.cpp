// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/placement/point_index.h"

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <random>
#include <set>

#include "tests/support/rationals.h"

using namespace confidel;
using namespace confidel::test;

namespace {

using Generator = std::mt19937_64;
using Position = PointIndex::Position;

double real(Generator& generator) { return std::ldexp(static_cast<double>(generator() >> 11), -52) - 1; }

/// Every point of the closed ball is visited, exactly once; what else is visited is just outside.
void check_ball(const PointIndex& index, const std::vector<Position>& points, const Position& centre, double radius) {
  std::vector<int> visited;
  BOOST_TEST(!index.visit_ball(centre, radius, [&](int id) {
    visited.push_back(id);
    return false;
  }));
  const std::set<int> found(visited.begin(), visited.end());
  BOOST_TEST(found.size() == visited.size());
  const mpq_class square = mpq_class(radius) * mpq_class(radius);
  for (std::size_t id = 0; id < points.size(); ++id) {
    const mpq_class distance = squared(minus(rational(points[id]), rational(centre)));
    if (found.count(static_cast<int>(id)))
      BOOST_TEST((distance <= square * mpq_class(1 + 1e-9) + mpq_class(1e-300)));
    else
      BOOST_TEST((distance > square), "point " << id << " is in the ball and was not visited");
  }
  // The same order again, and an end as soon as the visitor says so.
  std::vector<int> again;
  const std::size_t stop = visited.size() / 2;
  const bool stopped = index.visit_ball(centre, radius, [&](int id) {
    again.push_back(id);
    return again.size() == stop + 1;
  });
  BOOST_TEST(stopped == !visited.empty());
  BOOST_TEST((again == std::vector<int>(visited.begin(), visited.begin() + static_cast<long>(std::min(stop + 1, visited.size())))));
}

void check(const std::vector<Position>& points, const Position& low, const Position& high, Generator& generator, double scale) {
  PointIndex index(low, high);
  BOOST_TEST(index.empty());
  for (std::size_t i = 0; i < points.size(); ++i) {
    index.insert(static_cast<int>(i), points[i]);
    // Queries between insertions: the tree grows.
    if (i % 40 == 0) {
      const std::vector<Position> so_far(points.begin(), points.begin() + static_cast<long>(i) + 1);
      check_ball(index, so_far, points[generator() % so_far.size()], scale * std::abs(real(generator)));
    }
  }
  BOOST_TEST(index.size() == points.size());
  for (int query = 0; query < 25; ++query) {
    const Position& near = points[generator() % points.size()];
    const Position& other = points[generator() % points.size()];
    check_ball(index, points, near, scale * std::pow(std::abs(real(generator)), 3));
    check_ball(index, points, near, 0);
    check_ball(index, points, {scale * real(generator), scale * real(generator), scale * real(generator)}, scale * std::abs(real(generator)));
    // A point nearly on the sphere, often exactly.
    const double distance = std::sqrt((squared(minus(rational(near), rational(other)))).get_d());
    check_ball(index, points, near, distance);
    check_ball(index, points, near, std::nextafter(distance, 0.0));
  }
}

const Position low{-1, -1, -1}, high{1, 1, 1};

}  // namespace

BOOST_AUTO_TEST_SUITE(point_index)

BOOST_AUTO_TEST_CASE(random_points) {
  Generator generator(1);
  std::vector<Position> points(300);
  for (auto& p : points) p = {real(generator), real(generator), real(generator)};
  check(points, low, high, generator, 1);
}

BOOST_AUTO_TEST_CASE(clusters) {
  Generator generator(2);
  std::vector<Position> points;
  for (int i = 0; i < 300; ++i) {
    const double size = std::pow(10.0, -static_cast<double>(generator() % 17));
    points.push_back({0.5 + size * real(generator), -0.25 + size * real(generator), size * real(generator)});
  }
  check(points, low, high, generator, 1);
  check(points, low, high, generator, 1e-9);
}

BOOST_AUTO_TEST_CASE(grid_points) {
  // Points on the borders of all boxes of the tree, and many at equal distances.
  Generator generator(3);
  std::vector<Position> points;
  for (int i = 0; i < 7; ++i)
    for (int j = 0; j < 7; ++j)
      for (int k = 0; k < 7; ++k) points.push_back({i / 3. - 1, j / 4. - 1, k / 8. - 1});
  std::shuffle(points.begin(), points.end(), generator);
  check(points, low, high, generator, 1);
}

BOOST_AUTO_TEST_CASE(duplicates) {
  Generator generator(4);
  std::vector<Position> points;
  for (int i = 0; i < 200; ++i) points.push_back({i % 3 * 0.25, i % 2 * 0.5, 0.125});
  check(points, low, high, generator, 1);
}

BOOST_AUTO_TEST_CASE(outside_the_box) {
  Generator generator(5);
  std::vector<Position> points;
  for (int i = 0; i < 200; ++i) {
    const double size = std::pow(10.0, static_cast<double>(generator() % 5));
    points.push_back({size * real(generator), size * real(generator), size * real(generator)});
  }
  check(points, low, high, generator, 1e3);
}

BOOST_AUTO_TEST_CASE(flat_boxes) {
  Generator generator(6);
  std::vector<Position> points;
  for (int i = 0; i < 100; ++i) points.push_back({real(generator), 0.5, 0});
  check(points, {-1, 0.5, 0}, {1, 0.5, 0}, generator, 1);
  check({{0, 0, 0}}, {0, 0, 0}, {0, 0, 0}, generator, 1);
  check({{1, 2, 3}, {1, 2, 3}, {1, 2, 4}}, {1, 2, 3}, {1, 2, 3}, generator, 4);
}

BOOST_AUTO_TEST_CASE(nothing) {
  const PointIndex index(low, high);
  BOOST_TEST(!index.visit_ball({0, 0, 0}, 10, [](int) { return true; }));
}

BOOST_AUTO_TEST_SUITE_END()
