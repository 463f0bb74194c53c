// SPDX-License-Identifier: GPL-3.0-or-later
// The paper's constants and points as algebraic numbers. For one translation unit: algebraic_instance.cpp.
#pragma once

#include <numeric>

#include "proofs/lemmas/algebraic_number.h"
#include "proofs/lemmas/projections.h"

namespace confidel::algebraic {

/// The constants, in the input's coordinates.
struct Sizes {
  mpq_class squared_radius;  ///< r^2
  mpq_class squared_cosine;  ///< cos^2 phi', phi' <= phi; phi' is acute
  Number radius, offset, reach, spacing, chord;  ///< r, d, r cos(beta), h, the chord that bounds h
  Number squared_spacing, squared_chord;         ///< in fewer roots than the squares of these
  Angle beta, step;                              ///< step: that of the chord h
  std::optional<std::array<mpq_class, 2>> parts;  ///< of phi: beta and step, where they are that
  bool exact_spacing = true;
  std::vector<std::pair<std::string, std::string>> description;
};

/// 15 degrees * part / 2^halvings, below 360 degrees, in as few roots as it takes: what a sign costs grows with the products in it.
inline Angle constructed_from_fifteen(long part, int halvings, Roots& roots) {
  for (; halvings > 0 && part % 2 == 0; part /= 2) --halvings;
  const Number two = roots.root(mpq_class(1, 2)), three = roots.root(3);
  const auto cosine = [&](long k) -> Number {  // of 15 k degrees
    k = std::abs(k) % 24;
    if (k > 12) k = 24 - k;
    const int sign = k > 6 ? -1 : 1;
    if (k > 6) k = 12 - k;
    const Number values[] = {Number(1), two * (three + 1) / 2, three / 2, two, number(mpq_class(1, 2)), two * (three - 1) / 2, Number(0)};
    return sign * values[k];
  };
  Angle angle{cosine(part), cosine(part - 6)};
  double degrees = 15.0 * static_cast<double>(part);
  for (; halvings > 0; --halvings) {
    degrees /= 2;
    const Number root = CORE::sqrt((1 + angle.cosine) / 2);
    const double turn = std::fmod(degrees, 360);
    const Number half = turn < 90 || turn > 270 ? root : -root;
    angle = {half, angle.sine / (2 * half)};
  }
  return angle;
}

/// phi * part, by square roots, where that is possible.
inline std::optional<Angle> constructed(const mpq_class& squared_cosine_of_phi, const mpq_class& part, Roots& roots) {
  long divisor = part.get_den().get_si();
  const long multiple = part.get_num().get_si();
  int halvings = 0;
  for (; divisor % 2 == 0; divisor /= 2) ++halvings;
  const bool eighth = squared_cosine_of_phi == mpq_class(1, 2);
  if (eighth && (divisor == 1 || divisor == 3)) return constructed_from_fifteen(multiple * 3 / divisor, halvings, roots);
  Angle angle;
  if (divisor == 1) {
    angle = {roots.root(squared_cosine_of_phi), roots.root(1 - squared_cosine_of_phi)};
  } else if (eighth && divisor == 5) {
    const Number five = roots.root(5);  // 9 degrees: half of 18
    angle = half({CORE::sqrt(10 + 2 * five) / 4, (five - 1) / 4});
  } else {
    return {};
  }
  for (; halvings > 0; --halvings) angle = half(angle);
  Angle result = angle;
  for (long i = multiple; i > 1; --i) result = sum(result, angle);
  return result;
}

/// cos^2 of the least angle that the rule counts, and which one it is; at most pi/4.
inline std::pair<mpq_class, std::string> least_angle(const Instance& instance, bool facet_angles) {
  std::pair<mpq_class, std::string> least{mpq_class(1, 2), "pi/4"};
  const auto offer = [&](const mpq_class& square, const std::string& what) {
    if (square > least.first) least = {square, what};
  };
  for (VertexId v = 0; v < instance.vertex_count; ++v)
    for (const SegmentId e : instance.segments_at(v)) {
      const RationalVector u = confidel::minus(instance.positions[instance.other_end(e, v)], instance.positions[v]);
      for (const SegmentId other : instance.segments_at(v)) {
        if (other <= e) continue;
        const RationalVector w = confidel::minus(instance.positions[instance.other_end(other, v)], instance.positions[v]);
        const mpq_class product = confidel::dot(u, w);
        if (product > 0) offer(square(product) / (squared(u) * squared(w)), fmt::format("the angle of segments {} and {}", e, other));
      }
      if (!facet_angles) continue;
      for (const FacetId facet : instance.facets_at(v))
        if (!instance.on_boundary_or_constraint(facet, e) && cell_below(instance, v, facet, u) >= 0)
          offer(1 - squared_sine(instance, facet, u), fmt::format("the angle of segment {} and facet {}", e, facet));
    }
  return least;
}

/// sign and square of the greatest cosine of a dihedral angle; -1 (no angle below pi) if there is none.
inline mpq_class greatest_signed_square(const Instance& instance) {
  std::vector<std::vector<RationalVector>> at(instance.segments.size());
  for (std::size_t f = 0; f < instance.facets.size(); ++f) {
    const auto add = [&](VertexId a, VertexId c) {
      at[instance.find_segment(a, c)].push_back(confidel::cross(instance.normal(static_cast<FacetId>(f)), confidel::minus(instance.positions[c], instance.positions[a])));
    };
    for (const auto& [a, c] : instance.facets[f].boundary) add(a, c);
    for (const auto& [a, c] : instance.facets[f].constraints) {
      add(a, c);
      add(c, a);
    }
  }
  mpq_class greatest = -1;
  for (const auto& sheets : at)
    for (std::size_t i = 0; i < sheets.size(); ++i)
      for (std::size_t j = i + 1; j < sheets.size(); ++j) {
        const mpq_class product = confidel::dot(sheets[i], sheets[j]);
        greatest = std::max(greatest, mpq_class(sgn(product) * square(product) / (squared(sheets[i]) * squared(sheets[j]))));
      }
  return greatest;
}

/// From the rational strategy's instance: its separation (exact by L21), its angle's witness where roots do not do.
inline Sizes exact_sizes(const Instance& rational, const GlobalRule& rule, Roots& roots) {
  Sizes sizes;
  const LemmaResult separation = evaluate(find_lemma("L21"), rational);
  if (!separation.slack || !separation.slack->exact) throw StrategyFailed(rule.name + ": no two parts of the input are disjoint");
  sizes.squared_radius = (*separation.slack->exact + 1) * square(*rational.parameters.radius);
  sizes.radius = roots.root(sizes.squared_radius);
  sizes.description.emplace_back("r", fmt::format("{:.9g} = delta/3: exact", sizes.radius.doubleValue()));

  const auto [squared_cosine, what] = least_angle(rational, rule.facet_angles);
  const auto part = [&](int multiple) {
    mpq_class result(multiple, rule.angle_multiple);
    result.canonicalize();
    return result;
  };
  const mpq_class chord_part = part(rule.chord), beta_part = part(rule.beta > 0 ? rule.beta : rule.chord);
  std::optional<Angle> chord = constructed(squared_cosine, chord_part, roots), beta = constructed(squared_cosine, beta_part, roots);
  const double phi = std::asin(std::sqrt(mpq_class(1 - squared_cosine).get_d())) * 45 / std::atan(1.0);
  if (chord && beta) {
    sizes.squared_cosine = squared_cosine;
    sizes.description.emplace_back("phi", fmt::format("{:.9g} degrees = {}: exact", phi, what));
  } else {
    // An angle that roots do not divide: the rational strategy's, whose cosine is rational.
    const mpq_class& cosine = rational.parameters.angle_cosine;
    const auto multiple = [&](int j) {
      const mpq_class c = cosine_of_multiple(j, cosine);
      return Angle{number(c), roots.root(1 - square(c))};
    };
    chord = multiple(rule.chord);
    if (rule.beta > 0) beta = multiple(rule.beta);
    sizes.squared_cosine = square(cosine_of_multiple(rule.angle_multiple, cosine));
    sizes.description.emplace_back("phi", fmt::format("{:.9g} degrees = {}; of this the rational strategy's multiple of an angle with a rational cosine, at most 2^-30 less", phi, what));
  }
  sizes.chord = 2 * sizes.radius * chord->sine;
  const std::optional<Angle> twice_chord = sizes.squared_cosine == squared_cosine ? constructed(squared_cosine, 2 * chord_part, roots) : sum(*chord, *chord);
  sizes.squared_chord = number(2 * sizes.squared_radius) * (1 - twice_chord->cosine);
  if (rule.beta > 0) {
    sizes.beta = *beta;
    sizes.offset = sizes.radius * beta->sine;
    sizes.reach = sizes.radius * beta->cosine;
    sizes.description.emplace_back("d", fmt::format("{:.9g} = r sin({} phi)", sizes.offset.doubleValue(), beta_part.get_str()));
  } else {
    sizes.offset = sizes.chord;
    sizes.reach = CORE::sqrt(sizes.radius * sizes.radius - sizes.offset * sizes.offset);
    sizes.beta = {sizes.reach / sizes.radius, sizes.offset / sizes.radius};
    sizes.description.emplace_back("d", fmt::format("{:.9g} = 2 r sin({} phi)", sizes.offset.doubleValue(), chord_part.get_str()));
  }

  sizes.spacing = sizes.chord;
  bool by_chord = true;
  std::string which = fmt::format("2 r sin({} phi)", chord_part.get_str());
  const mpq_class greatest = greatest_signed_square(rational), share = rule.fit ? mpq_class(1) : mpq_class(2, 3);
  if (greatest > -1) {
    const Number cosine = sgn(greatest) * roots.root(abs(greatest));
    const Number base = number(share) * sizes.offset * CORE::sqrt(2 * (1 - cosine));
    if (exact_sign(base - sizes.spacing) < 0) {
      sizes.spacing = base;
      by_chord = false;
      which = share == 1 ? "d_f" : "(2/3) d_f";
    }
  }
  if (rule.fit && exact_sign(sizes.offset - sizes.spacing) < 0) {
    sizes.spacing = sizes.offset;
    by_chord = false;
    which = "d";
  }
  // What arcs and rows can be divided into: quotients of angles, no roots.
  if (rule.fit && rational.parameters.spacing->get_d() < sizes.spacing.doubleValue() * (1 - 3e-6)) {
    sizes.spacing = number(*rational.parameters.spacing);
    sizes.exact_spacing = by_chord = false;
    which = "what arcs and rows can be divided into: the rational strategy's";
  }
  sizes.description.emplace_back("h", fmt::format("{:.9g} = {}{}", sizes.spacing.doubleValue(), which, sizes.exact_spacing ? ": exact" : ""));
  if (by_chord) {
    sizes.squared_spacing = sizes.squared_chord;
    sizes.step = *twice_chord;
    if (sizes.squared_cosine == squared_cosine && rule.beta > 0) sizes.parts = {beta_part, 2 * chord_part};
  } else {
    sizes.squared_spacing = sizes.spacing * sizes.spacing;
    const Number quotient = sizes.spacing / sizes.radius;
    sizes.step = {1 - quotient * quotient / 2, quotient * CORE::sqrt(1 - quotient * quotient / 4)};
  }
  return sizes;
}

/// Unit vectors of the input, and turns in its facets.
class Directions {
 public:
  Directions(const Instance& instance, const Sizes& sizes, Roots& roots) : instance_(instance), sizes_(sizes), roots_(roots) {}

