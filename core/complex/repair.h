// SPDX-License-Identifier: GPL-3.0-or-later
// Explicit repairs of an input, each one reported: what `confidel convert` does when it is told to.
#pragma once

#include <string>
#include <vector>

#include "core/complex/input.h"

namespace confidel {

struct Repair {
  std::string kind;  ///< "merge", "triangulate", "split"
  std::string message;
  double moved = 0;  ///< how far a point that was made lies from where it exactly belongs, in the input's units; rounded for the reader
};

/// Vertices with bit-identical positions (zeros have no sign) become one; nothing that is merely close does. The first one keeps its place.
std::vector<Repair> merge_identical_vertices(Input& input);

/// Facets that are not flat, exactly, become triangles without new vertices: a triangulation of their projection along a coordinate axis.
/// Flat facets stay as they are. Throws InputError (E-NONCOPLANAR, E-INDEX, E-DEGENERATE-FACET) for facets whose projection crosses or touches itself.
std::vector<Repair> triangulate_facets(Input& input);

/// Dimension 2: segments that cross are split at a new vertex, the crossing's nearest double. Where the crossing is no double, this bends
/// the segments by less than a unit in the last place, which may make new crossings: repeated until there are none.
/// Throws InputError: E-FORMAT in dimension 3, E-CROSSING if there is no end of it.
std::vector<Repair> split_crossings(Input& input);

}  // namespace confidel
