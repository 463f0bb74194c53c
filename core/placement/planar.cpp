// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/placement/planar.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/numbers/angle.h"
#include "core/placement/circle.h"

namespace confidel {

namespace {

constexpr double pi = std::numbers::pi;
constexpr double hair = 0x1p-30;
// A run is refused before it begins when the estimate exceeds --max-points by this factor.
constexpr double estimate_margin = 1.5;

double approximate(const mpq_class& value) { return value.get_d(); }

RationalPoint2 rational(const Point& point) { return {rational_coordinate(point, 0), rational_coordinate(point, 1)}; }

class Planar {
 public:
  Planar(const Complex& complex, const Features& features, const PlanarOptions& options, const Limits& limits, Progress& progress)
      : complex_(complex), features_(features), options_(options), limits_(limits), progress_(progress) {
    for (const Point& vertex : complex.vertices) add(rational(vertex), PointKind::vertex, -1);
    sides_.resize(complex.segments.size());
    if (!complex.facets.empty()) {
      for (const auto& [a, c] : complex.facets[0].boundary) sides_[complex.find_segment(a, c)][a < c ? 0 : 1] = true;
      for (const auto& [a, c] : complex.facets[0].constraints) sides_[complex.find_segment(a, c)] = {true, true};
    }
  }

  Placement run() {
    if (complex_.segments.empty() && complex_.facets.empty()) return result();
    choose_angle_and_radius();
    place_ends();
    find_sectors();
    choose_spacing();
    if (const Sector* crossing = crossing_protectors()) return refuted(*crossing);
    estimate();
    subdivide();
    place_rows();
    place_arcs();
    fill();
    return result();
  }

 private:
  enum Side { left = 0, right = 1 };  // of a segment, from its first to its second vertex
  struct End {
    int projection = -1;
    std::array<int, 2> offset{-1, -1};  // by Side
  };
  struct Sector {
    VertexId vertex;
    int first = -1, last = -1;                    // points a at its two edges; -1: all around an isolated vertex
    int first_projection = -1, last_projection = -1;
    double start = 0, angle = 2 * pi;             // the remaining arc
    int parts = 0;
  };

  int add(RationalPoint2 position, PointKind kind, int carrier) {
    positions_.push_back(std::move(position));
    information_.push_back({kind, carrier});
    const long count = static_cast<long>(positions_.size());
    // The few points before the estimate are no reason to stop without one.
    if (estimated_ && limits_.max_points > 0 && count > limits_.max_points) throw LimitReached("max-points", count);
    if ((count & 255) == 0) {
      progress_.at("placing points", count);
      if (progress_.stop_requested(count)) throw LimitReached("stopped", count);
    }
    return static_cast<int>(count) - 1;
  }

  bool in_facet(SegmentId segment) const { return sides_[segment][left] || sides_[segment][right]; }

  double direction_angle(const RationalPoint2& from, const RationalPoint2& to) const {
    const RationalPoint2 d = to - from;
    return std::atan2(approximate(d[1]), approximate(d[0]));
  }

  void choose_angle_and_radius() {
    double delta = INFINITY, phi = pi / 4;
    for (const double distance : features_.vertex_distance) delta = std::min(delta, distance);
    for (const double distance : features_.segment_distance) delta = std::min(delta, distance);
    for (const auto& ends : features_.segment_angle) phi = std::min({phi, ends[0], ends[1]});
    if (!(phi > 1e-7)) throw StrategyFailed("an angle is below 1e-7 radians: too sharp for global parameters");
    phi_ = phi * (1 - hair);
    cosine_ = witness_of_angle(phi_ / options_.rule.angle_multiple);
    double radius = delta / 3;
    if (options_.greatest_circumradius) {
      const mpq_class bound = times_power_of_two(*options_.greatest_circumradius, -complex_.scale) * mpq_class(19, 10);
      radius = std::min(radius, approximate(bound));
    }
    if (!std::isfinite(radius)) radius = 1;  // nothing is near anything
    radius_ = rounded_down(radius * (1 - hair), 24);
    r_ = approximate(radius_);
    const double psi = phi_ / options_.rule.angle_multiple;
    beta_ = options_.rule.beta > 0 ? options_.rule.beta * psi : std::asin(2 * std::sin(options_.rule.chord * psi));
    beta_ *= 1 - 0x1p-20;
    bits_ = 24 + static_cast<int>(std::ceil(std::log2(1 / beta_)));
  }

