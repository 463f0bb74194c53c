// SPDX-License-Identifier: GPL-3.0-or-later
// The constrained Delaunay triangulation of P'' over rational points of any denominator, and Chew's refinement of it (paper
// section 2.1): the planar strategies whose points lie exactly on circles need both. CGAL's, over its exact kernel.
#pragma once

#include <gmpxx.h>

#include <array>
#include <functional>
#include <memory>
#include <vector>

namespace confidel {

using RationalPoint2 = std::array<mpq_class, 2>;

/// Vertices are numbered from 0 in order of insertion.
class RationalRegion {
 public:
  RationalRegion();
  ~RationalRegion();
  RationalRegion(const RationalRegion&) = delete;
  RationalRegion& operator=(const RationalRegion&) = delete;

  /// Pre: distinct from all others. near: a vertex not far from it, or -1.
  int insert(const RationalPoint2& point, int near = -1);
  /// Declares a boundary segment. Pre: it crosses no other and passes through no vertex.
  void constrain(int a, int b);
  /// Decides which triangles lie inside: even-odd across the boundary segments. Call once, after all segments.
  void mark();

  /// The circumcentre of a triangle inside was inserted, rounded.
  struct Step {
    std::array<int, 3> corners;
    int vertex;
  };
  /// Chew's rule: while a triangle inside has R^2 > threshold, inserts its circumcentre, each coordinate rounded to a multiple of
  /// 2^-bits. Returns the steps in order. `stopped` is asked now and then; when it says so, the rest is left undone.
  /// Throws logic_error when a circumcentre is not inside (then the spacing of the boundary is not what Chew's lemma wants).
  std::vector<Step> refine(const mpq_class& threshold, int bits, const std::function<bool(long)>& stopped);

  int vertex_count() const;
  RationalPoint2 point(int vertex) const;
  /// Triangles inside, counter-clockwise, in a deterministic order.
  std::vector<std::array<int, 3>> triangles() const;

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace confidel
