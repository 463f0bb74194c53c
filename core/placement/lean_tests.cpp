// SPDX-License-Identifier: GPL-3.0-or-later
// What is supported: exact tests of triangles and of segments' pieces.
#include <algorithm>
#include <cmath>

#include "core/placement/lean_state.h"
#include "core/placement/sphere.h"

namespace confidel {

LeanState::State LeanState::test(FacetId f, const Triangle& t) {
  const FacetTriangulation& planar = planar_[f];
  if (flat_) return test_flat(f, t);
  auto face = tetrahedra_.face(t[0], t[1], t[2]);
  if (!face.exists) {
    bool tie = false;
    for (int i = 0; i < 3 && !tie; ++i) {
      const int d = planar.across(t[i], t[(i + 1) % 3], t[(i + 2) % 3]);
      tie = d >= 0 && diametral_power(point(t[0]), point(t[1]), point(t[2]), point(d)) == 0;
    }
    if (tie) face = tetrahedra_.cocircular_face(t[0], t[1], t[2]);
    if (!face.exists) return State::bad;
  }
  if (face.above >= 0 && face.below >= 0 && in_sphere(point(t[0]), point(t[1]), point(t[2]), point(face.above), point(face.below)) == 0)
    return State::bad;
  for (int i = 0; i < 3; ++i) {
    const int a = t[i], b = t[(i + 1) % 3], c = t[(i + 2) % 3];
    if (!planar.is_constraint(a, b)) continue;
    for (int d : tetrahedra_.coplanar_across(a, b, c))
      if (diametral_power(point(a), point(b), point(c), point(d)) == 0) {
        blocked_ = {a, b};
        return State::tie;
      }
  }
  return State::good;
}

// All points lie in one plane: the triangle's open disk is empty, and ties do not lie beyond constraints.
LeanState::State LeanState::test_flat(FacetId f, const Triangle& t) {
  const Point &a = point(t[0]), &b = point(t[1]), &c = point(t[2]);
  const Ball ball = circumscribed_ball(a, b, c);
  State state = State::good;
  index_.visit_ball(ball.centre, ball.radius, [&](int id) {
    if (!alive_[id] || id == t[0] || id == t[1] || id == t[2]) return false;
    const int power = diametral_power(a, b, c, point(id));
    if (power > 0) return false;
    // The intruder is behind a constraint: the first constraint of the triangle that it is beyond.
    for (int i = 0; i < 3; ++i) {
      const int p = t[i], q = t[(i + 1) % 3];
      if (planar_orientation(projections_[f], point(p), point(q), point(id)) >= 0 || !planar_[f].is_constraint(p, q)) continue;
      blocked_ = {p, q};
      state = State::tie;
      return true;
    }
    if (power == 0) return false;
    state = State::bad;
    return false;
  });
  return state;
}

// No other point in or on the diametral ball.
bool LeanState::hanging_encroached(int a, int b) const {
  const Ball ball = diametral_ball(point(a), point(b));
  return index_.visit_ball(ball.centre, ball.radius, [&](int id) {
    return alive_[id] && id != a && id != b && diametral_power(point(a), point(b), point(id)) <= 0;
  });
}

bool LeanState::unsupported(int a, int b) const {
  if (chains_[segment_of(a, b)].hanging()) return hanging_encroached(a, b);
  return !flat_ && !tetrahedra_.is_edge(a, b);
}

bool LeanState::clearly_unsupported(const Triangle& t, const std::vector<int>& points) const {
  constexpr double margin = 1e-6, thin = 1e-8;
  const Point& a = point(t[0]);
  const Double3 u = approximate_difference(point(t[1]), a), w = approximate_difference(point(t[2]), a), n = cross(u, w);
  const double uu = dot(u, u), ww = dot(w, w), nn = dot(n, n);
  if (!(nn > thin * uu * ww)) return false;
  const Double3 z = (uu / (2 * nn)) * cross(w, n) + (ww / (2 * nn)) * cross(n, u);
  const double size = std::sqrt(nn);
  // Spheres of the pencil have their centres at z + t n/|n|, for t between these.
  double low = -1e300, high = 1e300;
  for (int id : points) {
    if (!alive_[id] || id == t[0] || id == t[1] || id == t[2]) continue;
    const Double3 d = approximate_difference(point(id), a);
    const double square = dot(d, d), power = square - 2 * dot(z, d), height = dot(n, d) / size;
    if (height * height < margin * margin * square) {
      if (power < -margin * (square + length(z) * std::sqrt(square))) return true;
    } else if (height > 0) {
      high = std::min(high, power / (2 * height));
    } else {
      low = std::max(low, power / (2 * height));
    }
  }
  if (low == -1e300 || high == 1e300) return false;
  return low > high + margin * (length(z) + std::abs(low) + std::abs(high));
}

std::optional<LeanState::Hovering> LeanState::hovering(const Triangle& t) const {
  // Lower than this part of the radius, and farther than that from the corners.
  constexpr double low = 0.1, far = 0.3;
  const Point& a = point(t[0]);
  const Double3 u = approximate_difference(point(t[1]), a), w = approximate_difference(point(t[2]), a), n = cross(u, w);
  const double nn = dot(n, n), size = std::sqrt(nn);
  const Double3 z = (dot(u, u) / (2 * nn)) * cross(w, n) + (dot(w, w) / (2 * nn)) * cross(n, u);
  const double radius = length(z);
  std::vector<int> around;
  for (int id : t) {
    const auto more = tetrahedra_.neighbours(id);
    around.insert(around.end(), more.begin(), more.end());
  }
  std::sort(around.begin(), around.end());
  around.erase(std::unique(around.begin(), around.end()), around.end());
  // The points that bound the pencil from either side.
  struct Bound {
    double parameter = 1e300, height = 0;
    Double3 foot{};
  } bounds[2];
  for (int id : around) {
    if (id == t[0] || id == t[1] || id == t[2]) continue;
    const Double3 d = approximate_difference(point(id), a);
    const double height = dot(n, d) / size;
    if (height == 0) continue;
    const double parameter = (dot(d, d) - 2 * dot(z, d)) / (2 * std::abs(height));
    Bound& bound = bounds[height > 0 ? 0 : 1];
    if (parameter < bound.parameter) bound = {parameter, std::abs(height), d - (height / size) * n};
  }
  std::optional<Hovering> result;
  for (const Bound& bound : bounds) {
    if (bound.parameter >= 0 || bound.height > low * radius || (result && result->height <= bound.height)) continue;
    const double least = std::min({length(bound.foot), length(bound.foot - u), length(bound.foot - w)});
    if (least >= far * radius) result = Hovering{bound.foot, bound.height};
  }
  return result;
}

double LeanState::circumradius(const Triangle& t) const {
  const double x = distance(t[0], t[1]), y = distance(t[1], t[2]), z = distance(t[2], t[0]);
  const double area = std::sqrt(std::max(0.0, (x + y + z) * (-x + y + z) * (x - y + z) * (x + y - z)));
  return area > 0 ? x * y * z / area : 1e300;
}

}  // namespace confidel
