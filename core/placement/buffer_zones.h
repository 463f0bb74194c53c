// SPDX-License-Identifier: GPL-3.0-or-later
// Buffer zones: balls around vertices, aligned rows along edges, and what is left of each facet, P'' (paper sections 2.2, 2.3, 3.2;
// theory.md sections 3 and 4). A strategy chooses the sizes; the construction and its splits are the same for all.
#pragma once

#include <deque>
#include <functional>
#include <unordered_map>
#include <vector>

#include "core/complex/complex.h"
#include "core/placement/placement.h"
#include "core/planar/frame.h"
#include "core/planar/region.h"

namespace confidel {

/// Sizes in working coordinates, floating point: they steer.
/// Products of four lengths of this order are still doubles: what steers refinement computes them. Throws std::range_error if a rounding
/// tolerance of the strategies is smaller.
void expect_in_range(double tolerance);

struct BufferSizes {
  std::vector<double> radius;   ///< r_v per vertex
  std::vector<double> offset;   ///< d_e per segment
  /// Smallest angle that matters at the vertex: rounding of its points scales with its square (theory.md section 5).
  std::vector<double> vertex_angle;
  std::vector<double> dihedral;  ///< alpha_e per segment
  double greatest_arc = 1.0471975511965976;  ///< subarcs at the beginning: at most 60 degrees
  /// Rounding at a vertex, relative to r_v times the square of its smallest angle; and of offsets, relative to them.
  double vertex_precision = 0x1p-12, offset_precision = 0x1p-10;
};

/// One spacing for everything (theory.md section 3): chords and intervals lie in [least, 1.5 least], near place or above.
struct Spacing {
  double place = 0;  ///< h0
  double least = 0;  ///< h, a little below
  /// Is the facet's arc at the vertex, from the segment `first` to `last` (both -1: the whole circle), at least as long as `count` chords
  /// of h0? Asked where floating point cannot tell. Without it: yes, and `least` makes up for it.
  using Reaches = std::function<bool(FacetId facet, VertexId vertex, SegmentId first, SegmentId last, int count)>;
  Reaches reaches;
};

/// One cell of the buffer zones, or the two of a rectangle.
struct BufferCell {
  CellKind kind = CellKind::T;
  int sector = -1;               ///< T and S
  int row = -1, protector = -1;  ///< R
  int index = 0;                 ///< T: 0 opens, 1 closes the sector; S: of the subarc; R: of the interval
};

class BufferZones {
 public:
  /// Pre: complex is valid and triangulated. Everything, coarse: one interval per edge, arcs of at most greatest_arc.
  BufferZones(const Complex& complex, const BufferSizes& sizes);

  /// In steps, for strategies with one spacing: the ends of rows, and sectors as wide as these leave them (no arc points; a sector
  /// may be empty or negative, if sizes are wrong). Then the three steps, in this order, once each.
  enum class Stage { ends };
  BufferZones(const Complex& complex, const BufferSizes& sizes, Stage);
  void divide_sectors(const Spacing& spacing);
  void divide_rows(const Spacing& spacing);
  void build_regions();

  struct Station {
    Dyadic t;
    int point;
  };
  /// One side of a segment in one facet: the row of points at o = factor * direction from the segment's points.
  struct Protector {
    FacetId facet;
    bool left;  ///< left of the segment from its first to its second vertex
    IntegerVector direction;
    Dyadic factor;
    std::vector<int> points;
    std::vector<char> free;  ///< per interval: its rectangle is known not to be encroached by anything but later points
  };
  struct Row {
    SegmentId segment;
    bool projection_first, projection_second;  ///< is there a point m at that end (else the row begins at the vertex)
    std::vector<Station> stations;             ///< from the first vertex to the second; the vertices themselves only where there is no m
    std::vector<Protector> protectors;         ///< empty: a hanging segment
    std::vector<char> free;                    ///< hanging: per interval
  };
  struct ArcPoint {
    double angle;
    int point;
  };
  /// A facet's sector at a vertex, between two of its edges, or all around an isolated vertex (then the first point closes it again).
  struct Sector {
    FacetId facet;
    VertexId vertex;
    bool full;
    double first = 0, last = 0;  ///< the arc's range of angles
    Double3 x, y;  ///< unit vectors: direction of the first edge, and that turned by 90 degrees in the facet
    std::array<int, 2> row{-1, -1}, protector{-1, -1};  ///< at the first and the last edge
    std::vector<ArcPoint> arc;
    std::vector<char> free;
  };
  /// What a boundary segment of a region belongs to.
  struct Owner {
    int row = -1, protector = -1;
    int sector = -1;
  };

