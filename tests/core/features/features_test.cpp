// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/features/features.h"

#include <tbb/global_control.h>

#include <boost/test/unit_test.hpp>
#include <cstring>
#include <limits>
#include <numbers>
#include <random>

#include "tests/core/features/brute_force.h"
#include "tests/support/complexes.h"

using namespace confidel;
using namespace confidel::support;

namespace {

bool is_lower_bound(double value, const mpq_class& squared) {
  if (squared < 0) return value == std::numeric_limits<double>::infinity();
  if (!(value >= 0) || std::isinf(value)) return false;
  const mpq_class exact(value);
  const mpq_class accuracy(999999999, 1000000000);
  return exact * exact <= squared && exact * exact >= accuracy * accuracy * squared;
}

bool is_lower_bound(double value, long double angle) {
  return value >= 0 && value <= angle && value >= angle * (1 - 1e-6L);
}

/// Everything in features.h against the brute force.
void check(const Complex& complex, const std::string& name) {
  const Features features = compute_features(complex);
  const auto expected = brute_force::compute(complex);
  BOOST_TEST_CONTEXT(name) {
    for (std::size_t v = 0; v < complex.vertices.size(); ++v) {
      BOOST_TEST(is_lower_bound(features.vertex_distance[v], expected.vertex_distance[v]),
                 "delta of " << v << ": " << features.vertex_distance[v] << " for "
                             << std::sqrt(expected.vertex_distance[v].get_d()));
    }
    for (std::size_t e = 0; e < complex.segments.size(); ++e) {
      BOOST_TEST(is_lower_bound(features.segment_distance[e], expected.segment_distance[e]),
                 "g of " << e << ": " << features.segment_distance[e] << " for "
                         << std::sqrt(expected.segment_distance[e].get_d()));
      for (int side = 0; side < 2; ++side) {
        BOOST_TEST(
            is_lower_bound(features.segment_angle[e][side], expected.segment_angle[e][side]),
            "theta of " << e << ": " << features.segment_angle[e][side] << " for " << expected.segment_angle[e][side]);
        BOOST_TEST(
            is_lower_bound(features.facet_angle[e][side], expected.facet_angle[e][side]),
            "omega of " << e << ": " << features.facet_angle[e][side] << " for " << expected.facet_angle[e][side]);
      }
      BOOST_TEST(is_lower_bound(features.dihedral_angle[e], expected.dihedral_angle[e]),
                 "alpha of " << e << ": " << features.dihedral_angle[e] << " for " << expected.dihedral_angle[e]);
    }
  }
}

using Generator = std::mt19937_64;

int integer(Generator& generator, int low, int high) {
  return low + static_cast<int>(generator() % static_cast<std::uint64_t>(high - low + 1));
}

double real(Generator& generator) { return std::ldexp(static_cast<double>(generator() >> 11), -52) - 1; }

/// Triangles that share vertices and edges by chance, hanging segments, vertices of their own. They may cross or
/// overlap: the distances are then 0, for both computations.
Complex random_soup(Generator& generator, const std::vector<Coordinates>& vertices, int triangles, int hanging) {
  const int last = static_cast<int>(vertices.size()) - 1;
  const auto positions = points(vertices);
  std::set<std::array<VertexId, 3>> chosen;
  for (int attempt = 0; attempt < triangles; ++attempt) {
    std::array<VertexId, 3> t{integer(generator, 0, last), integer(generator, 0, last), integer(generator, 0, last)};
    std::sort(t.begin(), t.end());
    if (t[0] == t[1] || t[1] == t[2]) continue;
    if (plane_normal(positions[t[0]], positions[t[1]], positions[t[2]]) == IntegerVector{}) continue;
    chosen.insert(t);
  }
  std::vector<Segment> segments;
  for (int attempt = 0; attempt < hanging; ++attempt) {
    const Segment s{integer(generator, 0, last), integer(generator, 0, last)};
    if (s[0] != s[1]) segments.push_back(s);
  }
  return triangle_complex(vertices, {chosen.begin(), chosen.end()}, segments);
}

/// Affine images of an octagon with a vertex inside: as one fan, with diagonals as constraints, with the vertex
/// isolated or at the end of a dangling constraint.
Complex random_polygons(Generator& generator, int facets, double offset) {
  const std::array<std::array<int, 2>, 9> octagon{
      {{1, 0}, {2, 0}, {3, 1}, {3, 2}, {2, 3}, {1, 3}, {0, 2}, {0, 1}, {1, 2}}};
  std::vector<Coordinates> vertices;
  std::vector<FacetParts> parts;
  for (int facet = 0; facet < facets; ++facet) {
    std::array<double, 3> origin, u, v;
    for (int k = 0; k < 3; ++k) {
      origin[k] = integer(generator, -40, 40);
      u[k] = integer(generator, -9, 9);
      v[k] = integer(generator, -9, 9);
    }
    if (u[1] * v[2] == u[2] * v[1] && u[2] * v[0] == u[0] * v[2] && u[0] * v[1] == u[1] * v[0]) continue;
    const auto first = static_cast<VertexId>(vertices.size());
    for (const auto& [i, j] : octagon) {
      auto& position = vertices.emplace_back();
      for (int k = 0; k < 3; ++k) position[k] = offset + std::ldexp(origin[k] + i * u[k] + j * v[k], -7);
    }
    std::vector<VertexId> polygon(8);
    for (int i = 0; i < 8; ++i) polygon[i] = first + i;
    const int kind = integer(generator, 0, 3);
    if (kind <= 1) {
      parts.push_back(fan(polygon));
      if (kind == 1) parts.back().constraints.push_back({first, first + integer(generator, 2, 6)});
    } else {
      parts.push_back(fan_around(first + 8, polygon));
      if (kind == 3) {
        parts.back().constraints.push_back({first + integer(generator, 0, 7), first + 8});
        parts.back().isolated.clear();
      }
    }
  }
  // Hanging segments between polygons, some of them at vertices inside of facets.
  std::vector<Segment> hanging;
  const int last = static_cast<int>(vertices.size()) - 1;
  for (int i = 0; i < 3 && last > 9; ++i) {
    const VertexId a = integer(generator, 0, last);
    const VertexId b = (a + integer(generator, 9, last - 9 > 9 ? last - 9 : 9)) % (last + 1);
    if (a / 9 != b / 9) hanging.push_back({a, b});
  }
  return facet_complex(points(vertices), parts, hanging);
}

double degrees(double angle) { return angle * 180 / std::numbers::pi; }

/// Wedges in which everything that is sharp is at the segment 01.
Complex wedge(double tangent) {
  return triangle_complex({{0, 0, 0}, {1, 0, 0}, {0.25, 1, 0}, {0.625, 1, tangent}}, {{0, 1, 2}, {0, 1, 3}});
}

}  // namespace

