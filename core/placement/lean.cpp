// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/placement/lean.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <queue>
#include <tuple>
#include <unordered_map>

#include "core/placement/graded.h"
#include "core/placement/local_claims.h"
#include "core/placement/pencil.h"
#include "core/placement/point_index.h"
#include "core/planar/facet_triangulation.h"
#include "core/planar/frame.h"
#include "core/tetrahedra/delaunay.h"

namespace confidel {
namespace {

using Triangle = FacetTriangulation::Triangle;

// Protection begins where refinement comes nearer than r_v/kappa to a vertex or d_e/kappa to a segment.
constexpr double kappa = 128;
// Insertions round their circumcentre by at most this part of the radius (theory.md section 5).
constexpr double rounding = 1.0 / 64;

// Refinement comes too close to an input vertex or segment.
struct NeedsProtection : std::runtime_error {
  using std::runtime_error::runtime_error;
};

std::uint64_t key(int a, int b) {
  if (a > b) std::swap(a, b);
  return (static_cast<std::uint64_t>(static_cast<std::uint32_t>(a)) << 32) | static_cast<std::uint32_t>(b);
}

class Lean {
 public:
  Lean(const Complex& complex, const Features& features, const Limits& limits, Progress& progress)
      : complex_(complex), sizes_(graded_sizes(complex, features)), limits_(limits), progress_(progress), index_(make_index()) {
    budget_ = 4000 + 128 * static_cast<long>(complex.vertices.size() + complex.segments.size() + complex.facets.size());
    build();
  }

  Placement run(LeanReport& report) {
    refine();
    report.placed = steiner_;
    clean_up();
    report.removed = report.placed - steiner_;
    return result();
  }

 private:
  struct Station {
    Dyadic t;
    int point;
  };
  struct Chain {
    std::vector<Station> stations;  // from the first vertex to the second, both included
    std::vector<FacetId> facets;    // that contain the segment, each once
    bool hanging() const { return facets.empty(); }
  };
  struct Information {
    PointKind kind;
    int carrier;
  };

  PointIndex make_index() const {
    PointIndex::Position low{1e300, 1e300, 1e300}, high{-1e300, -1e300, -1e300};
    for (const Point& p : complex_.vertices)
      for (int axis = 0; axis < 3; ++axis) {
        low[axis] = std::min(low[axis], p.approximate(axis));
        high[axis] = std::max(high[axis], p.approximate(axis));
      }
    return PointIndex(low, high);
  }

  const Point& point(int id) const { return *points_[id]; }

  int add_point(Point p, PointKind kind, int carrier) {
    storage_.push_back(std::move(p));
    points_.push_back(&storage_.back());
    information_.push_back({kind, carrier});
    alive_.push_back(1);
    ++steiner_;
    return static_cast<int>(points_.size()) - 1;
  }

  void build() {
    const int vertices = static_cast<int>(complex_.vertices.size());
    facets_of_vertex_.resize(vertices);
    for (int v = 0; v < vertices; ++v) {
      points_.push_back(&complex_.vertices[v]);
      information_.push_back({PointKind::vertex, -1});
      alive_.push_back(1);
      tetrahedra_.insert(v, complex_.vertices[v]);
      index_.insert(v, complex_.vertices[v].approximate());
    }
    chains_.resize(complex_.segments.size());
    for (std::size_t s = 0; s < chains_.size(); ++s) {
      const auto [a, b] = complex_.segments[s];
      chains_[s].stations = {{{0, 0}, a}, {{1, 0}, b}};
      segment_of_[key(a, b)] = static_cast<SegmentId>(s);
    }
    for (std::size_t f = 0; f < complex_.facets.size(); ++f) {
      const Facet& facet = complex_.facets[f];
      frames_.emplace_back(complex_, facet);
      projections_.push_back(projection_of(facet.normal));
      planar_.emplace_back(projections_.back());
      FacetTriangulation& planar = planar_.back();
      std::vector<VertexId> own(facet.isolated);
      for (const auto* edges : {&facet.boundary, &facet.constraints})
        for (const auto& [a, b] : *edges) {
          own.push_back(a);
          own.push_back(b);
          chains_[complex_.find_segment(a, b)].facets.push_back(static_cast<FacetId>(f));
        }
      std::sort(own.begin(), own.end());
      own.erase(std::unique(own.begin(), own.end()), own.end());
      for (VertexId v : own) {
        planar.add_vertex(v, complex_.vertices[v]);
        facets_of_vertex_[v].push_back(static_cast<FacetId>(f));
      }
      for (const auto& [a, b] : facet.boundary) planar.add_constraint(a, b, true);
      for (const auto& [a, b] : facet.constraints) planar.add_constraint(a, b, false);
      planar.mark();
    }
    flat_ = tetrahedra_.dimension() < 3;
  }

