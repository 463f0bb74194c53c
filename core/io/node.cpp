// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/node.h"

#include <fmt/format.h>

#include <filesystem>

namespace confidel::io {

namespace {

struct Header {
  int count = 0;
  int dimension = 0;
  int attributes = 0;
  int markers = 0;
  Place dimension_place;
};

Header read_header(TextParser& parser, int least_dimension) {
  parser.need("the vertices' header (count, dimension, attributes, markers)");
  parser.need_fields(4, 4, "number of vertices, dimension, number of attributes, number of markers");
  Header header;
  header.count = parser.count(0, "number of vertices");
  header.dimension = parser.choice(1, "dimension", least_dimension, 3);
  header.attributes = parser.choice(2, "number of attributes", 0, 1000);
  header.markers = parser.choice(3, "number of markers", 0, 1);
  header.dimension_place = parser.place(1);
  return header;
}

void read_rows(TextParser& parser, const Header& header, Input& input) {
  const std::size_t coordinates_end = 1 + static_cast<std::size_t>(header.dimension);
  const std::size_t attributes_end = coordinates_end + static_cast<std::size_t>(header.attributes);
  const std::size_t fields = attributes_end + static_cast<std::size_t>(header.markers);
  const std::string layout = fmt::format("a vertex row is: index, {} coordinates, {} attributes, {} marker(s)",
                                         header.dimension, header.attributes, header.markers);
  long long expected = 0;
  for (int i = 0; i < header.count; ++i) {
    parser.need_row("vertices", i, header.count);
    InputVertex vertex;
    vertex.line = parser.line();
    if (i == 0) {
      // Everything else is counted from here.
      parser.need_fields(fields, fields, layout);
      input.first_index = parser.integer(0, "index of the first vertex");
      parser.problems().throw_if_any();
      if (input.first_index != 0 && input.first_index != 1) {
        parser.problems().stop(
            "E-INDEX", parser.place(0),
            fmt::format("the first vertex has index {}: number the vertices from 0 or 1", input.first_index));
      }
      expected = input.first_index;
    }
    if (parser.has_fields(fields, fields, layout)) {
      expected = parser.row_index(0, "vertex row", expected);
      vertex.position = parser.point(1, header.dimension);
      for (std::size_t field = coordinates_end; field < attributes_end; ++field) parser.real(field, "attribute");
      if (header.markers == 1) vertex.marker = parser.integer(attributes_end, "marker");
    } else {
      ++expected;
    }
    input.vertices.push_back(vertex);
  }
}

}  // namespace

void read_nodes(const Source& source, TextParser& parser, int least_dimension, Input& input) {
  const Header header = read_header(parser, least_dimension);
  input.dimension = header.dimension;
  input.vertex_file = source.file;
  if (header.count > 0) {
    input.has_markers = input.has_markers || header.markers == 1;
    read_rows(parser, header, input);
    return;
  }
  const std::string companion = std::filesystem::path(source.file).replace_extension(".node").string();
  Source nodes;
  try {
    nodes = load(companion);
  } catch (const FileError& error) {
    throw FileError(fmt::format("{}:{}: the file has no vertices of its own, and its companion is missing: {}",
                                source.file, header.dimension_place.line, error.what()));
  }
  TextParser node_parser(companion, nodes.text, parser.problems());
  const Header node_header = read_header(node_parser, 2);
  if (node_header.dimension != header.dimension) {
    parser.problems().stop(
        "E-VALUE", node_header.dimension_place,
        fmt::format("dimension {}, but {} says {}", node_header.dimension, source.file, header.dimension));
  }
  if (node_header.count == 0) {
    parser.problems().stop("E-EMPTY", {companion, node_header.dimension_place.line, 0}, "there are no vertices");
  }
  input.vertex_file = companion;
  input.has_markers = input.has_markers || node_header.markers == 1;
  read_rows(node_parser, node_header, input);
  node_parser.expect_end(fmt::format("the header announces {} vertices", node_header.count));
}

}  // namespace confidel::io
