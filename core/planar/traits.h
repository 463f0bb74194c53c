// SPDX-License-Identifier: GPL-3.0-or-later
// CGAL traits for planar triangulations of exact points of one plane in space: orientation by projection along an axis,
// in-circle with the plane's own metric. Model of ConstrainedDelaunayTriangulationTraits_2 as far as it is used.
#pragma once

#include <CGAL/enum.h>

#include "core/numbers/predicates.h"

namespace confidel {

/// A reference to a point that is owned elsewhere.
struct PlanarPoint {
  const Point* point = nullptr;
  bool operator==(const PlanarPoint& other) const { return point == other.point || *point == *other.point; }
  bool operator!=(const PlanarPoint& other) const { return !(*this == other); }
};

class PlanarTraits {
 public:
  using Point_2 = PlanarPoint;
  struct Segment_2 {
    Point_2 a, b;
  };
  struct Triangle_2 {
    Point_2 a, b, c;
  };

  PlanarTraits() = default;
  explicit PlanarTraits(Projection projection) : projection_(projection) {}

  struct Orientation_2 {
    Projection projection;
    CGAL::Orientation operator()(const Point_2& a, const Point_2& b, const Point_2& c) const {
      return CGAL::Orientation(planar_orientation(projection, *a.point, *b.point, *c.point));
    }
  };
  struct Side_of_oriented_circle_2 {
    Projection projection;
    CGAL::Oriented_side operator()(const Point_2& a, const Point_2& b, const Point_2& c, const Point_2& d) const {
      return CGAL::Oriented_side(planar_in_circle(projection, *a.point, *b.point, *c.point, *d.point));
    }
  };
  /// Comparison along one axis of the projection, exact.
  template <int Which>
  struct Compare {
    Projection projection;
    CGAL::Comparison_result operator()(const Point_2& a, const Point_2& b) const {
      return CGAL::Comparison_result(planar_compare_axis(projection, Which, *a.point, *b.point));
    }
  };
  using Compare_x_2 = Compare<0>;
  using Compare_y_2 = Compare<1>;
  template <int Which>
  struct Less {
    Projection projection;
    bool operator()(const Point_2& a, const Point_2& b) const {
      return planar_compare_axis(projection, Which, *a.point, *b.point) < 0;
    }
  };
  using Less_x_2 = Less<0>;
  using Less_y_2 = Less<1>;
  struct Construct_segment_2 {
    Segment_2 operator()(const Point_2& a, const Point_2& b) const { return {a, b}; }
  };
  struct Construct_triangle_2 {
    Triangle_2 operator()(const Point_2& a, const Point_2& b, const Point_2& c) const { return {a, b, c}; }
  };

  struct Construct_point_2 {
    const Point_2& operator()(const Point_2& p) const { return p; }
  };

  Construct_point_2 construct_point_2_object() const { return {}; }
  Orientation_2 orientation_2_object() const { return {projection_}; }
  Side_of_oriented_circle_2 side_of_oriented_circle_2_object() const { return {projection_}; }
  Compare_x_2 compare_x_2_object() const { return {projection_}; }
  Compare_y_2 compare_y_2_object() const { return {projection_}; }
  Less_x_2 less_x_2_object() const { return {projection_}; }
  Less_y_2 less_y_2_object() const { return {projection_}; }
  Construct_segment_2 construct_segment_2_object() const { return {}; }
  Construct_triangle_2 construct_triangle_2_object() const { return {}; }

 private:
  Projection projection_;
};

}  // namespace confidel
