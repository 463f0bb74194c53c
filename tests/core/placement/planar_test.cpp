// SPDX-License-Identifier: GPL-3.0-or-later
// The planar strategies: exactness of what is claimed to be exact, the spacings, the refutation, Saalfeld's disks. Everything in rationals.
#include "core/placement/planar.h"

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <set>

#include "core/complex/build.h"
#include "core/io/read.h"
#include "core/placement/circle.h"
#include "core/placement/open_hull.h"
#include "core/placement/saalfeld.h"
#include "tests/support/placing.h"

using namespace confidel;

namespace {

Complex example(const std::string& name) {
  return build_complex(read_input(std::string(CONFIDEL_SOURCE_DIR) + "/examples/" + name), {}).complex;
}

Placement place_exactly(const Complex& complex, const PlanarOptions& options, double* estimate = nullptr) {
  test::SilentProgress progress;
  const Placement placement = place_planar(complex, compute_features(complex), options, Limits{200000, 1}, progress);
  if (estimate != nullptr) *estimate = progress.estimate;
  return placement;
}

RationalPoint2 at(const Placement& placement, int point) {
  return {placement.rational_positions[point][0], placement.rational_positions[point][1]};
}

mpq_class square(const RationalPoint2& x) { return dot(x, x); }

struct Circle {
  RationalPoint2 centre;
  mpq_class square_radius;
};

Circle circle(const RationalPoint2& a, const RationalPoint2& b, const RationalPoint2& c) {
  const RationalPoint2 u = b - a, w = c - a;
  const mpq_class twice = 2 * cross(u, w), uu = square(u), ww = square(w);
  const RationalPoint2 offset{(w[1] * uu - u[1] * ww) / twice, (u[0] * ww - w[0] * uu) / twice};
  return {a + offset, square(offset)};
}

// Points exactly on circles, chords and rows in [h, 3h/2], rectangles exactly rectangular, R <= (17/16) h inside, every circle empty (where that is few pairs: the checker does it for all).
void check_exactly(const Complex& complex, const Placement& placement) {
  const mpq_class r = *placement.parameters.radius, h = *placement.parameters.spacing;
  const mpq_class hh = h * h;
  const int vertices = static_cast<int>(complex.vertices.size());
  std::set<std::string> seen;
  for (const auto& p : placement.rational_positions) BOOST_TEST((seen.insert(p[0].get_str() + " " + p[1].get_str()).second));
  long arcs = 0, boxes = 0, large = 0, encroached = 0;
  for (std::size_t i = 0; i < placement.cells.size(); ++i) {
    const PlacedCell& cell = placement.cells[i];
    const RationalPoint2 a = at(placement, cell.corners[0]), b = at(placement, cell.corners[1]), c = at(placement, cell.corners[2]);
    BOOST_TEST((sgn(cross(b - a, c - a)) > 0));
    if (cell.kind == CellKind::S) {
      ++arcs;
      BOOST_TEST((cell.corners[0] < vertices));
      BOOST_TEST((square(b - a) == r * r));
      BOOST_TEST((square(c - a) == r * r));
      BOOST_TEST((square(c - b) >= hh));
      BOOST_TEST((4 * square(c - b) <= 9 * hh));
    } else if (cell.kind == CellKind::T) {
      for (int corner = 0; corner < 3; ++corner) {
        const int id = cell.corners[corner];
        if (placement.points[id].kind == PointKind::offset) BOOST_TEST((square(at(placement, id) - a) == r * r));
      }
    } else if (cell.kind == CellKind::R && i + 1 < placement.cells.size() && placement.cells[i + 1].box == cell.box) {
      ++boxes;
      const RationalPoint2 d = at(placement, placement.cells[i + 1].corners[2]);
      BOOST_TEST((a + c == b + d));
      BOOST_TEST((dot(b - a, d - a) == 0));
      BOOST_TEST((square(b - a) >= hh));
      BOOST_TEST((4 * square(b - a) <= 9 * hh));
    }
    const Circle round = circle(a, b, c);
    if (cell.kind == CellKind::C) large += 256 * round.square_radius > 289 * hh;
    for (std::size_t x = 0; x < placement.points.size() && placement.cells.size() < 700; ++x)
      encroached += square(at(placement, static_cast<int>(x)) - round.centre) < round.square_radius;
  }
  BOOST_TEST((arcs > 0));
  BOOST_TEST((boxes > 0));
  BOOST_TEST((large == 0));
  BOOST_TEST((encroached == 0));
  for (const PlacedRow& row : placement.rows)
    for (const auto& protector : row.protectors) {
      BOOST_TEST_REQUIRE(protector.points.size() == row.points.size());
      const RationalPoint2 offset = at(placement, protector.points[0]) - at(placement, row.points[0]);
      for (std::size_t i = 0; i < row.points.size(); ++i) BOOST_TEST((at(placement, protector.points[i]) == at(placement, row.points[i]) + offset));
    }
}

}  // namespace

BOOST_AUTO_TEST_SUITE(planar_strategies)

