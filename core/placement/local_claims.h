// SPDX-License-Identifier: GPL-3.0-or-later
// What the graded strategy claims about its placements (docs/lemma-claims.md): the radii and offsets as rational parameters, with cosines
// from which the inequalities between them follow by rational arithmetic alone, and the lemmas that hold by construction or were tested.
#pragma once

#include "core/features/features.h"
#include "core/placement/buffer_zones.h"

namespace confidel {

/// The lemmas that are claimed for every placement that conforms, whatever its cells are.
void claim_conformity(Placement& placement);

/// Fills parameters and claims. Pre: the placement was made with these sizes, which are graded_sizes of these features.
void claim_local(const Complex& complex, const Features& features, const BufferSizes& sizes, Placement& placement);

}  // namespace confidel
