// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/placement/open_hull.h"

#include <algorithm>
#include <numbers>
#include <set>

#include "core/placement/graded.h"
#include "core/placement/planar_cells.h"

namespace confidel {

namespace {

constexpr double sharp = std::numbers::pi / 36;

int orientation(const Point& a, const Point& b, const Point& c) {
  const Difference u = difference(b, a), w = difference(c, a);
  return sgn(mpz_class(u.vector[0] * w.vector[1] - u.vector[1] * w.vector[0]));
}

// Boundary edges with the whole complex on their left or on their line: those between neighbours on the hull, collinear ones included.
std::vector<SegmentId> hull_segments(const Complex& complex) {
  std::vector<VertexId> order(complex.vertices.size());
  for (std::size_t v = 0; v < order.size(); ++v) order[v] = static_cast<VertexId>(v);
  std::sort(order.begin(), order.end(), [&](VertexId a, VertexId b) { return complex.vertices[a] < complex.vertices[b]; });
  std::set<std::array<VertexId, 2>> edges;
  for (int half = 0; half < 2; ++half) {
    std::vector<VertexId> chain;
    for (const VertexId v : order) {
      while (chain.size() >= 2 && orientation(complex.vertices[chain[chain.size() - 2]], complex.vertices[chain.back()], complex.vertices[v]) < 0) chain.pop_back();
      chain.push_back(v);
    }
    for (std::size_t i = 0; i + 1 < chain.size(); ++i) edges.insert({std::min(chain[i], chain[i + 1]), std::max(chain[i], chain[i + 1])});
    std::reverse(order.begin(), order.end());
  }
  std::vector<SegmentId> result;
  for (const auto& [a, c] : complex.facets[0].boundary)
    if (edges.count({std::min(a, c), std::max(a, c)}) != 0) result.push_back(complex.find_segment(a, c));
  return result;
}

}  // namespace

std::optional<Placement> place_with_open_hull(const Complex& complex, const Features& features, const Limits& limits, Progress& progress) {
  if (complex.dimension != 2 || complex.facets.empty()) return std::nullopt;
  std::vector<char> open(complex.segments.size(), 0);
  bool needed = false;
  for (const SegmentId s : hull_segments(complex)) {
    open[s] = 1;
    needed |= std::min(features.segment_angle[s][0], features.segment_angle[s][1]) < sharp;
  }
  if (!needed) return std::nullopt;

  Complex inner;
  inner.dimension = 2;
  inner.vertices = complex.vertices;
  inner.scale = complex.scale;
  std::vector<SegmentId> names;
  for (SegmentId s = 0; s < static_cast<SegmentId>(complex.segments.size()); ++s)
    if (!open[s]) {
      inner.segments.push_back(complex.segments[s]);
      inner.segment_markers.push_back(complex.segment_markers.empty() ? 0 : complex.segment_markers[s]);
      names.push_back(s);
    }
  Placement placement = place_graded(inner, compute_features(inner), limits, progress);
  std::vector<std::vector<int>> chains(complex.segments.size());
  for (SegmentId s = 0; s < static_cast<SegmentId>(chains.size()); ++s)
    if (open[s]) chains[s] = {complex.segments[s][0], complex.segments[s][1]};
  for (const auto& [segment, a, b] : placement.hanging) {
    std::vector<int>& chain = chains[names[segment]];
    if (chain.empty()) chain.push_back(a);
    chain.push_back(b);
  }
  for (PlacedPoint& point : placement.points)
    if (point.carrier >= 0) point.carrier = names[point.carrier];
  for (PlacedRow& row : placement.rows) row.segment = names[row.segment];
  placement.hanging.clear();
  placement.cells.clear();
  placement.claims.clear();
  placement.parameters = {};
  add_planar_cells(complex, chains, placement);
  placement.claims = {"L18", "L18b", "L19", "L22"};
  return placement;
}

}  // namespace confidel
