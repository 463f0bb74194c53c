// SPDX-License-Identifier: GPL-3.0-or-later
// Vectors of doubles for filters. u = 2^-53 in all comments: no operation fuses or reassociates (-ffp-contract=off).
#pragma once

#include <cmath>

#include "core/features/bounding_volumes.h"

namespace confidel {

inline Vector operator-(const Vector& a, const Vector& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
inline Vector operator+(const Vector& a, const Vector& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
inline Vector operator*(double factor, const Vector& a) { return {factor * a[0], factor * a[1], factor * a[2]}; }
inline double dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
inline Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
inline double sum_of_magnitudes(const Vector& a) { return std::abs(a[0]) + std::abs(a[1]) + std::abs(a[2]); }

}  // namespace confidel
