// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/planar/facet_triangulation.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <algorithm>
#include <set>
#include <stdexcept>
#include <unordered_map>

#include "core/planar/traits.h"

namespace confidel {
namespace {

using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<int, PlanarTraits>;
using FaceBase = CGAL::Triangulation_face_base_with_info_2<bool, PlanarTraits, CGAL::Constrained_triangulation_face_base_2<PlanarTraits>>;
using Triangulation =
    CGAL::Constrained_Delaunay_triangulation_2<PlanarTraits, CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>,
                                               CGAL::No_constraint_intersection_requiring_constructions_tag>;
using VertexHandle = Triangulation::Vertex_handle;
using FaceHandle = Triangulation::Face_handle;
using Edge = Triangulation::Edge;

std::array<int, 2> sorted(int a, int b) { return {std::min(a, b), std::max(a, b)}; }

}  // namespace

struct FacetTriangulation::Implementation {
  explicit Implementation(Projection chosen) : projection(chosen), triangulation(PlanarTraits(chosen)) {}

  Projection projection;
  Triangulation triangulation;
  std::unordered_map<int, VertexHandle> vertices;
  std::set<std::array<int, 2>> boundary;  // pieces that have the facet on one side only

  const Point& point(VertexHandle v) const { return *v->point().point; }
  VertexHandle vertex(int id) const { return vertices.at(id); }
  bool inside(FaceHandle f) const { return !triangulation.is_infinite(f) && f->info(); }

  Triangle triangle(FaceHandle f) const {
    Triangle result{f->vertex(0)->info(), f->vertex(1)->info(), f->vertex(2)->info()};
    std::rotate(result.begin(), std::min_element(result.begin(), result.end()), result.end());
    return result;
  }

  void name(VertexHandle v, int id) {
    v->info() = id;
    vertices[id] = v;
  }

  void mark() {
    for (auto f = triangulation.all_faces_begin(); f != triangulation.all_faces_end(); ++f) f->info() = false;
    CGAL::Unique_hash_map<FaceHandle, bool> seen(false);
    std::vector<std::pair<FaceHandle, bool>> todo{{triangulation.infinite_face(), false}};
    seen[triangulation.infinite_face()] = true;
    while (!todo.empty()) {
      const auto [f, within] = todo.back();
      todo.pop_back();
      f->info() = within;
      for (int i = 0; i < 3; ++i) {
        const FaceHandle g = f->neighbor(i);
        if (seen[g]) continue;
        seen[g] = true;
        bool flips = triangulation.is_constrained(Edge(f, i));
        if (flips) {
          const VertexHandle a = f->vertex(Triangulation::ccw(i)), b = f->vertex(Triangulation::cw(i));
          flips = boundary.count(sorted(a->info(), b->info())) > 0;
        }
        todo.emplace_back(g, flips ? !within : within);
      }
    }
  }

  std::vector<Triangle> star(VertexHandle v) const {
    std::vector<Triangle> result;
    auto f = triangulation.incident_faces(v), end = f;
    do
      if (inside(f)) result.push_back(triangle(f));
    while (++f != end);
    return result;
  }

  std::vector<VertexHandle> link(VertexHandle v) const {
    std::vector<VertexHandle> result;
    auto w = triangulation.incident_vertices(v), end = w;
    do
      if (!triangulation.is_infinite(w)) result.push_back(w);
    while (++w != end);
    return result;
  }

  // The finite faces all of whose corners are around a vertex, each up to three times.
  std::vector<FaceHandle> faces_among(const std::vector<VertexHandle>& ring) const {
    const std::set<VertexHandle> members(ring.begin(), ring.end());
    std::vector<FaceHandle> result;
    for (const VertexHandle v : ring) {
      auto f = triangulation.incident_faces(v), end = f;
      do {
        bool all = !triangulation.is_infinite(f);
        for (int i = 0; i < 3 && all; ++i) all = members.count(f->vertex(i)) > 0;
        if (all) result.push_back(f);
      } while (++f != end);
    }
    return result;
  }

  std::vector<Triangle> corners_among(const std::vector<VertexHandle>& ring) const {
    std::vector<Triangle> result;
    for (const FaceHandle f : faces_among(ring)) result.push_back(triangle(f));
    std::sort(result.begin(), result.end());
    return result;
  }

