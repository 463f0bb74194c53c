// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <map>
#include <set>

#include "core/complex/broad_phase.h"
#include "core/complex/draft.h"
#include "core/complex/intersection.h"

namespace confidel::building {

namespace {

bool share_vertex(const Segment& a, const Segment& b) {
  return a[0] == b[0] || a[0] == b[1] || a[1] == b[0] || a[1] == b[1];
}

/// "(2.5, 3), exactly (5/2, 3)".
std::string crossing_text(const Draft& draft, const Segment& first, const Segment& second) {
  const auto place = [&](VertexId vertex) { return draft.vertices[vertex].scaled(draft.scale); };
  const auto point = crossing_point(place(first[0]), place(first[1]), place(second[0]), place(second[1]));
  std::string decimal, exact;
  for (int axis = 0; axis < draft.input.dimension; ++axis) {
    const char* separator = axis == 0 ? "" : ", ";
    decimal += fmt::format("{}{}", separator, point[axis].get_d());
    exact += separator + point[axis].get_str();
  }
  return decimal == exact ? fmt::format("({})", exact) : fmt::format("({}), exactly ({})", decimal, exact);
}

/// Facets two of whose edges cross each other cannot be triangulated.
void mark_unsound(Draft& draft, const std::vector<std::pair<int, int>>& crossings) {
  std::map<Segment, std::vector<Segment>> partners;
  for (const auto& [first, second] : crossings) partners[draft.edges[first].ends].push_back(draft.edges[second].ends);
  if (partners.empty()) return;
  for (FacetDraft& facet : draft.facets)
    for (const Segment& edge : facet.edges) {
      const auto found = partners.find(edge);
      if (found == partners.end()) continue;
      for (const Segment& partner : found->second)
        if (std::binary_search(facet.edges.begin(), facet.edges.end(), partner)) facet.sound = false;
    }
}

}  // namespace

std::vector<std::pair<int, int>> find_crossing_edges(Draft& draft) {
  std::vector<Box> boxes;
  boxes.reserve(draft.edges.size());
  for (const EdgeRecord& edge : draft.edges) boxes.push_back(bounding_box(draft.positions, edge.ends));
  std::vector<std::pair<int, int>> crossings;
  for_each_meeting_pair(boxes, [&](int i, int j) {
    const Segment &first = draft.edges[i].ends, &second = draft.edges[j].ends;
    if (share_vertex(first, second)) return;
    const auto test = draft.input.dimension == 2 ? planar_segments_cross : segments_cross;
    const auto& points = draft.vertices;
    if (test(points[first[0]], points[first[1]], points[second[0]], points[second[1]]))
      crossings.emplace_back(std::min(i, j), std::max(i, j));
  });
  std::sort(crossings.begin(), crossings.end());
  for (const auto& [i, j] : crossings) {
    const bool swap = draft.edges[i].line > draft.edges[j].line;
    const EdgeRecord &first = draft.edges[swap ? j : i], &second = draft.edges[swap ? i : j];
    draft.add_problem(
        "E-CROSSING", second.line,
        fmt::format("{} crosses {} at {}; make the crossing a vertex of both or remove one", draft.edge_name(second),
                    draft.edge_name(first), crossing_text(draft, first.ends, second.ends)));
  }
  mark_unsound(draft, crossings);
  return crossings;
}

}  // namespace confidel::building
