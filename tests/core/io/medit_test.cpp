// SPDX-License-Identifier: GPL-3.0-or-later
#include <boost/test/unit_test.hpp>

#include "tests/core/io/reader_fixture.h"

using namespace confidel;
using test::with;

namespace {

const std::string surface = R"(MeshVersionFormatted 1

Dimension
3
# the set of vertices
Vertices
5
0 0 0 0
1 0 0 1
1 1 0 2
0 1 0 3
0 0 1D0 4

Triangles 2
1 2 5 10
2 3 5 11
Corners
1
1
Quadrilaterals
1
1 2 3 4 12
Edges
1
1 5 13
Tetrahedra 1
1 2 3 5 0
RequiredVertices 0
End
)";

const std::string planar =
    "MeshVersionFormatted 2\nDimension 2\nVertices 3\n0 0 0\n1 0 0\n0 1 7\nEdges 2\n1 2 5\n2 3 6\nEnd\n";

}  // namespace

BOOST_AUTO_TEST_SUITE(io_medit)

BOOST_AUTO_TEST_CASE(surface_of_triangles_quadrilaterals_and_edges) {
  const Input input = test::read_text(".mesh", surface);
  BOOST_TEST(input.dimension == 3);
  BOOST_TEST(input.first_index == 1);
  BOOST_TEST(input.has_markers);
  BOOST_TEST(input.triangle_soup);
  BOOST_REQUIRE_EQUAL(input.vertices.size(), 5);
  BOOST_TEST(input.vertices[4].position == (std::array<double, 3>{0, 0, 1}));
  BOOST_TEST(input.vertices[4].marker == 4);
  BOOST_TEST(input.vertices[4].line == 12);
  BOOST_REQUIRE_EQUAL(input.facets.size(), 3);
  BOOST_TEST(input.facets[1].polygons[0].corners == (std::vector<int>{1, 2, 4}), boost::test_tools::per_element());
  BOOST_TEST(input.facets[1].marker == 11);
  BOOST_TEST(input.facets[1].line == 16);
  BOOST_TEST(input.facets[2].polygons[0].corners == (std::vector<int>{0, 1, 2, 3}), boost::test_tools::per_element());
  BOOST_REQUIRE_EQUAL(input.segments.size(), 1);
  BOOST_TEST(input.segments[0].ends == (std::array<int, 2>{0, 4}));
  BOOST_TEST(input.segments[0].marker == 13);
  BOOST_REQUIRE_EQUAL(input.remarks.size(), 1);
  BOOST_TEST(input.remarks[0] == "not read: 1 Corners, 1 Tetrahedra");
}

BOOST_AUTO_TEST_CASE(sections_in_any_order) {
  const Input input = test::read_text(
      ".mesh",
      "MeshVersionFormatted 2\nDimension 3\nTriangles\n1\n1 2 3 0\nVertices\n3\n0 0 0 0\n1 0 0 0\n0 1 0 0\nEnd");
  BOOST_TEST(input.facets.size() == 1);
}

BOOST_AUTO_TEST_CASE(in_the_plane_the_edges_are_the_graph) {
  const Input input = test::read_text(".mesh", with(planar, "End", "Triangles 1\n1 2 3 0\nEnd"));
  BOOST_TEST(input.dimension == 2);
  BOOST_TEST(!input.triangle_soup);
  BOOST_TEST(input.vertices[2].marker == 7);
  BOOST_REQUIRE_EQUAL(input.segments.size(), 2);
  BOOST_TEST(input.segments[1].marker == 6);
  BOOST_TEST(input.facets.empty());
  BOOST_TEST(input.remarks.at(0) == "not read: 1 Triangles");
}

BOOST_AUTO_TEST_CASE(malformed) {
  const std::string head = "MeshVersionFormatted 2\nDimension 3\n";
  test::check_malformed(
      ".mesh",
      {{"empty", "", "E-TRUNCATED", 1, 1},
       {"another format", "OFF\n", "E-SYNTAX", 1, 1},
       {"version 5", with(surface, "Formatted 1", "Formatted 5"), "E-VALUE", 1, 0},
       {"no dimension", with(surface, "Dimension\n3\n", ""), "E-SYNTAX", 4, 1},
       {"dimension 4", with(surface, "Dimension\n3\n", "Dimension\n4\n"), "E-VALUE", 4, 1},
       {"keyword in small letters", with(surface, "Triangles 2", "triangles 2"), "E-SYNTAX", 14, 1},
       {"unknown section", with(surface, "Corners", "Colours"), "E-SYNTAX", 17, 1},
       {"no vertices", head + "End\n", "E-EMPTY", 1, 1},
       {"section twice", with(surface, "RequiredVertices 0", "Triangles 0"), "E-SYNTAX", 28, 1},
       {"count negative", with(surface, "Triangles 2", "Triangles -2"), "E-COUNT", 14, 11},
       {"count absurd", with(surface, "Triangles 2", "Triangles 2147483648"), "E-COUNT", 14, 11},
       {"count and more", with(surface, "Triangles 2", "Triangles 2 3"), "E-FIELDS", 14, 13},
       {"count and row on one line", with(surface, "Edges\n1\n", "Edges\n1 1\n"), "E-FIELDS", 24, 3},
       {"too few rows", with(surface, "Triangles 2", "Triangles 3"), "E-COUNT", 17, 1},
       {"too many rows", with(surface, "Triangles 2", "Triangles 1"), "E-SYNTAX", 16, 1},
       {"vertex without reference", with(surface, "1 1 0 2\n", "1 1 0\n"), "E-FIELDS", 10, 6},
       {"vertex nan", with(surface, "1 1 0 2\n", "1 nan 0 2\n"), "E-NUMBER", 10, 3},
       {"vertex not a number", with(surface, "1 1 0 2\n", "Ridge 1 0 2\n"), "E-NUMBER", 10, 1},
       {"reference real", with(surface, "1 1 0 2\n", "1 1 0 2.5\n"), "E-NUMBER", 10, 7},
       {"triangle without reference", with(surface, "1 2 5 10", "1 2 5"), "E-FIELDS", 15, 6},
       {"corner 0", with(surface, "1 2 5 10", "0 2 5 10"), "E-INDEX", 15, 1},
       {"corner 6", with(surface, "1 2 5 10", "1 6 5 10"), "E-INDEX", 15, 3},
       {"edge with three vertices", with(surface, "1 5 13", "1 5 2 13"), "E-FIELDS", 25, 7},
       {"no End", with(surface, "End\n", ""), "E-TRUNCATED", 28, 19},
       {"end in a section", head + "Vertices 2147483647\n0 0 0 0\n", "E-TRUNCATED", 4, 8},
       {"behind the end", surface + "Edges 0\n", "E-TRAILING", 30, 1},
       {"only tetrahedra", head + "Vertices 4\n0 0 0 0\n1 0 0 0\n0 1 0 0\n0 0 1 0\nTetrahedra 1\n1 2 3 4 0\nEnd\n",
        "E-EMPTY", 1, 1},
       {"planar without edges", with(planar, "Edges 2\n1 2 5\n2 3 6\n", "Triangles 1\n1 2 3 0\n"), "E-EMPTY", 1, 1},
       {"planar with a z", with(planar, "1 0 0\n", "1 0 0 0\n"), "E-FIELDS", 5, 7}});
}

BOOST_AUTO_TEST_SUITE_END()