  // After a removal: the triangles all of whose corners were around the removed vertex.
  std::vector<Triangle> among(const std::vector<VertexHandle>& ring) const {
    std::set<VertexHandle> members(ring.begin(), ring.end());
    std::vector<Triangle> result;
    for (const VertexHandle v : ring) {
      auto f = triangulation.incident_faces(v), end = f;
      do {
        if (!inside(f)) continue;
        bool all = true;
        for (int i = 0; i < 3; ++i) all = all && members.count(f->vertex(i)) > 0;
        if (all) result.push_back(triangle(f));
      } while (++f != end);
    }
    std::sort(result.begin(), result.end());
    result.erase(std::unique(result.begin(), result.end()), result.end());
    return result;
  }
};

FacetTriangulation::FacetTriangulation(Projection projection) : implementation_(std::make_unique<Implementation>(projection)) {}
FacetTriangulation::~FacetTriangulation() = default;
FacetTriangulation::FacetTriangulation(FacetTriangulation&&) noexcept = default;
FacetTriangulation& FacetTriangulation::operator=(FacetTriangulation&&) noexcept = default;

void FacetTriangulation::add_vertex(int id, const Point& point) {
  auto& self = *implementation_;
  self.name(self.triangulation.insert(PlanarPoint{&point}), id);
}

void FacetTriangulation::add_constraint(int a, int b, bool boundary) {
  auto& self = *implementation_;
  self.triangulation.insert_constraint(self.vertex(a), self.vertex(b));
  if (boundary) self.boundary.insert(sorted(a, b));
}

void FacetTriangulation::mark() { implementation_->mark(); }

bool FacetTriangulation::has_vertex(int id) const { return implementation_->vertices.count(id) > 0; }

std::vector<FacetTriangulation::Triangle> FacetTriangulation::triangles() const {
  const auto& self = *implementation_;
  std::vector<Triangle> result;
  for (auto f = self.triangulation.finite_faces_begin(); f != self.triangulation.finite_faces_end(); ++f)
    if (f->info()) result.push_back(self.triangle(f));
  std::sort(result.begin(), result.end());
  return result;
}

bool FacetTriangulation::has_triangle(const Triangle& triangle) const {
  const auto& self = *implementation_;
  VertexHandle v[3];
  for (int i = 0; i < 3; ++i) {
    const auto place = self.vertices.find(triangle[i]);
    if (place == self.vertices.end()) return false;
    v[i] = place->second;
  }
  FaceHandle f;
  return self.triangulation.is_face(v[0], v[1], v[2], f) && self.inside(f);
}

bool FacetTriangulation::is_constraint(int a, int b) const {
  const auto& self = *implementation_;
  FaceHandle f;
  int i = 0;
  return self.triangulation.is_edge(self.vertex(a), self.vertex(b), f, i) && self.triangulation.is_constrained(Edge(f, i));
}

int FacetTriangulation::across(int a, int b, int c) const {
  const auto& self = *implementation_;
  FaceHandle f;
  int i = 0;
  if (!self.triangulation.is_edge(self.vertex(a), self.vertex(b), f, i) || self.triangulation.is_constrained(Edge(f, i))) return -1;
  const VertexHandle other = self.vertex(c);
  VertexHandle v = f->vertex(i);
  if (v == other) v = self.triangulation.mirror_vertex(f, i);
  return self.triangulation.is_infinite(v) ? -1 : v->info();
}

FacetTriangulation::Walk FacetTriangulation::walk(const Triangle& from, const Point& to) const {
  const auto& self = *implementation_;
  const auto& t = self.triangulation;
  FaceHandle f, previous;
  if (!t.is_face(self.vertex(from[0]), self.vertex(from[1]), self.vertex(from[2]), f)) return {};
  const int limit = 4 * static_cast<int>(t.number_of_faces()) + 16;  // a visibility walk may cycle
  for (int steps = 0; steps < limit; ++steps) {
    int crossed = -1;
    for (int k = 0; k < 3 && crossed < 0; ++k) {
      const int i = (k + steps) % 3;
      if (f->neighbor(i) == previous) continue;
      if (planar_orientation(self.projection, self.point(f->vertex(Triangulation::ccw(i))), self.point(f->vertex(Triangulation::cw(i))), to) < 0)
        crossed = i;
    }
    if (crossed < 0) {
      // Exactly on a constraint is behind it.
      for (int i = 0; i < 3; ++i)
        if (t.is_constrained(Edge(f, i)) &&
            planar_orientation(self.projection, self.point(f->vertex(Triangulation::ccw(i))), self.point(f->vertex(Triangulation::cw(i))), to) == 0)
          return {false, sorted(f->vertex(Triangulation::ccw(i))->info(), f->vertex(Triangulation::cw(i))->info())};
      return {true, {-1, -1}};
    }
    if (t.is_constrained(Edge(f, crossed)))
      return {false, sorted(f->vertex(Triangulation::ccw(crossed))->info(), f->vertex(Triangulation::cw(crossed))->info())};
    previous = f;
    f = f->neighbor(crossed);
  }
  return {};
}

std::vector<FacetTriangulation::Triangle> FacetTriangulation::insert(int id, const Point& point, int near) {
  auto& self = *implementation_;
  const auto hint = self.vertices.find(near);
  const VertexHandle v =
      self.triangulation.insert(PlanarPoint{&point}, hint != self.vertices.end() ? hint->second->face() : FaceHandle());
  self.name(v, id);
  auto f = self.triangulation.incident_faces(v), end = f;
  do f->info() = true;
  while (++f != end);
  return self.star(v);
}

std::vector<FacetTriangulation::Triangle> FacetTriangulation::split(int a, int b, int id, const Point& point) {
  auto& self = *implementation_;
  auto& t = self.triangulation;
  FaceHandle f;
  int i = 0;
  if (!t.is_edge(self.vertex(a), self.vertex(b), f, i)) throw std::logic_error("facet triangulation: no such constraint");
  const Point &pa = self.point(self.vertex(a)), &pb = self.point(self.vertex(b));
  // Which sides are in the facet: +1 is left of ab.
  bool left = false, right = false;
  for (const FaceHandle g : {f, f->neighbor(i)}) {
    if (!self.inside(g)) continue;
    for (int k = 0; k < 3; ++k) {
      const int side = planar_orientation(self.projection, pa, pb, self.point(g->vertex(k)));
      left |= side > 0;
      right |= side < 0;
    }
  }
  const VertexHandle v = t.insert(PlanarPoint{&point}, Triangulation::EDGE, f, i);
  self.name(v, id);
  auto g = t.incident_faces(v), end = g;
  do {
    bool within = false;
    if (!t.is_infinite(g))
      for (int k = 0; k < 3; ++k) {
        const int side = planar_orientation(self.projection, pa, pb, self.point(g->vertex(k)));
        within |= (side > 0 && left) || (side < 0 && right);
      }
    g->info() = within;
  } while (++g != end);
  if (self.boundary.erase(sorted(a, b)) > 0) {
    self.boundary.insert(sorted(a, id));
    self.boundary.insert(sorted(id, b));
  }
  return self.star(v);
}

std::vector<FacetTriangulation::Triangle> FacetTriangulation::remove(int id) {
  auto& self = *implementation_;
  const VertexHandle v = self.vertex(id);
  const auto ring = self.link(v);
  // Everything around the point lies in the facet: so does what fills the hole. Other triangles among the ring stay what they are.
  const auto old = self.corners_among(ring);
  self.triangulation.remove(v);
  self.vertices.erase(id);
  for (const FaceHandle f : self.faces_among(ring))
    if (!std::binary_search(old.begin(), old.end(), self.triangle(f))) f->info() = true;
  return self.among(ring);
}

std::vector<FacetTriangulation::Triangle> FacetTriangulation::join(int a, int id, int b) {
  auto& self = *implementation_;
  const VertexHandle v = self.vertex(id);
  const auto ring = self.link(v);
  self.triangulation.remove_incident_constraints(v);
  self.triangulation.remove(v);
  self.vertices.erase(id);
  self.triangulation.insert_constraint(self.vertex(a), self.vertex(b));
  if (self.boundary.erase(sorted(a, id)) > 0) {
    self.boundary.erase(sorted(id, b));
    self.boundary.insert(sorted(a, b));
  }
  self.mark();
  return self.among(ring);
}

}  // namespace confidel
