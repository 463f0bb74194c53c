// SPDX-License-Identifier: GPL-3.0-or-later
// H-angle, H-ball and H-chord: what the paper chooses, as inequalities between rationals.
#include "proofs/lemmas/needs.h"
#include "proofs/lemmas/rational_geometry.h"
#include "proofs/lemmas/statements.h"
#include "proofs/lemmas/tally.h"

namespace confidel::statements {

void angle(const Instance& instance, Tally& tally) {
  const auto [multiple, cosine] = need_angle(instance);
  const mpq_class bound = cosine_of_multiple(multiple, cosine);
  if (!multiple_below_pi(multiple, cosine) || bound <= 0 || 2 * square(bound) < 1) tally.fail(instance.lines.angle, "angle");
  for (std::size_t s = 0; s < instance.segments.size(); ++s)
    for (const VertexId v : instance.segments[s]) {
      const RationalVector e = minus(instance.positions[instance.other_end(static_cast<SegmentId>(s), v)], instance.positions[v]);
      bool failed = false;
      for (const SegmentId other : instance.segments_at(v)) {
        if (other == static_cast<SegmentId>(s)) continue;
        const RationalVector g = minus(instance.positions[instance.other_end(other, v)], instance.positions[v]);
        // A pair belongs to the ends of both.
        const auto place = [&] { return fmt::format("segment-{}-segment-{}", s, other); };
        const int line = line_of(instance.lines.segments, std::max<int>(static_cast<int>(s), other));
        if (!failed && !at_least_cosine(bound, e, g)) {
          failed = true;
          tally.fail(line, place());
        }
        tally.slack(bound.get_d() - approximate_cosine(e, g), line, place);
      }
    }
}

void ball(const Instance& instance, Tally& tally) {
  const auto& positions = instance.positions;
  const Parameters& parameters = instance.parameters;
  const bool local = !parameters.balls.empty();
  if (!local) need(parameters.radius, "r");
  if (!local && instance.dimension == 3) need(parameters.spacing, "h");
  const auto test = [&](int cell, int v, int p) {
    const mpq_class square_distance = squared(minus(positions[p], positions[v]));
    bool good;
    if (local) {
      const mpq_class r = square(need_ball(instance, v));
      good = 15 * r <= 16 * square_distance && 16 * square_distance <= 17 * r;
    } else if (instance.dimension == 2) {
      good = square_distance == square(*parameters.radius);
    } else {
      good = 7 * abs(square_distance - square(*parameters.radius)) <= square(*parameters.spacing);
    }
    if (!good) tally.fail(line_of(instance.lines.cells, cell), cell_and_point(cell, p));
    return good;
  };
  for (const EndCell& end : instance.end_cells) test(end.cell, end.v, end.a);
  for (const SpokeCell& spoke : instance.spoke_cells)
    if (test(spoke.cell, spoke.v, spoke.p)) test(spoke.cell, spoke.v, spoke.q);
}

void chord(const Instance& instance, Tally& tally) {
  const mpq_class& r = need(instance.parameters.radius, "r");
  const mpq_class& h = need(instance.parameters.spacing, "h");
  const auto [multiple, cosine] = need_angle(instance);
  const int j = instance.parameters.chord;
  if (j == 0) throw MissingParameter("chord");
  if (4L * j > multiple || !multiple_below_pi(multiple, cosine)) {
    tally.fail(instance.lines.chord, fmt::format("chord-{}", j));
    return;
  }
  const mpq_class bound = 4 * square(r) * (1 - square(cosine_of_multiple(j, cosine)));
  if (square(h) > bound) tally.fail(instance.lines.chord, fmt::format("chord-{}", j));
  tally.slack(mpq_class(bound / square(h) - 1), instance.lines.chord, [] { return "chord"; });
}

}  // namespace confidel::statements
