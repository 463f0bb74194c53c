// SPDX-License-Identifier: GPL-3.0-or-later
// Where the points of a mesh lie in a complex: exactly on its vertices, segments and facets, or near them.
#pragma once

#include <vector>

#include "core/audit/audit.h"

namespace confidel {

struct Locations {
  std::vector<Point> points;                   ///< of the mesh, in the complex's working coordinates
  std::vector<int> point_of_vertex;            ///< of each vertex of the complex; -1: none
  std::vector<int> vertex_of_point;            ///< of each point; -1: none
  std::vector<std::vector<int>> on_segment;    ///< points strictly inside of each segment, exactly on it, from its first vertex to its second
  std::vector<std::vector<int>> on_facet;      ///< points exactly on each facet that lie on no segment of it and are no vertices; increasing
  std::vector<std::vector<FacetId>> near_facets;  ///< of each point: facets that it is on or near; increasing
  std::vector<OffCarrier> off;
  std::vector<int> duplicates;
  long inner = 0;
};

/// Facets that contain each segment; increasing.
std::vector<std::vector<FacetId>> facets_of_segments(const Complex& complex);

Locations locate(const Complex& complex, const Mesh& mesh, double near);

}  // namespace confidel
