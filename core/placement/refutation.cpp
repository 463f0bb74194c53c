// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/placement/refutation.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "core/placement/pencil.h"
#include "core/placement/sphere.h"

namespace confidel {
namespace {

// A cell with its points at hand.
struct CellView {
  CellView(const BufferZones& zones, const BufferCell& cell) : zones_(zones), reference(cell) {
    if (cell.kind == CellKind::R) {
      const auto box = zones.box(cell);
      ids.assign(box.begin(), box.end());
      facet = zones.rows_view()[cell.row].protectors[cell.protector].facet;
      edge = {box[0], box[1]};
    } else {
      const auto corners = zones.corners(cell);
      ids.assign(corners.begin(), corners.end());
      facet = zones.sectors_view()[cell.sector].facet;
      vertex = zones.sectors_view()[cell.sector].vertex;
      // T has its segment on the side of the vertex and the foot.
      if (cell.kind == CellKind::T) edge = cell.index == 0 ? std::array{ids[0], ids[1]} : std::array{ids[2], ids[0]};
    }
  }
  const Point& a() const { return zones_.point(ids[0]); }
  const Point& b() const { return zones_.point(ids[1]); }
  const Point& c() const { return zones_.point(ids[2]); }
  bool has(int id) const { return std::find(ids.begin(), ids.end(), id) != ids.end(); }

