// SPDX-License-Identifier: GPL-3.0-or-later
// What a placement promises, in rationals and by code of its own: carriers, tiling, empty spheres (certificate-format.md section 5).
#pragma once

#include "core/placement/placement.h"
#include "tests/core/complex/triangulation_rules.h"
#include "tests/support/rationals.h"

namespace confidel::test {

struct ExactPlacement {
  ExactPlacement(const Complex& complex, const Placement& given) : complex(CanonicalReader(canonical_text(complex)).read()), placement(given) {
    for (const PlacedPoint& point : placement.points) points.push_back(rational(point.position.scaled(complex.scale)));
  }

  /// The parameters of all points that a segment carries, its ends included; throws if one is not strictly inside.
  std::map<mpq_class, int> along(int segment) const {
    const auto [a, b] = complex.segments[segment];
    std::map<mpq_class, int> result{{0, a}, {1, b}};
    for (std::size_t i = complex.vertices.size(); i < points.size(); ++i) {
      const PlacedPoint& point = placement.points[i];
      if (!on_segment_kind(point.kind) || point.carrier != segment) continue;
      mpq_class t;
      require(parameter_on_line(points[a], points[b], points[i], t) && t > 0 && t < 1, "a point lies strictly inside its segment");
      require(result.emplace(t, static_cast<int>(i)).second, "points are distinct");
    }
    return result;
  }

  static bool on_segment_kind(PointKind kind) { return kind == PointKind::projection || kind == PointKind::edge; }

  void require_points() const {
    require(points.size() >= complex.vertices.size(), "vertices are points");
    for (std::size_t v = 0; v < complex.vertices.size(); ++v)
      require(points[v] == complex.vertices[v] && placement.points[v].kind == PointKind::vertex, "the first points are the vertices");
    std::set<Rational3> distinct(points.begin(), points.end());
    require(distinct.size() == points.size(), "points are distinct");
    for (std::size_t s = 0; s < complex.segments.size(); ++s) along(static_cast<int>(s));
    for (std::size_t i = complex.vertices.size(); i < points.size(); ++i) {
      const PlacedPoint& point = placement.points[i];
      require(point.kind != PointKind::vertex, "Steiner points are no vertices");
      if (on_segment_kind(point.kind)) continue;
      const CanonicalFacet& facet = complex.facets.at(point.carrier);
      require(scalar(facet_normal(complex, facet), minus(points[i], points[facet.frame[0]])) == 0, "a point lies in its facet's plane");
    }
  }

  /// Rule `tiling`, and that the areas of the cells add up to the facet's.
  void require_tiling() const {
    std::vector<std::map<Pair, int>> directed(complex.facets.size());
    std::vector<mpq_class> area(complex.facets.size());
    std::vector<std::set<int>> corners(complex.facets.size());
    for (const PlacedCell& cell : placement.cells) {
      const auto [a, b, c] = cell.corners;
      const Rational3 normal = facet_normal(complex, complex.facets.at(cell.facet));
      const mpq_class part = scalar(normal, times(minus(points[b], points[a]), minus(points[c], points[a])));
      require(part > 0, "cells are positively oriented");
      area[cell.facet] += part;
      for (const Pair& edge : {Pair{a, b}, Pair{b, c}, Pair{c, a}}) require(++directed[cell.facet][edge] == 1, "directed edges occur once");
      for (const int corner : cell.corners) {
        const PlacedPoint& point = placement.points[corner];
        if (point.kind != PointKind::vertex && !on_segment_kind(point.kind)) require(point.carrier == cell.facet, "corners belong to the facet");
        corners[cell.facet].insert(corner);
      }
    }
    for (std::size_t f = 0; f < complex.facets.size(); ++f) {
      const CanonicalFacet& facet = complex.facets[f];
      require(area[f] == boundary_area(complex, facet), "the areas of the cells add up");
      std::set<Pair> rest;
      for (const auto& [edge, count] : directed[f])
        if (!directed[f].count({edge[1], edge[0]})) rest.insert(edge);
      std::size_t chains = 0;
      for (const auto& [a, c] : facet.boundary) chains += follow(a, c, [&](const Pair& edge) { return rest.count(edge) == 1; });
      require(chains == rest.size(), "open edges are the boundary and nothing else");
      for (const auto& [a, c] : facet.constraints)
        follow(a, c, [&](const Pair& edge) { return directed[f].count(edge) == 1 && directed[f].count({edge[1], edge[0]}) == 1; });
      for (const int v : facet.isolated) require(corners[f].count(v) == 1, "an isolated vertex is a corner");
      for (std::size_t i = complex.vertices.size(); i < points.size(); ++i)
        if (!on_segment_kind(placement.points[i].kind) && placement.points[i].carrier == static_cast<int>(f))
          require(corners[f].count(static_cast<int>(i)) == 1, "a facet's point is a corner of one of its cells");
    }
  }

