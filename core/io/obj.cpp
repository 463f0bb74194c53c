// SPDX-License-Identifier: GPL-3.0-or-later
// .obj of Wavefront: vertices, faces and polylines; groups become markers.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>

#include "core/io/number.h"
#include "core/io/source.h"
#include "core/io/surface.h"
#include "core/io/text_parser.h"

namespace confidel::io {

namespace {

constexpr std::string_view name_records[] = {"g", "o", "usemtl", "mtllib"};
constexpr Dialect dialect{.comma_separates = false, .name_records = name_records, .continuation = true};

/// Records without influence on the shape.
constexpr std::string_view ignored[] = {"vt",       "vn",       "vp",         "p",         "s",
                                        "mtllib",   "mg",       "maplib",     "lod",       "bevel",
                                        "c_interp", "d_interp", "shadow_obj", "trace_obj", "usemap"};

bool is_ignored(std::string_view keyword) {
  return std::find(std::begin(ignored), std::end(ignored), keyword) != std::end(ignored);
}

class ObjReader {
 public:
  ObjReader(const Source& source, Problems& problems, Input& input)
      : source_(source), problems_(problems), input_(input), faces_(input) {}

  void read() {
    read_vertices();
    TextParser parser(source_.file, source_.text, problems_, dialect);
    while (parser.next()) {
      const std::string_view keyword = parser.text(0);
      if (keyword == "v") {
        ++vertices_so_far_;
      } else if (keyword == "f") {
        read_face(parser);
      } else if (keyword == "l") {
        read_polyline(parser);
      } else if (keyword == "g" || keyword == "o" || keyword == "usemtl") {
        enter_group(parser);
      } else if (!is_ignored(keyword)) {
        problems_.add("E-SYNTAX", parser.place(0),
                      fmt::format("{} is no record that is read (v, f, l, g, o, usemtl) or ignored: remove it, or "
                                  "approximate free-form geometry by faces",
                                  quoted(keyword)));
      }
    }
    if (!group_markers_.empty()) remark_groups();
  }

 private:
  /// Vertices first: a face may come before its vertices.
  void read_vertices() {
    TextParser parser(source_.file, source_.text, problems_, dialect);
    while (parser.next()) {
      if (parser.text(0) != "v") continue;
      InputVertex vertex;
      vertex.line = parser.line();
      // Four fields, five with a weight, seven with a colour: six are none of these.
      if (parser.has_fields(4, parser.size() == 6 ? 5 : 7, "a vertex is: v x y z, and perhaps w or r g b")) {
        vertex.position = parser.point(1, 3);
        for (std::size_t field = 4; field < parser.size(); ++field) parser.real(field, "weight or colour");
      }
      input_.vertices.push_back(vertex);
    }
  }

  /// The vertex of a corner v, v/vt, v//vn or v/vt/vn.
  int corner(TextParser& parser, std::size_t field) {
    const std::string_view text = parser.text(field);
    std::array<std::string_view, 3> parts;
    std::size_t count = 0;
    std::size_t begin = 0;
    bool well_formed = true;
    while (well_formed) {
      const std::size_t end = std::min(text.find('/', begin), text.size());
      if (count == parts.size()) {
        well_formed = false;
        break;
      }
      parts[count++] = text.substr(begin, end - begin);
      if (end == text.size()) break;
      begin = end + 1;
    }
    int vertex = 0;
    NumberStatus status = well_formed ? parse_integer(parts[0], vertex) : NumberStatus::malformed;
    for (std::size_t i = 1; i < count && status == NumberStatus::ok; ++i) {
      int other = 0;
      const bool may_be_empty = i == 1 && count == 3;
      if (!(parts[i].empty() && may_be_empty)) status = parse_integer(parts[i], other);
    }
    if (status == NumberStatus::malformed) {
      problems_.add("E-NUMBER", parser.place(field),
                    fmt::format("corner {} is none of v, v/vt, v//vn, v/vt/vn with decimal integers", quoted(text)));
      return 0;
    }
    const long long total = static_cast<long long>(input_.vertices.size());
    const long long index = vertex < 0 ? vertices_so_far_ + vertex : static_cast<long long>(vertex) - 1;
    if (status == NumberStatus::ok && vertex != 0 && index >= 0 && index < total) return static_cast<int>(index);
    problems_.add("E-INDEX", parser.place(field),
                  fmt::format("vertex {} does not exist: there are {} (numbered from 1), {} of them before this line "
                              "(numbered -1, -2, ... backwards)",
                              quoted(parts[0]), total, vertices_so_far_));
    return 0;
  }

  void read_face(TextParser& parser) {
    if (!parser.has_fields(4, TextParser::unlimited, "a face is: f and at least three corners")) return;
    std::vector<int> corners;
    for (std::size_t field = 1; field < parser.size(); ++field) corners.push_back(corner(parser, field));
    faces_.add(std::move(corners), marker_, parser.line());
  }

  void read_polyline(TextParser& parser) {
    if (!parser.has_fields(3, TextParser::unlimited, "a polyline is: l and at least two vertices")) return;
    int previous = corner(parser, 1);
    for (std::size_t field = 2; field < parser.size(); ++field) {
      const int next = corner(parser, field);
      input_.segments.push_back({{previous, next}, marker_, parser.line()});
      previous = next;
    }
  }

  /// Facets of the same object, groups and material share a marker: 1, 2, ... in the order of the file.
  void enter_group(TextParser& parser) {
    const std::string keyword(parser.text(0));
    std::string name;
    for (std::size_t field = 1; field < parser.size(); ++field) {
      name += (field > 1 ? " " : "") + std::string(parser.text(field));
    }
    state_[keyword] = name;
    std::string key;
    for (const auto& [word, value] : state_) key += (key.empty() ? "" : ", ") + word + " " + value;
    const auto [entry, is_new] = group_markers_.try_emplace(key, static_cast<int>(group_markers_.size()) + 1);
    marker_ = entry->second;
    input_.has_markers = true;
  }

  void remark_groups() {
    // Only groups that hold something are worth a name.
    std::map<int, std::string> names;
    for (const auto& [name, marker] : group_markers_) names[marker] = name;
    std::map<int, bool> used;
    for (const InputFacet& facet : input_.facets) used[facet.marker] = true;
    for (const InputSegment& segment : input_.segments) used[segment.marker] = true;
    constexpr std::size_t longest_list = 20;
    std::string list;
    std::size_t listed = 0;
    for (const auto& [marker, is_used] : used) {
      if (marker == 0) continue;
      if (listed++ < longest_list) list += fmt::format("{}{} = {}", listed == 1 ? "" : "; ", marker, names[marker]);
    }
    if (listed > longest_list) list += fmt::format("; and {} more", listed - longest_list);
    if (listed > 0) input_.remarks.push_back("markers are groups: " + list);
  }

  const Source& source_;
  Problems& problems_;
  Input& input_;
  FaceCollector faces_;
  long long vertices_so_far_ = 0;
  std::map<std::string, std::string> state_;
  std::map<std::string, int> group_markers_;
  int marker_ = 0;
};

}  // namespace

Input read_obj(const Source& source) {
  Problems problems;
  Input input;
  input.file = source.file;
  input.vertex_file = source.file;
  input.first_index = 1;
  input.triangle_soup = true;
  ObjReader(source, problems, input).read();
  problems.sort_by_line();
  problems.throw_if_any();
  return input;
}

}  // namespace confidel::io
