// SPDX-License-Identifier: GPL-3.0-or-later
// CGAL traits for Delaunay tetrahedralizations of exact points. Model of DelaunayTriangulationTraits_3 as far as it is used.
#pragma once

#include <CGAL/enum.h>

#include "core/numbers/predicates.h"

namespace confidel {

/// A reference to a point that is owned elsewhere.
struct SpacePoint {
  const Point* point = nullptr;
  bool operator==(const SpacePoint& other) const { return point == other.point || *point == *other.point; }
  bool operator!=(const SpacePoint& other) const { return !(*this == other); }
};

class SpaceTraits {
 public:
  using Point_3 = SpacePoint;
  struct Segment_3 {
    Point_3 a, b;
  };
  struct Triangle_3 {
    Point_3 a, b, c;
  };
  struct Tetrahedron_3 {
    Point_3 a, b, c, d;
  };
  struct Line_3 {};
  struct Ray_3 {};
  struct Plane_3 {};
  struct Object_3 {};

  struct Compare_xyz_3 {
    CGAL::Comparison_result operator()(const Point_3& a, const Point_3& b) const {
      return CGAL::Comparison_result(Point::compare(*a.point, *b.point));
    }
  };
  struct Equal_3 {
    bool operator()(const Point_3& a, const Point_3& b) const { return a == b; }
  };
  struct Orientation_3 {
    CGAL::Orientation operator()(const Point_3& a, const Point_3& b, const Point_3& c, const Point_3& d) const {
      return CGAL::Orientation(orientation(*a.point, *b.point, *c.point, *d.point));
    }
  };
  /// For points of one plane: an orientation that is consistent within it.
  struct Coplanar_orientation_3 {
    CGAL::Orientation operator()(const Point_3& a, const Point_3& b, const Point_3& c) const {
      for (int axis : {2, 0, 1})
        if (const int sign = planar_orientation({axis, 1}, *a.point, *b.point, *c.point); sign != 0) return CGAL::Orientation(sign);
      return CGAL::COLLINEAR;
    }
    /// Is d on the same side of the line ab as c?
    CGAL::Orientation operator()(const Point_3& a, const Point_3& b, const Point_3& c, const Point_3& d) const {
      return CGAL::Orientation(int((*this)(a, b, c)) * int((*this)(a, b, d)));
    }
  };
  struct Side_of_oriented_sphere_3 {
    CGAL::Oriented_side operator()(const Point_3& a, const Point_3& b, const Point_3& c, const Point_3& d, const Point_3& e) const {
      return CGAL::Oriented_side(in_sphere(*a.point, *b.point, *c.point, *d.point, *e.point));
    }
  };
  struct Coplanar_side_of_bounded_circle_3 {
    CGAL::Bounded_side operator()(const Point_3& a, const Point_3& b, const Point_3& c, const Point_3& d) const {
      return CGAL::Bounded_side(-diametral_power(*a.point, *b.point, *c.point, *d.point));
    }
  };
  struct Compare_distance_3 {
    CGAL::Comparison_result operator()(const Point_3& p, const Point_3& a, const Point_3& b) const {
      return CGAL::Comparison_result(compare_distance(*p.point, *a.point, *b.point));
    }
  };
  struct Construct_point_3 {
    const Point_3& operator()(const Point_3& p) const { return p; }
  };
  struct Construct_segment_3 {
    Segment_3 operator()(const Point_3& a, const Point_3& b) const { return {a, b}; }
  };
  struct Construct_triangle_3 {
    Triangle_3 operator()(const Point_3& a, const Point_3& b, const Point_3& c) const { return {a, b, c}; }
  };
  struct Construct_tetrahedron_3 {
    Tetrahedron_3 operator()(const Point_3& a, const Point_3& b, const Point_3& c, const Point_3& d) const { return {a, b, c, d}; }
  };

  Compare_xyz_3 compare_xyz_3_object() const { return {}; }
  Equal_3 equal_3_object() const { return {}; }
  Orientation_3 orientation_3_object() const { return {}; }
  Coplanar_orientation_3 coplanar_orientation_3_object() const { return {}; }
  Side_of_oriented_sphere_3 side_of_oriented_sphere_3_object() const { return {}; }
  Coplanar_side_of_bounded_circle_3 coplanar_side_of_bounded_circle_3_object() const { return {}; }
  Compare_distance_3 compare_distance_3_object() const { return {}; }
  Construct_point_3 construct_point_3_object() const { return {}; }
  Construct_segment_3 construct_segment_3_object() const { return {}; }
  Construct_triangle_3 construct_triangle_3_object() const { return {}; }
  Construct_tetrahedron_3 construct_tetrahedron_3_object() const { return {}; }
};

}  // namespace confidel
