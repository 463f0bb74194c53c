// SPDX-License-Identifier: GPL-3.0-or-later
// Exact tests whether two simplices meet in more than they may.
#pragma once

#include <array>

#include "core/numbers/predicates.h"

namespace confidel::building {

using Corners = std::array<const Point*, 3>;

/// True iff the open segments ab and cd have exactly one point in common. Precondition for coplanar ones: not
/// collinear.
bool segments_cross(const Point& a, const Point& b, const Point& c, const Point& d);

/// The same in the plane z = 0.
bool planar_segments_cross(const Point& a, const Point& b, const Point& c, const Point& d);

/// The common point of segments that cross, in the points' coordinates.
std::array<mpq_class, 3> crossing_point(const Point& a, const Point& b, const Point& c, const Point& d);

/// True iff the open segment ab passes through the plane of the triangle in a point of the closed triangle.
bool segment_pierces(const Point& a, const Point& b, const Corners& triangle);

/// Quick and one-sided: true only if the triangles meet in nothing but their common corners (the same Point objects)
/// and, if these are two, the edge between them. Decides most neighbours without exact zeros.
bool meet_in_common_corners(const Corners& first, const Corners& second);

enum class Meeting {
  none,  ///< nothing in common, or one point
  line,  ///< in different planes; a piece of a line of positive length
  area   ///< in one plane; a positive area
};

/// How two triangles meet. Triangles in one plane that have only an edge or a piece of one in common: none.
Meeting meeting_of(const Corners& first, const Corners& second);

}  // namespace confidel::building
