// SPDX-License-Identifier: GPL-3.0-or-later
// Shrinking what conform does something with.
#pragma once

#include <string>

#include "apps/conform_process.h"

namespace confidel {

struct ShrinkRequest {
  ConformSettings settings;
  std::string behaviour;   ///< see is_behaviour
  double time_limit = 60;  ///< for all of it, seconds; 0: none
};

/// The smallest input found on which conform still shows the behaviour. Each run gets three times the time that the original took (and at least a
/// second), except where running out of it is what is kept. Pre: the input shows it.
Input shrink_with_conform(const Input& input, const ShrinkRequest& request, ConformWorkspace& workspace, double original_seconds);

}  // namespace confidel
