// SPDX-License-Identifier: GPL-3.0-or-later
// The piecewise-linear complex (PLC), or planar straight-line graph (PSLG), in its canonical form:
// docs/certificate-format.md section 2 gives the meaning of every field.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "core/numbers/point.h"

namespace confidel {

using VertexId = int;
using SegmentId = int;
using FacetId = int;

/// A segment's end vertices, a < b.
using Segment = std::array<VertexId, 2>;

struct Facet {
  /// Three vertices, not collinear: the plane; counter-clockwise seen from the positive side.
  std::array<VertexId, 3> frame{};
  /// Directed boundary edges, the region on their left; increasing.
  std::vector<std::array<VertexId, 2>> boundary;
  /// Inner constraints (a < c): slits, dangling or free segments inside the region; increasing.
  std::vector<std::array<VertexId, 2>> constraints;
  /// Isolated vertices inside the region, increasing.
  std::vector<VertexId> isolated;
  /// A triangulation of the region: the facet's part of the simplicial complex K (theory.md section 3).
  /// Vertices are exactly those of the facet, all constraints are edges of it, every triangle is positively oriented.
  std::vector<std::array<VertexId, 3>> triangles;
  /// Primitive normal on the positive side.
  IntegerVector normal;
  /// The input's marker (0 if it has none) and the line of the input where the facet begins (0 if made).
  int marker = 0;
  int line = 0;
};

struct Complex {
  int dimension = 3;
  /// Positions in working coordinates: the input's times 2^-scale, so that all coordinates have magnitude <= 1.
  /// Planar inputs have z = 0.
  std::vector<Point> vertices;
  int scale = 0;
  /// Sorted; no vertex lies in the interior of a segment.
  std::vector<Segment> segments;
  /// Marker per segment (0 if the input has none).
  std::vector<int> segment_markers;
  std::vector<Facet> facets;

  /// Index of the segment {a, b}, or -1. Logarithmic.
  SegmentId find_segment(VertexId a, VertexId b) const;
  /// The input's coordinates of a vertex: exact.
  Point input_position(VertexId vertex) const { return vertices[vertex].scaled(scale); }
};

/// The canonical text of docs/certificate-format.md section 2, from `plc 1` to the LF after `end`.
std::string canonical_text(const Complex& complex);

/// Canonical spelling of a point in the input's coordinates: "X Y Z W", or "X Y W" in dimension 2.
std::string canonical_point(const Point& input_position, int dimension);

/// SHA-256 in lower-case hexadecimal digits.
std::string sha256(const std::string& bytes);

}  // namespace confidel
