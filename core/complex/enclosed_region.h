// SPDX-License-Identifier: GPL-3.0-or-later
// The region that the edges of one plane bound, and its exact triangulation: what a facet is.
#pragma once

#include <array>
#include <vector>

#include "core/complex/complex.h"
#include "core/numbers/predicates.h"

namespace confidel::building {

struct RegionInput {
  /// Working coordinates, and the input's doubles: the same points.
  const std::vector<Point>& vertices;
  const std::vector<std::array<double, 3>>& positions;
  /// The plane's normal; its positive side orients the result.
  IntegerVector normal;
  /// Edges that bound: sorted, a < b, atomic (no vertex strictly between the ends), pairwise not crossing.
  const std::vector<Segment>& edges;
  /// Edges that lie in the plane but bound nothing here: the same requirements. Vertices in the plane: sorted.
  const std::vector<Segment>& guest_edges;
  const std::vector<VertexId>& points;
  const std::vector<VertexId>& guest_points;
  /// Working coordinates and doubles of the seeds: what can be reached from their orthogonal projections is no part of
  /// the region.
  const std::vector<Point>& seeds;
  const std::vector<std::array<double, 3>>& seed_positions;
  /// Dimension 2: edges that enclose nothing but holes are given the convex hull of everything as boundary.
  bool hull_if_open = false;
};

struct Region {
  std::vector<std::array<VertexId, 2>> boundary;  ///< directed, the region on the left; increasing
  std::vector<std::array<VertexId, 2>>
      constraints;                 ///< edges and guest edges with the region on both sides; increasing
  std::vector<VertexId> isolated;  ///< points and guest points of the region on no edge of it; increasing
  std::vector<std::array<VertexId, 3>> triangles;  ///< positively oriented
  std::vector<Segment> outside_edges;              ///< bounding edges with the region on neither side; increasing
  std::vector<VertexId> outside_points;            ///< points outside of the region; increasing
  std::vector<Segment> hull_edges;                 ///< edges that were added because of hull_if_open
  bool encloses = false;                           ///< the edges enclose something, before the seeds take effect
  enum class Seed { inside, outside, on_edge };
  std::vector<Seed> seeds;  ///< where each seed lies: inside of what the edges enclose, outside of it, or exactly on an
                            ///< edge or vertex
};

/// As TetGen resolves a facet: the constrained Delaunay triangulation of everything, minus what is reached from outside
/// of the convex hull or from a seed without crossing a bounding edge. No points are added.
Region enclosed_region(const RegionInput& input);

}  // namespace confidel::building