  Vector unit(const RationalVector& u) { return times(roots_.root(1 / squared(u)), vector(u)); }
  /// In the facet, to the left of u.
  Vector left(FacetId facet, const RationalVector& u) {
    const RationalVector& n = instance_.normal(facet);
    return times(roots_.root(1 / squared(n)) * roots_.root(1 / squared(u)), vector(confidel::cross(n, u)));
  }
  RationalVector along(SegmentId segment, VertexId from) const {
    return confidel::minus(instance_.positions[instance_.other_end(segment, from)], instance_.positions[from]);
  }
  /// Where a facet's circles begin at vertices without segments of the facet.
  RationalVector frame_direction(FacetId facet) const {
    return confidel::minus(instance_.positions[instance_.facets[facet].frame[1]], instance_.positions[instance_.facets[facet].frame[0]]);
  }
  Vector turned(const Angle& angle, const Vector& x, const Vector& y) const { return plus(times(angle.cosine, x), times(angle.sine, y)); }
  /// beta + i step, or i step.
  const Angle& multiple(bool from_beta, std::size_t i) {
    auto& list = multiples_[from_beta ? 1 : 0];
    while (list.size() <= i) {
      const auto k = static_cast<long>(list.size());
      if (sizes_.parts)
        list.push_back(k == 0 && !from_beta ? Angle{1, 0} : *constructed(sizes_.squared_cosine, (from_beta ? (*sizes_.parts)[0] : mpq_class(0)) + k * (*sizes_.parts)[1], roots_));
      else
        list.push_back(k > 0 ? sum(list.back(), sizes_.step) : from_beta ? sizes_.beta : Angle{1, 0});
    }
    return list[i];
  }

