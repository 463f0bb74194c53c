// SPDX-License-Identifier: GPL-3.0-or-later
// Inputs by hand: vertex i stands on line i + 1, facet i on line 101 + i, segment i on line 201 + i.
#pragma once

#include <string>
#include <vector>

#include "core/complex/build.h"

namespace confidel::test {

using Position = std::array<double, 3>;

class InputMaker {
 public:
  explicit InputMaker(int dimension = 3) {
    input_.file = "made";
    input_.dimension = dimension;
  }

  InputMaker& vertices(const std::vector<Position>& positions) {
    for (const Position& position : positions)
      input_.vertices.push_back({position, 0, static_cast<int>(input_.vertices.size()) + 1});
    return *this;
  }

  /// Polygons of any size; hole points.
  InputMaker& facet(const std::vector<std::vector<int>>& polygons, const std::vector<Position>& holes = {},
                    int marker = 0) {
    InputFacet facet;
    facet.line = 101 + static_cast<int>(input_.facets.size());
    for (const auto& corners : polygons) facet.polygons.push_back({corners, facet.line});
    facet.holes = holes;
    facet.marker = marker;
    input_.facets.push_back(facet);
    return *this;
  }

  InputMaker& segment(int a, int b, int marker = 0) {
    input_.segments.push_back({{a, b}, marker, 201 + static_cast<int>(input_.segments.size())});
    return *this;
  }

  InputMaker& hole(const Position& seed) {
    input_.holes.push_back(seed);
    return *this;
  }

  operator const Input&() const { return input_; }
  Input& input() { return input_; }

 private:
  Input input_;
};

inline std::vector<Problem> problems_of(const Input& input, const BuildOptions& options = {}) {
  try {
    build_complex(input, options);
  } catch (const InputError& error) {
    return error.problems;
  }
  return {};
}

/// "E-CROSSING@201" and so on, in order.
inline std::vector<std::string> codes_of(const Input& input) {
  std::vector<std::string> codes;
  for (const Problem& problem : problems_of(input))
    codes.push_back(problem.code + "@" + std::to_string(problem.place.line));
  return codes;
}

/// All problems as text, for messages.
inline std::string text_of(const std::vector<Problem>& problems) {
  std::string text;
  for (const Problem& problem : problems)
    text += problem.code + "@" + std::to_string(problem.place.line) + ": " + problem.message + "\n";
  return text;
}

inline bool has_remark(const BuildReport& report, const std::string& part) {
  for (const std::string& remark : report.remarks)
    if (remark.find(part) != std::string::npos) return true;
  return false;
}

/// Corners of the unit square in the plane z = 0, and an inner square with corners at 1/4 and 3/4.
inline std::vector<Position> nested_squares() {
  return {{0, 0, 0},       {1, 0, 0},       {1, 1, 0},       {0, 1, 0},
          {0.25, 0.25, 0}, {0.75, 0.25, 0}, {0.75, 0.75, 0}, {0.25, 0.75, 0}};
}

inline std::vector<Position> square() { return {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}; }

}  // namespace confidel::test
