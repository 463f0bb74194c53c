// SPDX-License-Identifier: GPL-3.0-or-later
// One translation unit with its headers, because CORE is slow to compile.
#include "proofs/lemmas/algebraic_instance.h"

#include <algorithm>

#include "proofs/lemmas/algebraic_statements.h"

namespace confidel {
namespace {

using namespace algebraic;

// The points are replaced by exact ones: no room for roundings, which are only to keep the combinatorics.
GlobalRule without_rounding(GlobalRule rule, const GlobalSizes& sizes) {
  rule.sizes = sizes;
  rule.least_share = 1;
  rule.fit = false;
  rule.claims = {"L8"};
  rule.eta = 0x1p-30 + 0x1p-40;
  rule.rounding = 0x1p-45;
  return rule;
}

/// Triangles of P'' that are Delaunay by the rounded points but not by the exact ones: flips, until there are none.
bool flip(const Kernel& kernel, std::vector<PlacedCell>& cells) {
  bool any = false, again = true;
  while (again) {
    again = false;
    std::map<std::array<int, 3>, int> edges;  // facet and directed edge
    for (std::size_t c = 0; c < cells.size(); ++c)
      for (int k = 0; k < 3; ++k) edges[{cells[c].facet, cells[c].corners[k], cells[c].corners[(k + 1) % 3]}] = static_cast<int>(c);
    std::vector<char> touched(cells.size(), 0);
    for (std::size_t c = 0; c < cells.size(); ++c)
      for (int k = 0; k < 3 && touched[c] == 0 && cells[c].kind == CellKind::C; ++k) {
        const int a = cells[c].corners[k], b = cells[c].corners[(k + 1) % 3], x = cells[c].corners[(k + 2) % 3];
        const auto other = edges.find({cells[c].facet, b, a});
        if (a > b || other == edges.end() || cells[other->second].kind != CellKind::C || touched[other->second] != 0) continue;
        int y = -1;
        for (const int corner : cells[other->second].corners)
          if (corner != a && corner != b) y = corner;
        if (CellSphere(kernel, cells[c].corners).power(y).sign >= 0) continue;
        cells[c].corners = {x, a, y};
        cells[other->second].corners = {y, b, x};
        touched[c] = touched[other->second] = 1;
        any = again = true;
      }
  }
  return any;
}

double ratio_of(const RationalVector& x, const mpq_class& square_length) { return std::abs(mpq_class(squared(x) / square_length - 1).get_d()); }

class Check {
 public:
  Check(const Complex& complex, const GlobalRule& rule, const Limits& limits, Progress& progress) : complex_(complex), rule_(rule), limits_(limits), progress_(progress) {}

  AlgebraicReport run(const AlgebraicChanges& changes) {
    const Features features = compute_features(complex_);
    GlobalRule outline = rule_;
    outline.fill = false;
    outline.claims.clear();
    Placement placement = place_global(complex_, features, outline, limits_, progress_);
    const long zone_points = static_cast<long>(placement.points.size());
    if (limits_.max_points > 0 && zone_points > limits_.max_points) throw LimitReached("max-points", zone_points);
    const Instance rational_zones = instance_of(complex_, placement, true);
    if (placement.refutation) report_.refutes = placement.refutation->statement;

    Roots roots;
    const Sizes sizes = exact_sizes(rational_zones, rule_, roots);
    const auto working = [&](const Number& x) { return std::ldexp(x.doubleValue(), -complex_.scale); };
    Directions directions(rational_zones, sizes, roots);
    GlobalRule exact_rule = without_rounding(rule_, {working(sizes.radius), working(sizes.offset), working(sizes.spacing), rational_zones.parameters.angle_cosine});
    exact_rule.reaches = [&](FacetId facet, VertexId vertex, SegmentId first, SegmentId last, int count) { return directions.reaches(facet, vertex, first, last, count); };
    try {
      placement = place_global(complex_, features, exact_rule, limits_, progress_);
      report_.filled = !placement.refutation;
    } catch (const LimitReached& limit) {
      if (std::string(limit.what()) != "max-points") throw;
      exact_rule.fill = false;
      placement = place_global(complex_, features, exact_rule, limits_, progress_);
    }
    if ((placement.refutation ? placement.refutation->statement : "") != report_.refutes) throw StrategyFailed(rule_.name + ": rounded and unrounded sizes disagree about a refutation");
    const Instance rational = report_.filled ? instance_of(complex_, place_global(complex_, features, rule_, {0, limits_.threads}, progress_), true) : rational_zones;

    Instance instance = instance_of(complex_, placement, true);
    Points points(instance, sizes, roots, directions);
    for (const auto& [id, change] : changes) {
      points.on_sphere.erase(id);
      for (int axis = 0; axis < 3; ++axis) points.exact.at(id)[axis] = points.exact[id][axis] + Number(change[axis]);
    }
    if (report_.filled) {
      const Kernel kernel(instance, points.exact);
      if (flip(kernel, placement.cells)) instance = instance_of(complex_, placement, true);
    }
    const Kernel kernel(instance, points.exact);
    report_.parameters = sizes.description;
    report_.points = static_cast<long>(instance.positions.size());
    report_.cells = static_cast<long>(instance.cells.size());
    Statements statements(kernel, sizes, rational, points.on_sphere);
    for (const Lemma& lemma : all_lemmas()) {
      progress_.at(lemma.id, report_.points);
      if (progress_.stop_requested(report_.points)) throw LimitReached("stopped", report_.points);
      report_.lemmas.push_back(test(lemma, kernel, statements, rational));
    }
    if (placement.refutation) confirm(*placement.refutation, statements);
    equalities(kernel, statements, rational, sizes);
    report_.exact_signs = kernel.exact_signs();
    return std::move(report_);
  }