  // The facets that a point lies on, by its carrier.
  const std::vector<FacetId>& facets_of(int id) const {
    switch (information_[id].kind) {
      case PointKind::vertex: return facets_of_vertex_[id];
      case PointKind::edge: return chains_[information_[id].carrier].facets;
      default: return single_[information_[id].carrier];
    }
  }

  // --- tests -------------------------------------------------------------------------------------------------------------------

  enum class State { good, bad, tie };

  // Is the triangle a strong face, with no tie beyond a constraint? If a tie is, blocked_ is the constraint.
  State test(FacetId f, const Triangle& t) {
    const FacetTriangulation& planar = planar_[f];
    if (flat_) return test_flat(f, t);
    auto face = tetrahedra_.face(t[0], t[1], t[2]);
    if (!face.exists) {
      bool tie = false;
      for (int i = 0; i < 3 && !tie; ++i) {
        const int d = planar.across(t[i], t[(i + 1) % 3], t[(i + 2) % 3]);
        tie = d >= 0 && diametral_power(point(t[0]), point(t[1]), point(t[2]), point(d)) == 0;
      }
      if (tie) face = tetrahedra_.cocircular_face(t[0], t[1], t[2]);
      if (!face.exists) return State::bad;
    }
    if (face.above >= 0 && face.below >= 0 &&
        in_sphere(point(t[0]), point(t[1]), point(t[2]), point(face.above), point(face.below)) == 0)
      return State::bad;
    for (int i = 0; i < 3; ++i) {
      const int a = t[i], b = t[(i + 1) % 3], c = t[(i + 2) % 3];
      if (!planar.is_constraint(a, b)) continue;
      for (int d : tetrahedra_.coplanar_across(a, b, c))
        if (diametral_power(point(a), point(b), point(c), point(d)) == 0) {
          blocked_ = {a, b};
          return State::tie;
        }
    }
    return State::good;
  }

  // All points lie in one plane: the triangle's open disk is empty, and ties do not lie beyond constraints.
  State test_flat(FacetId f, const Triangle& t) {
    const Point &a = point(t[0]), &b = point(t[1]), &c = point(t[2]);
    const Double3 u = approximate_difference(b, a), w = approximate_difference(c, a), n = cross(u, w);
    const double uu = dot(u, u), ww = dot(w, w), nn = dot(n, n), sine = nn / (uu * ww), inflation = 1e-12 + 1e-14 / sine;
    const Double3 z = (uu / (2 * nn)) * cross(w, n) + (ww / (2 * nn)) * cross(n, u);
    double radius = length(z) * (1 + inflation) + 1e-15;
    Double3 centre = a.approximate() + z;
    if (!std::isfinite(radius) || inflation > 1) {
      centre = {0, 0, 0};
      radius = 1e10;
    }
    State state = State::good;
    index_.visit_ball(centre, radius, [&](int id) {
      if (!alive_[id] || id == t[0] || id == t[1] || id == t[2]) return false;
      const int power = diametral_power(a, b, c, point(id));
      if (power > 0) return false;
      // The intruder is behind a constraint: the first constraint of the triangle that it is beyond.
      for (int i = 0; i < 3; ++i) {
        const int p = t[i], q = t[(i + 1) % 3];
        if (planar_orientation(projections_[f], point(p), point(q), point(id)) >= 0 || !planar_[f].is_constraint(p, q)) continue;
        blocked_ = {p, q};
        state = State::tie;
        return true;
      }
      if (power == 0) return false;
      state = State::bad;
      return false;
    });
    return state;
  }

  // certificate-format.md, rule hanging: no other point in or on the diametral ball.
  bool hanging_encroached(int a, int b) const {
    const Double3 half = 0.5 * approximate_difference(point(b), point(a));
    return index_.visit_ball(point(a).approximate() + half, length(half) * (1 + 1e-12) + 1e-15, [&](int id) {
      return alive_[id] && id != a && id != b && diametral_power(point(a), point(b), point(id)) <= 0;
    });
  }

