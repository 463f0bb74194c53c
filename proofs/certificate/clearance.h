// SPDX-License-Identifier: GPL-3.0-or-later
// How far the points of a certificate are from the spheres of its cells: exact, for pictures and reports. It is no verdict.
#pragma once

#include <gmpxx.h>

#include <array>
#include <functional>
#include <vector>

#include "proofs/certificate/reader.h"

namespace confidel {

/// The point of smallest power with respect to a sphere, and P(x)/R^2: certificate-format.md section 3. Exact.
struct Nearest {
  int point = -1;  ///< -1: there is none
  mpq_class relative_power;
};

struct CellClearance {
  /// The sphere in doubles, for drawing: nearest doubles of the exact values, up to a few units in the last place.
  std::array<double, 3> centre{};
  double radius = 0;
  /// Over all points but the corners, and but the fourth corner of a box if that lies exactly on the sphere. Of several the smallest id.
  Nearest all;
  /// Over the points off the facet's plane; none in dimension 2.
  Nearest off_plane;
  /// Corners that are collinear have no sphere, and one above 1e150 is beyond what doubles can search; the rest is then empty.
  bool degenerate = false;

  /// A point lies inside, or on the sphere and off the plane: what the rule `emptiness` forbids.
  bool violated() const {
    return (all.point >= 0 && all.relative_power < 0) || (off_plane.point >= 0 && off_plane.relative_power <= 0);
  }
};

/// The nearest doubles to all points.
std::vector<std::array<double, 3>> approximate_positions(const Certificate& certificate);

/// One entry per cell. Runs on all threads that TBB has; the result does not depend on them. `stop` is asked now and then, from any thread; when
/// it says true, the rest of the entries is left empty.
std::vector<CellClearance> clearances(const Certificate& certificate, const std::vector<std::array<double, 3>>& positions,
                                      const std::function<bool()>& stop);

}  // namespace confidel
