// SPDX-License-Identifier: GPL-3.0-or-later
// How triangles and segments meet, in rationals and by clipping: shares nothing with core/complex/intersection.cpp.
#pragma once

#include <algorithm>
#include <vector>

#include "tests/core/complex/canonical_reader.h"

namespace confidel::test {

using Shape = std::vector<Rational3>;  ///< a convex polygon's corners in order, a segment's ends, a point, or nothing

inline Rational3 between(const Rational3& a, const Rational3& b, const mpq_class& t) {
  return {a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1]), a[2] + t * (b[2] - a[2])};
}

/// The part of the shape with n.(x - origin) >= 0.
inline Shape clipped(const Shape& shape, const Rational3& normal, const Rational3& origin) {
  Shape result;
  for (std::size_t i = 0; i < shape.size(); ++i) {
    const Rational3 &from = shape[i], &to = shape[(i + 1) % shape.size()];
    const mpq_class a = scalar(normal, minus(from, origin)), b = scalar(normal, minus(to, origin));
    if (a >= 0) result.push_back(from);
    if (sgn(a) * sgn(b) < 0) result.push_back(between(from, to, mpq_class(a / (a - b))));
  }
  Shape distinct;
  for (const Rational3& point : result)
    if (std::find(distinct.begin(), distinct.end(), point) == distinct.end()) distinct.push_back(point);
  return distinct;
}

inline Rational3 negative(const Rational3& a) { return {-a[0], -a[1], -a[2]}; }

/// The corners of the common part of a convex shape and a convex polygon whose first three corners are not collinear.
inline Shape common_part(Shape shape, const Shape& polygon) {
  const Rational3 normal = times(minus(polygon[1], polygon[0]), minus(polygon[2], polygon[0]));
  shape = clipped(clipped(shape, normal, polygon[0]), negative(normal), polygon[0]);
  for (std::size_t i = 0; i < polygon.size(); ++i)
    shape = clipped(shape, times(normal, minus(polygon[(i + 1) % polygon.size()], polygon[i])), polygon[i]);
  return shape;
}

inline bool has_area(const Shape& shape) {
  for (std::size_t i = 2; i < shape.size(); ++i)
    if (times(minus(shape[1], shape[0]), minus(shape[i], shape[0])) != Rational3{0, 0, 0}) return true;
  return false;
}

/// The ends of a shape without area: two points or one.
inline Shape ends_of(const Shape& shape) {
  if (shape.size() <= 1) return shape;
  return {*std::min_element(shape.begin(), shape.end()), *std::max_element(shape.begin(), shape.end())};
}

inline bool on_segment(const Rational3& point, const Rational3& a, const Rational3& b) {
  return times(minus(b, a), minus(point, a)) == Rational3{0, 0, 0} && scalar(minus(a, point), minus(b, point)) <= 0;
}

}  // namespace confidel::test
