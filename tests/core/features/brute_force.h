// SPDX-License-Identifier: GPL-3.0-or-later
// The definitions of features.h, word by word, over all pairs and in exact rationals. Shares no code with
// core/features.
#pragma once

#include <gmpxx.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <set>
#include <vector>

#include "core/complex/complex.h"

namespace confidel::brute_force {

using Rational = mpq_class;
using Position = std::array<Rational, 3>;

inline Position minus(const Position& a, const Position& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
inline Rational product(const Position& a, const Position& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
inline Position multiple(const Rational& factor, const Position& a) {
  return {factor * a[0], factor * a[1], factor * a[2]};
}

inline Rational power_of_two(int exponent) {
  Rational one = 1;
  if (exponent >= 0) mpq_mul_2exp(one.get_mpq_t(), one.get_mpq_t(), exponent);
  if (exponent < 0) mpq_div_2exp(one.get_mpq_t(), one.get_mpq_t(), -exponent);
  return one;
}

inline Position position(const Point& point) {
  const Rational unit = power_of_two(-point.exponent());
  return {unit * point.numerator(0), unit * point.numerator(1), unit * point.numerator(2)};
}

/// Solves the symmetric system; nothing if it is singular.
inline std::optional<std::vector<Rational>> solve(std::vector<std::vector<Rational>> matrix,
                                                  std::vector<Rational> right) {
  const std::size_t n = right.size();
  for (std::size_t i = 0; i < n; ++i) {
    std::size_t pivot = i;
    while (pivot < n && matrix[pivot][i] == 0) ++pivot;
    if (pivot == n) return std::nullopt;
    std::swap(matrix[i], matrix[pivot]);
    std::swap(right[i], right[pivot]);
    for (std::size_t j = 0; j < n; ++j) {
      if (j == i) continue;
      const Rational factor = matrix[j][i] / matrix[i][i];
      for (std::size_t k = i; k < n; ++k) matrix[j][k] -= factor * matrix[i][k];
      right[j] -= factor * right[i];
    }
  }
  for (std::size_t i = 0; i < n; ++i) right[i] /= matrix[i][i];
  return right;
}

/// Squared distance of two simplices: the least one over all pairs of faces whose affine hulls come nearest inside
/// both. Pairs of parallel hulls are left out, smaller faces attain their distance.
inline Rational squared_distance(const std::vector<Position>& a, const std::vector<Position>& b) {
  std::optional<Rational> least;
  for (unsigned face_a = 1; face_a < 1U << a.size(); ++face_a) {
    for (unsigned face_b = 1; face_b < 1U << b.size(); ++face_b) {
      std::vector<Position> x, y, directions;
      for (std::size_t i = 0; i < a.size(); ++i) {
        if (face_a >> i & 1U) x.push_back(a[i]);
      }
      for (std::size_t i = 0; i < b.size(); ++i) {
        if (face_b >> i & 1U) y.push_back(b[i]);
      }
      // y0 - x0 + sum of parameter * direction has to be orthogonal to all directions.
      for (std::size_t i = 1; i < x.size(); ++i) directions.push_back(minus(x[0], x[i]));
      for (std::size_t i = 1; i < y.size(); ++i) directions.push_back(minus(y[i], y[0]));
      Position gap = minus(y[0], x[0]);
      std::vector<std::vector<Rational>> matrix;
      std::vector<Rational> right;
      for (const auto& row : directions) {
        auto& entries = matrix.emplace_back();
        for (const auto& column : directions) entries.push_back(product(row, column));
        right.push_back(-product(row, gap));
      }
      const auto parameters = solve(matrix, right);
      if (!parameters) continue;
      bool inside = true;
      Rational sum_x = 0;
      Rational sum_y = 0;
      for (std::size_t i = 0; i < directions.size(); ++i) {
        const Rational& parameter = (*parameters)[i];
        inside = inside && parameter >= 0;
        (i + 1 < x.size() ? sum_x : sum_y) += parameter;
        const Position step = multiple(parameter, directions[i]);
        for (int k = 0; k < 3; ++k) gap[k] += step[k];
      }
      if (!inside || sum_x > 1 || sum_y > 1) continue;
      const Rational squared = product(gap, gap);
      if (!least || squared < *least) least = squared;
    }
  }
  return *least;
}

/// Angles to about 1e-18 relative: the tangent of the half angle is |cross| / (|a||b| + dot), in 400 bits.
inline long double angle(const Position& a, const Position& b) {
  const mpf_class aa(product(a, a), 400), bb(product(b, b), 400), ab(product(a, b), 400);
  const Rational squared_sine = product(a, a) * product(b, b) - product(a, b) * product(a, b);
  if (squared_sine == 0) return ab > 0 ? 0 : std::numbers::pi_v<long double>;
  const mpf_class lengths = sqrt(mpf_class(aa * bb));
  // Without cancellation: (lengths - ab) = sine^2 / (lengths + ab).
  const mpf_class sine = sqrt(mpf_class(squared_sine, 400));
  const mpf_class tangent = ab >= 0 ? mpf_class(sine / (lengths + ab)) : mpf_class((lengths - ab) / sine);
  long exponent = 0;
  const double high = mpf_get_d_2exp(&exponent, tangent.get_mpf_t());
  mpf_class scaled = tangent;
  if (exponent >= 0) mpf_div_2exp(scaled.get_mpf_t(), tangent.get_mpf_t(), exponent);
  if (exponent < 0) mpf_mul_2exp(scaled.get_mpf_t(), tangent.get_mpf_t(), -exponent);
  const mpf_class rest = scaled - high;
  return 2 * std::atan(std::ldexp(static_cast<long double>(high) + rest.get_d(), static_cast<int>(exponent)));
}

inline long double sector_angle(const Position& direction, const Position& b, const Position& c) {
  const auto shadow = solve({{product(b, b), product(b, c)}, {product(b, c), product(c, c)}},
                            {product(b, direction), product(c, direction)});
  if ((*shadow)[0] < 0 || (*shadow)[1] < 0) return std::min(angle(direction, b), angle(direction, c));
  Position foot;
  for (int k = 0; k < 3; ++k) foot[k] = (*shadow)[0] * b[k] + (*shadow)[1] * c[k];
  if (product(foot, foot) == 0) return std::numbers::pi_v<long double> / 2;
  return angle(direction, foot);
}

struct Features {
  /// Squared; -1 stands for infinity.
  std::vector<Rational> vertex_distance, segment_distance;
  std::vector<std::array<long double, 2>> segment_angle, facet_angle;
  std::vector<long double> dihedral_angle;
};

inline Features compute(const Complex& complex) {
  std::vector<Position> at;
  for (const Point& vertex : complex.vertices) at.push_back(position(vertex));
  const int vertices = static_cast<int>(at.size());
  std::vector<std::set<VertexId>> facet_vertices;
  std::vector<std::set<Segment>> facet_segments;
  for (const Facet& facet : complex.facets) {
    auto& corners = facet_vertices.emplace_back(facet.isolated.begin(), facet.isolated.end());
    auto& segments = facet_segments.emplace_back();
    for (const auto* edges : {&facet.boundary, &facet.constraints}) {
      for (const auto& edge : *edges) {
        corners.insert(edge.begin(), edge.end());
        segments.insert({std::min(edge[0], edge[1]), std::max(edge[0], edge[1])});
      }
    }
  }
  const auto improve = [](Rational& least, const Rational& squared) {
    if (least < 0 || squared < least) least = squared;
  };
  const auto corners_of = [&](const std::array<VertexId, 3>& t) {
    return std::vector<Position>{at[t[0]], at[t[1]], at[t[2]]};
  };
  Features features;
  for (VertexId v = 0; v < vertices; ++v) {
    Rational least = -1;
    for (VertexId w = 0; w < vertices; ++w) {
      if (w != v) improve(least, squared_distance({at[v]}, {at[w]}));
    }
    for (const auto& [a, b] : complex.segments) {
      if (a != v && b != v) improve(least, squared_distance({at[v]}, {at[a], at[b]}));
    }
    for (std::size_t f = 0; f < complex.facets.size(); ++f) {
      if (facet_vertices[f].count(v) > 0) continue;
      for (const auto& triangle : complex.facets[f].triangles)
        improve(least, squared_distance({at[v]}, corners_of(triangle)));
    }
    features.vertex_distance.push_back(least);
  }
  for (const Segment& e : complex.segments) {
    const std::vector<Position> ends{at[e[0]], at[e[1]]};
    const auto meets = [&](VertexId v) { return v == e[0] || v == e[1]; };
    Rational least = -1;
    for (VertexId v = 0; v < vertices; ++v) {
      if (!meets(v)) improve(least, squared_distance(ends, {at[v]}));
    }
    for (const auto& [a, b] : complex.segments) {
      if (!meets(a) && !meets(b)) improve(least, squared_distance(ends, {at[a], at[b]}));
    }
    std::vector<Position> sheets;
    std::array<long double, 2> theta, omega;
    theta.fill(std::numbers::pi_v<long double>);
    omega = theta;
    for (std::size_t f = 0; f < complex.facets.size(); ++f) {
      const bool contains = facet_segments[f].count(e) > 0;
      for (const auto& triangle : complex.facets[f].triangles) {
        const auto met = std::count_if(triangle.begin(), triangle.end(), meets);
        if (met == 2 && contains) {
          sheets.push_back(at[*std::find_if_not(triangle.begin(), triangle.end(), meets)]);
        }
        if (met == 0 && !contains) improve(least, squared_distance(ends, corners_of(triangle)));
        for (int side = 0; side < 2 && !contains; ++side) {
          std::vector<Position> rays;
          for (const VertexId corner : triangle) {
            if (corner != e[side]) rays.push_back(minus(at[corner], at[e[side]]));
          }
          if (rays.size() != 2) continue;
          omega[side] = std::min(omega[side], sector_angle(minus(at[e[1 - side]], at[e[side]]), rays[0], rays[1]));
        }
      }
    }
    for (const Segment& other : complex.segments) {
      for (int side = 0; side < 2 && other != e; ++side) {
        const VertexId v = e[side];
        if (other[0] != v && other[1] != v) continue;
        const VertexId end = other[0] == v ? other[1] : other[0];
        theta[side] = std::min(theta[side], angle(minus(at[e[1 - side]], at[v]), minus(at[end], at[v])));
      }
    }
    long double alpha = std::numbers::pi_v<long double>;
    const Position along = minus(ends[1], ends[0]);
    for (auto& sheet : sheets) {
      const Position from = minus(sheet, ends[0]);
      sheet = minus(from, multiple(product(from, along) / product(along, along), along));
    }
    for (std::size_t i = 0; i < sheets.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) alpha = std::min(alpha, angle(sheets[i], sheets[j]));
    }
    features.segment_distance.push_back(least);
    features.segment_angle.push_back(theta);
    features.facet_angle.push_back(omega);
    features.dihedral_angle.push_back(alpha);
  }
  return features;
}

}  // namespace confidel::brute_force
