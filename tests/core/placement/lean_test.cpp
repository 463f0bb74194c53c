// SPDX-License-Identifier: GPL-3.0-or-later
// The lean strategy: nothing where nothing is needed, local protection where refinement would not end, and the real checker's verdict.
#include "core/placement/lean.h"

#include <unistd.h>

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <optional>
#include <random>

#include "core/complex/merge.h"
#include "proofs/certificate/writer.h"
#include "tests/support/exact_placement.h"
#include "tests/support/placing.h"
#include "tests/support/random_inputs.h"
#include "tests/support/small_inputs.h"

using namespace confidel;
using namespace confidel::test;

namespace {

constexpr double pi = 3.14159265358979324;

// The same numbers everywhere: std::uniform_real_distribution may differ.
class Sequence {
 public:
  explicit Sequence(unsigned seed) : raw_(seed) {}
  double next(double low, double high) { return low + (high - low) * static_cast<double>(raw_() >> 11) * 0x1p-53; }

 private:
  std::mt19937_64 raw_;
};

Double3 at(const Position& p) { return {p[0], p[1], p[2]}; }

// Do the cones over the segments ab and cd cross?
bool cones_cross(const Position& a, const Position& b, const Position& c, const Position& d) {
  const Double3 n = cross(at(a), at(b)), m = cross(at(c), at(d)), line = cross(n, m);
  for (double sign : {1.0, -1.0}) {
    const Double3 x = sign * line;
    if (dot(cross(at(a), x), n) > 0 && dot(cross(x, at(b)), n) > 0 && dot(cross(at(c), x), m) > 0 && dot(cross(x, at(d)), m) > 0) return true;
  }
  return false;
}

// Random triangles that share one vertex.
Input star(unsigned seed, int count) {
  Sequence sequence(seed);
  const auto direction = [&] {
    for (;;) {
      const double x = sequence.next(-1, 1), y = sequence.next(-1, 1), z = sequence.next(-1, 1), square = x * x + y * y + z * z;
      if (square > 0.1 && square < 1) return Position{x, y, z};
    }
  };
  std::vector<Position> vertices{{0, 0, 0}};
  std::vector<std::vector<int>> facets;
  while (static_cast<int>(facets.size()) < count) {
    const Position a = direction(), b = direction();
    if (dot(at(a), at(b)) < 0.07 * length(at(a)) * length(at(b))) continue;
    bool free = true;
    for (std::size_t i = 1; i < vertices.size(); i += 2) free = free && !cones_cross(a, b, vertices[i], vertices[i + 1]);
    if (!free) continue;
    const int first = static_cast<int>(vertices.size());
    facets.push_back({0, first, first + 1});
    vertices.push_back(a);
    vertices.push_back(b);
  }
  return triangles(vertices, facets);
}

// Random triangles that share one edge.
Input blades(unsigned seed, int count) {
  Sequence sequence(seed);
  std::vector<Position> vertices{{0, 0, 0}, {0, 0, 1}};
  std::vector<std::vector<int>> facets;
  for (int i = 0; i < count; ++i) {
    const double angle = sequence.next(0, 2 * pi), away = sequence.next(0.3, 1), height = sequence.next(-0.3, 1.3);
    facets.push_back({0, 1, static_cast<int>(vertices.size())});
    vertices.push_back({away * std::cos(angle), away * std::sin(angle), height});
  }
  return triangles(vertices, facets);
}

Input icosahedron() {
  const double g = (1 + std::sqrt(5.0)) / 2;
  const std::vector<Position> vertices{{-1, g, 0}, {1, g, 0}, {-1, -g, 0}, {1, -g, 0}, {0, -1, g}, {0, 1, g}, {0, -1, -g}, {0, 1, -g}, {g, 0, -1}, {g, 0, 1}, {-g, 0, -1}, {-g, 0, 1}};
  return triangles(vertices, {{0, 11, 5}, {0, 5, 1}, {0, 1, 7}, {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4}, {11, 10, 2}, {10, 7, 6}, {7, 1, 8},
                              {3, 9, 4}, {3, 4, 2}, {3, 2, 6}, {3, 6, 8}, {3, 8, 9}, {4, 9, 5}, {2, 4, 11}, {6, 2, 10}, {8, 6, 7}, {9, 8, 1}});
}

std::string certificate(const Complex& complex, const Placement& placement) {
  const std::string path = "/tmp/confidel-lean-test-" + std::to_string(getpid()) + ".cert";
  write_certificate(path, path + ".part", complex, placement, {});
  std::ifstream file(path, std::ios::binary);
  std::string bytes{std::istreambuf_iterator<char>(file), {}};
  const std::string command = std::string(CONFIDEL_BINARY_DIR) + "/confidel-check " + path + " > " + path + ".verdict";
  BOOST_TEST(std::system(command.c_str()) == 0);
  std::ifstream said(path + ".verdict");
  const std::string verdict{std::istreambuf_iterator<char>(said), {}};
  BOOST_TEST((verdict.find("s VERIFIED") != std::string::npos));
  std::remove(path.c_str());
  std::remove((path + ".verdict").c_str());
  return bytes;
}

// Places, checks, and returns the number of Steiner points.
long steiner(const Complex& complex, LeanReport* report = nullptr) {
  SilentProgress progress;
  const Placement placement = place_lean(complex, compute_features(complex), {}, progress, report);
  certificate(complex, placement);
  return static_cast<long>(placement.points.size() - complex.vertices.size());
}

// Graded's number of Steiner points, accepted too; nothing if it needs many.
std::optional<long> steiner_of_graded(const Complex& complex) {
  try {
    const Placement placement = place(complex, Strategy::graded, 20000);
    certificate(complex, placement);
    return static_cast<long>(placement.points.size() - complex.vertices.size());
  } catch (const LimitReached&) {
    return std::nullopt;
  }
}

long steiner(const Input& input, LeanReport* report = nullptr) { return steiner(build_complex(input).complex, report); }

}  // namespace

