// SPDX-License-Identifier: GPL-3.0-or-later
// Meshes to be judged: the family of .node, and the choice among formats.
#include <fmt/format.h>

#include <filesystem>
#include <limits>

#include "core/io/mesh.h"
#include "core/io/node.h"
#include "core/io/text_parser.h"

namespace confidel {
namespace {

using io::Problems;
using io::TextParser;

/// Rows of vertices: index, corners, and further fields that the header may or may not announce.
template <std::size_t Corners>
void read_rows(TextParser& parser, int count, std::size_t given, const Mesh& mesh, std::vector<std::array<int, Corners>>& rows, std::vector<int>* labels,
               bool labelled, const char* what) {
  long long expected = mesh.first_index;
  for (int row = 0; row < count; ++row) {
    parser.need_row(what, row, count);
    if (!parser.has_fields(1 + given + (labelled ? 1 : 0), TextParser::unlimited, fmt::format("a row of {}: index, {} vertices{}", what, given, labelled ? ", marker" : ""))) {
      ++expected;
      continue;
    }
    expected = parser.row_index(0, what, expected);
    std::array<int, Corners> corners{};
    for (std::size_t i = 0; i < Corners; ++i) corners[i] = parser.vertex(1 + i, mesh.first_index, mesh.points.size());
    rows.push_back(corners);
    // Markers stand in the last column that every version of the tools writes: right behind the corners.
    if (labels != nullptr && labelled) labels->push_back(parser.integer(1 + given, "marker"));
  }
  parser.expect_end(fmt::format("{} {} were announced", count, what));
}

void read_elements(const std::string& path, Mesh& mesh, Problems& problems) {
  const io::Source source = io::load(path);
  TextParser parser(path, source.text, problems);
  parser.need("the elements' header (count, corners, attributes)");
  parser.need_fields(3, 3, "number of elements, corners of each, attributes");
  const int count = parser.count(0, "number of elements");
  const int corners = parser.choice(1, "number of corners", 3, 10);
  parser.choice(2, "number of attributes", 0, 1000);
  const bool planar = mesh.dimension == 2;
  if (planar ? corners != 3 && corners != 6 : corners != 4 && corners != 10)
    problems.stop("E-VALUE", parser.place(1), fmt::format("{} corners of elements in dimension {}", corners, mesh.dimension));
  // Of quadratic elements the corners come first; the nodes on edges are points like others.
  if (planar) read_rows(parser, count, static_cast<std::size_t>(corners), mesh, mesh.faces, nullptr, false, "elements");
  else read_rows(parser, count, static_cast<std::size_t>(corners), mesh, mesh.tetrahedra, nullptr, false, "elements");
}

template <std::size_t Corners>
void read_marked(const std::string& path, Mesh& mesh, Problems& problems, std::vector<std::array<int, Corners>>& rows, std::vector<int>& labels, const char* what) {
  const io::Source source = io::load(path);
  TextParser parser(path, source.text, problems);
  parser.need(fmt::format("the header (number of {}, markers)", what));
  parser.need_fields(1, 2, fmt::format("number of {}, markers", what));
  const int count = parser.count(0, "number of rows");
  const bool labelled = parser.size() > 1 && parser.choice(1, "number of markers", 0, 1) == 1;
  read_rows(parser, count, Corners, mesh, rows, &labels, labelled, what);
}

Mesh read_node_family(const std::string& base) {
  Problems problems;
  const io::Source source = io::load(base + ".node");
  TextParser parser(source.file, source.text, problems);
  Input nodes;
  io::read_nodes(source, parser, 2, nodes);
  parser.expect_end(fmt::format("{} points were announced", nodes.vertices.size()));
  Mesh mesh;
  mesh.file = source.file;
  mesh.dimension = nodes.dimension;
  mesh.first_index = nodes.first_index;
  for (const InputVertex& vertex : nodes.vertices) mesh.points.push_back(vertex.position);
  const auto exists = [&](const char* suffix) { return std::filesystem::exists(base + suffix); };
  if (exists(".ele")) read_elements(base + ".ele", mesh, problems);
  if (mesh.dimension == 3 && exists(".face")) read_marked(base + ".face", mesh, problems, mesh.faces, mesh.face_labels, "faces");
  if (exists(".edge")) read_marked(base + ".edge", mesh, problems, mesh.edges, mesh.edge_labels, "edges");
  problems.throw_if_any();
  return mesh;
}

}  // namespace

Mesh read_mesh(const std::string& path) {
  const std::string suffix = io::suffix(path);
  if (suffix == ".mesh") return io::read_medit_mesh(io::load(path));
  if (suffix == ".vtu") return io::read_vtu(io::load(path));
  for (const char* known : {".node", ".ele", ".face", ".edge"})
    if (suffix == known) return read_node_family(path.substr(0, path.size() - suffix.size()));
  if (std::filesystem::exists(path + ".node")) return read_node_family(path);
  io::load(path);  // A file that is not there at all is the more useful message.
  throw InputError({{"E-FORMAT", {path, 0, 0}, fmt::format("the suffix '{}' names no mesh that can be read: use .node (with .ele, .face), .mesh, .vtu", suffix)}});
}

}  // namespace confidel