  // Section 2.3: on the circle at the distance d_e from the edge, on both sides, and their projection; the far end by reflection.
  void place_ends() {
    ends_.resize(complex_.segments.size());
    for (SegmentId s = 0; s < static_cast<SegmentId>(complex_.segments.size()); ++s) {
      const auto& [a, b] = complex_.segments[s];
      const RationalPoint2 u = positions_[a], w = positions_[b];
      const RationalPoint2 near = u + radius_ * point_of_unit_circle(direction_angle(u, w) + beta_, bits_);
      const RationalPoint2 middle = projected(near, u, w);
      for (int end = 0; end < 2; ++end) {
        End& here = ends_[s][end];
        const RationalPoint2 m = end == 0 ? middle : reflected(middle, u, w), up = end == 0 ? near : reflected(near, u, w);
        here.projection = add(m, PointKind::projection, s);
        if (sides_[s][left]) here.offset[left] = add(up, PointKind::offset, 0);
        if (sides_[s][right]) here.offset[right] = add(mpq_class(2) * m - up, PointKind::offset, 0);
      }
    }
  }

  void find_sectors() {
    struct Spoke {
      SegmentId segment;
      int end;
      RationalPoint2 direction;
      bool upper;
    };
    std::vector<std::vector<Spoke>> spokes(complex_.vertices.size());
    for (SegmentId s = 0; s < static_cast<SegmentId>(complex_.segments.size()); ++s)
      for (int end = 0; end < 2 && in_facet(s); ++end) {
        const VertexId v = complex_.segments[s][end];
        const RationalPoint2 d = positions_[complex_.segments[s][1 - end]] - positions_[v];
        spokes[v].push_back({s, end, d, sgn(d[1]) > 0 || (sgn(d[1]) == 0 && sgn(d[0]) > 0)});
      }
    for (VertexId v = 0; v < static_cast<VertexId>(spokes.size()); ++v) {
      auto& around = spokes[v];
      std::sort(around.begin(), around.end(), [](const Spoke& x, const Spoke& y) {
        return x.upper != y.upper ? x.upper : cross(x.direction, y.direction) > 0;
      });
      for (std::size_t i = 0; i < around.size(); ++i) {
        const Spoke &first = around[i], &last = around[(i + 1) % around.size()];
        const int begin = ends_[first.segment][first.end].offset[first.end == 0 ? left : right];
        if (begin < 0) continue;  // outside the domain
        Sector sector{v};
        sector.first = begin;
        sector.last = ends_[last.segment][last.end].offset[last.end == 0 ? right : left];
        sector.first_projection = ends_[first.segment][first.end].projection;
        sector.last_projection = ends_[last.segment][last.end].projection;
        const RationalPoint2 x = positions_[sector.first] - positions_[v], y = positions_[sector.last] - positions_[v];
        sector.start = std::atan2(approximate(x[1]), approximate(x[0]));
        sector.angle = std::atan2(approximate(cross(x, y)), approximate(dot(x, y)));
        if (sector.angle <= 0) sector.angle += 2 * pi;
        sectors_.push_back(sector);
      }
    }
    if (!complex_.facets.empty())
      for (const VertexId v : complex_.facets[0].isolated) sectors_.push_back({v});
  }

  // L5, exactly. With the printed d_e at its maximum this happens wherever the smallest angle is phi.
  const Sector* crossing_protectors() const {
    for (const Sector& sector : sectors_) {
      if (sector.first < 0 || sector.first_projection == sector.last_projection) continue;
      const RationalPoint2& v = positions_[sector.vertex];
      if (sgn(cross(positions_[sector.first_projection] - v, positions_[sector.last_projection] - v)) > 0 &&
          sgn(cross(positions_[sector.first] - v, positions_[sector.last] - v)) <= 0)
        return &sector;
    }
    return nullptr;
  }

