// SPDX-License-Identifier: GPL-3.0-or-later
// What the paper says, as data for `confidel paper`: each statement with the lemmas that say it exactly, and the inputs that refute it.
#pragma once

#include <string>
#include <vector>

namespace confidel {

/// A run of the paper's own parameters that is expected to end in a refutation.
struct Counterexample {
  std::string input;
  std::string beta;  ///< as of --beta; empty: as printed
  bool operator==(const Counterexample&) const = default;
};

enum class Experiment { none, empty_spheres, ties, radius, offset, verdicts };

struct PaperStatement {
  std::string section, text;
  std::vector<std::string> lemmas;      ///< of lemma-claims.md: what is tested on every object of the repaired runs
  std::vector<Counterexample> against;  ///< runs with the paper's parameters that refute it
  std::string remark;                   ///< what makes it true, or what is true instead
  Experiment experiment = Experiment::none;
};

const std::vector<PaperStatement>& paper_statements();

}  // namespace confidel
