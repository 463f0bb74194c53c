// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/write.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/io/source.h"

namespace confidel {
namespace {

class Writer {
 public:
  Writer(const Input& input, const std::string& path) : input_(input), path_(path) {}

  WrittenInput write() {
    const std::string suffix = io::suffix(path_);
    if (suffix == ".poly") poly();
    else if (suffix == ".smesh") smesh();
    else if (suffix == ".off") off();
    else if (suffix == ".obj") obj();
    else refuse(fmt::format("the suffix '{}' names no format that can be written: use .poly, .smesh, .off, .obj", suffix));
    return std::move(result_);
  }

 private:
  [[noreturn]] void refuse(const std::string& why) const { throw InputError({{"E-FORMAT", {path_, 0, 0}, why}}); }

  template <class... Arguments>
  void put(fmt::format_string<Arguments...> format, Arguments&&... arguments) {
    result_.text += fmt::format(format, std::forward<Arguments>(arguments)...);
  }

  std::string position(const std::array<double, 3>& point) const {
    return input_.dimension == 2 ? fmt::format("{} {}", point[0], point[1]) : fmt::format("{} {} {}", point[0], point[1], point[2]);
  }

  std::string corners(const InputPolygon& polygon, int base) const {
    std::string text;
    for (const int corner : polygon.corners) text += fmt::format("{}{}", text.empty() ? "" : " ", corner + base);
    return text;
  }

  void need_space(const char* format) const {
    if (input_.dimension == 2) refuse(fmt::format("{} holds surfaces in space; write a planar input as .poly", format));
  }
  void need_no_segments(const char* format) const {
    if (!input_.segments.empty())
      refuse(fmt::format("{} of dimension 3 holds no segments outside facets, and there are {}; write .off or .obj", format, input_.segments.size()));
  }
  /// One loop per facet, and no holes: what all but .poly hold.
  void need_simple_facets(const char* format) const {
    for (const InputFacet& facet : input_.facets)
      if (facet.polygons.size() != 1 || !facet.holes.empty())
        refuse(fmt::format("{} holds facets of one polygon without holes, and that of line {} is none; write .poly", format, facet.line));
  }
  void need_no_volumes(const char* format) {
    if (!input_.holes.empty()) refuse(fmt::format("{} holds no hole points, and there are {}; write .poly or .smesh", format, input_.holes.size()));
    if (!input_.regions.empty()) result_.lost.push_back(fmt::format("{} regions: {} has none", input_.regions.size(), format));
  }

  void nodes() {
    const int markers = input_.has_markers ? 1 : 0, base = input_.first_index;
    put("{} {} 0 {}\n", input_.vertices.size(), input_.dimension, markers);
    for (std::size_t i = 0; i < input_.vertices.size(); ++i) {
      put("{} {}", i + base, position(input_.vertices[i].position));
      if (markers == 1) put(" {}", input_.vertices[i].marker);
      put("\n");
    }
  }

  void holes_and_regions() {
    const int base = input_.first_index;
    put("{}\n", input_.holes.size());
    for (std::size_t i = 0; i < input_.holes.size(); ++i) put("{} {}\n", i + base, position(input_.holes[i]));
    if (input_.regions.empty()) return;
    put("{}\n", input_.regions.size());
    for (std::size_t i = 0; i < input_.regions.size(); ++i) {
      const InputRegion& region = input_.regions[i];
      put("{} {} {} {}\n", i + base, position(region.seed), region.attribute, region.bound);
    }
  }

  void poly() {
    const int markers = input_.has_markers ? 1 : 0, base = input_.first_index;
    if (input_.dimension == 3) need_no_segments(".poly");
    nodes();
    if (input_.dimension == 2) {
      put("{} {}\n", input_.segments.size(), markers);
      for (std::size_t i = 0; i < input_.segments.size(); ++i) {
        const InputSegment& segment = input_.segments[i];
        put("{} {} {}", i + base, segment.ends[0] + base, segment.ends[1] + base);
        if (markers == 1) put(" {}", segment.marker);
        put("\n");
      }
    } else {
      put("{} {}\n", input_.facets.size(), markers);
      for (const InputFacet& facet : input_.facets) {
        put("{} {}", facet.polygons.size(), facet.holes.size());
        if (markers == 1) put(" {}", facet.marker);
        put("\n");
        for (const InputPolygon& polygon : facet.polygons) put("{} {}\n", polygon.corners.size(), corners(polygon, base));
        for (std::size_t i = 0; i < facet.holes.size(); ++i) put("{} {}\n", i + base, position(facet.holes[i]));
      }
    }
    holes_and_regions();
  }

  void smesh() {
    need_space(".smesh");
    need_no_segments(".smesh");
    need_simple_facets(".smesh");
    const int markers = input_.has_markers ? 1 : 0;
    nodes();
    put("{} {}\n", input_.facets.size(), markers);
    for (const InputFacet& facet : input_.facets) {
      put("{} {}", facet.polygons[0].corners.size(), corners(facet.polygons[0], input_.first_index));
      if (markers == 1) put(" {}", facet.marker);
      put("\n");
    }
    holes_and_regions();
  }

  void note_markers(const char* format) {
    const auto marked = [](const auto& each) { return each.marker != 0; };
    const auto count = std::count_if(input_.facets.begin(), input_.facets.end(), marked) + std::count_if(input_.segments.begin(), input_.segments.end(), marked);
    if (count > 0) result_.lost.push_back(fmt::format("the markers of {} facets and segments: {} has none", count, format));
  }

  void off() {
    need_space(".off");
    need_simple_facets(".off");
    need_no_volumes(".off");
    note_markers(".off");
    put("OFF\n{} {} 0\n", input_.vertices.size(), input_.facets.size() + input_.segments.size());
    for (const InputVertex& vertex : input_.vertices) put("{}\n", position(vertex.position));
    for (const InputFacet& facet : input_.facets) put("{} {}\n", facet.polygons[0].corners.size(), corners(facet.polygons[0], 0));
    for (const InputSegment& segment : input_.segments) put("2 {} {}\n", segment.ends[0], segment.ends[1]);
  }

  void obj() {
    need_space(".obj");
    need_simple_facets(".obj");
    need_no_volumes(".obj");
    for (const InputVertex& vertex : input_.vertices) put("v {}\n", position(vertex.position));
    // Facets of one marker are one group; readers number groups in their order.
    int group = 0;
    const auto begin_group = [&](int marker) {
      if (marker != group) put("g marker{}\n", marker);
      group = marker;
    };
    for (const InputFacet& facet : input_.facets) {
      begin_group(facet.marker);
      put("f {}\n", corners(facet.polygons[0], 1));
    }
    for (const InputSegment& segment : input_.segments) {
      begin_group(segment.marker);
      put("l {} {}\n", segment.ends[0] + 1, segment.ends[1] + 1);
    }
  }

  const Input& input_;
  const std::string& path_;
  WrittenInput result_;
};

}  // namespace

WrittenInput written_input(const Input& input, const std::string& path) { return Writer(input, path).write(); }

}  // namespace confidel
