// SPDX-License-Identifier: GPL-3.0-or-later
// .ply of Stanford: text, and binary of both byte orders.
#include "core/io/ply.h"

#include <fmt/format.h>

#include <cmath>

#include "core/io/bytes.h"
#include "core/io/surface.h"
#include "core/io/text_parser.h"

namespace confidel::io {

namespace {

/// The values of the body, one after the other, however they are spelled.
class Body {
 public:
  virtual ~Body() = default;
  virtual void begin_row(const PlyElement& element, int row) = 0;
  virtual void end_row(const PlyElement& element) = 0;
  virtual int list_length(const PlyProperty& property) = 0;
  virtual double real(const PlyProperty& property) = 0;
  /// A vertex, 0-based; reports E-INDEX.
  virtual int vertex(const PlyProperty& property, int vertices) = 0;
  virtual void skip(const PlyProperty& property) = 0;
  /// Where the current row begins; line 0 in binary files.
  virtual Place row_place() const = 0;
  virtual void expect_end() = 0;
};

class TextBody : public Body {
 public:
  explicit TextBody(TextParser& parser) : parser_(parser) {}

  void begin_row(const PlyElement& element, int row) override {
    if (!parser_.next()) {
      parser_.problems().stop("E-TRUNCATED", parser_.end_of_text(),
                              fmt::format("the file ends after {} of {} rows of element {}: restore the rest, or "
                                          "correct the count",
                                          row, element.count, quoted(element.name)));
    }
    field_ = 0;
  }
  void end_row(const PlyElement& element) override {
    if (field_ == parser_.size()) return;
    parser_.need_fields(field_, field_, fmt::format("the properties of element {}", quoted(element.name)));
  }
  int list_length(const PlyProperty& property) override { return parser_.count(take(property), "length of a list"); }
  double real(const PlyProperty& property) override { return parser_.real(take(property), "coordinate"); }
  int vertex(const PlyProperty& property, int vertices) override {
    return parser_.vertex(take(property), 0, static_cast<std::size_t>(vertices));
  }
  void skip(const PlyProperty& property) override { take(property); }
  Place row_place() const override { return parser_.place(); }
  void expect_end() override { parser_.expect_end("all announced elements are read"); }

 private:
  std::size_t take(const PlyProperty& property) {
    if (field_ == parser_.size()) {
      parser_.problems().stop(
          "E-FIELDS", parser_.place(field_),
          fmt::format("the line ends where a value of property {} is expected", quoted(property.name)));
    }
    return field_++;
  }

  TextParser& parser_;
  std::size_t field_ = 0;
};

class BinaryBody : public Body {
 public:
  BinaryBody(const Source& source, const PlyHeader& header, Problems& problems)
      : source_(source),
        problems_(problems),
        bytes_(source.text, header.body, header.format == PlyFormat::binary_big_endian) {}

  void begin_row(const PlyElement& element, int row) override {
    element_ = &element;
    row_ = row;
  }
  void end_row(const PlyElement&) override {}
  int list_length(const PlyProperty& property) override {
    const long long length = integer(property.list_size);
    if (length < 0 || static_cast<std::uint64_t>(length) > bytes_.remaining()) {
      problems_.stop(
          length < 0 ? "E-COUNT" : "E-TRUNCATED", row_place(),
          fmt::format("{}: a list of {} values, but {} bytes are left", where(), length, bytes_.remaining()));
    }
    return static_cast<int>(length);
  }
  double real(const PlyProperty& property) override {
    if (!property.type.is_real) return static_cast<double>(integer(property.type));
    need(property.type.width);
    const double value = property.type.width == 4 ? bytes_.real32() : bytes_.real64();
    if (std::isfinite(value)) return value;
    problems_.add("E-NUMBER", row_place(), fmt::format("{}: a coordinate is not finite", where()));
    return 0;
  }
  int vertex(const PlyProperty& property, int vertices) override {
    const long long index = integer(property.type);
    if (index >= 0 && index < vertices) return static_cast<int>(index);
    problems_.add("E-INDEX", row_place(),
                  fmt::format("{}: vertex {} does not exist: there are {}, numbered from 0", where(), index, vertices));
    return 0;
  }
  void skip(const PlyProperty& property) override {
    need(property.type.width);
    bytes_.skip(property.type.width);
  }
  Place row_place() const override { return {source_.file, 0, 0}; }
  void expect_end() override {
    const std::string_view rest = std::string_view(source_.text).substr(bytes_.position());
    if (rest.find_first_not_of("\r\n") == std::string_view::npos) return;
    problems_.stop("E-TRAILING", row_place(),
                   fmt::format("{} bytes after the end of the announced elements: remove them, or correct the counts",
                               rest.size()));
  }

 private:
  std::string where() const {
    return fmt::format("element {}, row {} (before byte {})", quoted(element_->name), row_ + 1, bytes_.position());
  }
  void need(std::size_t width) {
    if (bytes_.remaining() >= width) return;
    problems_.stop("E-TRUNCATED", row_place(), fmt::format("{}: the file ends in it", where()));
  }
  long long integer(const PlyType& type) {
    need(type.width);
    const std::uint64_t value = bytes_.integer(type.width);
    if (!type.is_signed) return static_cast<long long>(value);
    const std::uint64_t sign = std::uint64_t{1} << (8 * type.width - 1);
    return static_cast<long long>(value ^ sign) - static_cast<long long>(sign);
  }

