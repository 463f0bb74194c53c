// SPDX-License-Identifier: GPL-3.0-or-later
// .off of Geomview: [ST][C][N][4][n]OFF.
#include <fmt/format.h>

#include "core/io/number.h"
#include "core/io/source.h"
#include "core/io/surface.h"
#include "core/io/text_parser.h"

namespace confidel::io {

namespace {

struct Layout {
  bool texture = false;
  bool colour = false;
  bool normal = false;
  bool homogeneous = false;
  bool announces_dimension = false;
};

struct Counts {
  int vertices = 0;
  int faces = 0;
};

/// Takes the prefixes (in any order: writers differ) and OFF from the text; false if it is something else.
bool take_keyword(std::string_view& text, Layout& layout) {
  const auto take = [&](std::string_view prefix, bool& flag) {
    if (flag || !text.starts_with(prefix)) return false;
    text.remove_prefix(prefix.size());
    return flag = true;
  };
  while (take("ST", layout.texture) || take("C", layout.colour) || take("N", layout.normal) ||
         take("4", layout.homogeneous) || take("n", layout.announces_dimension)) {
  }
  if (!text.starts_with("OFF")) return false;
  text.remove_prefix(3);
  return true;
}

/// The header may stand on one line, on several, or have its first number glued to the keyword.
Counts read_header(TextParser& parser, Layout& layout) {
  parser.need("OFF");
  std::string_view glued = parser.text(0);
  if (!take_keyword(glued, layout)) {
    parser.problems().stop("E-SYNTAX", parser.place(0),
                           fmt::format("{} where [ST][C][N][4][n]OFF is expected", quoted(parser.text(0))));
  }
  if (!glued.empty() && (glued.front() < '0' || glued.front() > '9')) {
    parser.problems().stop("E-SYNTAX", parser.place(0),
                           fmt::format("{} where OFF, or OFF and a count, is expected", quoted(parser.text(0))));
  }
  if (parser.size() > 1 && parser.text(1) == "BINARY") {
    parser.problems().stop("E-FORMAT", parser.place(1), "binary .off is not read: write it as text, or as .ply");
  }
  // Numbers of the header come from fields, except that the first may be the rest of the keyword.
  int glued_value = -1;
  std::size_t field = 1;
  if (!glued.empty()) {
    Problems& problems = parser.problems();
    Place place = parser.place(0);
    place.column += static_cast<int>(parser.text(0).size() - glued.size());
    if (parse_integer(glued, glued_value) != NumberStatus::ok) {
      problems.stop("E-COUNT", place, fmt::format("count {} is not a number that can be true", quoted(glued)));
    }
  }
  const auto next_line_if_used_up = [&](const char* expected) {
    if (glued_value < 0 && field == parser.size()) {
      parser.need(expected);
      field = 0;
    }
  };
  if (layout.announces_dimension) {
    next_line_if_used_up("the dimension of nOFF");
    const Place place = parser.place(glued_value < 0 ? field : 0);
    const int dimension = glued_value < 0 ? parser.count(field++, "dimension") : glued_value;
    glued_value = -1;
    if (dimension != 3) {
      parser.problems().stop("E-VALUE", place, fmt::format("dimension {}: only 3 is read", dimension));
    }
  }
  next_line_if_used_up("the counts of vertices and faces");
  const std::size_t behind_first = glued_value < 0 ? field + 1 : field;
  parser.need_fields(behind_first + 1, behind_first + 2,
                     "number of vertices, number of faces, and perhaps number of edges (not used)");
  Counts counts;
  counts.vertices = glued_value < 0 ? parser.count(field, "number of vertices") : glued_value;
  counts.faces = parser.count(behind_first, "number of faces");
  if (parser.size() == behind_first + 2) parser.integer(behind_first + 1, "number of edges");
  return counts;
}

void read_vertices(TextParser& parser, const Layout& layout, int count, Input& input) {
  const std::size_t coordinates = layout.homogeneous ? 4 : 3;
  const std::size_t others = (layout.normal ? 3 : 0) + (layout.texture ? 2 : 0);
  const std::size_t least = coordinates + others + (layout.colour ? 3 : 0);
  const std::size_t most = coordinates + others + (layout.colour ? 4 : 0);
  const std::string meaning = fmt::format("a vertex row is: {}{}{}{}", layout.homogeneous ? "x y z w" : "x y z",
                                          layout.normal ? ", normal (3)" : "", layout.colour ? ", colour (3 or 4)" : "",
                                          layout.texture ? ", texture coordinates (2)" : "");
  for (int i = 0; i < count; ++i) {
    parser.need_row("vertices", i, count);
    InputVertex vertex;
    vertex.line = parser.line();
    if (parser.has_fields(least, most, meaning)) {
      vertex.position = parser.point(0, 3);
      if (layout.homogeneous && parser.real(3, "w") != 1) {
        parser.problems().add("E-VALUE", parser.place(3), "w must be 1: a quotient is in general no double");
      }
      for (std::size_t field = coordinates; field < parser.size(); ++field) parser.real(field, "normal or colour");
    }
    input.vertices.push_back(vertex);
  }
}

void read_faces(TextParser& parser, int count, Input& input) {
  FaceCollector faces(input);
  for (int i = 0; i < count; ++i) {
    parser.need_row("faces", i, count);
    const int corners = parser.count(0, "number of corners");
    if (corners == 0) {
      parser.problems().add("E-VALUE", parser.place(0), "a face has at least one corner");
      continue;
    }
    const std::size_t end = 1 + static_cast<std::size_t>(corners);
    if (parser.size() < end || parser.size() > end + 4 || parser.size() == end + 2) {
      parser.has_fields(end, parser.size() == end + 2 ? end + 1 : end + 4,
                        fmt::format("a face row is: {}, its corners, and a colour of 0, 1, 3 or 4 numbers", corners));
      continue;
    }
    std::vector<int> indices;
    for (std::size_t field = 1; field < end; ++field) indices.push_back(parser.vertex(field, 0, input.vertices.size()));
    for (std::size_t field = end; field < parser.size(); ++field) parser.real(field, "colour");
    faces.add(std::move(indices), 0, parser.line());
  }
  faces.finish();
}

}  // namespace

Input read_off(const Source& source) {
  Problems problems;
  TextParser parser(source.file, source.text, problems);
  Input input;
  input.file = source.file;
  input.vertex_file = source.file;
  input.triangle_soup = true;
  Layout layout;
  const Counts counts = read_header(parser, layout);
  read_vertices(parser, layout, counts.vertices, input);
  read_faces(parser, counts.faces, input);
  parser.expect_end(fmt::format("the header announces {} vertices and {} faces", counts.vertices, counts.faces));
  problems.throw_if_any();
  return input;
}

}  // namespace confidel::io