  // h: the printed chord of phi/2, or less where that leaves too little of an arc or of an edge; 2 r sin(phi*/12) repaired.
  void choose_spacing() {
    double h = 2 * r_ * std::sin(phi_ / options_.rule.angle_multiple * options_.rule.chord);
    if (options_.rule.fit) {
      h = std::min(h, r_ * std::sin(beta_));  // d_e >= h
      for (const Sector& sector : sectors_) h = std::min(h, 2 * r_ * std::sin(std::min(sector.angle, phi_) / 4));
    }
    set_spacing(h * (1 - hair));
  }

  void set_spacing(double h) {
    spacing_ = rounded_down(h, 30);
    const mpq_class cosine = cosine_of_multiple(options_.rule.chord, cosine_);
    while (spacing_ * spacing_ > 4 * radius_ * radius_ * (1 - cosine * cosine)) spacing_ *= mpq_class(4095, 4096);
    h_ = approximate(spacing_);
  }

  // The number of equal parts, each of a length in [h, 3h/2] with a hair to spare, or 0. length(k): one of k parts.
  template <class Length>
  int parts_of(double first_guess, const Length& length) const {
    for (int k = std::max(1, static_cast<int>(first_guess)); k <= static_cast<int>(first_guess) + 1; ++k) {
      const double part = length(k);
      if (part >= h_ * (1 + 1e-9) && part <= 1.5 * h_ * (1 - 1e-9)) return k;
    }
    return 0;
  }

  double row_length(SegmentId s) const {
    const RationalPoint2 d = positions_[ends_[s][1].projection] - positions_[ends_[s][0].projection];
    return std::sqrt(approximate(dot(d, d)));
  }

  bool try_to_subdivide() {
    for (Sector& sector : sectors_) {
      const double guess = sector.angle / (2 * std::asin(h_ / (2 * r_)));
      if (!(guess < 1e9)) throw LimitReached("max-points", static_cast<long>(positions_.size()));
      sector.parts = parts_of(guess, [&](int k) { return 2 * r_ * std::sin(sector.angle / (2 * k)); });
      if (sector.parts == 0) return false;
    }
    row_parts_.assign(complex_.segments.size(), 0);
    for (SegmentId s = 0; s < static_cast<SegmentId>(complex_.segments.size()); ++s) {
      const double length = row_length(s);
      if (!(length / h_ < 1e9)) throw LimitReached("max-points", static_cast<long>(positions_.size()));
      row_parts_[s] = parts_of(length / h_, [&](int k) { return length / k; });
      if (row_parts_[s] == 0) return false;
    }
    return true;
  }

  // "h or smaller": one that divides every arc and row with a hair to spare on both ends of [h, 3h/2].
  void subdivide() {
    for (int tries = 0; !try_to_subdivide(); ++tries) {
      if (tries == 2000) throw StrategyFailed("no spacing divides all arcs and edges");
      set_spacing(h_ * 0.999);
    }
  }

  void estimate() {
    double points = static_cast<double>(positions_.size());
    for (const Sector& sector : sectors_) points += sector.angle * r_ / h_;
    for (SegmentId s = 0; s < static_cast<SegmentId>(complex_.segments.size()); ++s)
      points += row_length(s) / h_ * (1.0 + sides_[s][left] + sides_[s][right]);
    double area = 0;
    for (const Facet& facet : complex_.facets)
      for (const auto& [a, c] : facet.boundary) area += approximate(cross(positions_[a], positions_[c])) / 2;
    // Measured: Chew's rule with the threshold (17/16) h leaves one point for 1.76 h^2; planar_test holds the estimate within a factor of 2.
    points += area / (1.76 * h_ * h_);
    progress_.estimated(points);
    estimated_ = true;
    if (limits_.max_points > 0 && points > estimate_margin * static_cast<double>(limits_.max_points))
      throw LimitReached("max-points", static_cast<long>(positions_.size()));
  }

  void cell(int a, int b, int c, CellKind kind, int box = -1) { placement_.cells.push_back({0, {a, b, c}, kind, box, {}}); }

