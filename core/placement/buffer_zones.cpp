// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/placement/buffer_zones.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <limits>
#include <map>
#include <numbers>

namespace confidel {
namespace {

std::uint64_t pair_key(int a, int b) {
  if (a > b) std::swap(a, b);
  return (static_cast<std::uint64_t>(static_cast<std::uint32_t>(a)) << 32) | static_cast<std::uint32_t>(b);
}

// A half-edge of a facet: from -> to with the region on its left. Inner constraints are two of them.
struct HalfEdge {
  VertexId from, to;
};

std::vector<HalfEdge> half_edges(const Facet& facet) {
  std::vector<HalfEdge> result;
  for (const auto& [a, c] : facet.boundary) result.push_back({a, c});
  for (const auto& [a, c] : facet.constraints) {
    result.push_back({a, c});
    result.push_back({c, a});
  }
  return result;
}

// Segments and facets' isolated places at each vertex.
std::vector<int> incidences_of(const Complex& complex) {
  std::vector<int> incidences(complex.vertices.size(), 0);
  for (const Segment& segment : complex.segments)
    for (VertexId v : segment) ++incidences[v];
  for (const Facet& facet : complex.facets)
    for (VertexId v : facet.isolated) ++incidences[v];
  return incidences;
}

}  // namespace

void expect_in_range(double tolerance) {
  if (!(tolerance >= 0x1p-240)) throw std::range_error("a size is below 2^-240 of the input's extent, where doubles cannot steer");
}

BufferZones::BufferZones(const Complex& complex, const BufferSizes& sizes, Stage) : complex_(complex), radius_(sizes.radius) {
  for (const Point& vertex : complex.vertices) add_reference(vertex, PointKind::vertex, -1);
  for (const Facet& facet : complex.facets) frames_.emplace_back(complex, facet);
  tolerances_.resize(complex.vertices.size());
  for (std::size_t v = 0; v < complex.vertices.size(); ++v) {
    const double angle = std::min(1.0, sizes.vertex_angle[v]);
    tolerances_[v] = sizes.radius[v] * angle * angle * sizes.vertex_precision;
    expect_in_range(tolerances_[v]);
  }
  build_rows(sizes);
  build_sectors(sizes);
}

BufferZones::BufferZones(const Complex& complex, const BufferSizes& sizes) : BufferZones(complex, sizes, Stage::ends) {
  std::vector<int> incidences = incidences_of(complex);
  // Nothing else is near: it stays a free vertex of P''.
  std::erase_if(sectors_, [&](const Sector& sector) { return sector.full && incidences[sector.vertex] < 2; });
  divide_arcs([&](const Sector& sector) {
    const double angle = sector.last - sector.first;
    return std::max(sector.full ? 6 : 1, static_cast<int>(std::ceil(angle / sizes.greatest_arc - 1e-9)));
  });
  build_regions();
}

int BufferZones::add_reference(const Point& point, PointKind kind, int carrier) {
  points_.push_back(&point);
  information_.push_back({kind, carrier});
  return static_cast<int>(points_.size()) - 1;
}

int BufferZones::add_point(Point point, PointKind kind, int carrier) {
  storage_.push_back(std::move(point));
  return add_reference(storage_.back(), kind, carrier);
}

void BufferZones::build_rows(const BufferSizes& sizes) {
  const Complex& complex = complex_;
  const std::vector<int> incidences = incidences_of(complex);
  row_of_segment_.resize(complex.segments.size());
  for (std::size_t s = 0; s < complex.segments.size(); ++s) {
    row_of_segment_[s] = static_cast<int>(s);
    rows_.push_back({static_cast<SegmentId>(s), true, true, {}, {}, {}});
  }
  for (std::size_t f = 0; f < complex.facets.size(); ++f) {
    const Facet& facet = complex.facets[f];
    for (const auto& [from, to] : half_edges(facet)) {
      Row& row = rows_[complex.find_segment(from, to)];
      Protector protector{static_cast<FacetId>(f), from < to, {}, {}, {}, {}};
      // The region is on the left of from -> to: that is where n x direction points.
      protector.direction = cross(facet.normal, direction(complex.vertices[from], complex.vertices[to]));
      make_primitive(protector.direction);
      row.protectors.push_back(std::move(protector));
    }
  }
  for (Row& row : rows_) {
    const auto [first, second] = complex.segments[row.segment];
    const Point &p = complex.vertices[first], &q = complex.vertices[second];
    const bool hanging = row.protectors.empty();
    row.projection_first = !hanging || incidences[first] > 1;
    row.projection_second = !hanging || incidences[second] > 1;
    const double size = length(approximate_difference(q, p));
    const double d = sizes.offset[row.segment];
    const auto reach = [&](VertexId v) { return std::sqrt((sizes.radius[v] - d) * (sizes.radius[v] + d)) / size; };
    const auto add_station = [&](Dyadic t) {
      const int id = add_point(along(p, q, t), PointKind::projection, row.segment);
      row.stations.push_back({std::move(t), id});
    };
    if (row.projection_first)
      add_station(round_to(reach(first), tolerances_[first] / size));
    else
      row.stations.push_back({{0, 0}, first});
    if (row.projection_second) {
      Dyadic t = round_to(reach(second), tolerances_[second] / size);
      mpz_class one = 1;
      if (t.exponent >= 0) one <<= t.exponent;
      t.numerator = one - t.numerator;
      add_station(std::move(t));
    } else {
      row.stations.push_back({{1, 0}, second});
    }
    row.free.assign(1, 0);
    // Offsets of the sheets at one edge must agree to within 1 - cos(alpha): R's condition o'.(o'-o) > 0 (theory.md section 5).
    const double precision = [&] {
      const double half = std::sin(sizes.dihedral[row.segment] / 2);
      return std::min(sizes.offset_precision, half * half / 8);  // 1 - cos(alpha) = 2 sin^2(alpha/2)
    }();
    for (Protector& protector : row.protectors) {
      double unit = 0;
      for (const auto& value : protector.direction) unit = std::hypot(unit, value.get_d());
      protector.factor = round_to(d / unit, std::max(precision, 0x1p-100) * d / unit);
      for (const Station& station : row.stations)
        protector.points.push_back(
            add_point(translate(point(station.point), protector.factor, protector.direction), PointKind::offset, protector.facet));
      protector.free.assign(1, 0);
    }
  }
}

Point BufferZones::arc_point(const Sector& sector, double angle) const {
  const double r = radius_[sector.vertex];
  const Double3 offset = (r * std::cos(angle)) * sector.x + (r * std::sin(angle)) * sector.y;
  return frames_[sector.facet].round(complex_.vertices[sector.vertex], offset, tolerances_[sector.vertex]);
}

void BufferZones::build_sectors(const BufferSizes& sizes) {
  const Complex& complex = complex_;
  for (std::size_t f = 0; f < complex.facets.size(); ++f) {
    const Facet& facet = complex.facets[f];
    const Double3 normal = frames_[f].unit_normal();
    // Directions around each vertex: outgoing half-edges begin sectors, incoming ones end them.
    struct Spoke {
      VertexId other;
      bool begins = false, ends = false;
      Double3 direction{};
      double angle = 0;
    };
    std::map<VertexId, std::vector<Spoke>> around;
    const auto spoke = [&](VertexId at, VertexId other) -> Spoke& {
      auto& list = around[at];
      for (Spoke& s : list)
        if (s.other == other) return s;
      list.push_back({other, false, false, unit_vector(direction(complex.vertices[at], complex.vertices[other])), 0});
      return list.back();
    };
    for (const auto& [from, to] : half_edges(facet)) {
      spoke(from, to).begins = true;
      spoke(to, from).ends = true;
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
        if (!end.ends) throw std::logic_error("buffer zones: a sector does not close");
        // Angles between neighbours from their own cross product: exact enough for the smallest ones.
        const Double3 turned = cross(normal, begin.direction);
        double angle = std::atan2(dot(end.direction, turned), dot(end.direction, begin.direction));
        if (angle <= 0 || spokes.size() == 1) angle += 2 * std::numbers::pi;
        if (spokes.size() == 1) angle = 2 * std::numbers::pi;
        Sector sector{static_cast<FacetId>(f), v, false, 0, 0, begin.direction, turned, {}, {}, {}, {}};
        const auto attach = [&](int side, VertexId from, VertexId to) {
          const int index = complex.find_segment(from, to);
          sector.row[side] = index;
          const auto& protectors = rows_[index].protectors;
          for (std::size_t p = 0; p < protectors.size(); ++p)
            if (protectors[p].facet == sector.facet && protectors[p].left == (from < to)) sector.protector[side] = static_cast<int>(p);
        };
        attach(0, v, begin.other);
        attach(1, end.other, v);
        const double r = sizes.radius[v];
        sector.first = std::asin(std::min(1.0, sizes.offset[sector.row[0]] / r));
        sector.last = angle - std::asin(std::min(1.0, sizes.offset[sector.row[1]] / r));
        const auto offset_point = [&](int side) {
          const Row& row = rows_[sector.row[side]];
          const auto& points = row.protectors[sector.protector[side]].points;
          return complex.segments[row.segment][0] == v ? points.front() : points.back();
        };
        sector.arc = {{sector.first, offset_point(0)}, {sector.last, offset_point(1)}};
        sectors_.push_back(std::move(sector));
      }
    }
    for (VertexId v : facet.isolated) {
      const Double3 x = unit_vector(direction(complex.vertices[facet.frame[0]], complex.vertices[facet.frame[1]]));
      sectors_.push_back({static_cast<FacetId>(f), v, true, 0, 2 * std::numbers::pi, x, cross(normal, x), {}, {}, {}, {}});
    }
  }
}

