// SPDX-License-Identifier: GPL-3.0-or-later
// .poly of dimension 3, and .smesh.
#include <boost/test/unit_test.hpp>

#include "core/io/read.h"
#include "tests/core/io/reader_fixture.h"

using namespace confidel;
using test::with;

namespace {

const std::string prism = R"(8 3 0 1  # vertices
1 0 0 0 1
2 4 0 0 1
3 4 4 0 1
4 0 4 0 1
5 1 1 0 2
6 2 1 0 2
7 2 2 0 2
8 3 3 0 3
2 1      # facets
4 1 -3   # a square with a square hole, a slit and a vertex
4 1 2
  3      # corner lists may wrap

  4
3 5 6 7
2 3 8
1 8
1 1.5 1.25 0
1 0 5
3 5 6 7
1        # holes
1 9 9 9
1        # regions
1 .5 .5 .5 10
)";

const std::string wedge = R"(# part 1
5 3 0 0
0 0 0 0
1 1 0 0
2 1 1 0
3 0 1 0
4 0 0 1
# part 2
3 1
4 0 1 2 3 -1
3 0
  1 4 7 # wraps
2 0 4 9
# part 3
0
# part 4
0
)";

}  // namespace

BOOST_AUTO_TEST_SUITE(io_poly)

BOOST_AUTO_TEST_CASE(facets_keep_their_polygons) {
  const Input input = test::read_text(".poly", prism);
  BOOST_TEST(input.dimension == 3);
  BOOST_TEST(input.first_index == 1);
  BOOST_TEST(input.has_markers);
  BOOST_TEST(input.segments.empty());
  BOOST_REQUIRE_EQUAL(input.facets.size(), 2);
  const InputFacet& facet = input.facets[0];
  BOOST_TEST(facet.marker == -3);
  BOOST_TEST(facet.line == 11);
  BOOST_REQUIRE_EQUAL(facet.polygons.size(), 4);
  BOOST_TEST(facet.polygons[0].corners == (std::vector<int>{0, 1, 2, 3}), boost::test_tools::per_element());
  BOOST_TEST(facet.polygons[0].line == 12);
  BOOST_TEST(facet.polygons[1].corners == (std::vector<int>{4, 5, 6}), boost::test_tools::per_element());
  BOOST_TEST(facet.polygons[1].line == 16);
  BOOST_TEST(facet.polygons[2].corners == (std::vector<int>{2, 7}), boost::test_tools::per_element());
  BOOST_TEST(facet.polygons[3].corners == std::vector<int>{7}, boost::test_tools::per_element());
  BOOST_REQUIRE_EQUAL(facet.holes.size(), 1);
  BOOST_TEST(facet.holes[0] == (std::array<double, 3>{1.5, 1.25, 0}));
  BOOST_TEST(input.facets[1].marker == 5);
  BOOST_TEST(input.holes[0] == (std::array<double, 3>{9, 9, 9}));
  BOOST_TEST(input.regions[0].attribute == 10);
  BOOST_TEST(input.regions[0].bound == -1, "a missing bound is not the attribute");
}

BOOST_AUTO_TEST_CASE(facet_headers) {
  // val3dity hangs on a marker 0 and on rows of holes (tudelft3d/val3dity#49, #51).
  BOOST_TEST(test::read_text(".poly", with(prism, "1 0 5", "1 0 0")).facets[1].marker == 0);
  const std::string nodes = "3 3 0 0\n0 0 0 0\n1 1 0 0\n2 0 1 0\n";
  BOOST_TEST(test::read_text(".poly", nodes + "1 0\n1\n3 0 1 2\n0\n").facets.size() == 1);
  BOOST_TEST(test::read_text(".poly", nodes + "1 0\n1 0\n3 0 1 2\n0\n0\n").facets.size() == 1);
  BOOST_TEST(test::read_text(".poly", nodes + "1 0\n1 1\n3 0 1 2\n0 .1 .1 0\n0\n").facets[0].holes.size() == 1);
}

