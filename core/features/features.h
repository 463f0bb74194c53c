// SPDX-License-Identifier: GPL-3.0-or-later
// Local feature sizes of a complex, for the graded strategy (theory.md section 4). They steer sizes; no verdict rests
// on them, but termination does: every value is a lower bound of the exact quantity, within a relative 1e-9 of it (1e-6
// for angles).
#pragma once

#include <array>
#include <vector>

#include "core/complex/complex.h"

namespace confidel {

struct Features {
  /// delta_v: distance from v to the nearest other vertex, segment without v, or facet that does not have v as one of
  /// its vertices. A facet that has v needs no entry of its own: what it has near v, beyond its sectors at v, is
  /// bounded by segments without v.
  std::vector<double> vertex_distance;
  /// g_e: distance from e to the nearest segment disjoint from e, vertex not on e, or triangle of K that is disjoint
  /// from e and belongs to a facet that does not contain e as a boundary edge or constraint. Infinity if there is none.
  std::vector<double> segment_distance;
  /// theta_{v,e}, [0] at the segment's first vertex, [1] at its second: smallest angle to another segment at v; pi if
  /// there is none.
  std::vector<std::array<double, 2>> segment_angle;
  /// omega_{v,e}: smallest angle at v between e and a facet at v that does not contain e; to the facet's sector (the
  /// cone of its triangles of K at v), not to its plane; pi if there is none.
  std::vector<std::array<double, 2>> facet_angle;
  /// alpha_e: smallest dihedral angle between two sheets at e (an inner constraint counts as two sheets); pi if fewer
  /// than two.
  std::vector<double> dihedral_angle;
  /// delta: smallest distance of two disjoint entities, of which one is a vertex or segment (lemma-claims.md section 2: facets as they
  /// are, whatever their triangulation). Infinity if there are none.
  double separation = 0;
};

/// Pre: complex is valid and its facets are triangulated. Near-linear through a bounding-volume hierarchy;
/// deterministic for any number of threads.
Features compute_features(const Complex& complex);

}  // namespace confidel