  double circumradius(const Triangle& t) const {
    const double x = length(approximate_difference(point(t[1]), point(t[0]))), y = length(approximate_difference(point(t[2]), point(t[1]))),
                 z = length(approximate_difference(point(t[0]), point(t[2])));
    const double area = std::sqrt(std::max(0.0, (x + y + z) * (-x + y + z) * (x - y + z) * (x + y - z)));
    return area > 0 ? x * y * z / area : 1e300;
  }

  // --- changes -----------------------------------------------------------------------------------------------------------------

  void examine(FacetId f, const Triangle& t) {
    if (test(f, t) != State::good) queue_.emplace(circumradius(t), -f, -t[0], -t[1], -t[2]);
  }

  void examine_segment(int a, int b, SegmentId s) {
    if (chains_[s].hanging() ? hanging_encroached(a, b) : !flat_ && !tetrahedra_.is_edge(a, b)) missing_.push_back({a, b});
  }

  // Everything that a new point may spoil; called with what the tetrahedralization was going to change.
  void examine_around(const DelaunayTetrahedralization::Conflict& conflict, int id) {
    for (const auto& [a, b] : conflict.edges)
      if (segment_of_.count(key(a, b)) > 0) missing_.push_back({a, b});
    for (const auto& face : conflict.faces) {
      for (FacetId f : facets_of(face[0])) {
        Triangle t{face[0], face[1], face[2]};
        if (planar_orientation_of(f, t) < 0) std::swap(t[1], t[2]);
        if (planar_[f].has_triangle(t)) examine(f, t);
      }
    }
    for (std::size_t s = 0; s < chains_.size(); ++s) {
      if (!chains_[s].hanging()) continue;
      const auto& stations = chains_[s].stations;
      for (std::size_t i = 0; i + 1 < stations.size(); ++i) {
        const int a = stations[i].point, b = stations[i + 1].point;
        if (a != id && b != id && diametral_power(point(a), point(b), point(id)) <= 0) missing_.push_back({a, b});
      }
    }
  }

  int planar_orientation_of(FacetId f, const Triangle& t) const {
    return planar_orientation(projections_[f], point(t[0]), point(t[1]), point(t[2]));
  }

  void check_limits() {
    progress_.at("placing points", static_cast<long>(complex_.vertices.size()) + steiner_);
    if (limits_.max_points > 0 && steiner_ > limits_.max_points) throw LimitReached("max-points", steiner_);
    if (progress_.stop_requested(steiner_)) throw LimitReached("stopped", steiner_);
    if (steiner_ > budget_) throw NeedsProtection("the budget of points is used up");
  }

  int place(Point p, PointKind kind, int carrier, int near) {
    const int id = add_point(std::move(p), kind, carrier);
    check_limits();
    DelaunayTetrahedralization::Conflict conflict;
    if (!flat_) {
      conflict = tetrahedra_.conflict(point(id), near);
      tetrahedra_.insert(id, point(id), near);
    }
    index_.insert(id, point(id).approximate());
    pending_.push_back({std::move(conflict), id});
    return id;
  }

  // Splits the piece ab of a segment: at a power-of-two distance from an input vertex (Ruppert's shells), else in the middle.
  void split(int a, int b) {
    const SegmentId s = segment_of_.at(key(a, b));
    Chain& chain = chains_[s];
    std::size_t i = 0;
    while (key(chain.stations[i].point, chain.stations[i + 1].point) != key(a, b)) ++i;
    a = chain.stations[i].point;
    b = chain.stations[i + 1].point;
    const auto [first, second] = complex_.segments[s];
    const Point &p = point(first), &q = point(second);
    const double whole = length(approximate_difference(q, p));
    const bool at_first = a == first, at_second = b == second;
    const double piece = length(approximate_difference(point(b), point(a)));
    for (const auto& [near, v] : {std::pair{at_first, first}, std::pair{at_second, second}})
      if (near && piece < sizes_.radius[v] / kappa) throw NeedsProtection("a segment is split close to vertex " + std::to_string(v));
    if (piece < sizes_.offset[s] / kappa) throw NeedsProtection("a segment is split far below its distance to other things");
    Dyadic t;
    if (at_first != at_second) {
      const double shell = std::exp2(std::round(std::log2(piece / 2)));
      const VertexId v = at_first ? first : second;
      const double angle = std::min(1.0, sizes_.vertex_angle[v]);
      t = round_to(shell / whole, shell / whole * angle * angle * 0x1p-12);
      if (at_second) {
        mpz_class one = 1;
        if (t.exponent > 0) one <<= t.exponent;
        t.numerator = one - t.numerator;
      }
    } else {
      t = midpoint(chain.stations[i].t, chain.stations[i + 1].t);
    }
    const int id = place(along(p, q, t), PointKind::edge, s, a);
    chain.stations.insert(chain.stations.begin() + static_cast<long>(i) + 1, {std::move(t), id});
    segment_of_.erase(key(a, b));
    segment_of_[key(a, id)] = segment_of_[key(id, b)] = s;
    for (FacetId f : chain.facets)
      for (const Triangle& triangle : planar_[f].split(a, b, id, point(id))) fresh_.push_back({f, triangle});
    settle();
    examine_segment(a, id, s);
    examine_segment(id, b, s);
  }

