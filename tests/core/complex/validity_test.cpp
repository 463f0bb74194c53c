// SPDX-License-Identifier: GPL-3.0-or-later
// Every code with what it refuses, the line it names, and a neighbour that is right.
#include <boost/test/unit_test.hpp>

#include <limits>

#include "core/complex/build.h"
#include "tests/core/complex/inputs.h"

using namespace confidel;
using namespace confidel::test;

namespace {

using Codes = std::vector<std::string>;

bool says(const Input& input, const std::string& part) {
  const auto problems = problems_of(input);
  for (const Problem& problem : problems)
    if (problem.message.find(part) != std::string::npos) return true;
  BOOST_TEST_MESSAGE(text_of(problems));
  return false;
}

InputMaker triangle_with(const std::vector<Position>& more) {
  std::vector<Position> vertices{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}};
  vertices.insert(vertices.end(), more.begin(), more.end());
  return InputMaker().vertices(vertices).facet({{0, 1, 2}});
}

}  // namespace

BOOST_AUTO_TEST_SUITE(complex_validity)

BOOST_AUTO_TEST_CASE(empty) {
  BOOST_TEST(codes_of(InputMaker()) == Codes{"E-EMPTY@0"});
  BOOST_TEST(codes_of(InputMaker().vertices(square())) == Codes{"E-EMPTY@0"});
  BOOST_TEST(codes_of(InputMaker(2)) == Codes{"E-EMPTY@0"});
  BOOST_TEST(codes_of(InputMaker(2).vertices({{1, 2, 0}})).empty());
}

BOOST_AUTO_TEST_CASE(numbers_are_finite) {
  const double infinity = std::numeric_limits<double>::infinity();
  BOOST_TEST(codes_of(triangle_with({{0, infinity, 0}})) == Codes{"E-NUMBER@4"});
}

BOOST_AUTO_TEST_CASE(duplicate_vertices) {
  const auto input = triangle_with({{4, 0, -0.0}, {4, 0, 1e-300}, {4, 0, 0}});
  BOOST_TEST(codes_of(input) == (Codes{"E-DUPLICATE-VERTEX@4", "E-DUPLICATE-VERTEX@6"}));
  BOOST_TEST(says(input, "vertex 3 (line 4) and vertex 1 (line 2)"));
  BOOST_TEST(says(input, "vertex 5 (line 6) and vertex 1 (line 2)"));
}

BOOST_AUTO_TEST_CASE(vertices_of_a_companion_file_are_named_there) {
  Input input = triangle_with({{4, 0, 0}});
  input.vertex_file = "companion.node";
  const auto problems = problems_of(input);
  BOOST_REQUIRE(problems.size() == 1U);
  BOOST_TEST(problems.front().place.file == "companion.node");
}

BOOST_AUTO_TEST_CASE(duplicates_do_not_hide_other_problems) {
  InputMaker input = triangle_with({{4, 0, 0}, {0, 0, 5}});
  input.facet({{3, 1, 4}}).facet({{0, 3, 2}});
  BOOST_TEST(codes_of(input) == (Codes{"E-DUPLICATE-VERTEX@4", "E-DEGENERATE-FACET@102", "E-OVERLAP@103"}));
}

BOOST_AUTO_TEST_CASE(indices) {
  InputMaker input = triangle_with({});
  input.facet({{0, 1, 3}}).facet({{0, -1, 2}}).segment(0, 7);
  BOOST_TEST(codes_of(input) == (Codes{"E-INDEX@102", "E-INDEX@103", "E-INDEX@201"}));
  input.input().first_index = 1;
  BOOST_TEST(says(input, "facet 2 (line 102) has the corner 4, which does not exist: vertices are numbered 1 to 3"));
  BOOST_TEST(says(input, "segment 1 has the end 8"));
}

