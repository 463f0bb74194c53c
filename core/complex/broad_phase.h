// SPDX-License-Identifier: GPL-3.0-or-later
// Pairs of boxes that meet: the broad phase of every pairwise test. Coordinates are the input's doubles, so boxes are
// exact.
#pragma once

#include <algorithm>
#include <array>
#include <functional>
#include <vector>

namespace confidel::building {

/// A closed axis-parallel box.
struct Box {
  std::array<double, 3> low{};
  std::array<double, 3> high{};
};

/// The smallest box of the positions with these indices.
template <typename Indices>
Box bounding_box(const std::vector<std::array<double, 3>>& positions, const Indices& indices) {
  Box box{positions[indices[0]], positions[indices[0]]};
  for (const int index : indices)
    for (int axis = 0; axis < 3; ++axis) {
      box.low[axis] = std::min(box.low[axis], positions[index][axis]);
      box.high[axis] = std::max(box.high[axis], positions[index][axis]);
    }
  return box;
}

using PairCallback = std::function<void(int, int)>;

/// Calls back once for every unordered pair of different boxes that meet, in no particular order: near-linear plus
/// output.
void for_each_meeting_pair(const std::vector<Box>& boxes, const PairCallback& callback);

/// Calls back once for every pair (index in first, index in second) that meets.
void for_each_meeting_pair(const std::vector<Box>& first, const std::vector<Box>& second, const PairCallback& callback);

}  // namespace confidel::building
