// SPDX-License-Identifier: GPL-3.0-or-later
// The Delaunay mesh of a placement's points, to be taken to other tools.
#pragma once

#include <string>
#include <vector>

#include "core/complex/complex.h"
#include "core/complex/input.h"
#include "core/io/mesh.h"
#include "core/placement/placement.h"

namespace confidel {

/// hull: every element of the convex hull (in the plane: of what the segments enclose, without holes). regions: without what is reached from outside, or from a hole point, without crossing a facet
/// (in the plane: an input segment).
enum class Keep { hull, regions };

struct ConformingMesh {
  Mesh mesh;                 ///< the points as their nearest doubles
  double greatest_move = 0;  ///< of a point by rounding, in the input's units
  long moved = 0;            ///< points that are no doubles
  long inverted = 0;         ///< elements that rounding turned around or made flat, exactly
  std::vector<std::string> remarks;
};

/// The exact Delaunay tetrahedralization of all points (one of them, if there are ties: all of them conform, this is what the certificate
/// says); in the plane, and where all points lie in one plane, the placement's cells. Faces are all triangles on facets, edges all pieces of
/// segments, with their markers (the number of the facet or segment from 1 on where the input has no markers); tetrahedra have the attribute of the
/// region that a region's point of the input lies in.
/// exact: the points as rationals, too. Deterministic. Throws InputError (E-HOLE) if a hole's or region's point lies on a facet.
ConformingMesh conforming_mesh(const Complex& complex, const Input& input, const Placement& placement, Keep keep, bool exact);

}  // namespace confidel
