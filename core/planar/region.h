// SPDX-License-Identifier: GPL-3.0-or-later
// The constrained Delaunay triangulation of P'', a facet (or planar domain) minus its buffer zones, exact, and its refinement
// (theory.md section 4, rules (ii) and (iii)).
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "core/numbers/point.h"
#include "core/numbers/predicates.h"
#include "core/planar/frame.h"

namespace confidel {

/// What refinement asks of its surroundings.
class RegionEnvironment {
 public:
  virtual ~RegionEnvironment() = default;
  /// Is the triangle's diametral sphere encroached (theory.md section 4: power < 0, or = 0 off the plane), by any point known
  /// outside this region's own new points? With only_new: by a point that is new since the last call for this triangle.
  /// May set ball to one that every encroaching point lies in; the region keeps it with the triangle.
  virtual bool encroached(const Point& a, const Point& b, const Point& c, bool only_new, Ball& ball) = 0;
  /// May a point that is new since the last call lie in this ball? Saves the call with only_new, which must fetch the triangle's corners.
  virtual bool near_new_point(const Ball& /*ball*/) { return true; }
  /// The triangle's circumcentre, rounded within the plane (theory.md section 5).
  virtual Point circumcentre(const Point& a, const Point& b, const Point& c) = 0;
  /// True when a limit is reached: refinement returns at once.
  virtual bool stopped() = 0;
  /// Must boundary segments that a circumcentre encroaches be split instead of inserting it (Ruppert's rule)? If not, every
  /// circumcentre inside is inserted (Chew's rule): only for spacings where none comes near the boundary.
  virtual bool boundary_gives_way() { return true; }
  /// Told after each insertion: the triangle whose circumcentre it was, counter-clockwise, and the new vertex.
  virtual void inserted(const std::array<int, 3>& /*triangle*/, int /*vertex*/) {}
};

/// Vertices are numbered from 0 in order of insertion. Points are referred to, not copied: they must outlive the region.
class Region {
 public:
  explicit Region(Projection projection);
  ~Region();
  Region(Region&&) noexcept;
  Region& operator=(Region&&) noexcept;

  /// Inserts a vertex (a boundary vertex or an isolated vertex). Pre: distinct from all others.
  int insert(const Point& point);
  /// Declares a boundary segment. Pre: it crosses no other and passes through no vertex.
  void constrain(int a, int b);
  /// Decides which triangles lie inside: even-odd across the boundary segments. Call once, after all initial segments.
  void mark();

  /// Splits the boundary segment ab by a new vertex that lies on it, or in front of it on the region's side within its diametral
  /// disk (a point of the arc over the chord ab); the region loses the triangle in the latter case. Returns the new vertex.
  int split(int a, int b, const Point& point);

  /// Boundary segments whose open diametral disk contains a vertex of the region: rule (ii).
  std::vector<std::array<int, 2>> encroached_boundary() const;

  struct Refinement {
    /// Boundary segments that must be split before the triangles that they block can be refined; sorted, unique.
    std::vector<std::array<int, 2>> blocking;
    /// Number of vertices inserted: they are the last ones.
    int inserted = 0;
    /// Encroached triangles are left because the environment said stop.
    bool open = false;
    /// A circumcentre rounded onto an existing vertex: the tolerance is too coarse for this input.
    bool stuck = false;
  };
  /// Rule (iii): inserts circumcentres of encroached triangles, greatest first (in large regions up to a factor of 2), until every triangle is free or blocked.
  /// Each triangle is asked about once completely, and after that (with only_new) on every further call.
  /// New points live in the region.
  Refinement refine(RegionEnvironment& environment);

  int vertex_count() const;
  const Point& point(int vertex) const;
  /// Triangles inside, counter-clockwise, in a deterministic order.
  std::vector<std::array<int, 3>> triangles() const;
  std::size_t triangle_count() const;

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace confidel
