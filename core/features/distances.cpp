// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/features/distances.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/features/vector.h"

namespace confidel {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
/// Two bounds this close decide a distance: half of the promised relative accuracy.
constexpr double accepted_ratio = 1 + 5e-10;
/// Squares below this may have lost digits to underflow.
constexpr double tiny_square = 1e-200;

/// A guess of the shortest way from a to b. gap leads from a point of a to a point of b, up to rounding; if the way
/// ends inside both of two crossing segments or inside the triangle, normal is orthogonal to them, hence a more
/// accurate direction.
struct Approach {
  Vector gap{};
  Vector normal{};
  bool has_normal = false;
  double squared = infinity;

  void improve(const Vector& other) {
    const double other_squared = dot(other, other);
    if (!(other_squared < squared)) return;
    *this = {other, {}, false, other_squared};
  }
  void improve(const Vector& other, const Vector& other_normal) {
    const double other_squared = dot(other, other);
    if (!(other_squared < squared)) return;
    *this = {other, dot(other_normal, other) < 0 ? -1.0 * other_normal : other_normal, true, other_squared};
  }
  void improve(const Approach& other) {
    if (other.squared < squared) *this = other;
  }
};

/// From the origin to the segment; both ends relative to it.
Approach approach_segment(const Vector& a, const Vector& b) {
  Approach approach;
  const Vector along = b - a;
  const double squared_length = dot(along, along);
  const double projection = -dot(a, along);
  if (!(projection > 0)) {
    approach.improve(a);
  } else if (!(projection < squared_length)) {
    approach.improve(b);
  } else {
    approach.improve(a + projection / squared_length * along);
  }
  return approach;
}

/// From the origin to the triangle.
Approach approach_triangle(const Vector& a, const Vector& b, const Vector& c) {
  Approach approach;
  const Vector u = b - a;
  const Vector v = c - a;
  const Vector normal = cross(u, v);
  const double squared_normal = dot(normal, normal);
  const double s = dot(cross(v, a), normal) / squared_normal;
  const double t = dot(cross(a, u), normal) / squared_normal;
  if (s >= 0 && t >= 0 && s + t <= 1) {
    approach.improve(a + s * u + t * v, normal);
    return approach;
  }
  approach.improve(approach_segment(a, b));
  approach.improve(approach_segment(b, c));
  approach.improve(approach_segment(c, a));
  return approach;
}

/// Between segments pq and ab, given by the four differences from the first to the second.
Approach approach_segments(const Vector& pa, const Vector& pb, const Vector& qa, const Vector& qb) {
  const Vector u = pa - qa;
  const Vector v = pb - pa;
  const Vector normal = cross(u, v);
  const double squared_normal = dot(normal, normal);
  // p + s u and a + t v are nearest: pa = s u - t v + a multiple of the normal.
  const double s = dot(cross(pa, v), normal) / squared_normal;
  const double t = dot(cross(pa, u), normal) / squared_normal;
  Approach approach;
  if (s >= 0 && s <= 1 && t >= 0 && t <= 1) approach.improve(pa + t * v - s * u, normal);
  approach.improve(approach_segment(pa, pb));
  approach.improve(approach_segment(qa, qb));
  approach.improve(approach_segment(pa, qa));
  approach.improve(approach_segment(pb, qb));
  return approach;
}

/// The differences b[j] - a[i]: every component has a relative error of at most u.
struct Differences {
  Differences(Simplex from, Simplex to) : rows(from.size()), columns(to.size()) {
    for (std::size_t i = 0; i < rows; ++i) {
      for (std::size_t j = 0; j < columns; ++j) {
        at[i][j] = to[j]->position - from[i]->position;
        greatest = std::max(greatest, sum_of_magnitudes(at[i][j]));
      }
    }
  }
  std::array<std::array<Vector, 3>, 2> at;
  std::size_t rows;
  std::size_t columns;
  double greatest = 0;
};

Approach approach_row(const std::array<Vector, 3>& to, std::size_t columns) {
  if (columns == 3) return approach_triangle(to[0], to[1], to[2]);
  if (columns == 2) return approach_segment(to[0], to[1]);
  Approach approach;
  approach.improve(to[0]);
  return approach;
}

Approach approach_simplices(const Differences& differences) {
  const auto& at = differences.at;
  const std::size_t columns = differences.columns;
  if (differences.rows == 1) return approach_row(at[0], columns);
  if (columns == 1) return approach_segment(at[0][0], at[1][0]);
  if (columns == 2) return approach_segments(at[0][0], at[0][1], at[1][0], at[1][1]);
  // Disjoint: an end is nearest to the triangle, or a side of the triangle is nearest to the segment.
  Approach approach = approach_row(at[0], 3);
  approach.improve(approach_row(at[1], 3));
  for (int j = 0; j < 3; ++j) {
    const int k = (j + 1) % 3;
    approach.improve(approach_segments(at[0][j], at[0][k], at[1][j], at[1][k]));
  }
  return approach;
}

/// Whatever the direction w is: |b - a| >= w.(b - a) / |w| for all a and b of the two convex sets, and the corners
/// attain the minimum of the right side. So rounding in the guess of w makes this bound weaker, never wrong. Rounding
/// here: a product sum has an error of at most 4.01 u (with the difference's own) times the sum of magnitudes, |w| one
/// of 3.01 u, the last two operations 2 u; underflow is negligible because |w|^2 and the bound's square exceed 1e-200.
double separation(const Differences& differences, const Vector& w) {
  const double squared = dot(w, w);
  if (!(squared > tiny_square)) return 0;
  double least = infinity;
  double least_reversed = infinity;
  for (std::size_t i = 0; i < differences.rows; ++i) {
    for (std::size_t j = 0; j < differences.columns; ++j) {
      const double x = w[0] * differences.at[i][j][0];
      const double y = w[1] * differences.at[i][j][1];
      const double z = w[2] * differences.at[i][j][2];
      const double sum = x + y + z;
      const double error = 0x1p-50 * (std::abs(x) + std::abs(y) + std::abs(z));
      least = std::min(least, sum - error);
      least_reversed = std::min(least_reversed, -sum - error);
    }
  }
  least = std::max(least, least_reversed);
  if (!(least > tiny_square)) return 0;
  return least / std::sqrt(squared) * (1 - 0x1p-49);
}

}  // namespace

