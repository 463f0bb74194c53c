// SPDX-License-Identifier: GPL-3.0-or-later
// H-offset: how far protectors may be from their edge. Global: by one angle for all; local: by the angles at the edge's ends.
#include "proofs/lemmas/needs.h"
#include "proofs/lemmas/projections.h"
#include "proofs/lemmas/statements.h"
#include "proofs/lemmas/tally.h"

namespace confidel::statements {
namespace {

/// (1) and (2) of lemma-claims.md at one end of a segment.
bool local_bounds(const Instance& instance, VertexId v, SegmentId segment, const mpq_class& radius, const Parameters::Row& row) {
  const int end = instance.segments[segment][0] == v ? 0 : 1;
  const mpq_class &a = row.edge_cosine[end], &b = row.facet_cosine[end];
  const RationalVector u = minus(instance.positions[instance.other_end(segment, v)], instance.positions[v]);
  const auto towards = [&](SegmentId other) { return minus(instance.positions[instance.other_end(other, v)], instance.positions[v]); };
  if (!multiple_below_pi(3, a) || square(row.offset) > square(radius) * (1 - square(a))) return false;
  const mpq_class three = cosine_of_multiple(3, a);
  for (const SegmentId other : instance.segments_at(v))
    if (other != segment && !at_least_cosine(three, u, towards(other))) return false;
  if (instance.dimension == 2) return true;
  if (!multiple_below_pi(10, b) || square(row.offset) > square(radius) * (1 - square(cosine_of_multiple(7, b)))) return false;
  const mpq_class ten = cosine_of_multiple(10, b), squared_sine_bound = 1 - square(ten);
  for (const FacetId facet : instance.facets_at(v)) {
    if (instance.on_boundary_or_constraint(facet, segment)) continue;
    for (const SegmentId other : instance.segments_at(v))
      if (other != segment && instance.on_boundary_or_constraint(facet, other) && !at_least_cosine(ten, u, towards(other))) return false;
    if (cell_below(instance, v, facet, u) >= 0 && (ten < 0 || squared_sine(instance, facet, u) < squared_sine_bound)) return false;
  }
  return true;
}

}  // namespace

void offset(const Instance& instance, Tally& tally) {
  const Parameters& parameters = instance.parameters;
  const auto& positions = instance.positions;
  const bool local = !parameters.balls.empty() || !parameters.rows.empty();
  std::vector<std::array<signed char, 2>> known(instance.segments.size(), {-1, -1});  // the bounds of an end are the same for all its cells
  mpq_class bound;
  if (!local) {
    need(parameters.radius, "r");
    const auto [multiple, cosine] = need_angle(instance);
    if (parameters.beta == 0 && parameters.offset == 0) throw MissingParameter("beta");
    const int j = parameters.beta > 0 ? parameters.beta : parameters.offset;
    // On parameters alone: once, whether or not there are cells; then J has no bound, and cells are not tested.
    if (!multiple_below_pi(multiple, cosine) || (parameters.beta > 0 ? 2L : 4L) * j > multiple) {
      tally.fail(instance.lines.offset, fmt::format("{}-{}", parameters.beta > 0 ? "beta" : "offset", j));
      return;
    }
    bound = square(cosine_of_multiple(j, cosine));
  }
  for (const EndCell& end : instance.end_cells) {
    const SegmentId segment = instance.carriers[end.m];
    const mpq_class height = squared(minus(positions[end.a], positions[end.m])), length = squared(minus(positions[end.a], positions[end.v]));
    const int line = line_of(instance.lines.cells, end.cell);
    bool good = true;
    if (local) {
      const Parameters::Row& row = need_row(instance, segment);
      const mpq_class& radius = need_ball(instance, end.v);
      const mpq_class d = square(row.offset);
      auto& bounds = known[segment][instance.segments[segment][0] == end.v ? 0 : 1];
      if (bounds < 0) bounds = local_bounds(instance, end.v, segment, radius, row) ? 1 : 0;
      good = bounds == 1 && 15 * d <= 16 * height && 16 * height <= 17 * d && 4 * d <= square(radius);
    } else if (parameters.beta > 0) {
      const mpq_class reach = (length - height) / length;  // (|m-v| / |a-v|)^2: the angle at m is right
      good = reach >= bound;
      tally.slack(mpq_class(reach - bound), line, [&] { return cell_name(end.cell); });
    } else {
      good = height <= 4 * square(*parameters.radius) * (1 - bound);
    }
    if (!good) tally.fail(line, cell_name(end.cell));
  }
}

}  // namespace confidel::statements
