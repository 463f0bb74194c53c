// SPDX-License-Identifier: GPL-3.0-or-later
// What the lean strategy refines: points, the segments' pieces, every facet's triangulation, and the tetrahedralization of it all;
// the tests of what is supported, and changes that keep everything in step and know what they may have spoiled.
#pragma once

#include <deque>
#include <optional>
#include <queue>
#include <stdexcept>
#include <tuple>
#include <unordered_map>
#include <vector>

#include "core/features/features.h"
#include "core/placement/buffer_zones.h"
#include "core/placement/placement.h"
#include "core/placement/point_index.h"
#include "core/planar/facet_triangulation.h"
#include "core/planar/frame.h"
#include "core/tetrahedra/delaunay.h"

namespace confidel {

/// Lean cannot go on by its own means: the whole input is the graded strategy's.
struct LeanGivesUp : std::runtime_error {
  using std::runtime_error::runtime_error;
};

class LeanState {
 public:
  using Triangle = FacetTriangulation::Triangle;

  /// Pre: complex is valid and triangulated, and outlives this.
  LeanState(const Complex& complex, const Features& features, const Limits& limits, Progress& progress);

  struct Station {
    Dyadic t;
    int point;
  };
  struct Chain {
    std::vector<Station> stations;  ///< from the first vertex to the second, both included
    std::vector<FacetId> facets;    ///< that contain the segment, each once
    bool hanging() const { return facets.empty(); }
  };
  struct Information {
    PointKind kind;
    int carrier;
  };

  const Complex& complex() const { return complex_; }
  const BufferSizes& sizes() const { return sizes_; }
  const std::vector<Chain>& chains() const { return chains_; }
  const PlaneFrame& frame(FacetId facet) const { return frames_[facet]; }
  const FacetTriangulation& planar(FacetId facet) const { return planar_[facet]; }
  const DelaunayTetrahedralization& tetrahedra() const { return tetrahedra_; }
  Progress& progress() { return progress_; }
  /// All points lie in one plane: there are no tetrahedra.
  bool flat() const { return flat_; }

  int point_count() const { return static_cast<int>(points_.size()); }
  const Point& point(int id) const { return *points_[id]; }
  const Information& information(int id) const { return information_[id]; }
  bool alive(int id) const { return alive_[id] != 0; }
  bool on_segment(int id) const { return information_[id].kind == PointKind::edge || information_[id].kind == PointKind::projection; }
  /// Points that are there besides the vertices.
  long steiner() const { return steiner_; }
  /// More points were placed than inputs without traps need: protection may begin earlier.
  bool hard() const { return ever_ > early_; }
  double distance(int a, int b) const { return length(approximate_difference(point(b), point(a))); }
  const std::vector<FacetId>& facets_of_vertex(VertexId v) const { return facets_of_vertex_[v]; }
  const PointIndex& index() const { return index_; }

  bool is_piece(int a, int b) const;
  SegmentId segment_of(int a, int b) const;
  /// Which station of its chain a point is.
  std::size_t station_of(SegmentId segment, int id) const;

  // --- tests (lean_tests.cpp) ---
  enum class State { good, bad, tie };
  /// Is the triangle a strong face, with no tie beyond a constraint? If a tie is, blocked() is the constraint.
  State test(FacetId facet, const Triangle& triangle);
  const std::array<int, 2>& blocked() const { return blocked_; }
  /// Does nothing support the piece of a segment? A hanging one needs its diametral ball (certificate-format.md, rule hanging).
  bool unsupported(int a, int b) const;
  double circumradius(const Triangle& triangle) const;
  /// Do the given points alone leave the triangle no empty sphere, by a margin that floating point can vouch for?
  bool clearly_unsupported(const Triangle& triangle, const std::vector<int>& points) const;
  /// A point of another facet that hovers closely over the middle of an unsupported triangle: where below it, seen from the triangle's
  /// first corner, and how high. Steering only.
  struct Hovering {
    Double3 foot;
    double height;
  };
  std::optional<Hovering> hovering(const Triangle& triangle) const;

  // --- changes; what they spoil is queued by settle() ---
  /// Inserts a point into a segment's chain, and into every facet of it.
  int put_on_segment(SegmentId segment, Dyadic t, PointKind kind);
  /// Pre: strictly inside the facet, on no constraint and no vertex. near: a point close to it.
  int put_in_facet(FacetId facet, Point position, PointKind kind, int near);
  /// Takes a Steiner point out again.
  void take_out(int id);
  /// Tests what the last changes may have spoiled.
  void settle();
  /// Takes the point out if everything is supported without it. Says then whose surroundings that changed.
  bool try_remove(int id, std::vector<int>& neighbours);

  void examine_everything();
  /// Pieces and triangles that failed a test when it was made. Largest circumradius first.
  struct Missing {
    int a, b;
  };
  std::vector<Missing> missing;
  struct Bad {
    FacetId facet;
    Triangle triangle;
  };
  bool any_bad() const { return !queue_.empty(); }
  Bad next_bad();
  void examine(FacetId facet, const Triangle& triangle);

 private:
  void build();
  const std::vector<FacetId>& facets_of(int id) const;
  bool hanging_encroached(int a, int b) const;
  State test_flat(FacetId facet, const Triangle& triangle);
  int add_point(Point position, PointKind kind, int carrier);
  int place(Point position, PointKind kind, int carrier, int near);
  void remove_from_chain(int id);
  void examine_piece(int a, int b);
  void examine_around(const DelaunayTetrahedralization::Conflict& conflict, int id);
  void check_limits();

  const Complex& complex_;
  const BufferSizes sizes_;
  const Limits& limits_;
  Progress& progress_;
  PointIndex index_;
  DelaunayTetrahedralization tetrahedra_;
  bool flat_ = false;
  long budget_ = 0, early_ = 0, ever_ = 0, steiner_ = 0;
  std::deque<Point> storage_;
  std::vector<const Point*> points_;
  std::vector<Information> information_;
  std::vector<char> alive_;
  std::vector<Chain> chains_;
  std::vector<SegmentId> hanging_;
  std::vector<std::vector<FacetId>> facets_of_vertex_, single_;
  std::unordered_map<std::uint64_t, SegmentId> segment_of_;
  std::vector<PlaneFrame> frames_;
  std::vector<Projection> projections_;
  std::vector<FacetTriangulation> planar_;
  std::array<int, 2> blocked_{-1, -1};
  std::vector<std::pair<DelaunayTetrahedralization::Conflict, int>> pending_;
  std::vector<std::pair<FacetId, Triangle>> fresh_;
  std::vector<std::array<int, 2>> fresh_pieces_;
  std::priority_queue<std::tuple<double, int, int, int, int>> queue_;
};

}  // namespace confidel
