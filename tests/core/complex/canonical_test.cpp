// SPDX-License-Identifier: GPL-3.0-or-later
#include <boost/test/unit_test.hpp>

#include "core/complex/build.h"
#include "tests/core/complex/inputs.h"
#include "tests/core/complex/triangulation_rules.h"

using namespace confidel;
using namespace confidel::test;

BOOST_AUTO_TEST_SUITE(complex_canonical)

BOOST_AUTO_TEST_CASE(sha256_of_known_texts) {
  // FIPS 180-2, appendix B.
  BOOST_TEST(sha256("") == "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  BOOST_TEST(sha256("abc") == "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
}

BOOST_AUTO_TEST_CASE(points_have_one_spelling) {
  const auto spell = [](double x, double y, double z, int dimension = 3) {
    return canonical_point(Point::from_doubles(x, y, z), dimension);
  };
  BOOST_TEST(spell(0, 0, 0) == "0 0 0 1");
  BOOST_TEST(spell(-0.0, 0, 0) == "0 0 0 1");
  BOOST_TEST(spell(10, -16, 255) == "a -10 ff 1");
  BOOST_TEST(spell(0.5, -0.25, 3) == "2 -1 c 4");
  BOOST_TEST(spell(4, 8, 1024) == "4 8 400 1");
  BOOST_TEST(spell(0.1, 0, 0) == "ccccccccccccd 0 0 80000000000000");
  BOOST_TEST(spell(0.5, 1, 0, 2) == "1 2 2");
}

BOOST_AUTO_TEST_CASE(worked_example) {
  // docs/certificate-format.md, section 7.
  InputMaker maker;
  maker.vertices({{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {1, 1, 5}, {1, 1, 9}}).facet({{0, 1, 2}}).segment(4, 3);
  const std::string text = canonical_text(build_complex(maker).complex);
  BOOST_TEST(text ==
             "plc 1\ndim 3\nvertices 5\nv 0 0 0 1\nv 4 0 0 1\nv 0 4 0 1\nv 1 1 5 1\nv 1 1 9 1\n"
             "segments 4\ns 0 1\ns 0 2\ns 1 2\ns 3 4\nfacets 1\nf 0 1 2\nb 3\n0 1\n1 2\n2 0\nc 0\np 0\nend\n");
  BOOST_TEST(sha256(text) == "680b430c4cf762c7e9ef3d597ce3704f7f45f3f7269fa1723b5d7f076d1ad8e3");
}

BOOST_AUTO_TEST_CASE(dimension_two) {
  InputMaker maker(2);
  maker.vertices({{0, 0, 0}, {0.5, 0, 0}, {0, 1, 0}, {0.125, 0.25, 0}}).segment(0, 1).segment(1, 2).segment(2, 0);
  BOOST_TEST(canonical_text(build_complex(maker).complex) ==
             "plc 1\ndim 2\nvertices 4\nv 0 0 1\nv 1 0 2\nv 0 1 1\nv 1 2 8\n"
             "segments 3\ns 0 1\ns 0 2\ns 1 2\nfacets 1\nf 0 1 2\nb 3\n0 1\n1 2\n2 0\nc 0\np 1\n3\nend\n");
}

BOOST_AUTO_TEST_CASE(everything_a_facet_can_have) {
  auto vertices = nested_squares();
  vertices.push_back({0.125, 0.5, 0});
  InputMaker maker;
  maker.vertices(vertices).facet({{3, 2, 1, 0}, {4, 5, 6, 7}, {1, 5}, {8}}, {{0.5, 0.5, 0}});
  const std::string text = canonical_text(build_complex(maker).complex);
  // Clockwise seen from above: the positive side is below.
  BOOST_TEST(text.substr(text.find("facets")) ==
             "facets 1\nf 0 2 1\nb 8\n0 3\n1 0\n2 1\n3 2\n4 5\n5 6\n6 7\n7 4\nc 1\n1 5\np 1\n8\nend\n");
}

BOOST_AUTO_TEST_CASE(reader_refuses_what_the_rules_forbid) {
  // The test's own reader has to be able to fail.
  InputMaker maker;
  auto vertices = square();
  vertices.push_back({0.25, 0.25, 0});
  vertices.push_back({0.75, 0.25, 0});
  maker.vertices(vertices).facet({{0, 1, 2, 3}, {4, 5}});
  const std::string good = canonical_text(build_complex(maker).complex);
  require_rules(CanonicalReader(good).read());
  const auto refuses = [&](const std::string& from, const std::string& to) {
    std::string bad = good;
    const auto place = bad.find(from);
    BOOST_REQUIRE(place != std::string::npos);
    bad.replace(place, from.size(), to);
    try {
      require_rules(CanonicalReader(bad).read());
    } catch (const std::runtime_error&) {
      return true;
    }
    return false;
  };
  BOOST_TEST(refuses("\n0 1\n", "\n1 0\n"));      // a boundary edge reversed
  BOOST_TEST(refuses("c 1\n4 5", "c 1\n0 1"));    // both boundary and constraint
  BOOST_TEST(refuses("c 1\n4 5", "c 1\n2 4"));    // no segment
  BOOST_TEST(refuses("p 0\n", "p 1\n4\n"));       // isolated, but on an edge
  BOOST_TEST(refuses("v 1 0 0 1", "v 2 0 0 2"));  // gcd
  BOOST_TEST(refuses("v 1 1 0 1", "v 1 1 1 1"));  // not coplanar
}

BOOST_AUTO_TEST_SUITE_END()
