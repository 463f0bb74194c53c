// SPDX-License-Identifier: GPL-3.0-or-later
#include <boost/test/unit_test.hpp>

#include "tests/core/io/reader_fixture.h"

using namespace confidel;
using test::with;

namespace {

const std::string body = "0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 1 2\n4 0 1 2 3\n";
const std::string tetrahedron = "OFF\n4 2 0\n" + body;

}  // namespace

BOOST_AUTO_TEST_SUITE(io_off)

BOOST_AUTO_TEST_CASE(spellings_of_the_header) {
  for (const char* header :
       {"OFF\n4 2 0\n", "OFF 4 2 0\n", "OFF4 2 0\n", "OFF\n4 2\n", "OFF 4 2\n", "OFF4 2\n", "OFF\n4 2 99\n",
        "OFF\n# Created by meshio\n4 2 0\n", "# first\n\n  OFF # kind\n\n\n   4 2 0 # counts\n\n", "OFF\r\n4 2 0\r\n",
        "nOFF\n3\n4 2 0\n", "nOFF 3\n4 2 0\n", "nOFF 3 4 2 0\n", "nOFF\n3 4 2 0\n", "nOFF3\n4 2 0\n", "nOFF3 4 2\n",
        "\xEF\xBB\xBFOFF\n4 2 0\n"}) {
    BOOST_TEST_CONTEXT(header) {
      const Input input = test::read_text(".off", header + body);
      BOOST_TEST(input.dimension == 3);
      BOOST_TEST(input.first_index == 0);
      BOOST_TEST(input.triangle_soup);
      BOOST_TEST(!input.has_markers);
      BOOST_REQUIRE_EQUAL(input.vertices.size(), 4);
      BOOST_TEST(input.vertices[3].position == (std::array<double, 3>{0, 0, 1}));
      BOOST_REQUIRE_EQUAL(input.facets.size(), 2);
      BOOST_TEST(input.facets[1].polygons[0].corners == (std::vector<int>{0, 1, 2, 3}),
                 boost::test_tools::per_element());
    }
  }
  BOOST_TEST(test::read_text(".off", tetrahedron).facets[1].line == 8);
}

BOOST_AUTO_TEST_CASE(prefixes) {
  const std::string face = "3 0 1 2\n";
  const struct {
    const char* header;
    const char* rest;
  } table[] = {{"COFF", " 255 0 0 255"},
               {"COFF", " 1.0 0 0"},
               {"NOFF", " 0 0 1"},
               {"STOFF", " .5 .5"},
               {"4OFF", " 1"},
               {"CNOFF", " 0 0 1 .1 .2 .3 1"},
               {"NCOFF", " 0 0 1 .1 .2 .3"},
               {"STCN4OFF", " 1 0 0 1 1 1 1 1 .5 .5"}};
  for (const auto& entry : table) {
    BOOST_TEST_CONTEXT(entry.header) {
      std::string text = std::string(entry.header) + "\n3 1 0\n";
      for (const char* vertex : {"0 0 0", "1 0 0", "0 2 0"}) text += std::string(vertex) + entry.rest + "\n";
      const Input input = test::read_text(".off", text + face);
      BOOST_TEST(input.vertices[2].position == (std::array<double, 3>{0, 2, 0}));
      BOOST_TEST(input.facets.size() == 1);
    }
  }
  BOOST_TEST(test::read_text(".off", "4nOFF\n3\n1 0\n1 2 3 1\n").vertices.size() == 1);
}

BOOST_AUTO_TEST_CASE(colours_of_faces) {
  for (const char* colour : {"", " 7", " 255 0 0", " 0.5 0.5 0.5 1.0", " # 1 2"}) {
    BOOST_TEST(
        test::read_text(".off", with(tetrahedron, "3 0 1 2\n", std::string("3 0 1 2") + colour + "\n")).facets.size() ==
            2,
        colour);
  }
}

BOOST_AUTO_TEST_CASE(faces_with_fewer_corners) {
  const Input input = test::read_text(".off", with(with(tetrahedron, "4 0 1 2 3", "2 3 1"), "3 0 1 2", "1 2"));
  BOOST_TEST(input.facets.empty());
  BOOST_REQUIRE_EQUAL(input.segments.size(), 1);
  BOOST_TEST(input.segments[0].ends == (std::array<int, 2>{3, 1}));
  BOOST_TEST(input.remarks.size() == 2);
}

