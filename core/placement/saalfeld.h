// SPDX-License-Identifier: GPL-3.0-or-later
// Saalfeld's edge refinement (paper section 1.2, Figure 1), the historical baseline: a disk around every vertex, then every edge covered
// by tangent circles that are smaller than the distance between any two of the remaining edges.
#pragma once

#include "core/complex/complex.h"
#include "core/features/features.h"
#include "core/placement/placement.h"

namespace confidel {

/// Steiner points lie on segments only. Pre: complex is valid, triangulated, of dimension 2. Deterministic.
/// Throws LimitReached (also before the work: the number of points is known).
Placement place_saalfeld(const Complex& complex, const Features& features, const Limits& limits, Progress& progress);

}  // namespace confidel
