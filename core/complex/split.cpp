// SPDX-License-Identifier: GPL-3.0-or-later
// Edges become atomic: no vertex lies strictly between the ends of one.
#include <map>

#include "core/complex/broad_phase.h"
#include "core/complex/draft.h"

namespace confidel::building {

namespace {

int line_of(const Draft& draft, const FacetDraft& facet) { return draft.input.facets[facet.source].line; }

/// Every edge once, with its first owner: segments before facets, in the order of the file.
std::vector<EdgeRecord> all_edges(const Draft& draft) {
  std::vector<EdgeRecord> records;
  for (const SegmentDraft& segment : draft.segments)
    records.push_back(
        {segment.ends, -1, segment.source, segment.source < 0 ? 0 : draft.input.segments[segment.source].line});
  for (const FacetDraft& facet : draft.facets)
    for (const Segment& edge : facet.edges) records.push_back({edge, facet.source, -1, line_of(draft, facet)});
  std::stable_sort(records.begin(), records.end(),
                   [](const EdgeRecord& a, const EdgeRecord& b) { return a.ends < b.ends; });
  records.erase(std::unique(records.begin(), records.end(),
                            [](const EdgeRecord& a, const EdgeRecord& b) { return a.ends == b.ends; }),
                records.end());
  return records;
}

using Pieces = std::map<Segment, std::vector<Segment>>;

/// For every edge with vertices strictly inside: the vertices.
std::map<Segment, std::vector<VertexId>> vertices_on_edges(const Draft& draft, const std::vector<EdgeRecord>& records) {
  std::vector<Box> vertex_boxes, edge_boxes;
  for (const auto& position : draft.positions) vertex_boxes.push_back({position, position});
  for (const EdgeRecord& record : records) edge_boxes.push_back(bounding_box(draft.positions, record.ends));
  std::map<Segment, std::vector<VertexId>> found;
  for_each_meeting_pair(vertex_boxes, edge_boxes, [&](int vertex, int index) {
    const auto& [a, b] = records[index].ends;
    if (vertex == a || vertex == b) return;
    const Point &from = draft.vertices[a], &to = draft.vertices[b], &point = draft.vertices[vertex];
    if (collinear(from, to, point) && strictly_between(from, to, point)) found[records[index].ends].push_back(vertex);
  });
  return found;
}

/// Along a line, the lexicographic order is the order from one end to the other.
void sort_along(const Draft& draft, const Segment& edge, std::vector<VertexId>& vertices) {
  const bool forwards = draft.vertices[edge[0]] < draft.vertices[edge[1]];
  std::sort(vertices.begin(), vertices.end(), [&](VertexId a, VertexId b) {
    return forwards ? draft.vertices[a] < draft.vertices[b] : draft.vertices[b] < draft.vertices[a];
  });
}

Pieces split_into_pieces(Draft& draft, const std::vector<EdgeRecord>& records) {
  Pieces pieces;
  for (auto& [edge, vertices] : vertices_on_edges(draft, records)) {
    sort_along(draft, edge, vertices);
    std::vector<Segment>& chain = pieces[edge];
    VertexId last = edge[0];
    for (const VertexId vertex : vertices) {
      draft.report.split_segments.push_back({edge[0], edge[1], vertex});
      chain.push_back(make_segment(last, vertex));
      last = vertex;
    }
    chain.push_back(make_segment(last, edge[1]));
  }
  return pieces;
}

}  // namespace

void split_edges(Draft& draft) {
  const Pieces pieces = split_into_pieces(draft, all_edges(draft));
  if (!pieces.empty()) {
    for (FacetDraft& facet : draft.facets) {
      std::vector<Segment> atomic;
      for (const Segment& edge : facet.edges) {
        const auto found = pieces.find(edge);
        if (found == pieces.end())
          atomic.push_back(edge);
        else
          atomic.insert(atomic.end(), found->second.begin(), found->second.end());
      }
      sort_unique(atomic);
      facet.edges = std::move(atomic);
    }
    std::vector<SegmentDraft> segments;
    for (const SegmentDraft& segment : draft.segments) {
      const auto found = pieces.find(segment.ends);
      if (found == pieces.end()) {
        segments.push_back(segment);
        continue;
      }
      for (const Segment& piece : found->second) segments.push_back({piece, segment.source, segment.marker});
    }
    draft.segments = std::move(segments);
  }
  draft.edges = all_edges(draft);
}

}  // namespace confidel::building