  // Tests what the last changes may have spoiled.
  void settle() {
    auto pending = std::move(pending_);
    pending_.clear();
    auto fresh = std::move(fresh_);
    fresh_.clear();
    for (const auto& [f, triangle] : fresh)
      if (planar_[f].has_triangle(triangle)) examine(f, triangle);
    for (const auto& [conflict, id] : pending) examine_around(conflict, id);
    if (!flat_) return;
    // Without tetrahedra nobody says what else changed: other facets of the plane around the new points are tested again.
    for (const auto& [conflict, id] : pending)
      for (std::size_t f = 0; f < planar_.size(); ++f)
        if (planar_.size() > 1)
          for (const Triangle& t : planar_[f].triangles())
            if (diametral_power(point(t[0]), point(t[1]), point(t[2]), point(id)) <= 0) examine(static_cast<FacetId>(f), t);
  }

  bool is_piece(int a, int b) const { return segment_of_.count(key(a, b)) > 0; }

  void split_missing() {
    while (!missing_.empty()) {
      const auto [a, b] = missing_.back();
      missing_.pop_back();
      if (!is_piece(a, b)) continue;
      const bool hanging = chains_[segment_of_.at(key(a, b))].hanging();
      if (hanging ? hanging_encroached(a, b) : !flat_ && !tetrahedra_.is_edge(a, b)) split(a, b);
    }
  }

  // Steps 5, 7, 11 and 12 for one bad triangle.
  void repair(FacetId f, const Triangle& t, State state) {
    if (state == State::tie) return split(blocked_[0], blocked_[1]);
    const Point &a = point(t[0]), &b = point(t[1]), &c = point(t[2]);
    const Double3 u = approximate_difference(b, a), w = approximate_difference(c, a), n = cross(u, w);
    const double nn = dot(n, n);
    const Double3 z = (dot(u, u) / (2 * nn)) * cross(w, n) + (dot(w, w) / (2 * nn)) * cross(n, u);
    const double radius = length(z);
    if (!std::isfinite(radius)) throw NeedsProtection("a triangle is too thin for its circumcentre");
    const Point& origin = complex_.vertices[complex_.facets[f].frame[0]];
    Point centre = radius > 0x1p-36 ? frames_[f].round(origin, approximate_difference(a, origin) + z, radius * rounding)
                                    : frames_[f].round(a, z, radius * rounding);
    const auto walk = planar_[f].walk(t, centre);
    if (!walk.reached) {
      if (walk.constraint[0] < 0) throw NeedsProtection("a circumcentre cannot be located");
      return split(walk.constraint[0], walk.constraint[1]);
    }
    if (!flat_) {
      // A piece of a segment that would vanish is split instead: the longest.
      std::array<int, 2> longest{-1, -1};
      double size = 0;
      for (const auto& [p, q] : tetrahedra_.conflict(centre, t[0]).edges) {
        if (!is_piece(p, q)) continue;
        const double here = length(approximate_difference(point(q), point(p)));
        if (here > size) {
          size = here;
          longest = {p, q};
        }
      }
      if (longest[0] >= 0) return split(longest[0], longest[1]);
    }
    guard(f, centre, radius);
    const int id = place(std::move(centre), PointKind::interior, f, t[0]);
    for (const Triangle& triangle : planar_[f].insert(id, point(id), t[0])) fresh_.push_back({f, triangle});
    settle();
  }

