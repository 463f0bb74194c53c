// SPDX-License-Identifier: GPL-3.0-or-later
#include <boost/test/unit_test.hpp>

#include "tests/core/io/reader_fixture.h"

using namespace confidel;
using test::with;

namespace {

const std::string part = R"(# a part
mtllib part#1.mtl
v 0 0 0
v 1 0 0 1.0        # with a weight
v 0 1 0 .1 .2 .3   # with a colour
v 0 0 1
vt 0.5 0.5
vn 0 0 1
vp 0.1
s off
f 1 2 3
o body#1
f 1/1/1 2//1 3/1 \
  4/1/1
g side top
usemtl steel
f -1 -2 -3
g
v 5 5 5
l 1 2 -1
p 1
)";

}  // namespace

BOOST_AUTO_TEST_SUITE(io_obj)

BOOST_AUTO_TEST_CASE(records) {
  const Input input = test::read_text(".obj", part);
  BOOST_TEST(input.dimension == 3);
  BOOST_TEST(input.first_index == 1);
  BOOST_TEST(input.triangle_soup);
  BOOST_REQUIRE_EQUAL(input.vertices.size(), 5);
  BOOST_TEST(input.vertices[2].position == (std::array<double, 3>{0, 1, 0}));
  BOOST_TEST(input.vertices[4].line == 19);
  BOOST_REQUIRE_EQUAL(input.facets.size(), 3);
  const auto corners = [&](std::size_t facet) { return input.facets[facet].polygons[0].corners; };
  BOOST_TEST(corners(0) == (std::vector<int>{0, 1, 2}), boost::test_tools::per_element());
  BOOST_TEST(corners(1) == (std::vector<int>{0, 1, 2, 3}), boost::test_tools::per_element());
  BOOST_TEST(corners(2) == (std::vector<int>{3, 2, 1}), boost::test_tools::per_element());
  BOOST_TEST(input.facets[1].line == 13);
  BOOST_REQUIRE_EQUAL(input.segments.size(), 2);
  BOOST_TEST(input.segments[0].ends == (std::array<int, 2>{0, 1}));
  BOOST_TEST(input.segments[1].ends == (std::array<int, 2>{1, 4}));
}

BOOST_AUTO_TEST_CASE(groups_are_markers) {
  const Input input = test::read_text(".obj", part);
  BOOST_TEST(input.has_markers);
  BOOST_TEST(input.facets[0].marker == 0);
  BOOST_TEST(input.facets[1].marker == 1);
  BOOST_TEST(input.facets[2].marker == 3);
  BOOST_TEST(input.segments[0].marker == 4);
  BOOST_REQUIRE_EQUAL(input.remarks.size(), 1);
  BOOST_TEST(input.remarks[0].find("1 = o body#1") != std::string::npos, input.remarks[0]);
  BOOST_TEST(input.remarks[0].find("3 = g side top, o body#1, usemtl steel") != std::string::npos, input.remarks[0]);
  // Entering a group again is the same group.
  const Input again = test::read_text(".obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\ng a\nf 1 2 3\ng b\nf 1 2 3\ng a\nf 1 2 3\n");
  BOOST_TEST(again.facets[0].marker == again.facets[2].marker);
  BOOST_TEST(again.facets[0].marker != again.facets[1].marker);
  BOOST_TEST(!test::read_text(".obj", "v 0 0 0\ns 1\n").has_markers);
}

BOOST_AUTO_TEST_CASE(faces_may_come_first) {
  const Input input = test::read_text(".obj", "f 1 2 3\nv 0 0 0\nv 1 0 0\nv 0 1 0");
  BOOST_TEST(input.facets[0].polygons[0].corners == (std::vector<int>{0, 1, 2}), boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(continued_lines_keep_their_places) {
  test::check_malformed(".obj", {{"second line", "v 0 0 0\nf 1 1 \\\n 1 9\n", "E-INDEX", 3, 4},
                                 {"second line too short", "v 0 0 \\\r\n\nv 1 1 1\n", "E-FIELDS", 1, 6}});
}

BOOST_AUTO_TEST_CASE(malformed) {
  const std::string good = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
  test::check_malformed(".obj", {{"two coordinates", "v 0 0\n" + good, "E-FIELDS", 1, 6},
                                 {"six fields", "v 0 0 0 1 1\n" + good, "E-FIELDS", 1, 11},
                                 {"eight fields", "v 0 0 0 1 1 1 1\n" + good, "E-FIELDS", 1, 15},
                                 {"commas", "v 0,0,0\n" + good, "E-FIELDS", 1, 8},
                                 {"infinite coordinate", "v 0 0 inf\n" + good, "E-NUMBER", 1, 7},
                                 {"colour is a word", "v 0 0 0 red 0 0\n" + good, "E-NUMBER", 1, 9},
                                 {"two corners", good + "f 1 2\n", "E-FIELDS", 5, 6},
                                 {"corner 0", good + "f 1 2 0\n", "E-INDEX", 5, 7},
                                 {"corner too large", good + "f 1 2 4\n", "E-INDEX", 5, 7},
                                 {"corner too negative", good + "f 1 2 -4\n", "E-INDEX", 5, 7},
                                 {"relative corner before its vertex", "f -1 -2 -3\n" + good, "E-INDEX", 1, 3},
                                 {"corner beyond 32 bits", good + "f 1 2 4294967297\n", "E-INDEX", 5, 7},
                                 {"corner without number", good + "f 1 2 /1\n", "E-NUMBER", 5, 7},
                                 {"corner with open slash", good + "f 1 2 3/\n", "E-NUMBER", 5, 7},
                                 {"corner with two open slashes", good + "f 1 2 3//\n", "E-NUMBER", 5, 7},
                                 {"corner with three slashes", good + "f 1 2 3/1/1/1\n", "E-NUMBER", 5, 7},
                                 {"corner hexadecimal", good + "f 1 2 0x3\n", "E-NUMBER", 5, 7},
                                 {"corner real", good + "f 1 2 3.0\n", "E-NUMBER", 5, 7},
                                 {"polyline of one vertex", good + "l 1\n", "E-FIELDS", 5, 4},
                                 {"unknown record", good + "frobnicate 1\n", "E-SYNTAX", 5, 1},
                                 {"free-form geometry", good + "curv 0 1 1 2\n", "E-SYNTAX", 5, 1},
                                 {"capital letter", "V 0 0 0\n" + good, "E-SYNTAX", 1, 1},
                                 {"another format", "OFF\n4 2 0\n", "E-SYNTAX", 1, 1}});
  const std::vector<Problem> problems = test::problems_of(".obj", "f 1 2\nv 0 0\n");
  BOOST_REQUIRE_EQUAL(problems.size(), 2);
  BOOST_TEST(problems[0].place.line == 1, "problems come in the order of the file");
}

BOOST_AUTO_TEST_SUITE_END()
