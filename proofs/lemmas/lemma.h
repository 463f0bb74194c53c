// SPDX-License-Identifier: GPL-3.0-or-later
// The statements of the paper that can be tested on an instance: the producer's own version of docs/lemma-claims.md section 4.
#pragma once

#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "proofs/lemmas/instance.h"

namespace confidel {

struct Lemma {
  const char* id;
  const char* statement;
  const char* section;     ///< of the paper
  const char* hypothesis;  ///< what it is stated under; parameters by the names of lemma-claims.md
  const char* exact_form;
  bool needs_kinds;  ///< speaks of cells T, S, R, C: meaningless where Instance::wrong_kind >= 0
  /// How many objects the claim ranges over. Cheap; needs no positions of Steiner points.
  long (*count)(const Instance&);
};

/// In the order in which certificates claim them.
const std::vector<Lemma>& all_lemmas();

/// Throws std::out_of_range if there is none.
const Lemma& find_lemma(const std::string& id);

}  // namespace confidel
