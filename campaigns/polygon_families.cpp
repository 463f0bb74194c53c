// SPDX-License-Identifier: GPL-3.0-or-later
// Complexes in space with facets of more than three corners. Their coordinates are integers over a power of two, so that facets
// are exactly flat.
#include "campaigns/families.h"
#include "campaigns/shapes.h"

namespace confidel::campaigns {

namespace {

/// A prism whose walls stand on the segments of a random PSLG; sometimes with floor and roof.
Input prism(Random& random) {
  std::vector<Position> floor = random_positions(random, random.integer(3, 7), 4, 2);
  const auto segments = random_noncrossing_segments(random, floor, random.integer(2, 7));
  const double height = std::ldexp(1.0, -random.integer(0, 4));
  Maker maker;
  for (const Position& p : floor) maker.vertex(p);
  for (const Position& p : floor) maker.vertex({p[0], p[1], height});
  const int count = static_cast<int>(floor.size());
  for (const auto& [a, b] : segments) maker.facet({a, b, b + count, a + count});
  if (random.one_in(2)) {
    // The floor is a square around everything; walls stand on it as slits.
    std::vector<std::vector<int>> polygons{{}};
    for (const auto& [x, y] : {std::array{-2., -2.}, {2., -2.}, {2., 2.}, {-2., 2.}}) polygons[0].push_back(maker.vertex({x, y, 0}));
    for (const auto& [a, b] : segments) polygons.push_back({a, b});
    maker.facet(polygons);
  }
  return maker.input();
}

/// A polygon in a random rational plane: a square with a bay, holes, slits, dangling segments, isolated vertices.
void add_polygon(Random& random, Maker& maker, const Plane& plane) {
  const auto at = [&](int u, int v) { return maker.vertex(plane.at(u, v)); };
  std::vector<std::vector<int>> polygons{{at(0, 0), at(16, 0), at(16, 16)}};
  if (random.one_in(2)) polygons[0].push_back(at(random.integer(7, 9), random.integer(13, 17)));
  polygons[0].push_back(at(0, 16));
  std::vector<Position> holes;
  // One thing in each quarter.
  for (int quarter = 0; quarter < 4; ++quarter) {
    const int u = quarter % 2 == 0 ? 1 : 9, v = quarter < 2 ? 1 : 7;
    switch (random.integer(0, 5)) {
      case 0: {
        const int size = random.integer(1, 4);
        polygons.push_back({at(u, v), at(u + size, v), at(u + random.integer(0, size), v + size)});
        // Inside (0,0) (s,0) (x,s), whatever x is: three quarters down the line from the last corner to the middle of the first side.
        const auto& corners = polygons.back();
        const Position middle = sum(sum(maker.at(corners[0]), maker.at(corners[1])), {0, 0, 0});
        holes.push_back({(3 * middle[0] / 2 + maker.at(corners[2])[0]) / 4, (3 * middle[1] / 2 + maker.at(corners[2])[1]) / 4, (3 * middle[2] / 2 + maker.at(corners[2])[2]) / 4});
        break;
      }
      case 1: polygons.push_back({at(u, v), at(u + random.integer(1, 5), v + random.integer(0, 4))}); break;
      case 2: polygons.push_back({at(u + random.integer(0, 3), v + random.integer(0, 3))}); break;
      case 3: {
        const int first = at(u, v), second = at(u + random.integer(1, 3), v + random.integer(1, 3));
        polygons.push_back({first, second});
        polygons.push_back({second, at(u + 4, v + random.integer(0, 1))});
        break;
      }
      case 4: polygons.push_back({polygons[0][0], at(random.integer(1, 4), random.integer(1, 4))}); break;
      default: break;
    }
  }
  maker.facet(polygons, holes);
}

Input polygon(Random& random) {
  Maker maker;
  add_polygon(random, maker, random_plane(random));
  return maker.input();
}

/// Two such polygons in parallel planes, or one with a wall on its first edge.
Input polygons(Random& random) {
  Maker maker;
  Plane plane = random_plane(random);
  add_polygon(random, maker, plane);
  if (random.one_in(2)) {
    plane.origin = sum(plane.origin, plane.normal(), random.one_in(2) ? 1 : 0.25);
    add_polygon(random, maker, plane);
  } else {
    const double height = std::ldexp(1.0, random.integer(-3, 1));
    const Position up = plane.normal();
    const int a = maker.vertex(sum(maker.at(0), up, height)), b = maker.vertex(sum(maker.at(1), up, height));
    maker.facet({0, 1, b, a});
  }
  return maker.input();
}

/// Geology: layers that dip, cut off at a fault.
Input horizons(Random& random) {
  Maker maker;
  const int layers = random.integer(1, 3), throw_height = random.integer(0, 2);
  const int dip_x = random.integer(-1, 1), dip_y = random.integer(-1, 1);
  std::vector<std::vector<int>> on_fault;
  for (const int side : {-1, 1}) {
    std::vector<int> column;
    for (int layer = 0; layer < layers; ++layer) {
      const auto at = [&](int x, int y) { return maker.vertex({1. * x, 1. * y, 0.25 * (dip_x * x + dip_y * y) + 2 * layer + (side > 0 ? throw_height : 0)}); };
      // The fault's plane is x = 0.
      const int a = at(0, 0), b = at(0, 8), c = at(8 * side, 8), d = at(8 * side, 0);
      maker.facet({a, b, c, d});
      column.push_back(a), column.push_back(b);
    }
    on_fault.push_back(column);
    if (throw_height == 0) break;
  }
  if (random.one_in(4)) return maker.input();
  std::vector<std::vector<int>> fault{{maker.vertex({0, -2, -4}), maker.vertex({0, 10, -4}), maker.vertex({0, 10, 12}), maker.vertex({0, -2, 12})}};
  for (const auto& column : on_fault)
    for (std::size_t i = 0; i < column.size(); i += 2) fault.push_back({column[i], column[i + 1]});
  maker.facet(fault);
  return maker.input();
}

/// A closed box with a smaller one inside or beside it, faces as polygons.
Input boxes(Random& random) {
  Maker maker;
  const auto add = [&](const Position& low, const Position& high) {
    const int first = maker.size();
    for (int i = 0; i < 8; ++i) maker.vertex({(i & 1) != 0 ? high[0] : low[0], (i & 2) != 0 ? high[1] : low[1], (i & 4) != 0 ? high[2] : low[2]});
    for (const auto& face : std::vector<std::vector<int>>{{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}) {
      std::vector<int> corners;
      for (const int corner : face) corners.push_back(first + corner);
      maker.facet(corners);
    }
  };
  const auto side = [&] { return 1. * random.integer(2, 8); };
  const Position outer{side(), side(), side()};
  add({0, 0, 0}, outer);
  const double margin = std::ldexp(1.0, -random.integer(1, 5));
  if (random.one_in(2)) add({margin, margin, margin}, {1, 1, 1});
  else if (random.one_in(2)) add({0, 0, outer[2] + margin}, {outer[0], outer[1], outer[2] + 2});
  return maker.input();
}

/// Coplanar neighbours: a polygon cut into pieces that are facets of their own, or one soup of triangles that is to be merged.
Input coplanar(Random& random) {
  const Plane plane = random_plane(random);
  Maker maker;
  const int columns = random.integer(2, 3);
  for (int u = 0; u <= columns; ++u)
    for (int v = 0; v <= 1; ++v) maker.vertex(plane.at(4 * u + (u == columns ? random.integer(0, 2) : 0), 4 * v + random.integer(0, 1)));
  for (int u = 0; u < columns; ++u) {
    const int a = 2 * u;
    if (random.one_in(3)) {
      maker.facet({a, a + 2, a + 3, a + 1});
    } else {
      maker.facet({a, a + 2, a + 3});
      maker.facet({a, a + 3, a + 1});
    }
  }
  if (random.one_in(2)) {
    maker.vertex(sum(maker.at(2), plane.normal(), random.one_in(2) ? 1 : -0.125));
    maker.facet({2, 3, maker.size() - 1});
  }
  maker.input().triangle_soup = random.one_in(2);
  return maker.input();
}

}  // namespace

std::vector<Family> polygon_families() {
  return {
      {"prism", 3, true, "walls on the segments of a random PSLG, with or without a floor", prism},
      {"polygon", 3, true, "one polygon in a slanted plane: holes, slits, dangling segments, isolated vertices", polygon},
      {"polygons", 3, true, "two of these in parallel planes, or one with a wall", polygons},
      {"horizons", 3, true, "layers that dip, cut off at a fault", horizons},
      {"boxes", 3, true, "a box, and perhaps another in it or near it", boxes},
      {"coplanar", 3, true, "coplanar neighbours, to be merged or not", coplanar},
  };
}

}  // namespace confidel::campaigns
