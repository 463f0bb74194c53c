// SPDX-License-Identifier: GPL-3.0-or-later
// .mesh of Medit: sections by keyword. As an input, the surface and the edges are read; as a mesh, tetrahedra too.
#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "core/io/mesh.h"
#include "core/io/source.h"
#include "core/io/surface.h"
#include "core/io/text_parser.h"

namespace confidel::io {

namespace {

constexpr std::string_view skipped[] = {"Tetrahedra",
                                        "Hexahedra",
                                        "Prisms",
                                        "Wedges",
                                        "Pyramids",
                                        "Corners",
                                        "Ridges",
                                        "RequiredVertices",
                                        "RequiredEdges",
                                        "RequiredTriangles",
                                        "RequiredQuadrilaterals",
                                        "Normals",
                                        "NormalAtVertices",
                                        "NormalAtTriangleVertices",
                                        "NormalAtQuadrilateralVertices",
                                        "Tangents",
                                        "TangentAtVertices",
                                        "TangentAtEdges",
                                        "SubDomainFromGeom",
                                        "SubDomainFromMesh"};

struct Section {
  std::string keyword;
  int count = 0;
  Place place;
  TextParser rows;  ///< stands before the first row
};

class MeditReader {
 public:
  /// With a mesh, elements go there: edges, triangles, tetrahedra; without, facets and segments go to the input.
  MeditReader(TextParser parser, Problems& problems, Input& input, Mesh* mesh = nullptr)
      : parser_(std::move(parser)), problems_(problems), input_(input), mesh_(mesh), faces_(input) {}

  void read() {
    const Place start = read_preamble();
    find_sections();
    if (!vertices_) problems_.stop("E-EMPTY", start, "there is no section Vertices");
    read_vertices(*vertices_);
    for (Section& section : elements_) read_elements(section);
    problems_.sort_by_line();
    problems_.throw_if_any();
    if (mesh_ != nullptr) return;
    faces_.finish();
    remark_skipped(start);
  }

 private:
  /// A keyword, and its number on the same line or alone on the next.
  int number_of(const char* name) {
    const std::string keyword(parser_.text(0));
    if (parser_.size() == 1) {
      parser_.need(fmt::format("the number behind {}", keyword));
      parser_.need_fields(1, 1, fmt::format("the number behind {}", keyword));
      return parser_.count(0, name);
    }
    parser_.need_fields(2, 2, fmt::format("{} and its number", keyword));
    return parser_.count(1, name);
  }

  Place read_preamble() {
    parser_.need("MeshVersionFormatted");
    expect_keyword("MeshVersionFormatted");
    const Place start = parser_.place(0);
    const int version = number_of("version");
    if (version < 1 || version > 4) problems_.stop("E-VALUE", parser_.place(), "versions 1 to 4 are read");
    parser_.need("Dimension");
    expect_keyword("Dimension");
    input_.dimension = number_of("dimension");
    if (input_.dimension != 2 && input_.dimension != 3) {
      problems_.stop("E-VALUE", parser_.place(parser_.size() - 1), "the dimension must be 2 or 3");
    }
    return start;
  }

  void expect_keyword(std::string_view keyword) {
    if (parser_.text(0) == keyword) return;
    problems_.stop("E-SYNTAX", parser_.place(0),
                   fmt::format("{} where {} is expected", quoted(parser_.text(0)), keyword));
  }

  bool is_element(std::string_view keyword) const {
    if (mesh_ != nullptr) return keyword == "Edges" || keyword == "Triangles" || keyword == "Tetrahedra";
    return keyword == "Edges" || keyword == "Triangles" || keyword == "Quadrilaterals";
  }
  static bool is_skipped(std::string_view keyword) {
    return std::find(std::begin(skipped), std::end(skipped), keyword) != std::end(skipped);
  }
  bool is_keyword(std::string_view text) const {
    return text == "Vertices" || text == "End" || text == "Quadrilaterals" || is_element(text) || is_skipped(text);
  }

