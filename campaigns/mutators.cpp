// SPDX-License-Identifier: GPL-3.0-or-later
#include "campaigns/mutators.h"

#include <gmpxx.h>

#include <algorithm>
#include <limits>
#include <stdexcept>

#include "campaigns/instance.h"
#include "campaigns/shapes.h"

namespace confidel::campaigns {

namespace {

using Changed = std::optional<Input>;

bool only_triangles(const Input& input) {
  return std::all_of(input.facets.begin(), input.facets.end(), [](const InputFacet& facet) {
    return facet.polygons.size() == 1 && facet.polygons[0].corners.size() == 3 && facet.holes.empty();
  });
}

/// The middle of two positions, if it is exact.
std::optional<Position> middle(const Position& a, const Position& b) {
  Position result{};
  for (std::size_t i = 0; i < 3; ++i) {
    result[i] = a[i] / 2 + b[i] / 2;
    if (2 * mpq_class(result[i]) != mpq_class(a[i]) + mpq_class(b[i])) return std::nullopt;
  }
  return result;
}

Changed snap(const Input& input, Random& random) {
  Input result = input;
  const int bits = random.integer(1, 8);
  double greatest = 0;
  for (const InputVertex& vertex : input.vertices)
    for (const double coordinate : vertex.position) greatest = std::max(greatest, std::abs(coordinate));
  int exponent = 0;
  std::frexp(greatest, &exponent);
  for (InputVertex& vertex : result.vertices)
    for (double& coordinate : vertex.position) coordinate = std::ldexp(std::nearbyint(std::ldexp(coordinate, bits - exponent)), exponent - bits) + 0.0;
  return result;
}

Changed move_by_an_ulp(const Input& input, Random& random) {
  if (!only_triangles(input)) return std::nullopt;
  Input result = input;
  for (int i = random.integer(1, 3); i > 0; --i) {
    double& coordinate = result.vertices[random.index(result.vertices.size())].position[random.index(static_cast<std::size_t>(input.dimension))];
    coordinate = std::nextafter(coordinate, random.one_in(2) ? std::numeric_limits<double>::infinity() : -std::numeric_limits<double>::infinity()) + 0.0;
  }
  return result;
}

/// Space pressed to half its height: what faces each other is half as far apart, and what is flat stays so.
Changed halve_gap(const Input& input, Random& random) {
  const std::size_t axis = random.index(static_cast<std::size_t>(input.dimension));
  Input result = input;
  bool exact = true;
  const auto press = [&](Position& position) {
    const double half = position[axis] / 2;
    exact = exact && 2 * half == position[axis];
    position[axis] = half;
  };
  for (InputVertex& vertex : result.vertices) press(vertex.position);
  for (InputFacet& facet : result.facets) std::for_each(facet.holes.begin(), facet.holes.end(), press);
  std::for_each(result.holes.begin(), result.holes.end(), press);
  if (!exact) return std::nullopt;
  return result;
}

Changed vertex_on_edge(const Input& input, Random& random) {
  Input result = input;
  std::array<int, 2> ends{};
  if (!input.segments.empty() && (input.facets.empty() || random.one_in(2))) {
    ends = random.choose(input.segments).ends;
  } else if (!input.facets.empty()) {
    const auto& corners = random.choose(random.choose(input.facets).polygons).corners;
    if (corners.size() < 2) return std::nullopt;
    const std::size_t i = random.index(corners.size());
    ends = {corners[i], corners[(i + 1) % corners.size()]};
  } else {
    return std::nullopt;
  }
  const auto position = middle(input.vertices[static_cast<std::size_t>(ends[0])].position, input.vertices[static_cast<std::size_t>(ends[1])].position);
  if (!position) return std::nullopt;
  const int added = static_cast<int>(result.vertices.size());
  result.vertices.push_back({*position, 0, 0});
  if (input.dimension == 2) return result;  // that vertices on segments split them is the builder's business
  if (!input.segments.empty()) {
    // Another segment ends there.
    const Position apex = sum(*position, {random.real(8), random.real(8), random.real(8)});
    result.vertices.push_back({apex, 0, 0});
    result.segments.push_back({{added, added + 1}, 0, 0});
    return result;
  }
  for (InputFacet& facet : result.facets)
    for (InputPolygon& polygon : facet.polygons)
      for (std::size_t i = 0; i < polygon.corners.size() && polygon.corners.size() > 1; ++i) {
        const int a = polygon.corners[i], b = polygon.corners[(i + 1) % polygon.corners.size()];
        if (std::min(a, b) != std::min(ends[0], ends[1]) || std::max(a, b) != std::max(ends[0], ends[1])) continue;
        if (polygon.corners.size() == 2) return std::nullopt;  // a slit would need two polygons
        polygon.corners.insert(polygon.corners.begin() + static_cast<std::ptrdiff_t>(i) + 1, added);
        break;
      }
  return result;
}

/// An isolated vertex in a facet, or a hanging edge that stands on it.
Changed vertex_in_facet(const Input& input, Random& random) {
  if (input.facets.empty()) return std::nullopt;
  Input result = input;
  InputFacet& facet = result.facets[random.index(result.facets.size())];
  const auto& corners = facet.polygons[0].corners;
  const auto at = [&](std::size_t i) { return input.vertices[static_cast<std::size_t>(corners[i])].position; };
  const std::size_t i = random.index(corners.size());
  const auto base = middle(at((i + 1) % corners.size()), at((i + 2) % corners.size()));
  const auto position = base ? middle(*base, at(i)) : std::nullopt;
  if (!position) return std::nullopt;
  const int added = static_cast<int>(result.vertices.size());
  result.vertices.push_back({*position, 0, 0});
  if (!input.segments.empty() || input.triangle_soup) {
    result.vertices.push_back({sum(*position, {random.real(8), random.real(8), random.real(8)}), 0, 0});
    result.segments.push_back({{added, added + 1}, 0, 0});
  } else {
    facet.polygons.push_back({{added}, 0});
  }
  return result;
}

Changed split_facet(const Input& input, Random& random) {
  if (input.facets.empty()) return std::nullopt;
  const std::size_t chosen = random.index(input.facets.size());
  const InputFacet& facet = input.facets[chosen];
  if (facet.polygons.size() != 1 || !facet.holes.empty() || facet.polygons[0].corners.size() < 4) return std::nullopt;
  auto corners = facet.polygons[0].corners;
  std::rotate(corners.begin(), corners.begin() + random.integer(0, static_cast<int>(corners.size()) - 1), corners.end());
  const std::ptrdiff_t cut = random.integer(2, static_cast<int>(corners.size()) - 2);
  Input result = input;
  result.facets[chosen].polygons[0].corners.assign(corners.begin(), corners.begin() + cut + 1);
  InputFacet rest = facet;
  rest.polygons[0].corners.assign(corners.begin() + cut, corners.end());
  rest.polygons[0].corners.push_back(corners[0]);
  result.facets.push_back(rest);
  return result;
}

/// Reading it as a triangle soup merges coplanar neighbours; or the other way round.
Changed merge_coplanar(const Input& input, Random&) {
  if (input.dimension == 2 || (!input.segments.empty() && input.triangle_soup)) return std::nullopt;
  Input result = input;
  result.triangle_soup = !input.triangle_soup;
  try {
    suffix_for(result);
  } catch (const std::invalid_argument&) {
    return std::nullopt;
  }
  return result;
}

Changed union_with_translate(const Input& input, Random& random) { return far_union(input, input, random); }
Changed permute(const Input& input, Random& random) { return permuted(input, random); }
Changed permute_axes(const Input& input, Random& random) { return with_permuted_axes(input, random); }
Changed scale(const Input& input, Random& random) { return scaled(input, random.integer(-40, 40)); }

}  // namespace

const std::vector<Mutator>& mutators() {
  static const std::vector<Mutator> all{
      {"snap", "all vertices to a coarse grid", snap},
      {"ulp", "some coordinates by one unit in the last place (complexes of triangles only)", move_by_an_ulp},
      {"halve-gap", "one axis pressed to a half", halve_gap},
      {"vertex-on-edge", "a vertex exactly in the middle of an edge", vertex_on_edge},
      {"vertex-in-facet", "a vertex, or a hanging edge's end, exactly in a facet", vertex_in_facet},
      {"split-facet", "a polygon cut along a diagonal", split_facet},
      {"merge-coplanar", "coplanar neighbours become one facet, or cease to be", merge_coplanar},
      {"permute", "indices and orders permuted", permute},
      {"axes", "axes permuted and mirrored", permute_axes},
      {"rotate", "by a Pythagorean angle, times the hypotenuse", rotated},
      {"scale", "times a power of two", scale},
      {"union", "with a translate of itself", union_with_translate},
  };
  return all;
}

std::optional<Input> mutate(const Mutator& mutator, const Input& input, Random& random) {
  constexpr int proposals = 8;
  for (int i = 0; i < proposals; ++i) {
    auto proposal = mutator.propose(input, random);
    if (proposal && is_valid(*proposal)) return proposal;
  }
  return std::nullopt;
}

Input mutate(const Input& input, Random& random) {
  for (int i = 0; i < 8; ++i)
    if (auto result = mutate(random.choose(mutators()), input, random)) return std::move(*result);
  return input;
}

}  // namespace confidel::campaigns
