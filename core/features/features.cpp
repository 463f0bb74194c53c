// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/features/features.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <limits>

#include "core/features/angles.h"
#include "core/features/incidence.h"

namespace confidel {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Every vertex and segment is computed from read-only data alone, one after the other: threads change nothing.
class Computation {
 public:
  explicit Computation(const Complex& complex)
      : complex_(complex),
        incidence_(complex),
        corners_(complex.vertices.begin(), complex.vertices.end()),
        vertices_(boxes(complex.vertices.size(), [](std::size_t i) { return std::array{static_cast<VertexId>(i)}; })),
        segments_(boxes(complex.segments.size(), [&](std::size_t i) { return complex.segments[i]; })),
        triangles_(
            boxes(incidence_.triangles.size(), [&](std::size_t i) { return incidence_.triangles[i].vertices; })) {}

  double vertex_distance(VertexId vertex) const {
    const std::array self{&corners_[vertex]};
    const Probe probe{self[0]->box, false, {}};
    double nearest = vertices_.search(probe, infinity, [&](VertexId other, double limit) {
      return other == vertex ? limit : nearer(self, std::array{other}, limit);
    });
    nearest = segments_.search(probe, nearest, [&](SegmentId segment, double limit) {
      const Segment& ends = complex_.segments[segment];
      return ends[0] == vertex || ends[1] == vertex ? limit : nearer(self, ends, limit);
    });
    return triangles_.search(probe, nearest, [&](int triangle, double limit) {
      const Triangle& other = incidence_.triangles[triangle];
      return incidence_.facet_has_vertex(other.facet, vertex) ? limit : nearer(self, other.vertices, limit);
    });
  }

  double segment_distance(SegmentId segment) const {
    const auto [a, b] = complex_.segments[segment];
    const std::array self{&corners_[a], &corners_[b]};
    const auto touches = [a = a, b = b](const auto& vertices) {
      return std::any_of(vertices.begin(), vertices.end(), [&](VertexId vertex) { return vertex == a || vertex == b; });
    };
    Probe probe{self[0]->box, true, {self[0]->position, self[1]->position}};
    probe.box.extend(self[1]->box);
    double nearest = vertices_.search(probe, infinity, [&](VertexId vertex, double limit) {
      const std::array other{vertex};
      return touches(other) ? limit : nearer(self, other, limit);
    });
    nearest = segments_.search(probe, nearest, [&](SegmentId index, double limit) {
      const Segment& other = complex_.segments[index];
      return touches(other) ? limit : nearer(self, other, limit);
    });
    // In the plane there is nothing but e's own facet.
    if (incidence_.facets_of[segment].size() == complex_.facets.size()) return nearest;
    return triangles_.search(probe, nearest, [&](int triangle, double limit) {
      const Triangle& other = incidence_.triangles[triangle];
      if (touches(other.vertices) || incidence_.facet_has_segment(other.facet, segment)) return limit;
      return nearer(self, other.vertices, limit);
    });
  }

  double segment_angle(SegmentId segment, int side) const {
    const VertexId vertex = complex_.segments[segment][side];
    const VertexId end = complex_.segments[segment][1 - side];
    double smallest = straight_angle;
    for (const SegmentId index : incidence_.segments_at[vertex]) {
      if (index == segment) continue;
      const Segment& other = complex_.segments[index];
      const VertexId other_end = other[0] == vertex ? other[1] : other[0];
      smallest = std::min(smallest, angle_below(corners_[vertex], corners_[end], corners_[other_end], smallest));
    }
    return smallest;
  }

  double facet_angle(SegmentId segment, int side) const {
    const VertexId vertex = complex_.segments[segment][side];
    const VertexId end = complex_.segments[segment][1 - side];
    double smallest = straight_angle;
    for (const int index : incidence_.triangles_at[vertex]) {
      const Triangle& triangle = incidence_.triangles[index];
      if (incidence_.facet_has_segment(triangle.facet, segment)) continue;
      const auto& corners = triangle.vertices;
      const auto position = std::find(corners.begin(), corners.end(), vertex) - corners.begin();
      smallest =
          std::min(smallest, sector_angle_below(corners_[vertex], corners_[end], corners_[corners[(position + 1) % 3]],
                                                corners_[corners[(position + 2) % 3]], smallest));
    }
    return smallest;
  }

  double dihedral_angle(SegmentId segment) const {
    const auto [a, b] = complex_.segments[segment];
    const auto sheets = incidence_.sheets_of[segment];
    double smallest = straight_angle;
    for (std::size_t i = 0; i < sheets.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        smallest = std::min(smallest, dihedral_angle_below(corners_[a], corners_[b], corners_[sheets[j]],
                                                           corners_[sheets[i]], smallest));
      }
    }
    return smallest;
  }

 private:
  template <class Vertices>
  std::vector<Box> boxes(std::size_t count, Vertices vertices) const {
    std::vector<Box> result(count);
    for (std::size_t i = 0; i < count; ++i) {
      for (const VertexId vertex : vertices(i)) result[i].extend(corners_[vertex].box);
    }
    return result;
  }

  template <std::size_t M, std::size_t N>
  double nearer(const std::array<const Corner*, M>& self, const std::array<VertexId, N>& other, double limit) const {
    std::array<const Corner*, N> simplex;
    for (std::size_t i = 0; i < N; ++i) simplex[i] = &corners_[other[i]];
    return std::min(limit, distance_below(self, simplex, limit));
  }

  const Complex& complex_;
  Incidence incidence_;
  std::vector<Corner> corners_;
  BoundingVolumes vertices_;
  BoundingVolumes segments_;
  BoundingVolumes triangles_;
};

}  // namespace

Features compute_features(const Complex& complex) {
  const Computation computation(complex);
  const int vertices = static_cast<int>(complex.vertices.size());
  const int segments = static_cast<int>(complex.segments.size());
  Features features;
  features.vertex_distance.resize(vertices);
  features.segment_distance.resize(segments);
  features.segment_angle.resize(segments);
  features.facet_angle.resize(segments);
  features.dihedral_angle.resize(segments);
  tbb::parallel_for(0, vertices,
                    [&](int vertex) { features.vertex_distance[vertex] = computation.vertex_distance(vertex); });
  tbb::parallel_for(0, segments, [&](int segment) {
    features.segment_distance[segment] = computation.segment_distance(segment);
    for (int side = 0; side < 2; ++side) {
      features.segment_angle[segment][side] = computation.segment_angle(segment, side);
      features.facet_angle[segment][side] = computation.facet_angle(segment, side);
    }
    features.dihedral_angle[segment] = computation.dihedral_angle(segment);
  });
  return features;
}

}  // namespace confidel
