// SPDX-License-Identifier: GPL-3.0-or-later
// Meshes of other tools, to be judged, and our own, to be taken along.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "core/complex/input.h"
#include "core/io/source.h"

namespace confidel {

struct Mesh {
  std::string file;
  int dimension = 3;
  int first_index = 0;  ///< the file's own numbering, for messages
  std::vector<std::array<double, 3>> points;
  std::vector<std::array<int, 2>> edges;       ///< those that the mesh names: pieces of segments
  std::vector<std::array<int, 3>> faces;       ///< pieces of facets; in dimension 2 the triangles of the mesh
  std::vector<std::array<int, 4>> tetrahedra;
  /// As many as edges, faces, tetrahedra, or none. Labels of tetrahedra are attributes of regions.
  std::vector<int> edge_labels, face_labels;
  std::vector<double> tetrahedron_labels;
  /// Coordinates as exact text, as many as points, or none: written instead of the doubles where the format is text.
  std::vector<std::array<std::string, 3>> exact;
};

/// Reads .node with .ele, .face and .edge (TetGen, Triangle; named by any of them or by what they have in common), medit .mesh, .vtu (ascii
/// or inline base64). A number is its nearest double. Throws InputError, FileError.
Mesh read_mesh(const std::string& path);

/// The files that make up the mesh in the format of the path's suffix, names and contents: .node (with .ele, .face, .edge), .vtu, .mesh,
/// .off (faces only). Numbers round-trip; the same mesh gives the same bytes.
/// Throws InputError (E-FORMAT) for other suffixes, and for exact text in .vtu and .mesh.
std::vector<std::pair<std::string, std::string>> mesh_files(const Mesh& mesh, const std::string& path);

namespace io {
Mesh read_medit_mesh(const Source& source);
Mesh read_vtu(const Source& source);
std::string vtu_text(const Mesh& mesh);
}  // namespace io

}  // namespace confidel