  /// Spacing::Reaches, exactly. Pre: it is nearly so.
  bool reaches(FacetId facet, VertexId vertex, SegmentId first, SegmentId last, int count) {
    if (first < 0) return exact_sign(multiple(false, count).sine) <= 0;
    const RationalVector u = along(first, vertex), w = along(last, vertex);
    const Vector end = turned(multiple(true, count), unit(u), left(facet, u));
    const Vector protector = turned({sizes_.beta.cosine, -sizes_.beta.sine}, unit(w), left(facet, w));
    return exact_sign(dot(vector(instance_.normal(facet)), cross(end, protector))) >= 0;
  }

 private:
  const Instance& instance_;
  const Sizes& sizes_;
  Roots& roots_;
  std::array<std::vector<Angle>, 2> multiples_;
};

/// The points of the arc of an opening cell, from protector to protector. Pre: its fan is closed.
inline std::vector<int> arc_of(const Instance& instance, const EndCell& opening) {
  const int last = instance.end_cells[instance.closing_cell(opening)].a;
  std::vector<int> arc{opening.a};
  while (arc.back() != last)
    for (const int corner : instance.cells[instance.cell_with_edge(instance.cells[opening.cell].facet, opening.v, arc.back())].corners)
      if (corner != opening.v && corner != arc.back()) {
        arc.push_back(corner);
        break;
      }
  return arc;
}

/// The exact points of an instance whose positions are rounded ones: those that the strategy puts at algebraic places are put there, the
/// others (vertices, and points within facets, which Chew's refinement rounds) stay.
class Points {
 public:
  Points(const Instance& instance, const Sizes& sizes, Roots& roots, Directions& directions) : instance_(instance), sizes_(sizes), roots_(roots), directions_(directions), done_(instance.positions.size(), 0) {
    for (const RationalVector& position : instance.positions) exact.push_back(vector(position));
    place_rows();
    place_offsets();
    place_arcs();
    for (const EndCell& end : instance.end_cells)
      if (end.opens && instance.closing_cell(end) >= 0) divide_by_steps(end);
    for (std::size_t f = 0; f < instance.facets.size(); ++f)
      for (const VertexId v : instance.facets[f].isolated) divide_circle(static_cast<FacetId>(f), v);
  }