BOOST_AUTO_TEST_CASE(degenerate_facets) {
  const std::vector<Position> line{{0, 0, 0}, {1, 1, 1}, {2, 2, 2}, {1, 0, 0}};
  BOOST_TEST(codes_of(InputMaker().vertices(line).facet({{0, 1, 2}})) == Codes{"E-DEGENERATE-FACET@101"});
  BOOST_TEST(codes_of(InputMaker().vertices(line).facet({{0, 1, 1}})) == Codes{"E-DEGENERATE-FACET@101"});
  BOOST_TEST(codes_of(InputMaker().vertices(line).facet({{0, 3, 0, 3}})) == Codes{"E-DEGENERATE-FACET@101"});
  BOOST_TEST(codes_of(InputMaker().vertices(line).facet({{0}, {1}})) == Codes{"E-DEGENERATE-FACET@101"});
  BOOST_TEST(codes_of(InputMaker().vertices(line).facet({})) == Codes{"E-DEGENERATE-FACET@101"});
  // A loop that walks there and back has corners off a line, but no area.
  BOOST_TEST(codes_of(InputMaker().vertices(square()).facet({{0, 1, 2, 1}})) == Codes{"E-DEGENERATE-FACET@101"});
  BOOST_TEST(codes_of(InputMaker().vertices(line).facet({{0, 1, 3}})).empty());
}

BOOST_AUTO_TEST_CASE(open_loops) {
  BOOST_TEST(codes_of(InputMaker().vertices(square()).facet({{0, 1}, {1, 2}, {2, 3}})) == Codes{"E-OPEN-LOOP@101"});
  BOOST_TEST(codes_of(InputMaker().vertices(square()).facet({{0, 1}, {1, 2}, {2, 3}, {3, 0}})).empty());
}

BOOST_AUTO_TEST_CASE(facets_off_a_plane) {
  auto vertices = square();
  vertices[2][2] = 0x1p-1070;
  const InputMaker input = InputMaker().vertices(vertices).facet({{0, 1, 3, 2}}).facet({{0, 1, 3}});
  BOOST_TEST(codes_of(input) == Codes{"E-NONCOPLANAR@101"});
  BOOST_TEST(
      says(input, "facet 0 (line 101) is not flat: vertex 2 (line 3) is off the plane of its corners 0, 1, 3 by"));
  // 0.1 + 0.2 is not 0.3: a plane x + y = 0.3 that is none.
  BOOST_TEST(
      codes_of(InputMaker().vertices({{0.3, 0, 0}, {0, 0.3, 0}, {0, 0.3, 1}, {0.1, 0.2, 1}}).facet({{0, 1, 2, 3}})) ==
      Codes{"E-NONCOPLANAR@101"});
  BOOST_TEST(
      says(InputMaker().vertices({{0, 0, 0}, {8, 0, 0}, {0, 8, 0}, {8, 8, 1}, {4, 4, 3}}).facet({{0, 1, 3, 2}, {4}}),
           "vertex 4 (line 5) is off the plane of its corners 0, 1, 3"));
}

BOOST_AUTO_TEST_CASE(crossing_segments_name_the_exact_point) {
  InputMaker plane(2);
  plane.vertices({{0, 0, 0}, {3, 1, 0}, {0, 1, 0}, {3, 0, 0}, {1, -1, 0}, {1, 5, 0}})
      .segment(0, 1)
      .segment(2, 3)
      .segment(4, 5);
  BOOST_TEST(codes_of(plane) == (Codes{"E-CROSSING@202", "E-CROSSING@203", "E-CROSSING@203"}));
  BOOST_TEST(says(
      plane,
      "segment 1 from 2 to 3 (line 202) crosses segment 0 from 0 to 1 (line 201) at (1.5, 0.5), exactly (3/2, 1/2)"));
  BOOST_TEST(says(plane, "exactly (1, 1/3)"));
  BOOST_TEST(says(plane, "exactly (1, 2/3)"));

  InputMaker space;
  space.vertices({{0, 0, 0}, {2, 2, 2}, {2, 0, 0}, {0, 2, 2}, {0, 0, 0.5}, {2, 2, 2.5}})
      .segment(0, 1)
      .segment(2, 3)
      .segment(4, 5);
  BOOST_TEST(codes_of(space) == Codes{"E-CROSSING@202"});
  BOOST_TEST(says(space, "at (1, 1, 1);"));
}

