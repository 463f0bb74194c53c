// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/complex/merge.h"

#include <rapidcheck.h>

#include <boost/test/unit_test.hpp>

#include "tests/core/complex/generators.h"
#include "tests/core/complex/inputs.h"
#include "tests/core/complex/triangulation_rules.h"

using namespace confidel;
using namespace confidel::test;

namespace {

using Edges = std::vector<std::array<VertexId, 2>>;

BuiltComplex merged(const Input& input) {
  BuildOptions options;
  options.merge_coplanar = BuildOptions::Merging::on;
  BuiltComplex built = build_complex(input, options);
  require_everything(built.complex);
  return built;
}

Input cut_square(int first_marker = 0, int second_marker = 0) {
  return InputMaker().vertices(square()).facet({{0, 1, 2}}, {}, first_marker).facet({{0, 2, 3}}, {}, second_marker);
}

/// The sum of the facets' areas, each times a rational function of its plane that makes it rational: |n|_max / |n|.
mpq_class area_measure(const CanonicalComplex& complex) {
  mpq_class sum = 0;
  for (const CanonicalFacet& facet : complex.facets) {
    const Rational3 normal = facet_normal(complex, facet);
    mpq_class longest = 0;
    for (const mpq_class& component : normal)
      if (abs(component) > longest) longest = abs(component);
    sum += boundary_area(complex, facet) / scalar(normal, normal) * longest;
  }
  return sum;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(complex_merge)

BOOST_AUTO_TEST_CASE(diagonal_vanishes) {
  const auto built = merged(cut_square());
  BOOST_TEST(built.complex.facets.size() == 1U);
  BOOST_TEST((built.complex.facets[0].boundary == Edges{{0, 1}, {1, 2}, {2, 3}, {3, 0}}));
  BOOST_TEST(built.complex.segments.size() == 4U);
  BOOST_TEST(built.complex.segment_markers.size() == 4U);
}

BOOST_AUTO_TEST_CASE(only_soups_are_merged_by_themselves) {
  Input input = cut_square();
  BOOST_TEST(build_complex(input).complex.facets.size() == 2U);
  input.triangle_soup = true;
  BOOST_TEST(build_complex(input).complex.facets.size() == 1U);
  BuildOptions off;
  off.merge_coplanar = BuildOptions::Merging::off;
  BOOST_TEST(build_complex(input, off).complex.facets.size() == 2U);
}

BOOST_AUTO_TEST_CASE(different_markers_stay_apart) {
  BOOST_TEST(merged(cut_square(1, 2)).complex.facets.size() == 2U);
  BOOST_TEST(merged(cut_square(2, 2)).complex.facets[0].marker == 2);
}

BOOST_AUTO_TEST_CASE(opposite_orientations_merge) {
  const auto built = merged(InputMaker().vertices(square()).facet({{0, 1, 2}}).facet({{0, 3, 2}}));
  BOOST_TEST(built.complex.facets.size() == 1U);
  BOOST_TEST((built.complex.facets[0].normal == IntegerVector{0, 0, 1}));
}

BOOST_AUTO_TEST_CASE(stated_segment_stays_a_constraint) {
  // An .obj file that says `l 1 3` along the diagonal means it.
  Input input = cut_square();
  input.segments.push_back({{2, 0}, 9, 201});
  const auto built = merged(input);
  BOOST_TEST(built.complex.facets.size() == 1U);
  BOOST_TEST((built.complex.facets[0].constraints == Edges{{0, 2}}));
  BOOST_TEST(built.complex.segment_markers[built.complex.find_segment(0, 2)] == 9);
}

BOOST_AUTO_TEST_CASE(segment_of_a_third_facet_stays_a_constraint) {
  auto vertices = square();
  vertices.push_back({0, 0, 1});
  const auto built = merged(InputMaker().vertices(vertices).facet({{0, 1, 2}}).facet({{0, 2, 3}}).facet({{0, 2, 4}}));
  // The diagonal is shared by three facets: the two halves meet in it only, and are not merged.
  BOOST_TEST(built.complex.find_segment(0, 2) >= 0);
  BOOST_TEST(built.complex.facets.size() == 3U);
}

BOOST_AUTO_TEST_CASE(vertex_without_segments_becomes_isolated) {
  auto vertices = square();
  vertices.push_back({0.5, 0.25, 0});
  InputMaker fan = InputMaker().vertices(vertices);
  for (int i = 0; i < 4; ++i) fan.facet({{i, (i + 1) % 4, 4}});
  const auto built = merged(fan);
  BOOST_TEST(built.complex.facets.size() == 1U);
  BOOST_TEST((built.complex.facets[0].isolated == std::vector<VertexId>{4}));
  BOOST_TEST(built.complex.facets[0].triangles.size() == 4U);
}

BOOST_AUTO_TEST_CASE(ring_around_a_foreign_facet) {
  // Eight triangles around an inner square that has another marker: a facet with a hole.
  InputMaker ring = InputMaker().vertices(nested_squares());
  for (int i = 0; i < 4; ++i) {
    const int j = (i + 1) % 4;
    ring.facet({{i, j, 4 + i}}).facet({{j, 4 + j, 4 + i}});
  }
  ring.facet({{4, 5, 6, 7}}, {}, 5);
  const auto built = merged(ring);
  BOOST_TEST(built.complex.facets.size() == 2U);
  BOOST_TEST(built.complex.facets[0].boundary.size() == 8U);
  BOOST_TEST(built.complex.segments.size() == 8U);
}

BOOST_AUTO_TEST_CASE(merging_keeps_what_is_covered) {
  int shrunk = 0;
  const bool passed = rc::check("random soups of one or two planes", [&] {
    InputMaker maker;
    std::vector<Position> positions;
    for (int i = 0; i < 8; ++i) {
      const Position position{1. * *whole_range(0, 3), 1. * *whole_range(0, 3), 1. * *whole_range(0, 2)};
      if (std::find(positions.begin(), positions.end(), position) == positions.end()) positions.push_back(position);
    }
    maker.vertices(positions);
    // Triangles are added as long as they do no harm, so that most cases have many.
    const int count = static_cast<int>(positions.size());
    for (int i = 0; i < 12; ++i) {
      InputMaker longer = maker;
      const int a = *whole_range(0, count), b = *whole_range(0, count), c = *whole_range(0, count);
      if (i == 11 && a != b)
        longer.segment(a, b);
      else
        longer.facet({{a, b, c}}, {}, *whole_range(0, 2));
      if (problems_of(longer).empty()) maker = longer;
    }
    if (maker.input().facets.empty()) return;
    const BuiltComplex plain = build_complex(maker), result = merged(maker);
    const CanonicalComplex before = require_everything(plain.complex), after = require_everything(result.complex);
    RC_ASSERT(area_measure(before) == area_measure(after));
    RC_ASSERT(after.vertices == before.vertices);
    RC_ASSERT(
        std::includes(before.segments.begin(), before.segments.end(), after.segments.begin(), after.segments.end()));
    RC_ASSERT(result.complex.segment_markers.size() == result.complex.segments.size());
    shrunk += after.facets.size() < before.facets.size();
  });
  BOOST_TEST(passed);
  BOOST_TEST(shrunk > 0);
}

BOOST_AUTO_TEST_SUITE_END()
