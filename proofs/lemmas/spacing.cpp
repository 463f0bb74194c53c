// SPDX-License-Identifier: GPL-3.0-or-later
// L1 and L2: neighbours are between h and 3h/2 apart.
#include "proofs/lemmas/needs.h"
#include "proofs/lemmas/rational_geometry.h"
#include "proofs/lemmas/statements.h"
#include "proofs/lemmas/tally.h"

namespace confidel::statements {
namespace {

void between(const Instance& instance, int cell, int from, int to, Tally& tally) {
  const mpq_class ratio = squared(minus(instance.positions[to], instance.positions[from])) / square(*instance.parameters.spacing);
  const mpq_class above = ratio - 1, below = mpq_class(9, 4) - ratio;
  const int line = line_of(instance.lines.cells, cell);
  if (above < 0 || below < 0) tally.fail(line, cell_name(cell));
  tally.slack(above < below ? above : below, line, [&] { return cell_name(cell); });
}

}  // namespace

void arc_spacing(const Instance& instance, Tally& tally) {
  need(instance.parameters.spacing, "h");
  for (const SpokeCell& spoke : instance.spoke_cells) between(instance, spoke.cell, spoke.p, spoke.q, tally);
}

void edge_spacing(const Instance& instance, Tally& tally) {
  need(instance.parameters.spacing, "h");
  for (const BoxCells& box : instance.boxes) between(instance, box.cells[0], box.corners[0], box.corners[1], tally);
}

}  // namespace confidel::statements