  const Source& source_;
  Problems& problems_;
  ByteCursor bytes_;
  const PlyElement* element_ = nullptr;
  int row_ = 0;
};

class PlyReader {
 public:
  PlyReader(const PlyHeader& header, Body& body, Problems& problems, Input& input)
      : header_(header), body_(body), problems_(problems), input_(input), faces_(input) {
    for (const PlyElement& element : header.elements) {
      if (element.name == "vertex") vertices_ = element.count;
    }
  }

  void read() {
    for (const PlyElement& element : header_.elements) {
      if (element.name == "vertex") {
        read_vertices(element);
      } else if (element.name == "face") {
        read_faces(element);
      } else if (element.name == "edge") {
        read_edges(element);
      } else if (element.name == "tristrips") {
        problems_.stop("E-FORMAT", place(element), "strips of triangles are not read: write the triangles as faces");
      } else {
        for (int row = 0; row < element.count; ++row)
          read_row(element, row, [](int, const PlyProperty&) { return false; });
        input_.remarks.push_back(fmt::format("element {} is not read", quoted(element.name)));
      }
    }
    body_.expect_end();
    faces_.finish();
  }

 private:
  Place place(const PlyElement& element) const { return {input_.file, element.line, 0}; }

  int need_property(const PlyElement& element, const std::string& name, bool list) {
    const int index = element.find(name);
    if (index >= 0 && element.properties[static_cast<std::size_t>(index)].is_list() == list) return index;
    problems_.stop("E-SYNTAX", place(element),
                   fmt::format("element {} has no {} {}", quoted(element.name), list ? "list" : "property", name));
  }
  void need_integer(const PlyElement& element, int property) {
    if (!element.properties[static_cast<std::size_t>(property)].type.is_real) return;
    problems_.stop("E-SYNTAX", place(element),
                   fmt::format("element {}: vertices must be integers", quoted(element.name)));
  }

  /// Calls use(position, property) for each value that is wanted; use returns false if it took nothing.
  template <typename Use>
  void read_row(const PlyElement& element, int row, Use use) {
    body_.begin_row(element, row);
    for (std::size_t i = 0; i < element.properties.size(); ++i) {
      const PlyProperty& property = element.properties[i];
      const int values = property.is_list() ? body_.list_length(property) : 1;
      for (int value = 0; value < values; ++value) {
        if (!use(static_cast<int>(i), property)) body_.skip(property);
      }
    }
    body_.end_row(element);
  }

  void read_vertices(const PlyElement& element) {
    const std::array<int, 3> wanted{need_property(element, "x", false), need_property(element, "y", false),
                                    need_property(element, "z", false)};
    for (int row = 0; row < element.count; ++row) {
      InputVertex vertex;
      read_row(element, row, [&](int index, const PlyProperty& property) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
          if (index != wanted[axis]) continue;
          vertex.position[axis] = body_.real(property) + 0.0;
          return true;
        }
        return false;
      });
      vertex.line = body_.row_place().line;
      input_.vertices.push_back(vertex);
    }
  }

  void read_faces(const PlyElement& element) {
    const std::string name = element.find("vertex_index") >= 0 ? "vertex_index" : "vertex_indices";
    const int wanted = need_property(element, name, true);
    need_integer(element, wanted);
    for (int row = 0; row < element.count; ++row) {
      std::vector<int> corners;
      read_row(element, row, [&](int index, const PlyProperty& property) {
        if (index != wanted) return false;
        corners.push_back(body_.vertex(property, vertices_));
        return true;
      });
      if (corners.empty()) {
        problems_.add("E-VALUE", body_.row_place(), fmt::format("face {} has no corners", row));
        continue;
      }
      faces_.add(std::move(corners), 0, body_.row_place().line);
    }
  }

  void read_edges(const PlyElement& element) {
    const std::array<int, 2> wanted{need_property(element, "vertex1", false), need_property(element, "vertex2", false)};
    for (const int property : wanted) need_integer(element, property);
    for (int row = 0; row < element.count; ++row) {
      InputSegment segment;
      read_row(element, row, [&](int index, const PlyProperty& property) {
        for (std::size_t end = 0; end < 2; ++end) {
          if (index != wanted[end]) continue;
          segment.ends[end] = body_.vertex(property, vertices_);
          return true;
        }
        return false;
      });
      segment.line = body_.row_place().line;
      input_.segments.push_back(segment);
    }
  }

  const PlyHeader& header_;
  Body& body_;
  Problems& problems_;
  Input& input_;
  FaceCollector faces_;
  int vertices_ = 0;
};

}  // namespace

Input read_ply(const Source& source) {
  Problems problems;
  Input input;
  input.file = source.file;
  input.vertex_file = source.file;
  input.triangle_soup = true;
  const PlyHeader header = read_ply_header(source, problems);
  if (header.format == PlyFormat::ascii) {
    TextParser parser(source.file, std::string_view(source.text).substr(header.body), problems,
                      {.comma_separates = false, .name_records = {}, .continuation = false}, header.lines + 1);
    TextBody body(parser);
    PlyReader(header, body, problems, input).read();
  } else {
    BinaryBody body(source, header, problems);
    PlyReader(header, body, problems, input).read();
  }
  problems.throw_if_any();
  return input;
}

}  // namespace confidel::io
