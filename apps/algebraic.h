// SPDX-License-Identifier: GPL-3.0-or-later
// confidel lemma --kernel algebraic: what is decided with square roots.
#pragma once

#include <string>

#include "core/complex/build.h"
#include "core/placement/global.h"

namespace confidel {

/// The extremal statements. Exit 1 if anything did not come out as the page says.
int decide_algebraically(bool json);

struct AlgebraicOptions {
  std::string file, strategy = "repaired", beta;
  long max_points = 2000;
  bool json = false;
  BuildOptions build;
  GlobalRule rule;  ///< of strategy and beta
};

/// The lemmas on the exact points of one input. Exit 1 if one does not hold.
int check_algebraically(const AlgebraicOptions& options);

}  // namespace confidel
