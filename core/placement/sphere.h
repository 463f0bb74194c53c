// SPDX-License-Identifier: GPL-3.0-or-later
// Smallest spheres through triangles: approximate for steering, exact for what encroaches them.
#pragma once

#include "core/numbers/point.h"
#include "core/numbers/predicates.h"
#include "core/planar/frame.h"

namespace confidel {

/// The smallest ball with a, b, c on its sphere, inflated by a bound on its error: for pruning only. offset: centre minus a, not inflated.
Ball circumscribed_ball(const Point& a, const Point& b, const Point& c, Double3* offset = nullptr);

/// The same for the segment ab.
Ball diametral_ball(const Point& a, const Point& b);

/// Does p encroach the smallest sphere through a, b, c (theory.md section 4)? Power < 0, or = 0 off the plane; and, so that ties do not
/// cross constraints (L18b), = 0 in the plane strictly to the right of the constraint (first, second), if there is one.
/// Exact. Pre: p is none of a, b, c.
bool encroaches(Projection projection, const Point& a, const Point& b, const Point& c, const Point& p, const Point* first = nullptr,
                const Point* second = nullptr);

/// A facet's circumcentres, rounded within its plane.
struct CircumcentreRounding {
  const PlaneFrame& frame;
  const Point& origin;  ///< a point of the plane: numerators are short from here
  double reach;         ///< the facet's size
  /// Within tolerance of a + offset. Pre: of the order of `length(offset)` or less.
  Point round(const Point& a, const Double3& offset, double tolerance) const;
};

}  // namespace confidel