  /// Notes where the sections are: they may come in any order, and the vertices are needed first.
  void find_sections() {
    while (true) {
      parser_.need("a section or End");
      const std::string keyword(parser_.text(0));
      if (keyword == "End") break;
      if (!is_keyword(keyword)) {
        problems_.stop("E-SYNTAX", parser_.place(0),
                       fmt::format("{} where a section (Vertices, Edges, Triangles, Quadrilaterals, ...) or End is "
                                   "expected: does the section before have more rows than announced?",
                                   quoted(keyword)));
      }
      const Place place = parser_.place(0);
      if (std::find(seen_.begin(), seen_.end(), keyword) != seen_.end()) {
        problems_.stop("E-SYNTAX", place, fmt::format("a second section {}", keyword));
      }
      seen_.push_back(keyword);
      const int count = number_of("number of rows");
      Section section{keyword, count, place, parser_};
      for (int row = 0; row < count; ++row) {
        parser_.need_row(keyword.c_str(), row, count);
        if (!is_keyword(parser_.text(0))) continue;
        problems_.stop("E-COUNT", parser_.place(0),
                       fmt::format("{} after {} of {} {}: correct the count", parser_.text(0), row, count, keyword));
      }
      if (keyword == "Vertices") {
        vertices_ = std::move(section);
      } else if (is_element(keyword)) {
        elements_.push_back(std::move(section));
      } else if (count > 0) {
        skipped_.emplace_back(fmt::format("{} {}", count, keyword));
      }
    }
    parser_.expect_end("End ends the file");
  }

  void read_vertices(Section& section) {
    const std::size_t fields = static_cast<std::size_t>(input_.dimension) + 1;
    for (int row = 0; row < section.count; ++row) {
      section.rows.next();
      InputVertex vertex;
      vertex.line = section.rows.line();
      if (section.rows.has_fields(
              fields, fields, input_.dimension == 2 ? "a vertex is: x y reference" : "a vertex is: x y z reference")) {
        vertex.position = section.rows.point(0, input_.dimension);
        vertex.marker = section.rows.integer(fields - 1, "reference");
      }
      input_.vertices.push_back(vertex);
    }
  }

  void read_elements(Section& section) {
    const std::size_t corners = section.keyword == "Edges" ? 2 : section.keyword == "Triangles" ? 3 : 4;
    const std::string layout = fmt::format("a row of {} is: {} vertices and a reference", section.keyword, corners);
    for (int row = 0; row < section.count; ++row) {
      section.rows.next();
      if (!section.rows.has_fields(corners + 1, corners + 1, layout)) continue;
      std::vector<int> vertices;
      for (std::size_t i = 0; i < corners; ++i) vertices.push_back(section.rows.vertex(i, 1, input_.vertices.size()));
      const int reference = section.rows.integer(corners, "reference");
      if (mesh_ != nullptr) {
        if (corners == 2) mesh_->edges.push_back({vertices[0], vertices[1]});
        if (corners == 3) mesh_->faces.push_back({vertices[0], vertices[1], vertices[2]});
        if (corners == 4) mesh_->tetrahedra.push_back({vertices[0], vertices[1], vertices[2], vertices[3]});
      } else if (corners == 2) {
        input_.segments.push_back({{vertices[0], vertices[1]}, reference, section.rows.line()});
      } else if (input_.dimension == 3) {
        faces_.add(std::move(vertices), reference, section.rows.line());
      }
    }
    // In the plane, the edges are the graph; triangles are somebody's mesh of its inside.
    if (mesh_ == nullptr && corners > 2 && input_.dimension == 2 && section.count > 0) {
      skipped_.emplace_back(fmt::format("{} {}", section.count, section.keyword));
    }
  }

  void remark_skipped(const Place& start) {
    if (skipped_.empty()) return;
    const std::string list = fmt::format("{}", fmt::join(skipped_, ", "));
    const bool planar = input_.dimension == 2;
    if (input_.segments.empty() && input_.facets.empty()) {
      problems_.stop("E-EMPTY", start,
                     fmt::format("the file has {}, but no {}: these are what is read", list,
                                 planar ? "Edges" : "Triangles, Quadrilaterals or Edges"));
    }
    input_.remarks.push_back("not read: " + list);
  }

  TextParser parser_;
  Problems& problems_;
  Input& input_;
  Mesh* mesh_;
  FaceCollector faces_;
  std::vector<std::string> seen_;
  std::optional<Section> vertices_;
  std::vector<Section> elements_;
  std::vector<std::string> skipped_;
};

}  // namespace

Input read_medit(const Source& source) {
  Problems problems;
  Input input;
  input.file = source.file;
  input.vertex_file = source.file;
  input.first_index = 1;
  input.has_markers = true;
  input.triangle_soup = true;
  MeditReader(TextParser(source.file, source.text, problems), problems, input).read();
  if (input.dimension == 2) input.triangle_soup = false;
  return input;
}

Mesh read_medit_mesh(const Source& source) {
  Problems problems;
  Input input;
  input.file = source.file;
  Mesh mesh;
  mesh.file = source.file;
  mesh.first_index = 1;
  MeditReader(TextParser(source.file, source.text, problems), problems, input, &mesh).read();
  mesh.dimension = input.dimension;
  for (const InputVertex& vertex : input.vertices) mesh.points.push_back(vertex.position);
  return mesh;
}

}  // namespace confidel::io
