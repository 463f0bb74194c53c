// SPDX-License-Identifier: GPL-3.0-or-later
// A search for the input that makes a number as small as possible: many short climbs from random starts. Floating point steers; what was
// found is decided elsewhere.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "campaigns/random.h"
#include "core/complex/input.h"

namespace confidel::campaigns {

struct SearchStep {
  std::string family;  ///< where the climb began
  const Input& input;
  double objective;
};

struct Search {
  /// Smaller is tighter; no value: it says nothing (too large, undecided).
  std::function<std::optional<double>(const Input&)> objective;
  /// Called with every climb's improvements.
  std::function<void(const SearchStep&)> improved = [](const SearchStep&) {};
  /// Asked before each evaluation.
  std::function<bool()> stop;
};

/// (1+1) evolution strategy with restarts: the vertices of a complex of triangles move by a step that grows on success and shrinks on failure; now
/// and then one of the mutators. Starts are members of families with small angles, or with the dimension's other shapes. Only valid inputs are asked about.
void search(Random& random, const Search& task);

}  // namespace confidel::campaigns
