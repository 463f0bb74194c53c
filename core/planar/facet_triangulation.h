// SPDX-License-Identifier: GPL-3.0-or-later
// The exact constrained Delaunay triangulation of a whole facet, its segments' pieces being the constraints; points come and go.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "core/numbers/point.h"
#include "core/numbers/predicates.h"

namespace confidel {

/// Vertices are named by the caller's ids. Points are referred to, not copied.
class FacetTriangulation {
 public:
  using Triangle = std::array<int, 3>;  ///< counter-clockwise

  explicit FacetTriangulation(Projection projection);
  ~FacetTriangulation();
  FacetTriangulation(FacetTriangulation&&) noexcept;
  FacetTriangulation& operator=(FacetTriangulation&&) noexcept;

  /// The initial vertices and constraints; a boundary constraint has the facet on one side, an inner one on both.
  void add_vertex(int id, const Point& point);
  void add_constraint(int a, int b, bool boundary);
  /// Decides which triangles lie in the facet.
  void mark();

  bool has_vertex(int id) const;
  std::vector<Triangle> triangles() const;
  bool has_triangle(const Triangle& triangle) const;
  bool is_constraint(int a, int b) const;
  /// The vertex across the edge ab of the triangle abc if that is no constraint; -1 otherwise.
  int across(int a, int b, int c) const;

  /// Where a point of the plane lies, seen from a triangle: in the facet, or on or behind a constraint (the first on the way).
  struct Walk {
    bool reached = false;
    std::array<int, 2> constraint{-1, -1};
  };
  Walk walk(const Triangle& from, const Point& to) const;

  /// Each returns the triangles of the facet that are new.
  /// Pre of insert: the point lies strictly inside the facet, on no constraint, and on no vertex.
  std::vector<Triangle> insert(int id, const Point& point, int near);
  /// Pre: the point lies strictly between a and b, which a constraint joins.
  std::vector<Triangle> split(int a, int b, int id, const Point& point);
  /// Pre: id was inserted by insert.
  std::vector<Triangle> remove(int id);
  /// Pre: id was inserted by split, between what are now its neighbours a and b on the segment.
  std::vector<Triangle> join(int a, int id, int b);

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace confidel
