// SPDX-License-Identifier: GPL-3.0-or-later
// L8: every interior point was inserted as the circumcentre of a large triangle, far from what was there (Chew's lemma).
#include "proofs/lemmas/needs.h"
#include "proofs/lemmas/rational_geometry.h"
#include "proofs/lemmas/space.h"
#include "proofs/lemmas/statements.h"

namespace confidel::statements {
namespace {

/// What a facet has before its first insertion, and its outline.
struct FacetState {
  explicit FacetState(const Space& space) : points(space.empty_index()), edges(space.empty_index()) {}
  PointIndex points;
  PointIndex edges;  ///< middles of the outline's edges, by their place in the instance's outline
  double half_length = 0;
};

}  // namespace

void insertions(const Instance& instance, Tally& tally) {
  const mpq_class h = square(need(instance.parameters.spacing, "h"));
  const Space space(instance);
  const auto& p = instance.positions;
  const double spacing = space.scaled(*instance.parameters.spacing).upper();
  std::vector<FacetState> states(instance.facets.size(), FacetState(space));
  for (std::size_t id = 0; id < instance.kinds.size(); ++id)
    if (instance.protects(static_cast<int>(id))) states[instance.carriers[id]].points.insert(static_cast<int>(id), space.approximate(static_cast<int>(id)));
  for (std::size_t e = 0; e < instance.outline.size(); ++e) {
    const OutlineEdge& edge = instance.outline[e];
    FacetState& state = states[instance.cells[edge.cell].facet];
    const auto &a = space.approximate(edge.a), &b = space.approximate(edge.b);
    state.edges.insert(static_cast<int>(e), {(a[0] + b[0]) / 2, (a[1] + b[1]) / 2, (a[2] + b[2]) / 2});
    state.half_length = std::max(state.half_length, std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]) / 2);
  }
  std::vector<char> of_other_cell(instance.kinds.size(), 0);  // corners of cells that are not C
  for (const PlacedCell& cell : instance.cells)
    if (cell.kind != CellKind::C)
      for (const int corner : cell.corners) of_other_cell[corner] = 1;

  std::vector<char> inserted(instance.kinds.size(), 0);
  for (std::size_t i = 0; i < instance.insertions.size(); ++i) {
    const Insertion& insertion = instance.insertions[i];
    const auto [a, b, c] = insertion.corners;
    const int line = line_of(instance.lines.insertions, static_cast<int>(i));
    const std::string name = fmt::format("point-{}", insertion.point);
    FacetState& state = states[insertion.facet];
    const auto known = [&](int id) { return instance.carriers[id] == insertion.facet && (instance.protects(id) || (instance.kinds[id] == PointKind::interior && inserted[id])); };
    bool good = instance.kinds[insertion.point] == PointKind::interior && instance.carriers[insertion.point] == insertion.facet && !inserted[insertion.point] &&
                !of_other_cell[insertion.point] && known(a) && known(b) && known(c);
    const RationalVector u = minus(p[b], p[a]), w = minus(p[c], p[a]), n = cross(u, w);
    const mpq_class area = squared(n);
    if (area == 0) good = false;
    if (good) {
      const RationalVector from_a = times(1 / (2 * area), plus(times(squared(u), cross(w, n)), times(squared(w), cross(n, u))));
      const RationalVector centre = plus(p[a], from_a);
      if (squared(from_a) <= h || 4096 * squared(minus(p[insertion.point], centre)) > h) good = false;
      // The point is within h/64 of the centre: a search around it finds what is near the centre.
      const double reach = Space::reach(spacing, 1 + std::max(0.0, tally.smallest())) + spacing * 0x1p-5 + 4 * Space::position_error;
      state.points.visit_ball(space.approximate(insertion.point), reach, [&](int id) {
        const mpq_class slack = squared(minus(p[id], centre)) / h - 1;
        if (slack <= 0) good = false;
        tally.slack(slack, line, [&] { return fmt::format("point-{}-point-{}", insertion.point, id); });
        return false;
      });
      state.edges.visit_ball(space.approximate(insertion.point), reach + state.half_length, [&](int e) {
        const OutlineEdge& edge = instance.outline[e];
        const mpq_class slack = 4 * squared_distance_to_segment(centre, p[edge.a], p[edge.b]) / h - 1;
        if (slack < 0) good = false;
        tally.slack(slack, line, [&] { return fmt::format("point-{}-edge-{}-{}", insertion.point, edge.a, edge.b); });
        return false;
      });
    }
    if (!good) tally.fail(line, name);
    inserted[insertion.point] = 1;
    state.points.insert(insertion.point, space.approximate(insertion.point));
  }
  for (std::size_t id = 0; id < instance.kinds.size(); ++id)
    if (instance.kinds[id] == PointKind::interior && !inserted[id]) tally.fail(line_of(instance.lines.points, static_cast<int>(id)), fmt::format("point-{}", id));
}

}  // namespace confidel::statements
