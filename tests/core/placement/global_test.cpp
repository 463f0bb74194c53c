// SPDX-License-Identifier: GPL-3.0-or-later
// The global strategies: parameters, subdivisions and insertions in rationals, and the counterexamples as regressions that must stay
// refuted (theory.md section 2).
#include "core/placement/global.h"

#include <boost/test/unit_test.hpp>

#include "core/numbers/angle.h"
#include "core/tetrahedra/delaunay.h"
#include "tests/support/exact_placement.h"
#include "tests/support/placing.h"
#include "tests/support/small_inputs.h"

using namespace confidel;
using namespace confidel::test;

namespace {

Input w2() { return triangles({{0, 0, 0}, {12, 0, 0}, {0, 12, 0}, {12, 12, 1}}, {{0, 1, 2}, {0, 1, 3}}); }
Input w3() { return triangles({{0, 0, 0}, {20, 0, 0}, {0, 20, 0}, {20, 20, 1}, {10, 10, -14}}, {{0, 1, 2}, {0, 1, 3}, {0, 1, 4}}); }
Input w3_prime() { return triangles({{0, 0, 0}, {70, 0, 0}, {0, 70, 0}, {70, 70, 1}, {36, 36, -42}}, {{0, 1, 2}, {0, 1, 3}, {0, 1, 4}}); }
Input g3() {
  return triangles({{0, 0, 0}, {20, 0, 0}, {0, 20, 0}, {20, 20, 1}, {0, 0, 28}, {10, 10, -14}, {-10, -10, -14}}, {{0, 1, 2}, {0, 3, 4}, {0, 5, 6}});
}
Input tetrahedron() { return triangles({{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}}, {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}); }

Placement placed(const Complex& complex, const GlobalRule& rule, long max_points = 0, int threads = 1) {
  SilentProgress progress;
  return place_global(complex, compute_features(complex), rule, {max_points, threads}, progress);
}

GlobalRule paper_with(const char* share) { return *share == 0 ? paper_rule() : paper_rule(mpq_class(share)); }

// P0(x) and n.(x-a), recomputed in rationals from a placement in the input's coordinates.
struct ExactCell {
  ExactCell(const ExactPlacement& exact, const PlacedCell& cell) : exact_(exact), cell_(cell) {
    const auto [a, b, c] = cell_.corners;
    const Rational3 u = minus(exact.points[b], exact.points[a]), w = minus(exact.points[c], exact.points[a]), n = times(u, w);
    twice_ = scaled(1 / squared(n), plus(scaled(squared(u), times(w, n)), scaled(squared(w), times(n, u))));
    normal_ = facet_normal(exact.complex, exact.complex.facets[cell_.facet]);
  }
  mpq_class power(int point) const {
    const Rational3 x = from_a(point);
    return squared(x) - scalar(twice_, x);
  }
  mpq_class height(int point) const { return scalar(normal_, from_a(point)); }
  mpq_class square_of_radius() const { return squared(twice_) / 4; }
  Rational3 centre() const { return plus(exact_.points[cell_.corners[0]], scaled(mpq_class(1, 2), twice_)); }

