// SPDX-License-Identifier: GPL-3.0-or-later
// The cells of a planar domain once its segments are refined: its constrained Delaunay triangulation.
#pragma once

#include <vector>

#include "core/complex/complex.h"
#include "core/placement/placement.h"

namespace confidel {

/// Adds the triangles of the domain (kind C) and the pieces of segments outside it (hanging) to the placement, whose points are final.
/// chains: per segment its points from its first to its second vertex, both included. Pre: dimension 2, every other Steiner point lies in
/// the domain on no segment. Where the pieces are Delaunay, so are the triangles (Lemma 1.1).
void add_planar_cells(const Complex& complex, const std::vector<std::vector<int>>& chains, Placement& placement);

}  // namespace confidel
