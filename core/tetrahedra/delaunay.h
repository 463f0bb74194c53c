// SPDX-License-Identifier: GPL-3.0-or-later
// The exact Delaunay tetrahedralization of a changing set of points (CGAL, over the project's exact points). It steers and
// cross-checks; the verdict never rests on it. Ties are broken by CGAL's symbolic perturbation.
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "core/numbers/point.h"

namespace confidel {

class DelaunayTetrahedralization {
 public:
  DelaunayTetrahedralization();
  ~DelaunayTetrahedralization();
  DelaunayTetrahedralization(DelaunayTetrahedralization&&) noexcept;
  DelaunayTetrahedralization& operator=(DelaunayTetrahedralization&&) noexcept;

  /// 3 once four points are not coplanar. The queries below make sense then only.
  int dimension() const;

  /// Pre: distinct from all present points; the point outlives its presence; id >= 0 is not present. near: a present id or -1.
  void insert(int id, const Point& point, int near = -1);
  void remove(int id);
  bool present(int id) const;

  bool is_edge(int a, int b) const;
  /// The present points that an edge joins with id.
  std::vector<int> neighbours(int id) const;

  /// All tetrahedra, positively oriented (orientation(a, b, c, d) = +1), the least id first; in increasing order.
  std::vector<std::array<int, 4>> tetrahedra() const;

  /// Is abc a face? Then above/below are the fourth corners of its two tetrahedra, where the normal (b-a) x (c-a) points and on the
  /// other side; -1: the hull's outside.
  struct Face {
    bool exists = false;
    int above = -1, below = -1;
  };
  Face face(int a, int b, int c) const;

  /// Any face at a that is coplanar with abc and has all corners on the circle through a, b, c: with ties in the plane, the
  /// polygon that they span may be triangulated differently. above and below are relative to abc.
  Face cocircular_face(int a, int b, int c) const;

  /// Corners of faces that are coplanar with abc, contain the edge ab, and lie on the other side of it from c.
  std::vector<int> coplanar_across(int a, int b, int c) const;

  /// What the insertion of a point would change: the edges that would vanish, and all faces of the tetrahedra that would.
  struct Conflict {
    std::vector<std::array<int, 2>> edges;   ///< a < b
    std::vector<std::array<int, 3>> faces;   ///< sorted corners; those that vanish and those that stay with another neighbour
  };
  Conflict conflict(const Point& point, int near) const;

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace confidel
