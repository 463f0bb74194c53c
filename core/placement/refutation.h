// SPDX-License-Identifier: GPL-3.0-or-later
// Cells of the buffer zones whose spheres are not empty, and the placements that show it (lemma-claims.md section 5).
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/placement/buffer_zones.h"
#include "core/placement/point_index.h"

namespace confidel {

/// What refutes a statement. Values are exact, in the input's coordinates.
struct Witness {
  std::string statement;          ///< L5, L9, L10, L11, L13, L18
  std::vector<BufferCell> cells;  ///< two for L5, else one
  std::vector<int> points;        ///< two for L18, none for L5, else one
  std::vector<mpq_class> values;
};

/// Two neighbouring protectors of a facet that cross at a vertex, or touch: L5. The first in order, or none.
std::optional<Witness> find_crossing(const BufferZones& zones);

/// A cell whose diametral sphere is encroached by points of the index, rule `emptiness` and `tie`: strictly inside or not.
struct EncroachedCell {
  BufferCell cell;
  std::vector<int> inside;  ///< points of negative power; may be empty (ties)
};

/// All T and S cells, and with `rectangles` R cells too. Throws LimitReached when progress asks to stop.
std::vector<EncroachedCell> find_encroached(const BufferZones& zones, const PointIndex& index, bool rectangles, Progress& progress);

/// The strongest refutation: that no sphere through a cell is empty (L18), of all cells the one with the widest gap, by points m
/// if these suffice; else a point in a
/// diametral sphere, L10 before L9, L11 and L13, the deepest. None if there are only ties, or points that no statement is about.
std::optional<Witness> strongest_witness(const BufferZones& zones, const PointIndex& index, const std::vector<EncroachedCell>& cells);

/// The complex's vertices, the cells of the witness first, then those that its points need, and no other points.
Placement refuting_placement(const BufferZones& zones, const Witness& witness);

}  // namespace confidel
