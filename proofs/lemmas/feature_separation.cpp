// SPDX-License-Identifier: GPL-3.0-or-later
// L21: vertices, segments and facets without a common vertex are far apart, compared with the protecting balls (and, local, the offsets).

#include "core/features/bounding_volumes.h"
#include "proofs/lemmas/needs.h"
#include "proofs/lemmas/rational_geometry.h"
#include "proofs/lemmas/space.h"
#include "proofs/lemmas/statements.h"

namespace confidel::statements {
namespace {

mpq_class between_segments(const RationalVector& a, const RationalVector& b, const RationalVector& c, const RationalVector& d) {
  mpq_class least = std::min({squared_distance_to_segment(a, c, d), squared_distance_to_segment(b, c, d), squared_distance_to_segment(c, a, b), squared_distance_to_segment(d, a, b)});
  const RationalVector u = minus(b, a), v = minus(d, c), n = cross(u, v), w = minus(c, a);
  const mpq_class size = squared(n);
  if (size == 0) return least;
  const mpq_class s = dot(cross(w, v), n), t = dot(cross(w, u), n);
  if (s < 0 || s > size || t < 0 || t > size) return least;
  return std::min(least, mpq_class(square(dot(w, n)) / size));
}

/// Is a point of the facet's plane in the closed region? By parity of boundary edges on a ray, in the projection along the normal's
/// greatest component.
bool in_region(const Instance& instance, FacetId f, const RationalVector& x) {
  const RationalVector& n = instance.normal(f);
  int axis = 0;
  for (int k = 1; k < 3; ++k)
    if (abs(n[k]) > abs(n[axis])) axis = k;
  const int i = (axis + 1) % 3, j = (axis + 2) % 3;
  bool inside = false;
  for (const auto& [a, c] : instance.facets[f].boundary) {
    const RationalVector p = minus(instance.positions[a], x), q = minus(instance.positions[c], x);
    const mpq_class turn = p[i] * q[j] - p[j] * q[i];
    if (turn == 0 && p[i] * q[i] <= 0 && p[j] * q[j] <= 0) return true;
    if ((p[j] > 0) != (q[j] > 0) && (sgn(turn) > 0) == (q[j] > p[j])) inside = !inside;
  }
  return inside;
}

/// lemma-claims.md section 2: the distance to the plane if the projection is in the region; absent: unbounded.
std::optional<mpq_class> vertex_to_facet(const Instance& instance, VertexId v, FacetId f) {
  const RationalVector& n = instance.normal(f);
  const mpq_class height = dot(n, minus(instance.positions[v], instance.positions[instance.facets[f].frame[0]])), size = squared(n);
  if (!in_region(instance, f, minus(instance.positions[v], times(height / size, n)))) return std::nullopt;
  return square(height) / size;
}

bool segment_meets_facet(const Instance& instance, SegmentId s, FacetId f) {
  const RationalVector& n = instance.normal(f);
  const RationalVector &origin = instance.positions[instance.facets[f].frame[0]], &a = instance.positions[instance.segments[s][0]], &b = instance.positions[instance.segments[s][1]];
  const mpq_class p = dot(n, minus(a, origin)), q = dot(n, minus(b, origin));
  if (p * q > 0) return false;
  // In the plane: crossings of boundary edges are pairs of segments.
  if (p == 0 && q == 0) return in_region(instance, f, a) || in_region(instance, f, b);
  return in_region(instance, f, plus(a, times(p / (p - q), minus(b, a))));
}

class Separation {
 public:
  Separation(const Instance& instance, Tally& tally)
      : instance_(instance), tally_(tally), space_(instance), vertices_(volumes(instance.vertex_count, [](int v) { return std::vector<int>{v}; })),
        segments_(volumes(static_cast<int>(instance.segments.size()), [&](int s) { return std::vector<int>{instance.segments[s][0], instance.segments[s][1]}; })),
        facets_(volumes(instance.dimension == 3 ? static_cast<int>(instance.facets.size()) : 0, [&](int f) {
          std::vector<int> corners;
          for (const auto& [a, c] : instance.facets[f].boundary) corners.push_back(a);
          return corners;
        })) {}

  /// All entities disjoint from the vertex; later_only: those that come after it in (vertices, segments, facets).
  bool vertex(VertexId v, const mpq_class& radius, bool later_only) {
    const int own = line_of(instance_.lines.points, v);
    begin({v}, radius, fmt::format("vertex-{}", v));
    search(vertices_, [&](int other) -> std::optional<mpq_class> {
      if (other == v || (later_only && other < v)) return std::nullopt;
      return squared(minus(instance_.positions[v], instance_.positions[other]));
    }, instance_.lines.points, own, "vertex");
    search(segments_, [&](int s) -> std::optional<mpq_class> {
      if (instance_.segments[s][0] == v || instance_.segments[s][1] == v) return std::nullopt;
      return squared_distance_to_segment(instance_.positions[v], instance_.positions[instance_.segments[s][0]], instance_.positions[instance_.segments[s][1]]);
    }, instance_.lines.segments, own, "segment");
    search(facets_, [&](int f) -> std::optional<mpq_class> {
      if (instance_.has_vertex(f, v)) return std::nullopt;
      return vertex_to_facet(instance_, v, f);
    }, instance_.lines.facets, own, "facet");
    return end();
  }

