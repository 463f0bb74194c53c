// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/features/features.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <limits>

#include "core/features/incidence.h"
#include "core/features/link_angles.h"

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
        vertices_(volumes(complex.vertices.size(), [](std::size_t i) { return std::array{static_cast<VertexId>(i)}; })),
        segments_(volumes(complex.segments.size(), [&](std::size_t i) { return complex.segments[i]; })),
        triangles_(
            volumes(incidence_.triangles.size(), [&](std::size_t i) { return incidence_.triangles[i].vertices; })) {}

  double vertex_distance(VertexId vertex) const {
    const std::array self{&corners_[vertex]};
    const Probe probe(self[0]->box);
    const auto touches = [vertex](const Labels& vertices) { return contains(vertices, vertex); };
    Vector direction{};
    double nearest = vertices_.search(probe, infinity, touches, [&](VertexId other, double limit) {
      return nearer(self, std::array{other}, limit, direction);
    });
    nearest = segments_.search(probe, nearest, touches, [&](SegmentId segment, double limit) {
      return nearer(self, complex_.segments[segment], limit, direction);
    });
    return triangles_.search(probe, nearest, touches, [&](int triangle, double limit) {
      const Triangle& other = incidence_.triangles[triangle];
      if (incidence_.facet_has_vertex(other.facet, vertex)) return limit;
      return nearer(self, other.vertices, limit, direction);
    });
  }

  /// To the nearest segment that is disjoint from it, if nearer than the limit.
  double distance_to_segments(SegmentId segment, double limit) const {
    const auto [a, b] = complex_.segments[segment];
    const std::array self{&corners_[a], &corners_[b]};
    Box box = self[0]->box;
    box.extend(self[1]->box);
    Vector direction{};
    return segments_.search(
        Probe(box, self[0]->position, self[1]->position), limit,
        [a = a, b = b](const Labels& vertices) { return contains(vertices, a) || contains(vertices, b); },
        [&](SegmentId other, double nearest) { return nearer(self, complex_.segments[other], nearest, direction); });
  }

  double segment_distance(SegmentId segment) const {
    const auto [a, b] = complex_.segments[segment];
    const std::array self{&corners_[a], &corners_[b]};
    const auto touches = [a = a, b = b](const Labels& vertices) {
      return contains(vertices, a) || contains(vertices, b);
    };
    Box box = self[0]->box;
    box.extend(self[1]->box);
    const Probe probe(box, self[0]->position, self[1]->position);
    Vector direction{};
    // A few neighbours give a first limit.
    double nearest = infinity;
    for (const VertexId end : {a, b}) {
      const auto segments = incidence_.segments_at[end];
      for (const SegmentId index : segments.first(std::min<std::size_t>(segments.size(), 8))) {
        const Segment& other = complex_.segments[index];
        if (index == segment) continue;
        nearest = nearer(self, std::array{other[0] == end ? other[1] : other[0]}, nearest, direction);
      }
    }
    nearest = vertices_.search(probe, nearest, touches, [&](VertexId other, double limit) {
      return nearer(self, std::array{other}, limit, direction);
    });
    nearest = segments_.search(probe, nearest, touches, [&](SegmentId other, double limit) {
      return nearer(self, complex_.segments[other], limit, direction);
    });
    // In the plane there is nothing but e's own facet.
    if (incidence_.facets_of[segment].size() == complex_.facets.size()) return nearest;
    return triangles_.search(probe, nearest, touches, [&](int triangle, double limit) {
      const Triangle& other = incidence_.triangles[triangle];
      if (incidence_.facet_has_segment(other.facet, segment)) return limit;
      return nearer(self, other.vertices, limit, direction);
    });
  }

  const Incidence& incidence() const { return incidence_; }
  const std::vector<Corner>& corners() const { return corners_; }

 private:
  static bool contains(const Labels& vertices, VertexId vertex) {
    return vertices[0] == vertex || vertices[1] == vertex || vertices[2] == vertex;
  }

  /// Simplices, labelled with their vertices.
  template <class Vertices>
  BoundingVolumes volumes(std::size_t count, Vertices vertices) const {
    std::vector<Box> boxes(count);
    std::vector<Labels> labels(count, {-1, -1, -1});
    for (std::size_t i = 0; i < count; ++i) {
      const auto simplex = vertices(i);
      std::copy(simplex.begin(), simplex.end(), labels[i].begin());
      for (const VertexId vertex : simplex) boxes[i].extend(corners_[vertex].box);
    }
    return BoundingVolumes(boxes, labels);
  }

  template <std::size_t M, std::size_t N>
  double nearer(const std::array<const Corner*, M>& self, const std::array<VertexId, N>& other, double limit,
                Vector& direction) const {
    std::array<const Corner*, N> simplex;
    for (std::size_t i = 0; i < N; ++i) simplex[i] = &corners_[other[i]];
    return std::min(limit, distance_below(self, simplex, limit, direction));
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
  // Lists are written for one segment, or for one end of it, by one task.
  tbb::parallel_for(0, vertices, [&](int vertex) {
    features.vertex_distance[vertex] = computation.vertex_distance(vertex);
    const LinkAngles angles(complex, computation.incidence(), computation.corners(), vertex);
    for (const SegmentId segment : computation.incidence().segments_at[vertex]) {
      const int side = complex.segments[segment][0] == vertex ? 0 : 1;
      features.segment_angle[segment][side] = angles.to_segments(segment);
      features.facet_angle[segment][side] = angles.to_facets(segment);
    }
  });
  tbb::parallel_for(0, segments, [&](int segment) {
    features.segment_distance[segment] = computation.segment_distance(segment);
    features.dihedral_angle[segment] =
        smallest_dihedral_angle(complex, computation.incidence(), computation.corners(), segment);
  });
  // A segment and a facet that are disjoint are nearest at an end of the segment or on the facet's boundary.
  features.separation = infinity;
  for (const double distance : features.vertex_distance) features.separation = std::min(features.separation, distance);
  for (int segment = 0; segment < segments; ++segment)
    features.separation = computation.distance_to_segments(segment, features.separation);
  return features;
}

}  // namespace confidel
