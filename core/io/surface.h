// SPDX-License-Identifier: GPL-3.0-or-later
// Facets of formats that know only faces, and vertices of formats that know only coordinates.
#pragma once

#include <array>
#include <cstddef>
#include <unordered_map>
#include <vector>

#include "core/complex/input.h"

namespace confidel::io {

/// Adds faces as facets of one polygon each; faces with two corners are segments, those with one are vertices.
class FaceCollector {
 public:
  explicit FaceCollector(Input& input) : input_(input) {}
  void add(std::vector<int> corners, int marker, int line);
  /// Writes what was not a face into the input's remarks.
  void finish();

 private:
  Input& input_;
  std::size_t segments_ = 0;
  std::size_t points_ = 0;
};

/// Makes one vertex of bit-identical positions (zeros have no sign).
class CornerMerger {
 public:
  explicit CornerMerger(Input& input) : input_(input) {}
  /// Index of the vertex at this position.
  int vertex(const std::array<double, 3>& position, int line);
  /// Writes the count of merged corners into the input's remarks.
  void finish();

 private:
  struct Hash {
    std::size_t operator()(const std::array<double, 3>& position) const;
  };
  Input& input_;
  std::unordered_map<std::array<double, 3>, int, Hash> index_;
  std::size_t corners_ = 0;
};

}  // namespace confidel::io
