// SPDX-License-Identifier: GPL-3.0-or-later
// L6: points of the boundary of P'' (kinds arc and offset of one facet) are at least h apart.
#include "proofs/lemmas/needs.h"
#include "proofs/lemmas/rational_geometry.h"
#include "proofs/lemmas/space.h"
#include "proofs/lemmas/statements.h"

namespace confidel::statements {

void boundary_separation(const Instance& instance, Tally& tally) {
  const mpq_class h = square(need(instance.parameters.spacing, "h"));
  const Space space(instance);
  const double spacing = space.scaled(*instance.parameters.spacing).upper();
  std::vector<PointIndex> of_facet(instance.facets.size(), space.empty_index());
  std::vector<int> points;
  for (std::size_t id = 0; id < instance.kinds.size(); ++id) {
    if (!instance.protects(static_cast<int>(id))) continue;
    points.push_back(static_cast<int>(id));
    of_facet[instance.carriers[id]].insert(static_cast<int>(id), space.approximate(static_cast<int>(id)));
  }
  for (const int x : points) {
    int nearest = -1;
    mpq_class least;
    const double reach = Space::reach(spacing, 1 + std::max(0.0, tally.smallest())) + 4 * Space::position_error;
    of_facet[instance.carriers[x]].visit_ball(space.approximate(x), reach, [&](int y) {
      if (y == x) return false;
      mpq_class distance = squared(minus(instance.positions[x], instance.positions[y]));
      if (nearest < 0 || distance < least || (distance == least && y < nearest)) {
        nearest = y;
        least = std::move(distance);
      }
      return false;
    });
    if (nearest < 0) continue;
    const int line = line_of(instance.lines.points, std::max(x, nearest));
    const auto place = [&] { return fmt::format("point-{}-point-{}", x, nearest); };
    if (least < h) tally.fail(line, place());
    tally.slack(mpq_class(least / h - 1), line, place);
  }
}

}  // namespace confidel::statements
