// SPDX-License-Identifier: GPL-3.0-or-later
// The exact maps.
#include <gmpxx.h>

#include <algorithm>
#include <array>
#include <stdexcept>

#include "campaigns/instance.h"
#include "campaigns/mutators.h"

namespace confidel::campaigns {

namespace {

template <class Map>
Input mapped(Input input, const Map& map) {
  const auto apply = [&](Position& position) {
    position = map(position);
    for (double& coordinate : position) coordinate += 0.0;  // -0 is 0
  };
  for (InputVertex& vertex : input.vertices) apply(vertex.position);
  for (InputFacet& facet : input.facets) std::for_each(facet.holes.begin(), facet.holes.end(), apply);
  std::for_each(input.holes.begin(), input.holes.end(), apply);
  input.regions.clear();
  return input;
}

/// The double that is the value, if it is one.
std::optional<double> exactly(const mpq_class& value) {
  const double rounded = value.get_d();
  if (!std::isfinite(rounded) || mpq_class(rounded) != value) return std::nullopt;
  return rounded;
}

double reach(const Input& input, int axis) {
  double greatest = 0;
  for (const InputVertex& vertex : input.vertices) greatest = std::max(greatest, std::abs(vertex.position[static_cast<std::size_t>(axis)]));
  return greatest;
}

}  // namespace

Input permuted(const Input& input, Random& random) {
  Input result = input;
  std::vector<int> order(input.vertices.size()), place(input.vertices.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = static_cast<int>(i);
  random.shuffle(order);
  for (std::size_t i = 0; i < order.size(); ++i) {
    result.vertices[i] = input.vertices[static_cast<std::size_t>(order[i])];
    place[static_cast<std::size_t>(order[i])] = static_cast<int>(i);
  }
  const auto renumber = [&](int& vertex) { vertex = place[static_cast<std::size_t>(vertex)]; };
  for (InputFacet& facet : result.facets) {
    for (InputPolygon& polygon : facet.polygons) {
      std::for_each(polygon.corners.begin(), polygon.corners.end(), renumber);
      std::rotate(polygon.corners.begin(), polygon.corners.begin() + random.integer(0, static_cast<int>(polygon.corners.size()) - 1), polygon.corners.end());
      if (random.one_in(2)) std::reverse(polygon.corners.begin(), polygon.corners.end());
    }
    random.shuffle(facet.polygons);
  }
  for (InputSegment& segment : result.segments) {
    std::for_each(segment.ends.begin(), segment.ends.end(), renumber);
    if (random.one_in(2)) std::swap(segment.ends[0], segment.ends[1]);
  }
  random.shuffle(result.facets);
  random.shuffle(result.segments);
  return result;
}

Input with_permuted_axes(const Input& input, Random& random) {
  std::vector<int> axes{0, 1};
  if (input.dimension == 3) axes.push_back(2);
  random.shuffle(axes);
  std::array<double, 3> signs{};
  for (double& sign : signs) sign = random.one_in(2) ? 1 : -1;
  return mapped(input, [&](const Position& from) {
    Position to{};
    for (std::size_t i = 0; i < axes.size(); ++i) to[i] = signs[i] * from[static_cast<std::size_t>(axes[i])];
    return to;
  });
}

std::optional<Input> rotated(const Input& input, Random& random) {
  const auto [p, q, r] = random.choose(std::vector<std::array<int, 3>>{{3, 4, 5}, {5, 12, 13}, {8, 15, 17}, {7, 24, 25}, {20, 21, 29}, {-4, 3, 5}, {-12, 5, 13}});
  const std::size_t axis = input.dimension == 3 ? random.index(3) : 2, u = (axis + 1) % 3, v = (axis + 2) % 3;
  bool exact = true;
  const Input result = mapped(input, [&, p = p, q = q, r = r](const Position& from) {
    Position to{};
    const auto set = [&](std::size_t i, const mpq_class& value) {
      const auto rounded = exactly(value);
      exact = exact && rounded;
      to[i] = rounded.value_or(0);
    };
    set(axis, mpq_class(from[axis]) * r);
    set(u, mpq_class(from[u]) * p - mpq_class(from[v]) * q);
    set(v, mpq_class(from[u]) * q + mpq_class(from[v]) * p);
    return to;
  });
  if (!exact) return std::nullopt;
  return result;
}

std::optional<Input> scaled(const Input& input, int power_of_two) {
  bool exact = true;
  const Input result = mapped(input, [&](const Position& from) {
    Position to{};
    for (std::size_t i = 0; i < 3; ++i) {
      to[i] = std::ldexp(from[i], power_of_two);
      exact = exact && std::isfinite(to[i]) && std::ldexp(to[i], -power_of_two) == from[i];
    }
    return to;
  });
  if (!exact) return std::nullopt;
  return result;
}

std::optional<Input> far_union(const Input& first, const Input& second, Random& random) {
  if (first.dimension != second.dimension || first.triangle_soup != second.triangle_soup) return std::nullopt;
  const int axis = random.integer(0, first.dimension - 1);
  double greatest = 0;
  for (int k = 0; k < 3; ++k) greatest = std::max({greatest, reach(first, k), reach(second, k)});
  if (greatest == 0) return std::nullopt;
  int exponent = 0;
  std::frexp(greatest, &exponent);
  const double step = std::ldexp(1.0, exponent + 3);
  bool exact = std::isfinite(step);
  const Input moved = mapped(second, [&](Position position) {
    const auto sum = exactly(mpq_class(position[static_cast<std::size_t>(axis)]) + (exact ? mpq_class(step) : mpq_class(0)));
    exact = exact && sum;
    position[static_cast<std::size_t>(axis)] = sum.value_or(0);
    return position;
  });
  if (!exact) return std::nullopt;
  Input result = first;
  const int offset = static_cast<int>(first.vertices.size());
  result.vertices.insert(result.vertices.end(), moved.vertices.begin(), moved.vertices.end());
  for (InputFacet facet : moved.facets) {
    for (InputPolygon& polygon : facet.polygons)
      for (int& corner : polygon.corners) corner += offset;
    result.facets.push_back(facet);
  }
  for (InputSegment segment : moved.segments) {
    for (int& end : segment.ends) end += offset;
    result.segments.push_back(segment);
  }
  result.holes.insert(result.holes.end(), moved.holes.begin(), moved.holes.end());
  try {
    suffix_for(result);
  } catch (const std::invalid_argument&) {
    return std::nullopt;
  }
  return result;
}

}  // namespace confidel::campaigns
