// SPDX-License-Identifier: GPL-3.0-or-later
// The smallest input that still does what it did.
#pragma once

#include <array>
#include <cstddef>
#include <functional>

#include "core/complex/input.h"

namespace confidel::campaigns {

/// What shrinking makes smaller, the first difference counts: facets and hanging segments, polygons and corners, vertices, bits of coordinates.
using Measure = std::array<std::size_t, 4>;
Measure measure(const Input& input);

struct Shrinking {
  /// Whether an input still does it. Asked about valid inputs only.
  std::function<bool(const Input&)> keeps;
  /// Asked before each candidate: the best so far is the result then.
  std::function<bool()> stop = [] { return false; };
};

/// Removes facets and segments, then polygons and corners, then vertices, then bits, again and again until nothing more can go. Every accepted
/// step is valid, keeps the behaviour, and is strictly smaller. Pre: the input is valid and shrinking.keeps(input).
Input shrink(Input input, const Shrinking& shrinking);

}  // namespace confidel::campaigns
