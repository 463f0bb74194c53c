// SPDX-License-Identifier: GPL-3.0-or-later
// L3 and L4: how far the circles of spokes and rectangles reach into P''. By squares: no root is needed.
#include "proofs/lemmas/needs.h"
#include "proofs/lemmas/rational_geometry.h"
#include "proofs/lemmas/statements.h"
#include "proofs/lemmas/tally.h"

namespace confidel::statements {

void spoke_bulge(const Instance& instance, Tally& tally) {
  const mpq_class h = square(need(instance.parameters.spacing, "h"));
  for (const SpokeCell& spoke : instance.spoke_cells) {
    const RationalVector a = minus(instance.positions[spoke.p], instance.positions[spoke.v]), b = minus(instance.positions[spoke.q], instance.positions[spoke.v]);
    const mpq_class base = squared(minus(b, a)), d = dot(a, b);
    if (base <= h && d >= 0) continue;
    const mpq_class x = squared(cross(a, b));
    const mpq_class left = square(base - h) * x, right = 4 * h * base * square(d);
    const int line = line_of(instance.lines.cells, spoke.cell);
    if (d <= 0 || left > right) tally.fail(line, cell_name(spoke.cell));
    if (d > 0) tally.slack(mpq_class((right - left) / (square(h) * x)), line, [&] { return cell_name(spoke.cell); });
  }
}

void box_bulge(const Instance& instance, Tally& tally) {
  const mpq_class h = square(need(instance.parameters.spacing, "h"));
  for (const BoxCells& box : instance.boxes) {
    const auto& p = instance.positions;
    const mpq_class w = squared(minus(p[box.corners[1]], p[box.corners[0]])), d = squared(minus(p[box.corners[2]], p[box.corners[1]]));
    if (w <= h) continue;
    const mpq_class slack = (4 * h * d - square(w - h)) / square(h);
    const int line = line_of(instance.lines.cells, box.cells[0]);
    if (slack < 0) tally.fail(line, cell_name(box.cells[0]));
    tally.slack(slack, line, [&] { return cell_name(box.cells[0]); });
  }
}

}  // namespace confidel::statements
