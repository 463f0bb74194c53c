// SPDX-License-Identifier: GPL-3.0-or-later
// Lower bounds of angles, by cross and dot products and atan2: accurate for the smallest angles too.
#pragma once

#include "core/features/distances.h"

namespace confidel {

/// The double below pi: the bound where there is no angle.
inline constexpr double straight_angle = 0x1.921fb54442d18p+1;

/// Lower bounds of angles in [0, pi], within a relative 1e-6 of the angle unless they are at least limit.
/// Between the directions from v to a and to b.
double angle_below(const Corner& v, const Corner& a, const Corner& b, double limit);
/// Between the direction from v to a and the planar cone of the directions from v to b and to c. Pre: v, b, c are not
/// collinear.
double sector_angle_below(const Corner& v, const Corner& a, const Corner& b, const Corner& c, double limit);
/// Between the half-planes that the line ab bounds, through c and through d.
double dihedral_angle_below(const Corner& a, const Corner& b, const Corner& c, const Corner& d, double limit);

}  // namespace confidel