  std::vector<Vector> exact;
  /// Points on the sphere of a vertex: (p - v)/r, the same number in fewer roots.
  struct OnSphere {
    VertexId vertex;
    Vector direction;
  };
  std::map<int, OnSphere> on_sphere;

 private:
  void put_on_sphere(int id, VertexId v, Vector direction) {
    put(id, plus(exact[v], times(sizes_.radius, direction)));
    on_sphere.insert_or_assign(id, OnSphere{v, std::move(direction)});
  }
  const RationalVector& at(int id) const { return instance_.positions[id]; }
  RationalVector difference(int to, int from) const { return confidel::minus(at(to), at(from)); }
  Vector unit(const RationalVector& u) { return directions_.unit(u); }
  Vector left(FacetId facet, const RationalVector& u) { return directions_.left(facet, u); }
  RationalVector direction(SegmentId segment, VertexId from) const { return directions_.along(segment, from); }
  void put(int id, Vector position) {
    exact[id] = std::move(position);
    done_[id] = 1;
  }
  Vector foot(SegmentId segment, VertexId vertex) { return plus(exact[vertex], times(sizes_.reach, unit(direction(segment, vertex)))); }
  VertexId nearer_end(int id, SegmentId segment) const {
    const auto& [a, b] = instance_.segments[segment];
    return squared(difference(id, a)) < squared(difference(id, b)) ? a : b;
  }

