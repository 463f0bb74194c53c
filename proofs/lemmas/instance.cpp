// SPDX-License-Identifier: GPL-3.0-or-later
#include "proofs/lemmas/instance.h"

#include <algorithm>
#include <cstdint>

#include "proofs/lemmas/rational_geometry.h"

namespace confidel {
namespace {

template <class T>
void make_set(std::vector<T>& list) {
  std::sort(list.begin(), list.end());
  list.erase(std::unique(list.begin(), list.end()), list.end());
}

RationalVector rational(const Point& point) { return {rational_coordinate(point, 0), rational_coordinate(point, 1), rational_coordinate(point, 2)}; }

}  // namespace

std::uint64_t Instance::edge_key(int from, int to) const {
  return (static_cast<std::uint64_t>(static_cast<std::uint32_t>(from)) << 32) | static_cast<std::uint32_t>(to);
}

SegmentId Instance::find_segment(VertexId a, VertexId b) const {
  const Segment wanted{std::min(a, b), std::max(a, b)};
  const auto place = std::lower_bound(segments.begin(), segments.end(), wanted);
  return place != segments.end() && *place == wanted ? static_cast<SegmentId>(place - segments.begin()) : -1;
}

bool Instance::on_boundary_or_constraint(FacetId facet, SegmentId segment) const {
  const auto& list = segments_of_facet_[facet];
  return std::binary_search(list.begin(), list.end(), segment);
}

bool Instance::has_vertex(FacetId facet, VertexId vertex) const {
  return std::binary_search(facets_at_[vertex].begin(), facets_at_[vertex].end(), facet);
}

int Instance::cell_with_edge(FacetId facet, int from, int to) const {
  const auto place = edges_[facet].find(edge_key(from, to));
  return place == edges_[facet].end() ? -1 : place->second;
}

bool Instance::lies_on(int point, SegmentId segment) const {
  if (point < vertex_count) return segments[segment][0] == point || segments[segment][1] == point;
  return on_segment_kind(point) && carriers[point] == segment;
}

bool Instance::coplanar(FacetId f, FacetId g) const {
  if (f == g) return true;
  const RationalVector c = cross(normals_[f], normals_[g]);
  if (c[0] != 0 || c[1] != 0 || c[2] != 0) return false;
  return dot(normals_[f], minus(positions[facets[g].frame[0]], positions[facets[f].frame[0]])) == 0;
}

bool Instance::in_plane(int point, FacetId facet) const {
  return dot(normals_[facet], minus(positions[point], positions[facets[facet].frame[0]])) == 0;
}

void Instance::derive() {
  segments_at_.assign(vertex_count, {});
  facets_at_.assign(vertex_count, {});
  cells_at_.assign(vertex_count, {});
  for (std::size_t s = 0; s < segments.size(); ++s)
    for (const VertexId v : segments[s]) segments_at_[v].push_back(static_cast<SegmentId>(s));
  segments_of_facet_.assign(facets.size(), {});
  for (std::size_t f = 0; f < facets.size(); ++f) {
    const Facet& facet = facets[f];
    for (const auto* edges : {&facet.boundary, &facet.constraints})
      for (const auto& [a, c] : *edges) {
        segments_of_facet_[f].push_back(find_segment(a, c));
        for (const VertexId v : {a, c}) facets_at_[v].push_back(static_cast<FacetId>(f));
      }
    for (const VertexId v : facet.isolated) facets_at_[v].push_back(static_cast<FacetId>(f));
    make_set(segments_of_facet_[f]);
    const auto& [i, j, k] = facet.frame;
    normals_.push_back(dimension == 2 ? RationalVector{0, 0, 1} : cross(minus(positions[j], positions[i]), minus(positions[k], positions[i])));
  }
  for (auto& list : facets_at_) make_set(list);
  edges_.assign(facets.size(), {});
  for (std::size_t c = 0; c < cells.size(); ++c) {
    const PlacedCell& cell = cells[c];
    for (int k = 0; k < 3; ++k) {
      edges_[cell.facet].emplace(edge_key(cell.corners[k], cell.corners[(k + 1) % 3]), static_cast<int>(c));
      if (cell.corners[k] < vertex_count) cells_at_[cell.corners[k]].push_back(static_cast<int>(c));
    }
  }
  const auto wrong = [&](int cell) {
    if (wrong_kind < 0 || cell < wrong_kind) wrong_kind = cell;
  };
  for (std::size_t c = 0; c < cells.size(); ++c)
    if (!classify(static_cast<int>(c))) wrong(static_cast<int>(c));
  if (const int cell = pair_boxes(); cell >= 0) wrong(cell);
  for (std::size_t i = 0; i < end_cells.size(); ++i) end_of_cell_[end_cells[i].cell] = static_cast<int>(i);
  for (std::size_t i = 0; i < spoke_cells.size(); ++i) spoke_of_cell_[spoke_cells[i].cell] = static_cast<int>(i);
  for (std::size_t i = 0; i < boxes.size(); ++i)
    for (const int cell : boxes[i].cells) box_of_cell_[cell] = static_cast<int>(i);
  for (const EndCell& end : end_cells)
    if (whole && end.opens && closing_cell(end) < 0) wrong(end.cell);
  for (std::size_t c = 0; c < cells.size(); ++c) {
    if (cells[c].kind != CellKind::C) continue;
    for (int k = 0; k < 3; ++k) {
      const int a = cells[c].corners[k], b = cells[c].corners[(k + 1) % 3];
      const int other = cell_with_edge(cells[c].facet, b, a);
      if (other < 0 || cells[other].kind == CellKind::C) continue;
      int y = -1;
      for (const int corner : cells[other].corners)
        if (corner != a && corner != b) y = corner;
      outline.push_back({static_cast<int>(c), a, b, cells[c].corners[(k + 2) % 3], other, y});
    }
  }
}

bool Instance::classify(int c) {
  const PlacedCell& cell = cells[c];
  if (!cell.offset.is_zero()) return false;
  int vertex = -1, vertices = 0;
  for (int k = 0; k < 3; ++k)
    if (kinds[cell.corners[k]] == PointKind::vertex) {
      vertex = k;
      ++vertices;
    }
  const auto corner = [&](int k) { return cell.corners[(vertex + k) % 3]; };
  switch (cell.kind) {
    case CellKind::T: {
      if (vertices != 1) return false;
      const bool opens = kinds[corner(1)] == PointKind::projection;
      const int v = corner(0), m = corner(opens ? 1 : 2), a = corner(opens ? 2 : 1);
      if (kinds[m] != PointKind::projection || kinds[a] != PointKind::offset) return false;
      const SegmentId segment = carriers[m];
      if (segments[segment][0] != v && segments[segment][1] != v) return false;
      if (!on_boundary_or_constraint(cell.facet, segment)) return false;
      end_cells.push_back({c, v, m, a, opens});
      return static_cast<int>(positions.size()) <= std::max(m, a) || dot(minus(positions[m], positions[v]), minus(positions[a], positions[m])) == 0;
    }
    case CellKind::S:
      if (vertices != 1 || !protects(corner(1)) || !protects(corner(2))) return false;
      spoke_cells.push_back({c, corner(0), corner(1), corner(2)});
      return true;
    case CellKind::R:
      return true;  // in pairs: pair_boxes
    case CellKind::C:
      for (const int point : cell.corners)
        if (!protects(point) && kinds[point] != PointKind::interior) return false;
      return true;
  }
  return false;
}

// All boxes: the quadrilateral of two triangles, turned so that it begins with the side on the segment. Returns the first cell that is no
// half of one, or -1.
int Instance::pair_boxes() {
  for (std::size_t c = 0; c < cells.size(); ++c) {
    if (cells[c].kind != CellKind::R) continue;
    if (c + 1 == cells.size() || cells[c + 1].kind != CellKind::R || cells[c + 1].box != cells[c].box || cells[c + 1].facet != cells[c].facet) return static_cast<int>(c);
    const auto& first = cells[c].corners;
    const auto& second = cells[c + 1].corners;
    BoxCells box{{static_cast<int>(c), static_cast<int>(c + 1)}, {-1, -1, -1, -1}};
    for (int k = 0; k < 3; ++k)
      for (int j = 0; j < 3; ++j)
        if (first[k] == second[(j + 1) % 3] && first[(k + 1) % 3] == second[j]) box.corners = {first[k], second[(j + 2) % 3], first[(k + 1) % 3], first[(k + 2) % 3]};
    if (box.corners[0] < 0) return static_cast<int>(c);
    ++c;
    bool turned = false;
    for (int k = 0; k < 4 && !turned; ++k) {
      const int p = box.corners[k], q = box.corners[(k + 1) % 4], x = box.corners[(k + 2) % 4], y = box.corners[(k + 3) % 4];
      if (kinds[x] != PointKind::offset || kinds[y] != PointKind::offset || !on_segment_kind(p) || !on_segment_kind(q)) continue;
      if (carriers[p] != carriers[q] || !on_boundary_or_constraint(cells[c].facet, carriers[p])) continue;
      box.corners = {p, q, x, y};
      turned = true;
    }
    if (!turned) return box.cells[0];
    boxes.push_back(box);
  }
  return -1;
}

int Instance::box_of(int cell) const {
  const auto place = box_of_cell_.find(cell);
  return place == box_of_cell_.end() ? -1 : place->second;
}

int Instance::closing_cell(const EndCell& opening) const {
  const FacetId facet = cells[opening.cell].facet;
  int p = opening.a;
  for (std::size_t steps = 0; steps <= spoke_cells.size(); ++steps) {
    const int next = cell_with_edge(facet, opening.v, p);
    if (next < 0) return -1;
    if (const auto end = end_of_cell_.find(next); end != end_of_cell_.end()) return end_cells[end->second].opens ? -1 : end->second;
    const auto spoke = spoke_of_cell_.find(next);
    if (spoke == spoke_of_cell_.end()) return -1;
    p = spoke_cells[spoke->second].q;
  }
  return -1;
}

Instance instance_of(const Complex& complex, const Placement& placement, bool with_points) {
  Instance result;
  result.dimension = complex.dimension;
  result.vertex_count = static_cast<int>(complex.vertices.size());
  result.segments = complex.segments;
  for (const Facet& facet : complex.facets) {
    Facet& copy = result.facets.emplace_back();
    copy.frame = facet.frame;
    copy.boundary = facet.boundary;
    copy.constraints = facet.constraints;
    copy.isolated = facet.isolated;
  }
  for (std::size_t id = 0; id < placement.points.size(); ++id) {
    const PlacedPoint& point = placement.points[id];
    result.kinds.push_back(point.kind);
    result.carriers.push_back(point.carrier);
    if (!with_points && id >= complex.vertices.size()) continue;
    if (id < placement.rational_positions.size())
      result.positions.push_back(placement.rational_positions[id]);
    else
      result.positions.push_back(rational(point.position.scaled(complex.scale)));
  }
  result.cells = placement.cells;
  result.rows = placement.rows;
  result.hanging = placement.hanging;
  result.parameters = placement.parameters;
  result.insertions = placement.insertions;
  result.whole = !placement.refutation;
  result.derive();
  return result;
}

}  // namespace confidel