BOOST_AUTO_TEST_SUITE(features_known)

BOOST_AUTO_TEST_CASE(w3) {
  const Complex complex = triangle_complex({{0, 0, 0}, {20, 0, 0}, {0, 20, 0}, {20, 20, 1}, {10, 10, -14}},
                                           {{0, 1, 2}, {0, 1, 3}, {0, 1, 4}});
  check(complex, "W3");
  const Features features = compute_features(complex);
  double theta = 4, omega = 4, alpha = 4;
  for (std::size_t e = 0; e < complex.segments.size(); ++e) {
    for (int side = 0; side < 2; ++side) {
      theta = std::min(theta, features.segment_angle[e][side]);
      omega = std::min(omega, features.facet_angle[e][side]);
    }
    alpha = std::min(alpha, features.dihedral_angle[e]);
  }
  BOOST_TEST(degrees(theta) == 44.7106, boost::test_tools::tolerance(1e-6));
  BOOST_TEST(degrees(omega) == 2.025, boost::test_tools::tolerance(1e-3));
  BOOST_TEST(degrees(alpha) == 2.862, boost::test_tools::tolerance(1e-3));
  // The smallest delta is that of vertex 3 or of its neighbours: delta^2 = 200/801 is theory.md's minimum over simplex
  // pairs.
  const double least = std::min(*std::min_element(features.vertex_distance.begin(), features.vertex_distance.end()),
                                *std::min_element(features.segment_distance.begin(), features.segment_distance.end()));
  BOOST_TEST(std::ldexp(least, complex.scale) == std::sqrt(200.0 / 801), boost::test_tools::tolerance(1e-8));
}

