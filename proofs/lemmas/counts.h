// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers of objects of the claims: the column "objects" of docs/lemma-claims.md section 4.
#pragma once

#include "proofs/lemmas/instance.h"

namespace confidel::counts {

long one(const Instance& instance);
long segment_ends(const Instance& instance);
long end_cells(const Instance& instance);
long opening_end_cells(const Instance& instance);
long spoke_cells(const Instance& instance);
long end_and_spoke_cells(const Instance& instance);
long boxes(const Instance& instance);
long box_cells(const Instance& instance);
long other_cells(const Instance& instance);
long cells(const Instance& instance);
long protecting_points(const Instance& instance);
long interior_points(const Instance& instance);
/// Ordered pairs of protectors of one row, their facets not in one plane.
long protectors_off_plane(const Instance& instance);
/// Unordered pairs of protectors of one row.
long protector_pairs(const Instance& instance);
/// Vertex, segment at it, facet in which the vertex occurs and that does not have the segment.
long tilts(const Instance& instance);
long outline_edges(const Instance& instance);
long facets(const Instance& instance);
long vertices_and_segments(const Instance& instance);
long hanging_subsegments(const Instance& instance);


}  // namespace confidel::counts
