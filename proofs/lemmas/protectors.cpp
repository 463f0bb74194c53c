// SPDX-License-Identifier: GPL-3.0-or-later
// L5 and L7: protectors of neighbouring edges do not cross; the corners of P'' at a protector's end are not acute.
#include <algorithm>

#include "proofs/lemmas/rational_geometry.h"
#include "proofs/lemmas/statements.h"
#include "proofs/lemmas/tally.h"

namespace confidel::statements {

void protectors_apart(const Instance& instance, Tally& tally) {
  const auto& p = instance.positions;
  for (const EndCell& opening : instance.end_cells) {
    if (!opening.opens) continue;
    const int index = instance.closing_cell(opening);
    if (index < 0) continue;  // in a refutation only
    const EndCell& closing = instance.end_cells[index];
    const RationalVector& n = instance.normal(instance.cells[opening.cell].facet);
    const auto turn = [&](int from, int to) { return dot(n, cross(minus(p[from], p[opening.v]), minus(p[to], p[opening.v]))); };
    if (turn(opening.m, closing.m) <= 0) continue;
    const mpq_class turned = turn(opening.a, closing.a);
    const auto place = [&] { return fmt::format("cell-{}-cell-{}", opening.cell, closing.cell); };
    const int line = line_of(instance.lines.cells, opening.cell);
    if (turned <= 0) tally.fail(line, place());
    const mpq_class sine = square(turned) / (squared(minus(p[opening.a], p[opening.v])) * squared(minus(p[closing.a], p[opening.v])) * squared(n));
    tally.slack(sgn(turned) * std::sqrt(sine.get_d()), line, place);
  }
}

void obtuse_corners(const Instance& instance, Tally& tally) {
  const auto& p = instance.positions;
  for (const EndCell& end : instance.end_cells) {
    const FacetId facet = instance.cells[end.cell].facet;
    const int line = line_of(instance.lines.cells, end.cell);
    // The cells beyond the edges m a and v a; directed edges of neighbours run the other way.
    const int box = end.opens ? instance.cell_with_edge(facet, end.a, end.m) : instance.cell_with_edge(facet, end.m, end.a);
    const int spoke = end.opens ? instance.cell_with_edge(facet, end.v, end.a) : instance.cell_with_edge(facet, end.a, end.v);
    int q = -1, s = -1;
    if (box >= 0 && instance.box_of(box) >= 0) {
      const auto& corners = instance.boxes[instance.box_of(box)].corners;
      for (int k = 0; k < 4; ++k)
        if (corners[k] == end.a)
          for (const int side : {1, 3})
            if (corners[(k + side) % 4] != end.m) q = corners[(k + side) % 4];
    }
    if (spoke >= 0 && instance.cells[spoke].kind == CellKind::S)
      for (const int corner : instance.cells[spoke].corners)
        if (corner != end.v && corner != end.a) s = corner;
    if (q < 0 || s < 0) {
      tally.fail(line, cell_name(end.cell));
      continue;
    }
    const RationalVector x = minus(p[q], p[end.a]), y = minus(p[s], p[end.a]);
    if (dot(x, y) > 0) tally.fail(line, cell_name(end.cell));
    tally.slack(-approximate_cosine(x, y), line, [&] { return cell_name(end.cell); });
  }
}

}  // namespace confidel::statements