// pieces(sector): into how many equal subarcs. A full circle begins with an arc point of its own.
template <class Pieces>
void BufferZones::divide_arcs(Pieces pieces) {
  for (Sector& sector : sectors_) {
    const int count = pieces(static_cast<const Sector&>(sector));
    std::vector<ArcPoint> arc;
    for (int i = 0; i <= count; ++i) {
      const double at = sector.first + (sector.last - sector.first) * i / count;
      if (!sector.full && (i == 0 || i == count))
        arc.push_back(i == 0 ? sector.arc.front() : sector.arc.back());
      else if (i == count)
        arc.push_back({at, arc.front().point});
      else
        arc.push_back({at, add_point(arc_point(sector, at), PointKind::arc, sector.facet)});
    }
    sector.arc = std::move(arc);
    sector.free.assign(sector.arc.size() - 1, 0);
  }
}

void BufferZones::divide_sectors(const Spacing& spacing) {
  for (std::size_t v = 0; v < tolerances_.size(); ++v)
    tolerances_[v] = std::min(tolerances_[v], spacing.least * spacing.least / radius_[v] * 0x1p-24);
  divide_arcs([&](const Sector& sector) {
    const double r = radius_[sector.vertex], angle = sector.last - sector.first;
    const double unit = 2 * std::asin(spacing.place / (2 * r));
    int count = static_cast<int>(std::floor(angle / unit * (1 + 1e-9)));
    if (spacing.reaches) {
      const int nearest = static_cast<int>(std::lround(angle / unit));
      if (std::abs(angle / unit - nearest) < 1e-9 * nearest) count = spacing.reaches(sector.facet, sector.vertex, sector.row[0], sector.row[1], nearest) ? nearest : nearest - 1;
    }
    count = std::max(2, count);
    // Just below three units, two chords are longer than 1.5 least: there three chords are not shorter than least.
    if (2 * r * std::sin(angle / (2 * count)) > 1.5 * spacing.least * (1 - 0x1p-30)) ++count;
    return count;
  });
}

