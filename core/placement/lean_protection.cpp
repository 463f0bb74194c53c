// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/placement/lean_protection.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

namespace confidel {
namespace {

// Free points are removed a little beyond what is protected: splits would have to separate them.
constexpr double clearance = 1.25;

}  // namespace

LeanProtection::LeanProtection(LeanState& state) : state_(state), complex_(state.complex()) {
  active_vertex_.assign(complex_.vertices.size(), 0);
  active_segment_.assign(complex_.segments.size(), 0);
  ends_.assign(complex_.segments.size(), {-1, -1});
  stations_.resize(complex_.segments.size());
  sectors_of_facet_.resize(complex_.facets.size());
  sheets_of_facet_.resize(complex_.facets.size());
}

double LeanProtection::tolerance(VertexId v) const {
  const double angle = std::min(1.0, state_.sizes().vertex_angle[v]);
  const double result = state_.sizes().radius[v] * angle * angle * 0x1p-12;
  expect_in_range(result);
  return result;
}

void LeanProtection::build_sheets() {
  sheets_.resize(complex_.segments.size());
  for (std::size_t f = 0; f < complex_.facets.size(); ++f) {
    const Facet& facet = complex_.facets[f];
    const auto add = [&](VertexId from, VertexId to) {
      const SegmentId s = complex_.find_segment(from, to);
      Sheet sheet{static_cast<FacetId>(f), from < to, {}, {}, {-1, -1}, {}};
      // The region is on the left of from -> to: that is where n x direction points.
      sheet.direction = cross(facet.normal, direction(complex_.vertices[from], complex_.vertices[to]));
      make_primitive(sheet.direction);
      double unit = 0;
      for (const auto& value : sheet.direction) unit = std::hypot(unit, value.get_d());
      // Offsets of the sheets at one edge must agree to within 1 - cos(alpha) (theory.md section 5).
      const double d = state_.sizes().offset[s], half = std::sin(state_.sizes().dihedral[s] / 2);
      sheet.factor = round_to(d / unit, std::max(std::min(0x1p-10, half * half / 8), 0x1p-100) * d / unit);
      sheets_[s].push_back(std::move(sheet));
    };
    for (const auto& [a, b] : facet.boundary) add(a, b);
    for (const auto& [a, b] : facet.constraints) {
      add(a, b);
      add(b, a);
    }
  }
}

void LeanProtection::build_sectors() {
  sectors_of_vertex_.resize(complex_.vertices.size());
  for (std::size_t f = 0; f < complex_.facets.size(); ++f) {
    const Facet& facet = complex_.facets[f];
    const Double3 normal = state_.frame(static_cast<FacetId>(f)).unit_normal();
    // Directions around each vertex: outgoing half-edges begin sectors.
    struct Spoke {
      VertexId other;
      bool begins;
      Double3 direction;
      double angle;
    };
    std::map<VertexId, std::vector<Spoke>> around;
    const auto spoke = [&](VertexId at, VertexId other, bool begins) {
      auto& list = around[at];
      for (Spoke& s : list)
        if (s.other == other) {
          s.begins |= begins;
          return;
        }
      list.push_back({other, begins, unit_vector(direction(complex_.vertices[at], complex_.vertices[other])), 0});
    };
    const auto add = [&](VertexId from, VertexId to) {
      spoke(from, to, true);
      spoke(to, from, false);
    };
    for (const auto& [a, b] : facet.boundary) add(a, b);
    for (const auto& [a, b] : facet.constraints) {
      add(a, b);
      add(b, a);
    }
    for (auto& [v, spokes] : around) {
      const Double3 x = spokes.front().direction, y = cross(normal, x);
      for (Spoke& s : spokes) {
        s.angle = std::atan2(dot(s.direction, y), dot(s.direction, x));
        if (s.angle < 0) s.angle += 2 * std::numbers::pi;
      }
      spokes.front().angle = 0;
      std::sort(spokes.begin(), spokes.end(), [](const Spoke& a, const Spoke& b) { return a.angle < b.angle; });
      for (std::size_t k = 0; k < spokes.size(); ++k) {
        const Spoke& begin = spokes[k];
        if (!begin.begins) continue;
        const Spoke& end = spokes[(k + 1) % spokes.size()];
        const Double3 turned = cross(normal, begin.direction);
        double angle = std::atan2(dot(end.direction, turned), dot(end.direction, begin.direction));
        if (angle <= 0) angle += 2 * std::numbers::pi;
        if (spokes.size() == 1) angle = 2 * std::numbers::pi;
        sectors_of_vertex_[v].push_back(static_cast<int>(sectors_.size()));
        sectors_.push_back({static_cast<FacetId>(f), v, false, begin.direction, turned, angle,
                            {complex_.find_segment(v, begin.other), complex_.find_segment(end.other, v)}, {v < begin.other, end.other < v}, {}});
      }
    }
    for (VertexId v : facet.isolated) {
      const Double3 x = unit_vector(direction(complex_.vertices[facet.frame[0]], complex_.vertices[facet.frame[1]]));
      sectors_of_vertex_[v].push_back(static_cast<int>(sectors_.size()));
      sectors_.push_back({static_cast<FacetId>(f), v, true, x, cross(normal, x), 2 * std::numbers::pi, {-1, -1}, {false, false}, {}});
    }
  }
}

LeanProtection::Sheet& LeanProtection::sheet_of(SegmentId s, FacetId f, bool left) {
  for (Sheet& sheet : sheets_[s])
    if (sheet.facet == f && sheet.left == left) return sheet;
  throw std::logic_error("lean: a sector has no sheet at its edge");
}

bool LeanProtection::free_point(int id) const {
  return id >= static_cast<int>(complex_.vertices.size()) && state_.alive(id) &&
         (id >= static_cast<int>(protected_.size()) || !protected_[id]);
}

void LeanProtection::note_sector(int point, int sector) {
  if (static_cast<int>(protected_.size()) <= point) protected_.resize(point + 1, 0);
  protected_[point] = 1;
  if (sector >= 0) sectors_of_point_[point].push_back(sector);
}

Point LeanProtection::arc_point(const Sector& sector, double angle) const {
  const double r = state_.sizes().radius[sector.vertex];
  const Double3 offset = (r * std::cos(angle)) * sector.x + (r * std::sin(angle)) * sector.y;
  return state_.frame(sector.facet).round(complex_.vertices[sector.vertex], offset, tolerance(sector.vertex));
}

void LeanProtection::clear_ball(VertexId v) {
  const double reach = clearance * state_.sizes().radius[v];
  std::vector<int> gone;
  state_.index().visit_ball(complex_.vertices[v].approximate(), reach, [&](int id) {
    if (!free_point(id) || !(length(approximate_difference(state_.point(id), complex_.vertices[v])) < reach)) return false;
    const int carrier = state_.information(id).carrier;
    bool here;
    if (state_.on_segment(id)) {
      here = complex_.segments[carrier][0] == v || complex_.segments[carrier][1] == v;
    } else {
      const auto& facets = state_.facets_of_vertex(v);
      here = std::find(facets.begin(), facets.end(), carrier) != facets.end();
    }
    if (here) gone.push_back(id);
    return false;
  });
  std::sort(gone.begin(), gone.end());
  for (int id : gone) state_.take_out(id);
}

void LeanProtection::activate_vertex(VertexId v) {
  if (sheets_.empty()) {
    build_sheets();
    build_sectors();
  }
  active_vertex_[v] = 1;
  ++vertices_;
  clear_ball(v);
  const double r = state_.sizes().radius[v];
  for (std::size_t s = 0; s < complex_.segments.size(); ++s) {
    const auto [first, second] = complex_.segments[s];
    if (first != v && second != v) continue;
    const Point &p = complex_.vertices[first], &q = complex_.vertices[second];
    const double size = length(approximate_difference(q, p)), d = state_.sizes().offset[s];
    Dyadic t = round_to(std::sqrt((r - d) * (r + d)) / size, tolerance(v) / size);
    if (second == v) {
      mpz_class one = 1;
      if (t.exponent >= 0) one <<= t.exponent;
      t.numerator = one - t.numerator;
    }
    const int m = state_.put_on_segment(static_cast<SegmentId>(s), std::move(t), PointKind::projection);
    note_sector(m, -1);
    const int end = first == v ? 0 : 1;
    ends_[s][end] = m;
    for (Sheet& sheet : sheets_[s]) {
      sheet.ends[end] = state_.put_in_facet(sheet.facet, translate(state_.point(m), sheet.factor, sheet.direction), PointKind::offset, m);
      note_sector(sheet.ends[end], -1);
    }
  }
  for (int index : sectors_of_vertex_[v]) {
    Sector& sector = sectors_[index];
    sectors_of_facet_[sector.facet].push_back(index);
    double first = 0, last = sector.angle;
    std::array<int, 2> ends{-1, -1};
    if (!sector.full) {
      const double sines[2] = {state_.sizes().offset[sector.edges[0]] / r, state_.sizes().offset[sector.edges[1]] / r};
      first = std::asin(std::min(1.0, sines[0]));
      last -= std::asin(std::min(1.0, sines[1]));
      for (int side = 0; side < 2; ++side) {
        const SegmentId s = sector.edges[side];
        const int end = complex_.segments[s][0] == v ? 0 : 1;
        ends[side] = sheet_of(s, sector.facet, sector.left[side]).ends[end];
        note_sector(ends_[s][end], index);
      }
    }
    const int pieces = std::max(sector.full ? 6 : 1, static_cast<int>(std::ceil((last - first) / state_.sizes().greatest_arc - 1e-9)));
    for (int i = 0; i <= pieces; ++i) {
      const double at = first + (last - first) * i / pieces;
      int id;
      if (i == pieces && sector.full)
        id = sector.arc.front().point;
      else if (!sector.full && (i == 0 || i == pieces))
        id = ends[i == 0 ? 0 : 1];
      else
        id = state_.put_in_facet(sector.facet, arc_point(sector, at), PointKind::arc, v);
      sector.arc.push_back({at, id});
      if (i < pieces || !sector.full) note_sector(id, index);
    }
  }
}

void LeanProtection::clear_row(SegmentId s) {
  const auto [first, second] = complex_.segments[s];
  const Point &p = complex_.vertices[first], &q = complex_.vertices[second];
  const Double3 axis = approximate_difference(q, p);
  const double size = length(axis), reach = clearance * state_.sizes().offset[s];
  std::vector<int> gone;
  state_.index().visit_ball(p.approximate() + 0.5 * axis, size / 2 + 2 * reach, [&](int id) {
    if (!free_point(id)) return false;
    const int carrier = state_.information(id).carrier;
    if (state_.on_segment(id)) {
      if (carrier == s) gone.push_back(id);
      return false;
    }
    bool here = false;
    for (const Sheet& sheet : sheets_[s]) here |= sheet.facet == carrier;
    if (!here) return false;
    const Double3 to = approximate_difference(state_.point(id), p);
    if (length(cross(axis, to)) / size < reach && dot(axis, to) > 0 && dot(axis, to) < size * size) gone.push_back(id);
    return false;
  });
  std::sort(gone.begin(), gone.end());
  for (int id : gone) state_.take_out(id);
}

void LeanProtection::activate_segment(SegmentId s) {
  active_segment_[s] = 1;
  ++segments_;
  for (VertexId v : complex_.segments[s])
    if (!active_vertex(v)) activate_vertex(v);
  if (sheets_[s].empty()) return;  // hanging: its ends' balls suffice
  clear_row(s);
  stations_[s] = {ends_[s][0], ends_[s][1]};
  for (std::size_t k = 0; k < sheets_[s].size(); ++k) {
    Sheet& sheet = sheets_[s][k];
    sheet.points = {sheet.ends[0], sheet.ends[1]};
    sheets_of_facet_[sheet.facet].push_back({s, static_cast<int>(k)});
    for (int id : sheet.points) rows_of_point_[id].push_back(s);
  }
  for (int id : stations_[s]) rows_of_point_[id].push_back(s);
}

// --- splits --------------------------------------------------------------------------------------------------------------------

void LeanProtection::split_arc(int index, std::size_t i) {
  Sector& sector = sectors_[index];
  const double angle = (sector.arc[i].angle + sector.arc[i + 1].angle) / 2;
  if ((sector.arc[i + 1].angle - sector.arc[i].angle) * state_.sizes().radius[sector.vertex] < 64 * tolerance(sector.vertex))
    throw LeanGivesUp("an arc is too short to be split");
  const int id = state_.put_in_facet(sector.facet, arc_point(sector, angle), PointKind::arc, sector.arc[i].point);
  note_sector(id, index);
  sector.arc.insert(sector.arc.begin() + static_cast<long>(i) + 1, {angle, id});
  if (sector.full) return;
  // An arc that became as short as the row of its segment would be wide: the row is needed too.
  const double r = state_.sizes().radius[sector.vertex];
  const auto too_short = [&](int side) {
    const SegmentId s = sector.edges[side];
    const std::size_t k = side == 0 ? 0 : sector.arc.size() - 2;
    return !active_segment(s) && (sector.arc[k + 1].angle - sector.arc[k].angle) * r < state_.sizes().offset[s];
  };
  for (int side = 0; side < 2; ++side)
    if (too_short(side)) activate_segment(sector.edges[side]);
}

void LeanProtection::split_row(SegmentId s, std::size_t i) {
  const int a = stations_[s][i], b = stations_[s][i + 1];
  const auto& chain = state_.chains()[s].stations;
  Dyadic t = midpoint(chain[state_.station_of(s, a)].t, chain[state_.station_of(s, b)].t);
  const int id = state_.put_on_segment(s, std::move(t), PointKind::edge);
  note_sector(id, -1);
  stations_[s].insert(stations_[s].begin() + static_cast<long>(i) + 1, id);
  rows_of_point_[id].push_back(s);
  for (Sheet& sheet : sheets_[s]) {
    const int o = state_.put_in_facet(sheet.facet, translate(state_.point(id), sheet.factor, sheet.direction), PointKind::offset, id);
    note_sector(o, -1);
    sheet.points.insert(sheet.points.begin() + static_cast<long>(i) + 1, o);
    rows_of_point_[o].push_back(s);
  }
}

bool LeanProtection::split_piece(int a, int b, FacetId facet) {
  const SegmentId s = state_.segment_of(a, b);
  for (int end = 0; end < 2; ++end) {
    const VertexId v = complex_.segments[s][end];
    if (!active_vertex(v) || (a != v && b != v)) continue;
    // The longest arc next to the piece.
    int best = -1;
    std::size_t interval = 0;
    double longest = 0;
    for (int index : sectors_of_vertex_[v]) {
      const Sector& sector = sectors_[index];
      if (sector.full || (facet >= 0 && sector.facet != facet)) continue;
      for (int side = 0; side < 2; ++side) {
        if (sector.edges[side] != s) continue;
        const std::size_t i = side == 0 ? 0 : sector.arc.size() - 2;
        const double angle = sector.arc[i + 1].angle - sector.arc[i].angle;
        if (angle > longest) {
          longest = angle;
          best = index;
          interval = i;
        }
      }
    }
    if (best < 0) throw LeanGivesUp("the end of a hanging segment is not free");
    split_arc(best, interval);
    return true;
  }
  const auto& row = stations_[s];
  for (std::size_t i = 0; i + 1 < row.size(); ++i)
    if ((row[i] == a && row[i + 1] == b) || (row[i] == b && row[i + 1] == a)) {
      split_row(s, i);
      return true;
    }
  return false;
}

bool LeanProtection::split_under(FacetId facet, const Triangle& t) {
  // One row.
  const auto row = rows_of_point_.find(t[0]);
  if (row != rows_of_point_.end())
    for (SegmentId s : row->second) {
      std::size_t low = stations_[s].size(), high = 0;
      int found = 0;
      for (int id : t) {
        const auto note = [&](const std::vector<int>& points) {
          const auto place = std::find(points.begin(), points.end(), id);
          if (place == points.end()) return false;
          const std::size_t i = static_cast<std::size_t>(place - points.begin());
          low = std::min(low, i);
          high = std::max(high, i);
          ++found;
          return true;
        };
        if (note(stations_[s])) continue;
        for (const Sheet& sheet : sheets_[s])
          if (sheet.facet == facet && note(sheet.points)) break;
      }
      if (found < 3 || high <= low) continue;
      std::size_t best = low;
      double longest = 0;
      for (std::size_t i = low; i < high; ++i) {
        const double size = state_.distance(stations_[s][i], stations_[s][i + 1]);
        if (size > longest) {
          longest = size;
          best = i;
        }
      }
      split_row(s, best);
      return true;
    }
  // One sector.
  for (int index : sectors_of_facet_[facet]) {
    const Sector& sector = sectors_[index];
    std::vector<std::size_t> on_arc;
    int found = 0;
    for (int id : t) {
      if (id == sector.vertex) {
        ++found;
        continue;
      }
      const auto place = sectors_of_point_.find(id);
      if (place == sectors_of_point_.end() || std::find(place->second.begin(), place->second.end(), index) == place->second.end()) continue;
      ++found;
      for (std::size_t i = 0; i < sector.arc.size(); ++i)
        if (sector.arc[i].point == id) {
          on_arc.push_back(i);
          break;
        }
    }
    if (found < 3) continue;
    if (on_arc.empty()) return false;
    std::sort(on_arc.begin(), on_arc.end());
    std::size_t low = on_arc.front(), high = on_arc.back();
    if (on_arc.size() == 1) {
      // A triangle at the end of an edge: its neighbour.
      if (low + 1 == sector.arc.size()) --low;
      high = low + 1;
    } else if (sector.full && on_arc.size() == 2 && high - low > sector.arc.size() / 2) {
      low = high;  // the interval that closes the circle
      high = sector.arc.size() - 1;
    }
    std::size_t best = low;
    double longest = 0;
    for (std::size_t i = low; i < high; ++i) {
      const double angle = sector.arc[i + 1].angle - sector.arc[i].angle;
      if (angle > longest) {
        longest = angle;
        best = i;
      }
    }
    split_arc(index, best);
    return true;
  }
  return false;
}

std::optional<std::array<int, 2>> LeanProtection::split_at(FacetId facet, const Point& position) {
  const auto in_disk = [&](int a, int b) {
    return dot(approximate_difference(state_.point(a), position), approximate_difference(state_.point(b), position)) <= 0;
  };
  for (int index : sectors_of_facet_[facet]) {
    const Sector& sector = sectors_[index];
    const Double3 to = approximate_difference(position, complex_.vertices[sector.vertex]);
    const double r = state_.sizes().radius[sector.vertex], away = length(to);
    if (away > 1.5 * r) continue;  // the disk of a chord of 60 degrees reaches to 1.37 r
    if (away < r) {
      double angle = std::atan2(dot(to, sector.y), dot(to, sector.x));
      if (angle < 0) angle += 2 * std::numbers::pi;
      if (angle <= sector.angle) {
        // Between a segment and the arc a split of the arc would change nothing: what is beyond m is too long.
        if (!sector.full && (angle < sector.arc.front().angle || angle > sector.arc.back().angle)) {
          const int side = angle < sector.arc.front().angle ? 0 : 1;
          const SegmentId s = sector.edges[side];
          const auto& stations = state_.chains()[s].stations;
          const std::size_t i = complex_.segments[s][0] == sector.vertex ? 1 : stations.size() - 3;
          const std::array<int, 2> piece{stations[i].point, stations[i + 1].point};
          return piece;
        }
        std::size_t i = 0;
        while (i + 2 < sector.arc.size() && sector.arc[i + 1].angle < angle) ++i;
        split_arc(index, i);
        return std::array<int, 2>{-1, -1};
      }
    }
    for (std::size_t i = 0; i + 1 < sector.arc.size(); ++i)
      if (in_disk(sector.arc[i].point, sector.arc[i + 1].point)) {
        split_arc(index, i);
        return std::array<int, 2>{-1, -1};
      }
  }
  for (const auto& [s, k] : sheets_of_facet_[facet]) {
    const Sheet& sheet = sheets_[s][k];
    const auto& row = stations_[s];
    // Strip and disk of an interval lie between the normals at its ends: only one interval is asked, and its neighbours for roundings.
    const Double3 whole = approximate_difference(state_.point(row.back()), state_.point(row.front()));
    std::size_t low = 0, high = row.size() - 1;
    while (high - low > 1) {
      const std::size_t middle = (low + high) / 2;
      (dot(approximate_difference(position, state_.point(row[middle])), whole) < 0 ? high : low) = middle;
    }
    for (std::size_t i = low > 0 ? low - 1 : 0; i <= low + 1 && i + 1 < row.size(); ++i) {
      // The strip: between the segment and the chord, from station to station.
      const Double3 along = approximate_difference(state_.point(row[i + 1]), state_.point(row[i])),
                    up = approximate_difference(state_.point(sheet.points[i]), state_.point(row[i])),
                    to = approximate_difference(position, state_.point(row[i]));
      const double x = dot(to, along), y = dot(to, up);
      const bool inside = x >= 0 && x <= dot(along, along) && y >= 0 && y <= dot(up, up);
      if (!inside && !in_disk(sheet.points[i], sheet.points[i + 1])) continue;
      split_row(s, i);
      return std::array<int, 2>{-1, -1};
    }
  }
  return std::nullopt;
}

}  // namespace confidel
