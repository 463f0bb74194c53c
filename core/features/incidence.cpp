// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/features/incidence.h"

#include <algorithm>

namespace confidel {

namespace {

/// -1 if {a, b} is no segment: an artificial diagonal.
SegmentId segment_between(const Complex& complex, VertexId a, VertexId b) {
  const Segment wanted{std::min(a, b), std::max(a, b)};
  const auto found = std::lower_bound(complex.segments.begin(), complex.segments.end(), wanted);
  if (found == complex.segments.end() || *found != wanted) return -1;
  return static_cast<SegmentId>(found - complex.segments.begin());
}

template <class Pairs>
void sort_and_remove_repetitions(Pairs& pairs) {
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
}

}  // namespace

Incidence::Incidence(const Complex& complex) {
  using Pairs = std::vector<std::pair<int, int>>;
  Pairs vertex_segments, vertex_triangles, vertex_facets, segment_facets, segment_sheets;
  for (std::size_t segment = 0; segment < complex.segments.size(); ++segment) {
    for (const VertexId end : complex.segments[segment]) vertex_segments.emplace_back(end, static_cast<int>(segment));
  }
  for (std::size_t index = 0; index < complex.facets.size(); ++index) {
    const Facet& facet = complex.facets[index];
    const auto id = static_cast<FacetId>(index);
    for (const auto* edges : {&facet.boundary, &facet.constraints}) {
      for (const auto& edge : *edges) {
        segment_facets.emplace_back(segment_between(complex, edge[0], edge[1]), id);
        for (const VertexId end : edge) vertex_facets.emplace_back(end, id);
      }
    }
    for (const VertexId vertex : facet.isolated) vertex_facets.emplace_back(vertex, id);
    for (const auto& corners : facet.triangles) {
      const int triangle = static_cast<int>(triangles.size());
      triangles.push_back({id, corners});
      for (int k = 0; k < 3; ++k) {
        vertex_triangles.emplace_back(corners[k], triangle);
        // Where an edge of K is a segment, the facet contains that segment: the complex is valid.
        const SegmentId segment = segment_between(complex, corners[k], corners[(k + 1) % 3]);
        if (segment >= 0) segment_sheets.emplace_back(segment, corners[(k + 2) % 3]);
      }
    }
  }
  sort_and_remove_repetitions(vertex_facets);
  sort_and_remove_repetitions(segment_facets);
  const std::size_t vertices = complex.vertices.size();
  segments_at = {vertices, vertex_segments};
  triangles_at = {vertices, vertex_triangles};
  facets_at = {vertices, vertex_facets};
  facets_of = {complex.segments.size(), segment_facets};
  sheets_of = {complex.segments.size(), segment_sheets};
}

bool Incidence::facet_has_vertex(FacetId facet, VertexId vertex) const {
  const auto facets = facets_at[vertex];
  return std::binary_search(facets.begin(), facets.end(), facet);
}

bool Incidence::facet_has_segment(FacetId facet, SegmentId segment) const {
  const auto facets = facets_of[segment];
  return std::binary_search(facets.begin(), facets.end(), facet);
}

}  // namespace confidel