void BufferZones::divide_rows(const Spacing& spacing) {
  for (Row& row : rows_) {
    const auto [first, second] = complex_.segments[row.segment];
    const Point &p = complex_.vertices[first], &q = complex_.vertices[second];
    const double size = length(approximate_difference(q, p));
    const double length_between = length(approximate_difference(point(row.stations.back().point), point(row.stations.front().point)));
    const long count = std::max(1L, static_cast<long>(std::floor(length_between / spacing.place * (1 + 1e-12))));
    std::vector<Station> stations{row.stations.front()};
    const long double low = row.stations.front().t.approximate(), high = row.stations.back().t.approximate();
    for (long i = 1; i < count; ++i) {
      Dyadic t = round_to(low + (high - low) * i / count, spacing.least / size * 0x1p-24);
      const int id = add_point(along(p, q, t), PointKind::edge, row.segment);
      stations.push_back({std::move(t), id});
    }
    stations.push_back(row.stations.back());
    for (Protector& protector : row.protectors) {
      std::vector<int> points{protector.points.front()};
      for (long i = 1; i < count; ++i)
        points.push_back(add_point(translate(point(stations[i].point), protector.factor, protector.direction), PointKind::offset, protector.facet));
      points.push_back(protector.points.back());
      protector.points = std::move(points);
      protector.free.assign(count, 0);
    }
    row.stations = std::move(stations);
    row.free.assign(count, 0);
  }
}

