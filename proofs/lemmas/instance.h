// SPDX-License-Identifier: GPL-3.0-or-later
// What lemmas are statements about: a complex and the points, cells and rows of a placement, exact and in the input's coordinates, with what
// docs/lemma-claims.md section 2 derives from them (kinds, fans, boxes, outlines). Written from that page; the checker has code of its own.
#pragma once

#include <gmpxx.h>

#include <array>
#include <optional>
#include <unordered_map>
#include <vector>

#include "core/complex/complex.h"
#include "core/placement/placement.h"

namespace confidel {

using RationalVector = std::array<mpq_class, 3>;

/// A cell T: vertex v, projection m, offset point a. Counter-clockwise it is v m a (then it opens its fan) or v a m (it closes one).
struct EndCell {
  int cell, v, m, a;
  bool opens;
};

/// A cell S: v p q counter-clockwise.
struct SpokeCell {
  int cell, v, p, q;
};

/// A rectangle: corners counter-clockwise, the first two carried by the segment (or an end of it).
struct BoxCells {
  std::array<int, 2> cells;
  std::array<int, 4> corners;
};

/// An edge of an outline: a to b in the C cell, whose third corner is x; the other cell's third corner is y.
struct OutlineEdge {
  int cell, a, b, x, other_cell, y;
};

class Instance {
 public:
  /// The lines of records in a certificate; empty where there is none.
  struct Lines {
    std::vector<int> points, cells, segments, facets, rows, hanging, balls, row_sizes, insertions;
    int radius = 0, angle = 0, offset = 0, chord = 0;
  };

  int dimension = 3;
  int vertex_count = 0;
  std::vector<RationalVector> positions;  ///< empty in an instance that only counts, but for the vertices'
  std::vector<PointKind> kinds;
  std::vector<int> carriers;
  std::vector<Segment> segments;
  std::vector<Facet> facets;  ///< frame, boundary, constraints and isolated only
  std::vector<PlacedCell> cells;
  std::vector<PlacedRow> rows;
  std::vector<std::array<int, 3>> hanging;
  Parameters parameters;
  std::vector<Insertion> insertions;
  Lines lines;
  bool whole = true;  ///< false in a refutation, whose cells do not cover facets: fans may be open

  /// What follows is derived by this; to be called once, when the above is complete.
  void derive();

  /// The first cell that is not of its kind (rule `kinds`), or an opening cell whose fan is not closed; -1: none. Statements about T, S, R
  /// and C cells have no meaning then.
  int wrong_kind = -1;
  std::vector<EndCell> end_cells;
  std::vector<SpokeCell> spoke_cells;
  std::vector<BoxCells> boxes;
  std::vector<OutlineEdge> outline;

  SegmentId find_segment(VertexId a, VertexId b) const;
  bool on_boundary_or_constraint(FacetId facet, SegmentId segment) const;
  bool has_vertex(FacetId facet, VertexId vertex) const;
  /// By vertex: segments, and facets in which it occurs; increasing.
  const std::vector<SegmentId>& segments_at(VertexId vertex) const { return segments_at_[vertex]; }
  const std::vector<FacetId>& facets_at(VertexId vertex) const { return facets_at_[vertex]; }
  VertexId other_end(SegmentId segment, VertexId vertex) const { return segments[segment][0] == vertex ? segments[segment][1] : segments[segment][0]; }
  /// The cell of the facet that has the directed edge, or -1.
  int cell_with_edge(FacetId facet, int from, int to) const;
  /// By vertex: the cells that have it as a corner.
  const std::vector<int>& cells_at(VertexId vertex) const { return cells_at_[vertex]; }
  /// Index into boxes of an R cell, or -1.
  int box_of(int cell) const;
  /// Index into end_cells of the closing cell of an opening one's fan.
  int closing_cell(const EndCell& opening) const;

  bool on_segment_kind(int point) const { return kinds[point] == PointKind::projection || kinds[point] == PointKind::edge; }
  bool protects(int point) const { return kinds[point] == PointKind::arc || kinds[point] == PointKind::offset; }
  /// Is the point an end of the segment, or carried by it?
  bool lies_on(int point, SegmentId segment) const;
  /// The facet's normal as the format defines it, with its length.
  const RationalVector& normal(FacetId facet) const { return normals_[facet]; }
  bool coplanar(FacetId f, FacetId g) const;
  bool in_plane(int point, FacetId facet) const;

 private:
  bool classify(int cell);
  int pair_boxes();
  std::uint64_t edge_key(int from, int to) const;

  std::vector<RationalVector> normals_;
  std::vector<std::vector<SegmentId>> segments_at_, segments_of_facet_;
  std::vector<std::vector<FacetId>> facets_at_;
  std::vector<std::vector<int>> cells_at_;
  std::vector<std::unordered_map<std::uint64_t, int>> edges_;  // by facet
  std::unordered_map<int, int> end_of_cell_, spoke_of_cell_, box_of_cell_;
};

/// with_points = false: enough to count objects, without the positions of the Steiner points.
Instance instance_of(const Complex& complex, const Placement& placement, bool with_points);

}  // namespace confidel
