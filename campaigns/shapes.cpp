// SPDX-License-Identifier: GPL-3.0-or-later
#include "campaigns/shapes.h"

#include <algorithm>
#include <set>

#include "core/numbers/predicates.h"

namespace confidel::campaigns {

namespace {

std::vector<Point> exact(const std::vector<Position>& positions) {
  std::vector<Point> points;
  for (const auto& [x, y, z] : positions) points.push_back(Point::from_doubles(x, y, z));
  return points;
}

}  // namespace

double snapped(double value, int bits) { return std::ldexp(std::nearbyint(std::ldexp(value, bits)), -bits); }

Position snapped(const Position& position, int bits) {
  return {snapped(position[0], bits), snapped(position[1], bits), snapped(position[2], bits)};
}

Position sum(const Position& a, const Position& b, double factor) {
  return {a[0] + factor * b[0], a[1] + factor * b[1], a[2] + factor * b[2]};
}

double distance(const Position& a, const Position& b) { return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]); }

std::vector<Position> random_positions(Random& random, int count, int bits, int dimension) {
  std::set<Position> taken;
  std::vector<Position> positions;
  while (static_cast<int>(positions.size()) < count) {
    Position position{random.real(bits), random.real(bits), dimension == 3 ? random.real(bits) : 0};
    if (taken.insert(position).second) positions.push_back(position);
    if (bits < 53 && static_cast<int>(taken.size()) > (1 << std::min(20, dimension * bits - 1))) ++bits;
  }
  return positions;
}

Position Plane::normal() const {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

Plane random_plane(Random& random) {
  Plane plane;
  const auto vector = [&](int size) { return Position{1. * random.integer(-size, size), 1. * random.integer(-size, size), 1. * random.integer(-size, size)}; };
  plane.origin = vector(8);
  if (random.one_in(4)) {
    plane.a = {1, 0, 0}, plane.b = {0, 1, 0};
    return plane;
  }
  do {
    plane.a = vector(random.one_in(5) ? 60 : 4), plane.b = vector(random.one_in(5) ? 60 : 4);
  } while (plane.normal() == Position{0, 0, 0});
  return plane;
}

DelaunayFaces strict_delaunay_faces(const std::vector<Position>& positions) {
  const std::vector<Point> points = exact(positions);
  const int count = static_cast<int>(points.size());
  std::set<std::vector<int>> triangles;
  std::set<std::array<int, 2>> edges;
  for (int a = 0; a < count; ++a)
    for (int b = a + 1; b < count; ++b)
      for (int c = b + 1; c < count; ++c)
        for (int d = c + 1; d < count; ++d) {
          const int turn = orientation(points[a], points[b], points[c], points[d]);
          bool empty = turn != 0;
          for (int e = 0; e < count && empty; ++e)
            if (e != a && e != b && e != c && e != d) empty = turn * in_sphere(points[a], points[b], points[c], points[d], points[e]) < 0;
          if (!empty) continue;
          for (const auto& face : std::vector<std::vector<int>>{{a, b, c}, {a, b, d}, {a, c, d}, {b, c, d}}) triangles.insert(face);
          for (const auto& edge : {std::array{a, b}, {a, c}, {a, d}, {b, c}, {b, d}, {c, d}}) edges.insert(edge);
        }
  return {{triangles.begin(), triangles.end()}, {edges.begin(), edges.end()}};
}

std::vector<std::array<int, 2>> random_noncrossing_segments(Random& random, const std::vector<Position>& planar, int count) {
  const std::vector<Point> points = exact(planar);
  const auto side = [&](int a, int b, int c) { return planar_orientation({2, 1}, points[a], points[b], points[c]); };
  const auto meet = [&](const std::array<int, 2>& s, const std::array<int, 2>& t) {
    for (const int end : t)
      if (end != s[0] && end != s[1] && side(s[0], s[1], end) == 0 && strictly_between(points[s[0]], points[s[1]], points[end])) return true;
    for (const int end : s)
      if (end != t[0] && end != t[1] && side(t[0], t[1], end) == 0 && strictly_between(points[t[0]], points[t[1]], points[end])) return true;
    return side(s[0], s[1], t[0]) * side(s[0], s[1], t[1]) < 0 && side(t[0], t[1], s[0]) * side(t[0], t[1], s[1]) < 0;
  };
  std::vector<std::array<int, 2>> segments;
  const int last = static_cast<int>(points.size()) - 1;
  for (int attempt = 0; attempt < 8 * count && static_cast<int>(segments.size()) < count; ++attempt) {
    const int a = random.integer(0, last), b = random.integer(0, last);
    const std::array<int, 2> segment{std::min(a, b), std::max(a, b)};
    bool good = a != b && std::find(segments.begin(), segments.end(), segment) == segments.end();
    for (int v = 0; v <= last && good; ++v)
      good = v == a || v == b || side(a, b, v) != 0 || !strictly_between(points[a], points[b], points[v]);
    for (std::size_t i = 0; i < segments.size() && good; ++i) good = !meet(segments[i], segment);
    if (good) segments.push_back(segment);
  }
  return segments;
}

}  // namespace confidel::campaigns