 private:
  Rational3 from_a(int point) const { return minus(exact_.points[point], exact_.points[cell_.corners[0]]); }
  const ExactPlacement& exact_;
  PlacedCell cell_;
  Rational3 twice_, normal_;
};

mpq_class square_of_distance(const ExactPlacement& exact, int a, int b) { return squared(minus(exact.points[a], exact.points[b])); }

void check_hypotheses(const ExactPlacement& exact) {
  const Parameters& p = exact.placement.parameters;
  const mpq_class r = *p.radius, h = *p.spacing, c = p.angle_cosine;
  BOOST_TEST(multiple_below_pi(p.angle_multiple, c));
  const mpq_class phi = cosine_of_multiple(p.angle_multiple, c);
  BOOST_TEST((phi > 0 && 2 * phi * phi >= 1));
  const mpq_class chord = cosine_of_multiple(p.chord, c);
  BOOST_TEST((4 * p.chord <= p.angle_multiple && h * h <= 4 * r * r * (1 - chord * chord)));
  BOOST_TEST(((p.beta > 0) != (p.offset > 0)));
  for (const PlacedCell& cell : exact.placement.cells) {
    if (cell.kind == CellKind::S)
      for (int i : {1, 2}) BOOST_TEST((7 * abs(mpq_class(square_of_distance(exact, cell.corners[i], cell.corners[0]) - r * r)) <= h * h));
    if (cell.kind == CellKind::S) {
      const mpq_class base = square_of_distance(exact, cell.corners[1], cell.corners[2]);
      BOOST_TEST((h * h <= base && 4 * base <= 9 * h * h));
    }
    if (cell.kind != CellKind::T) continue;
    const auto [v, x, y] = cell.corners;
    const bool opens = exact.placement.points[x].kind == PointKind::projection;
    const int m = opens ? x : y, a = opens ? y : x;
    BOOST_TEST((7 * abs(mpq_class(square_of_distance(exact, a, v) - r * r)) <= h * h));
    const mpq_class d = square_of_distance(exact, a, m);
    if (p.beta > 0) {
      const mpq_class t = cosine_of_multiple(p.beta, c);
      BOOST_TEST((square_of_distance(exact, a, v) - d >= t * t * square_of_distance(exact, a, v)));
    } else {
      const mpq_class t = cosine_of_multiple(p.offset, c);
      BOOST_TEST((d <= 4 * r * r * (1 - t * t)));
    }
  }
}

void check_refutation(const Input& input, const char* share, const std::string& statement) {
  BOOST_TEST_CONTEXT(statement << " with beta = " << share << " phi") {
    const Complex complex = build_complex(input).complex;
    const Placement placement = placed(complex, paper_with(share), 1000);
    BOOST_REQUIRE(placement.refutation);
    const Refutation& refutation = *placement.refutation;
    BOOST_REQUIRE(refutation.statement == statement);
    BOOST_TEST((placement.claims == std::vector<std::string>{"H-angle", "H-ball", "H-offset", "H-chord", "L1", "L21"}));
    const ExactPlacement exact(complex, placement);
    BOOST_CHECK_NO_THROW(exact.require_points());
    check_hypotheses(exact);
    // Nothing but the vertices and corners of cells.
    std::set<int> used;
    for (const PlacedCell& cell : placement.cells) used.insert(cell.corners.begin(), cell.corners.end());
    for (int i = static_cast<int>(complex.vertices.size()); i < static_cast<int>(placement.points.size()); ++i) BOOST_TEST(used.count(i) == 1);
    const PlacedCell& refuted = placement.cells.at(refutation.cells.at(0));
    const ExactCell cell(exact, refuted);
    if (statement == "L5") {
      const PlacedCell& other = placement.cells[refutation.cells.at(1)];
      const auto [v, m, a] = refuted.corners;
      const auto [v2, a2, m2] = other.corners;
      const auto turn = [&](int x, int y) {
        const Rational3 normal = facet_normal(exact.complex, exact.complex.facets[refuted.facet]);
        return sgn(mpq_class(scalar(normal, times(minus(exact.points[x], exact.points[v]), minus(exact.points[y], exact.points[v])))));
      };
      BOOST_TEST((v == v2 && turn(m, m2) > 0 && turn(a, a2) <= 0));
      BOOST_TEST((refutation.values.at(0) == cell.power(m2)));
    } else if (statement == "L18") {
      const int below = refutation.points.at(0), above = refutation.points.at(1);
      BOOST_TEST((cell.height(below) < 0 && cell.height(above) > 0));
      BOOST_TEST((refutation.values.at(0) == cell.power(below) / (2 * cell.height(below))));
      BOOST_TEST((refutation.values.at(1) == cell.power(above) / (2 * cell.height(above))));
      BOOST_TEST((refutation.values[0] > refutation.values[1]));
    } else {
      BOOST_TEST((refutation.values.at(0) == cell.power(refutation.points.at(0)) && refutation.values[0] < 0));
    }
    // An independent opinion: is the triangle a face of the Delaunay tetrahedralization of these points alone?
    if (statement != "L18") return;
    DelaunayTetrahedralization delaunay;
    for (int i = 0; i < static_cast<int>(placement.points.size()); ++i) delaunay.insert(i, placement.points[i].position);
    BOOST_TEST(delaunay.dimension() == 3);
    const auto [a, b, c] = refuted.corners;
    BOOST_TEST(!delaunay.face(a, b, c).exists);
  }
}

}  // namespace