  const BufferZones& zones_;
  BufferCell reference;
  std::vector<int> ids;  ///< counter-clockwise, the first three make the sphere
  FacetId facet = -1;
  VertexId vertex = -1;            ///< T and S
  std::array<int, 2> edge{-1, -1};  ///< the side on a segment, the cell on its left; S has none
};

template <class Visit>
void for_each_cell(const BufferZones& zones, bool rectangles, Visit visit) {
  const auto& sectors = zones.sectors_view();
  for (int s = 0; s < static_cast<int>(sectors.size()); ++s) {
    if (!sectors[s].full)
      for (int side : {0, 1}) visit(BufferCell{CellKind::T, s, -1, -1, side});
    for (int i = 0; i + 1 < static_cast<int>(sectors[s].arc.size()); ++i) visit(BufferCell{CellKind::S, s, -1, -1, i});
  }
  if (!rectangles) return;
  const auto& rows = zones.rows_view();
  for (int r = 0; r < static_cast<int>(rows.size()); ++r)
    for (int p = 0; p < static_cast<int>(rows[r].protectors.size()); ++p)
      for (int i = 0; i + 1 < static_cast<int>(rows[r].stations.size()); ++i) visit(BufferCell{CellKind::R, -1, r, p, i});
}

// Is the point the foot m at this vertex?
bool is_foot_at(const BufferZones& zones, int id, VertexId vertex) {
  if (zones.kind(id) != PointKind::projection) return false;
  const auto& row = zones.rows_view()[zones.carrier(id)];
  const auto [first, second] = zones.complex().segments[row.segment];
  return !row.protectors.empty() && ((first == vertex && row.stations.front().point == id) || (second == vertex && row.stations.back().point == id));
}

// The statement that a point inside a cell's diametral sphere refutes; null if there is none.
const char* statement_about(const BufferZones& zones, const CellView& cell, int point) {
  switch (cell.reference.kind) {
    case CellKind::T: return "L9";
    case CellKind::R: return "L13";
    case CellKind::S: break;
    case CellKind::C: return nullptr;
  }
  if (is_foot_at(zones, point, cell.vertex)) return "L10";
  return zones.kind(point) == PointKind::arc || zones.kind(point) == PointKind::offset ? "L11" : nullptr;
}

// A cell that has the point as a corner, preferably a T cell at that vertex.
std::optional<BufferCell> cell_at(const BufferZones& zones, int point, VertexId vertex) {
  std::optional<BufferCell> found;
  bool preferred = false;
  for_each_cell(zones, true, [&](const BufferCell& cell) {
    if (preferred || (found && cell.kind != CellKind::T)) return;
    const CellView view(zones, cell);
    if (!view.has(point)) return;
    if (!found) found = cell;
    if (cell.kind == CellKind::T && view.vertex == vertex) {
      found = cell;
      preferred = true;
    }
  });
  return found;
}

// Bounds of the pencil's parameter by the points nearby: approximate for the choice, exact for the values.
struct Pencil {
  int lower = -1, upper = -1;  // the points that demand offsets above and below
  mpq_class lower_value, upper_value;
  double gap = 0;  // (lower - upper) |n| / R
};

// feet: by the points m of the cell's vertex only, which the paper speaks of.
Pencil pencil_of(const BufferZones& zones, const PointIndex& index, const CellView& cell, bool feet) {
  const Difference normal = certificate_normal(zones.complex(), zones.complex().facets[cell.facet]);
  const Double3 unit = unit_vector(normal.vector);
  Double3 offset;
  const Ball ball = circumscribed_ball(cell.a(), cell.b(), cell.c(), &offset);
  const double radius = length(offset);
  Pencil pencil;
  double lower = -1e300, upper = 1e300;
  index.visit_ball(ball.centre, 4 * ball.radius, [&](int id) {
    if (cell.has(id) || (feet && !is_foot_at(zones, id, cell.vertex))) return false;
    const Double3 x = approximate_difference(zones.point(id), cell.a());
    const double height = dot(unit, x);
    if (std::abs(height) < 1e-9 * length(x) && orientation(cell.a(), cell.b(), cell.c(), zones.point(id)) == 0) return false;
    const double at = (dot(x, x) - 2 * dot(offset, x)) / (2 * height) / radius;
    if (height < 0 && at > lower) {
      lower = at;
      pencil.lower = id;
    }
    if (height > 0 && at < upper) {
      upper = at;
      pencil.upper = id;
    }
    return false;
  });
  if (pencil.lower < 0 || pencil.upper < 0) return pencil;
  pencil.gap = lower - upper;
  if (pencil.gap <= 0) return pencil;
  const auto exact = [&](int id) { return pencil_parameter(cell.a(), cell.b(), cell.c(), zones.point(id), normal); };
  pencil.lower_value = exact(pencil.lower);
  pencil.upper_value = exact(pencil.upper);
  return pencil;
}

mpq_class input_power(const BufferZones& zones, const CellView& cell, int point) {
  return times_power_of_two(power_of(cell.a(), cell.b(), cell.c(), zones.point(point)), 2 * zones.complex().scale);
}

}  // namespace

std::optional<Witness> find_crossing(const BufferZones& zones) {
  const auto& sectors = zones.sectors_view();
  for (int s = 0; s < static_cast<int>(sectors.size()); ++s) {
    if (sectors[s].full) continue;
    const BufferCell opening{CellKind::T, s, -1, -1, 0}, closing{CellKind::T, s, -1, -1, 1};
    const auto [v, m, a] = zones.corners(opening);
    const auto [same, a2, m2] = zones.corners(closing);
    const Projection projection = projection_of(zones.complex().facets[sectors[s].facet].normal);
    const auto turn = [&](int x, int y) { return planar_orientation(projection, zones.point(v), zones.point(x), zones.point(y)); };
    if (turn(m, m2) > 0 && turn(a, a2) <= 0) return Witness{"L5", {opening, closing}, {}, {input_power(zones, CellView(zones, opening), m2)}};
  }
  return {};
}

std::vector<EncroachedCell> find_encroached(const BufferZones& zones, const PointIndex& index, bool rectangles, Progress& progress) {
  std::vector<EncroachedCell> result;
  long tested = 0;
  for_each_cell(zones, rectangles, [&](const BufferCell& reference) {
    if (++tested % 4096 == 0) {
      progress.at("testing the buffer zones", zones.point_count());
      if (progress.stop_requested(zones.point_count())) throw LimitReached("stopped", zones.point_count());
    }
    const CellView cell(zones, reference);
    const Projection projection = projection_of(zones.complex().facets[cell.facet].normal);
    const Point *first = cell.edge[0] < 0 ? nullptr : &zones.point(cell.edge[0]), *second = cell.edge[0] < 0 ? nullptr : &zones.point(cell.edge[1]);
    const Ball ball = circumscribed_ball(cell.a(), cell.b(), cell.c());
    EncroachedCell found{reference, {}};
    bool touched = false;
    index.visit_ball(ball.centre, ball.radius, [&](int id) {
      if (cell.has(id)) return false;
      const Point& p = zones.point(id);
      if (!encroaches(projection, cell.a(), cell.b(), cell.c(), p, first, second)) return false;
      if (diametral_power(cell.a(), cell.b(), cell.c(), p) < 0)
        found.inside.push_back(id);
      else
        touched = true;
      return false;
    });
    if (touched || !found.inside.empty()) result.push_back(std::move(found));
  });
  return result;
}

std::optional<Witness> strongest_witness(const BufferZones& zones, const PointIndex& index, const std::vector<EncroachedCell>& cells) {
  const int scale = zones.complex().scale;
  std::optional<Witness> best;
  for (const bool feet : {true, false}) {
    double widest = 0;
    for (const EncroachedCell& encroached : cells) {
      const Pencil pencil = pencil_of(zones, index, CellView(zones, encroached.cell), feet);
      if (pencil.gap <= widest || pencil.lower_value <= pencil.upper_value) continue;
      widest = pencil.gap;
      // t n is a length: in the input's coordinates n grows by 4^scale and lengths by 2^scale.
      best = Witness{"L18", {encroached.cell}, {pencil.lower, pencil.upper},
                     {times_power_of_two(pencil.lower_value, -scale), times_power_of_two(pencil.upper_value, -scale)}};
    }
    if (best) return best;
  }
  double deepest = 0;
  for (const char* statement : {"L10", "L9", "L11", "L13"}) {
    for (const EncroachedCell& encroached : cells) {
      const CellView cell(zones, encroached.cell);
      Double3 offset;
      circumscribed_ball(cell.a(), cell.b(), cell.c(), &offset);
      for (int id : encroached.inside) {
        const char* about = statement_about(zones, cell, id);
        if (about == nullptr || std::string(about) != statement) continue;
        const Double3 x = approximate_difference(zones.point(id), cell.a());
        const double depth = (2 * dot(offset, x) - dot(x, x)) / dot(offset, offset);
        if (best && depth <= deepest) continue;
        deepest = depth;
        best = Witness{statement, {encroached.cell}, {id}, {}};
      }
    }
    if (best) break;
  }
  if (best) best->values = {input_power(zones, CellView(zones, best->cells[0]), best->points[0])};
  return best;
}

Placement refuting_placement(const BufferZones& zones, const Witness& witness) {
  Placement placement;
  std::map<int, int> renamed;
  const int vertices = static_cast<int>(zones.complex().vertices.size());
  const auto use = [&](int id) {
    const auto [place, fresh] = renamed.try_emplace(id, static_cast<int>(placement.points.size()));
    if (fresh) placement.points.push_back({zones.point(id), zones.kind(id), zones.carrier(id)});
    return place->second;
  };
  for (int v = 0; v < vertices; ++v) use(v);
  int boxes = 0;
  const auto add = [&](const BufferCell& reference) {
    const CellView cell(zones, reference);
    const int index = static_cast<int>(placement.cells.size());
    std::vector<int> ids;
    for (int id : cell.ids) ids.push_back(use(id));
    const bool rectangle = reference.kind == CellKind::R;
    placement.cells.push_back({cell.facet, {ids[0], ids[1], ids[2]}, reference.kind, rectangle ? boxes : -1, {}});
    if (rectangle) placement.cells.push_back({cell.facet, {ids[0], ids[2], ids[3]}, reference.kind, boxes++, {}});
    return index;
  };
  Refutation refutation{witness.statement, {}, {}, witness.values};
  for (const BufferCell& cell : witness.cells) refutation.cells.push_back(add(cell));
  const VertexId vertex = CellView(zones, witness.cells[0]).vertex;
  for (int id : witness.points) {
    if (id >= vertices && renamed.count(id) == 0) {
      const auto cell = cell_at(zones, id, vertex);
      if (!cell) throw StrategyFailed("refutation: a witness that belongs to no cell");
      add(*cell);
    }
    refutation.points.push_back(use(id));
  }
  placement.refutation = std::move(refutation);
  return placement;
}

}  // namespace confidel
