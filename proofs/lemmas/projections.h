// SPDX-License-Identifier: GPL-3.0-or-later
// Where an edge at a vertex lies over a facet at that vertex (L15, and the local strategy's offsets).
#pragma once

#include "proofs/lemmas/rational_geometry.h"

namespace confidel {

/// A cell v p q of the facet, counter-clockwise, whose angle at v contains the orthogonal projection of the direction u; -1: none.
inline int cell_below(const Instance& instance, VertexId v, FacetId facet, const RationalVector& u) {
  const RationalVector& n = instance.normal(facet);
  for (const int c : instance.cells_at(v)) {
    const PlacedCell& cell = instance.cells[c];
    if (cell.facet != facet) continue;
    const int k = cell.corners[0] == v ? 0 : cell.corners[1] == v ? 1 : 2;
    const RationalVector p = minus(instance.positions[cell.corners[(k + 1) % 3]], instance.positions[v]);
    const RationalVector q = minus(instance.positions[cell.corners[(k + 2) % 3]], instance.positions[v]);
    if (dot(n, cross(p, u)) >= 0 && dot(n, cross(u, q)) >= 0) return c;
  }
  return -1;
}

/// sin^2 of the angle between the direction u and the facet's plane.
inline mpq_class squared_sine(const Instance& instance, FacetId facet, const RationalVector& u) {
  const RationalVector& n = instance.normal(facet);
  return square(dot(u, n)) / (squared(u) * squared(n));
}

}  // namespace confidel
