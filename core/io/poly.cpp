// SPDX-License-Identifier: GPL-3.0-or-later
// .poly of Triangle (dimension 2) and of TetGen (dimension 3), and TetGen's .smesh.
#include <fmt/format.h>

#include "core/io/node.h"
#include "core/io/source.h"
#include "core/io/text_parser.h"

namespace confidel::io {

namespace {

/// Polygons are the only records that may wrap: a cursor that runs over fields and lines.
class PolygonCursor {
 public:
  explicit PolygonCursor(TextParser& parser) : parser_(parser) {}

  /// Reads k v1 .. vk. Afterwards field() is the first field behind it, on the line where it ends.
  InputPolygon read(const Input& input) {
    InputPolygon polygon;
    polygon.line = parser_.line();
    const int corners = parser_.count(0, "number of corners");
    if (corners == 0) {
      parser_.problems().stop("E-VALUE", parser_.place(0), "a polygon has at least one corner");
    }
    field_ = 1;
    for (int i = 0; i < corners; ++i, ++field_) {
      if (field_ == parser_.size()) {
        parser_.need(
            fmt::format("corner {} of {} of the polygon that begins at line {}", i + 1, corners, polygon.line));
        field_ = 0;
      }
      polygon.corners.push_back(parser_.vertex(field_, input.first_index, input.vertices.size()));
    }
    line_ = polygon.line;
    corners_ = corners;
    return polygon;
  }

  /// Checks that so many fields follow on the line; reports them otherwise, as the text is out of step then.
  void need_rest(std::size_t fields, const char* meaning) {
    if (parser_.size() == field_ + fields) return;
    parser_.need_fields(
        field_ + fields, field_ + fields,
        fmt::format("the polygon that begins at line {} announces {} corners{}", line_, corners_, meaning));
  }
  std::size_t field() const { return field_; }

