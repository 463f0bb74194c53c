// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/placement/sphere.h"

#include <cmath>

namespace confidel {

namespace {

// A ball around a + offset; the rounding of its centre is relative to the coordinates, which may be small against 1 or large against the radius.
Ball around(const Point& a, const Double3& offset, double inflation) {
  const auto size = [](const Double3& p) { return std::abs(p[0]) + std::abs(p[1]) + std::abs(p[2]); };
  return {a.approximate() + offset, length(offset) * (1 + inflation) + 0x1p-51 * (size(a.approximate()) + size(offset))};
}

}  // namespace

Ball diametral_ball(const Point& a, const Point& b) { return around(a, 0.5 * approximate_difference(b, a), 1e-12); }

Ball circumscribed_ball(const Point& a, const Point& b, const Point& c, Double3* offset) {
  const Double3 u = approximate_difference(b, a), w = approximate_difference(c, a), n = cross(u, w);
  const double uu = dot(u, u), ww = dot(w, w), nn = dot(n, n);
  const Double3 z = (uu / (2 * nn)) * cross(w, n) + (ww / (2 * nn)) * cross(n, u);
  if (offset != nullptr) *offset = z;
  // The centre's relative error is about 20 u / sin^2 of the angle at a.
  const double sine_square = nn / (uu * ww);
  const double inflation = 1e-12 + 1e-14 / sine_square;
  Ball ball = around(a, z, inflation);
  if (!std::isfinite(ball.radius) || inflation > 1) ball = {Double3{0, 0, 0}, 1e10};  // everything
  return ball;
}

bool encroaches(Projection projection, const Point& a, const Point& b, const Point& c, const Point& p, const Point* first, const Point* second) {
  const int power = diametral_power(a, b, c, p);
  if (power != 0) return power < 0;
  if (orientation(a, b, c, p) != 0) return true;
  return first != nullptr && planar_orientation(projection, *first, *second, p) < 0;
}

Point CircumcentreRounding::round(const Point& a, const Double3& offset, double tolerance) const {
  // Next to features that are tiny against the facet only a close base is accurate enough.
  if (length(offset) > reach * 0x1p-36) return frame.round(origin, approximate_difference(a, origin) + offset, tolerance);
  return frame.round(a, offset, tolerance);
}

}  // namespace confidel