BOOST_AUTO_TEST_SUITE(lean)

BOOST_AUTO_TEST_CASE(nothing_where_nothing_is_needed) {
  for (const NamedInput& named : small_inputs())
    if (named.name == "cube of squares" || named.name == "tetrahedron") BOOST_TEST(steiner(named.input) == 0, named.name);
  for (double angle : {90.0, 30.0, 5.0, 1.0, 0.1}) BOOST_TEST(steiner(wedge(angle, 0.5)) == 0, angle << " degrees");
  BOOST_TEST(steiner(icosahedron()) == 0);
}

BOOST_AUTO_TEST_CASE(triangles_at_one_vertex) {
  for (unsigned seed : {1u, 2u, 3u}) {
    LeanReport report;
    const long points = steiner(star(seed, 14), &report);
    BOOST_TEST_MESSAGE("star " << seed << ": " << points << " points, " << report.protected_vertices << " balls, " << report.protected_segments << " rows");
    BOOST_TEST(!report.fell_back);
    BOOST_TEST(points < 1500);
  }
}

BOOST_AUTO_TEST_CASE(blades_at_one_edge) {
  for (unsigned seed : {1u, 2u}) {
    LeanReport report;
    const long points = steiner(blades(seed, 12), &report);
    BOOST_TEST_MESSAGE("blades " << seed << ": " << points << " points, " << report.protected_vertices << " balls, " << report.protected_segments << " rows");
    BOOST_TEST(!report.fell_back);
    BOOST_TEST(report.protected_segments > 0);
    BOOST_TEST(points < 12000);
  }
}