BOOST_AUTO_TEST_CASE(points_of_circles_are_exact_and_near_their_angle) {
  for (double angle = -7; angle < 7; angle += 0.37) {
    const RationalPoint2 p = point_of_unit_circle(angle, 30);
    BOOST_TEST((dot(p, p) == 1));
    BOOST_TEST((std::abs(p[0].get_d() - std::cos(angle)) < 1e-8));
    BOOST_TEST((std::abs(p[1].get_d() - std::sin(angle)) < 1e-8));
  }
}

BOOST_AUTO_TEST_CASE(repaired_is_exact) {
  for (const char* name : {"corner-45.poly", "well.poly"}) {
    const Complex complex = example(name);
    double estimate = 0;
    const Placement placement = place_exactly(complex, {repaired_rule(), {}}, &estimate);
    BOOST_TEST((!placement.refutation));
    check_exactly(complex, placement);
    BOOST_TEST((estimate > 0.5 * placement.points.size()));
    BOOST_TEST((estimate < 2.0 * placement.points.size()));
  }
}

BOOST_AUTO_TEST_CASE(circumradii_are_bounded_on_request) {
  const Complex complex = example("corner-45.poly");
  PlanarOptions options{repaired_rule(), mpq_class(1, 4)};
  const Placement placement = place_exactly(complex, options);
  BOOST_TEST((100 * *placement.parameters.radius * *placement.parameters.radius * 16 <= 361));
  for (const PlacedCell& cell : placement.cells)
    BOOST_TEST((circle(at(placement, cell.corners[0]), at(placement, cell.corners[1]), at(placement, cell.corners[2])).square_radius <= mpq_class(1, 16)));
  check_exactly(complex, placement);
}

BOOST_AUTO_TEST_CASE(printed_offsets_are_refuted) {
  const Complex complex = example("corner-45.poly");
  PlanarOptions options{paper_rule(), {}};
  const Placement placement = place_exactly(complex, options);
  BOOST_TEST_REQUIRE(placement.refutation.has_value());
  BOOST_TEST((placement.refutation->statement == "L5"));
  // theory.md section 2: the power of m_B is -0.005728 r^2.
  const mpq_class r = *placement.parameters.radius;
  BOOST_TEST((std::abs(mpq_class(placement.refutation->values[0] / (r * r)).get_d() + 0.005728) < 1e-6));
  BOOST_TEST((placement.points.size() == complex.vertices.size() + 4));
  // With beta = phi/3 nothing is refuted.
  options.rule = paper_rule(mpq_class(1, 3));
  const Placement third = place_exactly(complex, options);
  BOOST_TEST((!third.refutation));
  check_exactly(complex, third);
}

BOOST_AUTO_TEST_CASE(too_many_points_are_refused_with_the_estimate) {
  const Complex complex = example("courtyard.poly");
  test::SilentProgress progress;
  BOOST_CHECK_THROW(place_planar(complex, compute_features(complex), {repaired_rule(), {}}, Limits{100, 1}, progress), LimitReached);
  BOOST_TEST((progress.estimate > 100));
}

BOOST_AUTO_TEST_CASE(saalfeld_places_points_on_segments_only) {
  for (const char* name : {"corner-45.poly", "courtyard.poly", "well.poly"}) {
    const Complex complex = example(name);
    test::SilentProgress progress;
    const Placement placement = place_saalfeld(complex, compute_features(complex), {}, progress);
    BOOST_TEST((placement.points.size() > complex.vertices.size() + 2 * complex.segments.size()));
    for (std::size_t i = complex.vertices.size(); i < placement.points.size(); ++i)
      BOOST_TEST((placement.points[i].kind == PointKind::projection || placement.points[i].kind == PointKind::edge));
    // Every piece has an empty diametral circle.
    long bad = 0;
    for (const PlacedRow& row : placement.rows) {
      std::vector<int> chain{complex.segments[row.segment][0]};
      chain.insert(chain.end(), row.points.begin(), row.points.end());
      chain.push_back(complex.segments[row.segment][1]);
      for (std::size_t i = 0; i + 1 < chain.size(); ++i)
        for (std::size_t x = 0; x < placement.points.size(); ++x) {
          if (static_cast<int>(x) == chain[i] || static_cast<int>(x) == chain[i + 1]) continue;
          const Difference a = difference(placement.points[x].position, placement.points[chain[i]].position);
          const Difference b = difference(placement.points[x].position, placement.points[chain[i + 1]].position);
          bad += sgn(dot(a.vector, b.vector)) <= 0;
        }
    }
    BOOST_TEST((bad == 0));
  }
}

BOOST_AUTO_TEST_CASE(the_hull_is_left_open_where_it_is_sharp) {
  const Complex star = example("star-1.poly");
  test::SilentProgress progress;
  const auto placement = place_with_open_hull(star, compute_features(star), {}, progress);
  BOOST_TEST((placement.has_value()));
  const Complex courtyard = example("courtyard.poly");
  BOOST_TEST((!place_with_open_hull(courtyard, compute_features(courtyard), {}, progress).has_value()));
}

BOOST_AUTO_TEST_SUITE_END()
