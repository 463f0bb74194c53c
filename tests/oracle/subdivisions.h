// SPDX-License-Identifier: GPL-3.0-or-later
// Does every Delaunay subdivision of a point set conform to a complex? Tried on several: CGAL's exact triangulations.
#pragma once

#include <array>
#include <cstdint>
#include <set>

#include "tests/core/complex/canonical_reader.h"

namespace confidel::test {

struct Conformity {
  int tried = 0;
  int conforming = 0;
  /// Different sets of edges among them: more than one where ties exist.
  int different = 0;
  /// The first fault found.
  std::string fault;
  bool always() const { return conforming == tried; }
};

/// The plain Delaunay triangulation, and `perturbed` more in which ties are broken at random: regular triangulations with random
/// weights, so small that they decide nothing but ties. (The order of insertion alone would change nothing: CGAL breaks ties by the
/// lexicographic order of the points, whatever the order. It is shuffled nevertheless.)
Conformity conformity(const CanonicalComplex& complex, const std::vector<Rational3>& points, int perturbed, std::uint64_t seed);

/// Edges and triangles of one Delaunay subdivision, corners increasing. Ties are broken at random, but in favour of the raised points (at most
/// three): if they are all on a sphere without points inside, their simplex is in the subdivision.
struct SubdivisionFaces {
  std::set<std::array<int, 2>> edges;
  std::set<std::array<int, 3>> triangles;
};
SubdivisionFaces subdivision(const std::vector<Rational3>& points, const std::vector<int>& raised, std::uint64_t seed);

}  // namespace confidel::test