int BufferZones::region_vertex(FacetRegion& region, int point_id) {
  const auto [place, fresh] = region.vertices.try_emplace(point_id, -1);
  if (fresh) {
    place->second = region.region.insert(point(point_id));
    region.points.push_back(point_id);
  }
  return place->second;
}

void BufferZones::own(FacetRegion& region, int first, int second, const Owner& owner) {
  region.owners[pair_key(region.vertices.at(first), region.vertices.at(second))] = owner;
}

void BufferZones::build_regions() {
  row_marks_.resize(rows_.size());
  sector_marks_.resize(sectors_.size());
  for (std::size_t f = 0; f < complex_.facets.size(); ++f) regions_.emplace_back(projection_of(complex_.facets[f].normal));
  const auto connect = [&](FacetId f, int a, int b, const Owner& owner) {
    FacetRegion& region = regions_[f];
    const int first = region_vertex(region, a), second = region_vertex(region, b);
    region.region.constrain(first, second);
    own(region, a, b, owner);
  };
  // All vertices first: CGAL inserts points faster before there are constraints.
  for (const Row& row : rows_)
    for (const Protector& protector : row.protectors)
      for (int id : protector.points) region_vertex(regions_[protector.facet], id);
  for (const Sector& sector : sectors_)
    for (const ArcPoint& arc : sector.arc) region_vertex(regions_[sector.facet], arc.point);
  for (std::size_t r = 0; r < rows_.size(); ++r)
    for (std::size_t p = 0; p < rows_[r].protectors.size(); ++p) {
      const Protector& protector = rows_[r].protectors[p];
      for (std::size_t i = 0; i + 1 < protector.points.size(); ++i)
        connect(protector.facet, protector.points[i], protector.points[i + 1], {static_cast<int>(r), static_cast<int>(p), -1});
    }
  std::vector<std::vector<char>> protected_isolated(complex_.facets.size());
  std::map<std::pair<FacetId, VertexId>, bool> balls;
  for (std::size_t s = 0; s < sectors_.size(); ++s) {
    const Sector& sector = sectors_[s];
    if (sector.full) balls[{sector.facet, sector.vertex}] = true;
    for (std::size_t i = 0; i + 1 < sector.arc.size(); ++i)
      connect(sector.facet, sector.arc[i].point, sector.arc[i + 1].point, {-1, -1, static_cast<int>(s)});
  }
  for (std::size_t f = 0; f < complex_.facets.size(); ++f) {
    for (VertexId v : complex_.facets[f].isolated)
      if (!balls.count({static_cast<FacetId>(f), v})) region_vertex(regions_[f], v);
    regions_[f].region.mark();
  }
}

int BufferZones::projection_point(const Sector& sector, int side) const {
  const Row& row = rows_[sector.row[side]];
  return complex_.segments[row.segment][0] == sector.vertex ? row.stations.front().point : row.stations.back().point;
}

std::array<int, 3> BufferZones::corners(const BufferCell& cell) const {
  const Sector& sector = sectors_[cell.sector];
  if (cell.kind == CellKind::S) return {sector.vertex, sector.arc[cell.index].point, sector.arc[cell.index + 1].point};
  if (cell.index == 0) return {sector.vertex, projection_point(sector, 0), sector.arc.front().point};
  return {sector.vertex, sector.arc.back().point, projection_point(sector, 1)};
}

std::array<int, 4> BufferZones::box(const BufferCell& cell) const {
  const Row& row = rows_[cell.row];
  const Protector& protector = row.protectors[cell.protector];
  const int i = cell.index;
  // Along the segment the region is on the left: the protector's points follow on the way back.
  if (protector.left) return {row.stations[i].point, row.stations[i + 1].point, protector.points[i + 1], protector.points[i]};
  return {row.stations[i + 1].point, row.stations[i].point, protector.points[i], protector.points[i + 1]};
}

