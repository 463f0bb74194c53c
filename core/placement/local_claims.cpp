// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/placement/local_claims.h"

#include <algorithm>
#include <numbers>

#include "core/numbers/angle.h"

namespace confidel {
namespace {

constexpr int radius_bits = 40, offset_bits = 40;
// An offset is claimed a little smaller than it was chosen, so that rounded cosines leave room: far within the 1/32 that H-offset allows.
constexpr double claimed_offset = 1 - 0x1p-16;

/// Kinds are as H-ball and the lemmas on T, S, R and C cells need them: a vertex that is isolated in a facet and has no ball is a corner of
/// C cells, about which they say nothing.
bool protects_everything(const Placement& placement) {
  return std::none_of(placement.cells.begin(), placement.cells.end(), [&](const PlacedCell& cell) {
    return cell.kind == CellKind::C &&
           std::any_of(cell.corners.begin(), cell.corners.end(), [&](int corner) { return placement.points[corner].kind == PointKind::vertex; });
  });
}

}  // namespace

void claim_conformity(Placement& placement) { placement.claims = {"L18", "L18b", "L19", "L22"}; }

void claim_local(const Complex& complex, const Features& features, const BufferSizes& sizes, Placement& placement) {
  std::vector<char> ball(complex.vertices.size(), 0), row(complex.segments.size(), 0);
  for (const PlacedCell& cell : placement.cells) {
    if (cell.kind != CellKind::T && cell.kind != CellKind::S) continue;
    for (const int corner : cell.corners) {
      const PlacedPoint& point = placement.points[corner];
      if (point.kind == PointKind::vertex) ball[corner] = 1;
      if (point.kind == PointKind::projection) row[point.carrier] = 1;
    }
  }
  Parameters& parameters = placement.parameters;
  for (std::size_t v = 0; v < ball.size(); ++v)
    if (ball[v]) parameters.balls.push_back({static_cast<VertexId>(v), times_power_of_two(rounded_down(sizes.radius[v], radius_bits), complex.scale)});
  for (std::size_t s = 0; s < row.size(); ++s) {
    if (!row[s]) continue;
    Parameters::Row claimed;
    claimed.segment = static_cast<SegmentId>(s);
    claimed.offset = times_power_of_two(rounded_down(sizes.offset[s] * claimed_offset, offset_bits), complex.scale);
    for (int end = 0; end < 2; ++end) {
      // graded_sizes: at most r sin(min(theta/3, 0.7 omega, pi/6)). Three times the first angle, and ten times the second, stay below pi.
      claimed.edge_cosine[end] = witness_of_angle(std::min(features.segment_angle[s][end] / 3, std::numbers::pi / 6));
      claimed.facet_cosine[end] = witness_of_angle(std::min(features.facet_angle[s][end] / 10, std::numbers::pi / 42));
    }
    parameters.rows.push_back(std::move(claimed));
  }

  const bool kinds = protects_everything(placement), balls = !parameters.balls.empty(), rows = !parameters.rows.empty();
  auto& claims = placement.claims;
  claims.clear();
  if (kinds) {
    if (balls) claims.push_back("H-ball");
    if (balls && rows) claims.push_back("H-offset");
    claims.insert(claims.end(), {"L5", "L7", "L9", "L10", "L11", "L12", "L13", "L16", "L17"});
  }
  claims.insert(claims.end(), {"L18", "L18b", "L19"});
  if (balls && rows) claims.push_back("L21");
  claims.push_back("L22");
}

}  // namespace confidel
