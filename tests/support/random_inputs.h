// SPDX-License-Identifier: GPL-3.0-or-later
// Random valid inputs from one 64-bit seed: disjoint triangles, subcomplexes of Delaunay facets, stars, fans, polygons with
// dangling segments, hanging edges over facets.
#pragma once

#include <random>

#include "core/numbers/predicates.h"
#include "tests/support/small_inputs.h"

namespace confidel::test {

/// The sequence is the same everywhere: no distributions of the standard library.
class Random {
 public:
  explicit Random(std::uint64_t seed) : generator_(seed) {}
  int integer(int low, int high) { return low + static_cast<int>(generator_() % static_cast<std::uint64_t>(high - low + 1)); }
  double real() { return std::ldexp(static_cast<double>(generator_() >> 11), -52) - 1; }
  bool one_in(int n) { return integer(1, n) == 1; }

 private:
  std::mt19937_64 generator_;
};

/// Points in general position or on a small grid.
inline std::vector<Position> random_positions(Random& random, int count, bool on_grid) {
  std::vector<Position> positions;
  while (static_cast<int>(positions.size()) < count) {
    Position p{random.real(), random.real(), random.real()};
    if (on_grid) p = {1. * random.integer(0, 4), 1. * random.integer(0, 4), 1. * random.integer(0, 4)};
    if (std::find(positions.begin(), positions.end(), p) == positions.end()) positions.push_back(p);
  }
  return positions;
}

/// Some facets and edges of tetrahedra whose spheres are strictly empty of all other points: they are in every subdivision, and none
/// crosses another.
inline Input random_subcomplex(Random& random, int count, bool on_grid) {
  const auto positions = random_positions(random, count, on_grid);
  std::vector<Point> points;
  for (const auto& [x, y, z] : positions) points.push_back(Point::from_doubles(x, y, z));
  std::set<std::vector<int>> facets;
  std::set<Pair> edges;
  for (int a = 0; a < count; ++a)
    for (int b = a + 1; b < count; ++b)
      for (int c = b + 1; c < count; ++c)
        for (int d = c + 1; d < count; ++d) {
          const int turn = orientation(points[a], points[b], points[c], points[d]);
          if (turn == 0) continue;
          bool empty = true;
          for (int e = 0; e < count && empty; ++e)
            if (e != a && e != b && e != c && e != d) empty = turn * in_sphere(points[a], points[b], points[c], points[d], points[e]) < 0;
          if (!empty) continue;
          for (const auto& facet : std::vector<std::vector<int>>{{a, b, c}, {a, b, d}, {a, c, d}, {b, c, d}})
            if (random.one_in(3)) facets.insert(facet);
          for (const Pair& edge : {Pair{a, b}, Pair{b, c}, Pair{a, d}})
            if (random.one_in(8)) edges.insert(edge);
        }
  return triangles(positions, {facets.begin(), facets.end()}, {edges.begin(), edges.end()});
}

/// Triangles with a corner or an edge in common, around it in no order.
inline Input random_book(Random& random, int leaves, bool star) {
  std::vector<Position> vertices{{0, 0, 0}, {1, random.real(), 0.25}};
  std::vector<std::vector<int>> facets;
  for (int i = 0; i < leaves; ++i) {
    const int last = static_cast<int>(vertices.size());
    const double angle = 6.283185307179586 * (i + 0.3 * random.real()) / leaves;
    vertices.push_back({0.5 + 0.4 * random.real(), std::cos(angle), std::sin(angle)});
    if (!star) {
      facets.push_back({0, 1, last});
    } else if (i % 2 == 1) {
      facets.push_back({0, last - 1, last});
    }
  }
  return triangles(vertices, facets);
}

inline Input random_disjoint_triangles(Random& random, int count) {
  std::vector<Position> vertices;
  std::vector<std::vector<int>> facets;
  for (int i = 0; i < count; ++i) {
    // One per cell of a grid.
    const Position centre{3. * (i % 2), 3. * (i / 2 % 2), 3. * (i / 4)};
    for (int corner = 0; corner < 3; ++corner) vertices.push_back({centre[0] + random.real(), centre[1] + random.real(), centre[2] + random.real()});
    facets.push_back({3 * i, 3 * i + 1, 3 * i + 2});
  }
  return triangles(vertices, facets);
}

/// A polygon in a slanted plane with a slit, a vertex inside, and an edge that hangs over it.
inline Input random_plate(Random& random) {
  const auto at = [](double u, double v) { return Position{2 * u + v, u + 2 * v, -2 * u + 2 * v}; };
  InputMaker maker;
  std::vector<Position> vertices{at(0, 0), at(8, 0), at(8, 8), at(random.integer(3, 5), random.integer(5, 7)), at(0, 8), at(2, 1), at(random.integer(3, 6), 2), at(7, 4)};
  const double height = std::ldexp(1.0, -random.integer(0, 3));
  for (const double step : {1.0, 3.0}) {
    Position over = at(1 + step, 3);
    over[0] += 2 * height, over[1] -= 2 * height, over[2] += height * step;
    vertices.push_back(over);
  }
  maker.vertices(vertices).facet({{0, 1, 2, 3, 4}, {5, 6}, {7}}).segment(8, 9);
  return maker;
}

/// Large triangles close above each other, hardly tilted, and edges that hang between them: spheres through one reach the next.
inline Input random_stack(Random& random, int layers) {
  std::vector<Position> vertices;
  std::vector<std::vector<int>> facets;
  std::vector<Pair> hanging;
  for (int layer = 0; layer < layers; ++layer) {
    const int first = static_cast<int>(vertices.size());
    const double height = 0.25 * layer, turn = 6.28 * random.real();
    for (int corner = 0; corner < 3; ++corner) {
      const double angle = turn + 2.1 * corner, radius = 1 + 0.3 * random.real();
      vertices.push_back({radius * std::cos(angle), radius * std::sin(angle), height + 0.04 * random.real()});
    }
    facets.push_back({first, first + 1, first + 2});
    if (random.one_in(2)) continue;
    vertices.push_back({0.6 * random.real(), 0.6 * random.real(), height + 0.1});
    vertices.push_back({random.real(), random.real(), height + 0.15});
    hanging.push_back({first + 3, first + 4});
  }
  return triangles(vertices, facets, hanging);
}

/// Sheets at one edge within less than a right angle.
inline Input random_thin_book(Random& random, int leaves) {
  std::vector<Position> vertices{{0, 0, 0}, {1, 0, 0}};
  std::vector<std::vector<int>> facets;
  for (int i = 0; i < leaves; ++i) {
    const double angle = 0.35 * i + 0.1 * random.real(), size = 0.8 + 0.4 * random.real();
    vertices.push_back({0.5 + 0.6 * random.real(), size * std::cos(angle), size * std::sin(angle)});
    facets.push_back({0, 1, i + 2});
  }
  return triangles(vertices, facets);
}

inline NamedInput random_input(std::uint64_t seed) {
  Random random(seed);
  const std::string name = "seed " + std::to_string(seed) + ": ";
  switch (random.integer(0, 8)) {
    case 0: return {name + "disjoint triangles", random_disjoint_triangles(random, random.integer(2, 4))};
    case 1: return {name + "subcomplex", random_subcomplex(random, random.integer(5, 7), false)};
    case 2: return {name + "subcomplex on a grid", random_subcomplex(random, random.integer(6, 9), true)};
    case 3: return {name + "book", random_book(random, random.integer(2, 5), false)};
    case 4: return {name + "star", random_book(random, random.integer(4, 6), true)};
    case 5: return {name + "plate", random_plate(random)};
    case 6: return {name + "stack", random_stack(random, random.integer(2, 4))};
    case 7: return {name + "thin book", random_thin_book(random, random.integer(2, 5))};
    default: return {name + "fan", fan({random.real(), random.real(), random.real()})};
  }
}

}  // namespace confidel::test