void BufferZones::adopt_new_vertices(FacetId facet) {
  FacetRegion& region = regions_[facet];
  for (int v = static_cast<int>(region.points.size()); v < region.region.vertex_count(); ++v)
    region.points.push_back(add_reference(region.region.point(v), PointKind::interior, facet));
}

void BufferZones::request_row(int row, int interval) {
  row_marks_[row].resize(rows_[row].stations.size() - 1, 0);
  row_marks_[row][interval] = 1;
}

void BufferZones::request_sector(int sector, int interval) {
  sector_marks_[sector].resize(sectors_[sector].arc.size() - 1, 0);
  sector_marks_[sector][interval] = 1;
}

void BufferZones::request_boundary(FacetId facet, std::array<int, 2> vertices) {
  const FacetRegion& region = regions_[facet];
  const Owner& owner = region.owners.at(pair_key(vertices[0], vertices[1]));
  const std::uint64_t wanted = pair_key(region.points[vertices[0]], region.points[vertices[1]]);
  if (owner.sector >= 0) {
    const auto& arc = sectors_[owner.sector].arc;
    for (std::size_t i = 0; i + 1 < arc.size(); ++i)
      if (pair_key(arc[i].point, arc[i + 1].point) == wanted) request_sector(owner.sector, static_cast<int>(i));
  } else {
    const auto& points = rows_[owner.row].protectors[owner.protector].points;
    for (std::size_t i = 0; i + 1 < points.size(); ++i)
      if (pair_key(points[i], points[i + 1]) == wanted) request_row(owner.row, static_cast<int>(i));
  }
}

void BufferZones::split_boundary(FacetId facet, int first, int second, int middle) {
  FacetRegion& region = regions_[facet];
  const int a = region.vertices.at(first), b = region.vertices.at(second);
  const auto place = region.owners.find(pair_key(a, b));
  const Owner owner = place->second;
  region.owners.erase(place);
  const int m = region.region.split(a, b, point(middle));
  region.vertices[middle] = m;
  region.points.push_back(middle);
  own(region, first, middle, owner);
  own(region, middle, second, owner);
}

int BufferZones::split_row(int index) {
  Row& row = rows_[index];
  const auto& marks = row_marks_[index];
  const auto [first, second] = complex_.segments[row.segment];
  std::vector<Station> stations;
  std::vector<char> free;
  int count = 0;
  for (std::size_t i = 0; i < row.stations.size(); ++i) {
    stations.push_back(row.stations[i]);
    if (i + 1 == row.stations.size()) break;
    if (!marks[i]) {
      free.push_back(row.free[i]);
      continue;
    }
    Dyadic t = midpoint(row.stations[i].t, row.stations[i + 1].t);
    const int id = add_point(along(complex_.vertices[first], complex_.vertices[second], t), PointKind::edge, row.segment);
    stations.push_back({std::move(t), id});
    free.insert(free.end(), 2, 0);
    ++count;
  }
  for (Protector& protector : row.protectors) {
    std::vector<int> points;
    std::vector<char> protector_free;
    std::size_t next = 0;
    for (std::size_t i = 0; i < protector.points.size(); ++i, ++next) {
      points.push_back(protector.points[i]);
      if (i + 1 == protector.points.size()) break;
      if (!marks[i]) {
        protector_free.push_back(protector.free[i]);
        continue;
      }
      ++next;
      const int id = add_point(translate(point(stations[next].point), protector.factor, protector.direction), PointKind::offset, protector.facet);
      split_boundary(protector.facet, protector.points[i], protector.points[i + 1], id);
      points.push_back(id);
      protector_free.insert(protector_free.end(), 2, 0);
    }
    protector.points = std::move(points);
    protector.free = std::move(protector_free);
  }
  row.stations = std::move(stations);
  row.free = std::move(free);
  return count;
}

int BufferZones::split_sector(int index) {
  Sector& sector = sectors_[index];
  const auto& marks = sector_marks_[index];
  std::vector<ArcPoint> arc;
  std::vector<char> free;
  int count = 0;
  for (std::size_t i = 0; i < sector.arc.size(); ++i) {
    arc.push_back(sector.arc[i]);
    if (i + 1 == sector.arc.size()) break;
    if (!marks[i]) {
      free.push_back(sector.free[i]);
      continue;
    }
    const double angle = (sector.arc[i].angle + sector.arc[i + 1].angle) / 2;
    const int id = add_point(arc_point(sector, angle), PointKind::arc, sector.facet);
    split_boundary(sector.facet, sector.arc[i].point, sector.arc[i + 1].point, id);
    arc.push_back({angle, id});
    free.insert(free.end(), 2, 0);
    ++count;
  }
  sector.arc = std::move(arc);
  sector.free = std::move(free);
  return count;
}

