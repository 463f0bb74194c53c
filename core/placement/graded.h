// SPDX-License-Identifier: GPL-3.0-or-later
// The graded strategy: the paper's strategy made local (theory.md section 4).
#pragma once

#include "core/features/features.h"
#include "core/placement/buffer_zones.h"
#include "core/placement/placement.h"

namespace confidel {

/// Local sizes: r_v = delta_v/3 and d_e = min(g_e/3, r_v sin(min(theta/3, 0.7 omega, pi/6)) over both ends).
BufferSizes graded_sizes(const Complex& complex, const Features& features);

/// Splits buffer cells and refines P'' until no cell is encroached (rules (0) to (iii)). On return every cell's diametral sphere is
/// empty, closed off the facet's plane, by exact tests; the verdict is still the checker's.
/// Deterministic for any number of threads. Throws LimitReached, StrategyFailed.
Placement place_graded(const Complex& complex, const Features& features, const Limits& limits, Progress& progress);

}  // namespace confidel