BOOST_AUTO_TEST_CASE(malformed) {
  test::check_malformed(
      ".off", {{"empty", "", "E-TRUNCATED", 1, 1},
               {"no keyword", "4 2 0\n" + body, "E-SYNTAX", 1, 1},
               {"another keyword", "PLY\n4 2 0\n" + body, "E-SYNTAX", 1, 1},
               {"keyword with a tail", "OFFX\n4 2 0\n" + body, "E-SYNTAX", 1, 1},
               {"prefix twice", "NNOFF\n4 2 0\n" + body, "E-SYNTAX", 1, 1},
               {"binary", "OFF BINARY\n", "E-FORMAT", 1, 5},
               {"dimension 4", "nOFF\n4\n1 0 0\n0 0 0 0\n", "E-VALUE", 2, 1},
               {"dimension 2, glued", "nOFF2 1 0 0\n0 0\n", "E-VALUE", 1, 1},
               {"counts missing", "OFF\n", "E-TRUNCATED", 1, 4},
               {"one count", "OFF\n4\n2 0\n" + body, "E-FIELDS", 2, 2},
               {"one glued count", "OFF4\n2 0\n" + body, "E-FIELDS", 1, 5},
               {"four counts", "OFF\n4 2 0 0\n" + body, "E-FIELDS", 2, 7},
               {"negative count", "OFF\n4 -2 0\n" + body, "E-COUNT", 2, 3},
               {"2^31 vertices", "OFF\n2147483648 2 0\n" + body, "E-COUNT", 2, 1},
               {"2^31 vertices, glued", "OFF2147483648 2 0\n" + body, "E-COUNT", 1, 4},
               {"glued count with a tail", "OFF4x 2 0\n" + body, "E-COUNT", 1, 4},
               {"2^31 - 1 vertices", "OFF\n2147483647 2 0\n0 0 0\n", "E-TRUNCATED", 3, 6},
               {"2^31 - 1 faces", with(tetrahedron, "4 2 0", "4 2147483647 0"), "E-TRUNCATED", 8, 10},
               {"octal-looking count is decimal", "OFF\n010 2 0\n" + body, "E-FIELDS", 7, 7},
               {"two coordinates", with(tetrahedron, "1 0 0\n", "1 0\n"), "E-FIELDS", 4, 4},
               {"colour without prefix", with(tetrahedron, "1 0 0\n", "1 0 0 255 0 0\n"), "E-FIELDS", 4, 7},
               {"decimal commas", with(tetrahedron, "1 0 0\n", "1,5 0,0 0,0\n"), "E-FIELDS", 4, 7},
               {"coordinate nan", with(tetrahedron, "1 0 0\n", "1 nan 0\n"), "E-NUMBER", 4, 3},
               {"w is not 1", "4OFF\n1 0\n1 1 1 2\n", "E-VALUE", 3, 7},
               {"index too large", with(tetrahedron, "4 0 1 2 3", "4 0 1 2 4"), "E-INDEX", 8, 9},
               {"index negative", with(tetrahedron, "4 0 1 2 3", "4 0 1 2 -1"), "E-INDEX", 8, 9},
               {"index hexadecimal", with(tetrahedron, "4 0 1 2 3", "4 0 1 2 0x3"), "E-NUMBER", 8, 9},
               {"face without corners", with(tetrahedron, "3 0 1 2\n", "0\n"), "E-VALUE", 7, 1},
               {"face too short", with(tetrahedron, "3 0 1 2\n", "3 0 1\n"), "E-FIELDS", 7, 6},
               {"face of 2^31 - 1 corners", with(tetrahedron, "3 0 1 2\n", "2147483647 0 1 2\n"), "E-FIELDS", 7, 17},
               {"colour of two numbers", with(tetrahedron, "3 0 1 2\n", "3 0 1 2 9 9\n"), "E-FIELDS", 7, 11},
               {"colour of five numbers", with(tetrahedron, "3 0 1 2\n", "3 0 1 2 9 9 9 9 9\n"), "E-FIELDS", 7, 17},
               {"face missing", with(tetrahedron, "4 0 1 2 3\n", ""), "E-TRUNCATED", 7, 8},
               {"face too many", tetrahedron + "3 0 1 2\n", "E-TRAILING", 9, 1}});
}

BOOST_AUTO_TEST_SUITE_END()
