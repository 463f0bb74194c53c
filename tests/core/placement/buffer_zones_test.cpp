// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/placement/buffer_zones.h"

#include <boost/test/unit_test.hpp>
#include <numbers>
#include <random>

#include "core/numbers/predicates.h"
#include "tests/support/exact_placement.h"
#include "tests/support/placing.h"
#include "tests/support/small_inputs.h"

using namespace confidel;
using namespace confidel::test;

namespace {

using Generator = std::mt19937_64;

Rational3 at(const BufferZones& zones, int point) { return rational(zones.point(point)); }
double distance(const Rational3& a, const Rational3& b) { return std::sqrt(mpq_class(squared(minus(a, b))).get_d()); }

struct Case {
  explicit Case(const Input& input) : complex(build_complex(input).complex), sizes(graded_sizes(complex, compute_features(complex))), zones(complex, sizes) {}
  const Complex complex;
  const BufferSizes sizes;
  BufferZones zones;
};

/// How often each segment must have a protector: once per side with a facet on it.
std::map<std::pair<SegmentId, FacetId>, int> sides(const Complex& complex) {
  std::map<std::pair<SegmentId, FacetId>, int> result;
  for (std::size_t f = 0; f < complex.facets.size(); ++f) {
    for (const auto& [a, c] : complex.facets[f].boundary) ++result[{complex.find_segment(a, c), static_cast<FacetId>(f)}];
    for (const auto& [a, c] : complex.facets[f].constraints) result[{complex.find_segment(a, c), static_cast<FacetId>(f)}] += 2;
  }
  return result;
}

void check_protector(Case& c, const BufferZones::Row& row, const BufferZones::Protector& protector) {
  const Complex& complex = c.complex;
  const auto [first, second] = complex.segments[row.segment];
  const Rational3 direction = minus(rational(complex.vertices[second]), rational(complex.vertices[first]));
  const Rational3 normal = rational(complex.facets[protector.facet].normal);
  BOOST_REQUIRE(protector.points.size() == row.stations.size());
  BOOST_TEST(protector.free.size() + 1 == protector.points.size());
  const Rational3 offset = minus(at(c.zones, protector.points[0]), at(c.zones, row.stations[0].point));
  BOOST_TEST((scalar(offset, direction) == 0 && scalar(offset, normal) == 0));
  // Left of first -> second is where normal x direction points.
  BOOST_TEST(sgn(mpq_class(scalar(offset, times(normal, direction)))) == (protector.left ? 1 : -1));
  BOOST_TEST(std::abs(std::sqrt(squared(offset).get_d()) / c.sizes.offset[row.segment] - 1) < 1e-3);
  for (std::size_t i = 0; i < protector.points.size(); ++i) {
    const int q = protector.points[i];
    BOOST_TEST((minus(at(c.zones, q), at(c.zones, row.stations[i].point)) == offset));
    BOOST_TEST((c.zones.kind(q) == PointKind::offset && c.zones.carrier(q) == protector.facet));
  }
}

void check_rows(Case& c) {
  auto expected = sides(c.complex);
  BOOST_REQUIRE(c.zones.rows().size() == c.complex.segments.size());
  for (const auto& row : c.zones.rows()) {
    const auto [first, second] = c.complex.segments[row.segment];
    const Rational3 p = rational(c.complex.vertices[first]), q = rational(c.complex.vertices[second]);
    mpq_class previous = -1;
    for (std::size_t i = 0; i < row.stations.size(); ++i) {
      const int id = row.stations[i].point;
      mpq_class t;
      BOOST_REQUIRE(parameter_on_line(p, q, at(c.zones, id), t));
      BOOST_TEST((t == row.stations[i].t.numerator * power_of_two(-row.stations[i].t.exponent)));
      BOOST_TEST((t > previous));
      previous = t;
      const bool end = i == 0 ? row.projection_first : i + 1 == row.stations.size() ? row.projection_second : false;
      if (end) {
        // m: the foot of the offset from the sphere's point; at the tolerance of its vertex.
        const VertexId v = i == 0 ? first : second;
        const double r = c.sizes.radius[v], d = c.sizes.offset[row.segment];
        BOOST_TEST((c.zones.kind(id) == PointKind::projection && c.zones.carrier(id) == row.segment));
        BOOST_TEST(std::abs(distance(at(c.zones, id), i == 0 ? p : q) - std::sqrt(r * r - d * d)) <= 1.01 * c.zones.tolerance(v) + 1e-15);
      } else if (i > 0 && i + 1 < row.stations.size()) {
        BOOST_TEST((c.zones.kind(id) == PointKind::edge && c.zones.carrier(id) == row.segment));
      } else {
        BOOST_TEST(id == (i == 0 ? first : second));
      }
    }
    for (const auto& protector : row.protectors) {
      check_protector(c, row, protector);
      --expected[{row.segment, protector.facet}];
    }
    BOOST_TEST(row.free.size() + 1 == row.stations.size());
  }
  for (const auto& [key, count] : expected) BOOST_TEST(count == 0, "segment " << key.first << " in facet " << key.second);
}

void check_sectors(Case& c, bool at_the_beginning) {
  const Complex& complex = c.complex;
  for (const auto& sector : c.zones.sectors_view()) {
    const Facet& facet = complex.facets[sector.facet];
    const std::array<const Point*, 3> plane{&complex.vertices[facet.frame[0]], &complex.vertices[facet.frame[1]], &complex.vertices[facet.frame[2]]};
    const Projection projection = projection_of(facet.normal);
    const Point& v = complex.vertices[sector.vertex];
    const double r = c.sizes.radius[sector.vertex], tolerance = c.zones.tolerance(sector.vertex);
    BOOST_TEST(sector.arc.size() >= 2);
    BOOST_TEST(sector.free.size() + 1 == sector.arc.size());
    for (std::size_t i = 0; i < sector.arc.size(); ++i) {
      const auto& [angle, id] = sector.arc[i];
      const Rational3 place = at(c.zones, id);
      const bool offset = !sector.full && (i == 0 || i + 1 == sector.arc.size());
      BOOST_TEST(orientation(*plane[0], *plane[1], *plane[2], c.zones.point(id)) == 0);
      BOOST_TEST((c.zones.kind(id) == (offset ? PointKind::offset : PointKind::arc) && c.zones.carrier(id) == sector.facet));
      // On the ball: arc points within the tolerance, offset points as exactly as m and o are.
      BOOST_TEST(std::abs(distance(place, rational(v)) - r) <= (offset ? 1e-3 * r : 1.01 * tolerance));
      const Double3 step = approximate_difference(c.zones.point(id), v);
      double actual = std::atan2(dot(step, sector.y), dot(step, sector.x));
      if (actual < -1e-6) actual += 2 * std::numbers::pi;
      const double turns = std::abs(actual - angle) / (2 * std::numbers::pi);
      if (!offset) BOOST_TEST(std::abs(turns - std::round(turns)) * 2 * std::numbers::pi <= 2 * tolerance / r + 1e-9);
      if (i == 0) continue;
      BOOST_TEST(angle > sector.arc[i - 1].angle);
      if (at_the_beginning) BOOST_TEST(angle - sector.arc[i - 1].angle <= std::numbers::pi / 3 + 1e-9);
      BOOST_TEST(planar_orientation(projection, v, c.zones.point(sector.arc[i - 1].point), c.zones.point(id)) > 0);
    }
    if (sector.full) {
      BOOST_TEST(sector.arc.front().point == sector.arc.back().point);
      continue;
    }
    // T cells at both edges: v, m, a with a right angle at m.
    for (const int side : {0, 1}) {
      const auto& row = c.zones.rows()[sector.row[side]];
      const auto& points = row.protectors[sector.protector[side]].points;
      const bool first = complex.segments[row.segment][0] == sector.vertex;
      const int a = side == 0 ? sector.arc.front().point : sector.arc.back().point, m = c.zones.projection_point(sector, side);
      BOOST_TEST(a == (first ? points.front() : points.back()));
      BOOST_TEST(m == (first ? row.stations.front().point : row.stations.back().point));
      BOOST_TEST((scalar(minus(at(c.zones, a), at(c.zones, m)), minus(rational(v), at(c.zones, m))) == 0));
      const Point &pm = c.zones.point(m), &pa = c.zones.point(a);
      BOOST_TEST(planar_orientation(projection, v, side == 0 ? pm : pa, side == 0 ? pa : pm) > 0);
    }
  }
}

/// Cells by kind tell which points form them; the cells tile the facets exactly.
void check_result(Case& c) {
  const Placement placement = c.zones.result();
  BOOST_REQUIRE(static_cast<int>(placement.points.size()) == c.zones.point_count());
  const ExactPlacement exact(c.complex, placement);
  BOOST_CHECK_NO_THROW(exact.require_points());
  BOOST_CHECK_NO_THROW(exact.require_tiling());
  std::map<CellKind, std::size_t> kinds;
  std::map<int, std::vector<const PlacedCell*>> boxes;
  for (const PlacedCell& cell : placement.cells) {
    ++kinds[cell.kind];
    BOOST_TEST((cell.box >= 0) == (cell.kind == CellKind::R));
    if (cell.kind == CellKind::R) boxes[cell.box].push_back(&cell);
  }
  std::size_t spokes = 0, ends = 0, rectangles = 0;
  for (const auto& sector : c.zones.sectors_view()) {
    spokes += sector.arc.size() - 1;
    ends += sector.full ? 0 : 2;
  }
  for (const auto& row : c.zones.rows()) rectangles += row.protectors.size() * (row.stations.size() - 1);
  BOOST_TEST((kinds[CellKind::S] == spokes && kinds[CellKind::T] == ends && kinds[CellKind::R] == 2 * rectangles && boxes.size() == rectangles));
  for (const auto& [box, halves] : boxes) {
    // Rectangles exactly: corners of both halves, right angles, hence cocircular.
    BOOST_REQUIRE(halves.size() == 2);
    const auto &a = halves[0]->corners, &b = halves[1]->corners;
    BOOST_TEST((a[0] == b[0] && a[2] == b[1]));
    const Rational3 p0 = exact.points[a[0]], p1 = exact.points[a[1]], p2 = exact.points[a[2]], p3 = exact.points[b[2]];
    BOOST_TEST((plus(p0, p2) == plus(p1, p3) && scalar(minus(p1, p0), minus(p3, p0)) == 0));
  }
}

}  // namespace

