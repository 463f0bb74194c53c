// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/placement/saalfeld.h"

#include <algorithm>
#include <cmath>

#include "core/placement/planar_cells.h"
#include "core/planar/frame.h"

namespace confidel {

Placement place_saalfeld(const Complex& complex, const Features& features, const Limits& limits, Progress& progress) {
  Placement placement;
  for (const Point& vertex : complex.vertices) placement.points.push_back({vertex, PointKind::vertex, -1});
  double delta = INFINITY, phi = 3;
  for (const double distance : features.vertex_distance) delta = std::min(delta, distance);
  for (const double distance : features.segment_distance) delta = std::min(delta, distance);
  for (const auto& ends : features.segment_angle) phi = std::min({phi, ends[0], ends[1]});
  const double radius = std::min(1.0, delta / 3);
  // Two edges at a vertex are nearest where they leave its disk; every other pair is farther apart than the radius.
  const double distance = std::min(radius, 2 * radius * std::sin(phi / 2));
  const double greatest_piece = 2 * distance * (1 - 0x1p-10);

  double total = static_cast<double>(complex.vertices.size());
  for (const auto& [a, b] : complex.segments) total += 2 + length(approximate_difference(complex.vertices[b], complex.vertices[a])) / greatest_piece;
  progress.estimated(total);
  if (limits.max_points > 0 && total > 1.1 * static_cast<double>(limits.max_points))
    throw LimitReached("max-points", static_cast<long>(complex.vertices.size()));

  std::vector<std::vector<int>> chains;
  for (SegmentId s = 0; s < static_cast<SegmentId>(complex.segments.size()); ++s) {
    const auto& [a, b] = complex.segments[s];
    const Point &u = complex.vertices[a], &w = complex.vertices[b];
    const double extent = length(approximate_difference(w, u));
    PlacedRow row{s, {}, {}};
    const auto place = [&](const Dyadic& t, PointKind kind) {
      row.points.push_back(static_cast<int>(placement.points.size()));
      placement.points.push_back({along(u, w, t), kind, s});
      const long count = row.points.back() + 1;
      if (limits.max_points > 0 && count > limits.max_points) throw LimitReached("max-points", count);
      if ((count & 1023) == 0) {
        progress.at("placing points", count);
        if (progress.stop_requested(count)) throw LimitReached("stopped", count);
      }
    };
    // Points of one disk must be equally far to within 1 - cos(phi), lest one lies in another's first circle.
    const double disk_tolerance = radius * std::min(0x1p-12, phi * phi / 64) / extent;
    const Dyadic first = round_to(radius / extent, disk_tolerance);
    Dyadic last = first;  // 1 - t
    mpz_class one = 1;
    if (first.exponent >= 0) one <<= first.exponent;
    last.numerator = one - first.numerator;
    place(first, PointKind::projection);
    const double begin = first.approximate(), rest = 1 - 2 * begin;
    const long pieces = std::max(1L, static_cast<long>(std::ceil(rest * extent / greatest_piece * (1 + 0x1p-8))));
    for (long i = 1; i < pieces; ++i)
      place(round_to(begin + static_cast<long double>(rest) * i / pieces, greatest_piece / extent * 0x1p-12), PointKind::edge);
    place(last, PointKind::projection);
    std::vector<int> chain{a};
    chain.insert(chain.end(), row.points.begin(), row.points.end());
    chain.push_back(b);
    chains.push_back(std::move(chain));
    placement.rows.push_back(std::move(row));
  }

  add_planar_cells(complex, chains, placement);
  placement.claims = {"L18", "L18b", "L19", "L22"};
  return placement;
}

}  // namespace confidel