BOOST_AUTO_TEST_CASE(unit_cube) {
  const std::vector<Coordinates> vertices{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0},
                                          {0, 0, 1}, {1, 0, 1}, {0, 1, 1}, {1, 1, 1}};
  std::vector<FacetParts> facets;
  for (const std::vector<VertexId>& square : std::vector<std::vector<VertexId>>{
           {0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}) {
    facets.push_back(fan(square));
  }
  const Complex complex = facet_complex(points(vertices), facets);
  check(complex, "cube");
  const Features features = compute_features(complex);
  for (const double delta : features.vertex_distance)
    BOOST_TEST(std::ldexp(delta, complex.scale) == 1.0, boost::test_tools::tolerance(1e-9));
  // Six edges end at a corner that a facet's diagonal cuts off: the triangle beyond the diagonal is disjoint from them.
  int cut_off = 0;
  for (const double distance : features.segment_distance) {
    const double unit = std::ldexp(distance, complex.scale);
    cut_off += unit < 0.9;
    BOOST_TEST(unit == (unit < 0.9 ? std::sqrt(0.5) : 1.0), boost::test_tools::tolerance(1e-9));
  }
  BOOST_TEST(cut_off == 6);
  for (std::size_t e = 0; e < complex.segments.size(); ++e) {
    BOOST_TEST(degrees(features.segment_angle[e][0]) == 90.0, boost::test_tools::tolerance(1e-6));
    BOOST_TEST(degrees(features.facet_angle[e][1]) == 90.0, boost::test_tools::tolerance(1e-6));
    BOOST_TEST(degrees(features.dihedral_angle[e]) == 90.0, boost::test_tools::tolerance(1e-6));
  }
}

BOOST_AUTO_TEST_CASE(nothing_near) {
  check(Complex{}, "empty");
  check(facet_complex(points({{1, 2, 3}}), {}), "one vertex");
  check(facet_complex(points({{1, 2, 3}, {3, 2, 1}}), {}, {{0, 1}}), "one segment");
  check(triangle_complex({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}), "one triangle");
}

BOOST_AUTO_TEST_CASE(sharp_wedges) {
  for (const double tangent : {1e-3, 1e-6, 1e-9, 1e-12, 1e-18, 1e-100})
    check(wedge(tangent), "wedge " + std::to_string(tangent));
  const Features features = compute_features(wedge(1e-6));
  BOOST_TEST(features.dihedral_angle[0] == 1e-6, boost::test_tools::tolerance(2e-6));
}