  // Refinement may not come too close to vertices and segments (step 9 and 10 of the strategy).
  void guard(FacetId f, const Point& centre, double radius) const {
    if (radius > greatest_guard_) return;
    const auto distance_to = [&](VertexId v) { return length(approximate_difference(centre, complex_.vertices[v])); };
    const Facet& facet = complex_.facets[f];
    for (const auto* edges : {&facet.boundary, &facet.constraints})
      for (const auto& [p, q] : *edges) {
        const SegmentId s = complex_.find_segment(p, q);
        if (distance_to(p) < sizes_.radius[p] / kappa || distance_to(q) < sizes_.radius[q] / kappa)
          throw NeedsProtection("a facet is refined close to an input vertex");
        const Double3 along = approximate_difference(complex_.vertices[q], complex_.vertices[p]), to = approximate_difference(centre, complex_.vertices[p]);
        if (length(cross(along, to)) / length(along) < sizes_.offset[s] / kappa && dot(along, to) > 0 && dot(along, to) < dot(along, along))
          throw NeedsProtection("a facet is refined close to an input segment");
      }
  }

  void refine() {
    greatest_guard_ = 0;
    for (double r : sizes_.radius) greatest_guard_ = std::max(greatest_guard_, 4 * r / kappa);
    for (FacetId f = 0; f < static_cast<FacetId>(complex_.facets.size()); ++f) single_.push_back({f});
    for (;;) {
      for (std::size_t s = 0; s < chains_.size(); ++s)
        for (std::size_t i = 0; i + 1 < chains_[s].stations.size(); ++i)
          examine_segment(chains_[s].stations[i].point, chains_[s].stations[i + 1].point, static_cast<SegmentId>(s));
      split_missing();
      for (std::size_t f = 0; f < planar_.size(); ++f)
        for (const Triangle& t : planar_[f].triangles()) examine(static_cast<FacetId>(f), t);
      if (queue_.empty()) return;
      while (!queue_.empty()) {
        const auto [radius, f, p, q, r] = queue_.top();
        queue_.pop();
        const Triangle t{-p, -q, -r};
        if (!planar_[-f].has_triangle(t)) continue;
        const State state = test(-f, t);
        if (state == State::good) continue;
        repair(-f, t, state);
        split_missing();
        // It may have survived: a segment was split far away.
        if (planar_[-f].has_triangle(t)) examine(-f, t);
      }
    }
  }

  // --- step 14: remove what is not needed --------------------------------------------------------------------------------------

  void clean_up() {
    for (bool again = true; again;) {
      again = false;
      for (int id = static_cast<int>(points_.size()) - 1; id >= static_cast<int>(complex_.vertices.size()); --id) {
        if (!alive_[id]) continue;
        progress_.at("removing points", static_cast<long>(complex_.vertices.size()) + steiner_);
        if (progress_.stop_requested(steiner_)) return;  // what stands is complete
        again |= try_remove(id);
      }
    }
  }

  bool try_remove(int id) {
    const bool on_segment = information_[id].kind == PointKind::edge;
    int a = -1, b = -1;
    std::size_t i = 0;
    SegmentId s = -1;
    if (on_segment) {
      s = information_[id].carrier;
      auto& stations = chains_[s].stations;
      while (stations[i].point != id) ++i;
      a = stations[i - 1].point;
      b = stations[i + 1].point;
    }
    std::vector<std::pair<FacetId, Triangle>> changed;
    for (FacetId f : facets_of(id))
      for (const Triangle& t : on_segment ? planar_[f].join(a, id, b) : planar_[f].remove(id)) changed.push_back({f, t});
    if (!flat_) tetrahedra_.remove(id);
    alive_[id] = 0;
    bool fine = true;
    if (on_segment && chains_[s].hanging()) fine = !hanging_encroached(a, b);
    if (fine && on_segment && !flat_ && !chains_[s].hanging()) fine = tetrahedra_.is_edge(a, b);
    for (std::size_t k = 0; k < changed.size() && fine; ++k) fine = test(changed[k].first, changed[k].second) == State::good;
    if (fine) {
      if (on_segment) {
        chains_[s].stations.erase(chains_[s].stations.begin() + static_cast<long>(i));
        segment_of_.erase(key(a, id));
        segment_of_.erase(key(id, b));
        segment_of_[key(a, b)] = s;
      }
      --steiner_;
      return true;
    }
    alive_[id] = 1;
    const int near = on_segment ? a : changed.empty() ? -1 : changed.front().second[0];
    if (!flat_) tetrahedra_.insert(id, point(id), near);
    for (FacetId f : facets_of(id)) {
      if (on_segment)
        planar_[f].split(a, b, id, point(id));
      else
        planar_[f].insert(id, point(id), near);
    }
    return false;
  }

  // --- result ------------------------------------------------------------------------------------------------------------------

