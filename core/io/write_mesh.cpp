// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include "core/io/mesh.h"

namespace confidel {
namespace {

using Files = std::vector<std::pair<std::string, std::string>>;

std::string coordinates(const Mesh& mesh, std::size_t point) {
  std::string text;
  for (int axis = 0; axis < mesh.dimension; ++axis) {
    if (axis > 0) text += ' ';
    text += mesh.exact.empty() ? fmt::format("{}", mesh.points[point][axis]) : mesh.exact[point][axis];
  }
  return text;
}

template <class Row>
std::string corners(const Row& row, int base) {
  std::string text;
  for (const int corner : row) text += fmt::format("{}{}", text.empty() ? "" : " ", corner + base);
  return text;
}

template <class Label>
std::string label(const std::vector<Label>& labels, std::size_t i) {
  return labels.empty() ? "0" : fmt::format("{}", labels[i]);
}

template <class Rows>
std::string marked(const Rows& rows, const std::vector<int>& labels, int base) {
  std::string text = fmt::format("{} 1\n", rows.size());
  for (std::size_t i = 0; i < rows.size(); ++i) text += fmt::format("{} {} {}\n", i + base, corners(rows[i], base), label(labels, i));
  return text;
}

Files node_family(const Mesh& mesh, const std::string& base_name) {
  const int base = mesh.first_index;
  std::string nodes = fmt::format("{} {} 0 0\n", mesh.points.size(), mesh.dimension);
  for (std::size_t i = 0; i < mesh.points.size(); ++i) nodes += fmt::format("{} {}\n", i + base, coordinates(mesh, i));
  Files files{{base_name + ".node", nodes}};
  std::string elements;
  if (mesh.dimension == 2) {
    elements = fmt::format("{} 3 0\n", mesh.faces.size());
    for (std::size_t i = 0; i < mesh.faces.size(); ++i) elements += fmt::format("{} {}\n", i + base, corners(mesh.faces[i], base));
  } else {
    elements = fmt::format("{} 4 {}\n", mesh.tetrahedra.size(), mesh.tetrahedron_labels.empty() ? 0 : 1);
    for (std::size_t i = 0; i < mesh.tetrahedra.size(); ++i)
      elements += fmt::format("{} {}{}\n", i + base, corners(mesh.tetrahedra[i], base), mesh.tetrahedron_labels.empty() ? "" : " " + label(mesh.tetrahedron_labels, i));
    files.emplace_back(base_name + ".face", marked(mesh.faces, mesh.face_labels, base));
  }
  files.emplace_back(base_name + ".ele", elements);
  files.emplace_back(base_name + ".edge", marked(mesh.edges, mesh.edge_labels, base));
  return files;
}

std::string medit(const Mesh& mesh) {
  std::string text = fmt::format("MeshVersionFormatted 2\nDimension {}\nVertices {}\n", mesh.dimension, mesh.points.size());
  for (std::size_t i = 0; i < mesh.points.size(); ++i) text += coordinates(mesh, i) + " 0\n";
  const auto section = [&](const char* name, const auto& rows, const auto& labels) {
    if (rows.empty()) return;
    text += fmt::format("{} {}\n", name, rows.size());
    for (std::size_t i = 0; i < rows.size(); ++i) {
      // References are integers; regions have numbers.
      const auto reference = labels.empty() ? 0L : static_cast<long>(labels[i]);
      text += fmt::format("{} {}\n", corners(rows[i], 1), reference);
    }
  };
  section("Edges", mesh.edges, mesh.edge_labels);
  section("Triangles", mesh.faces, mesh.face_labels);
  section("Tetrahedra", mesh.tetrahedra, mesh.tetrahedron_labels);
  return text + "End\n";
}

std::string off(const Mesh& mesh) {
  std::string text = fmt::format("OFF\n{} {} 0\n", mesh.points.size(), mesh.faces.size());
  for (std::size_t i = 0; i < mesh.points.size(); ++i) text += coordinates(mesh, i) + (mesh.dimension == 2 ? " 0\n" : "\n");
  for (const auto& face : mesh.faces) text += "3 " + corners(face, 0) + "\n";
  return text;
}

}  // namespace

Files mesh_files(const Mesh& mesh, const std::string& path) {
  const std::string suffix = io::suffix(path);
  if (!mesh.exact.empty() && (suffix == ".vtu" || suffix == ".mesh"))
    throw InputError({{"E-FORMAT", {path, 0, 0}, fmt::format("{} holds doubles, no rationals: write .node or .off", suffix)}});
  for (const char* known : {".node", ".ele", ".face", ".edge"})
    if (suffix == known) return node_family(mesh, path.substr(0, path.size() - suffix.size()));
  if (suffix == ".vtu") return {{path, io::vtu_text(mesh)}};
  if (suffix == ".mesh") return {{path, medit(mesh)}};
  if (suffix == ".off") return {{path, off(mesh)}};
  throw InputError({{"E-FORMAT", {path, 0, 0}, fmt::format("the suffix '{}' names no mesh that can be written: use .vtu, .node, .mesh, .off", suffix)}});
}

}  // namespace confidel