  void place_rows() {
    for (std::size_t id = instance_.vertex_count; id < exact.size(); ++id)
      if (instance_.kinds[id] == PointKind::projection) {
        const SegmentId segment = instance_.carriers[id];
        put(static_cast<int>(id), foot(segment, nearer_end(static_cast<int>(id), segment)));
      }
    for (const PlacedRow& row : instance_.rows) {
      const auto& [a, b] = instance_.segments[row.segment];
      const RationalVector along = difference(b, a);
      const bool begins = done_[row.points.front()] != 0, ends = done_[row.points.back()] != 0;
      const long count = static_cast<long>(row.points.size()) - 1 + (begins ? 0 : 1) + (ends ? 0 : 1);
      const Number length = roots_.root(squared(along));
      const Number first = begins ? sizes_.reach : Number(0), last = ends ? length - sizes_.reach : length;
      const Vector direction = unit(along);
      for (std::size_t k = 0; k < row.points.size(); ++k) {
        if (done_[row.points[k]] != 0) continue;
        const long i = static_cast<long>(k) + (begins ? 0 : 1);
        put(row.points[k], plus(exact[a], times((Number(count - i) * first + Number(i) * last) / Number(count), direction)));
      }
    }
  }

  void place_offsets() {
    for (const EndCell& end : instance_.end_cells) {
      if (done_[end.a] != 0) continue;
      const RationalVector u = direction(instance_.carriers[end.m], end.v);
      const Number d = end.opens ? sizes_.offset : -sizes_.offset;
      const Vector across = left(instance_.cells[end.cell].facet, u);
      put(end.a, plus(exact[end.m], times(d, across)));
      on_sphere.insert_or_assign(end.a, OnSphere{end.v, directions_.turned({sizes_.beta.cosine, end.opens ? sizes_.beta.sine : -sizes_.beta.sine}, unit(u), across)});
    }
    for (const BoxCells& box : instance_.boxes) {
      const auto& [p, q, x, y] = box.corners;
      const Vector across = times(sizes_.offset, left(instance_.cells[box.cells[0]].facet, difference(q, p)));
      if (done_[x] == 0) put(x, plus(exact[q], across));
      if (done_[y] == 0) put(y, plus(exact[p], across));
    }
  }

  void place_arcs() {
    for (const SpokeCell& spoke : instance_.spoke_cells)
      for (const int id : {spoke.p, spoke.q}) {
        if (done_[id] != 0) continue;
        const FacetId facet = instance_.cells[spoke.cell].facet;
        if (instance_.kinds[id] == PointKind::arc)
          put_on_sphere(id, spoke.v, on_circle(facet, spoke.v, id));
        else
          put(id, lonely_offset(facet, spoke.v, id));
      }
  }

