// SPDX-License-Identifier: GPL-3.0-or-later
// Lower bounds of distances between points, segments and triangles.
#pragma once

#include <span>

#include "core/features/bounding_volumes.h"
#include "core/numbers/point.h"

namespace confidel {

/// A vertex as filters see it. exact: position is the point itself, as it is for all vertices that were read from
/// doubles.
struct Corner {
  explicit Corner(const Point& point);

  const Point* point;
  Vector position;
  bool exact;
  Box box;
};

/// A simplex: one to three corners, affinely independent.
using Simplex = std::span<const Corner* const>;

/// A lower bound of the distance between a point or segment a and a simplex b. It is within a relative 1e-9 of the
/// distance unless it is at least limit. direction: any vector along which a and b may be far apart, it is tried first;
/// set to the one that belongs to a distance below the limit, so that the next ones are passed over quickly.
/// Pre: coordinates have magnitude <= 1.
double distance_below(Simplex a, Simplex b, double limit, Vector& direction);

/// The largest double that is not above the distance, from exact squared distances; 0 if a and b meet.
double exact_distance_below(Simplex a, Simplex b);

/// The largest double not above sqrt(numerator / denominator) * 2^-exponent, up to a relative 2^-51 (an absolute
/// 2^-1073 if tiny). Pre: numerator >= 0, denominator > 0.
double square_root_below(const mpz_class& numerator, const mpz_class& denominator, int exponent);

}  // namespace confidel