BOOST_AUTO_TEST_CASE(segments_that_nearly_cross_do_not) {
  InputMaker space;
  space.vertices({{0, 0, 0}, {2, 2, 0}, {2, 0, 0x1p-1074}, {0, 2, 0}}).segment(0, 1).segment(2, 3);
  BOOST_TEST(codes_of(space).empty());
}

BOOST_AUTO_TEST_CASE(loop_that_crosses_itself) {
  const InputMaker input = InputMaker().vertices(square()).facet({{0, 2, 1, 3}});
  BOOST_TEST(codes_of(input) == Codes{"E-CROSSING@101"});
  BOOST_TEST(says(input, "edge 1-3 of facet 0 (line 101) crosses edge 0-2 of facet 0 (line 101) at (0.5, 0.5, 0)"));
  // With the crossing as a vertex it is two triangles.
  auto vertices = square();
  vertices.push_back({0.5, 0.5, 0});
  BOOST_TEST(codes_of(InputMaker().vertices(vertices).facet({{0, 2, 1, 3}})).empty());
}

BOOST_AUTO_TEST_CASE(segment_through_a_facet) {
  InputMaker input = triangle_with({{1, 1, -1}, {1, 1, 1}});
  input.segment(3, 4);
  BOOST_TEST(codes_of(input) == Codes{"E-CROSSING@201"});
  BOOST_TEST(says(input, "segment 0 from 3 to 4 (line 201) pierces facet 0 (line 101) near (1, 1, 0)"));
  InputMaker beside = triangle_with({{3, 3, -1}, {3, 3, 1}});
  BOOST_TEST(codes_of(beside.segment(3, 4)).empty());
  InputMaker touching = triangle_with({{1, 1, 0}, {1, 1, 1}});
  BOOST_TEST(codes_of(touching.segment(3, 4)).empty());
  InputMaker through_vertex = triangle_with({{1, 1, 0}, {1, 1, 1}, {1, 1, -1}});
  BOOST_TEST(codes_of(through_vertex.segment(4, 5)).empty());
}

BOOST_AUTO_TEST_CASE(segment_through_a_diagonal_of_the_triangulation) {
  // Whichever diagonal the square has, one of the two segments meets it.
  auto vertices = square();
  for (const double x : {0.25, 0.75})
    for (const double z : {-1., 1.}) vertices.push_back({x, 0.25, z});
  InputMaker input = InputMaker().vertices(vertices).facet({{0, 1, 2, 3}}).segment(4, 5).segment(6, 7);
  BOOST_TEST(codes_of(input) == (Codes{"E-CROSSING@201", "E-CROSSING@202"}));
}

BOOST_AUTO_TEST_CASE(facets_that_cross) {
  InputMaker input = triangle_with({{1, 1, -1}, {1, 1, 1}, {9, 9, 0}});
  input.facet({{3, 4, 5}});
  BOOST_TEST(codes_of(input) == Codes{"E-CROSSING@102"});
  BOOST_TEST(says(input, "facet 1 (line 102) and facet 0 (line 101) cross near (1.5, 1.5, 0)"));
}

BOOST_AUTO_TEST_CASE(squares_that_cross_in_a_common_diagonal) {
  // No edge pierces anything, no vertex lies in anything: only the common diagonal, which is no segment, is wrong.
  auto vertices = square();
  vertices.push_back({0.5, 0.5, 1});
  vertices.push_back({0.5, 0.5, -1});
  InputMaker input = InputMaker().vertices(vertices).facet({{0, 1, 2, 3}}).facet({{0, 4, 2, 5}});
  BOOST_TEST(codes_of(input) == Codes{"E-CROSSING@102"});
  input.segment(0, 2);  // now it is one, in both
  BOOST_TEST(codes_of(input).empty());
}

