// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/placement/lean.h"

#include <cmath>

#include "core/placement/graded.h"
#include "core/placement/lean_refinement.h"
#include "core/placement/local_claims.h"
#include "core/placement/pencil.h"

namespace confidel {
namespace {

using Triangle = LeanState::Triangle;

// Step 14: removes what is not needed, until nothing changes. A point that was needed is asked about again only once a neighbour is gone.
void clean_up(LeanState& state) {
  const int vertices = static_cast<int>(state.complex().vertices.size());
  std::vector<char> open(state.point_count(), 1);
  std::vector<int> neighbours;
  for (bool again = true; again;) {
    again = false;
    for (int id = state.point_count() - 1; id >= vertices; --id) {
      if (!state.alive(id) || (!open[id] && !state.flat())) continue;
      state.progress().at("removing points", vertices + state.steiner());
      if (state.progress().stop_requested(state.steiner())) return;  // what stands is complete
      open[id] = 0;
      if (!state.try_remove(id, neighbours)) continue;
      again = true;
      for (int near : neighbours) open[near] = 1;
    }
  }
}

// Step 15: an offset well inside the interval of the triangle's pencil that is empty.
mpq_class offset_of(const LeanState& state, FacetId f, const Triangle& t, const Difference& normal) {
  if (state.flat()) return 0;
  auto face = state.tetrahedra().face(t[0], t[1], t[2]);
  if (!face.exists) face = state.tetrahedra().cocircular_face(t[0], t[1], t[2]);
  const Point &a = state.point(t[0]), &b = state.point(t[1]), &c = state.point(t[2]);
  std::optional<mpq_class> low, high;
  if (face.above >= 0) high = pencil_parameter(a, b, c, state.point(face.above), normal);
  if (face.below >= 0) low = pencil_parameter(a, b, c, state.point(face.below), normal);
  double size = 0;
  for (const auto& value : normal.vector) size = std::hypot(size, value.get_d());
  const mpq_class offset = choose_offset(low, high, state.circumradius(t) / std::ldexp(size, -normal.exponent));
  if ((low && offset <= *low) || (high && offset >= *high)) throw StrategyFailed("lean: a face is not strong (facet " + std::to_string(f) + ")");
  return offset;
}

Placement result(const LeanState& state) {
  const Complex& complex = state.complex();
  Placement placement;
  std::vector<int> names(state.point_count(), -1);
  for (int id = 0; id < state.point_count(); ++id) {
    if (!state.alive(id)) continue;
    names[id] = static_cast<int>(placement.points.size());
    placement.points.push_back({state.point(id), state.information(id).kind, state.information(id).carrier});
  }
  for (FacetId f = 0; f < static_cast<FacetId>(complex.facets.size()); ++f) {
    const Difference normal = certificate_normal(complex, complex.facets[f]);
    for (const Triangle& t : state.planar(f).triangles()) {
      // t n is a length: in the input's coordinates n grows by 4^scale and lengths by 2^scale.
      mpq_class offset = times_power_of_two(offset_of(state, f, t, normal), -complex.scale);
      placement.cells.push_back({f, {names[t[0]], names[t[1]], names[t[2]]}, CellKind::C, -1, offset});
    }
  }
  for (std::size_t s = 0; s < complex.segments.size(); ++s) {
    const auto& stations = state.chains()[s].stations;
    if (state.chains()[s].hanging())
      for (std::size_t i = 0; i + 1 < stations.size(); ++i)
        placement.hanging.push_back({static_cast<SegmentId>(s), names[stations[i].point], names[stations[i + 1].point]});
    if (stations.size() < 4) continue;  // a row has at least two points besides the vertices
    PlacedRow row{static_cast<SegmentId>(s), {}, {}};
    for (std::size_t i = 1; i + 1 < stations.size(); ++i) row.points.push_back(names[stations[i].point]);
    placement.rows.push_back(std::move(row));
  }
  return placement;
}

}  // namespace

Placement place_lean(const Complex& complex, const Features& features, const Limits& limits, Progress& progress, LeanReport* report) {
  LeanReport ignored;
  LeanReport& told = report != nullptr ? *report : ignored;
  LeanState state(complex, features, limits, progress);
  LeanProtection protection(state);
  const auto tell = [&] {
    told.placed = state.steiner();
    told.protected_vertices = protection.vertices();
    told.protected_segments = protection.segments();
  };
  try {
    LeanRefinement(state, protection).run();
  } catch (const LeanGivesUp& reason) {
    tell();
    told.fell_back = true;
    told.reason = reason.what();
    return place_graded(complex, features, limits, progress);
  }
  tell();
  clean_up(state);
  told.removed = told.placed - state.steiner();
  Placement placement = result(state);
  claim_conformity(placement);
  progress.estimated(static_cast<double>(placement.points.size()));
  return placement;
}

}  // namespace confidel
