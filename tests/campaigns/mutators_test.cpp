// SPDX-License-Identifier: GPL-3.0-or-later
#include "campaigns/mutators.h"

#include <boost/test/unit_test.hpp>
#include <map>

#include "campaigns/families.h"
#include "campaigns/instance.h"
#include "core/complex/build.h"
#include "core/features/features.h"
#include "tests/support/placing.h"

using namespace confidel;
using namespace confidel::campaigns;

namespace {

std::vector<Input> some_inputs() {
  std::vector<Input> inputs;
  for (const Family& family : families())
    for (std::uint64_t seed = 100; seed < 104 && family.valid; ++seed) inputs.push_back(generate(family, seed));
  return inputs;
}

std::array<std::size_t, 3> counts(const Input& input) {
  const Complex complex = build_complex(input).complex;
  return {complex.vertices.size(), complex.segments.size(), complex.facets.size()};
}

}  // namespace

BOOST_AUTO_TEST_SUITE(input_mutators)

BOOST_AUTO_TEST_CASE(every_mutator_applies_somewhere_and_keeps_inputs_valid) {
  std::map<std::string, int> applied;
  Random random(3);
  for (const Input& input : some_inputs())
    for (const Mutator& mutator : campaigns::mutators())
      if (const auto result = mutate(mutator, input, random)) {
        ++applied[mutator.name];
        BOOST_TEST_CONTEXT(mutator.name << " of " << input.file) BOOST_CHECK(is_valid(*result));
      }
  for (const Mutator& mutator : campaigns::mutators()) BOOST_TEST_CONTEXT(mutator.name) BOOST_CHECK_GE(applied[mutator.name], 3);
}

BOOST_AUTO_TEST_CASE(exact_maps_keep_the_complex) {
  Random random(5);
  int rotations = 0, unions = 0;
  for (const Input& input : some_inputs()) {
    BOOST_TEST_CONTEXT(input.file) {
      const auto before = counts(input);
      BOOST_CHECK(counts(permuted(input, random)) == before);
      BOOST_CHECK(counts(with_permuted_axes(input, random)) == before);
      if (const auto image = rotated(input, random)) {
        BOOST_CHECK(counts(*image) == before);
        ++rotations;
      }
      if (const auto image = scaled(input, 17)) BOOST_CHECK(counts(*image) == before);
      const auto both = far_union(input, input, random);
      if (both && input.dimension == 3) {
        BOOST_CHECK((counts(*both) == std::array{2 * before[0], 2 * before[1], 2 * before[2]}));
        ++unions;
      }
    }
  }
  BOOST_CHECK_GE(rotations, 20);
  BOOST_CHECK_GE(unions, 20);
}

BOOST_AUTO_TEST_CASE(maps_that_would_round_are_refused) {
  Maker maker;
  const int a = maker.vertex({0x1.fffffffffffffp0, 0, 0}), b = maker.vertex({0, 0x1.fffffffffffffp0, 0}), c = maker.vertex({0, 0, 0x1.fffffffffffffp0});
  maker.facet({a, b, c});
  Random random(1);
  BOOST_CHECK(!rotated(maker.input(), random));
  BOOST_CHECK(!far_union(maker.input(), maker.input(), random));
  BOOST_CHECK(!scaled(maker.input(), 1024));
  BOOST_CHECK(!scaled(maker.input(), -1060));
  BOOST_CHECK(scaled(maker.input(), 1000));
}

BOOST_AUTO_TEST_CASE(scaling_maps_the_points_exactly) {
  int compared = 0;
  for (const char* name : {"fan", "polygon", "boxes", "planar-polygon", "hanging-edges", "star"})
    for (std::uint64_t seed = 0; seed < 3; ++seed) {
      const Input input = generate(*find_family(name), seed);
      const auto image = scaled(input, 9);
      BOOST_REQUIRE(image);
      const Complex one = build_complex(input).complex, other = build_complex(*image).complex;
      for (const test::Strategy strategy : {test::Strategy::lean, test::Strategy::graded}) {
        constexpr long most = 2000;
        Placement first, second;
        try {
          first = test::place(one, strategy, most);
        } catch (const LimitReached&) {
          continue;
        }
        second = test::place(other, strategy, most);
        BOOST_TEST_CONTEXT(name << ' ' << seed << ' ' << test::name_of(strategy)) {
          BOOST_REQUIRE_EQUAL(first.points.size(), second.points.size());
          for (std::size_t i = 0; i < first.points.size(); ++i)
            BOOST_CHECK(first.points[i].position.scaled(one.scale + 9) == second.points[i].position.scaled(other.scale));
          BOOST_CHECK_EQUAL(first.cells.size(), second.cells.size());
        }
        ++compared;
      }
    }
  BOOST_CHECK_GE(compared, 20);
}

BOOST_AUTO_TEST_SUITE_END()
