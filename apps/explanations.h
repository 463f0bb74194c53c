// SPDX-License-Identifier: GPL-3.0-or-later
// Everything that a program of the project can answer with a name, explained: data, printed by `confidel explain`.
#pragma once

#include <span>
#include <string_view>

namespace confidel {

struct Explanation {
  std::string_view name;     ///< E-NONCOPLANAR, emptiness, max-points, L12
  std::string_view kind;     ///< "error", "rule", "reason", "claim", "lemma"
  std::string_view meaning;  ///< one or two sentences; of a lemma, its statement as docs/lemmas.md has it
  std::string_view advice;   ///< what to do; empty if there is nothing to do
};

/// Errors, rules of the checker (docs/certificate-format.md section 5), reasons of UNDECIDED, claims about parameters, lemmas, in this order.
std::span<const Explanation> explanations();

/// Ignores case; nullptr if there is none of this name.
const Explanation* find_explanation(std::string_view name);

}  // namespace confidel