 private:
  std::string reason_to_skip(const std::string& id) const {
    const auto among = [&](std::initializer_list<const char*> list) { return std::find(list.begin(), list.end(), id) != list.end(); };
    if (id == "L20") return "no bound of circumradii is given";
    if (!report_.refutes.empty() && among({"L2", "L4", "L6", "L7", "L8", "L12", "L14", "L16", "L17", "L19", "L22", "L23"})) return "the strategy ends at the cells that refute " + report_.refutes;
    if (!report_.filled && among({"L8", "L16", "L17", "L19", "L23"})) return "P'' is not filled";
    return "";
  }

  AlgebraicRow test(const Lemma& lemma, const Kernel& kernel, Statements& statements, const Instance& rational) {
    AlgebraicRow row{lemma.id, reason_to_skip(lemma.id), {}, 0, {}};
    if (!row.skipped.empty()) return row;
    const Instance& instance = kernel.instance();
    const long objects = lemma.count(instance);
    if (row.id == "L19") {
      // Signs are those of the cells; the rest is combinatorial.
      row.exact = evaluate(lemma, instance);
      for (std::size_t c = 0; c < instance.cells.size(); ++c) {
        const auto& [a, b, d] = instance.cells[c].corners;
        const auto& [i, j, k] = instance.facets[instance.cells[c].facet].frame;
        const int turn = kernel.evaluate([&, a = a, b = b, d = d, i = i, j = j, k = k](const auto& g) {
          return dot(cross(g.between(j, i), g.between(k, i)), cross(g.between(b, a), g.between(d, a)));
        }).sign;
        if (turn <= 0 && row.exact.failures++ == 0) row.exact.failure = {cell_name(static_cast<int>(c)), 0};
      }
    } else if (row.id == "L21") {
      // r is a third of the least distance by definition: the nearest pairs are equalities, all others have what they have to spare.
      std::vector<double> slacks;
      Tally tally(objects, [&](double slack, int) { slacks.push_back(slack); });
      lemma.evaluate(rational, tally);
      const double least = tally.smallest();
      row.equalities = std::count(slacks.begin(), slacks.end(), least);
      row.exact = std::move(tally).result();
      if (row.exact.slack) row.exact.slack->rounded = 0;
    } else {
      Count count = statements.test(row.id);
      row.exact = std::move(count.result);
      row.equalities = count.equalities;
    }
    row.exact.objects = objects;
    try {
      row.rational = evaluate(lemma, rational);
    } catch (const MissingParameter&) {
    } catch (const WrongKind&) {
    }
    return row;
  }

  // What no lemma's test of the cells that are left says: that no sphere of a pencil is empty, that two protectors cross.
  void confirm(const Refutation& refutation, const Statements& statements) {
    const auto& cells = refutation.cells;
    if (report_.refutes == "L18" && !statements.excludes_all_spheres(cells[0], refutation.points[0], refutation.points[1]))
      throw StrategyFailed("the pencil of the rational refutation has an empty sphere when the points are exact");
    if (report_.refutes != "L5") return;
    if (!statements.cross_each_other(cells[0], cells[1])) throw StrategyFailed("the protectors of the rational refutation do not cross when the points are exact");
    for (AlgebraicRow& row : report_.lemmas)
      if (row.id == "L5" && row.exact.failures == 0) {
        row.exact.failures = 1;
        row.exact.failure = {fmt::format("cell-{}-cell-{}", cells[0], cells[1]), 0};
      }
  }

