// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/placement/lean_refinement.h"

#include <algorithm>
#include <cmath>

namespace confidel {
namespace {

// Protection begins where refinement comes nearer than r_v/kappa to a vertex or d_e/kappa to a segment.
// Late, because protection costs points; but early once many points were placed in vain.
constexpr double late = 128;
constexpr double early = 2;
// The budget of a neighbourhood: so often may refinement come nearer than r_v or d_e before protection begins.
constexpr int patience = 64;
// Insertions round their circumcentre by at most this part of the radius (theory.md section 5).
constexpr double rounding = 1.0 / 64;

}  // namespace

LeanRefinement::LeanRefinement(LeanState& state, LeanProtection& protection)
    : state_(state), protection_(protection), complex_(state.complex()) {
  for (double r : state.sizes().radius) greatest_guard_ = std::max(greatest_guard_, 2 * r);
  at_vertex_.assign(complex_.vertices.size(), 0);
  at_segment_.assign(complex_.segments.size(), 0);
}

bool LeanRefinement::used_up(int& events) { return ++events > patience; }

void LeanRefinement::run() {
  for (;;) {
    state_.examine_everything();
    split_missing();
    for (FacetId f = 0; f < static_cast<FacetId>(complex_.facets.size()); ++f)
      for (const Triangle& t : state_.planar(f).triangles()) state_.examine(f, t);
    if (!state_.any_bad()) return;
    const int before = state_.point_count();
    bool hidden = false;
    while (state_.any_bad()) {
      const auto [f, t] = state_.next_bad();
      if (!state_.planar(f).has_triangle(t)) continue;
      const LeanState::State now = state_.test(f, t);
      if (now == LeanState::State::good) continue;
      // In the plane, what is in the disk is hidden by a constraint, and the triangle at that constraint has it in its disk too:
      // splitting segments suffices, and with shells it ends.
      if (state_.flat() && now == LeanState::State::bad) {
        hidden = true;
        continue;
      }
      repair(f, t, now);
      split_missing();
      // It may have survived: a segment was split far away.
      if (state_.planar(f).has_triangle(t)) state_.examine(f, t);
    }
    if (hidden && state_.point_count() == before) throw LeanGivesUp("a triangle cannot be repaired");
  }
}

void LeanRefinement::split_missing() {
  while (!state_.missing.empty()) {
    const auto [a, b] = state_.missing.back();
    state_.missing.pop_back();
    if (!state_.is_piece(a, b) || !state_.unsupported(a, b)) continue;
    split(a, b);
    if (state_.is_piece(a, b) && state_.unsupported(a, b)) state_.missing.push_back({a, b});
  }
}

// Splits the piece ab of a segment: at a power-of-two distance from an input vertex (Ruppert's shells), else in the middle. Protected
// pieces by the rules of their balls and rows; where a piece is too short for its surroundings, protection begins.
void LeanRefinement::split(int a, int b, FacetId facet) {
  if (protection_.split_piece(a, b, facet)) return state_.settle();
  const SegmentId s = state_.segment_of(a, b);
  const auto& stations = state_.chains()[s].stations;
  std::size_t i = state_.station_of(s, a);
  if (i + 1 == stations.size() || stations[i + 1].point != b) {
    i = state_.station_of(s, b);
    std::swap(a, b);
  }
  const auto [first, second] = complex_.segments[s];
  const double whole = state_.distance(first, second);
  const double kappa = state_.hard() ? early : late;
  const bool at_first = a == first, at_second = b == second;
  const double piece = state_.distance(a, b);
  if (!state_.flat()) {
    for (const auto& [near, v] : {std::pair{at_first, first}, std::pair{at_second, second}}) {
      const double r = state_.sizes().radius[v];
      if (near && piece < r && (piece < r / kappa || used_up(at_vertex_[v]))) {
        protection_.activate_vertex(v);
        return state_.settle();
      }
    }
    const double d = state_.sizes().offset[s];
    if (piece < d && !protection_.active_segment(s) && (piece < d / kappa || used_up(at_segment_[s]))) {
      protection_.activate_segment(s);
      return state_.settle();
    }
  }
  Dyadic t;
  if (at_first != at_second) {
    const double shell = std::exp2(std::round(std::log2(piece / 2)));
    const VertexId v = at_first ? first : second;
    const double angle = std::min(1.0, state_.sizes().vertex_angle[v]);
    t = round_to(shell / whole, shell / whole * angle * angle * 0x1p-12);
    if (at_second) {
      mpz_class one = 1;
      if (t.exponent > 0) one <<= t.exponent;
      t.numerator = one - t.numerator;
    }
  } else {
    t = midpoint(stations[i].t, stations[i + 1].t);
  }
  state_.put_on_segment(s, std::move(t), PointKind::edge);
  state_.settle();
}

// Steps 5 to 12 for one bad triangle.
void LeanRefinement::repair(FacetId f, const Triangle& t, LeanState::State state) {
  if (state == LeanState::State::tie) {
    const auto blocked = state_.blocked();
    return split(blocked[0], blocked[1], f);
  }
  if (protection_.split_under(f, t)) return state_.settle();
  const Point &a = state_.point(t[0]), &b = state_.point(t[1]), &c = state_.point(t[2]);
  const Double3 u = approximate_difference(b, a), w = approximate_difference(c, a), n = cross(u, w);
  const double nn = dot(n, n);
  const Double3 z = (dot(u, u) / (2 * nn)) * cross(w, n) + (dot(w, w) / (2 * nn)) * cross(n, u);
  const double radius = length(z);
  if (!std::isfinite(radius)) throw LeanGivesUp("a triangle is too thin for its circumcentre");
  const PlaneFrame& frame = state_.frame(f);
  const Point& origin = complex_.vertices[complex_.facets[f].frame[0]];
  Double3 offset = z;
  double tolerance = radius * rounding;
  // A point that hovers closely over the triangle: with a point right below, both facets have spheres on their far sides, where any other
  // point would have to come as close as the facets are.
  if (!state_.flat())
    if (const auto hovering = state_.hovering(t)) {
      offset = hovering->foot;
      tolerance = std::min(tolerance, std::max(hovering->height * hovering->height / (8 * radius), radius * 0x1p-16));
    }
  Point centre = radius > 0x1p-36 ? frame.round(origin, approximate_difference(a, origin) + offset, tolerance) : frame.round(a, offset, tolerance);
  const auto walk = state_.planar(f).walk(t, centre);
  if (!walk.reached) {
    if (walk.constraint[0] < 0) throw LeanGivesUp("a circumcentre cannot be located");
    return split(walk.constraint[0], walk.constraint[1], f);
  }
  if (const auto piece = protection_.split_at(f, centre)) {
    if ((*piece)[0] < 0) return state_.settle();
    return split((*piece)[0], (*piece)[1], f);
  }
  if (!state_.flat()) {
    // A piece of a segment that would vanish is split instead: the longest.
    std::array<int, 2> longest{-1, -1};
    double size = 0;
    for (const auto& [p, q] : state_.tetrahedra().conflict(centre, t[0]).edges) {
      if (!state_.is_piece(p, q)) continue;
      const double here = state_.distance(p, q);
      if (here > size) {
        size = here;
        longest = {p, q};
      }
    }
    if (longest[0] >= 0) return split(longest[0], longest[1]);
  }
  if (protect_near(f, centre, radius)) return;
  state_.put_in_facet(f, std::move(centre), PointKind::interior, t[0]);
  state_.settle();
}

// Steps 9 and 10: a circumcentre too close, or too often close, to a vertex or a segment that is not protected yet.
bool LeanRefinement::protect_near(FacetId f, const Point& centre, double radius) {
  if (state_.flat() || radius > greatest_guard_) return false;
  const double kappa = state_.hard() ? early : late;
  const BufferSizes& sizes = state_.sizes();
  const auto near_vertex = [&](VertexId v) {
    if (protection_.active_vertex(v)) return false;
    const double away = length(approximate_difference(centre, complex_.vertices[v])), r = sizes.radius[v];
    if (away >= r || (away >= r / kappa && !used_up(at_vertex_[v]))) return false;
    protection_.activate_vertex(v);
    state_.settle();
    return true;
  };
  const Facet& facet = complex_.facets[f];
  for (VertexId v : facet.isolated)
    if (near_vertex(v)) return true;
  for (const auto* edges : {&facet.boundary, &facet.constraints})
    for (const auto& [p, q] : *edges) {
      if (near_vertex(p) || (edges == &facet.constraints && near_vertex(q))) return true;
      const SegmentId s = complex_.find_segment(p, q);
      if (protection_.active_segment(s)) continue;
      const auto [first, second] = complex_.segments[s];
      const Double3 along = approximate_difference(complex_.vertices[second], complex_.vertices[first]),
                    to = approximate_difference(centre, complex_.vertices[first]);
      const double whole = length(along), below = dot(along, to) / whole, near = sizes.offset[s] / kappa;
      const double away = length(cross(along, to)) / whole;
      if (away >= sizes.offset[s] || below <= 0 || below >= whole) continue;
      const bool often = used_up(at_segment_[s]);
      if (away >= near && !often) continue;
      // The piece below is split as long as it is long.
      const auto& stations = state_.chains()[s].stations;
      std::size_t i = 0;
      while (i + 2 < stations.size() && stations[i + 1].t.approximate() * whole < below) ++i;
      const int a = stations[i].point, b = stations[i + 1].point;
      if (!often && state_.distance(a, b) > 4 * near) {
        split(a, b, f);
      } else {
        protection_.activate_segment(s);
        state_.settle();
      }
      return true;
    }
  return false;
}

}  // namespace confidel
