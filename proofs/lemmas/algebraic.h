// SPDX-License-Identifier: GPL-3.0-or-later
// The extremal statements, where roots are needed: decided exactly over real algebraic numbers. They are about the paper's constants,
// not about an input: `confidel lemma --kernel algebraic`.
#pragma once

#include <string>
#include <vector>

namespace confidel {

struct AlgebraicResult {
  std::string id;
  std::string statement;  ///< what was decided
  std::string settles;    ///< which statement of the paper, or of the theory page, this settles, and how
  long comparisons = 0;   ///< exact comparisons made
  bool holds = false;
};

/// Exact: every comparison is the sign of an algebraic number. Deterministic.
std::vector<AlgebraicResult> decide_extremal_statements();

/// The vertex of a regular tetrahedron with its three faces, protected as by the repaired strategy at its widest (phi* = pi/4), with every
/// arc point exactly on the sphere: where the lemmas are equalities, and by how much the others hold. Smallest P/R^2, rounded.
struct AlgebraicCorner {
  long points = 0, end_cells = 0, spoke_cells = 0;
  bool on_sphere = false;         ///< |p-v|^2 = r^2 for all arc points
  bool spacing_is_h = false;      ///< L1 with b = h for every spoke
  bool right_angles = false;      ///< every T has its right angle at m
  bool end_cells_empty = false;   ///< L9
  bool spokes_miss_caps = false;  ///< L10
  bool spokes_empty = false;      ///< L11
  double end_cell_slack = 0, cap_slack = 0, spoke_slack = 0;
};
AlgebraicCorner tetrahedron_corner();

}  // namespace confidel
