// SPDX-License-Identifier: GPL-3.0-or-later
// Planar inputs whose convex hull makes sharp angles with them (artificial hull edges do): an edge of the hull is Delaunay whatever
// happens inside, so it needs no protection, and its angles cost nothing.
#pragma once

#include <optional>

#include "core/complex/complex.h"
#include "core/features/features.h"
#include "core/placement/placement.h"

namespace confidel {

/// Nothing if no boundary edge of the domain on its convex hull makes an angle below 5 degrees with another segment, or dimension is 3.
/// Otherwise the graded strategy on all other segments, each protected on its own as a hanging edge is (closed diametral disks
/// without other points, theory.md section 4 (0)), and the Delaunay triangles of the domain. Throws what place_graded throws.
std::optional<Placement> place_with_open_hull(const Complex& complex, const Features& features, const Limits& limits, Progress& progress);

}  // namespace confidel
