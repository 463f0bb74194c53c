// SPDX-License-Identifier: GPL-3.0-or-later
// The models of shared/data: what SOURCES.md says about them, exactly. Skipped, and said so, where they are not at
// hand.
#include <boost/test/unit_test.hpp>
#include <cstdlib>
#include <filesystem>

#include "core/complex/build.h"
#include "core/io/read.h"
#include "tests/core/complex/inputs.h"
#include "tests/core/complex/triangulation_rules.h"

using namespace confidel;
using namespace confidel::test;

namespace {

/// CONFIDEL_DATA, or shared/data beside the source tree.
std::filesystem::path data_folder() {
  if (const char* folder = std::getenv("CONFIDEL_DATA")) return folder;
  return std::filesystem::path(CONFIDEL_SOURCE_DIR).parent_path() / "shared" / "data";
}

bool is_present(const std::filesystem::path& path) {
  if (std::filesystem::exists(path)) return true;
  BOOST_TEST_MESSAGE("skipped: " << path << " is not there; set CONFIDEL_DATA to the folder of test models");
  return false;
}

std::map<std::string, int> counts_of(const std::filesystem::path& path) {
  std::map<std::string, int> counts;
  for (const Problem& problem : problems_of(read_input(path))) {
    ++counts[problem.code];
    BOOST_TEST(problem.place.line > 0);
    BOOST_TEST(problem.place.file == path.string());
  }
  return counts;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(complex_real_files)

BOOST_AUTO_TEST_CASE(valid_models_build) {
  for (const char* dimension : {"2d", "3d"}) {
    if (!is_present(data_folder() / dimension)) continue;
    for (const auto& entry : std::filesystem::directory_iterator(data_folder() / dimension))
      BOOST_TEST_CONTEXT(entry.path().string()) {
        try {
          const BuiltComplex built = build_complex(read_input(entry.path()));
          require_everything(built.complex);
        } catch (const InputError& error) {
          BOOST_ERROR(text_of(error.problems));
        } catch (const std::runtime_error& error) {
          BOOST_ERROR(error.what());
        }
      }
  }
}

BOOST_AUTO_TEST_CASE(tetgen_example) {
  const auto path = data_folder() / "3d" / "tetgen-example.poly";
  if (!is_present(path)) return;
  const Complex complex = build_complex(read_input(path)).complex;
  BOOST_TEST(complex.facets.size() == 23U);
  // Facet #3 has a hole, and facet #20 fills it.
  BOOST_TEST(complex.facets[2].boundary.size() == 8U);
  BOOST_TEST(complex.facets[19].boundary.size() == 4U);
  for (const auto& [a, c] : complex.facets[19].boundary) {
    const auto& hole = complex.facets[2].boundary;
    BOOST_TEST((std::count(hole.begin(), hole.end(), std::array<VertexId, 2>{a, c}) +
                    std::count(hole.begin(), hole.end(), std::array<VertexId, 2>{c, a}) ==
                1));
  }
}

BOOST_AUTO_TEST_CASE(bad_models_are_refused_for_their_true_reasons) {
  const auto folder = data_folder() / "bad";
  if (!is_present(folder)) return;
  using Counts = std::map<std::string, int>;
  BOOST_TEST((counts_of(folder / "gc-moebius.obj") == Counts{{"E-NONCOPLANAR", 224}}));
  BOOST_TEST((counts_of(folder / "cgal-non_manifold_face_graph.off") == Counts{{"E-DUPLICATE-VERTEX", 3}}));
  BOOST_TEST((counts_of(folder / "natural-earth-countries-110m.poly") == Counts{{"E-CROSSING", 157}}));
  const Counts crash = counts_of(folder / "manifold-openscad-nonmanifold-crash.obj");
  BOOST_TEST(crash.at("E-DUPLICATE-VERTEX") == 59);
  BOOST_TEST(crash.at("E-DEGENERATE-FACET") == 1);
  BOOST_TEST(crash.at("E-OVERLAP") > 0);
}

BOOST_AUTO_TEST_SUITE_END()