  void place_rows() {
    for (SegmentId s = 0; s < static_cast<SegmentId>(complex_.segments.size()); ++s) {
      const auto& [u, w] = complex_.segments[s];
      const std::array<End, 2>& ends = ends_[s];
      const RationalPoint2 begin = positions_[ends[0].projection];
      const RationalPoint2 step = mpq_class(1, row_parts_[s]) * (positions_[ends[1].projection] - begin);
      PlacedRow row;
      row.segment = s;
      row.points.push_back(ends[0].projection);
      for (int i = 1; i < row_parts_[s]; ++i) row.points.push_back(add(begin + mpq_class(i) * step, PointKind::edge, s));
      row.points.push_back(ends[1].projection);
      for (const Side side : {left, right}) {
        if (!sides_[s][side]) continue;
        const RationalPoint2 offset = positions_[ends[0].offset[side]] - begin;
        PlacedRow::Protector protector{0, side == left, {ends[0].offset[side]}};
        for (int i = 1; i < row_parts_[s]; ++i) protector.points.push_back(add(positions_[row.points[i]] + offset, PointKind::offset, 0));
        protector.points.push_back(ends[1].offset[side]);
        add_buffer_cells(row, protector);
        row.protectors.push_back(std::move(protector));
      }
      if (row.protectors.empty()) {
        placement_.hanging.push_back({s, u, row.points.front()});
        for (std::size_t i = 1; i < row.points.size(); ++i) placement_.hanging.push_back({s, row.points[i - 1], row.points[i]});
        placement_.hanging.push_back({s, row.points.back(), w});
      }
      placement_.rows.push_back(std::move(row));
    }
  }

  void add_buffer_cells(const PlacedRow& row, const PlacedRow::Protector& protector) {
    const auto& [u, w] = complex_.segments[row.segment];
    const std::vector<int>&x = row.points, &q = protector.points;
    if (protector.left) {
      cell(u, x.front(), q.front(), CellKind::T);
      cell(w, q.back(), x.back(), CellKind::T);
    } else {
      cell(u, q.front(), x.front(), CellKind::T);
      cell(w, x.back(), q.back(), CellKind::T);
    }
    for (std::size_t i = 0; i + 1 < x.size(); ++i, ++boxes_) {
      const std::size_t near = protector.left ? i : i + 1, far = protector.left ? i + 1 : i;
      cell(x[near], x[far], q[far], CellKind::R, boxes_);
      cell(x[near], q[far], q[near], CellKind::R, boxes_);
      outline_.push_back({q[i], q[i + 1]});
    }
  }

  void place_arcs() {
    for (const Sector& sector : sectors_) {
      const RationalPoint2 centre = positions_[sector.vertex];
      const auto arc_point = [&](int i) {
        const double angle = sector.start + sector.angle * i / sector.parts;
        return add(centre + radius_ * point_of_unit_circle(angle, bits_ + 8), PointKind::arc, 0);
      };
      std::vector<int> points{sector.first >= 0 ? sector.first : arc_point(0)};
      for (int i = 1; i < sector.parts; ++i) points.push_back(arc_point(i));
      points.push_back(sector.first >= 0 ? sector.last : points.front());
      for (std::size_t i = 0; i + 1 < points.size(); ++i) {
        cell(sector.vertex, points[i], points[i + 1], CellKind::S);
        outline_.push_back({points[i], points[i + 1]});
      }
    }
  }

  void fill() {
    if (outline_.empty()) return;
    RationalRegion region;
    std::vector<int> points, vertex_of(positions_.size(), -1);
    int near = -1;
    const auto vertex = [&](int point) {
      if (vertex_of[point] < 0) {
        vertex_of[point] = region.insert(positions_[point], near);
        points.push_back(point);
      }
      return near = vertex_of[point];
    };
    for (const auto& [a, b] : outline_) {
      const int from = vertex(a);
      region.constrain(from, vertex(b));
    }
    region.mark();
    const int boundary = region.vertex_count();
    const int bits = static_cast<int>(std::ceil(std::log2(64 / h_))) + 1;
    const mpq_class threshold = mpq_class(289, 256) * spacing_ * spacing_;
    const long others = static_cast<long>(positions_.size()) - boundary;
    const auto steps = region.refine(threshold, bits, [&](long vertices) {
      if (limits_.max_points > 0 && others + vertices > limits_.max_points) throw LimitReached("max-points", others + vertices);
      if ((vertices & 255) == 0) {
        progress_.at("Chew's refinement", others + vertices);
        if (progress_.stop_requested(others + vertices)) throw LimitReached("stopped", others + vertices);
      }
      return false;
    });
    for (const auto& step : steps) {
      points.push_back(add(region.point(step.vertex), PointKind::interior, 0));
      placement_.insertions.push_back({0, {points[step.corners[0]], points[step.corners[1]], points[step.corners[2]]}, points.back()});
    }
    for (const auto& [a, b, c] : region.triangles()) cell(points[a], points[b], points[c], CellKind::C);
  }

