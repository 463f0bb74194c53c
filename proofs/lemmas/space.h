// SPDX-License-Identifier: GPL-3.0-or-later
// The points of an instance for searches: scaled to magnitude 1, approximated with error bounds, indexed.
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>

#include "core/placement/point_index.h"
#include "core/planar/frame.h"
#include "proofs/lemmas/bounded.h"
#include "proofs/lemmas/instance.h"
#include "proofs/lemmas/tally.h"

namespace confidel {

class Space {
 public:
  explicit Space(const Instance& instance);

  const Instance& instance() const { return instance_; }
  /// to - from, in the scaled coordinates.
  BoundedVector difference(int to, int from) const;
  const PointIndex::Position& approximate(int point) const { return high_[point]; }
  Bounded scaled(const mpq_class& length) const;
  /// A lower bound of how far approximate positions are from the true ones: radii of searches are to be enlarged by it.
  static constexpr double position_error = 0x1p-50;
  /// length * sqrt(square), both of them rounded and not exact: a radius within which everything is that a slack below `square` (perhaps
  /// infinite) speaks of. No two points are farther apart than 4.
  static double reach(double length, double square) { return std::min(4.0, length * std::sqrt(std::max(0.0, square)) * (1 + 0x1p-30)); }

  /// An index of the points that the filter accepts.
  PointIndex index(const std::function<bool(int)>& accepted) const;
  PointIndex empty_index() const;

 private:
  const Instance& instance_;
  int scale_ = 0;
  std::vector<PointIndex::Position> high_, low_;
};

/// Where to search for the points with P(x) <= reach R^2 of a sphere with this corner: in scaled coordinates, enlarged by all errors. Everything, if nothing is known.
Ball enclosing_ball(const PointIndex::Position& corner, const BoundedVector& twice_centre, const Bounded& squared_radius, double reach);

/// The sphere of one cell, and the powers of points with respect to it.
class Sphere {
 public:
  Sphere(const Space& space, int cell);

  /// |centre - first corner|^2, exact.
  const mpq_class& squared_radius() const;
  /// P(x), exact.
  mpq_class power(int point) const;
  /// The sign of P(x), exact. If P(x) is certainly positive and P(x)/R^2 certainly above `enough`, that is all that is said:
  /// returns +1, and sets `clear`.
  int sign(int point, double enough, bool& clear) const;
  /// Calls visit(id) for all points of the index with P(x) <= reach R^2, and perhaps for more; reach may be infinite. Corners are left out.
  void visit(const PointIndex& index, double reach, const std::function<void(int)>& visit) const;

 private:
  void make_exact() const;

  const Space& space_;
  const Instance& instance_;
  std::array<int, 3> corners_;
  FacetId facet_;
  const mpq_class& offset_;
  BoundedVector twice_centre_;  ///< from the first corner
  Bounded squared_radius_;
  mutable bool exact_ = false;
  mutable RationalVector exact_twice_centre_;
  mutable mpq_class exact_squared_radius_;
};

}  // namespace confidel
