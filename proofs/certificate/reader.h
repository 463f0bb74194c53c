// SPDX-License-Identifier: GPL-3.0-or-later
// A reader of certificates for the programs that show or use them: docs/certificate-format.md, sections 1 to 3. It believes the spelling and
// tests what its users rely on (counts, indices, W > 0); it gives no verdict. The checkers have readers of their own.
#pragma once

#include <gmpxx.h>

#include <array>
#include <string>
#include <utility>
#include <vector>

#include "core/complex/input.h"
#include "core/placement/placement.h"

namespace confidel {

/// (x, y, z) / w, w > 0; z = 0 in dimension 2. Exact; w need not be a power of two.
struct HomogeneousPoint {
  std::array<mpz_class, 3> numerator;
  mpz_class denominator = 1;

  /// The nearest double of a coordinate up to one unit in the last place, infinite beyond the range of doubles: for drawing only.
  double approximate(int axis) const;
  mpq_class coordinate(int axis) const;
};

struct CertificateFacet {
  std::array<int, 3> frame{};
  std::vector<std::array<int, 2>> boundary, constraints;
  std::vector<int> isolated;
};

struct CertificateCell {
  int facet = 0;
  std::array<int, 3> corners{};
  CellKind kind = CellKind::C;
  int box = -1;
  int line = 0;
  mpq_class offset;  ///< zero: none
};

struct CertificateRow {
  int segment = 0;
  int facet = -1;  ///< -1: the points of the segment itself
  bool left = false;
  std::vector<int> points;
};

/// A line whose meaning is for others (claims, parameters, evidence), as it stands.
struct CertificateLine {
  int line = 0;
  std::string text;
};

struct Certificate {
  std::string file;
  int dimension = 3;
  std::vector<HomogeneousPoint> points;  ///< the vertices first
  std::vector<PointKind> kinds;          ///< per point
  std::vector<int> carriers;             ///< per point: segment or facet; -1 for vertices
  std::vector<int> point_lines;
  int vertex_count = 0;
  std::vector<std::array<int, 2>> segments;
  std::vector<CertificateFacet> facets;
  std::vector<CertificateCell> cells;
  std::vector<CertificateRow> rows;
  std::vector<std::array<int, 3>> hanging;  ///< segment, a, b
  std::vector<CertificateLine> claims, parameters, evidence;
  std::vector<std::pair<std::string, std::string>> notes;
  std::string complex_sha256;
  bool digest_matches = false;  ///< the SHA-256 of the last line is right

  /// The text of the first note with this key, or "".
  std::string note(const std::string& key) const;
};

/// Reads a certificate, compressed or not. Throws FileError if the file cannot be read, and InputError with the code of
/// certificate-format.md section 6, line and column if it is none, or is of a newer version.
Certificate read_certificate(const std::string& path);

/// The same from text; `file` is for messages.
Certificate parse_certificate(const std::string& file, const std::string& text);

}  // namespace confidel
