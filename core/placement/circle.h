// SPDX-License-Identifier: GPL-3.0-or-later
// Exactly on the circle: rational points, reflections and rows for the planar strategies (theory.md section 3, 2D).
#pragma once

#include "core/planar/rational_region.h"

namespace confidel {

RationalPoint2 operator+(const RationalPoint2& a, const RationalPoint2& b);
RationalPoint2 operator-(const RationalPoint2& a, const RationalPoint2& b);
RationalPoint2 operator*(const mpq_class& factor, const RationalPoint2& a);
mpq_class dot(const RationalPoint2& a, const RationalPoint2& b);
mpq_class cross(const RationalPoint2& a, const RationalPoint2& b);

/// A rational point of the unit circle in the direction `angle` (radians), to within 2^-bits: t -> ((1-t^2)/(1+t^2), 2t/(1+t^2)) with
/// dyadic t, in the quarter of the circle where |t| <= tan(pi/8).
RationalPoint2 point_of_unit_circle(double angle, int bits);

/// The orthogonal projection of p onto the line through a and b. Exact.
RationalPoint2 projected(const RationalPoint2& p, const RationalPoint2& a, const RationalPoint2& b);
/// The mirror image of p in the perpendicular bisector of ab. Exact.
RationalPoint2 reflected(const RationalPoint2& p, const RationalPoint2& a, const RationalPoint2& b);

}  // namespace confidel
