// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/complex/intersection.h"

#include <algorithm>
#include <cmath>

namespace confidel::building {

namespace {

/// A projection that is one-to-one on the plane of the four points. Precondition: they are coplanar, but not collinear.
Projection common_projection(const Point& a, const Point& b, const Point& c, const Point& d) {
  IntegerVector normal = plane_normal(a, b, c);
  if (sgn(normal[0]) == 0 && sgn(normal[1]) == 0 && sgn(normal[2]) == 0) normal = plane_normal(a, b, d);
  return projection_of(normal);
}

bool cross_in_plane(Projection projection, const Point& a, const Point& b, const Point& c, const Point& d) {
  const auto side = [&](const Point& p, const Point& q, const Point& r) {
    return planar_orientation(projection, p, q, r);
  };
  return side(a, b, c) * side(a, b, d) < 0 && side(c, d, a) * side(c, d, b) < 0;
}

/// The projection in which two directions span the greatest area. Doubles choose.
Projection broadest_projection(const std::array<double, 3>& u, const std::array<double, 3>& v) {
  Projection projection;
  double greatest = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const int i = (axis + 1) % 3, j = (axis + 2) % 3;
    const double area = std::abs(u[i] * v[j] - u[j] * v[i]);
    if (area > greatest) greatest = area, projection.axis = axis;
  }
  return projection;
}

/// orientation, without asking the exact stage about corners that are the same.
int orientation_of(const Point* a, const Point* b, const Point* c, const Point* d) {
  if (a == b || a == c || a == d || b == c || b == d || c == d) return 0;
  return orientation(*a, *b, *c, *d);
}

/// Signs of the corners of a triangle with respect to the plane of another one.
std::array<int, 3> sides(const Corners& plane, const Corners& triangle) {
  std::array<int, 3> signs{};
  for (int i = 0; i < 3; ++i) signs[i] = orientation_of(plane[0], plane[1], plane[2], triangle[i]);
  return signs;
}

/// Rotates the triangle so that its first corner lies strictly on one side of the plane and the others on the closed
/// other side. Returns the sign of that side, or 0 if the triangle has at most one point on the plane.
int isolate_corner(Corners& triangle, std::array<int, 3> signs) {
  for (int turn = 0; turn < 3; ++turn) {
    const int sign = signs[0];
    if (sign != 0 && signs[1] != sign && signs[2] != sign) {
      // (+,0,0) has an edge on the plane, (+,0,-) and (+,-,-) cross it. What is left, (0,+,+) and (+,+,+), has no such
      // corner.
      return sign;
    }
    std::rotate(triangle.begin(), triangle.begin() + 1, triangle.end());
    std::rotate(signs.begin(), signs.begin() + 1, signs.end());
  }
  return 0;
}

bool interiors_meet_in_plane(const Corners& first, const Corners& second) {
  const Projection projection = projection_of(plane_normal(*first[0], *first[1], *first[2]));
  const auto separates = [&](const Corners& a, const Corners& b) {
    const int inner = planar_orientation(projection, *a[0], *a[1], *a[2]);
    for (int i = 0; i < 3; ++i)
      if (std::all_of(b.begin(), b.end(), [&](const Point* corner) {
            return planar_orientation(projection, *a[i], *a[(i + 1) % 3], *corner) * inner <= 0;
          }))
        return true;
    return false;
  };
  return !separates(first, second) && !separates(second, first);
}

}  // namespace

namespace {

/// Are c and d strictly on one side of the line ab, or a and b of cd, along the axis that shows most of them? Doubles
/// choose the axis.
bool separated_in_projection(const Point& a, const Point& b, const Point& c, const Point& d) {
  std::array<double, 3> u{}, v{};
  for (int axis = 0; axis < 3; ++axis) {
    u[axis] = b.approximate(axis) - a.approximate(axis);
    v[axis] = d.approximate(axis) - c.approximate(axis);
  }
  const Projection projection = broadest_projection(u, v);
  const auto side = [&](const Point& p, const Point& q, const Point& r) {
    return planar_orientation(projection, p, q, r);
  };
  return side(a, b, c) * side(a, b, d) > 0 || side(c, d, a) * side(c, d, b) > 0;
}

}  // namespace

