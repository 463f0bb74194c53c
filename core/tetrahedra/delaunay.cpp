// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tetrahedra/delaunay.h"

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Triangulation_vertex_base_with_info_3.h>

#include <algorithm>
#include <stdexcept>

#include "core/tetrahedra/traits.h"

namespace confidel {
namespace {
using VertexBase = CGAL::Triangulation_vertex_base_with_info_3<int, SpaceTraits>;
using CellBase = CGAL::Delaunay_triangulation_cell_base_3<SpaceTraits>;
using Triangulation = CGAL::Delaunay_triangulation_3<SpaceTraits, CGAL::Triangulation_data_structure_3<VertexBase, CellBase>>;
using VertexHandle = Triangulation::Vertex_handle;
using CellHandle = Triangulation::Cell_handle;
}  // namespace

struct DelaunayTetrahedralization::Implementation {
  Triangulation triangulation;
  std::vector<VertexHandle> vertices;

  int id(VertexHandle v) const { return triangulation.is_infinite(v) ? -1 : v->info(); }
  const Point& point(int id) const { return *vertices[id]->point().point; }
};

DelaunayTetrahedralization::DelaunayTetrahedralization() : implementation_(std::make_unique<Implementation>()) {}
DelaunayTetrahedralization::~DelaunayTetrahedralization() = default;
DelaunayTetrahedralization::DelaunayTetrahedralization(DelaunayTetrahedralization&&) noexcept = default;
DelaunayTetrahedralization& DelaunayTetrahedralization::operator=(DelaunayTetrahedralization&&) noexcept = default;

int DelaunayTetrahedralization::dimension() const { return implementation_->triangulation.dimension(); }

bool DelaunayTetrahedralization::present(int id) const {
  return id >= 0 && id < static_cast<int>(implementation_->vertices.size()) && implementation_->vertices[id] != VertexHandle();
}

void DelaunayTetrahedralization::insert(int id, const Point& point, int near) {
  auto& self = *implementation_;
  if (static_cast<int>(self.vertices.size()) <= id) self.vertices.resize(id + 1);
  const CellHandle start = present(near) ? self.vertices[near]->cell() : CellHandle();
  const std::size_t before = self.triangulation.number_of_vertices();
  const VertexHandle v = self.triangulation.insert(SpacePoint{&point}, start);
  if (self.triangulation.number_of_vertices() == before) throw std::logic_error("tetrahedralization: a point is inserted twice");
  v->info() = id;
  self.vertices[id] = v;
}

void DelaunayTetrahedralization::remove(int id) {
  auto& self = *implementation_;
  self.triangulation.remove(self.vertices[id]);
  self.vertices[id] = VertexHandle();
}

bool DelaunayTetrahedralization::is_edge(int a, int b) const {
  const auto& self = *implementation_;
  CellHandle cell;
  int i = 0, j = 0;
  return self.triangulation.is_edge(self.vertices[a], self.vertices[b], cell, i, j);
}

std::vector<int> DelaunayTetrahedralization::neighbours(int id) const {
  const auto& self = *implementation_;
  std::vector<VertexHandle> around;
  self.triangulation.finite_adjacent_vertices(self.vertices[id], std::back_inserter(around));
  std::vector<int> result;
  for (const VertexHandle v : around) result.push_back(v->info());
  return result;
}

std::vector<std::array<int, 4>> DelaunayTetrahedralization::tetrahedra() const {
  const auto& self = *implementation_;
  std::vector<std::array<int, 4>> result;
  for (auto cell = self.triangulation.finite_cells_begin(); cell != self.triangulation.finite_cells_end(); ++cell) {
    std::array<int, 4> corners{};
    for (int i = 0; i < 4; ++i) corners[i] = cell->vertex(i)->info();
    // Even permutations keep the orientation: the least first, then the least of the others.
    const auto least = std::min_element(corners.begin(), corners.end());
    if (least != corners.begin()) {
      std::iter_swap(corners.begin(), least);
      std::swap(corners[2], corners[3]);
    }
    std::rotate(corners.begin() + 1, std::min_element(corners.begin() + 1, corners.end()), corners.end());
    result.push_back(corners);
  }
  std::sort(result.begin(), result.end());
  return result;
}

DelaunayTetrahedralization::Face DelaunayTetrahedralization::face(int a, int b, int c) const {
  const auto& self = *implementation_;
  const auto& t = self.triangulation;
  Face result;
  CellHandle cell;
  int i = 0, j = 0, k = 0;
  if (!t.is_facet(self.vertices[a], self.vertices[b], self.vertices[c], cell, i, j, k)) return result;
  result.exists = true;
  const int l = 6 - i - j - k;
  for (const VertexHandle apex : {cell->vertex(l), t.mirror_vertex(cell, l)}) {
    if (t.is_infinite(apex)) continue;
    const int side = orientation(self.point(a), self.point(b), self.point(c), *apex->point().point);
    (side > 0 ? result.above : result.below) = apex->info();
  }
  return result;
}

DelaunayTetrahedralization::Face DelaunayTetrahedralization::cocircular_face(int a, int b, int c) const {
  const auto& self = *implementation_;
  const auto& t = self.triangulation;
  Face result;
  std::vector<Triangulation::Facet> facets;
  t.finite_incident_facets(self.vertices[a], std::back_inserter(facets));
  const Point &pa = self.point(a), &pb = self.point(b), &pc = self.point(c);
  for (const auto& [cell, l] : facets) {
    bool fits = true;
    for (int k = 0; k < 4 && fits; ++k) {
      if (k == l) continue;
      const Point& p = *cell->vertex(k)->point().point;
      if (&p == &pa || &p == &pb || &p == &pc) continue;
      fits = orientation(pa, pb, pc, p) == 0 && diametral_power(pa, pb, pc, p) == 0;
    }
    if (!fits) continue;
    result.exists = true;
    for (const VertexHandle apex : {cell->vertex(l), t.mirror_vertex(cell, l)}) {
      if (t.is_infinite(apex)) continue;
      (orientation(pa, pb, pc, *apex->point().point) > 0 ? result.above : result.below) = apex->info();
    }
    return result;
  }
  return result;
}

std::vector<int> DelaunayTetrahedralization::coplanar_across(int a, int b, int c) const {
  const auto& self = *implementation_;
  const auto& t = self.triangulation;
  std::vector<int> result;
  CellHandle cell;
  int i = 0, j = 0;
  if (!t.is_edge(self.vertices[a], self.vertices[b], cell, i, j)) return result;
  auto f = t.incident_facets(cell, i, j), end = f;
  do {
    const CellHandle g = f->first;
    for (int k = 0; k < 4; ++k) {
      if (k == f->second) continue;
      const VertexHandle v = g->vertex(k);
      if (v == self.vertices[a] || v == self.vertices[b] || t.is_infinite(v)) continue;
      if (v == self.vertices[c]) continue;
      const Point& p = *v->point().point;
      if (orientation(self.point(a), self.point(b), self.point(c), p) != 0) continue;
      SpaceTraits::Coplanar_orientation_3 side;
      if (side(self.vertices[a]->point(), self.vertices[b]->point(), self.vertices[c]->point(), v->point()) == CGAL::NEGATIVE)
        result.push_back(v->info());
    }
  } while (++f != end);
  return result;
}

DelaunayTetrahedralization::Conflict DelaunayTetrahedralization::conflict(const Point& point, int near) const {
  const auto& self = *implementation_;
  const auto& t = self.triangulation;
  Conflict result;
  const SpacePoint p{&point};
  Triangulation::Locate_type type;
  int i = 0, j = 0;
  const CellHandle start = t.locate(p, type, i, j, present(near) ? self.vertices[near]->cell() : CellHandle());
  std::vector<CellHandle> cells;
  std::vector<Triangulation::Facet> rim;
  t.find_conflicts(p, start, std::back_inserter(rim), std::back_inserter(cells));
  std::vector<std::array<int, 2>> kept;
  const auto edge = [](int a, int b) { return std::array<int, 2>{std::min(a, b), std::max(a, b)}; };
  for (const auto& [cell, k] : rim) {
    std::array<int, 3> corners{};
    int n = 0;
    for (int v = 0; v < 4; ++v)
      if (v != k) corners[n++] = self.id(cell->vertex(v));
    kept.push_back(edge(corners[0], corners[1]));
    kept.push_back(edge(corners[1], corners[2]));
    kept.push_back(edge(corners[0], corners[2]));
  }
  std::sort(kept.begin(), kept.end());
  for (const CellHandle cell : cells) {
    int corners[4];
    for (int v = 0; v < 4; ++v) corners[v] = self.id(cell->vertex(v));
    for (int a = 0; a < 4; ++a) {
      for (int b = a + 1; b < 4; ++b) {
        const auto e = edge(corners[a], corners[b]);
        if (e[0] >= 0 && !std::binary_search(kept.begin(), kept.end(), e)) result.edges.push_back(e);
      }
      std::array<int, 3> face{};
      int n = 0;
      for (int b = 0; b < 4; ++b)
        if (b != a) face[n++] = corners[b];
      std::sort(face.begin(), face.end());
      if (face[0] >= 0) result.faces.push_back(face);
    }
  }
  std::sort(result.edges.begin(), result.edges.end());
  result.edges.erase(std::unique(result.edges.begin(), result.edges.end()), result.edges.end());
  std::sort(result.faces.begin(), result.faces.end());
  result.faces.erase(std::unique(result.faces.begin(), result.faces.end()), result.faces.end());
  return result;
}

}  // namespace confidel
