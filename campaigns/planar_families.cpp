// SPDX-License-Identifier: GPL-3.0-or-later
// Planar straight-line graphs.
#include <algorithm>

#include "campaigns/families.h"
#include "campaigns/shapes.h"

namespace confidel::campaigns {

namespace {

Input segments_between(Random& random, const std::vector<Position>& positions, int count) {
  Maker maker(2);
  for (const Position& position : positions) maker.vertex(position);
  for (const auto& [a, b] : random_noncrossing_segments(random, positions, count)) maker.segment(a, b);
  return maker.input();
}

Input planar_graph(Random& random) {
  return segments_between(random, random_positions(random, random.integer(3, 20), random.one_in(3) ? 4 : 53, 2), random.integer(1, 25));
}

Input planar_grid(Random& random) {
  std::vector<Position> positions;
  const int columns = random.integer(2, 5), rows = random.integer(2, 4);
  for (int x = 0; x < columns; ++x)
    for (int y = 0; y < rows; ++y) positions.push_back({1. * x, 1. * y, 0});
  return segments_between(random, positions, random.integer(2, 20));
}

Input planar_cocircular(Random& random) {
  const int square = random.choose(std::vector<int>{25, 65, 325, 1105});
  std::vector<Position> circle;
  for (int x = -33; x <= 33; ++x)
    for (int y = -33; y <= 33; ++y)
      if (x * x + y * y == square) circle.push_back({1. * x, 1. * y, 0});
  if (random.one_in(2)) circle.push_back({0, 0, 0});
  random.shuffle(circle);
  circle.resize(std::min<std::size_t>(circle.size(), static_cast<std::size_t>(random.integer(4, 20))));
  return segments_between(random, circle, random.integer(2, 12));
}

/// Segments that leave one vertex at small angles, lengths in any order.
Input planar_fan(Random& random) {
  Maker maker(2);
  maker.vertex({0, 0, 0});
  const int rays = random.integer(2, 12);
  const double step = random.one_in(2) ? full_turn / rays : 1. / random.integer(3, 300);
  for (int i = 0; i < rays; ++i) {
    const double angle = step * (i + 0.3 * random.real()), length = random.one_in(3) ? 1 : random.between(0.1, 2);
    maker.segment(0, maker.vertex(snapped({length * std::cos(angle), length * std::sin(angle), 0}, 40)));
  }
  return maker.input();
}

Input planar_parallel(Random& random) {
  Maker maker(2);
  const int count = random.integer(2, 6);
  const double gap = std::ldexp(1.0, -random.integer(1, 10));
  for (int i = 0; i < count; ++i) {
    const double tilt = random.one_in(2) ? 0 : 0.3 * gap * random.real();
    const int a = maker.vertex({random.between(-1, 0), gap * i, 0}), b = maker.vertex({random.between(0.5, 2), gap * i + tilt, 0});
    maker.segment(a, b);
  }
  return maker.input();
}

Input planar_polygon(Random& random) {
  Maker maker(2);
  const auto loop = [&](std::vector<Position> corners) {
    const int first = maker.size();
    for (const Position& corner : corners) maker.vertex(corner);
    for (int i = 0; i < maker.size() - first; ++i) maker.segment(first + i, first + (i + 1) % (maker.size() - first));
  };
  const int sides = random.integer(3, 12);
  std::vector<Position> corners;
  for (int i = 0; i < sides; ++i) {
    const double angle = full_turn * (i + 0.3 * random.real()) / sides, radius = random.between(2, 6);
    corners.push_back(snapped({radius * std::cos(angle), radius * std::sin(angle), 0}, 30));
  }
  loop(corners);
  if (random.one_in(2)) {
    loop({{-0.5, -0.5, 0}, {0.5, -0.5, 0}, {random.between(-0.5, 0.5), 0.25, 0}});
    if (random.one_in(2)) maker.hole({0, -0.25, 0});
  }
  if (random.one_in(2)) maker.vertex({0, 0.75, 0});
  if (random.one_in(2)) maker.segment(0, maker.vertex(snapped({0.9 * corners[0][0], 0.9 * corners[0][1] + 0.01, 0}, 30)));
  return maker.input();
}

/// Two segments at 1/k, and something between them near the tip.
Input planar_wedge(Random& random) {
  Maker maker(2);
  const double slope = 1. / random.integer(2, 1000), at = std::ldexp(1.0, -random.integer(0, 6));
  maker.vertex({0, 0, 0});
  maker.segment(0, maker.vertex({1, 0, 0}));
  maker.segment(0, maker.vertex({random.between(0.5, 1), snapped(slope, 40), 0}));
  if (random.one_in(2)) maker.vertex({at * 0.4, snapped(0.5 * at * 0.4 * slope, 50), 0});
  else maker.segment(maker.vertex({0.4, snapped(0.1 * slope, 50), 0}), maker.vertex({0.45, snapped(0.3 * slope, 50), 0}));
  return maker.input();
}

}  // namespace

std::vector<Family> planar_families() {
  return {
      {"planar-graph", 2, true, "random segments that do not cross", planar_graph},
      {"planar-grid", 2, true, "segments between points of a grid: ties everywhere", planar_grid},
      {"planar-cocircular", 2, true, "segments between integer points of one circle", planar_cocircular},
      {"planar-fan", 2, true, "segments with one vertex in common", planar_fan},
      {"planar-wedge", 2, true, "two segments 1/k apart, k up to 1000, and something between them", planar_wedge},
      {"planar-parallel", 2, true, "nearly parallel segments with gaps of 2^-k, k up to 10", planar_parallel},
      {"planar-polygon", 2, true, "a polygon with a hole, isolated vertices, dangling segments", planar_polygon},
  };
}

}  // namespace confidel::campaigns
