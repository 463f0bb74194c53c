// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/audit/intrusion.h"

#include <cmath>
#include <optional>

#include "core/numbers/predicates.h"
#include "core/planar/frame.h"

namespace confidel {
namespace {

using Rational3 = std::array<mpq_class, 3>;

Rational3 step(const Point& to, const Point& from) {
  return {rational_coordinate(to, 0) - rational_coordinate(from, 0), rational_coordinate(to, 1) - rational_coordinate(from, 1), rational_coordinate(to, 2) - rational_coordinate(from, 2)};
}
Rational3 product(const Rational3& a, const Rational3& b) { return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]}; }
mpq_class inner(const Rational3& a, const Rational3& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

/// Powers and pencil of one triangle, in rationals. n = (b-a) x (c-a).
class ExactTriangle {
 public:
  ExactTriangle(const Point& a, const Point& b, const Point& c) : a_(a), u_(step(b, a)), w_(step(c, a)), n_(product(u_, w_)), nn_(inner(n_, n_)) {
    const Rational3 first = product(w_, n_), second = product(n_, u_);
    for (int axis = 0; axis < 3; ++axis) centre_[axis] = (inner(u_, u_) * first[axis] + inner(w_, w_) * second[axis]) / (2 * nn_);
  }

  struct At {
    mpq_class power, height;  ///< with respect to the smallest sphere; n.(x-a)
    mpq_class parameter() const { return power / (2 * height); }
  };
  At at(const Point& x) const {
    const Rational3 d = step(x, a_);
    return {inner(d, d) - 2 * inner(d, centre_), inner(n_, d)};
  }
  mpq_class squared_radius(const mpq_class& parameter) const { return inner(centre_, centre_) + parameter * parameter * nn_; }

 private:
  const Point& a_;
  Rational3 u_, w_, n_;
  mpq_class nn_;
  Rational3 centre_;  ///< relative to a
};

/// A guess in doubles which points bound the pencil, so that few have to be evaluated exactly.
class Guess {
 public:
  Guess(const Point& a, const Point& b, const Point& c) : a_(a) {
    const Double3 u = approximate_difference(b, a), w = approximate_difference(c, a);
    n_ = cross(u, w);
    const double nn = dot(n_, n_);
    centre_ = (dot(u, u) / (2 * nn)) * cross(w, n_) + (dot(w, w) / (2 * nn)) * cross(n_, u);
  }
  double parameter(const Point& x) const {
    const Double3 d = approximate_difference(x, a_);
    return (dot(d, d) - 2 * dot(d, centre_)) / (2 * dot(n_, d));
  }
  double power(const Point& x) const {
    const Double3 d = approximate_difference(x, a_);
    return dot(d, d) - 2 * dot(d, centre_);
  }

 private:
  const Point& a_;
  Double3 n_{}, centre_{};
};

struct Bound {
  int id = -1;
  double guess = 0;
};

Intrusion conflict(const ExactTriangle& triangle, const std::vector<Point>& points, int above, int below) {
  const auto x = triangle.at(points[above]), y = triangle.at(points[below]);
  const mpq_class high = x.parameter(), low = y.parameter();
  Intrusion result;
  if (low < high) return result;
  // P_t(x) = 2 h_x (high - t) and P_t(y) = 2 h_y (low - t) with h_y < 0: equal where t is their mean, weighted by the heights.
  const mpq_class p = x.height, q = -y.height, t = (p * high + q * low) / (p + q), depth = 2 * p * q * (low - high) / (p + q);
  result.found = true;
  result.first = above;
  result.second = below;
  result.relative_depth = mpq_class(depth / triangle.squared_radius(t)).get_d();
  return result;
}

}  // namespace

Intrusion find_intrusion(const Point& a, const Point& b, const Point& c, const std::vector<Point>& points, const std::function<bool(int)>& skip) {
  const ExactTriangle triangle(a, b, c);
  const Guess guess(a, b, c);
  Bound above, below, inside;
  std::vector<std::pair<int, int>> sides;  // id and side, of the points off the plane
  for (int id = 0; id < static_cast<int>(points.size()); ++id) {
    if (skip(id)) continue;
    const int side = orientation(a, b, c, points[id]);
    if (side == 0) {
      if (diametral_power(a, b, c, points[id]) >= 0) continue;
      if (const double power = guess.power(points[id]); inside.id < 0 || power < inside.guess) inside = {id, power};
      continue;
    }
    sides.emplace_back(id, side);
    const double parameter = guess.parameter(points[id]);
    Bound& bound = side > 0 ? above : below;
    if (bound.id < 0 || (side > 0 ? parameter < bound.guess : parameter > bound.guess)) bound = {id, parameter};
  }
  if (inside.id >= 0) {
    const mpq_class depth = -triangle.at(points[inside.id]).power;
    return {true, inside.id, -1, mpq_class(depth / triangle.squared_radius(0)).get_d()};
  }
  if (above.id < 0 || below.id < 0) return {};
  if (const Intrusion quick = conflict(triangle, points, above.id, below.id); quick.found) return quick;
  // The guess may have missed the true bounds: all points, exactly.
  std::optional<mpq_class> high, low;
  for (const auto& [id, side] : sides) {
    const mpq_class parameter = triangle.at(points[id]).parameter();
    if (side > 0 ? !high || parameter < *high : !low || parameter > *low) {
      (side > 0 ? high : low) = parameter;
      (side > 0 ? above : below).id = id;
    }
  }
  return conflict(triangle, points, above.id, below.id);
}

}  // namespace confidel
