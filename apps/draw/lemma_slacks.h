// SPDX-License-Identifier: GPL-3.0-or-later
// The slacks of claimed lemmas, cell by cell: what pictures colour by.
#pragma once

#include <string>
#include <vector>

#include "proofs/certificate/reader.h"

namespace confidel {

struct LemmaSlacks {
  std::string id;             ///< as in docs/lemma-claims.md
  std::vector<double> cells;  ///< the smallest slack whose object is the cell, rounded; NaN where the lemma says nothing of it
};

/// Of the lemmas that the certificate claims and whose objects are cells, boxes or edges of the outline; those about empty spheres (L17 too) have the cell's
/// own slack and are left out. Empty where the certificate is not fit for it: that is for the checker to say.
std::vector<LemmaSlacks> lemma_slacks(const Certificate& certificate);

}  // namespace confidel