// Two blades at a very small angle: matching points keep the number far below what the angle suggests.
BOOST_AUTO_TEST_CASE(blades_at_a_small_angle) {
  std::vector<Position> vertices{{0, 0, 0}, {0, 0, 1}};
  std::vector<std::vector<int>> facets;
  const double degrees[] = {0, 0.15, 40, 95, 96, 150, 200, 200.3, 260, 310};
  for (int i = 0; i < 10; ++i) {
    const double angle = degrees[i] * pi / 180, away = 0.4 + 0.13 * (i * 7 % 5);
    vertices.push_back({away * std::cos(angle), away * std::sin(angle), -0.2 + 0.3 * (i * 3 % 5)});
    facets.push_back({0, 1, i + 2});
  }
  LeanReport report;
  const long points = steiner(triangles(vertices, facets), &report);
  BOOST_TEST_MESSAGE("small angle: " << points << " points, " << report.protected_vertices << " balls, " << report.protected_segments << " rows");
  BOOST_TEST(!report.fell_back);
  BOOST_TEST(points < 8000);
}

BOOST_AUTO_TEST_CASE(both_strategies_are_accepted_and_deterministic) {
  std::vector<Input> inputs{star(4, 8), blades(4, 4), wedge(10, 0.3)};
  for (const Input& input : inputs) {
    const Complex complex = build_complex(input).complex;
    const std::string lean = certificate(complex, place(complex, Strategy::lean));
    BOOST_TEST((lean == certificate(complex, place(complex, Strategy::lean, 0, 2))));
    certificate(complex, place(complex, Strategy::graded));
  }
}

// Four triangles around a pole are one square with an isolated vertex.
BOOST_AUTO_TEST_CASE(merged_pole) {
  const Input pyramid = triangles({{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}, {1, 1, 0}, {1, 1, 1}}, {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}, {0, 1, 5}});
  Complex complex = build_complex(pyramid).complex;
  merge_coplanar_facets(complex);
  BOOST_REQUIRE(complex.facets.size() == 2u);
  BOOST_TEST(complex.facets[0].isolated.size() + complex.facets[1].isolated.size() == 1u);
  steiner(complex);
}

// Two coplanar triangles and a third at their common edge: the edge belongs to three and stays. A further way around it merges them.
BOOST_AUTO_TEST_CASE(merged_edge_that_others_share) {
  const Input input = triangles({{0, 0, 0}, {1, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}, {0.5, 0, 1}, {1, 1, 0}},
                                {{0, 1, 6}, {1, 2, 6}, {2, 3, 6}, {3, 4, 6}, {4, 0, 6}, {1, 6, 5}});
  Complex complex = build_complex(input).complex;
  merge_coplanar_facets(complex);
  BOOST_REQUIRE(complex.facets.size() == 2u);
  BOOST_TEST(complex.facets[0].constraints.size() + complex.facets[1].constraints.size() == 1u);
  steiner(complex);
}

// Flattened: angles down to some hundredths of a degree.
BOOST_AUTO_TEST_CASE(squashed_complexes) {
  for (std::uint64_t seed : {1, 2, 3, 4, 5, 6, 7, 8, 9, 10}) {
    Random random(seed);
    Input input = random_subcomplex(random, 8, false);
    for (InputVertex& vertex : input.vertices) vertex.position[2] = std::ldexp(vertex.position[2], -static_cast<int>(4 + seed % 4 * 2));
    const Complex complex = build_complex(input).complex;
    LeanReport report;
    const long points = steiner(complex, &report);
    BOOST_TEST_MESSAGE("squashed " << seed << ": " << points << " points, " << report.protected_vertices << " balls, " << report.protected_segments << " rows");
    BOOST_TEST(!report.fell_back);
    BOOST_TEST(points < 1000);
  }
}

