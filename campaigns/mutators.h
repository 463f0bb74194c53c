// SPDX-License-Identifier: GPL-3.0-or-later
// Changes of an input that keep it valid, and transformations that must not change a verdict.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "campaigns/random.h"
#include "core/complex/input.h"

namespace confidel::campaigns {

struct Mutator {
  const char* name;
  const char* about;
  /// Nothing if it does not apply, or would have to round a coordinate where that is not allowed. The result need not be valid.
  std::optional<Input> (*propose)(const Input&, Random&);
};
const std::vector<Mutator>& mutators();

/// One mutator's result, if there is a valid one within a few proposals. Pre: the input is valid.
std::optional<Input> mutate(const Mutator& mutator, const Input& input, Random& random);

/// A random mutator's; the input itself if none applies.
Input mutate(const Input& input, Random& random);

// Exact maps. Those that return an optional have no value if a coordinate of the image is no double.

/// Vertices, facets, polygons, segments in another order; loops begin elsewhere.
Input permuted(const Input& input, Random& random);
/// (x, y, z) to signed coordinates in another order. In dimension 2 of x and y only.
Input with_permuted_axes(const Input& input, Random& random);
/// By a rational angle (p/r, q/r) about a coordinate axis (x, y plane in dimension 2), times r.
std::optional<Input> rotated(const Input& input, Random& random);
std::optional<Input> scaled(const Input& input, int power_of_two);
/// Both, the second one translated by a power of two along an axis, far enough that their boxes are apart by several times their size.
/// No value also if the two cannot be said in one file.
std::optional<Input> far_union(const Input& first, const Input& second, Random& random);

}  // namespace confidel::campaigns
