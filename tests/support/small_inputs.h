// SPDX-License-Identifier: GPL-3.0-or-later
// Small inputs with everything that makes placement hard, mild enough for a few hundred points.
#pragma once

#include <cmath>
#include <string>

#include "tests/core/complex/inputs.h"

namespace confidel::test {

struct NamedInput {
  std::string name;
  Input input;
};

inline Input triangles(const std::vector<Position>& vertices, const std::vector<std::vector<int>>& facets, const std::vector<Pair>& hanging = {}) {
  InputMaker maker;
  maker.vertices(vertices);
  for (const auto& facet : facets) maker.facet({facet});
  for (const auto& [a, b] : hanging) maker.segment(a, b);
  return maker;
}

/// Two triangles at an edge; apex_x = 0.5: mirror images.
inline Input wedge(double degrees, double apex_x) {
  const double height = std::sqrt(0.75), angle = degrees * 3.14159265358979324 / 180;
  return triangles({{0, 0, 0}, {1, 0, 0}, {0.5, height, 0}, {apex_x, height * std::cos(angle), height * std::sin(angle)}}, {{0, 1, 2}, {0, 1, 3}});
}

inline Input fan(const std::vector<double>& apexes) {
  std::vector<Position> vertices{{0, 0, 0}, {1, 0, 0}};
  std::vector<std::vector<int>> facets;
  for (std::size_t k = 0; k < apexes.size(); ++k) {
    const double angle = 2 * 3.14159265358979324 * static_cast<double>(k) / static_cast<double>(apexes.size());
    vertices.push_back({apexes[k], std::sqrt(0.75) * std::cos(angle), std::sqrt(0.75) * std::sin(angle)});
    facets.push_back({0, 1, static_cast<int>(k) + 2});
  }
  return triangles(vertices, facets);
}

inline std::vector<NamedInput> small_inputs() {
  const std::vector<Position> cube{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};
  const std::vector<std::vector<int>> squares{{3, 2, 1, 0}, {4, 5, 6, 7}, {0, 1, 5, 4}, {2, 3, 7, 6}, {1, 2, 6, 5}, {3, 0, 4, 7}};
  std::vector<std::vector<int>> halves;
  for (const auto& q : squares) {
    halves.push_back({q[0], q[1], q[2]});
    halves.push_back({q[0], q[2], q[3]});
  }
  const std::vector<Position> flat_square = square();
  std::vector<NamedInput> all{
      {"milder W2", triangles({{0, 0, 0}, {12, 0, 0}, {0, 12, 0}, {12, 12, 4}}, {{0, 1, 2}, {0, 1, 3}})},
      {"milder W3", triangles({{0, 0, 0}, {20, 0, 0}, {0, 20, 0}, {20, 20, 7}, {10, 10, -14}}, {{0, 1, 2}, {0, 1, 3}, {0, 1, 4}})},
      {"milder G3", triangles({{0, 0, 0}, {20, 0, 0}, {0, 20, 0}, {20, 20, 5}, {0, 0, 28}, {10, 10, -14}, {-10, -10, -14}}, {{0, 1, 2}, {0, 3, 4}, {0, 5, 6}})},
      {"cube of squares", triangles(cube, squares)},
      {"cube of triangles", triangles(cube, halves)},
      {"tetrahedron", triangles({{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}}, {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}})},
      {"W2", triangles({{0, 0, 0}, {12, 0, 0}, {0, 12, 0}, {12, 12, 1}}, {{0, 1, 2}, {0, 1, 3}})},
      {"octahedron", triangles({{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}}, {{0, 2, 4}, {1, 2, 4}, {0, 3, 4}, {0, 2, 5}})},
      {"equal fan", fan({0.5, 0.5, 0.5, 0.5, 0.5})},
      {"skew fan", fan({0.5, 0.35, 0.6, 0.45, 0.7})},
      {"mirror wedge 5", wedge(5, 0.5)},
      {"skew wedge 40", wedge(40, 0.3)},
      {"skew wedge 20", wedge(20, 0.3)},
      {"skew wedge 12", wedge(12, 0.3)},
      {"hanging edge close over a facet", triangles({{0, 0, 0}, {6, 0, 0}, {0, 6, 0}, {1, 1, 0.5}, {3, 2, 0.75}}, {{0, 1, 2}}, {{3, 4}})},
      {"hanging chain that stands on a facet", triangles({{0, 0, 0}, {6, 0, 0}, {0, 6, 0}, {2, 2, 0}, {3, 2, 2}, {1, 1, 3}, {8, 8, 1}}, {{0, 1, 2}}, {{3, 4}, {4, 5}, {1, 6}})},
      {"two coplanar neighbours", triangles({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 4, 5}, {1, 2, 3, 4}})},
      {"two coplanar triangles and apexes", triangles({flat_square[0], flat_square[1], flat_square[2], flat_square[3], {0.5, 0.5, 2}, {0.5, 0.5, -2}}, {{0, 1, 2}, {0, 2, 3}})},
      {"only segments", triangles({{0, 0, 0}, {4, 0, 0}, {0, 3, 0}, {1, 1, 1}, {2, 1, 3}}, {}, {{0, 1}, {0, 2}, {3, 4}})},
  };
  InputMaker parts;
  parts.vertices({{0, 0, 0}, {16, 0, 0}, {16, 16, 0}, {0, 16, 0}, {3, 3, 0}, {6, 3, 0}, {6, 6, 0}, {3, 6, 0}, {9, 9, 0}, {13, 11, 0}, {4, 12, 0}, {10, 2, 0}, {10, 2, 6}, {14, 2, 6}, {12, 7, 0}})
      .facet({{0, 1, 2, 3}, {4, 5, 6, 7}, {8, 9}, {10}, {11}, {1, 14}}, {{4.5, 4.5, 0}})
      .facet({{11, 12, 13}});
  all.push_back({"facet with hole, slit, dangling segment and isolated vertices", parts});
  InputMaker tie;
  tie.vertices({{-20, -20, 0}, {20, -20, 0}, {20, 20, 0}, {-20, 20, 0}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}, {0, 0, 1}}).facet({{0, 1, 2, 3}, {4}, {5}, {6}, {7}});
  all.push_back({"vertex exactly on the sphere through isolated vertices", tie});
  InputMaker planar;
  planar.vertices({{0, 0, 1}, {8, 0, 1}, {8, 8, 1}, {0, 8, 1}, {4, 2, 1}, {6, 5, 1}, {3, 5, 1}}).facet({{0, 1, 2, 3}, {4, 5}, {6}});
  all.push_back({"one plane only", planar});
  InputMaker notch;
  notch.vertices({{0, 0, 0}, {6, 0, 0}, {6, 6, 3}, {4, 6, 3}, {3, 2, 1}, {2, 6, 3}, {0, 6, 3}, {3, 7, 8}}).facet({{0, 1, 2, 3, 4, 5, 6}}).facet({{0, 1, 7}});
  all.push_back({"facet with a notch", notch});
  return all;
}

}  // namespace confidel::test