BOOST_AUTO_TEST_SUITE(global)

BOOST_AUTO_TEST_CASE(parameters_are_data) {
  const GlobalRule printed = paper_rule(), third = paper_rule(mpq_class(1, 3)), quarter = paper_rule(mpq_class(1, 4)), odd = paper_rule(mpq_class(2, 5));
  BOOST_TEST((printed.angle_multiple == 12 && printed.beta == 0 && printed.chord == 3));
  BOOST_TEST((third.angle_multiple == 12 && third.beta == 4 && third.chord == 3));
  BOOST_TEST((quarter.angle_multiple == 12 && quarter.beta == 3 && quarter.chord == 3));
  BOOST_TEST((odd.angle_multiple == 20 && odd.beta == 8 && odd.chord == 5));
  BOOST_TEST((repaired_rule().beta == 4 && repaired_rule().chord == 1 && repaired_rule().facet_angles));
  for (const char* share : {"0", "-1/3", "1/2", "1", "1/17", "1/1000000007"}) BOOST_CHECK_THROW(paper_rule(mpq_class(share)), std::invalid_argument);
}

BOOST_AUTO_TEST_CASE(sizes_are_those_of_the_theory) {
  const Complex complex = build_complex(w3()).complex;
  const Features features = compute_features(complex);
  // delta^2 = 200/801, phi = 44.7106 degrees, omega = 2.0236 degrees (at vertex 1), alpha = 2.862 degrees.
  const double unit = std::ldexp(1.0, complex.scale), degree = std::acos(-1.0) / 180;
  const GlobalSizes paper = global_sizes(features, paper_rule(mpq_class(1, 3))), repaired = global_sizes(features, repaired_rule());
  const mpq_class r = mpq_class(paper.radius) * power_of_two(complex.scale);
  BOOST_TEST((9 * r * r <= mpq_class(200, 801)));
  BOOST_TEST(std::abs(9 * mpq_class(r * r).get_d() / (200.0 / 801) - 1) < 1e-8);
  BOOST_TEST(paper.radius == repaired.radius);
  BOOST_TEST(std::abs(12 * std::acos(paper.angle_cosine.get_d()) / degree - 44.7106) < 1e-3);
  BOOST_TEST(std::abs(12 * std::acos(repaired.angle_cosine.get_d()) / degree - 2.0236) < 1e-3);
  BOOST_TEST(std::abs(std::asin(paper.offset / paper.radius) / degree - 44.7106 / 3) < 1e-3);
  BOOST_TEST(std::abs(paper.greatest_spacing - 2 * paper.offset * std::sin(2.8624 * degree / 2)) < 1e-4 * paper.greatest_spacing);
  BOOST_TEST(repaired.greatest_spacing * unit < 2 * repaired.offset * unit * std::sin(2.8624 * degree / 2) * 0.628);
  // A cube's facets are squares: delta is the edge, not the distance to a diagonal.
  const Complex cube = build_complex(small_inputs()[3].input).complex;
  BOOST_TEST(std::abs(compute_features(cube).separation * std::ldexp(1.0, cube.scale) - 1) < 1e-8);
}

