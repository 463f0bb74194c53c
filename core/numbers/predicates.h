// SPDX-License-Identifier: GPL-3.0-or-later
// Exact geometric predicates over dyadic points. Each returns the sign (-1, 0, +1) of a polynomial, exactly: a
// floating-point stage with a proved error bound decides the clear cases, integers decide the rest.
//
// Filters are effective for features above 2^-48 of the greatest coordinate of the points involved (or of 2^-100); smaller ones go to integers.
#pragma once

#include "core/numbers/point.h"

namespace confidel {

/// Sign of ((b-a) x (c-a)) . (d-a): +1 when d lies where the normal of (a,b,c) points to.
int orientation(const Point& a, const Point& b, const Point& c, const Point& d);

/// True iff a, b, c lie on one line (coinciding points included).
bool collinear(const Point& a, const Point& b, const Point& c);

/// The axis (0, 1, 2) along which a plane with this normal is projected for planar predicates: one with a
/// component of the greatest magnitude. sign is the sign of that component.
struct Projection {
  int axis = 2;
  int sign = 1;
};
Projection projection_of(const IntegerVector& normal);

/// Orientation of three points of one plane, seen from the plane's positive side: +1 counter-clockwise.
/// Precondition: the points lie in a plane with that projection.
int planar_orientation(Projection projection, const Point& a, const Point& b, const Point& c);

/// Lexicographic order of the projected points: -1, 0, +1. Equal points of the plane, and only these, compare 0.
int planar_compare(Projection projection, const Point& a, const Point& b);

/// The same along one axis of the projected plane: which = 0 or 1. (Axes are cyclic successors of projection.axis.)
int planar_compare_axis(Projection projection, int which, const Point& a, const Point& b);

/// +1 if d lies strictly inside the circle through a, b, c, -1 strictly outside, 0 on it.
/// Preconditions: coplanar as above; a, b, c counter-clockwise.
int planar_in_circle(Projection projection, const Point& a, const Point& b, const Point& c, const Point& d);

/// Sign of the power of x with respect to the smallest sphere through a, b, c (certificate-format.md, section 3):
/// -1 strictly inside, 0 on it, +1 outside. Precondition: a, b, c are not collinear.
int diametral_power(const Point& a, const Point& b, const Point& c, const Point& x);

/// Sign of (x-a).(x-b): the power of x with respect to the diametral sphere of the segment ab.
int diametral_power(const Point& a, const Point& b, const Point& x);

/// Sign of the power of e with respect to the sphere through a, b, c, d, times the orientation of (a,b,c,d):
/// +1 strictly inside for a positively oriented tetrahedron, -1 outside, 0 on the sphere (or a,b,c,d coplanar).
int in_sphere(const Point& a, const Point& b, const Point& c, const Point& d, const Point& e);

/// Sign of |p-a|^2 - |p-b|^2.
int compare_distance(const Point& p, const Point& a, const Point& b);

/// Precondition: p lies on the line through a and b, a != b. True iff p is strictly between them.
bool strictly_between(const Point& a, const Point& b, const Point& p);

}  // namespace confidel
