// SPDX-License-Identifier: GPL-3.0-or-later
// L9, L10, L11, L13, L16, L18 and L18b: which points a cell's sphere may not contain. P(x) >= 0, and > 0 off the cell's plane.
#include <algorithm>
#include <unordered_map>

#include "proofs/lemmas/rational_geometry.h"
#include "proofs/lemmas/space.h"
#include "proofs/lemmas/statements.h"

namespace confidel::statements {
namespace {

/// One cell against the points of an index. `skipped`: a point that is no matter. off_plane_only: slack of points off the plane only.
/// Returns the first point (by id) that violates, or -1.
int test_cell(const Space& space, const PointIndex& index, int cell, int skipped, bool off_plane_only, Tally& tally, double reach = 1e300) {
  const Instance& instance = space.instance();
  const Sphere sphere(space, cell);
  const FacetId facet = instance.cells[cell].facet;
  int worst = -1;
  sphere.visit(index, std::clamp(tally.smallest(), 0.0, reach), [&](int id) {
    if (id == skipped) return;
    bool clear = false;
    const int sign = sphere.sign(id, tally.smallest(), clear);
    if (clear) return;
    const bool off_plane = (sign == 0 || off_plane_only) && !instance.in_plane(id, facet);
    if ((sign < 0 || (sign == 0 && off_plane)) && (worst < 0 || id < worst)) worst = id;
    if (off_plane_only ? off_plane : sign != 0)
      tally.slack(sphere.power(id) / sphere.squared_radius(), line_of(instance.lines.cells, cell), [&] { return cell_and_point(cell, id); });
  });
  return worst;
}

void report(const Instance& instance, int cell, int point, Tally& tally) {
  if (point >= 0) tally.fail(line_of(instance.lines.cells, cell), cell_and_point(cell, point));
}

bool any(int) { return true; }

/// Is there any point off the plane of any facet? (All vertices in one plane: then all is in it.)
bool spatial(const Instance& instance) {
  if (instance.dimension == 2 || instance.facets.empty()) return false;
  for (int v = 0; v < instance.vertex_count; ++v)
    if (!instance.in_plane(v, 0)) return true;
  return false;
}

}  // namespace

void end_cells_empty(const Instance& instance, Tally& tally) {
  const Space space(instance);
  const PointIndex all = space.index(any);
  for (const EndCell& end : instance.end_cells) report(instance, end.cell, test_cell(space, all, end.cell, -1, false, tally), tally);
}

void spokes_and_caps(const Instance& instance, Tally& tally) {
  const Space space(instance);
  std::unordered_map<int, PointIndex> caps;  // by vertex
  std::unordered_map<int, std::vector<int>> seen;
  for (const EndCell& end : instance.end_cells) {
    auto& list = seen[end.v];
    if (std::find(list.begin(), list.end(), end.m) != list.end()) continue;
    list.push_back(end.m);
    caps.try_emplace(end.v, space.empty_index()).first->second.insert(end.m, space.approximate(end.m));
  }
  for (const SpokeCell& spoke : instance.spoke_cells)
    if (const auto found = caps.find(spoke.v); found != caps.end())
      report(instance, spoke.cell, test_cell(space, found->second, spoke.cell, -1, false, tally), tally);
}

void spokes_and_arcs(const Instance& instance, Tally& tally) {
  const Space space(instance);
  const PointIndex protecting = space.index([&](int id) { return instance.protects(id); });
  for (const SpokeCell& spoke : instance.spoke_cells) report(instance, spoke.cell, test_cell(space, protecting, spoke.cell, -1, false, tally), tally);
}

void boxes_empty(const Instance& instance, Tally& tally) {
  const Space space(instance);
  const PointIndex all = space.index(any);
  for (const BoxCells& box : instance.boxes)
    for (const int cell : box.cells) {
      int fourth = -1;
      for (const int corner : box.corners) {
        const auto& own = instance.cells[cell].corners;
        if (std::find(own.begin(), own.end(), corner) == own.end()) fourth = corner;
      }
      report(instance, cell, test_cell(space, all, cell, fourth, false, tally), tally);
    }
}

void other_cells_empty(const Instance& instance, Tally& tally) {
  const Space space(instance);
  const PointIndex all = space.index(any);
  const bool bounded = instance.parameters.spacing.has_value();
  if (instance.parameters.radius && !bounded) throw MissingParameter("h");
  for (std::size_t c = 0; c < instance.cells.size(); ++c) {
    if (instance.cells[c].kind != CellKind::C) continue;
    const int cell = static_cast<int>(c);
    const int point = test_cell(space, all, cell, -1, false, tally);
    bool small = true;
    if (bounded) {
      const Sphere sphere(space, cell);
      const mpq_class ratio = 289 * square(*instance.parameters.spacing) / (256 * sphere.squared_radius());
      small = ratio >= 1;
      tally.slack(mpq_class(ratio - 1), line_of(instance.lines.cells, cell), [&] { return cell_name(cell); });
    }
    if (point >= 0)
      report(instance, cell, point, tally);
    else if (!small)
      tally.fail(line_of(instance.lines.cells, cell), cell_name(cell));
  }
}

void emptiness(const Instance& instance, Tally& tally) {
  const Space space(instance);
  const PointIndex all = space.index(any);
  const double reach = spatial(instance) ? 1e300 : 0;
  for (std::size_t c = 0; c < instance.cells.size(); ++c)
    report(instance, static_cast<int>(c), test_cell(space, all, static_cast<int>(c), -1, true, tally, reach), tally);
}

void ties(const Instance& instance, Tally& tally) {
  const Space space(instance);
  const PointIndex all = space.index(any);
  for (std::size_t c = 0; c < instance.cells.size(); ++c) {
    const PlacedCell& cell = instance.cells[c];
    // An edge that lies on a segment of the facet: at most a few cells have one.
    std::vector<std::array<int, 2>> constrained;
    for (int k = 0; k < 3; ++k) {
      const int p = cell.corners[k], q = cell.corners[(k + 1) % 3];
      SegmentId segment = -1;
      if (instance.on_segment_kind(p))
        segment = instance.carriers[p];
      else if (instance.on_segment_kind(q))
        segment = instance.carriers[q];
      else if (p < instance.vertex_count && q < instance.vertex_count)
        segment = instance.find_segment(p, q);
      if (segment >= 0 && instance.lies_on(p, segment) && instance.lies_on(q, segment) && instance.on_boundary_or_constraint(cell.facet, segment)) constrained.push_back({p, q});
    }
    if (constrained.empty()) continue;
    const Sphere sphere(space, static_cast<int>(c));
    int beyond = -1;
    sphere.visit(all, 0, [&](int id) {
      bool clear = false;
      if (sphere.sign(id, 0, clear) != 0 || !instance.in_plane(id, cell.facet)) return;
      for (const auto& [p, q] : constrained) {
        const RationalVector along = minus(instance.positions[q], instance.positions[p]), x = minus(instance.positions[id], instance.positions[p]);
        if (dot(instance.normal(cell.facet), cross(along, x)) < 0 && (beyond < 0 || id < beyond)) beyond = id;
      }
    });
    report(instance, static_cast<int>(c), beyond, tally);
  }
}

}  // namespace confidel::statements
