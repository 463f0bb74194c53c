// SPDX-License-Identifier: GPL-3.0-or-later
// Inputs that are made, not read: put together by hand, tested exactly, written in a format that can say them.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "core/complex/input.h"

namespace confidel::campaigns {

using Position = std::array<double, 3>;

/// An Input step by step. Vertices are numbered from 0.
class Maker {
 public:
  explicit Maker(int dimension = 3) { input_.dimension = dimension; }

  int vertex(const Position& position);
  void facet(std::vector<int> corners) { facet(std::vector<std::vector<int>>{std::move(corners)}); }
  void facet(const std::vector<std::vector<int>>& polygons, const std::vector<Position>& holes = {});
  void segment(int a, int b) { input_.segments.push_back({{a, b}, 0, 0}); }
  void hole(const Position& seed) { input_.holes.push_back(seed); }

  int size() const { return static_cast<int>(input_.vertices.size()); }
  const Position& at(int vertex) const { return input_.vertices[static_cast<std::size_t>(vertex)].position; }
  Input& input() { return input_; }

 private:
  Input input_;
};

/// The exact validity test of core/complex/build.h.
bool is_valid(const Input& input);

/// Without the vertices that nothing mentions (in dimension 2 an unused vertex is a point of the domain and stays).
Input without_unused_vertices(const Input& input);

/// ".poly" (dimension 2; facets with holes, slits, isolated vertices), ".obj" (hanging segments, triangle soups), or ".smesh".
/// Throws std::invalid_argument for what no format can say: hanging segments together with a facet of several polygons.
std::string suffix_for(const Input& input);

/// The text of a file with that suffix: reading it gives the same input, bit for bit.
std::string input_text(const Input& input, const std::string& remark = "");

}  // namespace confidel::campaigns
