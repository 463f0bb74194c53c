// SPDX-License-Identifier: GPL-3.0-or-later
// A planar domain with integer or dyadic coordinates, and what its constrained Delaunay triangulation must be: by CGAL's own
// triangulation with an exact kernel, in the plane's own coordinates.
#pragma once

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <map>
#include <set>

#include "core/planar/region.h"
#include "tests/support/rationals.h"

namespace confidel::test {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Planar = std::array<mpq_class, 2>;
using Triple = std::array<int, 3>;

inline Kernel::Point_2 kernel_point(const Planar& p) {
  return {Kernel::FT(Kernel::FT::ET(p[0])), Kernel::FT(Kernel::FT::ET(p[1]))};
}

/// An embedding of the plane that keeps angles: orthogonal integer directions of one length.
struct Embedding {
  IntegerVector u, v;
  Projection projection;
  Embedding(IntegerVector first, IntegerVector second) : u(std::move(first)), v(std::move(second)), projection(projection_of(cross(u, v))) {}
  Point operator()(const Planar& p) const {
    // Coordinates are dyadic.
    const auto exponent = [](const mpq_class& x) { return static_cast<int>(mpz_sizeinbase(x.get_den().get_mpz_t(), 2)) - 1; };
    const Point base;
    return translate(translate(base, {p[0].get_num(), exponent(p[0])}, u), {p[1].get_num(), exponent(p[1])}, v);
  }
  static Point translate(const Point& base, const std::pair<mpz_class, int>& factor, const IntegerVector& direction) {
    const int exponent = std::max(base.exponent(), factor.second);
    std::array<mpz_class, 3> x;
    for (int i = 0; i < 3; ++i)
      x[i] = (base.numerator(i) << (exponent - base.exponent())) + ((factor.first * direction[i]) << (exponent - factor.second));
    return Point(x[0], x[1], x[2], exponent);
  }
};

class Reference {
 public:
  Reference(const std::vector<Planar>& points, const std::set<Pair>& boundary) : points_(points) {
    std::vector<Triangulation::Vertex_handle> handles;
    for (std::size_t i = 0; i < points.size(); ++i) {
      handles.push_back(triangulation_.insert(kernel_point(points[i])));
      handles.back()->info() = static_cast<int>(i);
    }
    for (const auto& [a, b] : boundary) triangulation_.insert_constraint(handles[a], handles[b]);
    mark();
    merge_ties();
  }

  /// The region's triangles are a constrained Delaunay triangulation of the same domain, whatever it did about ties: in every cocircular
  /// polygon (faces joined across unconstrained edges whose four points are on a circle) it has as many triangles as the reference.
  std::string compare(const std::vector<Triple>& triangles) const {
    std::map<int, int> count;
    std::set<Triple> seen;
    for (const Triple& t : triangles) {
      if (!seen.insert(t).second) return "a triangle twice";
      if (orientation(t) != CGAL::LEFT_TURN) return "a triangle that is not counter-clockwise";
      int home = -1;
      for (const auto& [polygon, corners] : corners_)
        if (corners.count(t[0]) && corners.count(t[1]) && corners.count(t[2])) home = polygon;
      if (home < 0) return "triangle " + std::to_string(t[0]) + " " + std::to_string(t[1]) + " " + std::to_string(t[2]) + " is not Delaunay";
      ++count[home];
    }
    for (const auto& [polygon, corners] : corners_)
      if (count[polygon] != static_cast<int>(corners.size()) - 2) return "a polygon is not covered";
    return "";
  }

  /// The inner triangles on the boundary edges whose third corner is in the edge's open diametral disk.
  std::vector<Pair> encroached() const {
    std::set<Pair> result;
    for (auto f : triangulation_.finite_face_handles()) {
      if (!inside_.at(f)) continue;
      for (int i = 0; i < 3; ++i) {
        const int a = f->vertex((i + 1) % 3)->info(), b = f->vertex((i + 2) % 3)->info();
        if (triangulation_.is_constrained({f, i}) && in_disk(a, b, f->vertex(i)->info())) result.insert({std::min(a, b), std::max(a, b)});
      }
    }
    return {result.begin(), result.end()};
  }

  bool in_disk(int a, int b, int c) const {
    return CGAL::angle(kernel_point(points_[a]), kernel_point(points_[c]), kernel_point(points_[b])) == CGAL::OBTUSE;
  }
  std::size_t ties() const { return ties_; }
  std::size_t inner_faces() const { return inner_; }

 private:
  using Vertex = CGAL::Triangulation_vertex_base_with_info_2<int, Kernel>;
  using Face = CGAL::Constrained_triangulation_face_base_2<Kernel>;
  using Triangulation =
      CGAL::Constrained_Delaunay_triangulation_2<Kernel, CGAL::Triangulation_data_structure_2<Vertex, Face>, CGAL::No_constraint_intersection_tag>;
  using Handle = Triangulation::Face_handle;

  CGAL::Orientation orientation(const Triple& t) const {
    return CGAL::orientation(kernel_point(points_[t[0]]), kernel_point(points_[t[1]]), kernel_point(points_[t[2]]));
  }

  // By rays: a face is inside iff a ray from its centroid crosses the boundary an odd number of times.
  void mark() {
    for (auto f : triangulation_.all_face_handles()) inside_[f] = false;
    std::vector<Pair> boundary;
    for (const auto& e : triangulation_.constrained_edges())
      boundary.push_back({e.first->vertex((e.second + 1) % 3)->info(), e.first->vertex((e.second + 2) % 3)->info()});
    for (auto f : triangulation_.finite_face_handles()) {
      Planar centre{0, 0};
      for (int i = 0; i < 3; ++i)
        for (int k : {0, 1}) centre[k] += points_[f->vertex(i)->info()][k] / 3;
      bool inside = false;
      for (const auto& [a, b] : boundary) {
        const Planar &p = points_[a], &q = points_[b];
        if ((p[1] > centre[1]) == (q[1] > centre[1])) continue;
        if (p[0] + (centre[1] - p[1]) * (q[0] - p[0]) / (q[1] - p[1]) > centre[0]) inside = !inside;
      }
      inside_[f] = inside;
      inner_ += inside;
    }
  }

  void merge_ties() {
    std::map<Handle, int> polygon;
    int next = 0;
    for (auto start : triangulation_.finite_face_handles()) {
      if (!inside_[start] || polygon.count(start)) continue;
      std::vector<Handle> todo{start};
      polygon[start] = next;
      while (!todo.empty()) {
        const Handle f = todo.back();
        todo.pop_back();
        for (int i = 0; i < 3; ++i) {
          corners_[next].insert(f->vertex(i)->info());
          const Handle g = f->neighbor(i);
          if (triangulation_.is_constrained({f, i}) || triangulation_.is_infinite(g) || polygon.count(g)) continue;
          const int far = g->vertex(g->index(f))->info();
          if (CGAL::side_of_oriented_circle(f->vertex(0)->point(), f->vertex(1)->point(), f->vertex(2)->point(), kernel_point(points_[far])) !=
              CGAL::ON_ORIENTED_BOUNDARY)
            continue;
          ++ties_;
          polygon[g] = next;
          todo.push_back(g);
        }
      }
      ++next;
    }
  }

  const std::vector<Planar>& points_;
  Triangulation triangulation_;
  std::map<Handle, bool> inside_;
  std::map<int, std::set<int>> corners_;
  std::size_t ties_ = 0, inner_ = 0;
};

}  // namespace confidel::test
