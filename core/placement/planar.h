// SPDX-License-Identifier: GPL-3.0-or-later
// The planar strategies of Theorem 2.1 (paper sections 2.1 to 2.3): the literal one and the repaired one (theory.md section 3, 2D).
// All protecting points lie exactly on their circles and rows; circumcentres are rounded within h/64.
#pragma once

#include <optional>

#include "core/complex/complex.h"
#include "core/features/features.h"
#include "core/placement/global.h"
#include "core/placement/placement.h"

namespace confidel {

struct PlanarOptions {
  /// paper_rule() or repaired_rule(); what it says of facets is of no effect.
  GlobalRule rule;
  /// r_max of Theorem 2.1, in the input's coordinates: every circumradius is at most this, exactly.
  std::optional<mpq_class> greatest_circumradius;
};

/// Pre: complex is valid, triangulated, of dimension 2. Deterministic. Claims its lemmas (lemma-claims.md); the literal parameters may end
/// in a refutation (placement.refutation is set, and the placement holds the witness only).
/// Throws LimitReached (also before the work when the estimate exceeds --max-points), StrategyFailed.
Placement place_planar(const Complex& complex, const Features& features, const PlanarOptions& options, const Limits& limits, Progress& progress);

}  // namespace confidel
