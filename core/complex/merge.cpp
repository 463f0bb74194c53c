// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/complex/merge.h"

#include <algorithm>
#include <map>
#include <numeric>

namespace confidel {
namespace {

using Edge = std::array<VertexId, 2>;

struct Use {
  FacetId facet;
  bool inner;
};

class Groups {
 public:
  explicit Groups(std::size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), 0); }
  int find(int i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  // The smallest member stands for the group.
  void join(int i, int j) {
    i = find(i);
    j = find(j);
    parent_[std::max(i, j)] = std::min(i, j);
  }

 private:
  std::vector<int> parent_;
};

bool parallel(const IntegerVector& a, const IntegerVector& b) {
  // Both are primitive.
  return a == b || (a[0] == -b[0] && a[1] == -b[1] && a[2] == -b[2]);
}

template <class T>
void sort_unique(std::vector<T>& list) {
  std::sort(list.begin(), list.end());
  list.erase(std::unique(list.begin(), list.end()), list.end());
}

Facet merged(const Complex& complex, const std::vector<FacetId>& members, const std::vector<char>& vanishes) {
  Facet result = complex.facets[members.front()];
  result.boundary.clear();
  result.constraints.clear();
  result.isolated.clear();
  result.triangles.clear();
  std::map<Edge, int> directed;
  std::vector<VertexId> lost;
  for (const FacetId member : members) {
    const Facet& facet = complex.facets[member];
    const bool turned = facet.normal != result.normal;
    for (auto [a, c] : facet.boundary) {
      if (vanishes[complex.find_segment(a, c)]) {
        lost.push_back(a);
        lost.push_back(c);
        continue;
      }
      if (turned) std::swap(a, c);
      ++directed[{a, c}];
    }
    for (const Edge& edge : facet.constraints) result.constraints.push_back(edge);
    for (const VertexId v : facet.isolated) result.isolated.push_back(v);
    for (auto triangle : facet.triangles) {
      if (turned) std::swap(triangle[1], triangle[2]);
      result.triangles.push_back(triangle);
    }
  }
  for (const auto& [edge, count] : directed) {
    if (directed.count({edge[1], edge[0]}) == 0)
      result.boundary.push_back(edge);
    else if (edge[0] < edge[1])
      result.constraints.push_back(edge);  // the facet is on both sides
  }
  sort_unique(result.constraints);
  std::vector<VertexId> joined;
  for (const auto* edges : {&result.boundary, &result.constraints})
    for (const Edge& edge : *edges) joined.insert(joined.end(), edge.begin(), edge.end());
  sort_unique(joined);
  result.isolated.insert(result.isolated.end(), lost.begin(), lost.end());
  sort_unique(result.isolated);
  std::erase_if(result.isolated, [&](VertexId v) { return std::binary_search(joined.begin(), joined.end(), v); });
  return result;
}

}  // namespace

MergeSummary merge_coplanar_facets(Complex& complex, const std::vector<Segment>& kept) {
  MergeSummary summary;
  summary.facets_before = static_cast<int>(complex.facets.size());
  std::vector<std::vector<Use>> uses(complex.segments.size());
  for (std::size_t f = 0; f < complex.facets.size(); ++f) {
    for (const auto& [a, c] : complex.facets[f].boundary) uses[complex.find_segment(a, c)].push_back({static_cast<FacetId>(f), false});
    for (const auto& [a, c] : complex.facets[f].constraints) uses[complex.find_segment(a, c)].push_back({static_cast<FacetId>(f), true});
  }
  Groups groups(complex.facets.size());
  std::vector<char> vanishes(complex.segments.size(), 0);
  for (std::size_t s = 0; s < uses.size(); ++s) {
    if (uses[s].size() != 2 || uses[s][0].inner || uses[s][1].inner) continue;
    const Facet &first = complex.facets[uses[s][0].facet], &second = complex.facets[uses[s][1].facet];
    if (first.marker != second.marker || !parallel(first.normal, second.normal)) continue;
    if (!std::binary_search(kept.begin(), kept.end(), complex.segments[s])) {
      vanishes[s] = 1;
      ++summary.segments_removed;
    }
    groups.join(uses[s][0].facet, uses[s][1].facet);
  }
  std::map<int, std::vector<FacetId>> members;
  for (std::size_t f = 0; f < complex.facets.size(); ++f) members[groups.find(static_cast<int>(f))].push_back(static_cast<FacetId>(f));
  std::vector<Facet> facets;
  for (const auto& [representative, list] : members)
    facets.push_back(list.size() == 1 ? std::move(complex.facets[representative]) : merged(complex, list, vanishes));
  complex.facets = std::move(facets);
  std::vector<Segment> segments;
  std::vector<int> markers;
  for (std::size_t s = 0; s < vanishes.size(); ++s) {
    if (vanishes[s]) continue;
    segments.push_back(complex.segments[s]);
    if (s < complex.segment_markers.size()) markers.push_back(complex.segment_markers[s]);
  }
  complex.segments = std::move(segments);
  complex.segment_markers = std::move(markers);
  summary.facets_after = static_cast<int>(complex.facets.size());
  return summary;
}

}  // namespace confidel
