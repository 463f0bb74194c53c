// SPDX-License-Identifier: GPL-3.0-or-later
#include "proofs/lemmas/counts.h"

#include <algorithm>


namespace confidel::counts {
namespace {

long of_kind(const Instance& instance, CellKind kind) {
  return std::count_if(instance.cells.begin(), instance.cells.end(), [&](const PlacedCell& cell) { return cell.kind == kind; });
}

}  // namespace

long one(const Instance&) { return 1; }
long segment_ends(const Instance& instance) { return 2 * static_cast<long>(instance.segments.size()); }
long end_cells(const Instance& instance) { return of_kind(instance, CellKind::T); }
long opening_end_cells(const Instance& instance) {
  return std::count_if(instance.end_cells.begin(), instance.end_cells.end(), [](const EndCell& cell) { return cell.opens; });
}
long spoke_cells(const Instance& instance) { return of_kind(instance, CellKind::S); }
long end_and_spoke_cells(const Instance& instance) { return end_cells(instance) + spoke_cells(instance); }
long boxes(const Instance& instance) { return box_cells(instance) / 2; }
long box_cells(const Instance& instance) { return of_kind(instance, CellKind::R); }
long other_cells(const Instance& instance) { return of_kind(instance, CellKind::C); }
long cells(const Instance& instance) { return static_cast<long>(instance.cells.size()); }

long protecting_points(const Instance& instance) {
  return std::count_if(instance.kinds.begin(), instance.kinds.end(), [](PointKind kind) { return kind == PointKind::arc || kind == PointKind::offset; });
}

long interior_points(const Instance& instance) { return std::count(instance.kinds.begin(), instance.kinds.end(), PointKind::interior); }

long protectors_off_plane(const Instance& instance) {
  long count = 0;
  for (const PlacedRow& row : instance.rows)
    for (const auto& first : row.protectors)
      for (const auto& second : row.protectors) count += !instance.coplanar(first.facet, second.facet);
  return count;
}

long protector_pairs(const Instance& instance) {
  long count = 0;
  for (const PlacedRow& row : instance.rows) {
    const long protectors = static_cast<long>(row.protectors.size());
    count += protectors * (protectors - 1) / 2;
  }
  return count;
}

long tilts(const Instance& instance) {
  if (instance.dimension == 2) return 0;
  long count = 0;
  for (VertexId v = 0; v < instance.vertex_count; ++v)
    for (const SegmentId segment : instance.segments_at(v))
      for (const FacetId facet : instance.facets_at(v)) count += !instance.on_boundary_or_constraint(facet, segment);
  return count;
}

long outline_edges(const Instance& instance) { return static_cast<long>(instance.outline.size()); }
long facets(const Instance& instance) { return static_cast<long>(instance.facets.size()); }
long vertices_and_segments(const Instance& instance) { return instance.vertex_count + static_cast<long>(instance.segments.size()); }
long hanging_subsegments(const Instance& instance) { return static_cast<long>(instance.hanging.size()); }

}  // namespace confidel::counts