  const Complex& complex() const { return complex_; }
  std::vector<Row>& rows() { return rows_; }
  std::vector<Sector>& sectors() { return sectors_; }
  const std::vector<Row>& rows_view() const { return rows_; }
  const std::vector<Sector>& sectors_view() const { return sectors_; }
  Region& region(FacetId facet) { return regions_[facet].region; }
  const PlaneFrame& frame(FacetId facet) const { return frames_[facet]; }

  int point_count() const { return static_cast<int>(points_.size()); }
  const Point& point(int id) const { return *points_[id]; }
  PointKind kind(int id) const { return information_[id].kind; }
  int carrier(int id) const { return information_[id].carrier; }

  /// The global point of a region's vertex, and back for boundary vertices.
  int point_of(FacetId facet, int region_vertex) const { return regions_[facet].points[region_vertex]; }
  /// Registers the vertices that the region inserted by itself (refine): they become interior points of the facet.
  void adopt_new_vertices(FacetId facet);

  /// The points m and a next to an edge's end in a sector: [0] at the first edge, [1] at the last.
  int projection_point(const Sector& sector, int side) const;

  /// The corners of a cell, counter-clockwise; a rectangle's four, the first two on its segment.
  std::array<int, 3> corners(const BufferCell& cell) const;
  std::array<int, 4> box(const BufferCell& cell) const;

  /// Marks an interval for splitting: of a row, of a sector, or whatever owns a region's boundary segment.
  void request_row(int row, int interval);
  void request_sector(int sector, int interval);
  void request_boundary(FacetId facet, std::array<int, 2> region_vertices);
  /// Splits everything that is marked, in a fixed order. Returns the number of intervals split.
  int apply_requests();

  /// Rounding tolerance at a vertex.
  double tolerance(VertexId vertex) const { return tolerances_[vertex]; }

  Placement result() const;

 private:
  struct Information {
    PointKind kind;
    int carrier;
  };
  struct FacetRegion {
    explicit FacetRegion(Projection projection) : region(projection) {}
    Region region;
    std::vector<int> points;                   // global id of each region vertex
    std::unordered_map<int, int> vertices;     // region vertex of a boundary point
    std::unordered_map<std::uint64_t, Owner> owners;
  };

  int add_point(Point point, PointKind kind, int carrier);
  int add_reference(const Point& point, PointKind kind, int carrier);
  void build_rows(const BufferSizes& sizes);
  void build_sectors(const BufferSizes& sizes);
  template <class Pieces>
  void divide_arcs(Pieces pieces);
  Point arc_point(const Sector& sector, double angle) const;
  int region_vertex(FacetRegion& region, int point);
  void own(FacetRegion& region, int first_point, int second_point, const Owner& owner);
  void split_boundary(FacetId facet, int first_point, int second_point, int middle_point);
  int split_row(int index);
  int split_sector(int index);

  const Complex& complex_;
  std::deque<Point> storage_;
  std::vector<const Point*> points_;
  std::vector<Information> information_;
  std::vector<PlaneFrame> frames_;
  std::vector<double> radius_, tolerances_;
  std::vector<Row> rows_;
  std::vector<int> row_of_segment_;
  std::vector<Sector> sectors_;
  std::vector<FacetRegion> regions_;
  std::vector<std::vector<char>> row_marks_, sector_marks_;
};

}  // namespace confidel