  /// Rules `emptiness` and `tie`: all cells against all points.
  void require_emptiness() const {
    for (const PlacedCell& cell : placement.cells) {
      const auto [a, b, c] = cell.corners;
      const Rational3 u = minus(points[b], points[a]), w = minus(points[c], points[a]), n = times(u, w);
      const Rational3 facet = facet_normal(complex, complex.facets[cell.facet]);
      const Rational3 flat = scaled(1 / (2 * squared(n)), plus(scaled(squared(u), times(w, n)), scaled(squared(w), times(n, u))));
      const Rational3 twice = scaled(2, plus(flat, scaled(cell.offset.value(), facet)));
      for (std::size_t i = 0; i < points.size(); ++i) {
        const Rational3 x = minus(points[i], points[a]);
        const int power = sgn(mpq_class(squared(x) - scalar(twice, x)));
        require(power >= 0, "no point is inside a cell's sphere");
        if (power > 0) continue;
        require(scalar(facet, x) == 0, "no point off the plane is on a cell's sphere");
        for (const Pair& edge : {Pair{a, b}, Pair{b, c}, Pair{c, a}}) {
          if (!is_constrained(edge, complex.facets[cell.facet])) continue;
          const Rational3 along = minus(points[edge[1]], points[edge[0]]);
          require(scalar(facet, times(along, minus(points[i], points[edge[0]]))) >= 0, "no tie beyond a constraint");
        }
      }
    }
  }

  void require_hanging() const {
    std::set<int> covered;
    for (const CanonicalFacet& facet : complex.facets)
      for (const auto* edges : {&facet.boundary, &facet.constraints})
        for (const auto& [a, c] : *edges) covered.insert(segment_of(a, c));
    std::vector<std::array<int, 3>> expected;
    for (int s = 0; s < static_cast<int>(complex.segments.size()); ++s) {
      if (covered.count(s)) continue;
      int previous = complex.segments[s][0];
      for (const auto& [t, id] : along(s)) {
        if (t > 0) expected.push_back({s, previous, id});
        previous = id;
      }
    }
    require(expected == placement.hanging, "hanging segments are divided at all their points, in order");
    for (const auto& [s, a, b] : placement.hanging)
      for (int x = 0; x < static_cast<int>(points.size()); ++x)
        if (x != a && x != b) require(scalar(minus(points[x], points[a]), minus(points[x], points[b])) > 0, "a hanging piece's ball is empty");
  }

  void require_all() const {
    require_points();
    require_tiling();
    require_emptiness();
    require_hanging();
  }

  CanonicalComplex complex;
  const Placement& placement;
  std::vector<Rational3> points;

 private:
  int segment_of(int a, int c) const {
    const Pair wanted{std::min(a, c), std::max(a, c)};
    const auto place = std::lower_bound(complex.segments.begin(), complex.segments.end(), wanted);
    require(place != complex.segments.end() && *place == wanted, "an edge of a facet is a segment");
    return static_cast<int>(place - complex.segments.begin());
  }

  /// All pieces of the segment from a to c satisfy the test; returns their number.
  template <class Test>
  std::size_t follow(int a, int c, Test test) const {
    std::vector<int> ids;
    for (const auto& [t, id] : along(segment_of(a, c))) ids.push_back(id);
    if (a > c) std::reverse(ids.begin(), ids.end());
    for (std::size_t i = 0; i + 1 < ids.size(); ++i) require(test({ids[i], ids[i + 1]}), "a segment is a union of cell edges");
    return ids.size() - 1;
  }

  /// Do both ends lie on one constraint of the facet (as its vertices or as points that it carries)?
  bool is_constrained(const Pair& edge, const CanonicalFacet& facet) const {
    for (const auto* edges : {&facet.boundary, &facet.constraints})
      for (const auto& [a, c] : *edges) {
        const int segment = segment_of(a, c);
        const auto lies_on = [&](int id) {
          const PlacedPoint& point = placement.points[id];
          return id == a || id == c || (on_segment_kind(point.kind) && point.carrier == segment);
        };
        if (lies_on(edge[0]) && lies_on(edge[1])) return true;
      }
    return false;
  }
};

}  // namespace confidel::test
