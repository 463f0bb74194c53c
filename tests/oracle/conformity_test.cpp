// SPDX-License-Identifier: GPL-3.0-or-later
// The oracle on the results of both strategies and on the test certificates.
#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <filesystem>

#include "tests/oracle/subdivisions.h"
#include "tests/support/certificate_reader.h"
#include "tests/support/placing.h"
#include "tests/support/random_inputs.h"
#include "tests/support/rationals.h"
#include "tests/support/small_inputs.h"

using namespace confidel;
using namespace confidel::test;

namespace {

constexpr std::size_t most_points = 500;

/// Returns the number of points, or 0 if there are too many for the oracle.
std::size_t check(const NamedInput& named, Strategy strategy, int perturbed) {
  const Complex complex = build_complex(named.input).complex;
  Placement placement;
  try {
    placement = place(complex, strategy, most_points);
  } catch (const LimitReached&) {
    return 0;
  }
  std::vector<Rational3> points;
  for (const PlacedPoint& point : placement.points) points.push_back(rational(point.position.scaled(complex.scale)));
  const CanonicalComplex canonical = CanonicalReader(canonical_text(complex)).read();
  const Conformity result = conformity(canonical, points, perturbed, 20260101);
  BOOST_TEST(result.fault == "", name_of(strategy) << ", " << named.name << ": " << result.fault);
  BOOST_TEST_MESSAGE(name_of(strategy) << ", " << named.name << ": " << points.size() << " points, " << result.different << " subdivisions");
  return points.size();
}

const std::string certificates = CONFIDEL_SOURCE_DIR "/tests/certificates/";

Conformity of_certificate(const std::string& name, int perturbed) {
  const CertifiedPoints certified = read_certificate(certificates + name);
  return conformity(certified.complex, certified.points, perturbed, 7);
}

}  // namespace

BOOST_AUTO_TEST_SUITE(conformity_of_strategies)

BOOST_AUTO_TEST_CASE(graded) {
  int done = 0;
  for (const NamedInput& named : small_inputs()) done += check(named, Strategy::graded, 5) > 0;
  BOOST_TEST(done >= 19);
}

BOOST_AUTO_TEST_CASE(lean) {
  int done = 0;
  for (const NamedInput& named : small_inputs()) done += check(named, Strategy::lean, 20) > 0;
  BOOST_TEST(done == static_cast<int>(small_inputs().size()));
}

BOOST_AUTO_TEST_CASE(random_inputs) {
  int graded = 0, lean = 0;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    const NamedInput named = random_input(seed);
    graded += seed % 2 == 0 && check(named, Strategy::graded, 2) > 0;
    lean += check(named, Strategy::lean, 4) > 0;
  }
  BOOST_TEST_MESSAGE(graded << " graded, " << lean << " lean");
  BOOST_TEST(graded >= 7);
  BOOST_TEST(lean >= 36);
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(conformity_of_certificates)

BOOST_AUTO_TEST_CASE(accepted_ones_conform) {
  int done = 0;
  for (const auto& entry : std::filesystem::directory_iterator(certificates + "accept")) {
    const std::string name = entry.path().filename();
    if (name.find("zstd") != std::string::npos || name == "nothing.cert") continue;
    if (read_certificate(entry.path()).complex.dimension != 3) continue;
    const Conformity result = of_certificate("accept/" + name, 20);
    BOOST_TEST(result.fault == "", name << ": " << result.fault);
    ++done;
  }
  BOOST_TEST(done >= 20);
}

BOOST_AUTO_TEST_CASE(rejected_ones_that_do_not_conform) {
  // A tie across a constraint is decisive: some subdivisions conform and some do not. (Most other rejections are of the proof, not of
  // the points: another sphere or other cells would do.)
  for (const char* name : {"tie-two-facets", "tie-inner", "tie-coplanar"}) {
    const Conformity result = of_certificate(std::string("reject/") + name + ".cert", 40);
    BOOST_TEST_MESSAGE(name << ": " << result.conforming << " of " << result.tried << " conform, " << result.different << " different; " << result.fault);
    BOOST_TEST(!result.always(), name << ": all subdivisions conform");
    BOOST_TEST(result.conforming > 0, name << ": no subdivision conforms");
  }
}

BOOST_AUTO_TEST_SUITE_END()
