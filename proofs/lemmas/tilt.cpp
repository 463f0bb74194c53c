// SPDX-License-Identifier: GPL-3.0-or-later
// L15: an edge over a facet at its vertex is at least phi' above the facet's plane.
#include "proofs/lemmas/needs.h"
#include "proofs/lemmas/projections.h"
#include "proofs/lemmas/statements.h"
#include "proofs/lemmas/tally.h"

namespace confidel::statements {

void tilt(const Instance& instance, Tally& tally) {
  const auto [multiple, cosine] = need_angle(instance);
  if (instance.dimension == 2) return;
  const mpq_class bound = cosine_of_multiple(multiple, cosine), squared_bound = 1 - square(bound);
  const bool acute = multiple_below_pi(multiple, cosine) && bound > 0;
  for (VertexId v = 0; v < instance.vertex_count; ++v)
    for (const SegmentId segment : instance.segments_at(v)) {
      const RationalVector u = minus(instance.positions[instance.other_end(segment, v)], instance.positions[v]);
      for (const FacetId facet : instance.facets_at(v)) {
        if (instance.on_boundary_or_constraint(facet, segment)) continue;
        const int cell = cell_below(instance, v, facet, u);
        if (cell < 0) continue;
        const mpq_class sine = squared_sine(instance, facet, u);
        const auto place = [&] { return fmt::format("vertex-{}-segment-{}-facet-{}", v, segment, facet); };
        const int line = line_of(instance.lines.cells, cell);
        if (!acute || sine < squared_bound) tally.fail(line, place());
        if (squared_bound > 0) tally.slack(mpq_class(sine / squared_bound - 1), line, place);
      }
    }
}

}  // namespace confidel::statements
