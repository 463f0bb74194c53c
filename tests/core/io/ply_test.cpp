// SPDX-License-Identifier: GPL-3.0-or-later
#include <boost/test/unit_test.hpp>
#include <limits>

#include "tests/core/io/binary_file.h"
#include "tests/core/io/reader_fixture.h"

using namespace confidel;
using test::with;

namespace {

const std::string text = R"(ply
format ascii 1.0
comment by hand # with a hash
obj_info nothing
element vertex 4
property float x
property float32 y
property double z
property uchar red
element face 2
property uchar quality
property list uchar int vertex_indices
property list uint8 float texcoord
element edge 1
property int vertex1
property int vertex2
element material 1
property int shininess
end_header
0 0 0 255
1 0 0 255
0 1 0 255   # corner
0 0 0.1 255

9 3 0 1 2 6 0 0 1 0 0 1
9 4 0 1 2 3 0
3 1
77
)";

std::string binary_header(bool big_endian, const std::string& name = "vertex_index") {
  return std::string("ply\nformat binary_") + (big_endian ? "big" : "little") +
         "_endian 1.0\ncomment x\nelement vertex 3\nproperty short x\nproperty float y\nproperty double z\n"
         "property list uchar short extra\nelement face 1\nproperty float quality\nproperty list int uint " +
         name + "\nend_header\n";
}

std::string binary(bool big_endian, const std::string& name = "vertex_index", double z = -0.0, unsigned corner = 2) {
  test::BinaryFile file(binary_header(big_endian, name), big_endian);
  for (int i = 0; i < 3; ++i) {
    file.integer(static_cast<std::uint16_t>(-i), 2).real32(0.1F).real64(i == 1 ? 0.1 : z).integer(i, 1);
    for (int k = 0; k < i; ++k) file.integer(12345, 2);
  }
  file.real32(std::numeric_limits<float>::quiet_NaN());
  file.integer(3, 4).integer(0, 4).integer(1, 4).integer(corner, 4);
  return file.bytes();
}

}  // namespace

BOOST_AUTO_TEST_SUITE(io_ply)

BOOST_AUTO_TEST_CASE(text_with_other_properties) {
  const Input input = test::read_text(".ply", text);
  BOOST_TEST(input.triangle_soup);
  BOOST_REQUIRE_EQUAL(input.vertices.size(), 4);
  BOOST_TEST(input.vertices[3].position == (std::array<double, 3>{0, 0, 0.1}));
  BOOST_TEST(input.vertices[3].line == 23);
  BOOST_REQUIRE_EQUAL(input.facets.size(), 2);
  BOOST_TEST(input.facets[0].polygons[0].corners == (std::vector<int>{0, 1, 2}), boost::test_tools::per_element());
  BOOST_TEST(input.facets[1].polygons[0].corners == (std::vector<int>{0, 1, 2, 3}), boost::test_tools::per_element());
  BOOST_TEST(input.facets[1].line == 26);
  BOOST_REQUIRE_EQUAL(input.segments.size(), 1);
  BOOST_TEST(input.segments[0].ends == (std::array<int, 2>{3, 1}));
  BOOST_REQUIRE_EQUAL(input.remarks.size(), 1);
  BOOST_TEST(input.remarks[0] == "element 'material' is not read");
}

BOOST_AUTO_TEST_CASE(text_with_carriage_returns) {
  std::string carriage = text;
  for (std::size_t i = 0; (i = carriage.find('\n', i)) != std::string::npos; i += 2) carriage.replace(i, 1, "\r\n");
  const Input input = test::read_text(".ply", carriage);
  BOOST_TEST(input.facets.size() == 2);
  BOOST_TEST(input.facets[1].line == 26);
}

BOOST_AUTO_TEST_CASE(elements_in_any_order) {
  const Input input =
      test::read_text(".ply",
                      "ply\nformat ascii 1.0\nelement face 1\nproperty list uchar int vertex_index\nelement vertex 3\n"
                      "property int z\nproperty int y\nproperty int x\nend_header\n3 0 1 2\n3 2 1\n0 0 0\n9 9 9");
  BOOST_TEST(input.vertices[0].position == (std::array<double, 3>{1, 2, 3}));
  BOOST_TEST(input.facets.size() == 1);
}

BOOST_AUTO_TEST_CASE(binary_of_both_byte_orders) {
  for (const bool big_endian : {false, true}) {
    for (const char* name : {"vertex_index", "vertex_indices"}) {
      const Input input = test::read_text(".ply", binary(big_endian, name));
      BOOST_REQUIRE_EQUAL(input.vertices.size(), 3);
      BOOST_TEST(input.vertices[1].position == (std::array<double, 3>{-1, static_cast<double>(0.1F), 0.1}));
      BOOST_TEST(input.vertices[1].line == 0);
      BOOST_REQUIRE_EQUAL(input.facets.size(), 1);
      BOOST_TEST(input.facets[0].polygons[0].corners == (std::vector<int>{0, 1, 2}), boost::test_tools::per_element());
    }
  }
  BOOST_TEST(test::read_text(".ply", binary(false) + "\r\n").facets.size() == 1);
}