BOOST_AUTO_TEST_CASE(facets_that_overlap) {
  InputMaker same = triangle_with({});
  same.facet({{1, 2, 0}});
  BOOST_TEST(codes_of(same) == Codes{"E-OVERLAP@102"});
  BOOST_TEST(says(same, "facet 1 (line 102) and facet 0 (line 101) are the same"));
  InputMaker inside = triangle_with({{1, 1, 0}});
  inside.facet({{3, 0, 1}});
  BOOST_TEST(codes_of(inside) == Codes{"E-OVERLAP@102"});
  InputMaker across = triangle_with({{4, 4, 0}});
  across.facet({{0, 3, 1}});
  BOOST_TEST(codes_of(across) == (Codes{"E-CROSSING@102", "E-OVERLAP@102"}));
  InputMaker beside = triangle_with({{4, 4, 0}});
  BOOST_TEST(codes_of(beside.facet({{1, 3, 2}})).empty());
}

BOOST_AUTO_TEST_CASE(crossing_edges_do_not_hide_other_crossings) {
  // Facet 1 crosses an edge of facet 0 with its own edge; facet 2 pierces facet 0 elsewhere.
  InputMaker input = triangle_with({{2, -1, 0}, {2, 1, 0}, {2, 0, 3}, {1, 1, -1}, {1, 1, 1}, {0.5, 9, 0}});
  input.facet({{3, 4, 5}}).facet({{6, 7, 8}});
  const auto codes = codes_of(input);
  BOOST_TEST((std::count(codes.begin(), codes.end(), "E-CROSSING@102") == 1), text_of(problems_of(input)));
  BOOST_TEST((std::count(codes.begin(), codes.end(), "E-CROSSING@103") == 1), text_of(problems_of(input)));
}

BOOST_AUTO_TEST_CASE(filled_hole_that_is_no_hole) {
  // Without the hole point the facet covers what the other one fills.
  const InputMaker input =
      InputMaker().vertices(nested_squares()).facet({{0, 1, 2, 3}, {4, 5, 6, 7}}).facet({{4, 5, 6, 7}});
  BOOST_TEST(codes_of(input) == Codes{"E-OVERLAP@102"});
}

BOOST_AUTO_TEST_CASE(hole_points) {
  const auto with_seed = [](const Position& seed) {
    return InputMaker().vertices(nested_squares()).facet({{0, 1, 2, 3}, {4, 5, 6, 7}, {4, 2}}, {seed});
  };
  BOOST_TEST(codes_of(with_seed({0.5, 0.25, 0})) == Codes{"E-HOLE@101"});
  BOOST_TEST(codes_of(with_seed({0.25, 0.25, 3})) == Codes{"E-HOLE@101"});
  BOOST_TEST(codes_of(with_seed({0.5, 0.5, 0})) == Codes{"E-HOLE@101"});  // on the diagonal 4-2
  BOOST_TEST(codes_of(with_seed({0.5, 0.375, 0})).empty());
  BOOST_TEST(codes_of(with_seed({7, 7, 0})).empty());
  const InputMaker eaten = InputMaker().vertices(square()).facet({{0, 1, 2, 3}}, {{0.25, 0.5, 0}});
  BOOST_TEST(codes_of(eaten) == Codes{"E-HOLE@101"});
  BOOST_TEST(says(eaten, "remove all of it"));
}

BOOST_AUTO_TEST_CASE(all_problems_are_found_in_one_run) {
  auto vertices = nested_squares();
  vertices.push_back({0, 0, 0});
  vertices.push_back({0.5, 0.5, 1});
  InputMaker input = InputMaker()
                         .vertices(vertices)
                         .facet({{0, 1, 2, 3}})
                         .facet({{0, 1, 99}})
                         .facet({{0, 1, 2, 9}})
                         .facet({{0, 1, 0}})
                         .facet({{0, 4}, {4, 1}})
                         .facet({{2, 1, 0}});
  BOOST_TEST(codes_of(input) == (Codes{"E-DUPLICATE-VERTEX@9", "E-INDEX@102", "E-NONCOPLANAR@103",
                                       "E-DEGENERATE-FACET@104", "E-OPEN-LOOP@105", "E-OVERLAP@106"}));
}

BOOST_AUTO_TEST_SUITE_END()
