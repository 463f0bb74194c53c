// SPDX-License-Identifier: GPL-3.0-or-later
// Dimension 2: the domain.
#include <boost/test/unit_test.hpp>

#include "core/complex/build.h"
#include "tests/core/complex/inputs.h"
#include "tests/core/complex/triangulation_rules.h"

using namespace confidel;
using namespace confidel::test;

namespace {

using Edges = std::vector<std::array<VertexId, 2>>;

BuiltComplex checked(const Input& input) {
  try {
    BuiltComplex built = build_complex(input);
    require_everything(built.complex);
    return built;
  } catch (const InputError& error) {
    BOOST_FAIL("refused:\n" + text_of(error.problems));
    throw;
  }
}

InputMaker& ring(InputMaker& maker, int first, int count) {
  for (int i = 0; i < count; ++i) maker.segment(first + i, first + (i + 1) % count);
  return maker;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(complex_planar)

BOOST_AUTO_TEST_CASE(closed_ring_bounds_the_domain) {
  InputMaker maker(2);
  ring(maker.vertices(nested_squares()), 0, 4);
  const auto built = checked(maker.segment(4, 6));
  BOOST_TEST(built.complex.dimension == 2);
  BOOST_TEST((built.complex.facets[0].boundary == Edges{{0, 1}, {1, 2}, {2, 3}, {3, 0}}));
  BOOST_TEST((built.complex.facets[0].constraints == Edges{{4, 6}}));
  BOOST_TEST((built.complex.facets[0].isolated == std::vector<VertexId>{5, 7}));
  BOOST_TEST(built.report.artificial_segments == 0);
}

BOOST_AUTO_TEST_CASE(orientation_is_counter_clockwise_however_the_ring_runs) {
  InputMaker maker(2);
  maker.vertices(nested_squares()).segment(0, 3).segment(3, 2).segment(2, 1).segment(1, 0);
  BOOST_TEST((checked(maker).complex.facets[0].boundary == Edges{{0, 1}, {1, 2}, {2, 3}, {3, 0}}));
}

BOOST_AUTO_TEST_CASE(holes_are_dug) {
  InputMaker maker(2);
  ring(ring(maker.vertices(nested_squares()), 0, 4), 4, 4).hole({0.5, 0.5, 0});
  const auto built = checked(maker);
  BOOST_TEST(
      (built.complex.facets[0].boundary == Edges{{0, 1}, {1, 2}, {2, 3}, {3, 0}, {4, 7}, {5, 4}, {6, 5}, {7, 6}}));
}

BOOST_AUTO_TEST_CASE(segments_outside_of_the_domain_are_hanging) {
  auto vertices = nested_squares();
  vertices.push_back({2, 2, 0});
  vertices.push_back({0.5, 0.5, 0});
  InputMaker maker(2);
  ring(ring(maker.vertices(vertices), 0, 4), 4, 4).segment(2, 8, 4).segment(9, 4).hole({0.5, 0.625, 0});
  const auto built = checked(maker);
  BOOST_TEST(built.complex.facets[0].constraints.empty());
  BOOST_TEST(built.complex.find_segment(2, 8) >= 0);
  BOOST_TEST(built.complex.segment_markers[built.complex.find_segment(2, 8)] == 4);
  BOOST_TEST(built.complex.find_segment(4, 9) >= 0);
  BOOST_TEST(has_remark(built.report, "2 segments lie outside"));
  BOOST_TEST(has_remark(built.report, "2 vertices lie outside"));
}

BOOST_AUTO_TEST_CASE(open_input_gets_its_convex_hull) {
  InputMaker maker(2);
  maker.vertices({{0, 0, 0}, {2, 0, 0}, {4, 0, 0}, {2, 4, 0}, {2, 1, 0}}).segment(0, 1).segment(4, 3);
  const auto built = checked(maker);
  // Vertex 1 is on the hull: the edge 1-2 is artificial, 0-1 is not.
  BOOST_TEST((built.complex.facets[0].boundary == Edges{{0, 1}, {1, 2}, {2, 3}, {3, 0}}));
  BOOST_TEST((built.complex.facets[0].constraints == Edges{{3, 4}}));
  BOOST_TEST(built.report.artificial_segments == 3);
}

BOOST_AUTO_TEST_CASE(holes_do_not_close_an_open_boundary) {
  // Triangle's box.poly: one side of the outer square and the ring of a hole; the domain is the hull minus the hole.
  InputMaker maker(2);
  ring(maker.vertices(nested_squares()), 4, 4).segment(0, 1).hole({0.5, 0.5, 0});
  const auto built = checked(maker);
  BOOST_TEST(built.complex.facets[0].boundary.size() == 8U);
  BOOST_TEST(built.report.artificial_segments == 3);
}

BOOST_AUTO_TEST_CASE(points_alone_span_their_hull) {
  InputMaker maker(2);
  const auto built = checked(maker.vertices({{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {1, 1, 0}}));
  BOOST_TEST(built.report.artificial_segments == 3);
  BOOST_TEST((built.complex.facets[0].isolated == std::vector<VertexId>{3}));
}

BOOST_AUTO_TEST_CASE(vertices_on_one_line_have_no_domain) {
  InputMaker maker(2);
  const auto built = checked(maker.vertices({{0, 0, 0}, {4, 4, 0}, {1, 1, 0}, {3, 3, 0}}).segment(0, 1));
  BOOST_TEST(built.complex.facets.empty());
  BOOST_TEST((built.complex.segments == std::vector<Segment>{{0, 2}, {1, 3}, {2, 3}}));
}

BOOST_AUTO_TEST_CASE(marker_is_the_last_that_says_something) {
  InputMaker maker(2);
  maker.vertices({{0, 0, 0}, {3, 0, 0}, {1, 0, 0}}).segment(0, 1, 5).segment(2, 1, 7).segment(1, 0);
  const auto built = checked(maker);
  BOOST_TEST((built.complex.segments == std::vector<Segment>{{0, 2}, {1, 2}}));
  BOOST_TEST((built.complex.segment_markers == std::vector<int>{5, 7}));
}

BOOST_AUTO_TEST_CASE(overlapping_segments_are_split_at_their_ends) {
  InputMaker maker(2);
  maker.vertices({{0, 0, 0}, {3, 0, 0}, {1, 0, 0}, {4, 0, 0}, {0, 1, 0}}).segment(0, 1).segment(2, 3).segment(1, 0);
  const auto built = checked(maker);
  BOOST_TEST(built.complex.find_segment(0, 2) >= 0);
  BOOST_TEST(built.complex.find_segment(1, 2) >= 0);
  BOOST_TEST(built.complex.find_segment(1, 3) >= 0);
  BOOST_TEST(has_remark(built.report, "segment 2 (line 203) is the same as segment 0 (line 201)"));
}

BOOST_AUTO_TEST_SUITE_END()
