// SPDX-License-Identifier: GPL-3.0-or-later
// What a strategy hands on: Steiner points on their carriers and the cells that they form. Exact; nothing in it is believed by the
// verdict, which is the checker's.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "core/complex/complex.h"

namespace confidel {

/// certificate-format.md section 3: the kind of a Steiner point. Carrier: a segment (projection, edge) or a facet (the others).
enum class PointKind : unsigned char { vertex, projection, edge, offset, arc, interior };

/// Kinds of cells: T at an edge's end, spoke S, rectangle R (two triangles), any other triangle C.
enum class CellKind : unsigned char { T, S, R, C };

/// As certificates spell them; `vertex` has no record there.
inline const char* name_of(PointKind kind) {
  static constexpr const char* names[] = {"vertex", "projection", "edge", "offset", "arc", "interior"};
  return names[static_cast<int>(kind)];
}
inline char name_of(CellKind kind) { return "TSRC"[static_cast<int>(kind)]; }

struct PlacedPoint {
  Point position;
  PointKind kind = PointKind::vertex;
  int carrier = -1;
};

/// A rational of which there are millions, nearly all zero: zeros take no memory of their own.
class SparseRational {
 public:
  SparseRational() = default;
  SparseRational(const mpq_class& value) : value_(value == 0 ? nullptr : std::make_unique<mpq_class>(value)) {}
  SparseRational(const SparseRational& other) : SparseRational(other.value()) {}
  SparseRational(SparseRational&&) noexcept = default;
  SparseRational& operator=(SparseRational other) noexcept {
    value_ = std::move(other.value_);
    return *this;
  }

  bool operator==(const SparseRational& other) const { return value() == other.value(); }
  bool is_zero() const { return !value_; }
  const mpq_class& value() const {
    static const mpq_class zero;
    return value_ ? *value_ : zero;
  }

 private:
  std::unique_ptr<mpq_class> value_;
};

struct PlacedCell {
  FacetId facet = 0;
  std::array<int, 3> corners{};
  CellKind kind = CellKind::C;
  int box = -1;
  /// The sphere's offset along the facet's normal (certificate-format.md section 3), in the input's coordinates; zero: none.
  SparseRational offset;
};

struct PlacedRow {
  SegmentId segment = 0;
  std::vector<int> points;  ///< all points carried by the segment, from its first vertex to its second
  struct Protector {
    FacetId facet;
    bool left;  ///< on the left of the segment (first to second vertex), seen from the facet's positive side
    std::vector<int> points;
  };
  std::vector<Protector> protectors;
};

/// The constants that lemma claims name: lemma-claims.md section 1, in the input's coordinates. Absent: nothing is claimed of it.
struct Parameters {
  std::optional<mpq_class> radius, spacing, greatest_circumradius;  ///< r, h, r-max
  int angle_multiple = 0;                                           ///< K: phi' = K arccos(angle_cosine); 0: absent
  mpq_class angle_cosine;
  int beta = 0, offset = 0, chord = 0;  ///< their J; 0: absent
  struct Ball {
    VertexId vertex;
    mpq_class radius;
  };
  struct Row {
    SegmentId segment;
    mpq_class offset;
    std::array<mpq_class, 2> edge_cosine, facet_cosine;  ///< A and B, at the first and the second vertex
  };
  std::vector<Ball> balls;  ///< by vertex
  std::vector<Row> rows;    ///< by segment
};

/// Evidence for L8: the point was inserted as the circumcentre of the triangle.
struct Insertion {
  FacetId facet;
  std::array<int, 3> corners;
  int point;
};

/// lemma-claims.md section 5. One cell and one point (L9 to L13), two cells (L5), or one cell and two points (L18).
struct Refutation {
  std::string statement;
  std::vector<int> cells, points;
  std::vector<mpq_class> values;  ///< POWER, or T1 and T2
};

/// Points 0 .. vertices-1 are the complex's vertices.
struct Placement {
  std::vector<PlacedPoint> points;
  /// The input's coordinates of all points where not all are dyadic (exact circles in the plane); else empty. The positions above
  /// are then approximations.
  std::vector<std::array<mpq_class, 3>> rational_positions;
  std::vector<PlacedCell> cells;
  std::vector<PlacedRow> rows;                   ///< by segment
  std::vector<std::array<int, 3>> hanging;       ///< segment, a, b: in order along the segment, by segment
  std::vector<std::string> claims;               ///< IDs of lemma-claims.md besides `conforms`, in its order
  Parameters parameters;
  std::vector<Insertion> insertions;             ///< in the order of insertion within each facet
  std::optional<Refutation> refutation;          ///< then the certificate refutes, and does not claim `conforms`
};

/// Limits of a long computation; those of time and memory are the Progress's.
struct Limits {
  long max_points = 0;  ///< 0: none
  int threads = 1;
};

/// Thrown when a limit is reached ("max-points") or Progress asked to stop ("stopped"): the verdict is UNDECIDED.
class LimitReached : public std::runtime_error {
 public:
  LimitReached(const std::string& why, long points) : std::runtime_error(why), points_reached(points) {}
  long points_reached;  ///< so far
};

/// Thrown when a strategy finds that it cannot go on on this input (never a wrong answer): UNDECIDED.
class StrategyFailed : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Called now and then with the stage and the number of points; may throw LimitReached. Must be fast when it has nothing to say.
class Progress {
 public:
  virtual ~Progress() = default;
  virtual void at(const char* stage, long points) = 0;
  /// True when work should stop (time, memory, interruption); safe to call from any thread.
  virtual bool stop_requested(long points) = 0;
  /// Told once, early: the number of points that the result is expected to have.
  virtual void estimated(double points) = 0;
};

}  // namespace confidel
