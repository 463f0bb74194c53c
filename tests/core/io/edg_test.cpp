// SPDX-License-Identifier: GPL-3.0-or-later
#include <boost/test/unit_test.hpp>

#include "tests/core/io/reader_fixture.h"

using namespace confidel;

BOOST_AUTO_TEST_SUITE(io_edg)

BOOST_AUTO_TEST_CASE(equal_ends_are_one_vertex) {
  const Input input = test::read_text(".edg", "4\n\n0 0 \t 1 -0.0  # comment\n1 0 1 1\n1.0,1 -0 0\n\n5 5 5 5\n\n");
  BOOST_TEST(input.dimension == 2);
  BOOST_TEST(!input.has_markers);
  BOOST_REQUIRE_EQUAL(input.vertices.size(), 4);
  BOOST_TEST(input.vertices[2].position == (std::array<double, 3>{1, 1, 0}));
  BOOST_REQUIRE_EQUAL(input.segments.size(), 3);
  BOOST_TEST(input.segments[2].ends == (std::array<int, 2>{2, 0}));
  BOOST_TEST(input.segments[2].line == 5);
  // A segment without length is its point.
  BOOST_TEST(input.vertices[3].position == (std::array<double, 3>{5, 5, 0}));
  BOOST_REQUIRE_EQUAL(input.remarks.size(), 2);
  BOOST_TEST(input.remarks[0] == "8 corners are 4 vertices: bit-identical ones are merged");
  BOOST_TEST(input.remarks[1].find("line 7") != std::string::npos, input.remarks[1]);
}

BOOST_AUTO_TEST_CASE(nearby_ends_are_two_vertices) {
  const Input input = test::read_text(".edg", "2\n0 0 1 0.1\n1 0.10000000000000001 1 0.10000000000000003");
  BOOST_TEST(input.vertices.size() == 3);
}

BOOST_AUTO_TEST_CASE(malformed) {
  test::check_malformed(".edg", {{"empty", "\n", "E-TRUNCATED", 1, 1},
                                 {"count and more", "1 0 0 1 1\n", "E-FIELDS", 1, 3},
                                 {"count negative", "-1\n", "E-COUNT", 1, 1},
                                 {"count absurd", "99999999999\n0 0 1 1\n", "E-COUNT", 1, 1},
                                 {"count too large", "2147483647\n0 0 1 1\n", "E-TRUNCATED", 2, 8},
                                 {"count too small", "1\n0 0 1 1\n1 1 2 2\n", "E-TRAILING", 3, 1},
                                 {"three numbers", "1\n0 0 1\n", "E-FIELDS", 2, 6},
                                 {"five numbers", "1\n0 0 1 1 1\n", "E-FIELDS", 2, 9},
                                 {"nan", "1\n0 0 1 nan\n", "E-NUMBER", 2, 7},
                                 {"a word", "1\n0 x 1 1\n", "E-NUMBER", 2, 3}});
}

BOOST_AUTO_TEST_SUITE_END()
