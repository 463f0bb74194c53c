// SPDX-License-Identifier: GPL-3.0-or-later
#include <boost/test/unit_test.hpp>
#include <limits>

#include "tests/core/io/binary_file.h"
#include "tests/core/io/reader_fixture.h"

using namespace confidel;
using test::with;

namespace {

const std::string text = R"(solid part #1, by hand
  facet normal 0 0 1
    outer loop
      vertex 0 0 0
      vertex 1 0 0
      vertex 0 1 0
    endloop
  endfacet
  facet normal nan -nan(ind) 0   # normals are not used
    outer loop
      vertex -0.0 1e0 0
      vertex 1 -0 0
      vertex 1 1 0.1
    endloop
  endfacet
endsolid part #1
)";

/// Two triangles with a common edge, one of its ends spelled with negative zeros.
std::string binary(const std::string& header, std::uint32_t announced = 2, float last = 0.1F) {
  std::string begin = header;
  begin.resize(80);
  test::BinaryFile file(begin);
  file.integer(announced, 4);
  for (const float x : {0.F, 0.F, 1.F, 0.F, 0.F, 0.F, 1.F, 0.F, 0.F, 0.F, 1.F, 0.F}) file.real32(x);
  file.integer(0, 2);
  for (const float x : {0.F, 0.F, 0.F, -0.F, 1.F, -0.F, 1.F, 0.F, 0.F, 1.F, 1.F, last}) file.real32(x);
  file.integer(7, 2);
  return file.bytes();
}

}  // namespace

BOOST_AUTO_TEST_SUITE(io_stl)

BOOST_AUTO_TEST_CASE(text_with_identical_corners) {
  const Input input = test::read_text(".stl", text);
  BOOST_TEST(input.triangle_soup);
  BOOST_TEST(!input.has_markers);
  BOOST_REQUIRE_EQUAL(input.vertices.size(), 4);
  BOOST_TEST(input.vertices[3].position == (std::array<double, 3>{1, 1, 0.1}));
  BOOST_TEST(input.vertices[3].line == 13);
  BOOST_REQUIRE_EQUAL(input.facets.size(), 2);
  BOOST_TEST(input.facets[1].polygons[0].corners == (std::vector<int>{2, 1, 3}), boost::test_tools::per_element());
  BOOST_TEST(input.facets[1].line == 9);
  BOOST_REQUIRE_EQUAL(input.remarks.size(), 1);
  BOOST_TEST(input.remarks[0] == "6 corners are 4 vertices: bit-identical ones are merged");
}

BOOST_AUTO_TEST_CASE(several_solids_are_markers) {
  const Input input = test::read_text(".stl", text + "SOLID\nENDSOLID\n" + text);
  BOOST_TEST(input.has_markers);
  BOOST_REQUIRE_EQUAL(input.facets.size(), 4);
  BOOST_TEST(input.facets[0].marker == 1);
  BOOST_TEST(input.facets[3].marker == 3);
  BOOST_TEST(input.vertices.size() == 4);
  BOOST_TEST(input.remarks.size() == 2);
}

BOOST_AUTO_TEST_CASE(binary_also_if_it_begins_like_text) {
  for (const char* header : {"", "made by hand", "solid part"}) {
    const Input input = test::read_text(".stl", binary(header));
    BOOST_REQUIRE_EQUAL(input.vertices.size(), 4);
    BOOST_TEST(input.vertices[3].position == (std::array<double, 3>{1, 1, static_cast<double>(0.1F)}));
    BOOST_REQUIRE_EQUAL(input.facets.size(), 2);
    BOOST_TEST(input.facets[1].polygons[0].corners == (std::vector<int>{2, 1, 3}), boost::test_tools::per_element());
    BOOST_TEST(input.facets[1].line == 0);
  }
}

BOOST_AUTO_TEST_CASE(malformed) {
  const std::string begin = text.substr(0, text.find("  facet normal nan"));
  test::check_malformed(
      ".stl", {{"empty", "", "E-TRUNCATED", 1, 1},
               {"another format", "OFF\n1 0 0\n", "E-SYNTAX", 1, 1},
               {"no endsolid", begin, "E-TRUNCATED", 8, 11},
               {"no facet", "solid\nvertex 0 0 0\n", "E-SYNTAX", 2, 1},
               {"no normal", with(text, "  facet normal 0 0 1\n", "  facet 0 0 1\n"), "E-SYNTAX", 2, 9},
               {"facet alone", with(text, "  facet normal 0 0 1\n", "  facet\n"), "E-SYNTAX", 2, 8},
               {"normal of two numbers", with(text, "  facet normal 0 0 1\n", "facet normal 0 1\n"), "E-FIELDS", 2, 17},
               {"two corners", with(text, "      vertex 1 0 0\n", ""), "E-SYNTAX", 6, 5},
               {"four corners", with(text, "      vertex 1 0 0\n", "vertex 1 0 0\nvertex 1 0 0\n"), "E-SYNTAX", 7, 7},
               {"two coordinates", with(text, "vertex 1 0 0\n", "vertex 1 0\n"), "E-FIELDS", 5, 17},
               {"four coordinates", with(text, "vertex 1 0 0\n", "vertex 1 0 0 1\n"), "E-FIELDS", 5, 20},
               {"corner at infinity", with(text, "vertex 1 0 0\n", "vertex 1 inf 0\n"), "E-NUMBER", 5, 16},
               {"end in the first facet", begin.substr(0, begin.find("    endloop")), "E-TRUNCATED", 6, 19},
               {"behind the end", text + "vertex 0 0 0\n", "E-SYNTAX", 17, 1},
               {"binary, too short", binary("").substr(0, 183), "E-TRUNCATED", 0, 0},
               {"binary, too long", binary("") + "x", "E-TRUNCATED", 0, 0},
               {"binary, absurd count", binary("", 0xFFFFFFFF), "E-TRUNCATED", 0, 0},
               {"binary, no header", binary("").substr(0, 60), "E-TRUNCATED", 0, 0},
               {"binary, nan", binary("", 2, std::numeric_limits<float>::quiet_NaN()), "E-NUMBER", 0, 0}});
  const std::vector<Problem> problems =
      test::problems_of(".stl", binary("", 2, std::numeric_limits<float>::infinity()));
  BOOST_TEST(problems.at(0).message == "triangle 2 (byte 170) has a corner that is not finite");
}

BOOST_AUTO_TEST_SUITE_END()