BOOST_AUTO_TEST_SUITE(buffer_zones)

BOOST_AUTO_TEST_CASE(construction) {
  for (const NamedInput& named : small_inputs()) {
    BOOST_TEST_CONTEXT(named.name) {
      Case c(named.input);
      check_rows(c);
      check_sectors(c, true);
      check_result(c);
    }
  }
}

BOOST_AUTO_TEST_CASE(splits_in_any_order) {
  // Whatever is split, rows stay aligned on all facets, arcs stay on their balls and the cells tile the facets.
  Generator generator(1);
  for (const NamedInput& named : small_inputs()) {
    BOOST_TEST_CONTEXT(named.name) {
      Case c(named.input);
      for (int round = 0; round < 4; ++round) {
        int wanted = 0;
        const auto some = [&] { return generator() % 4 == 0; };
        for (std::size_t r = 0; r < c.zones.rows().size(); ++r)
          for (std::size_t i = 0; i + 1 < c.zones.rows()[r].stations.size(); ++i)
            if (some()) c.zones.request_row(static_cast<int>(r), static_cast<int>(i)), ++wanted;
        for (std::size_t s = 0; s < c.zones.sectors().size(); ++s)
          for (std::size_t i = 0; i + 1 < c.zones.sectors()[s].arc.size(); ++i)
            if (some()) c.zones.request_sector(static_cast<int>(s), static_cast<int>(i)), ++wanted;
        BOOST_TEST(c.zones.apply_requests() == wanted);
        BOOST_TEST(c.zones.apply_requests() == 0);
      }
      check_rows(c);
      check_sectors(c, false);
      check_result(c);
    }
  }
}

BOOST_AUTO_TEST_CASE(splits_asked_for_by_regions) {
  // A region's boundary segment names the interval that it belongs to.
  for (const NamedInput& named : small_inputs()) {
    BOOST_TEST_CONTEXT(named.name) {
      Case c(named.input);
      int turns = 0;
      for (;; ++turns) {
        for (std::size_t f = 0; f < c.complex.facets.size(); ++f)
          for (const auto& ends : c.zones.region(static_cast<FacetId>(f)).encroached_boundary()) c.zones.request_boundary(static_cast<FacetId>(f), ends);
        if (c.zones.apply_requests() == 0) break;
        BOOST_REQUIRE(turns < 40);
      }
      check_rows(c);
      check_sectors(c, false);
      check_result(c);
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()