  void equalities(const Kernel& kernel, Statements& statements, const Instance& rational, const Sizes& sizes) {
    const Instance& instance = kernel.instance();
    const auto& p = rational.positions;
    const auto between = [&](int to, int from) { return confidel::minus(p[to], p[from]); };
    const mpq_class r = square(*rational.parameters.radius);
    const auto finish = [&](AlgebraicEquality equality) {
      if (equality.objects > 0) report_.equalities.push_back(std::move(equality));
    };

    AlgebraicEquality sphere{"|p - v| = r: arc and offset points on the sphere of their vertex"};
    const auto pairs = [](const Instance& of) {
      std::set<std::pair<int, int>> result;
      for (const EndCell& end : of.end_cells) result.insert({end.v, end.a});
      for (const SpokeCell& spoke : of.spoke_cells) result.insert({{spoke.v, spoke.p}, {spoke.v, spoke.q}});
      return result;
    };
    for (const auto& [v, x] : pairs(instance)) {
      ++sphere.objects;
      sphere.exact += statements.on_sphere(v, x) ? 1 : 0;
    }
    for (const auto& [v, x] : pairs(rational)) sphere.rational = std::max(sphere.rational, ratio_of(between(x, v), r));
    finish(sphere);

    AlgebraicEquality right{"(m - v).(a - m) = 0: right angles of T cells"}, offset{"|a - m| = d: offsets of T cells"};
    for (const EndCell& end : instance.end_cells) {
      ++right.objects;
      ++offset.objects;
      right.exact += statements.vanishes([&](const auto& g) { return dot(g.between(end.m, end.v), g.between(end.a, end.m)); }) ? 1 : 0;
      offset.exact += statements.vanishes([&](const auto& g) { return dot(g.between(end.a, end.m), g.between(end.a, end.m)) - g.squared(statements.offset_length()); }) ? 1 : 0;
    }
    const Number squared_offset = sizes.offset * sizes.offset;
    const mpq_class d(squared_offset.doubleValue());
    for (const EndCell& end : rational.end_cells) {
      offset.rational = std::max(offset.rational, ratio_of(between(end.a, end.m), d));
      right.rational = std::max(right.rational, std::abs(mpq_class(confidel::dot(between(end.m, end.v), between(end.a, end.m)) / r).get_d()));
    }
    finish(right);
    finish(offset);

    // Identical intervals, on the edge and on each protector; with the right angles boxes are rectangles.
    AlgebraicEquality intervals{"equal intervals of an edge and its protectors (2.3, 3.2)"};
    for (const PlacedRow& row : instance.rows)
      for_each_interval(row, [&](int from, int to) {
        ++intervals.objects;
        intervals.exact += statements.equal_steps(to, from, row.points[1], row.points[0]) ? 1 : 0;
      });
    for (const PlacedRow& row : rational.rows)
      for_each_interval(row, [&](int from, int to) { intervals.rational = std::max(intervals.rational, ratio_of(between(to, from), squared(between(row.points[1], row.points[0])))); });
    finish(intervals);

    AlgebraicEquality arcs{"equal chords of an arc (2.2), where roots divide it"};
    arcs.everywhere = false;
    for_each_arc(instance, [&](const std::vector<int>& arc) {
      ++arcs.objects;
      bool equal = true;
      for (std::size_t i = 1; equal && i + 1 < arc.size(); ++i) equal = equally_long(statements, {arc[i], arc[i + 1]}, {arc[0], arc[1]});
      arcs.exact += equal ? 1 : 0;
    });
    for_each_arc(rational, [&](const std::vector<int>& arc) {
      for (std::size_t i = 1; i + 1 < arc.size(); ++i) arcs.rational = std::max(arcs.rational, ratio_of(between(arc[i + 1], arc[i]), squared(between(arc[1], arc[0]))));
    });
    finish(arcs);
  }

  static bool equally_long(const Statements& statements, const std::array<int, 2>& one, const std::array<int, 2>& two) {
    return statements.vanishes([&](const auto& g) {
      const auto x = g.between(one[1], one[0]), y = g.between(two[1], two[0]);
      return dot(x, x) - dot(y, y);
    });
  }
  template <class Visit>
  static void for_each_interval(const PlacedRow& row, Visit visit) {
    for (std::size_t i = 0; i + 1 < row.points.size(); ++i) visit(row.points[i], row.points[i + 1]);
    for (const PlacedRow::Protector& protector : row.protectors)
      for (std::size_t i = 0; i + 1 < protector.points.size(); ++i) visit(protector.points[i], protector.points[i + 1]);
  }
  template <class Visit>
  static void for_each_arc(const Instance& instance, Visit visit) {
    for (const EndCell& end : instance.end_cells)
      if (end.opens && instance.closing_cell(end) >= 0) visit(arc_of(instance, end));
  }

  const Complex& complex_;
  const GlobalRule& rule_;
  const Limits& limits_;
  Progress& progress_;
  AlgebraicReport report_;
};

}  // namespace

bool AlgebraicReport::holds() const {
  return std::all_of(lemmas.begin(), lemmas.end(), [](const AlgebraicRow& row) { return row.exact.failures == 0; }) &&
         std::all_of(equalities.begin(), equalities.end(), [](const AlgebraicEquality& equality) { return !equality.everywhere || equality.exact == equality.objects; });
}

AlgebraicReport check_algebraically(const Complex& complex, const GlobalRule& rule, const Limits& limits, Progress& progress, const AlgebraicChanges& changes) {
  if (complex.dimension != 3) throw std::invalid_argument("check_algebraically: dimension 3 only");
  return Check(complex, rule, limits, progress).run(changes);
}

}  // namespace confidel
