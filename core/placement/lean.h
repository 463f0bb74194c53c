// SPDX-License-Identifier: GPL-3.0-or-later
// The lean strategy: refine only what no empty sphere supports (docs/strategies.md).
#pragma once

#include "core/features/features.h"
#include "core/placement/placement.h"

namespace confidel {

/// What happened on the way, for the report.
struct LeanReport {
  long placed = 0;   ///< Steiner points before the clean-up
  long removed = 0;  ///< by the clean-up
  long protected_vertices = 0, protected_segments = 0;  ///< that got a ball or a row, for refinement came too close to them
  bool fell_back = false;  ///< the whole input was handed to the graded strategy
  std::string reason;      ///< why
};

/// Splits segments and inserts points into facets until every triangle of every facet's constrained Delaunay triangulation is a
/// strong face of the Delaunay tetrahedralization: some sphere of its pencil is empty, closed off its plane. Cells carry that sphere's
/// offset. Then removes every Steiner point that is not needed. Where refinement approaches an input vertex or segment so closely that
/// it might not end (theory.md section 4 gives the sizes r_v and d_e), that vertex or segment gets a ball or a row of the graded strategy.
/// A budget of points makes certain that it ends: beyond it the whole input is handed to the graded strategy (docs/termination.md).
/// Deterministic. Throws LimitReached, StrategyFailed.
Placement place_lean(const Complex& complex, const Features& features, const Limits& limits, Progress& progress, LeanReport* report = nullptr);

}  // namespace confidel
