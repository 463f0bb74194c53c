// SPDX-License-Identifier: GPL-3.0-or-later
// L0a and L0b, Lemmas 1.1 and 1.2 of the paper, on random points with ties: an edge or triangle is in some Delaunay subdivision if and only
// if a sphere through its vertices has no point inside, and in every one if no other point is on it either. Spheres are sought here by
// linear inequalities in rationals, subdivisions are CGAL's.
#include <boost/test/unit_test.hpp>
#include <cstdlib>

#include "tests/core/complex/triangulation_rules.h"
#include "tests/oracle/subdivisions.h"
#include "tests/support/rationals.h"
#include "tests/support/random_inputs.h"

using namespace confidel;
using namespace confidel::test;

namespace {

/// coefficients . x <= bound, or < bound.
struct Inequality {
  std::vector<mpq_class> coefficients;
  mpq_class bound;
  bool strict;
};

/// Has the system a solution? Fourier and Motzkin's elimination.
bool solvable(std::vector<Inequality> system) {
  while (!system.empty() && !system.front().coefficients.empty()) {
    std::vector<Inequality> upper, lower, next;
    for (Inequality& row : system) {
      const mpq_class last = row.coefficients.back();
      row.coefficients.pop_back();
      if (last == 0) {
        next.push_back(std::move(row));
        continue;
      }
      const mpq_class scale = abs(last);
      for (mpq_class& value : row.coefficients) value /= scale;
      row.bound /= scale;
      (last > 0 ? upper : lower).push_back(std::move(row));
    }
    for (const Inequality& a : upper)
      for (const Inequality& b : lower) {
        Inequality sum{a.coefficients, a.bound + b.bound, a.strict || b.strict};
        for (std::size_t i = 0; i < sum.coefficients.size(); ++i) sum.coefficients[i] += b.coefficients[i];
        next.push_back(std::move(sum));
      }
    system = std::move(next);
  }
  return std::all_of(system.begin(), system.end(), [](const Inequality& row) { return row.strict ? row.bound > 0 : row.bound >= 0; });
}

/// Is there a sphere through the face's points with no other point inside (strict: nor on it)? Its centre c satisfies
/// 2 (x-a).c <= |x|^2 - |a|^2 for the others, = for the face's own.
bool has_empty_sphere(const std::vector<Rational3>& points, const std::vector<int>& face, bool strict) {
  const Rational3& a = points[face[0]];
  std::vector<Inequality> system;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (static_cast<int>(i) == face[0]) continue;
    const Rational3 u = scaled(2, minus(points[i], a));
    const mpq_class bound = squared(points[i]) - squared(a);
    const bool own = std::find(face.begin(), face.end(), static_cast<int>(i)) != face.end();
    system.push_back({{u[0], u[1], u[2]}, bound, strict && !own});
    if (own) system.push_back({{-u[0], -u[1], -u[2]}, -bound, false});
  }
  return solvable(std::move(system));
}

std::vector<Rational3> random_points(Random& random) {
  const int count = random.integer(4, 8), greatest = random.integer(1, 4);
  const bool flat = random.one_in(6);
  std::set<Rational3> points;
  const int cells = (greatest + 1) * (greatest + 1) * (flat ? 1 : greatest + 1);
  while (static_cast<int>(points.size()) < std::min(count, cells))
    points.insert({random.integer(0, greatest), random.integer(0, greatest), flat ? 0 : random.integer(0, greatest)});
  return {points.begin(), points.end()};
}

bool proper(const std::vector<Rational3>& points, const std::vector<int>& face) {
  return face.size() == 2 || !is_zero(times(minus(points[face[1]], points[face[0]]), minus(points[face[2]], points[face[0]])));
}

struct Counts {
  long faces = 0, always = 0, sometimes = 0, never = 0;
};

/// All edges and triangles of one point set.
void compare(const std::vector<Rational3>& points, std::uint64_t seed, Counts& counts) {
  const SubdivisionFaces first = subdivision(points, {}, seed), second = subdivision(points, {}, seed + 1);
  const auto in = [](const SubdivisionFaces& faces, const std::vector<int>& face) {
    return face.size() == 2 ? faces.edges.count({face[0], face[1]}) == 1 : faces.triangles.count({face[0], face[1], face[2]}) == 1;
  };
  std::vector<std::vector<int>> faces;
  const int count = static_cast<int>(points.size());
  for (int a = 0; a < count; ++a)
    for (int b = a + 1; b < count; ++b) {
      faces.push_back({a, b});
      for (int c = b + 1; c < count; ++c)
        if (proper(points, {a, b, c})) faces.push_back({a, b, c});
    }
  for (const std::vector<int>& face : faces) {
    ++counts.faces;
    const bool empty = has_empty_sphere(points, face, false), strictly = has_empty_sphere(points, face, true);
    BOOST_REQUIRE(empty || !strictly);
    for (const SubdivisionFaces* faces_of_one : {&first, &second}) {
      if (strictly) BOOST_TEST(in(*faces_of_one, face), "strictly empty, and not in a subdivision");
      if (!empty) BOOST_TEST(!in(*faces_of_one, face), "not empty, and in a subdivision");
    }
    counts.always += strictly;
    counts.never += !empty;
    if (!empty || strictly) continue;
    // A tie: some subdivision has the face. Trying one in seven is enough.
    if (++counts.sometimes % 7 == 0) BOOST_TEST(in(subdivision(points, face, seed), face), "empty, and not in the subdivision that is made for it");
  }
}

}  // namespace

BOOST_AUTO_TEST_SUITE(first_lemmas)

BOOST_AUTO_TEST_CASE(empty_spheres_and_faces_of_subdivisions) {
  const char* factor = std::getenv("CONFIDEL_ROUNDS");
  const long rounds = 1000 * (factor != nullptr ? std::atol(factor) : 1);
  Counts counts;
  for (long round = 0; round < rounds; ++round) {
    Random random(0xd1b54a32d192ed03ULL * static_cast<std::uint64_t>(round + 1));
    const auto points = random_points(random);
    compare(points, static_cast<std::uint64_t>(round), counts);
  }
  BOOST_TEST_MESSAGE(counts.faces << " edges and triangles: " << counts.always << " in every subdivision, " << counts.sometimes << " in some by ties, " << counts.never << " in none");
  BOOST_TEST(counts.always > rounds);
  BOOST_TEST(counts.sometimes > rounds);
  BOOST_TEST(counts.never > rounds);
}

BOOST_AUTO_TEST_CASE(the_cube) {
  // One sphere: every edge, face diagonal and space diagonal is in some subdivision, only the edges in all.
  std::vector<Rational3> cube;
  for (int i = 0; i < 8; ++i) cube.push_back({i & 1, i >> 1 & 1, i >> 2 & 1});
  BOOST_TEST(has_empty_sphere(cube, {0, 1}, true));
  BOOST_TEST(!has_empty_sphere(cube, {0, 3}, true));
  BOOST_TEST(has_empty_sphere(cube, {0, 3}, false));
  BOOST_TEST(has_empty_sphere(cube, {0, 7}, false));
  cube.push_back({mpq_class(1, 2), mpq_class(1, 2), mpq_class(1, 2)});
  BOOST_TEST(!has_empty_sphere(cube, {0, 7}, false));
}

BOOST_AUTO_TEST_SUITE_END()
