// SPDX-License-Identifier: GPL-3.0-or-later
// Merging exactly coplanar neighbours: the diagonals of a triangulated polygon are no constraints.
#pragma once

#include "core/complex/complex.h"

namespace confidel {

struct MergeSummary {
  int facets_before = 0, facets_after = 0;
  int segments_removed = 0;  ///< segments that are inside a merged facet now, and no constraints
};

/// Merges facets that lie in one plane, exactly, and share a segment that belongs to no other facet, with equal markers; transitively.
/// A segment where two merged facets meet and that others share too becomes an inner constraint, a vertex all of whose segments vanish
/// an isolated vertex. Vertices and their numbers stay; the merged facet keeps the place, the frame and the line of the first of them.
/// Segments that the input states by themselves (kept, increasing) never vanish: within a merged facet they are inner constraints.
/// Pre and post: a valid, triangulated complex.
MergeSummary merge_coplanar_facets(Complex& complex, const std::vector<Segment>& kept = {});

}  // namespace confidel