 private:
  TextParser& parser_;
  std::size_t field_ = 0;
  int line_ = 0;
  int corners_ = 0;
};

std::vector<std::array<double, 3>> read_points(TextParser& parser, int count, const Input& input, const char* section) {
  const std::size_t fields = 1 + static_cast<std::size_t>(input.dimension);
  std::vector<std::array<double, 3>> points;
  long long expected = input.first_index;
  for (int i = 0; i < count; ++i) {
    parser.need_row(section, i, count);
    if (!parser.has_fields(fields, fields,
                           input.dimension == 2 ? "a hole row is: index, x, y" : "a hole row is: index, x, y, z")) {
      ++expected;
      continue;
    }
    expected = parser.row_index(0, "hole row", expected);
    points.push_back(parser.point(1, input.dimension));
  }
  return points;
}

void read_holes_and_regions(TextParser& parser, Input& input) {
  parser.need("the number of holes (0 if there are none)");
  parser.need_fields(1, 1, "number of holes");
  const int holes = parser.count(0, "number of holes");
  input.holes = read_points(parser, holes, input, "holes");

  if (!parser.next()) return;  // The section of regions is optional.
  parser.need_fields(1, 1, fmt::format("number of regions ({} holes were announced)", holes));
  const int regions = parser.count(0, "number of regions");
  const std::size_t fields = 2 + static_cast<std::size_t>(input.dimension);
  long long expected = input.first_index;
  for (int i = 0; i < regions; ++i) {
    parser.need_row("regions", i, regions);
    if (!parser.has_fields(fields, fields + 1, "a region row is: index, coordinates, attribute, and perhaps a bound")) {
      ++expected;
      continue;
    }
    InputRegion region;
    region.line = parser.line();
    expected = parser.row_index(0, "region row", expected);
    region.seed = parser.point(1, input.dimension);
    region.attribute = parser.real(fields - 1, "attribute");
    if (parser.size() > fields) region.bound = parser.real(fields, "bound");
    if (region.bound < 0) region.bound = -1;
    input.regions.push_back(region);
  }
  parser.expect_end(fmt::format("{} regions were announced", regions));
}

void read_segments(TextParser& parser, Input& input) {
  parser.need("the segments' header (count, markers)");
  parser.need_fields(2, 2, "number of segments, number of markers (0 or 1)");
  const int count = parser.count(0, "number of segments");
  const int markers = parser.choice(1, "number of markers", 0, 1);
  input.has_markers = input.has_markers || markers == 1;
  const std::size_t fields = 3 + static_cast<std::size_t>(markers);
  long long expected = input.first_index;
  for (int i = 0; i < count; ++i) {
    parser.need_row("segments", i, count);
    if (!parser.has_fields(fields, fields,
                           markers == 1 ? "a segment row is: index, first vertex, second vertex, marker"
                                        : "a segment row is: index, first vertex, second vertex")) {
      ++expected;
      continue;
    }
    InputSegment segment;
    segment.line = parser.line();
    expected = parser.row_index(0, "segment row", expected);
    for (std::size_t end = 0; end < 2; ++end) {
      segment.ends[end] = parser.vertex(1 + end, input.first_index, input.vertices.size());
    }
    if (markers == 1) segment.marker = parser.integer(3, "marker");
    input.segments.push_back(segment);
  }
}

InputFacet read_facet(TextParser& parser, const Input& input, int markers) {
  InputFacet facet;
  facet.line = parser.line();
  if (markers == 1) {
    parser.need_fields(3, 3, "a facet begins with: number of polygons, number of holes, marker");
  } else {
    parser.need_fields(1, 2,
                       "a facet begins with: number of polygons, and perhaps number of holes (no markers announced)");
  }
  const int polygons = parser.count(0, "number of polygons");
  if (polygons == 0) parser.problems().stop("E-VALUE", parser.place(0), "a facet has at least one polygon");
  const int holes = parser.size() > 1 ? parser.count(1, "number of facet holes") : 0;
  if (markers == 1) facet.marker = parser.integer(2, "marker");
  for (int i = 0; i < polygons; ++i) {
    parser.need_row("polygons of a facet", i, polygons);
    PolygonCursor cursor(parser);
    facet.polygons.push_back(cursor.read(input));
    cursor.need_rest(0, "");
  }
  facet.holes = read_points(parser, holes, input, "holes of a facet");
  return facet;
}

InputFacet read_simple_facet(TextParser& parser, const Input& input, int markers) {
  InputFacet facet;
  facet.line = parser.line();
  PolygonCursor cursor(parser);
  facet.polygons.push_back(cursor.read(input));
  cursor.need_rest(static_cast<std::size_t>(markers), markers == 1 ? ", then a marker" : " (no markers announced)");
  if (markers == 1) facet.marker = parser.integer(cursor.field(), "marker");
  return facet;
}

void read_facets(TextParser& parser, Input& input, InputFacet (*read_one)(TextParser&, const Input&, int)) {
  parser.need("the facets' header (count, markers)");
  parser.need_fields(2, 2, "number of facets, number of markers (0 or 1)");
  const int count = parser.count(0, "number of facets");
  const int markers = parser.choice(1, "number of markers", 0, 1);
  input.has_markers = input.has_markers || markers == 1;
  for (int i = 0; i < count; ++i) {
    parser.need_row("facets", i, count);
    input.facets.push_back(read_one(parser, input, markers));
  }
}

}  // namespace

Input read_poly(const Source& source) {
  Problems problems;
  TextParser parser(source.file, source.text, problems);
  Input input;
  input.file = source.file;
  read_nodes(source, parser, 2, input);
  if (input.dimension == 2) {
    read_segments(parser, input);
  } else {
    read_facets(parser, input, read_facet);
  }
  read_holes_and_regions(parser, input);
  problems.throw_if_any();
  return input;
}

Input read_smesh(const Source& source) {
  Problems problems;
  TextParser parser(source.file, source.text, problems);
  Input input;
  input.file = source.file;
  read_nodes(source, parser, 3, input);
  read_facets(parser, input, read_simple_facet);
  read_holes_and_regions(parser, input);
  problems.throw_if_any();
  return input;
}

}  // namespace confidel::io
