// SPDX-License-Identifier: GPL-3.0-or-later
// Angles at a vertex and around a segment. Few neighbours are compared one by one; many (hubs of cones, backs of books)
// through an index of directions, so that no degree makes the whole quadratic.
#pragma once

#include <optional>

#include "core/features/angles.h"
#include "core/features/incidence.h"

namespace confidel {

class LinkAngles {
 public:
  LinkAngles(const Complex& complex, const Incidence& incidence, const std::vector<Corner>& corners, VertexId vertex);

  /// theta and omega of features.h for a segment at the vertex.
  double to_segments(SegmentId segment) const;
  double to_facets(SegmentId segment) const;

 private:
  VertexId other_end(SegmentId segment) const;

  const Complex& complex_;
  const Incidence& incidence_;
  const std::vector<Corner>& corners_;
  VertexId vertex_;
  /// Over unit directions and over the triangles' arcs of them; only at vertices with many.
  std::optional<BoundingVolumes> directions_;
  std::optional<BoundingVolumes> arcs_;
};

/// alpha of features.h.
double smallest_dihedral_angle(const Complex& complex, const Incidence& incidence, const std::vector<Corner>& corners,
                               SegmentId segment);

}  // namespace confidel