BOOST_AUTO_TEST_CASE(isolated_vertex_and_slit) {
  // A pole stands on the isolated vertex of a square: all around it, the facet is at a right angle; a slanted one is
  // nearer.
  const std::vector<Coordinates> vertices{{-2, -2, 0}, {2, -2, 0}, {2, 2, 0}, {-2, 2, 0}, {0, 0, 0}, {1, 0, 1}};
  check(facet_complex(points(vertices), {fan_around(4, {0, 1, 2, 3})}, {{4, 5}}), "isolated");
  auto slit = fan_around(4, {0, 1, 2, 3});
  slit.isolated.clear();
  slit.constraints.push_back({4, 0});
  const Complex complex = facet_complex(points(vertices), {slit}, {{4, 5}});
  check(complex, "slit");
  const Features features = compute_features(complex);
  const auto constraint =
      std::find(complex.segments.begin(), complex.segments.end(), Segment{0, 4}) - complex.segments.begin();
  BOOST_TEST(degrees(features.dihedral_angle[constraint]) == 180.0, boost::test_tools::tolerance(1e-6));
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(features_random)

BOOST_AUTO_TEST_CASE(soups) {
  Generator generator(20240901);
  for (int round = 0; round < 25; ++round) {
    std::vector<Coordinates> vertices(12);
    for (auto& vertex : vertices) vertex = {real(generator), real(generator), real(generator)};
    check(random_soup(generator, vertices, 8, 3), "soup " + std::to_string(round));
  }
}

BOOST_AUTO_TEST_CASE(grids) {
  // Small integers: ties, parallels, right angles, overlaps, crossings.
  Generator generator(7);
  for (int round = 0; round < 25; ++round) {
    std::set<Coordinates> vertices;
    while (vertices.size() < 11) {
      vertices.insert({1.0 * integer(generator, 0, 3), 1.0 * integer(generator, 0, 3), 1.0 * integer(generator, 0, 2)});
    }
    check(random_soup(generator, {vertices.begin(), vertices.end()}, 7, 3), "grid " + std::to_string(round));
  }
}

BOOST_AUTO_TEST_CASE(disjoint_triangles) {
  Generator generator(31);
  for (int round = 0; round < 2; ++round) {
    std::vector<Coordinates> vertices;
    std::vector<std::array<VertexId, 3>> triangles;
    for (int i = 0; i < 20; ++i) {
      const Coordinates centre{real(generator), real(generator), real(generator)};
      const auto first = static_cast<VertexId>(vertices.size());
      for (int corner = 0; corner < 3; ++corner) {
        auto& vertex = vertices.emplace_back(centre);
        for (double& coordinate : vertex) coordinate += 0.2 * real(generator);
      }
      triangles.push_back({first, first + 1, first + 2});
    }
    check(triangle_complex(vertices, triangles), "disjoint " + std::to_string(round));
  }
}

BOOST_AUTO_TEST_CASE(hubs_and_books) {
  // So many neighbours that they are searched through an index: fans around a vertex, sheets around a segment, some of
  // them very close together, seen from hanging segments too.
  Generator generator(37);
  for (int round = 0; round < 4; ++round) {
    const double spread = round % 2 == 0 ? 1 : std::ldexp(1.0, -7 * round);
    std::vector<Coordinates> vertices{{0, 0, 0}, {0.1, 0.2, 0.9}};
    std::vector<std::array<VertexId, 3>> triangles;
    std::vector<Segment> hanging;
    for (int i = 0; i < 28; ++i) {
      const auto last = static_cast<VertexId>(vertices.size());
      vertices.push_back({0.8 + 0.2 * real(generator), spread * real(generator), spread * real(generator)});
      if (round < 2) {
        triangles.push_back({0, 1, last});
      } else if (i % 3 == 2) {
        hanging.push_back({0, last});
      } else if (i > 0) {
        triangles.push_back({0, last - 1, last});
      }
    }
    check(triangle_complex(vertices, triangles, hanging), "hub " + std::to_string(round));
  }
}

BOOST_AUTO_TEST_CASE(book_of_leaves_that_doubles_cannot_order) {
  Generator generator(43);
  std::vector<Coordinates> vertices{{0, 0, 0}, {1, 0.5, 0.25}};
  std::vector<std::array<VertexId, 3>> triangles;
  for (VertexId i = 2; i < 28; ++i) {
    vertices.push_back({1e-20 * real(generator), 1, 1e-20 * real(generator)});
    triangles.push_back({0, 1, i});
  }
  check(triangle_complex(vertices, triangles), "thin book");
}

BOOST_AUTO_TEST_CASE(polygons) {
  Generator generator(11);
  for (int round = 0; round < 12; ++round) check(random_polygons(generator, 3, 0), "polygons " + std::to_string(round));
}

BOOST_AUTO_TEST_CASE(offsets) {
  // UTM coordinates: all detail is in the last digits.
  Generator generator(13);
  for (int round = 0; round < 20; ++round) {
    const double size = std::ldexp(1.0, -integer(generator, 0, 28));
    std::vector<Coordinates> vertices(10);
    for (auto& vertex : vertices) {
      vertex = {2.4e6 + size * real(generator), 5.1e6 + size * real(generator), 300 + size * real(generator)};
    }
    std::sort(vertices.begin(), vertices.end());
    vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
    check(random_soup(generator, vertices, 6, 2), "offset " + std::to_string(round));
    check(random_polygons(generator, 2, 4194304.0), "offset polygons " + std::to_string(round));
  }
}

BOOST_AUTO_TEST_CASE(flat) {
  // Hovering edges and nearly parallel segments at all heights.
  Generator generator(17);
  for (int round = 0; round < 40; ++round) {
    const double height = std::pow(10.0, -integer(generator, 2, 40));
    const int flat_axes = integer(generator, 1, 2);
    std::vector<Coordinates> vertices(10);
    for (auto& vertex : vertices) {
      vertex = {real(generator), real(generator) * (flat_axes == 2 ? height : 1), real(generator) * height};
    }
    check(random_soup(generator, vertices, 6, 3), "flat " + std::to_string(round));
  }
}

BOOST_AUTO_TEST_CASE(scales) {
  // Clusters of very different sizes around the vertices of one triangle.
  Generator generator(19);
  for (int round = 0; round < 30; ++round) {
    std::vector<Coordinates> vertices;
    for (int i = 0; i < 10; ++i) {
      const double size = std::pow(10.0, -integer(generator, 0, 18));
      const double x = integer(generator, 0, 1);
      vertices.push_back({x + size * real(generator), size * real(generator), size * real(generator)});
    }
    check(random_soup(generator, vertices, 6, 3), "scales " + std::to_string(round));
  }
}

BOOST_AUTO_TEST_CASE(points_that_are_no_doubles) {
  Generator generator(23);
  for (int round = 0; round < 15; ++round) {
    const int bits = integer(generator, 60, 1400);
    std::vector<Point> vertices;
    for (int i = 0; i < 9; ++i) {
      std::array<mpz_class, 3> numerators;
      for (auto& numerator : numerators) {
        numerator = mpz_class(integer(generator, -3, 3)) << bits;
        numerator += mpz_class(static_cast<unsigned long>(generator() >> 20));
      }
      vertices.emplace_back(numerators[0], numerators[1], numerators[2], bits + 2);
    }
    check(facet_complex(vertices, {fan({0, 1, 2}), fan({0, 3, 1}), fan({4, 5, 6})}, {{6, 7}, {7, 8}}),
          "bits " + std::to_string(bits));
  }
}

BOOST_AUTO_TEST_CASE(threads) {
  Generator generator(29);
  std::vector<Coordinates> vertices(300);
  for (auto& vertex : vertices) vertex = {real(generator), real(generator), real(generator)};
  const Complex complex = random_soup(generator, vertices, 400, 50);
  const auto run = [&](int threads) {
    const tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
    return compute_features(complex);
  };
  const Features one = run(1);
  const Features two = run(2);
  const auto same = [](const auto& a, const auto& b) {
    return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(a[0])) == 0;
  };
  BOOST_TEST(same(one.vertex_distance, two.vertex_distance));
  BOOST_TEST(same(one.segment_distance, two.segment_distance));
  BOOST_TEST(same(one.segment_angle, two.segment_angle));
  BOOST_TEST(same(one.facet_angle, two.facet_angle));
  BOOST_TEST(same(one.dihedral_angle, two.dihedral_angle));
}

BOOST_AUTO_TEST_SUITE_END()
