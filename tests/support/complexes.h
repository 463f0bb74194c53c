// SPDX-License-Identifier: GPL-3.0-or-later
// Complexes for tests, made by hand: no reader, no triangulation, no check of validity.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "core/complex/complex.h"

namespace confidel::support {

using Coordinates = std::array<double, 3>;

/// A facet with its part of K. boundary: counter-clockwise like the triangles.
struct FacetParts {
  std::vector<std::array<VertexId, 2>> boundary;
  std::vector<std::array<VertexId, 3>> triangles;
  std::vector<std::array<VertexId, 2>> constraints = {};
  std::vector<VertexId> isolated = {};
};

/// The convex polygon with these corners, triangulated as a fan from the first one.
inline FacetParts fan(const std::vector<VertexId>& polygon) {
  FacetParts parts;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    parts.boundary.push_back({polygon[i], polygon[(i + 1) % polygon.size()]});
    if (i >= 2) parts.triangles.push_back({polygon[0], polygon[i - 1], polygon[i]});
  }
  return parts;
}

/// The convex polygon with a vertex inside, which all triangles meet; it is isolated as long as no constraint ends
/// there.
inline FacetParts fan_around(VertexId inside, const std::vector<VertexId>& polygon) {
  FacetParts parts;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const VertexId next = polygon[(i + 1) % polygon.size()];
    parts.boundary.push_back({polygon[i], next});
    parts.triangles.push_back({inside, polygon[i], next});
  }
  parts.isolated = {inside};
  return parts;
}

/// Segments are those of the facets and the hanging ones. Vertices are divided by a power of two so that all
/// coordinates have magnitude <= 1.
inline Complex facet_complex(std::vector<Point> vertices, const std::vector<FacetParts>& facets,
                             const std::vector<Segment>& hanging = {}) {
  Complex complex;
  double greatest = 0;
  for (const Point& vertex : vertices) {
    for (int k = 0; k < 3; ++k) greatest = std::max(greatest, std::abs(vertex.approximate(k)));
  }
  std::frexp(greatest, &complex.scale);  // greatest < 2^scale
  for (const Point& vertex : vertices) complex.vertices.push_back(vertex.scaled(-complex.scale));
  complex.segments = hanging;
  for (const FacetParts& parts : facets) {
    Facet facet;
    facet.boundary = parts.boundary;
    facet.constraints = parts.constraints;
    for (auto& edge : facet.constraints) std::sort(edge.begin(), edge.end());
    facet.isolated = parts.isolated;
    std::sort(facet.boundary.begin(), facet.boundary.end());
    std::sort(facet.constraints.begin(), facet.constraints.end());
    std::sort(facet.isolated.begin(), facet.isolated.end());
    facet.triangles = parts.triangles;
    facet.frame = parts.triangles.front();
    const auto& [a, b, c] = facet.frame;
    facet.normal = plane_normal(complex.vertices[a], complex.vertices[b], complex.vertices[c]);
    for (const auto* edges : {&facet.boundary, &facet.constraints}) {
      for (const auto& edge : *edges) complex.segments.push_back(edge);
    }
    complex.facets.push_back(facet);
  }
  for (auto& segment : complex.segments) std::sort(segment.begin(), segment.end());
  std::sort(complex.segments.begin(), complex.segments.end());
  complex.segments.erase(std::unique(complex.segments.begin(), complex.segments.end()), complex.segments.end());
  complex.segment_markers.assign(complex.segments.size(), 0);
  return complex;
}

inline std::vector<Point> points(const std::vector<Coordinates>& coordinates) {
  std::vector<Point> result;
  for (const auto& [x, y, z] : coordinates) result.push_back(Point::from_doubles(x, y, z));
  return result;
}

/// Every triangle is a facet.
inline Complex triangle_complex(const std::vector<Coordinates>& vertices,
                                const std::vector<std::array<VertexId, 3>>& triangles,
                                const std::vector<Segment>& hanging = {}) {
  std::vector<FacetParts> facets;
  for (const auto& [a, b, c] : triangles) facets.push_back(fan({a, b, c}));
  return facet_complex(points(vertices), facets, hanging);
}

}  // namespace confidel::support
