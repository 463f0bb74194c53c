// SPDX-License-Identifier: GPL-3.0-or-later
// What complex.h promises about a facet's triangles, in rationals.
#pragma once

#include "core/complex/complex.h"
#include "tests/core/complex/canonical_reader.h"

namespace confidel::test {

/// Twice the area of the facet's region times the length of the frame's normal, by the boundary's directed edges.
inline mpq_class boundary_area(const CanonicalComplex& complex, const CanonicalFacet& facet) {
  const Rational3 normal = facet_normal(complex, facet);
  const Rational3& origin = complex.vertices[facet.frame[0]];
  mpq_class sum = 0;
  for (const auto& [a, c] : facet.boundary)
    sum += scalar(normal, times(minus(complex.vertices[a], origin), minus(complex.vertices[c], origin)));
  return sum;
}

/// Positive triangles whose vertices are the facet's, whose directed edges cancel but for the boundary, that have all
/// constraints as edges, and whose areas add up to the region's.
inline void require_triangulation(const CanonicalComplex& complex, const CanonicalFacet& facet,
                                  const std::vector<std::array<VertexId, 3>>& triangles) {
  const Rational3 normal = facet_normal(complex, facet);
  std::map<Pair, int> directed;
  std::set<int> corners, vertices(facet.isolated.begin(), facet.isolated.end());
  mpq_class area = 0;
  for (const auto& [a, b, c] : triangles) {
    const mpq_class part = scalar(normal, times(minus(complex.vertices[b], complex.vertices[a]),
                                                minus(complex.vertices[c], complex.vertices[a])));
    require(part > 0, "triangles are positive");
    area += part;
    corners.insert({a, b, c});
    for (const Pair& edge : {Pair{a, b}, Pair{b, c}, Pair{c, a}})
      require(++directed[edge] == 1, "directed edges occur once");
  }
  for (const auto& [a, c] : facet.constraints) {
    require(directed.count({a, c}) == 1 && directed.count({c, a}) == 1, "constraints are edges on both sides");
    vertices.insert({a, c});
  }
  std::vector<Pair> rest;
  for (const auto& [edge, times_seen] : directed)
    if (directed.count({edge[1], edge[0]}) == 0) rest.push_back(edge);
  require(rest == facet.boundary, "directed edges cancel but for the boundary");
  for (const auto& [a, c] : facet.boundary) vertices.insert({a, c});
  require(corners == vertices, "corners are the facet's vertices");
  require(area == boundary_area(complex, facet) && area > 0, "areas add up");
}

/// Reads the canonical text again and tests everything that can be tested about a complex by itself.
inline CanonicalComplex require_everything(const Complex& complex) {
  const CanonicalComplex canonical = CanonicalReader(canonical_text(complex)).read();
  require_rules(canonical);
  require(canonical.facets.size() == complex.facets.size(), "all facets are written");
  for (std::size_t i = 0; i < complex.facets.size(); ++i) {
    require_triangulation(canonical, canonical.facets[i], complex.facets[i].triangles);
    const Rational3 normal = facet_normal(canonical, canonical.facets[i]);
    const Rational3 stored{complex.facets[i].normal[0], complex.facets[i].normal[1], complex.facets[i].normal[2]};
    require(times(normal, stored) == Rational3{0, 0, 0} && scalar(normal, stored) > 0, "the normal is the frame's");
  }
  for (const Point& point : complex.vertices)
    for (int axis = 0; axis < 3; ++axis)
      require(std::abs(point.approximate(axis)) <= 1, "working coordinates are at most 1");
  return canonical;
}

}  // namespace confidel::test
