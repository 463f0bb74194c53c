// SPDX-License-Identifier: GPL-3.0-or-later
// Why a triangle is no Delaunay face: the points that lie in every sphere through its corners.
#pragma once

#include <functional>
#include <vector>

#include "core/numbers/point.h"

namespace confidel {

struct Intrusion {
  bool found = false;
  /// Ids of points: every sphere through the corners has one of them in it or on it. second is -1 if first alone is enough: it lies in the
  /// triangle's plane, inside of its circle.
  int first = -1, second = -1;
  /// Minus the power of the deeper of the two, for the sphere in which they are equally deep, over its squared radius: 0.8 is deep inside, 1e-34
  /// next to nothing. Computed exactly and then rounded for the reader; 0 exactly when they are on the sphere (a tie: some Delaunay subdivisions
  /// have the triangle, others not).
  double relative_depth = 0;
};

/// Tests all points given, exactly. Pre: a, b, c not collinear. skip(id) is true for the corners.
/// If none is found, some sphere through a, b, c has no point in it, and none on it off the plane of a, b, c.
Intrusion find_intrusion(const Point& a, const Point& b, const Point& c, const std::vector<Point>& points, const std::function<bool(int)>& skip);

}  // namespace confidel