  bool segment(SegmentId s, const mpq_class& radius, bool later_only) {
    const auto& [a, b] = instance_.segments[s];
    const int own = line_of(instance_.lines.segments, s);
    begin({a, b}, radius, fmt::format("segment-{}", s));
    search(segments_, [&, a = a, b = b](int other) -> std::optional<mpq_class> {
      const auto& [c, d] = instance_.segments[other];
      if ((later_only && other < s) || a == c || a == d || b == c || b == d) return std::nullopt;
      return between_segments(instance_.positions[a], instance_.positions[b], instance_.positions[c], instance_.positions[d]);
    }, instance_.lines.segments, own, "segment");
    search(facets_, [&, a = a, b = b](int f) -> std::optional<mpq_class> {
      if (instance_.has_vertex(f, a) || instance_.has_vertex(f, b) || !segment_meets_facet(instance_, s, f)) return std::nullopt;
      return mpq_class(0);
    }, instance_.lines.facets, own, "facet");
    return end();
  }

 private:
  template <class Corners>
  BoundingVolumes volumes(int count, Corners corners) const {
    std::vector<Box> boxes(count);
    for (int i = 0; i < count; ++i)
      for (const int point : corners(i)) boxes[i].extend(box_of(point));
    return BoundingVolumes(boxes);
  }
  Box box_of(int point) const {
    const auto& at = space_.approximate(point);
    Box box;
    for (int axis = 0; axis < 3; ++axis) {
      box.lower[axis] = at[axis] - Space::position_error;
      box.upper[axis] = at[axis] + Space::position_error;
    }
    return box;
  }

  void begin(const std::vector<int>& corners, const mpq_class& radius, std::string name) {
    box_ = Box();
    for (const int point : corners) box_.extend(box_of(point));
    threshold_ = 9 * square(radius);
    approximate_threshold_ = 3 * space_.scaled(radius).upper();
    name_ = std::move(name);
    violation_.clear();
  }
  bool end() {
    if (violation_.empty()) return true;
    tally_.fail(violation_line_, violation_);
    return false;
  }
  double limit() const { return Space::reach(approximate_threshold_, 1 + std::max(0.0, tally_.smallest())) + 4 * Space::position_error; }

  template <class Distance>
  void search(const BoundingVolumes& volumes, Distance distance, const std::vector<int>& lines, int own_line, const char* word) {
    volumes.search(Probe(box_), limit(), [](const Labels&) { return false; }, [&](int other, double before) {
      const std::optional<mpq_class> found = distance(other);
      if (!found) return before;
      const auto place = [&] { return fmt::format("{}-{}-{}", name_, word, other); };
      // Of two entities of the complex the line of the later one is named.
      const int line = std::max(own_line, line_of(lines, other));
      if (*found < threshold_ && violation_.empty()) {
        violation_ = place();
        violation_line_ = line;
      }
      tally_.slack(mpq_class(*found / threshold_ - 1), line, place);
      return std::min(before, limit());
    });
  }

  const Instance& instance_;
  Tally& tally_;
  Space space_;
  BoundingVolumes vertices_, segments_, facets_;
  Box box_;
  mpq_class threshold_;
  double approximate_threshold_ = 0;
  int violation_line_ = 0;
  std::string name_, violation_;
};

}  // namespace

void feature_separation(const Instance& instance, Tally& tally) {
  const Parameters& parameters = instance.parameters;
  const bool local = !parameters.balls.empty() || !parameters.rows.empty();
  if (!local) need(parameters.radius, "r");
  Separation separation(instance, tally);
  if (!local) {
    for (VertexId v = 0; v < instance.vertex_count; ++v) separation.vertex(v, *parameters.radius, true);
    for (std::size_t s = 0; s < instance.segments.size(); ++s) separation.segment(static_cast<SegmentId>(s), *parameters.radius, true);
    return;
  }
  for (const PlacedCell& cell : instance.cells)
    if (cell.kind == CellKind::T || cell.kind == CellKind::S)
      for (const int corner : cell.corners) {
        if (corner < instance.vertex_count) need_ball(instance, corner);
        if (cell.kind == CellKind::T && instance.on_segment_kind(corner)) need_row(instance, instance.carriers[corner]);
      }
  for (const auto& ball : parameters.balls) separation.vertex(ball.vertex, ball.radius, false);
  for (const auto& row : parameters.rows) separation.segment(row.segment, row.offset, false);
}

}  // namespace confidel::statements
