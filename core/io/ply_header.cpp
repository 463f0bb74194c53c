// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include "core/io/ply.h"
#include "core/io/text_parser.h"

namespace confidel::io {

namespace {

PlyType type_of(std::string_view name) {
  if (name == "char" || name == "int8") return {1, false, true};
  if (name == "uchar" || name == "uint8") return {1, false, false};
  if (name == "short" || name == "int16") return {2, false, true};
  if (name == "ushort" || name == "uint16") return {2, false, false};
  if (name == "int" || name == "int32") return {4, false, true};
  if (name == "uint" || name == "uint32") return {4, false, false};
  if (name == "float" || name == "float32") return {4, true, true};
  if (name == "double" || name == "float64") return {8, true, true};
  return {};
}

constexpr std::string_view end_header = "end_header";

/// Only lines that end with LF or CRLF count: the first byte behind end_header must be beyond doubt.
std::size_t find_body(const Source& source, Problems& problems) {
  const std::string& text = source.text;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = text.find('\n', begin);
    if (end == std::string::npos) break;
    std::string_view line(text.data() + begin, end - begin);
    if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
    while (!line.empty() && (line.back() == ' ' || line.back() == '\t')) line.remove_suffix(1);
    if (line == end_header) return end + 1;
    begin = end + 1;
  }
  problems.stop("E-TRUNCATED", {source.file, 0, 0}, "the header has no line 'end_header' that ends with a line feed");
}

class HeaderReader {
 public:
  HeaderReader(TextParser& parser, Problems& problems) : parser_(parser), problems_(problems) {}

  PlyHeader read() {
    parser_.need("ply");
    if (parser_.text(0) != "ply" || parser_.size() != 1) syntax(0, "'ply'");
    bool has_format = false;
    while (true) {
      parser_.need(std::string(end_header));
      const std::string_view keyword = parser_.text(0);
      if (keyword == "comment" || keyword == "obj_info") continue;
      if (!has_format) {
        read_format();
        has_format = true;
      } else if (keyword == end_header) {
        break;
      } else if (keyword == "element") {
        read_element();
      } else if (keyword == "property") {
        read_property();
      } else {
        syntax(0, "comment, obj_info, element, property or end_header");
      }
    }
    header_.lines = parser_.line();
    parser_.expect_end("end_header must stand alone on its line");
    for (const PlyElement& element : header_.elements) {
      if (!element.properties.empty() || element.count == 0) continue;
      problems_.stop("E-SYNTAX", {parser_.file(), element.line, 0},
                     fmt::format("element {} has no properties", quoted(element.name)));
    }
    return header_;
  }

 private:
  [[noreturn]] void syntax(std::size_t field, const std::string& expected) {
    problems_.stop("E-SYNTAX", parser_.place(field),
                   fmt::format("{} where {} is expected", quoted(parser_.text(field)), expected));
  }

  void read_format() {
    if (parser_.text(0) != "format") syntax(0, "'format'");
    parser_.need_fields(3, 3, "format, its name, 1.0");
    const std::string_view name = parser_.text(1);
    if (name == "ascii") {
      header_.format = PlyFormat::ascii;
    } else if (name == "binary_little_endian") {
      header_.format = PlyFormat::binary_little_endian;
    } else if (name == "binary_big_endian") {
      header_.format = PlyFormat::binary_big_endian;
    } else {
      problems_.stop("E-FORMAT", parser_.place(1),
                     fmt::format("{} is none of ascii, binary_little_endian, binary_big_endian", quoted(name)));
    }
    if (parser_.text(2) != "1.0") {
      problems_.stop("E-FORMAT", parser_.place(2),
                     fmt::format("version {}: only 1.0 is read", quoted(parser_.text(2))));
    }
  }

  void need_room(std::size_t size) {
    constexpr std::size_t most = 1000;
    if (size >= most) problems_.stop("E-COUNT", parser_.place(0), fmt::format("more than {} in one header", most));
  }

  void read_element() {
    parser_.need_fields(3, 3, "element, its name, its count");
    PlyElement element;
    element.name = parser_.text(1);
    element.count = parser_.count(2, "number of elements");
    element.line = parser_.line();
    for (const PlyElement& other : header_.elements) {
      if (other.name == element.name) syntax(1, "an element that has not been announced yet");
    }
    need_room(header_.elements.size());
    header_.elements.push_back(element);
  }

  PlyType need_type(std::size_t field) {
    const PlyType type = type_of(parser_.text(field));
    if (type.width == 0) syntax(field, "a type (char uchar short ushort int uint float double)");
    return type;
  }

  void read_property() {
    if (header_.elements.empty()) syntax(0, "an element before its properties");
    PlyProperty property;
    if (parser_.size() > 1 && parser_.text(1) == "list") {
      parser_.need_fields(5, 5, "property list, type of the length, type of the values, name");
      property.list_size = need_type(2);
      if (property.list_size.is_real) syntax(2, "an integer type");
      property.type = need_type(3);
    } else {
      parser_.need_fields(3, 3, "property, type, name");
      property.type = need_type(1);
    }
    const std::size_t name = parser_.size() - 1;
    property.name = parser_.text(name);
    if (header_.elements.back().find(property.name) >= 0) syntax(name, "a property that has not been announced yet");
    need_room(header_.elements.back().properties.size());
    header_.elements.back().properties.push_back(property);
  }

  TextParser& parser_;
  Problems& problems_;
  PlyHeader header_;
};

}  // namespace

int PlyElement::find(const std::string& property) const {
  for (std::size_t i = 0; i < properties.size(); ++i) {
    if (properties[i].name == property) return static_cast<int>(i);
  }
  return -1;
}

PlyHeader read_ply_header(const Source& source, Problems& problems) {
  const std::string_view text = source.text;
  if (!text.starts_with("ply\n") && !text.starts_with("ply\r\n")) {
    problems.stop("E-SYNTAX", {source.file, 1, 1}, "the first line is not 'ply'");
  }
  const std::size_t body = find_body(source, problems);
  static constexpr std::string_view name_records[] = {"comment", "obj_info"};
  TextParser parser(source.file, text.substr(0, body), problems,
                    {.comma_separates = false, .name_records = name_records, .continuation = false});
  PlyHeader header = HeaderReader(parser, problems).read();
  header.body = body;
  return header;
}

}  // namespace confidel::io
