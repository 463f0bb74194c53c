// SPDX-License-Identifier: GPL-3.0-or-later
// L20: circumradii are at most r_max, and r <= 1.9 r_max.
#include "proofs/lemmas/needs.h"
#include "proofs/lemmas/rational_geometry.h"
#include "proofs/lemmas/space.h"
#include "proofs/lemmas/statements.h"

namespace confidel::statements {

void circumradius(const Instance& instance, Tally& tally) {
  const mpq_class greatest = square(need(instance.parameters.greatest_circumradius, "r-max"));
  if (instance.parameters.radius && 100 * square(*instance.parameters.radius) > 361 * greatest) tally.fail(instance.lines.radius, "r");
  const Space space(instance);
  for (std::size_t c = 0; c < instance.cells.size(); ++c) {
    const Sphere sphere(space, static_cast<int>(c));
    const mpq_class slack = greatest / sphere.squared_radius() - 1;
    const int line = line_of(instance.lines.cells, static_cast<int>(c));
    if (slack < 0) tally.fail(line, cell_name(static_cast<int>(c)));
    tally.slack(slack, line, [&] { return cell_name(static_cast<int>(c)); });
  }
}

}  // namespace confidel::statements
