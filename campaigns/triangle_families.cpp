// SPDX-License-Identifier: GPL-3.0-or-later
// Complexes of triangles in space.
#include <algorithm>

#include "campaigns/families.h"
#include "campaigns/shapes.h"

namespace confidel::campaigns {

namespace {

Input disjoint_triangles(Random& random) {
  Maker maker;
  const int count = random.integer(1, 7), bits = random.one_in(3) ? 3 : 30;
  for (int i = 0; i < count; ++i) {
    const Position centre{2. * (i % 2), 2. * (i / 2 % 2), 2. * (i / 4)};
    const int first = maker.size();
    for (int corner = 0; corner < 3; ++corner) maker.vertex(sum(centre, {random.real(bits), random.real(bits), random.real(bits)}));
    maker.facet({first, first + 1, first + 2});
  }
  return maker.input();
}

Input delaunay_subcomplex(Random& random) {
  const auto positions = random_positions(random, random.integer(5, 10), random.one_in(3) ? 3 : 53);
  const DelaunayFaces faces = strict_delaunay_faces(positions);
  Maker maker;
  for (const Position& position : positions) maker.vertex(position);
  const int density = random.integer(1, 5);
  for (const auto& triangle : faces.triangles)
    if (random.one_in(density)) maker.facet(triangle);
  for (const auto& [a, b] : faces.edges)
    if (random.one_in(6)) maker.segment(a, b);
  return maker.input();
}

Input two_skeleton(Random& random) {
  const auto positions = random_positions(random, random.integer(4, 8), 53);
  Maker maker;
  for (const Position& position : positions) maker.vertex(position);
  for (const auto& triangle : strict_delaunay_faces(positions).triangles) maker.facet(triangle);
  return maker.input();
}

Input star(Random& random) {
  Maker maker;
  maker.vertex({0, 0, 0});
  const int count = random.integer(2, 6);
  for (int i = 0; i < count; ++i) {
    // A narrow triangle about a random direction: proposals whose triangles meet are refused.
    const Position direction{random.real(), random.real(), random.real()};
    for (int corner = 0; corner < 2; ++corner) {
      const double length = random.between(0.5, 2);
      maker.vertex(snapped({length * (direction[0] + 0.6 * random.real()), length * (direction[1] + 0.6 * random.real()), length * (direction[2] + 0.6 * random.real())}, 20));
    }
    maker.facet({0, maker.size() - 2, maker.size() - 1});
  }
  return maker.input();
}

/// Sheets at the edge 0-1 with these angles in radians.
Input sheets(Random& random, const std::vector<double>& angles, int bits = 24) {
  Maker maker;
  maker.vertex({0, 0, 0});
  maker.vertex({1, 0, 0});
  const bool mirrored = random.one_in(3);
  for (const double angle : angles) {
    const double along = mirrored ? 0.5 : random.between(-0.3, 1.3), size = mirrored ? 0.75 : random.between(0.4, 1.4);
    maker.vertex(snapped({along, size * std::cos(angle), size * std::sin(angle)}, bits));
    maker.facet({0, 1, maker.size() - 1});
  }
  return maker.input();
}

Input fan(Random& random) {
  std::vector<double> angles;
  const int leaves = random.integer(2, 8);
  for (int i = 0; i < leaves; ++i) angles.push_back(full_turn * (i + 0.5 * random.real()) / leaves);
  random.shuffle(angles);
  return sheets(random, angles);
}

Input wedge(Random& random) {
  std::vector<double> angles{full_turn * 0.5 * (random.real() + 1)};
  const int leaves = random.integer(2, 3);
  for (int i = 1; i < leaves; ++i) angles.push_back(angles.back() + 1. / random.integer(2, random.one_in(4) ? 60 : 12));
  return sheets(random, angles, 30);
}

Input plates(Random& random) {
  Maker maker;
  const int layers = random.integer(2, 3);
  const double gap = std::ldexp(1.0, -random.integer(1, 7));
  for (int layer = 0; layer < layers; ++layer) {
    const int first = maker.size();
    const double turn = full_turn * random.real();
    for (int corner = 0; corner < 3; ++corner) {
      const double angle = turn + full_turn / 3 * corner, radius = random.between(0.8, 1.2);
      maker.vertex(snapped({radius * std::cos(angle), radius * std::sin(angle), gap * (layer + 0.2 * random.real())}, 30));
    }
    maker.facet({first, first + 1, first + 2});
  }
  return maker.input();
}

/// W2, W3 of docs/lemmas.md with parameters: edges that hover over a facet although they share a vertex with it.
Input hovering_at_edge(Random& random) {
  const int n = random.integer(4, 40), h = random.integer(1, 6);
  Maker maker;
  maker.vertex({0, 0, 0});
  maker.vertex({1. * n, 0, 0});
  maker.vertex({0, 1. * n, 0});
  maker.vertex({1. * n + random.integer(-2, 2), 1. * n + random.integer(-2, 2), 1. * h});
  maker.facet({0, 1, 2});
  maker.facet({0, 1, 3});
  const int below = random.integer(0, 2);
  for (int i = 0; i < below; ++i) {
    maker.vertex({0.5 * n + random.integer(-3, 3), 0.5 * n + random.integer(-3, 3), -1. * random.integer(1, n)});
    maker.facet({0, 1, maker.size() - 1});
  }
  return maker.input();
}

/// G3 with parameters: facets that share only a vertex.
Input hovering_at_vertex(Random& random) {
  const int n = random.integer(4, 40);
  Maker maker;
  maker.vertex({0, 0, 0});
  maker.vertex({1. * n, 0, 0});
  maker.vertex({0, 1. * n, 0});
  maker.facet({0, 1, 2});
  maker.vertex({1. * n, 1. * n + random.integer(-2, 2), 1. * random.integer(1, 6)});
  maker.vertex({1. * random.integer(-2, 2), 1. * random.integer(-2, 2), 1.5 * n});
  maker.facet({0, 3, 4});
  if (!random.one_in(3)) {
    maker.vertex({0.5 * n, 0.5 * n, -1. * random.integer(1, n)});
    maker.vertex({-0.5 * n, -0.5 * n, -1. * random.integer(1, n)});
    maker.facet({0, 5, 6});
  }
  return maker.input();
}

Input sharp_apex(Random& random) {
  Maker maker;
  maker.vertex({0, 0, 0});
  const int sides = random.integer(3, 6);
  const double slope = std::ldexp(1.0, -random.integer(1, 4)), turn = random.real();
  for (int i = 0; i < sides; ++i) {
    const double angle = full_turn * (i + turn + 0.3 * random.real()) / sides, radius = slope * random.between(0.7, 1.3);
    maker.vertex(snapped({radius * std::cos(angle), radius * std::sin(angle), random.between(0.9, 1.1)}));
  }
  for (int i = 0; i < sides; ++i)
    if (sides == 3 || !random.one_in(4)) maker.facet({0, 1 + i, 1 + (i + 1) % sides});
  if (sides == 3 && random.one_in(2)) maker.facet({1, 2, 3});
  return maker.input();
}

Input needles(Random& random) {
  Maker maker;
  const int count = random.integer(1, 3);
  for (int i = 0; i < count; ++i) {
    const int first = maker.size();
    const double width = std::ldexp(1.0, -random.integer(2, 9)), middle = random.one_in(2) ? 0.5 : random.between(0, 1);
    const Position base{random.real(), random.real(), 2. * i + random.real()}, along{2 + random.real(), random.real(), 0.2 * random.real()};
    maker.vertex(base);
    maker.vertex(sum(base, along));
    maker.vertex(sum(sum(base, along, middle), {0, width, 0.5 * width}));
    maker.facet({first, first + 1, first + 2});
  }
  return maker.input();
}

Input hanging_edges(Random& random) {
  Maker maker;
  if (!random.one_in(5)) {
    for (int i = 0; i < 3; ++i) maker.vertex({4. * (i == 1) + random.real(10), 4. * (i == 2) + random.real(10), 0.5 * random.real(10)});
    maker.facet({0, 1, 2});
  }
  const int edges = random.integer(1, 4);
  for (int i = 0; i < edges; ++i) {
    const double height = std::ldexp(1.0, -random.integer(0, 6));
    const int from = !random.one_in(3) || maker.size() == 0 ? maker.vertex({1 + random.real(16), 1 + random.real(16), random.one_in(4) ? -height : height}) : random.integer(0, maker.size() - 1);
    const int to = maker.vertex({2 + 2 * random.real(16), 1 + random.real(16), height * random.between(1, 3)});
    maker.segment(from, to);
  }
  return maker.input();
}

/// Faces of the unit cubes of a small block: every sphere is full of ties.
Input grid(Random& random) {
  const int size = random.integer(1, 2), density = random.integer(1, 4);
  const double aspect = random.one_in(3) ? 0.25 : 1;
  Maker maker;
  const auto number = [&](int x, int y, int z) { return (x * (size + 1) + y) * (size + 1) + z; };
  for (int x = 0; x <= size; ++x)
    for (int y = 0; y <= size; ++y)
      for (int z = 0; z <= size; ++z) maker.vertex({1. * x, 1. * y, aspect * z});
  const bool halves = random.one_in(2);
  for (int axis = 0; axis < 3; ++axis)
    for (int at = 0; at <= size; ++at)
      for (int u = 0; u < size; ++u)
        for (int v = 0; v < size; ++v) {
          if (!random.one_in(density)) continue;
          std::vector<int> corners;
          for (const auto& [du, dv] : {std::array{0, 0}, {1, 0}, {1, 1}, {0, 1}}) {
            std::array<int, 3> p{};
            p[axis] = at, p[(axis + 1) % 3] = u + du, p[(axis + 2) % 3] = v + dv;
            corners.push_back(number(p[0], p[1], p[2]));
          }
          if (!halves) {
            maker.facet(corners);
            continue;
          }
          std::rotate(corners.begin(), corners.begin() + random.integer(0, 1), corners.end());
          maker.facet({corners[0], corners[1], corners[2]});
          if (!random.one_in(4)) maker.facet({corners[0], corners[2], corners[3]});
        }
  return maker.input();
}

/// Triangles of the convex hull of integer points on one sphere: all points are cospherical, exactly.
Input cospherical(Random& random) {
  const int square = random.choose(std::vector<int>{9, 14, 21, 26, 41, 50, 81});
  std::vector<Position> sphere;
  for (int x = -9; x <= 9; ++x)
    for (int y = -9; y <= 9; ++y)
      for (int z = -9; z <= 9; ++z)
        if (x * x + y * y + z * z == square) sphere.push_back({1. * x, 1. * y, 1. * z});
  random.shuffle(sphere);
  sphere.resize(std::min<std::size_t>(sphere.size(), static_cast<std::size_t>(random.integer(4, 9))));
  Maker maker;
  for (const Position& position : sphere) maker.vertex(position);
  const int count = maker.size(), density = random.integer(1, 3);
  const auto height = [&](int a, int b, int c, int d) {
    const Position u = sum(sphere[b], sphere[a], -1), v = sum(sphere[c], sphere[a], -1), w = sum(sphere[d], sphere[a], -1);
    return u[0] * (v[1] * w[2] - v[2] * w[1]) + u[1] * (v[2] * w[0] - v[0] * w[2]) + u[2] * (v[0] * w[1] - v[1] * w[0]);
  };
  for (int a = 0; a < count; ++a)
    for (int b = a + 1; b < count; ++b)
      for (int c = b + 1; c < count; ++c) {
        int above = 0, below = 0;
        for (int d = 0; d < count; ++d) {
          if (d == a || d == b || d == c) continue;
          (height(a, b, c, d) > 0 ? above : below) += 1;
          if (height(a, b, c, d) == 0) above = below = 1;
        }
        if (above * below == 0 && random.one_in(density)) maker.facet({a, b, c});
      }
  return maker.input();
}

}  // namespace

std::vector<Family> triangle_families() {
  return {
      {"disjoint-triangles", 3, true, "triangles with nothing in common", disjoint_triangles},
      {"delaunay-subcomplex", 3, true, "some faces and edges of a Delaunay tetrahedralization", delaunay_subcomplex},
      {"two-skeleton", 3, true, "all triangles of a Delaunay tetrahedralization", two_skeleton},
      {"star", 3, true, "triangles with one vertex in common", star},
      {"fan", 3, true, "triangles with one edge in common, all around it", fan},
      {"wedge", 3, true, "triangles with one edge in common, 1/k radians apart, k up to 60", wedge},
      {"plates", 3, true, "nearly parallel triangles with gaps of 2^-k, k up to 7", plates},
      {"hovering-at-edge", 3, true, "the counterexamples W2 and W3 with random parameters", hovering_at_edge},
      {"hovering-at-vertex", 3, true, "the counterexample G3 with random parameters", hovering_at_vertex},
      {"sharp-apex", 3, true, "sides of a steep pyramid", sharp_apex},
      {"needles", 3, true, "thin triangles: needles and caps", needles},
      {"hanging-edges", 3, true, "edges in no facet, near one, at one, or alone", hanging_edges},
      {"grid", 3, true, "squares and half squares of unit cubes: as many ties as there can be", grid},
      {"cospherical", 3, true, "triangles between integer points of one sphere", cospherical},
  };
}

}  // namespace confidel::campaigns