  mpq_class offset_of(FacetId f, const Triangle& t, const Difference& normal) {
    if (flat_) return 0;
    auto face = tetrahedra_.face(t[0], t[1], t[2]);
    if (!face.exists) face = tetrahedra_.cocircular_face(t[0], t[1], t[2]);
    const Point &a = point(t[0]), &b = point(t[1]), &c = point(t[2]);
    std::optional<mpq_class> low, high;
    if (face.above >= 0) high = pencil_parameter(a, b, c, point(face.above), normal);
    if (face.below >= 0) low = pencil_parameter(a, b, c, point(face.below), normal);
    double size = 0;
    for (const auto& value : normal.vector) size = std::hypot(size, value.get_d());
    const mpq_class offset = choose_offset(low, high, circumradius(t) / std::ldexp(size, -normal.exponent));
    if ((low && offset <= *low) || (high && offset >= *high)) throw StrategyFailed("lean: a face is not strong (facet " + std::to_string(f) + ")");
    return offset;
  }

  Placement result() {
    Placement placement;
    std::vector<int> names(points_.size(), -1);
    for (std::size_t id = 0; id < points_.size(); ++id) {
      if (!alive_[id]) continue;
      names[id] = static_cast<int>(placement.points.size());
      placement.points.push_back({point(static_cast<int>(id)), information_[id].kind, information_[id].carrier});
    }
    for (std::size_t f = 0; f < planar_.size(); ++f) {
      const Difference normal = certificate_normal(complex_, complex_.facets[f]);
      for (const Triangle& t : planar_[f].triangles()) {
        mpq_class offset = offset_of(static_cast<FacetId>(f), t, normal);
        // t n is a length: in the input's coordinates n grows by 4^scale and lengths by 2^scale.
        if (complex_.scale >= 0)
          mpq_div_2exp(offset.get_mpq_t(), offset.get_mpq_t(), complex_.scale);
        else
          mpq_mul_2exp(offset.get_mpq_t(), offset.get_mpq_t(), -complex_.scale);
        placement.cells.push_back({static_cast<FacetId>(f), {names[t[0]], names[t[1]], names[t[2]]}, CellKind::C, -1, std::move(offset)});
      }
    }
    for (std::size_t s = 0; s < chains_.size(); ++s) {
      const auto& stations = chains_[s].stations;
      if (chains_[s].hanging())
        for (std::size_t i = 0; i + 1 < stations.size(); ++i)
          placement.hanging.push_back({static_cast<SegmentId>(s), names[stations[i].point], names[stations[i + 1].point]});
      if (stations.size() < 4) continue;  // a row has at least two points besides the vertices
      PlacedRow row{static_cast<SegmentId>(s), {}, {}};
      for (std::size_t i = 1; i + 1 < stations.size(); ++i) row.points.push_back(names[stations[i].point]);
      placement.rows.push_back(std::move(row));
    }
    return placement;
  }

  const Complex& complex_;
  const BufferSizes sizes_;
  const Limits& limits_;
  Progress& progress_;
  PointIndex index_;
  DelaunayTetrahedralization tetrahedra_;
  bool flat_ = false;
  long budget_ = 0, steiner_ = 0;
  double greatest_guard_ = 0;
  std::deque<Point> storage_;
  std::vector<const Point*> points_;
  std::vector<Information> information_;
  std::vector<char> alive_;
  std::vector<Chain> chains_;
  std::vector<std::vector<FacetId>> facets_of_vertex_, single_;
  std::unordered_map<std::uint64_t, SegmentId> segment_of_;
  std::vector<PlaneFrame> frames_;
  std::vector<Projection> projections_;
  std::vector<FacetTriangulation> planar_;
  std::array<int, 2> blocked_{-1, -1};
  std::vector<std::array<int, 2>> missing_;
  std::vector<std::pair<DelaunayTetrahedralization::Conflict, int>> pending_;
  std::vector<std::pair<FacetId, Triangle>> fresh_;
  std::priority_queue<std::tuple<double, int, int, int, int>> queue_;
};

}  // namespace

Placement place_lean(const Complex& complex, const Features& features, const Limits& limits, Progress& progress, LeanReport* report) {
  LeanReport ignored;
  LeanReport& told = report != nullptr ? *report : ignored;
  try {
    Lean lean(complex, features, limits, progress);
    Placement placement = lean.run(told);
    claim_conformity(placement);
    progress.estimated(static_cast<double>(placement.points.size()));
    return placement;
  } catch (const NeedsProtection& reason) {
    told.fell_back = true;
    told.reason = reason.what();
    return place_graded(complex, features, limits, progress);
  }
}

}  // namespace confidel