  /// On the unit circle, at the angle of the rounded point.
  Vector on_circle(FacetId facet, VertexId v, int id) {
    RationalVector u = directions_.frame_direction(facet);
    for (const SegmentId segment : instance_.segments_at(v))
      if (instance_.on_boundary_or_constraint(facet, segment)) u = direction(segment, v);
    const RationalVector w = confidel::cross(instance_.normal(facet), u), from = difference(id, v);
    const double x = confidel::dot(from, u).get_d() / std::sqrt(squared(u).get_d()), y = confidel::dot(from, w).get_d() / std::sqrt(squared(w).get_d());
    const auto [cosine, sine] = rational_direction(std::atan2(y, x));
    return directions_.turned({number(cosine), number(sine)}, unit(u), left(facet, u));
  }

  /// A refutation may have a spoke without the T cell next to it.
  Vector lonely_offset(FacetId facet, VertexId v, int id) {
    std::optional<Vector> nearest;
    double least = 0;
    for (const SegmentId segment : instance_.segments_at(v)) {
      if (!instance_.on_boundary_or_constraint(facet, segment)) continue;
      for (const int side : {1, -1}) {
        Vector candidate = plus(foot(segment, v), times(side * sizes_.offset, left(facet, direction(segment, v))));
        double distance = 0;
        for (int axis = 0; axis < 3; ++axis) distance += std::pow(candidate[axis].doubleValue() - at(id)[axis].get_d(), 2);
        if (nearest && distance >= least) continue;
        least = distance;
        nearest = std::move(candidate);
      }
    }
    if (!nearest) throw StrategyFailed("an offset point that belongs to no segment");
    return *nearest;
  }

  bool steps(double angle, std::size_t count) const {
    const double step = std::atan2(sizes_.step.sine.doubleValue(), sizes_.step.cosine.doubleValue());
    return count <= greatest_steps && std::abs(angle / step - static_cast<double>(count)) < 1e-6;
  }

  /// An arc that is as long as its chords of h, or (by less than a millionth) longer: gets them, the last one is what is left. Other arcs
  /// have chords that are equal but for the rounding of their angles, as roots do not divide them.
  void divide_by_steps(const EndCell& opening) {
    const std::vector<int> arc = arc_of(instance_, opening);
    const std::size_t count = arc.size() - 1;
    double angle = 0;
    for (std::size_t i = 0; i < count; ++i)
      angle += 2 * std::asin(std::min(1.0, std::sqrt(squared(difference(arc[i + 1], arc[i])).get_d() / sizes_.squared_radius.get_d()) / 2));
    if (!steps(angle, count)) return;
    const RationalVector u = direction(instance_.carriers[opening.m], opening.v);
    const Vector x = unit(u), y = left(instance_.cells[opening.cell].facet, u);
    for (std::size_t i = 1; i < count; ++i) put_on_sphere(arc[i], opening.v, directions_.turned(directions_.multiple(true, i), x, y));
  }

  /// The same for the circle around a vertex that lies alone in its facet.
  void divide_circle(FacetId facet, VertexId v) {
    const RationalVector u = directions_.frame_direction(facet), w = confidel::cross(instance_.normal(facet), u);
    const double turn = 8 * std::atan(1.0), ratio = std::sqrt(squared(w).get_d() / squared(u).get_d());
    std::map<double, int> circle;  // by angle
    for (const SpokeCell& spoke : instance_.spoke_cells) {
      if (spoke.v != v || instance_.cells[spoke.cell].facet != facet) continue;
      const RationalVector from = difference(spoke.p, v);
      const double angle = std::atan2(confidel::dot(from, w).get_d() / ratio, confidel::dot(from, u).get_d());
      circle[angle < -1e-6 ? angle + turn : angle] = spoke.p;
    }
    if (!steps(turn, circle.size())) return;
    std::size_t i = 0;
    for (const auto& [angle, id] : circle) put_on_sphere(id, v, directions_.turned(directions_.multiple(false, i++), unit(u), left(facet, u)));
  }

  static constexpr std::size_t greatest_steps = 64;  // beyond, the products are long
  const Instance& instance_;
  const Sizes& sizes_;
  Roots& roots_;
  Directions& directions_;
  std::vector<char> done_;
};

}  // namespace confidel::algebraic