  void state_parameters() {
    const mpq_class unit = times_power_of_two(1, complex_.scale);
    Parameters& parameters = placement_.parameters;
    parameters.radius = radius_ * unit;
    parameters.spacing = spacing_ * unit;
    parameters.angle_multiple = options_.rule.angle_multiple;
    parameters.angle_cosine = cosine_;
    if (options_.rule.beta > 0) parameters.beta = options_.rule.beta;
    else parameters.offset = options_.rule.chord;
    parameters.chord = options_.rule.chord;
    parameters.greatest_circumradius = options_.greatest_circumradius;
  }

  Placement result() {
    const mpq_class unit = times_power_of_two(1, complex_.scale);
    for (std::size_t i = 0; i < positions_.size(); ++i) {
      const RationalPoint2& p = positions_[i];
      const Point position = i < complex_.vertices.size() ? complex_.vertices[i] : Point::from_doubles(approximate(p[0]), approximate(p[1]), 0);
      placement_.points.push_back({position, information_[i].kind, information_[i].carrier});
      placement_.rational_positions.push_back({p[0] * unit, p[1] * unit, 0});
    }
    if (h_ > 0) {
      state_parameters();
      placement_.claims = {"H-angle", "H-ball", "H-offset", "H-chord", "L1", "L2", "L3", "L4", "L5", "L6", "L7", "L8", "L9", "L10", "L11", "L13", "L14", "L16", "L17", "L18", "L18b", "L19"};
      if (options_.greatest_circumradius) placement_.claims.push_back("L20");
      placement_.claims.insert(placement_.claims.end(), {"L21", "L22", "L23"});
    }
    return std::move(placement_);
  }

  // The two T cells whose protectors cross, and the power of the second edge's projection point with respect to the first cell.
  Placement refuted(const Sector& sector) {
    const std::array<int, 4> witness{sector.first_projection, sector.first, sector.last, sector.last_projection};
    const RationalPoint2 v = positions_[sector.vertex], a = positions_[sector.first], m = positions_[sector.last_projection];
    const mpq_class unit = times_power_of_two(1, complex_.scale);
    const int count = static_cast<int>(complex_.vertices.size());
    std::vector<RationalPoint2> kept(positions_.begin(), positions_.begin() + count);
    std::vector<Information> kinds(information_.begin(), information_.begin() + count);
    for (const int point : witness) {
      kept.push_back(positions_[point]);
      kinds.push_back(information_[point]);
    }
    positions_ = std::move(kept);
    information_ = std::move(kinds);
    cell(sector.vertex, count, count + 1, CellKind::T);
    cell(sector.vertex, count + 2, count + 3, CellKind::T);
    placement_.refutation = Refutation{"L5", {0, 1}, {}, {unit * unit * dot(m - v, m - a)}};
    Placement placement = result();
    placement.claims = {"H-angle", "H-ball", "H-offset", "H-chord", "L1", "L21"};
    return placement;
  }

  struct Information {
    PointKind kind;
    int carrier;
  };

  const Complex& complex_;
  const Features& features_;
  const PlanarOptions& options_;
  const Limits& limits_;
  Progress& progress_;
  std::vector<RationalPoint2> positions_;  // in working coordinates
  std::vector<Information> information_;
  std::vector<std::array<bool, 2>> sides_;  // per segment, by Side: is the domain there
  std::vector<std::array<End, 2>> ends_;
  std::vector<Sector> sectors_;
  std::vector<int> row_parts_;
  std::vector<std::array<int, 2>> outline_;
  double phi_ = 0, beta_ = 0, r_ = 0, h_ = 0;
  mpq_class cosine_, radius_, spacing_;
  int bits_ = 0, boxes_ = 0;
  bool estimated_ = false;
  Placement placement_;
};

}  // namespace

Placement place_planar(const Complex& complex, const Features& features, const PlanarOptions& options, const Limits& limits, Progress& progress) {
  return Planar(complex, features, options, limits, progress).run();
}

}  // namespace confidel