BOOST_AUTO_TEST_CASE(malformed_text) {
  test::check_malformed(
      ".ply",
      {{"empty", "", "E-SYNTAX", 1, 1},
       {"another format", "OFF\n", "E-SYNTAX", 1, 1},
       {"no format", with(text, "format ascii 1.0\n", ""), "E-SYNTAX", 4, 1},
       {"unknown format", with(text, "format ascii", "format binary"), "E-FORMAT", 2, 8},
       {"unknown version", with(text, "ascii 1.0", "ascii 2.0"), "E-FORMAT", 2, 14},
       {"unknown word", with(text, "obj_info", "objinfo"), "E-SYNTAX", 4, 1},
       {"unknown type", with(text, "double z", "quad z"), "E-SYNTAX", 8, 10},
       {"element without count", with(text, "element vertex 4", "element vertex"), "E-FIELDS", 5, 15},
       {"element with a negative count", with(text, "element vertex 4", "element vertex -4"), "E-COUNT", 5, 16},
       {"2^31 vertices", with(text, "element vertex 4", "element vertex 2147483648"), "E-COUNT", 5, 16},
       {"2^31 - 1 vertices", with(text, "element vertex 4", "element vertex 2147483647"), "E-FIELDS", 25, 9},
       {"element twice", with(text, "element edge", "element face"), "E-SYNTAX", 14, 9},
       {"element without properties", with(text, "property int shininess\n", ""), "E-SYNTAX", 17, 0},
       {"property before elements", with(text, "comment by", "property int w\ncomment by"), "E-SYNTAX", 3, 1},
       {"property twice", with(text, "float32 y", "float32 x"), "E-SYNTAX", 7, 18},
       {"no z", with(text, "double z", "double height"), "E-SYNTAX", 5, 0},
       {"z is a list", with(text, "double z", "list uchar double z"), "E-SYNTAX", 5, 0},
       {"no corners", with(text, "vertex_indices", "corners"), "E-SYNTAX", 10, 0},
       {"corners are real", with(text, "uchar int vertex_indices", "uchar float vertex_indices"), "E-SYNTAX", 10, 0},
       {"length is real", with(text, "list uchar int", "list float int"), "E-SYNTAX", 12, 15},
       {"strips", with(text, "element material", "element tristrips"), "E-FORMAT", 17, 0},
       {"no end of the header", with(text, "end_header\n", ""), "E-TRUNCATED", 0, 0},
       {"end of the header with a comment", with(text, "end_header\n", "end_header # x\n"), "E-TRUNCATED", 0, 0},
       {"value missing", with(text, "1 0 0 255", "1 0 0"), "E-FIELDS", 21, 6},
       {"value too many", with(text, "1 0 0 255", "1 0 0 255 255"), "E-FIELDS", 21, 11},
       {"coordinate nan", with(text, "1 0 0 255", "1 0 nan 255"), "E-NUMBER", 21, 5},
       {"corner too large", with(text, "9 4 0 1 2 3 0", "9 4 0 1 2 4 0"), "E-INDEX", 26, 11},
       {"corner negative", with(text, "9 4 0 1 2 3 0", "9 4 0 1 2 -1 0"), "E-INDEX", 26, 11},
       {"face without corners", with(text, "9 4 0 1 2 3 0", "9 0 0"), "E-VALUE", 26, 0},
       {"face with a negative length", with(text, "9 4 0 1 2 3 0", "9 -4 0"), "E-COUNT", 26, 3},
       {"face of 2^31 - 1 corners", with(text, "9 4 0 1 2 3 0", "9 2147483647 0 1 2 3 0"), "E-FIELDS", 26, 23},
       {"end too soon", with(text, "77\n", ""), "E-TRUNCATED", 27, 4},
       {"behind the end", text + "77\n", "E-TRAILING", 29, 1}});
}

BOOST_AUTO_TEST_CASE(malformed_binary) {
  const double infinity = std::numeric_limits<double>::infinity();
  std::string absurd_list = binary(false);
  absurd_list.replace(absurd_list.size() - 16, 4, "\xFF\xFF\xFF\x7F");
  std::string negative_list = binary(true);
  negative_list.replace(negative_list.size() - 16, 4, "\xFF\xFF\xFF\xFF");
  test::check_malformed(".ply",
                        {{"cut", binary(false).substr(0, binary(false).size() - 1), "E-TRUNCATED", 0, 0},
                         {"only the header", binary_header(true), "E-TRUNCATED", 0, 0},
                         {"longer", binary(false) + "x", "E-TRAILING", 0, 0},
                         {"not finite", binary(true, "vertex_index", infinity), "E-NUMBER", 0, 0},
                         {"corner too large", binary(false, "vertex_index", 0, 3), "E-INDEX", 0, 0},
                         {"corner beyond 32 bits", binary(true, "vertex_index", 0, 0xFFFFFFFF), "E-INDEX", 0, 0},
                         {"absurd list", absurd_list, "E-TRUNCATED", 0, 0},
                         {"negative list", negative_list, "E-COUNT", 0, 0}});
  std::string absurd_count = binary(false);
  absurd_count.replace(absurd_count.find("vertex 3"), 8, "vertex 2147483647");
  BOOST_TEST(test::problems_of(".ply", absurd_count).at(0).code == "E-TRUNCATED");
}

BOOST_AUTO_TEST_SUITE_END()
