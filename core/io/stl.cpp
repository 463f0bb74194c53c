// SPDX-License-Identifier: GPL-3.0-or-later
// .stl, text and binary: a soup of triangles whose bit-identical corners are one vertex.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>

#include "core/io/bytes.h"
#include "core/io/source.h"
#include "core/io/surface.h"
#include "core/io/text_parser.h"

namespace confidel::io {

namespace {

constexpr std::size_t binary_header = 84;
constexpr std::size_t binary_triangle = 50;
constexpr std::string_view name_records[] = {"solid", "endsolid", "SOLID", "ENDSOLID"};
constexpr Dialect dialect{.comma_separates = false, .name_records = name_records, .continuation = false};

/// A binary file may begin with "solid" too: only its size tells.
bool is_binary(std::string_view bytes) {
  if (bytes.size() < binary_header) return false;
  const std::uint64_t triangles = ByteCursor(bytes, 80, false).integer(4);
  return bytes.size() == binary_header + binary_triangle * triangles;
}

bool is_word(std::string_view text, std::string_view word) {
  return std::equal(text.begin(), text.end(), word.begin(), word.end(),
                    [](unsigned char a, unsigned char b) { return std::tolower(a) == b; });
}

void read_binary(const Source& source, Problems& problems, CornerMerger& merger, FaceCollector& faces) {
  ByteCursor bytes(source.text, 80, false);
  const std::uint64_t triangles = bytes.integer(4);
  for (std::uint64_t i = 0; i < triangles; ++i) {
    bytes.skip(12);  // The normal follows from the corners.
    std::vector<int> corners;
    for (int corner = 0; corner < 3; ++corner) {
      const std::size_t position = bytes.position();
      std::array<double, 3> point;
      for (double& coordinate : point) coordinate = bytes.real32();
      if (!std::all_of(point.begin(), point.end(), [](double x) { return std::isfinite(x); })) {
        problems.add("E-NUMBER", {source.file, 0, 0},
                     fmt::format("triangle {} (byte {}) has a corner that is not finite", i + 1, position));
        point = {};
      }
      corners.push_back(merger.vertex(point, 0));
    }
    bytes.skip(2);
    faces.add(std::move(corners), 0, 0);
  }
}

class TextReader {
 public:
  TextReader(TextParser& parser, CornerMerger& merger, FaceCollector& faces)
      : parser_(parser), merger_(merger), faces_(faces) {}

  /// Returns the number of solids.
  int read() {
    int solids = 0;
    parser_.need("solid");
    do {
      expect_word(0, "solid");
      ++solids;
      while (true) {
        parser_.need("facet or endsolid");
        if (is_word(parser_.text(0), "endsolid")) break;
        read_facet(solids);
      }
    } while (parser_.next());
    return solids;
  }

 private:
  void expect_word(std::size_t field, std::string_view word) {
    if (field < parser_.size() && is_word(parser_.text(field), word)) return;
    const std::string found = field < parser_.size() ? quoted(parser_.text(field)) : "the end of the line";
    parser_.problems().stop("E-SYNTAX", parser_.place(field), fmt::format("{} where '{}' is expected", found, word));
  }

  void read_facet(int solid) {
    const int line = parser_.line();
    expect_word(0, "facet");
    expect_word(1, "normal");
    parser_.need_fields(5, 5, "facet normal and three numbers");  // Not used: exporters write nan here.
    parser_.need("outer loop");
    expect_word(0, "outer");
    expect_word(1, "loop");
    parser_.need_fields(2, 2, "outer loop");
    std::vector<int> corners;
    for (int i = 0; i < 3; ++i) {
      parser_.need("vertex");
      expect_word(0, "vertex");
      parser_.need_fields(4, 4, "vertex x y z");
      corners.push_back(merger_.vertex(parser_.point(1, 3), parser_.line()));
    }
    for (const char* word : {"endloop", "endfacet"}) {
      parser_.need(word);
      expect_word(0, word);
      parser_.need_fields(1, 1, word);
    }
    faces_.add(std::move(corners), solid, line);
  }

  TextParser& parser_;
  CornerMerger& merger_;
  FaceCollector& faces_;
};

}  // namespace

Input read_stl(const Source& source) {
  Problems problems;
  Input input;
  input.file = source.file;
  input.vertex_file = source.file;
  input.triangle_soup = true;
  CornerMerger merger(input);
  FaceCollector faces(input);
  if (is_binary(source.text)) {
    read_binary(source, problems, merger, faces);
  } else {
    TextParser parser(source.file, source.text, problems, dialect);
    const bool looks_binary = source.text.find('\0') != std::string::npos;
    if (looks_binary) {
      const std::string announced =
          source.text.size() < binary_header
              ? "its header is incomplete"
              : fmt::format("its header announces {} triangles", ByteCursor(source.text, 80, false).integer(4));
      problems.stop("E-TRUNCATED", {source.file, 0, 0},
                    fmt::format("a binary file of {} bytes, but {}: it should have 84 + 50 bytes per triangle",
                                source.text.size(), announced));
    }
    const int solids = TextReader(parser, merger, faces).read();
    if (solids > 1) {
      input.has_markers = true;
      input.remarks.push_back(fmt::format("markers are the solids of the file, 1 to {}", solids));
    } else {
      for (InputFacet& facet : input.facets) facet.marker = 0;
    }
  }
  problems.throw_if_any();
  merger.finish();
  return input;
}

}  // namespace confidel::io
