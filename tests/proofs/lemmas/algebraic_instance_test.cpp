// SPDX-License-Identifier: GPL-3.0-or-later
// The lemmas on exact points; and that a point which is not where it belongs is noticed.
#include "proofs/lemmas/algebraic_instance.h"

#include <algorithm>
#include <boost/test/unit_test.hpp>

#include "core/complex/build.h"
#include "core/io/read.h"
#include "tests/support/placing.h"

using namespace confidel;
using namespace confidel::test;

namespace {

AlgebraicReport checked(const std::string& example, const GlobalRule& rule, long max_points, const AlgebraicChanges& changes = {}) {
  const Complex complex = build_complex(read_input(std::string(CONFIDEL_SOURCE_DIR) + "/examples/" + example)).complex;
  SilentProgress progress;
  return check_algebraically(complex, rule, {max_points, 1}, progress, changes);
}

const AlgebraicRow& row_of(const AlgebraicReport& report, const std::string& id) {
  const auto place = std::find_if(report.lemmas.begin(), report.lemmas.end(), [&](const AlgebraicRow& row) { return row.id == id; });
  BOOST_REQUIRE(place != report.lemmas.end());
  return *place;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(algebraic_instance)

BOOST_AUTO_TEST_CASE(points_are_where_the_paper_wants_them) {
  const AlgebraicReport report = checked("tetrahedron.off", repaired_rule(), 500);
  BOOST_TEST(report.holds());
  BOOST_TEST(!report.filled);
  for (const AlgebraicEquality& equality : report.equalities) {
    BOOST_TEST(equality.exact == equality.objects, equality.statement);
    BOOST_TEST(equality.objects > 0);
  }
  for (const char* id : {"H-ball", "H-offset", "H-chord", "L1"}) BOOST_TEST(row_of(report, id).equalities == row_of(report, id).exact.objects, id);
  BOOST_TEST(row_of(report, "L2").equalities == 0);
  BOOST_TEST(row_of(report, "L21").equalities == 3);  // the three pairs of opposite edges
}

// By less than a double can say of a coordinate: 2^-60 of an edge.
BOOST_AUTO_TEST_CASE(a_wrong_point_is_noticed) {
  const AlgebraicReport good = checked("tetrahedron.off", repaired_rule(), 500);
  const int last = static_cast<int>(good.points) - 1, first = 4;
  for (const int id : {first, last, last / 2}) {
    const AlgebraicReport report = checked("tetrahedron.off", repaired_rule(), 500, {{id, {0x1p-60, -0x1p-61, 0x1p-62}}});
    BOOST_TEST(!report.holds(), "point " << id);
    const bool equality = std::any_of(report.equalities.begin(), report.equalities.end(), [](const AlgebraicEquality& e) { return e.everywhere && e.exact < e.objects; });
    BOOST_TEST(equality, "point " << id);
  }
  // Every arc point by itself: off the sphere, and only that one.
  long noticed = 0;
  for (int id = 0; id < static_cast<int>(good.points) && noticed < 3; id += 7) {
    if (id < 4) continue;
    const AlgebraicReport report = checked("tetrahedron.off", repaired_rule(), 500, {{id, {0, 0x1p-70, 0}}});
    if (row_of(report, "H-ball").exact.failures > 0) ++noticed;
  }
  BOOST_TEST(noticed > 0);
}

BOOST_AUTO_TEST_CASE(a_limit_is_kept) {
  BOOST_CHECK_THROW(checked("cube.off", repaired_rule(), 499), LimitReached);
  BOOST_CHECK_THROW(checked("corner-45.poly", repaired_rule(), 500), std::invalid_argument);
}

BOOST_AUTO_TEST_SUITE_END()
