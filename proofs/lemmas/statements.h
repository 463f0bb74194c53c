// SPDX-License-Identifier: GPL-3.0-or-later
// The tests of the statements, one file for each or for a tight group; table.cpp names them. All throw MissingParameter.
#pragma once

namespace confidel {
class Instance;
class Tally;

namespace statements {

using Statement = void(const Instance&, Tally&);

// hypotheses.cpp
Statement angle, ball, chord;
// offsets.cpp
Statement offset;
// spacing.cpp
Statement arc_spacing, edge_spacing;
// bulges.cpp
Statement spoke_bulge, box_bulge;
// protectors.cpp
Statement protectors_apart, obtuse_corners;
// boundary_separation.cpp
Statement boundary_separation;
// insertions.cpp
Statement insertions;
// empty_spheres.cpp
Statement end_cells_empty, spokes_and_caps, spokes_and_arcs, boxes_empty, other_cells_empty, emptiness, ties;
// alignment.cpp
Statement alignment, sheet_separation;
// tilt.cpp
Statement tilt;
// outline.cpp
Statement locally_delaunay, penetration;
// tiling.cpp
Statement tiling;
// circumradius.cpp
Statement circumradius;
// feature_separation.cpp
Statement feature_separation;
// hanging.cpp
Statement hanging_empty;

}  // namespace statements
}  // namespace confidel
