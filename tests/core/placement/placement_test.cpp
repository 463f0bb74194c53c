// SPDX-License-Identifier: GPL-3.0-or-later
// The results of the strategies: carriers, exact tiling, empty spheres, against all points in rationals.
#include "core/placement/placement.h"

#include <boost/test/unit_test.hpp>

#include "tests/support/exact_placement.h"
#include "tests/support/placing.h"
#include "tests/support/small_inputs.h"

using namespace confidel;
using namespace confidel::test;

namespace {

bool same(const Placement& a, const Placement& b) {
  if (a.points.size() != b.points.size() || a.cells.size() != b.cells.size() || a.hanging != b.hanging) return false;
  for (std::size_t i = 0; i < a.points.size(); ++i)
    if (!(a.points[i].position == b.points[i].position) || a.points[i].kind != b.points[i].kind || a.points[i].carrier != b.points[i].carrier) return false;
  for (std::size_t i = 0; i < a.cells.size(); ++i)
    if (a.cells[i].corners != b.cells[i].corners || a.cells[i].facet != b.cells[i].facet || a.cells[i].kind != b.cells[i].kind || a.cells[i].offset != b.cells[i].offset) return false;
  return true;
}

void check(const NamedInput& named, Strategy strategy) {
  BOOST_TEST_CONTEXT(name_of(strategy) << ": " << named.name) {
    const Complex complex = build_complex(named.input).complex;
    const Placement placement = place(complex, strategy);
    BOOST_TEST_MESSAGE(name_of(strategy) << ": " << named.name << ": " << placement.points.size() << " points");
    BOOST_CHECK_NO_THROW(ExactPlacement(complex, placement).require_all());
    BOOST_TEST(same(placement, place(complex, strategy, 0, 2)));
  }
}

}  // namespace

BOOST_AUTO_TEST_SUITE(placement)

BOOST_AUTO_TEST_CASE(graded) {
  for (const NamedInput& named : small_inputs()) check(named, Strategy::graded);
}

BOOST_AUTO_TEST_CASE(lean) {
  for (const NamedInput& named : small_inputs()) check(named, Strategy::lean);
}

BOOST_AUTO_TEST_CASE(limits) {
  const Complex complex = build_complex(wedge(2, 0.3)).complex;
  try {
    place(complex, Strategy::graded, 300);
    BOOST_ERROR("no limit was reached");
  } catch (const LimitReached& limit) {
    BOOST_TEST(limit.what() == std::string("max-points"));
    BOOST_TEST(limit.points_reached > 0);
  }
  struct Impatient : SilentProgress {
    bool stop_requested(long points) override { return points > 100; }
  } progress;
  BOOST_CHECK_THROW(place_graded(complex, compute_features(complex), {0, 2}, progress), LimitReached);
}

BOOST_AUTO_TEST_CASE(size_rules) {
  // r_v = delta_v/3, d_e = min(g_e/3, r_v sin(min(theta/3, 0.7 omega, pi/6))).
  for (const NamedInput& named : small_inputs()) {
    const Complex complex = build_complex(named.input).complex;
    const Features features = compute_features(complex);
    const BufferSizes sizes = graded_sizes(complex, features);
    for (std::size_t v = 0; v < complex.vertices.size(); ++v) BOOST_TEST(sizes.radius[v] <= features.vertex_distance[v] / 3);
    for (std::size_t s = 0; s < complex.segments.size(); ++s) {
      BOOST_TEST(sizes.offset[s] > 0);
      BOOST_TEST(sizes.offset[s] <= features.segment_distance[s] / 3);
      for (int end : {0, 1}) {
        const double sine = sizes.offset[s] / sizes.radius[complex.segments[s][end]];
        BOOST_TEST(sine <= std::sin(features.segment_angle[s][end] / 3) * (1 + 1e-12));
        BOOST_TEST(sine <= std::sin(0.7 * features.facet_angle[s][end]) * (1 + 1e-12));
        BOOST_TEST(sine <= 0.5 * (1 + 1e-12));
      }
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()
