// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/features/link_angles.h"

#include <algorithm>
#include <cmath>

#include "core/features/vector.h"

namespace confidel {

namespace {

constexpr std::size_t many = 24;
/// What rounding can do to a unit vector computed from exact corners, or to a chord, with room to spare.
constexpr double unit_error = 1e-14;

/// Unit vector from v to another corner; its error is below unit_error. Nothing if rounding or underflow could make it
/// worse.
std::optional<Vector> unit_direction(const Corner& v, const Corner& other) {
  if (!v.exact || !other.exact) return std::nullopt;
  const Vector vector = other.position - v.position;
  const double length = std::sqrt(dot(vector, vector));
  if (!(length > 1e-140)) return std::nullopt;
  return 1 / length * vector;
}

Box around(const Vector& point, double margin) {
  Box box;
  for (int k = 0; k < 3; ++k) {
    box.lower[k] = point[k] - margin;
    box.upper[k] = point[k] + margin;
  }
  return box;
}

const Box whole_sphere = around({0, 0, 0}, 2);

Box direction_box(const Corner& v, const Corner& other) {
  const auto unit = unit_direction(v, other);
  return unit ? around(*unit, unit_error) : whole_sphere;
}

/// The arc of directions between two.
Box arc_box(const Corner& v, const Corner& a, const Corner& b) {
  const auto x = unit_direction(v, a);
  const auto y = unit_direction(v, b);
  if (!x || !y) return whole_sphere;
  // The arc is nowhere farther from its chord than in the middle.
  const Vector middle = 0.5 * (*x + *y);
  const double margin = 1 - std::sqrt(dot(middle, middle)) + 2 * unit_error;
  Box box = around(*x, margin);
  box.extend(around(*y, margin));
  return box;
}

/// The two other corners of a triangle.
std::array<VertexId, 2> others(const std::array<VertexId, 3>& triangle, VertexId vertex) {
  if (triangle[0] == vertex) return {triangle[1], triangle[2]};
  return {triangle[0], triangle[1] == vertex ? triangle[2] : triangle[1]};
}

/// A length that the chord of the angle on the unit sphere does not exceed.
double chord_above(double angle) { return 2 * std::sin(0.5 * angle) + unit_error; }

/// improve(item, angle) returns the smaller of the angle and that to the item.
template <class Improve>
double search(const BoundingVolumes& volumes, const Box& direction, Improve improve) {
  double smallest = straight_angle;
  const auto excluded = [](const Labels&) { return false; };
  volumes.search(Probe(direction), chord_above(smallest), excluded, [&](int item, double chord) {
    const double angle = improve(item, smallest);
    if (!(angle < smallest)) return chord;
    smallest = angle;
    return std::min(chord, chord_above(smallest));
  });
  return smallest;
}

}  // namespace

LinkAngles::LinkAngles(const Complex& complex, const Incidence& incidence, const std::vector<Corner>& corners,
                       VertexId vertex)
    : complex_(complex), incidence_(incidence), corners_(corners), vertex_(vertex) {
  const auto segments = incidence_.segments_at[vertex_];
  const auto triangles = incidence_.triangles_at[vertex_];
  std::vector<Box> boxes;
  if (segments.size() > many) {
    for (const SegmentId segment : segments)
      boxes.push_back(direction_box(corners_[vertex_], corners_[other_end(segment)]));
    directions_.emplace(boxes);
  }
  if (segments.size() * triangles.size() > many * many) {
    boxes.clear();
    for (const int triangle : triangles) {
      const auto [a, b] = others(incidence_.triangles[triangle].vertices, vertex_);
      boxes.push_back(arc_box(corners_[vertex_], corners_[a], corners_[b]));
    }
    arcs_.emplace(boxes);
  }
}

VertexId LinkAngles::other_end(SegmentId segment) const {
  const Segment& ends = complex_.segments[segment];
  return ends[0] == vertex_ ? ends[1] : ends[0];
}

double LinkAngles::to_segments(SegmentId segment) const {
  const auto segments = incidence_.segments_at[vertex_];
  const Corner& v = corners_[vertex_];
  const Corner& end = corners_[other_end(segment)];
  const auto improve = [&](int index, double smallest) {
    if (segments[index] == segment) return smallest;
    return std::min(smallest, angle_below(v, end, corners_[other_end(segments[index])], smallest));
  };
  if (directions_) return search(*directions_, direction_box(v, end), improve);
  double smallest = straight_angle;
  for (std::size_t index = 0; index < segments.size(); ++index) smallest = improve(static_cast<int>(index), smallest);
  return smallest;
}

double LinkAngles::to_facets(SegmentId segment) const {
  const auto triangles = incidence_.triangles_at[vertex_];
  const Corner& v = corners_[vertex_];
  const Corner& end = corners_[other_end(segment)];
  const auto improve = [&](int index, double smallest) {
    const Triangle& triangle = incidence_.triangles[triangles[index]];
    if (incidence_.facet_has_segment(triangle.facet, segment)) return smallest;
    const auto [a, b] = others(triangle.vertices, vertex_);
    return std::min(smallest, sector_angle_below(v, end, corners_[a], corners_[b], smallest));
  };
  if (arcs_) return search(*arcs_, direction_box(v, end), improve);
  double smallest = straight_angle;
  for (std::size_t index = 0; index < triangles.size(); ++index) smallest = improve(static_cast<int>(index), smallest);
  return smallest;
}

namespace {

/// A sheet's direction around a segment, and how far off it may be.
struct Sheet {
  VertexId corner;
  double angle;
};

/// Sheets by increasing direction in (-pi, pi], each at most error off. error is infinite where doubles do not suffice.
std::vector<Sheet> sort_around(const Corner& a, const Corner& b, std::span<const VertexId> sheets,
                               const std::vector<Corner>& corners, double& error) {
  std::vector<Sheet> sorted;
  const Vector along = b.position - a.position;
  // A frame across the segment; orthonormal up to a few u, because along is far from the axis of its smallest
  // component.
  Vector axis{};
  int smallest = 0;
  for (int k = 1; k < 3; ++k) {
    if (std::abs(along[k]) < std::abs(along[smallest])) smallest = k;
  }
  axis[smallest] = 1;
  const auto normalised = [](const Vector& vector) { return 1 / std::sqrt(dot(vector, vector)) * vector; };
  const Vector first = normalised(cross(along, axis));
  const Vector second = normalised(cross(along, first));
  const double length = std::sqrt(dot(along, along));
  error = a.exact && b.exact && length > 1e-70 ? 0 : std::numeric_limits<double>::infinity();
  for (const VertexId corner : sheets) {
    const Vector to = corners[corner].position - a.position;
    const Vector normal = cross(along, to);
    const double length_normal = std::sqrt(dot(normal, normal));
    // The error of the normal as in angles.cpp, and that of the frame and of atan2.
    const double sheet_error = 0x1p-50 * length * std::sqrt(dot(to, to)) / length_normal + unit_error;
    const bool usable = corners[corner].exact && length_normal > 1e-70;
    error = usable ? std::max(error, sheet_error) : std::numeric_limits<double>::infinity();
    if (!usable) return sorted;
    sorted.push_back({corner, std::atan2(dot(normal, second), dot(normal, first))});
  }
  std::sort(sorted.begin(), sorted.end(), [](const Sheet& x, const Sheet& y) {
    return x.angle != y.angle ? x.angle < y.angle : x.corner < y.corner;
  });
  return sorted;
}

}  // namespace

double smallest_dihedral_angle(const Complex& complex, const Incidence& incidence, const std::vector<Corner>& corners,
                               SegmentId segment) {
  const Corner& a = corners[complex.segments[segment][0]];
  const Corner& b = corners[complex.segments[segment][1]];
  const auto sheets = incidence.sheets_of[segment];
  double smallest = straight_angle;
  const auto improve = [&](VertexId x, VertexId y) {
    smallest = std::min(smallest, dihedral_angle_below(a, b, corners[x], corners[y], smallest));
  };
  if (sheets.size() > many) {
    double error = 0;
    const auto sorted = sort_around(a, b, sheets, corners, error);
    if (error < 1e-3) {
      // The sheet that is nearest to another is behind or before it in the true order. In the order of approximate
      // angles, a sheet's partner comes within the smallest angle so far, plus both errors.
      const std::size_t n = sorted.size();
      for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t step = 1; step < n; ++step) {
          const std::size_t j = (i + step) % n;
          const double turn = sorted[j].angle - sorted[i].angle + (j < i ? 2 * straight_angle : 0);
          if (turn > smallest + 2 * error + unit_error) break;
          improve(sorted[i].corner, sorted[j].corner);
        }
      }
      return smallest;
    }
  }
  for (std::size_t i = 0; i < sheets.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) improve(sheets[j], sheets[i]);
  }
  return smallest;
}

}  // namespace confidel
