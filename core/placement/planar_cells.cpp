// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/placement/planar_cells.h"

#include "core/planar/facet_triangulation.h"

namespace confidel {

void add_planar_cells(const Complex& complex, const std::vector<std::vector<int>>& chains, Placement& placement) {
  std::vector<char> in_facet(complex.segments.size(), 0);
  if (!complex.facets.empty()) {
    const Facet& facet = complex.facets[0];
    FacetTriangulation triangulation(projection_of(facet.normal));
    std::vector<char> added(placement.points.size(), 0);
    const auto add = [&](int id) {
      if (!added[id]) triangulation.add_vertex(id, placement.points[id].position);
      added[id] = 1;
    };
    const auto constrain = [&](const std::array<VertexId, 2>& edge, bool boundary) {
      const SegmentId s = complex.find_segment(edge[0], edge[1]);
      in_facet[s] = 1;
      for (const int id : chains[s]) add(id);
      for (std::size_t i = 0; i + 1 < chains[s].size(); ++i) triangulation.add_constraint(chains[s][i], chains[s][i + 1], boundary);
    };
    for (const auto& edge : facet.boundary) constrain(edge, true);
    for (const auto& edge : facet.constraints) constrain(edge, false);
    for (const VertexId v : facet.isolated) add(v);
    triangulation.mark();
    for (const auto& corners : triangulation.triangles()) placement.cells.push_back({0, corners, CellKind::C, -1, {}});
  }
  for (SegmentId s = 0; s < static_cast<SegmentId>(complex.segments.size()); ++s)
    for (std::size_t i = 0; !in_facet[s] && i + 1 < chains[s].size(); ++i) placement.hanging.push_back({s, chains[s][i], chains[s][i + 1]});
}

}  // namespace confidel