// All squares between the points of a 3 x 3 x 2 grid, and equal blades at equal angles: everything ties with everything.
BOOST_AUTO_TEST_CASE(ties) {
  std::vector<Position> vertices;
  std::vector<std::vector<int>> squares;
  const auto id = [](int x, int y, int z) { return x + 3 * y + 9 * z; };
  for (int z = 0; z < 2; ++z)
    for (int y = 0; y < 3; ++y)
      for (int x = 0; x < 3; ++x) {
        vertices.push_back({1. * x, 1. * y, 1. * z});
        if (x < 2 && y < 2) squares.push_back({id(x, y, z), id(x + 1, y, z), id(x + 1, y + 1, z), id(x, y + 1, z)});
        if (x < 2 && z < 1) squares.push_back({id(x, y, z), id(x + 1, y, z), id(x + 1, y, z + 1), id(x, y, z + 1)});
        if (y < 2 && z < 1) squares.push_back({id(x, y, z), id(x, y + 1, z), id(x, y + 1, z + 1), id(x, y, z + 1)});
      }
  BOOST_TEST(steiner(triangles(vertices, squares)) == 0);
  // The squares' diagonals: right angles at everything.
  std::vector<std::vector<int>> halves;
  for (const auto& s : squares) halves.insert(halves.end(), {{s[0], s[1], s[2]}, {s[0], s[2], s[3]}});
  LeanReport report;
  steiner(triangles(vertices, halves), &report);
  BOOST_TEST(!report.fell_back);
  for (int count : {4, 6, 12}) {
    std::vector<Position> corners{{0, 0, 0}, {0, 0, 1}};
    std::vector<std::vector<int>> leaves;
    for (int i = 0; i < count; ++i) {
      const double angle = 2 * pi * i / count;
      corners.push_back({std::round(64 * std::cos(angle)), std::round(64 * std::sin(angle)), 0.5});
      leaves.push_back({0, 1, i + 2});
    }
    steiner(triangles(corners, leaves), &report);
    BOOST_TEST(!report.fell_back);
  }
}

// A plate with a hole, a slit and a vertex inside, on which blades stand, and an edge that hovers over it.
BOOST_AUTO_TEST_CASE(holes_and_interior_vertices) {
  for (const double height : {1.0, 0.05}) {
    InputMaker maker;
    maker.vertices({{0, 0, 0}, {8, 0, 0}, {8, 8, 0}, {0, 8, 0}, {2, 2, 0}, {4, 2, 0}, {3, 4, 0}, {5, 5, 0}, {7, 5, 0}, {6, 2, 0},
                    {6, 5, 2}, {6, 2.5, 2}, {5.5, 2, 2}, {5.2, 5.3, 3}, {5, 6, 3}, {1, 1, height}, {7, 1, 2 * height}})
        .facet({{0, 1, 2, 3}, {4, 5, 6}, {7, 8}, {9}}, {{3, 2.5, 0}})
        .facet({{7, 8, 10}})
        .facet({{9, 11, 12}})
        .facet({{7, 13, 14}})
        .segment(15, 16);
    LeanReport report;
    const long points = steiner(maker, &report);
    BOOST_TEST_MESSAGE("plate: " << points << " points, " << report.protected_vertices << " balls, " << report.protected_segments << " rows");
    BOOST_TEST(!report.fell_back);
  }
}

// Small angles in the plane need no protection: segments are cut at equal distances from their common vertex.
BOOST_AUTO_TEST_CASE(stars_in_the_plane) {
  for (double degrees : {5.0, 1.0, 0.1}) {
    std::vector<Position> vertices{{0, 0, 0}};
    std::vector<Pair> edges;
    for (int i = 0; i < 5; ++i) {
      const double angle = pi / 180 * degrees * i, size = 1 + 0.37 * (i * 7 % 5);
      vertices.push_back({size * std::cos(angle), size * std::sin(angle), 0});
      edges.push_back({0, i + 1});
    }
    InputMaker maker(2);
    maker.vertices(vertices);
    for (const auto& [a, b] : edges) maker.segment(a, b);
    LeanReport report;
    const long points = steiner(maker, &report);
    BOOST_TEST_MESSAGE(degrees << " degrees: " << points << " points");
    BOOST_TEST(!report.fell_back);
    BOOST_TEST(points < 200);
  }
}

BOOST_AUTO_TEST_CASE(fewer_points_than_graded) {
  for (std::uint64_t seed = 1; seed <= 24; ++seed) {
    const NamedInput named = random_input(seed);
    BOOST_TEST_CONTEXT(named.name) {
      const Complex complex = build_complex(named.input).complex;
      LeanReport report;
      const long points = steiner(complex, &report);
      BOOST_TEST(!report.fell_back, report.reason);
      if (const auto graded = steiner_of_graded(complex)) BOOST_TEST(points <= *graded);
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()
