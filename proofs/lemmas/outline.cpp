// SPDX-License-Identifier: GPL-3.0-or-later
// L17 and L23: the circles of cells C at the edges of P'''s boundary.
#include "proofs/lemmas/needs.h"
#include "proofs/lemmas/rational_geometry.h"
#include "proofs/lemmas/space.h"
#include "proofs/lemmas/statements.h"

namespace confidel::statements {

void locally_delaunay(const Instance& instance, Tally& tally) {
  const Space space(instance);
  for (const OutlineEdge& edge : instance.outline) {
    const Sphere sphere(space, edge.cell);
    bool clear = false;
    const int sign = sphere.sign(edge.y, tally.smallest(), clear);
    if (clear) continue;
    const int line = line_of(instance.lines.cells, edge.cell);
    if (sign < 0) tally.fail(line, cell_and_point(edge.cell, edge.y));
    tally.slack(mpq_class(sphere.power(edge.y) / sphere.squared_radius()), line, [&] { return cell_and_point(edge.cell, edge.y); });
  }
}

void penetration(const Instance& instance, Tally& tally) {
  const mpq_class h = square(need(instance.parameters.spacing, "h"));
  const Space space(instance);
  const auto& p = instance.positions;
  for (const OutlineEdge& edge : instance.outline) {
    if (dot(minus(p[edge.a], p[edge.x]), minus(p[edge.b], p[edge.x])) >= 0) continue;
    const Sphere sphere(space, edge.cell);
    const mpq_class depth = 4 * sphere.squared_radius() - squared(minus(p[edge.b], p[edge.a]));
    const int line = line_of(instance.lines.cells, edge.cell);
    if (depth > h) tally.fail(line, cell_name(edge.cell));
    tally.slack(mpq_class((h - depth) / h), line, [&] { return cell_name(edge.cell); });
  }
}

}  // namespace confidel::statements