BOOST_AUTO_TEST_CASE(smesh) {
  const Input input = test::read_text(".smesh", wedge);
  BOOST_TEST(input.first_index == 0);
  BOOST_TEST(input.has_markers);
  BOOST_REQUIRE_EQUAL(input.facets.size(), 3);
  for (const InputFacet& facet : input.facets) BOOST_TEST(facet.polygons.size() == 1);
  BOOST_TEST(input.facets[0].marker == -1);
  BOOST_TEST(input.facets[1].marker == 7);
  BOOST_TEST(input.facets[1].line == 11);
  BOOST_TEST(input.facets[1].polygons[0].corners == (std::vector<int>{0, 1, 4}), boost::test_tools::per_element());
  BOOST_TEST(input.facets[2].polygons[0].corners == (std::vector<int>{0, 4}), boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(smesh_with_companion) {
  const test::TemporaryFolder folder;
  const std::string smesh = folder.write("a.smesh", "0 3 0 0\n1 0\n3 1 2 3\n0\n");
  folder.write("a.node", "3 3 0 0\n1 0 0 0\n2 1 0 0\n3 0 1 0\n");
  const Input input = read_input(smesh);
  BOOST_TEST(input.vertices.size() == 3);
  BOOST_TEST(input.facets[0].polygons[0].corners == (std::vector<int>{0, 1, 2}), boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(malformed_poly) {
  test::check_malformed(
      ".poly", {{"vertex without z", with(prism, "2 4 0 0 1", "2 4 0 1"), "E-FIELDS", 3, 8},
                {"vertex with an attribute too many", with(prism, "2 4 0 0 1", "2 4 0 0 7 1"), "E-FIELDS", 3, 11},
                {"facets' header without markers", with(prism, "2 1      # facets", "2"), "E-FIELDS", 10, 2},
                {"facets' header with two markers", with(prism, "2 1      # facets", "2 2"), "E-VALUE", 10, 3},
                {"facet without its marker", with(prism, "1 0 5", "1 0"), "E-FIELDS", 20, 4},
                {"facet with a marker not announced", "1 3 0 0\n0 0 0 0\n1 0\n1 0 5\n1 0\n0\n", "E-FIELDS", 4, 5},
                {"facet without polygons", with(prism, "1 0 5", "0 0 5"), "E-VALUE", 20, 1},
                {"facet with -1 holes", with(prism, "1 0 5", "1 -1 5"), "E-COUNT", 20, 3},
                {"polygon without corners", with(prism, "1 8\n", "0\n"), "E-VALUE", 18, 1},
                {"polygon with a negative count", with(prism, "1 8\n", "-1 8\n"), "E-COUNT", 18, 1},
                {"polygon with a corner too many", with(prism, "2 3 8", "2 3 8 1"), "E-FIELDS", 17, 7},
                {"polygon takes corners from the next lines", with(prism, "4 1 2\n", "5 1 2\n"), "E-FIELDS", 16, 3},
                {"polygon of 2^31 - 1 corners", with(prism, "2 3 8", "2147483647 3 8"), "E-NUMBER", 19, 3},
                {"corner 9 of 8", with(prism, "2 3 8", "2 3 9"), "E-INDEX", 17, 5},
                {"corner 0 in a file from 1", with(prism, "  3      #", "  0      #"), "E-INDEX", 13, 3},
                {"corner is no integer", with(prism, "2 3 8", "2 3 8.0"), "E-NUMBER", 17, 5},
                {"facet hole announced, but missing", with(prism, "1 1.5 1.25 0\n", ""), "E-FIELDS", 19, 6},
                {"facet hole too many", with(prism, "4 1 -3", "4 0 -3"), "E-FIELDS", 19, 12},
                {"facet hole numbered 2", with(prism, "1 1.5 1.25 0", "2 1.5 1.25 0"), "E-INDEX", 19, 1},
                {"facet missing", with(prism, "2 1      # facets", "3 1"), "E-FIELDS", 22, 2},
                {"hole without z", with(prism, "1 9 9 9", "1 9 9"), "E-FIELDS", 23, 6},
                {"region without attribute", with(prism, "1 .5 .5 .5 10", "1 .5 .5 .5"), "E-FIELDS", 25, 11},
                {"region with seven fields", with(prism, "1 .5 .5 .5 10", "1 .5 .5 .5 10 1 1"), "E-FIELDS", 25, 17},
                {"region of infinite bound", with(prism, "1 .5 .5 .5 10", "1 .5 .5 .5 10 inf"), "E-NUMBER", 25, 15},
                {"end in a wrapped polygon", prism.substr(0, prism.find("  4\n")), "E-TRUNCATED", 14, 1}});
}

BOOST_AUTO_TEST_CASE(malformed_smesh) {
  test::check_malformed(".smesh",
                        {{"dimension 2", "1 2 0 0\n0 0 0\n0 0\n0\n", "E-VALUE", 1, 3},
                         {"facet without its marker", with(wedge, "2 0 4 9", "2 0 4"), "E-FIELDS", 13, 6},
                         {"marker on the next line", with(wedge, "2 0 4 9", "2 0 4\n9"), "E-FIELDS", 13, 6},
                         {"facet with a marker not announced", with(wedge, "3 1\n", "3 0\n"), "E-FIELDS", 10, 11},
                         {"facet with a field too many", with(wedge, "2 0 4 9", "2 0 4 9 9"), "E-FIELDS", 13, 9},
                         {"corner 5 of 0 to 4", with(wedge, "2 0 4 9", "2 0 5 9"), "E-INDEX", 13, 5},
                         {"facet missing", with(wedge, "2 0 4 9\n", ""), "E-VALUE", 14, 1},
                         {"facet too many", with(wedge, "2 0 4 9", "2 0 4 9\n2 0 4 9"), "E-FIELDS", 14, 3},
                         {"absurd number of facets", with(wedge, "3 1\n", "2147483647 1\n"), "E-VALUE", 15, 1},
                         {"hole section missing", wedge.substr(0, wedge.find("# part 3")), "E-TRUNCATED", 13, 8},
                         {"behind the end", wedge + "0\n", "E-TRAILING", 18, 1}});
}

BOOST_AUTO_TEST_CASE(a_short_polygon_is_named_with_its_line) {
  const std::string unwrapped = with(wedge, "3 0\n  1 4 7", "3 0 1 4 7");
  const std::vector<Problem> problems = test::problems_of(".smesh", with(unwrapped, "4 0 1 2 3 -1", "4 0 1 2"));
  BOOST_REQUIRE(!problems.empty());
  BOOST_TEST(problems[0].place.line == 11);
  BOOST_TEST(problems[0].message.find("line 10") != std::string::npos);
}

BOOST_AUTO_TEST_SUITE_END()
