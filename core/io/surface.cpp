// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/surface.h"

#include <fmt/format.h>

#include <bit>
#include <cstdint>

namespace confidel::io {

void FaceCollector::add(std::vector<int> corners, int marker, int line) {
  if (corners.size() >= 3) {
    InputFacet facet;
    facet.polygons.push_back({std::move(corners), line});
    facet.marker = marker;
    facet.line = line;
    input_.facets.push_back(std::move(facet));
  } else if (corners.size() == 2) {
    ++segments_;
    input_.segments.push_back({{corners[0], corners[1]}, marker, line});
  } else {
    ++points_;
  }
}

void FaceCollector::finish() {
  if (segments_ > 0) input_.remarks.push_back(fmt::format("{} faces with two corners are read as segments", segments_));
  if (points_ > 0) input_.remarks.push_back(fmt::format("{} faces with one corner are read as vertices", points_));
}

std::size_t CornerMerger::Hash::operator()(const std::array<double, 3>& position) const {
  std::uint64_t hash = 0;
  for (const double coordinate : position) {
    hash = (std::rotl(hash, 21) ^ std::bit_cast<std::uint64_t>(coordinate)) * 0x9E3779B97F4A7C15u;
  }
  return static_cast<std::size_t>(hash ^ (hash >> 32));
}

int CornerMerger::vertex(const std::array<double, 3>& position, int line) {
  ++corners_;
  std::array<double, 3> key = position;
  for (double& coordinate : key) coordinate += 0.0;  // -0.0 + 0.0 is 0.0
  const auto [entry, is_new] = index_.try_emplace(key, static_cast<int>(input_.vertices.size()));
  if (is_new) input_.vertices.push_back({key, 0, line});
  return entry->second;
}

void CornerMerger::finish() {
  input_.remarks.push_back(
      fmt::format("{} corners are {} vertices: bit-identical ones are merged", corners_, input_.vertices.size()));
}

}  // namespace confidel::io
