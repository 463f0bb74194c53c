// SPDX-License-Identifier: GPL-3.0-or-later
#include "campaigns/shrink.h"

#include <boost/test/unit_test.hpp>
#include <algorithm>

#include "campaigns/families.h"
#include "campaigns/instance.h"
#include "core/complex/build.h"

using namespace confidel;
using namespace confidel::campaigns;

BOOST_AUTO_TEST_SUITE(shrinking)

BOOST_AUTO_TEST_CASE(one_facet_is_left_of_many) {
  const Input input = generate(*find_family("two-skeleton"), 4);
  const Input small = shrink(input, {[](const Input& candidate) { return !candidate.facets.empty(); }});
  BOOST_CHECK_EQUAL(small.facets.size(), 1U);
  BOOST_CHECK_EQUAL(small.vertices.size(), 3U);
  BOOST_CHECK(is_valid(small));
  // Nothing is simpler than corners on axes.
  BOOST_CHECK_LE(measure(small)[3], 6U);
}

BOOST_AUTO_TEST_CASE(what_is_kept_is_kept_and_steps_go_down) {
  const Input input = generate(*find_family("fan"), 3);
  Measure last = measure(input);
  long asked = 0;
  const auto shares_an_edge = [&](const Input& candidate) {
    ++asked;
    BOOST_CHECK(is_valid(candidate));
    const Complex complex = build_complex(candidate).complex;
    std::size_t most = 0;
    for (const Segment& segment : complex.segments) {
      std::size_t sheets = 0;
      for (const Facet& facet : complex.facets)
        sheets += std::any_of(facet.boundary.begin(), facet.boundary.end(), [&](const auto& edge) { return std::min(edge[0], edge[1]) == segment[0] && std::max(edge[0], edge[1]) == segment[1]; }) ? 1 : 0;
      most = std::max(most, sheets);
    }
    return most >= 2;
  };
  const Input small = shrink(input, {shares_an_edge});
  BOOST_CHECK(shares_an_edge(small));
  BOOST_CHECK_EQUAL(small.facets.size(), 2U);
  BOOST_CHECK_EQUAL(small.vertices.size(), 4U);
  BOOST_CHECK(measure(small) < last);
  BOOST_CHECK_GT(asked, 3);
}

BOOST_AUTO_TEST_CASE(holes_slits_and_vertices_of_polygons_go) {
  const Input input = generate(*find_family("polygons"), 2);
  const Input small = shrink(input, {[](const Input& candidate) { return !candidate.facets.empty(); }});
  BOOST_CHECK_EQUAL(small.facets.size(), 1U);
  BOOST_CHECK_EQUAL(small.facets[0].polygons.size(), 1U);
  BOOST_CHECK_EQUAL(small.facets[0].polygons[0].corners.size(), 3U);
}

BOOST_AUTO_TEST_CASE(it_stops_when_told_and_refuses_what_does_not_do_it) {
  const Input input = generate(*find_family("fan"), 3);
  const Input same = shrink(input, {[](const Input&) { return true; }, [] { return true; }});
  BOOST_CHECK(measure(same) == measure(input));
  BOOST_CHECK_THROW(shrink(input, {[](const Input&) { return false; }}), std::invalid_argument);
}

BOOST_AUTO_TEST_CASE(the_smallest_double_shrinks) {
  Maker maker(2);
  maker.segment(maker.vertex({0, -0x1p-1074, 0}), maker.vertex({1, 0, 0}));
  const Input small = shrink(maker.input(), {[](const Input& candidate) { return candidate.vertices.size() == 2; }});
  BOOST_CHECK_EQUAL(small.vertices[0].position[1], 0);
}

BOOST_AUTO_TEST_CASE(planar_graphs_shrink_too) {
  const Input input = generate(*find_family("planar-graph"), 1);
  const Input small = shrink(input, {[](const Input& candidate) { return !candidate.segments.empty(); }});
  BOOST_CHECK_EQUAL(small.segments.size(), 1U);
  BOOST_CHECK_LE(small.vertices.size(), 3U);
}

BOOST_AUTO_TEST_SUITE_END()