Corner::Corner(const Point& vertex)
    : point(&vertex),
      position(vertex.approximate()),
      exact(Point::from_doubles(position[0], position[1], position[2]) == vertex) {
  for (int k = 0; k < 3; ++k) {
    box.lower[k] = box.upper[k] = position[k];
    if (exact) continue;
    // The approximation is at most one unit in the last place off.
    for (int step = 0; step < 2; ++step) {
      box.lower[k] = std::nextafter(box.lower[k], -infinity);
      box.upper[k] = std::nextafter(box.upper[k], infinity);
    }
  }
}

double distance_below(Simplex a, Simplex b, double limit, Vector& direction) {
  const auto exact = [](const Corner* corner) { return corner->exact; };
  if (!std::all_of(a.begin(), a.end(), exact) || !std::all_of(b.begin(), b.end(), exact)) {
    return exact_distance_below(a, b);
  }
  const Differences differences(a, b);
  if (const double below = separation(differences, direction); below >= limit) return below;
  const Approach approach = approach_simplices(differences);
  // The gap leads from a point of a to one of b, up to the rounding of its parameters' use: at most four terms of
  // magnitude at most 2 greatest, each with an error of at most 4 u, and barycentric coordinates whose sum exceeds 1 by
  // at most u.
  const double above = std::sqrt(approach.squared) * (1 + 0x1p-50) + 0x1p-47 * differences.greatest;
  double below = separation(differences, approach.gap);
  if (above > accepted_ratio * below && approach.has_normal) {
    below = std::max(below, separation(differences, approach.normal));
  }
  if (below >= limit) return below;
  direction = approach.gap;
  if (above <= accepted_ratio * below) return below;
  return exact_distance_below(a, b);
}

}  // namespace confidel
