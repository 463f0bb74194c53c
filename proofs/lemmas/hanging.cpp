// SPDX-License-Identifier: GPL-3.0-or-later
// L22, the rule `hanging`: the pieces of hanging segments, in order, and nothing in or on their diametral balls.
#include <algorithm>

#include "proofs/lemmas/rational_geometry.h"
#include "proofs/lemmas/space.h"
#include "proofs/lemmas/statements.h"

namespace confidel::statements {
namespace {

/// The subsegments as they must be: all points that each hanging segment carries, in order.
std::vector<std::array<int, 3>> expected_pieces(const Instance& instance) {
  std::vector<std::vector<std::pair<mpq_class, int>>> carried(instance.segments.size());
  std::vector<char> hangs(instance.segments.size(), 1);
  for (const Facet& facet : instance.facets)
    for (const auto* edges : {&facet.boundary, &facet.constraints})
      for (const auto& [a, c] : *edges) hangs[instance.find_segment(a, c)] = 0;
  for (std::size_t id = instance.vertex_count; id < instance.kinds.size(); ++id) {
    if (!instance.on_segment_kind(static_cast<int>(id)) || !hangs[instance.carriers[id]]) continue;
    const auto& [a, b] = instance.segments[instance.carriers[id]];
    const RationalVector along = minus(instance.positions[b], instance.positions[a]);
    carried[instance.carriers[id]].emplace_back(dot(along, minus(instance.positions[id], instance.positions[a])), static_cast<int>(id));
  }
  std::vector<std::array<int, 3>> pieces;
  for (std::size_t s = 0; s < instance.segments.size(); ++s) {
    if (!hangs[s]) continue;
    std::sort(carried[s].begin(), carried[s].end());
    int previous = instance.segments[s][0];
    for (const auto& [along, id] : carried[s]) {
      pieces.push_back({static_cast<int>(s), previous, id});
      previous = id;
    }
    pieces.push_back({static_cast<int>(s), previous, instance.segments[s][1]});
  }
  return pieces;
}

}  // namespace

void hanging_empty(const Instance& instance, Tally& tally) {
  if (expected_pieces(instance) != instance.hanging) {
    tally.fail(0, "hanging");
    return;
  }
  const Space space(instance);
  const PointIndex all = space.index([](int) { return true; });
  for (std::size_t i = 0; i < instance.hanging.size(); ++i) {
    const auto& [segment, a, b] = instance.hanging[i];
    const RationalVector &from = instance.positions[a], &to = instance.positions[b];
    const mpq_class length = squared(minus(to, from));
    const int line = line_of(instance.lines.hanging, static_cast<int>(i));
    const auto &low = space.approximate(a), &high = space.approximate(b);
    const PointIndex::Position middle{(low[0] + high[0]) / 2, (low[1] + high[1]) / 2, (low[2] + high[2]) / 2};
    const double approximate_length = std::hypot(high[0] - low[0], high[1] - low[1], high[2] - low[2]);
    const double reach = Space::reach(approximate_length, 0.25 + std::max(0.0, tally.smallest())) + 4 * Space::position_error;
    int inside = -1;
    all.visit_ball(middle, reach, [&, a = a, b = b](int id) {
      if (id == a || id == b) return false;
      const mpq_class power = dot(minus(instance.positions[id], from), minus(instance.positions[id], to));
      if (power <= 0 && (inside < 0 || id < inside)) inside = id;
      tally.slack(mpq_class(power / length), line, [&] { return fmt::format("subsegment-{}-{}-point-{}", a, b, id); });
      return false;
    });
    if (inside >= 0) tally.fail(line, fmt::format("subsegment-{}-{}-point-{}", a, b, inside));
  }
}

}  // namespace confidel::statements
