// SPDX-License-Identifier: GPL-3.0-or-later
// What the pictures of all formats are made from: a certificate, what was measured on it, and what the checker said.
#pragma once

#include <array>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "apps/draw/lemma_slacks.h"
#include "proofs/certificate/clearance.h"
#include "proofs/certificate/reader.h"

namespace confidel {

/// A protecting circle or sphere: vertices at the tip of cells of the kinds S and T have one.
struct DrawnBall {
  int vertex = 0;
  double radius = 0;
  mpq_class radius_square;  ///< of the point below; the others on the ball may be rounded differently
  int point = 0;
  int tightest = -1;  ///< of its cells
};

struct CellEdge {
  std::array<int, 2> ends{};  ///< increasing
  int segment = -1;           ///< that it lies on
  int tightest = -1;          ///< of its cells
  bool chew_boundary = false; ///< between a cell of kind C and what is none: the boundary of P''
};

/// What a refuting certificate points at (lemma-claims.md, section 5).
struct Witness {
  std::string statement;           ///< empty: the certificate refutes nothing
  std::vector<int> cells, points;
};

struct Picture {
  Certificate certificate;
  std::vector<std::array<double, 3>> positions;
  std::vector<CellClearance> clearances;
  std::vector<LemmaSlacks> lemmas;
  std::vector<DrawnBall> balls;       ///< by vertex
  std::vector<CellEdge> edges;   ///< by facet, then by ends; an edge of two facets occurs in both
  nlohmann::ordered_json check;  ///< the checker's report, or null
  std::string verdict;           ///< its last line, or why there is none

  Witness witness;

  /// Cells with a point where there must be none, in order.
  std::vector<int> violated;

  /// The slack of a cell that pictures show: relative power of the nearest point off the plane in dimension 3, of the nearest point in
  /// dimension 2; infinite if there is no such point.
  const Nearest& slack(std::size_t cell) const {
    return certificate.dimension == 3 ? clearances[cell].off_plane : clearances[cell].all;
  }
  double slack_value(std::size_t cell) const;
  /// The cell of smaller slack, the first of several; -1 stands for none.
  int tighter(int a, int b) const;
};

/// Fills balls, edges, witness and violated; the rest must be there.
void derive(Picture& picture);

/// The value rounded to 17 digits, and exactly where that is short or if it is asked for: "0.333 (exactly 1/3)".
std::string exact_text(const mpq_class& value, bool in_full);
double nearest_double(const mpq_class& value);

/// The coordinates in decimal, exact where they are short: "(1.5, 2)".
std::string point_text(const Picture& picture, int point, bool in_full);

/// "12 (arc)", "3 (vertex)".
std::string point_name(const Certificate& certificate, int point);

}  // namespace confidel
