// SPDX-License-Identifier: GPL-3.0-or-later
// The pencil of spheres through a triangle, exactly.
#pragma once

#include <gmpxx.h>

#include <optional>

#include "core/complex/complex.h"
#include "core/numbers/point.h"

namespace confidel {

/// The parameter t for which the sphere through a, b, c with centre z0 + t n passes through x: P0(x) / (2 n.(x-a)), exactly.
/// Pre: a, b, c not collinear; x off their plane; n is normal to it.
mpq_class pencil_parameter(const Point& a, const Point& b, const Point& c, const Point& x, const Difference& normal);

/// P0(x): the power of x with respect to the smallest sphere through a, b, c, exactly. Pre: a, b, c not collinear.
mpq_class power_of(const Point& a, const Point& b, const Point& c, const Point& x);

/// An offset strictly between the bounds, with few bits and well inside; zero (the smallest sphere) where that is well inside.
/// A missing bound is infinite. scale: a length^-1 that makes a difference, (circumradius / |n|) up to a factor. Pre: low < high.
mpq_class choose_offset(const std::optional<mpq_class>& low, const std::optional<mpq_class>& high, double scale);

/// The normal of a facet as certificates define it: (Pj-Pi) x (Pk-Pi), not reduced, in working coordinates.
Difference certificate_normal(const Complex& complex, const Facet& facet);

}  // namespace confidel
