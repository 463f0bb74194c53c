// SPDX-License-Identifier: GPL-3.0-or-later
// Lazy protection: a ball around a vertex or a row along a segment, where refinement would not end without (theory.md section 4 gives
// the sizes; the construction is the graded strategy's, but only where it is needed, and without constraints of its own).
#pragma once

#include <optional>
#include <vector>

#include "core/placement/lean_state.h"

namespace confidel {

class LeanProtection {
 public:
  using Triangle = LeanState::Triangle;

  explicit LeanProtection(LeanState& state);

  bool active_vertex(VertexId v) const { return active_vertex_[v] != 0; }
  bool active_segment(SegmentId s) const { return active_segment_[s] != 0; }
  long vertices() const { return vertices_; }
  long segments() const { return segments_; }

  /// Free points in the ball go; every segment at v gets its point m, every sector of a facet its arc of at most 60 degrees.
  /// Pre: not active, the input is not flat.
  void activate_vertex(VertexId v);
  /// Protects both ends, then: the segment's free points and those of its facets close to it go; a row begins with one interval.
  /// Pre: not active.
  void activate_segment(SegmentId s);

  /// The piece of a segment that is part of a ball or a row: splits the row, or an arc next to the piece (in the facet, if one is given).
  /// Returns whether it was such a piece.
  bool split_piece(int a, int b, FacetId facet = -1);
  /// A triangle of a facet all of whose corners are in one ball, or in one row: splits the longest arc, or the row, that it spans.
  bool split_under(FacetId facet, const Triangle& triangle);
  /// A point of a facet inside a ball or row, or in the diametral disk of a chord of one: splits that and returns {-1, -1}; between a
  /// segment and the first point of an arc it returns the piece of the segment next to the ball, which is to be split instead.
  std::optional<std::array<int, 2>> split_at(FacetId facet, const Point& position);

 private:
  struct ArcPoint {
    double angle;
    int point;
  };
  /// A facet's sector at a vertex, between two of its edges, or all around an isolated vertex (then the first point closes it again).
  struct Sector {
    FacetId facet;
    VertexId vertex;
    bool full;
    Double3 x, y;          ///< unit vectors: direction of the first edge, and that turned by 90 degrees in the facet
    double angle;          ///< of the whole sector
    SegmentId edges[2];    ///< the first and the last
    bool left[2];          ///< is the sector on the left of them
    std::vector<ArcPoint> arc;
  };
  /// One side of a segment in one facet: the points at factor * direction from the segment's points.
  struct Sheet {
    FacetId facet;
    bool left;
    IntegerVector direction;
    Dyadic factor;
    int ends[2];              ///< the points a next to the segment's ends, once its vertices are active
    std::vector<int> points;  ///< of the active row: one per station
  };

  void build_sheets();
  void build_sectors();
  Sheet& sheet_of(SegmentId s, FacetId f, bool left);
  double tolerance(VertexId v) const;
  void clear_ball(VertexId v);
  void clear_row(SegmentId s);
  void note_sector(int point, int sector);
  void split_arc(int sector, std::size_t interval);
  void split_row(SegmentId s, std::size_t interval);
  bool free_point(int id) const;
  Point arc_point(const Sector& sector, double angle) const;

  LeanState& state_;
  const Complex& complex_;
  std::vector<char> active_vertex_, active_segment_;
  std::vector<std::array<int, 2>> ends_;               // per segment: the points m, -1 without
  std::vector<std::vector<Sheet>> sheets_;             // per segment
  std::vector<std::vector<int>> stations_;             // per segment: the row's points on it, from m to m
  std::vector<Sector> sectors_;
  std::vector<std::vector<int>> sectors_of_vertex_;
  std::vector<std::vector<int>> sectors_of_facet_;     // active ones
  std::vector<std::vector<std::pair<SegmentId, int>>> sheets_of_facet_;  // active ones: segment, which of its sheets
  std::vector<char> protected_;                        // per point
  std::unordered_map<int, std::vector<int>> sectors_of_point_;
  std::unordered_map<int, std::vector<SegmentId>> rows_of_point_;
  long vertices_ = 0, segments_ = 0;
};

}  // namespace confidel
