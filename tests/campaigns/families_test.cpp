// SPDX-License-Identifier: GPL-3.0-or-later
#include "campaigns/families.h"

#include <boost/test/unit_test.hpp>
#include <filesystem>
#include <fstream>
#include <set>

#include <unistd.h>

#include "campaigns/instance.h"
#include "core/complex/build.h"
#include "core/io/read.h"

using namespace confidel;
using namespace confidel::campaigns;

namespace {

constexpr std::uint64_t seeds = 12;

Input read_back(const Input& input) {
  const auto path = std::filesystem::temp_directory_path() / ("confidel-families-test-" + std::to_string(::getpid()) + suffix_for(input));
  std::ofstream(path) << input_text(input, "a remark");
  const Input result = read_input(path.string());
  std::filesystem::remove(path);
  return result;
}

std::vector<std::vector<int>> corners_of(const Input& input) {
  std::vector<std::vector<int>> result;
  for (const InputFacet& facet : input.facets)
    for (const InputPolygon& polygon : facet.polygons) result.push_back(polygon.corners);
  return result;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(input_families)

BOOST_AUTO_TEST_CASE(the_generator_is_the_standard_s) {
  // [rand.predef]: the 10000th word of a default-constructed mt19937_64; its seed is 5489.
  Random random(5489);
  for (int i = 1; i < 10000; ++i) random.word();
  BOOST_CHECK_EQUAL(random.word(), 9981545732273789042U);
}

BOOST_AUTO_TEST_CASE(integers_and_reals_have_their_ranges) {
  Random random(1);
  std::set<int> seen;
  for (int i = 0; i < 1000; ++i) {
    seen.insert(random.integer(-2, 3));
    const double x = random.real(4);
    BOOST_CHECK(x >= -1 && x < 1 && std::ldexp(x, 3) == std::nearbyint(std::ldexp(x, 3)));
  }
  BOOST_CHECK_EQUAL(seen.size(), 6U);
  BOOST_CHECK_EQUAL(*seen.begin(), -2);
}

BOOST_AUTO_TEST_CASE(names_are_distinct_and_found) {
  std::set<std::string> names;
  for (const Family& family : families()) {
    names.insert(family.name);
    BOOST_CHECK_EQUAL(find_family(family.name)->name, family.name);
  }
  BOOST_CHECK_EQUAL(names.size(), families().size());
  BOOST_CHECK(find_family("no such family") == nullptr);
  BOOST_CHECK_EQUAL(family_for("all", families().size() + 2).name, families()[2].name);
}

BOOST_AUTO_TEST_CASE(members_are_as_valid_as_the_family_says) {
  for (const Family& family : families())
    for (std::uint64_t seed = 0; seed < seeds; ++seed) {
      const Input input = generate(family, seed);
      BOOST_TEST_CONTEXT(family.name << ' ' << seed) {
        BOOST_CHECK_EQUAL(is_valid(input), family.valid);
        if (std::string(family.name) != "huge-or-tiny") BOOST_CHECK_EQUAL(input.dimension, family.dimension);
        BOOST_CHECK_LE(input.vertices.size(), 200U);
      }
    }
}

BOOST_AUTO_TEST_CASE(the_same_seed_gives_the_same_member_and_others_give_others) {
  for (const Family& family : families()) {
    std::set<std::string> texts;
    for (std::uint64_t seed = 0; seed < seeds; ++seed) {
      const std::string text = input_text(generate(family, seed));
      BOOST_CHECK_EQUAL(text, input_text(generate(family, seed)));
      texts.insert(text);
    }
    BOOST_TEST_CONTEXT(family.name) BOOST_CHECK_GE(texts.size(), seeds / 2);
  }
}

BOOST_AUTO_TEST_CASE(what_is_written_is_read_back) {
  for (const Family& family : families())
    for (std::uint64_t seed = 0; seed < seeds; ++seed) {
      const Input input = generate(family, seed);
      BOOST_TEST_CONTEXT(family.name << ' ' << seed) {
        Input again;
        try {
          again = read_back(input);
        } catch (const InputError&) {
          BOOST_CHECK(!family.valid);  // readers refuse some of what is invalid
          continue;
        }
        BOOST_REQUIRE_EQUAL(again.vertices.size(), input.vertices.size());
        for (std::size_t i = 0; i < input.vertices.size(); ++i) BOOST_CHECK(again.vertices[i].position == input.vertices[i].position);
        BOOST_CHECK(corners_of(again) == corners_of(input));
        BOOST_CHECK_EQUAL(again.segments.size(), input.segments.size());
        if (family.valid) BOOST_CHECK_EQUAL(canonical_text(build_complex(again).complex), canonical_text(build_complex(input).complex));
      }
    }
}

BOOST_AUTO_TEST_SUITE_END()
