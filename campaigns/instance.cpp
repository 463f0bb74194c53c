// SPDX-License-Identifier: GPL-3.0-or-later
#include "campaigns/instance.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "core/complex/build.h"

namespace confidel::campaigns {

namespace {

bool is_simple(const InputFacet& facet) {
  return facet.polygons.size() == 1 && facet.polygons[0].corners.size() >= 3 && facet.holes.empty();
}

bool has_markers(const Input& input) {
  return std::any_of(input.facets.begin(), input.facets.end(), [](const InputFacet& facet) { return facet.marker != 0; });
}

std::string row(int index, const Position& position, int dimension) {
  std::string text = fmt::format("{} {} {}", index, position[0], position[1]);
  if (dimension == 3) text += fmt::format(" {}", position[2]);
  return text + "\n";
}

std::string corners_text(const InputPolygon& polygon) {
  std::string text = fmt::format("{}", polygon.corners.size());
  for (const int corner : polygon.corners) text += fmt::format(" {}", corner);
  return text;
}

std::string points_text(const std::vector<Position>& points, int dimension) {
  std::string text = fmt::format("{}\n", points.size());
  for (std::size_t i = 0; i < points.size(); ++i) text += row(static_cast<int>(i), points[i], dimension);
  return text;
}

std::string vertices_text(const Input& input) {
  std::string text = fmt::format("{} {} 0 0\n", input.vertices.size(), input.dimension);
  for (std::size_t i = 0; i < input.vertices.size(); ++i) text += row(static_cast<int>(i), input.vertices[i].position, input.dimension);
  return text;
}

std::string planar_poly(const Input& input) {
  std::string text = vertices_text(input) + fmt::format("{} 0\n", input.segments.size());
  for (std::size_t i = 0; i < input.segments.size(); ++i) text += fmt::format("{} {} {}\n", i, input.segments[i].ends[0], input.segments[i].ends[1]);
  return text + points_text(input.holes, 2);
}

std::string obj(const Input& input) {
  std::string text;
  for (const InputVertex& vertex : input.vertices) text += fmt::format("v {} {} {}\n", vertex.position[0], vertex.position[1], vertex.position[2]);
  int marker = 0;
  for (const InputFacet& facet : input.facets) {
    if (facet.marker != marker) text += fmt::format("g marker{}\n", facet.marker);
    marker = facet.marker;
    text += "f";
    for (const int corner : facet.polygons[0].corners) text += fmt::format(" {}", corner + 1);
    text += "\n";
  }
  for (const InputSegment& segment : input.segments) text += fmt::format("l {} {}\n", segment.ends[0] + 1, segment.ends[1] + 1);
  return text;
}

std::string facets_text(const Input& input, bool simple) {
  const bool markers = has_markers(input);
  std::string text = fmt::format("{} {}\n", input.facets.size(), markers ? 1 : 0);
  for (const InputFacet& facet : input.facets) {
    if (simple) {
      text += corners_text(facet.polygons[0]) + (markers ? fmt::format(" {}\n", facet.marker) : "\n");
      continue;
    }
    text += fmt::format("{} {}", facet.polygons.size(), facet.holes.size()) + (markers ? fmt::format(" {}\n", facet.marker) : "\n");
    for (const InputPolygon& polygon : facet.polygons) text += corners_text(polygon) + "\n";
    for (std::size_t i = 0; i < facet.holes.size(); ++i) text += row(static_cast<int>(i), facet.holes[i], 3);
  }
  return text;
}

}  // namespace

int Maker::vertex(const Position& position) {
  input_.vertices.push_back({position, 0, 0});
  for (double& coordinate : input_.vertices.back().position) coordinate += 0.0;  // -0 is 0, as readers have it
  return size() - 1;
}

void Maker::facet(const std::vector<std::vector<int>>& polygons, const std::vector<Position>& holes) {
  InputFacet facet;
  for (const auto& corners : polygons) facet.polygons.push_back({corners, 0});
  facet.holes = holes;
  input_.facets.push_back(std::move(facet));
}

bool is_valid(const Input& input) {
  try {
    build_complex(input);
  } catch (const InputError&) {
    return false;
  }
  return true;
}

Input without_unused_vertices(const Input& input) {
  if (input.dimension == 2) return input;
  std::vector<int> number(input.vertices.size(), -1);
  const auto use = [&](int vertex) { number[static_cast<std::size_t>(vertex)] = 0; };
  for (const InputFacet& facet : input.facets)
    for (const InputPolygon& polygon : facet.polygons) std::for_each(polygon.corners.begin(), polygon.corners.end(), use);
  for (const InputSegment& segment : input.segments) std::for_each(segment.ends.begin(), segment.ends.end(), use);
  Input result = input;
  result.vertices.clear();
  for (std::size_t i = 0; i < number.size(); ++i) {
    if (number[i] < 0) continue;
    number[i] = static_cast<int>(result.vertices.size());
    result.vertices.push_back(input.vertices[i]);
  }
  const auto renumber = [&](int& vertex) { vertex = number[static_cast<std::size_t>(vertex)]; };
  for (InputFacet& facet : result.facets)
    for (InputPolygon& polygon : facet.polygons) std::for_each(polygon.corners.begin(), polygon.corners.end(), renumber);
  for (InputSegment& segment : result.segments) std::for_each(segment.ends.begin(), segment.ends.end(), renumber);
  return result;
}

std::string suffix_for(const Input& input) {
  if (input.dimension == 2) return ".poly";
  const bool simple = std::all_of(input.facets.begin(), input.facets.end(), is_simple);
  if (!input.segments.empty() || input.triangle_soup) {
    if (!simple || !input.holes.empty()) throw std::invalid_argument("no format has hanging segments and facets of several polygons");
    return ".obj";
  }
  return simple ? ".smesh" : ".poly";
}

std::string input_text(const Input& input, const std::string& remark) {
  const std::string suffix = suffix_for(input);
  const std::string head = remark.empty() ? "" : "# " + remark + "\n";
  if (input.dimension == 2) return head + planar_poly(input);
  if (suffix == ".obj") return head + obj(input);
  return head + vertices_text(input) + facets_text(input, suffix == ".smesh") + points_text(input.holes, 3);
}

}  // namespace confidel::campaigns