bool planar_segments_cross(const Point& a, const Point& b, const Point& c, const Point& d) {
  return cross_in_plane(Projection{}, a, b, c, d);
}

bool segments_cross(const Point& a, const Point& b, const Point& c, const Point& d) {
  // What crosses, crosses in every projection; most neighbours in a flat part are told apart so, without exact zeros.
  if (separated_in_projection(a, b, c, d)) return false;
  if (orientation(a, b, c, d) != 0 || (collinear(a, b, c) && collinear(a, b, d))) return false;
  return cross_in_plane(common_projection(a, b, c, d), a, b, c, d);
}

std::array<mpq_class, 3> crossing_point(const Point& a, const Point& b, const Point& c, const Point& d) {
  const int axis = common_projection(a, b, c, d).axis;
  const int i = (axis + 1) % 3, j = (axis + 2) % 3;
  const auto across = [&](const Point& from, const Point& to) -> mpq_class {
    return (rational_coordinate(to, i) - rational_coordinate(from, i)) * (rational_coordinate(d, j) - rational_coordinate(c, j)) -
           (rational_coordinate(to, j) - rational_coordinate(from, j)) * (rational_coordinate(d, i) - rational_coordinate(c, i));
  };
  const mpq_class parameter = across(a, c) / across(a, b);
  std::array<mpq_class, 3> point;
  for (int k = 0; k < 3; ++k) point[k] = rational_coordinate(a, k) + parameter * (rational_coordinate(b, k) - rational_coordinate(a, k));
  return point;
}

bool segment_pierces(const Point& a, const Point& b, const Corners& triangle) {
  const auto& [p, q, r] = triangle;
  if (orientation(*p, *q, *r, a) * orientation(*p, *q, *r, b) >= 0) return false;
  const std::array<int, 3> turns{orientation(a, b, *p, *q), orientation(a, b, *q, *r), orientation(a, b, *r, *p)};
  const auto [least, greatest] = std::minmax_element(turns.begin(), turns.end());
  return *least * *greatest >= 0;
}

bool meet_in_common_corners(const Corners& first, const Corners& second) {
  std::array<double, 3> u{}, v{};
  for (int axis = 0; axis < 3; ++axis) {
    u[axis] = first[1]->approximate(axis) - first[0]->approximate(axis);
    v[axis] = first[2]->approximate(axis) - first[0]->approximate(axis);
  }
  const Projection projection = broadest_projection(u, v);
  // In the projection, an edge of one with the other strictly beyond it, but for corners that are ends of the edge.
  const auto separates = [&](const Corners& a, const Corners& b) {
    const int inner = planar_orientation(projection, *a[0], *a[1], *a[2]);
    for (int i = 0; inner != 0 && i < 3; ++i) {
      const Point *from = a[i], *to = a[(i + 1) % 3];
      if (std::all_of(b.begin(), b.end(), [&](const Point* corner) {
            return corner == from || corner == to || planar_orientation(projection, *from, *to, *corner) * inner < 0;
          }))
        return true;
    }
    return false;
  };
  return separates(first, second) || separates(second, first);
}

Meeting meeting_of(const Corners& first, const Corners& second) {
  // Guigue and Devillers, "Fast and robust triangle-triangle overlap test using orientation predicates" (2003), with
  // strict comparisons: the two triangles cut intervals from the planes' common line; they meet in more than a point
  // iff the open intervals meet.
  const std::array<int, 3> first_sides = sides(second, first);
  Corners t = first, s = second;
  if (first_sides == std::array<int, 3>{0, 0, 0})
    return interiors_meet_in_plane(first, second) ? Meeting::area : Meeting::none;
  const int t_side = isolate_corner(t, first_sides);
  if (t_side == 0) return Meeting::none;
  const int s_side = isolate_corner(s, sides(first, second));
  if (s_side == 0) return Meeting::none;
  // Both isolated corners on the positive side of the other's plane: swapping two corners of a triangle turns its plane
  // around.
  if (t_side < 0) std::swap(s[1], s[2]);
  if (s_side < 0) std::swap(t[1], t[2]);
  return orientation_of(t[0], t[1], s[0], s[1]) < 0 && orientation_of(t[0], t[2], s[2], s[0]) < 0 ? Meeting::line
                                                                                                  : Meeting::none;
}

}  // namespace confidel::building