int BufferZones::apply_requests() {
  int count = 0;
  for (std::size_t r = 0; r < rows_.size(); ++r) {
    if (row_marks_[r].empty()) continue;
    count += split_row(static_cast<int>(r));
    row_marks_[r].clear();
  }
  for (std::size_t s = 0; s < sectors_.size(); ++s) {
    if (sector_marks_[s].empty()) continue;
    count += split_sector(static_cast<int>(s));
    sector_marks_[s].clear();
  }
  return count;
}

Placement BufferZones::result() const {
  Placement placement;
  placement.points.reserve(point_count());
  for (int id = 0; id < point_count(); ++id) placement.points.push_back({point(id), kind(id), carrier(id)});
  std::vector<std::vector<PlacedCell>> cells(complex_.facets.size());
  const auto add = [&](FacetId facet, int a, int b, int c, CellKind kind, int box) {
    cells[facet].push_back({facet, {a, b, c}, kind, box, {}});
  };
  for (std::size_t s = 0; s < sectors_.size(); ++s) {
    const Sector& sector = sectors_[s];
    const auto place = [&](CellKind kind, int index) {
      const auto [a, b, c] = corners({kind, static_cast<int>(s), -1, -1, index});
      add(sector.facet, a, b, c, kind, -1);
    };
    if (!sector.full) {
      place(CellKind::T, 0);
      place(CellKind::T, 1);
    }
    for (std::size_t i = 0; i + 1 < sector.arc.size(); ++i) place(CellKind::S, static_cast<int>(i));
  }
  for (std::size_t r = 0; r < rows_.size(); ++r)
    for (std::size_t p = 0; p < rows_[r].protectors.size(); ++p)
      for (std::size_t i = 0; i + 1 < rows_[r].stations.size(); ++i) {
        const auto [a, b, c, d] = box({CellKind::R, -1, static_cast<int>(r), static_cast<int>(p), static_cast<int>(i)});
        add(rows_[r].protectors[p].facet, a, b, c, CellKind::R, 0);
        add(rows_[r].protectors[p].facet, a, c, d, CellKind::R, 0);
      }
  std::size_t count = 0;
  for (std::size_t f = 0; f < cells.size(); ++f) count += cells[f].size() + regions_[f].region.triangle_count();
  placement.cells.reserve(count);
  int boxes = 0;
  for (std::size_t f = 0; f < cells.size(); ++f) {
    for (std::size_t i = 0; i < cells[f].size(); ++i)
      if (cells[f][i].kind == CellKind::R) {
        cells[f][i].box = boxes;
        cells[f][++i].box = boxes++;
      }
    for (PlacedCell& cell : cells[f]) placement.cells.push_back(std::move(cell));
    for (const auto& [a, b, c] : regions_[f].region.triangles())
      placement.cells.push_back({static_cast<FacetId>(f), {regions_[f].points[a], regions_[f].points[b], regions_[f].points[c]}, CellKind::C, -1, {}});
  }
  for (const Row& row : rows_) {
    PlacedRow placed{row.segment, {}, {}};
    for (const Station& station : row.stations)
      if (information_[station.point].kind != PointKind::vertex) placed.points.push_back(station.point);
    for (const Protector& protector : row.protectors) placed.protectors.push_back({protector.facet, protector.left, protector.points});
    std::sort(placed.protectors.begin(), placed.protectors.end(),
              [](const auto& a, const auto& b) { return a.facet != b.facet ? a.facet < b.facet : a.left > b.left; });
    if (row.protectors.empty()) {
      const auto [first, second] = complex_.segments[row.segment];
      int previous = first;
      for (int id : placed.points) {
        placement.hanging.push_back({row.segment, previous, id});
        previous = id;
      }
      placement.hanging.push_back({row.segment, previous, second});
    }
    if (placed.points.size() >= 2) placement.rows.push_back(std::move(placed));
  }
  return placement;
}

}  // namespace confidel
