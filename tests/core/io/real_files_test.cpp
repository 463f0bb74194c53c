// SPDX-License-Identifier: GPL-3.0-or-later
// Files of other programs, where they are present: they are not part of the repository.
#include <boost/test/unit_test.hpp>
#include <cstdlib>
#include <filesystem>
#include <iostream>

#include "core/io/read.h"

using namespace confidel;

namespace {

/// "" and a printed reason if the file is absent.
std::string path_of(const std::string& file) {
  const char* folder = std::getenv("CONFIDEL_DATA");
  const std::string path = (folder != nullptr ? std::string(folder) : "/work/shared/data") + "/" + file;
  if (std::filesystem::exists(path)) return path;
  std::cout << "skipped: no " << path << " (CONFIDEL_DATA names the folder)\n";
  return "";
}

}  // namespace

BOOST_AUTO_TEST_SUITE(io_real_files)

BOOST_AUTO_TEST_CASE(counts) {
  if (path_of("").empty()) return;
  const struct {
    const char* file;
    std::size_t vertices, facets, segments, holes, regions;
  } table[] = {{"2d/A.poly", 29, 0, 29, 1, 0},
               {"2d/box.poly", 8, 0, 5, 1, 0},
               {"2d/cgal-butterfly.edg", 21, 0, 26, 0, 0},
               {"2d/cgal-clusters2.edg", 10, 0, 9, 0, 0},
               {"2d/cgal-fish.edg", 15, 0, 16, 0, 0},
               {"2d/cgal-img5.edg", 275, 0, 274, 0, 0},
               {"2d/double_hex.poly", 96, 0, 96, 2, 0},
               {"2d/face.poly", 26, 0, 22, 3, 0},
               {"2d/la.poly", 141, 0, 148, 0, 6},
               {"2d/natural-earth-countries-110m-noncrossing.poly", 7452, 0, 7491, 0, 0},
               {"2d/square_circle_hole.poly", 826, 0, 135, 1, 0},
               {"3d/attene-bracket.off", 1464, 2936, 0, 0, 0},
               {"3d/cgal-corner_poly.off", 12, 8, 0, 0, 0},
               {"3d/cgal-cross_quad.off", 40, 38, 0, 0, 0},
               {"3d/cgal-cubes.off", 14, 24, 0, 0, 0},
               {"3d/cgal-horizons.off", 1682, 3200, 0, 0, 0},
               {"3d/cgal-joint.off", 221, 446, 0, 0, 0},
               {"3d/cgal-pinion_small.off", 650, 1300, 0, 0, 0},
               {"3d/cgal-tripod.off", 24, 44, 0, 0, 0},
               {"3d/gc-fan3.obj", 5, 3, 0, 0, 0},
               {"3d/gc-triple_vierbein.obj", 75, 108, 0, 0, 0},
               {"3d/geode-fault-triangulated.smesh", 111, 186, 0, 0, 0},
               {"3d/manifold-Havocglass8_right.obj", 8, 12, 0, 0, 0},
               {"3d/slit-1.smesh", 14, 13, 0, 0, 0},
               {"3d/slit-10.smesh", 14, 13, 0, 0, 0},
               {"3d/spike-1-10.smesh", 11, 11, 0, 0, 0},
               {"3d/spike-10-7.smesh", 8, 8, 0, 0, 0},
               {"3d/tetgen-example.poly", 28, 23, 0, 2, 2},
               {"3d/wedge-1.smesh", 6, 5, 0, 0, 0},
               {"3d/wedge-10.smesh", 6, 5, 0, 0, 0},
               {"3d/wedge-5.smesh", 6, 5, 0, 0, 0},
               {"bad/cgal-non_manifold_face_graph.off", 24, 11, 0, 0, 0},
               {"bad/gc-moebius.obj", 280, 224, 0, 0, 0},
               {"bad/manifold-openscad-nonmanifold-crash.obj", 717, 1442, 0, 0, 0},
               {"bad/natural-earth-countries-110m.poly", 7490, 0, 7650, 0, 0}};
  int read = 0;
  for (const auto& entry : table) {
    const std::string path = path_of(entry.file);
    if (path.empty()) continue;
    ++read;
    BOOST_TEST_CONTEXT(entry.file) {
      const Input input = read_input(path);
      BOOST_TEST(input.dimension == (entry.facets == 0 ? 2 : 3));
      BOOST_TEST(input.vertices.size() == entry.vertices);
      BOOST_TEST(input.facets.size() == entry.facets);
      BOOST_TEST(input.segments.size() == entry.segments);
      BOOST_TEST(input.holes.size() == entry.holes);
      BOOST_TEST(input.regions.size() == entry.regions);
    }
  }
  std::cout << read << " files read" << '\n';
}

BOOST_AUTO_TEST_CASE(facet_with_a_hole_that_another_fills) {
  const std::string path = path_of("3d/tetgen-example.poly");
  if (path.empty()) return;
  const Input input = read_input(path);
  BOOST_REQUIRE_EQUAL(input.facets[2].polygons.size(), 2);
  BOOST_REQUIRE_EQUAL(input.facets[2].holes.size(), 1);
  BOOST_TEST(input.facets[2].holes[0] == (std::array<double, 3>{1, 0, 2.25}));
  BOOST_TEST(input.facets[2].marker == 3);
  BOOST_TEST(input.regions[1].bound == 0.01);
}

BOOST_AUTO_TEST_SUITE_END()
