// SPDX-License-Identifier: GPL-3.0-or-later
// What a reader hands on: the file's entities as they stand, with their places, before any exact validity test.
#pragma once

#include <array>
#include <stdexcept>
#include <string>
#include <vector>

namespace confidel {

/// A place in an input file; line 0 means the file as a whole, column 0 the line as a whole.
struct Place {
  std::string file;
  int line = 0;
  int column = 0;
};

/// One violation: a code such as E-NONCOPLANAR, and "what, where, what to do".
struct Problem {
  std::string code;
  Place place;
  std::string message;
};

/// Bad input: thrown by readers and by build_complex; the command prints each problem as
/// `file:line:column: error[CODE]: message` (the first 20, then a count) and exits with 2.
class InputError : public std::runtime_error {
 public:
  explicit InputError(std::vector<Problem> problems);
  std::vector<Problem> problems;
};

/// A file cannot be read or written: exit code 4.
class FileError : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

struct InputVertex {
  std::array<double, 3> position{};  ///< z = 0 in planar inputs
  int marker = 0;
  int line = 0;
};

/// A loop of corners (k >= 3), a segment (k = 2) or an isolated vertex (k = 1) of a facet.
struct InputPolygon {
  std::vector<int> corners;  ///< 0-based
  int line = 0;
};

struct InputFacet {
  std::vector<InputPolygon> polygons;
  std::vector<std::array<double, 3>> holes;  ///< points whose projections to the plane lie in holes
  int marker = 0;
  int line = 0;
};

struct InputSegment {
  std::array<int, 2> ends{};
  int marker = 0;
  int line = 0;
};

struct InputRegion {
  std::array<double, 3> seed{};
  double attribute = 0;
  double bound = -1;  ///< maximal area or volume; -1: none
  int line = 0;
};

struct Input {
  std::string file;
  std::string vertex_file;  ///< the file that the vertices' lines refer to: the companion .node, or file itself
  int dimension = 3;
  int first_index = 0;  ///< 0 or 1: the base of the file's own numbering, for messages
  bool has_markers = false;
  bool triangle_soup = false;  ///< .off, .obj, .stl, .ply, .mesh: facets are pieces of surfaces (see --merge-coplanar)
  std::vector<InputVertex> vertices;
  std::vector<InputFacet> facets;      ///< dimension 3
  std::vector<InputSegment> segments;  ///< dimension 2: the PSLG; dimension 3: segments outside facets (.obj `l`)
  std::vector<std::array<double, 3>> holes;  ///< volume holes (3D) or area holes (2D)
  std::vector<InputRegion> regions;
  /// What the reader did that the author may want to know: merged corners and the like.
  std::vector<std::string> remarks;
};

}  // namespace confidel
