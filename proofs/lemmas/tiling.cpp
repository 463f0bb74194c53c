// SPDX-License-Identifier: GPL-3.0-or-later
// L19, the rule `tiling`: directed edges of the cells cancel but along the facet's boundary; inner constraints are unions of cell edges.
#include <algorithm>
#include <map>
#include <set>

#include "proofs/lemmas/rational_geometry.h"
#include "proofs/lemmas/statements.h"
#include "proofs/lemmas/tally.h"

namespace confidel::statements {
namespace {

using Edge = std::pair<int, int>;

/// The points of a segment in order, its ends included.
std::vector<std::vector<int>> chains(const Instance& instance) {
  std::vector<std::vector<std::pair<mpq_class, int>>> carried(instance.segments.size());
  for (std::size_t id = instance.vertex_count; id < instance.kinds.size(); ++id) {
    if (!instance.on_segment_kind(static_cast<int>(id))) continue;
    const auto& [a, b] = instance.segments[instance.carriers[id]];
    carried[instance.carriers[id]].emplace_back(dot(minus(instance.positions[b], instance.positions[a]), minus(instance.positions[id], instance.positions[a])), static_cast<int>(id));
  }
  std::vector<std::vector<int>> result(instance.segments.size());
  for (std::size_t s = 0; s < instance.segments.size(); ++s) {
    std::sort(carried[s].begin(), carried[s].end());
    result[s].push_back(instance.segments[s][0]);
    for (const auto& [t, id] : carried[s]) result[s].push_back(id);
    result[s].push_back(instance.segments[s][1]);
  }
  return result;
}

bool tiles(const Instance& instance, FacetId f, const std::vector<int>& cells, const std::vector<std::vector<int>>& chains) {
  const Facet& facet = instance.facets[f];
  if (cells.empty()) return false;
  std::set<Edge> directed;
  std::set<int> corners;
  for (const int c : cells)
    for (int k = 0; k < 3; ++k) {
      const auto& at = instance.cells[c].corners;
      corners.insert(at[k]);
      if (!directed.emplace(at[k], at[(k + 1) % 3]).second) return false;
    }
  std::set<Edge> open;
  for (const auto& [a, b] : directed)
    if (!directed.count({b, a})) open.emplace(a, b);
  for (const auto& [a, c] : facet.boundary) {
    // A refined boundary may use only some of the segment's points: those between are then no corners of this facet.
    std::vector<int> chain = chains[instance.find_segment(a, c)];
    if (chain.front() != a) std::reverse(chain.begin(), chain.end());
    std::size_t at = 0;
    while (at + 1 < chain.size()) {
      std::size_t next = at + 1;
      while (next < chain.size() && !open.count({chain[at], chain[next]})) ++next;
      if (next == chain.size()) return false;
      open.erase({chain[at], chain[next]});
      at = next;
    }
  }
  if (!open.empty()) return false;
  for (const auto& [a, c] : facet.constraints) {
    const std::vector<int>& chain = chains[instance.find_segment(a, c)];
    for (std::size_t i = 0; i + 1 < chain.size(); ++i)
      if (!directed.count({chain[i], chain[i + 1]}) && !directed.count({chain[i + 1], chain[i]})) return false;
  }
  return std::all_of(facet.isolated.begin(), facet.isolated.end(), [&](int v) { return corners.count(v) == 1; });
}

}  // namespace

void tiling(const Instance& instance, Tally& tally) {
  const auto segment_chains = chains(instance);
  std::vector<std::vector<int>> by_facet(instance.facets.size());
  for (std::size_t c = 0; c < instance.cells.size(); ++c) by_facet[instance.cells[c].facet].push_back(static_cast<int>(c));
  for (std::size_t f = 0; f < instance.facets.size(); ++f)
    if (!tiles(instance, static_cast<FacetId>(f), by_facet[f], segment_chains))
      tally.fail(line_of(instance.lines.facets, static_cast<int>(f)), fmt::format("facet-{}", f));
}

}  // namespace confidel::statements