BOOST_AUTO_TEST_CASE(the_paper_stays_refuted) {
  for (const Input& input : {w2(), w3(), g3()}) check_refutation(input, "", "L5");
  for (const char* share : {"1/3", "1/4"}) {
    check_refutation(w2(), share, "L10");
    check_refutation(w3(), share, "L18");
    check_refutation(g3(), share, "L18");
    check_refutation(w3_prime(), share, "L18");
  }
  check_refutation(w3_prime(), "1/6", "L18");
  check_refutation(w3(), "1/6", "L10");
}

BOOST_AUTO_TEST_CASE(repaired_conforms_and_keeps_its_sizes) {
  const Input pierced = InputMaker().vertices({{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}, {2, 2, 0}}).facet({{0, 1, 2, 3}, {4}});
  for (const Input& input : {tetrahedron(), pierced, w2()}) {
    const Complex complex = build_complex(input).complex;
    if (complex.vertices.size() == 4 && complex.facets.size() == 2) {
      // W2 needs billions of points: the estimate says so before any facet is filled.
      SilentProgress progress;
      BOOST_CHECK_THROW(place_global(complex, compute_features(complex), repaired_rule(), {3'000'000, 1}, progress), LimitReached);
      BOOST_TEST(progress.estimate > 1e9);
      continue;
    }
    const Placement placement = placed(complex, repaired_rule());
    BOOST_TEST((!placement.refutation && placement.claims == repaired_rule().claims));
    const ExactPlacement exact(complex, placement);
    BOOST_CHECK_NO_THROW(exact.require_points());
    BOOST_CHECK_NO_THROW(exact.require_tiling());
    check_hypotheses(exact);
    const mpq_class h = *placement.parameters.spacing;
    for (const PlacedRow& row : placement.rows)
      for (std::size_t i = 0; i + 1 < row.points.size(); ++i) {
        const mpq_class w = square_of_distance(exact, row.points[i], row.points[i + 1]);
        BOOST_TEST((h * h <= w && 4 * w <= 9 * h * h));
        for (const auto& protector : row.protectors) BOOST_TEST((square_of_distance(exact, protector.points[i], protector.points[i + 1]) == w));
      }
    for (const PlacedCell& cell : placement.cells)
      if (cell.kind == CellKind::C) BOOST_TEST((256 * ExactCell(exact, cell).square_of_radius() <= 289 * h * h));
    // Every inner point was a circumcentre of points before it.
    std::size_t interior = 0;
    for (const PlacedPoint& point : placement.points) interior += point.kind == PointKind::interior;
    BOOST_TEST((placement.insertions.size() == interior && interior > 0));
    for (const Insertion& insertion : placement.insertions) {
      for (int corner : insertion.corners) BOOST_TEST((corner < insertion.point && placement.points[corner].carrier == insertion.facet));
      const ExactCell triangle(exact, {insertion.facet, insertion.corners, CellKind::C, -1, {}});
      BOOST_TEST((triangle.square_of_radius() > h * h));
      BOOST_TEST((4096 * squared(minus(triangle.centre(), exact.points[insertion.point])) <= h * h));
    }
    const Placement again = placed(complex, repaired_rule(), 0, 2);
    BOOST_TEST(again.points.size() == placement.points.size());
    for (std::size_t i = 0; i < placement.points.size(); ++i) BOOST_TEST((again.points[i].position == placement.points[i].position));
  }
}

BOOST_AUTO_TEST_CASE(limits) {
  const Complex complex = build_complex(tetrahedron()).complex;
  try {
    placed(complex, repaired_rule(), 500);
    BOOST_ERROR("no limit was reached");
  } catch (const LimitReached& limit) {
    BOOST_TEST(limit.what() == std::string("max-points"));
  }
  struct Impatient : SilentProgress {
    bool stop_requested(long points) override { return points > 100; }
  } progress;
  BOOST_CHECK_THROW(place_global(complex, compute_features(complex), repaired_rule(), {0, 2}, progress), LimitReached);
}

BOOST_AUTO_TEST_SUITE_END()
