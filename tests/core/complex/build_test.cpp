// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/complex/build.h"

#include <boost/test/unit_test.hpp>

#include "tests/core/complex/inputs.h"
#include "tests/core/complex/triangulation_rules.h"

using namespace confidel;
using namespace confidel::test;

namespace {

using Edges = std::vector<std::array<VertexId, 2>>;

BuiltComplex checked(const Input& input) {
  try {
    BuiltComplex built = build_complex(input);
    require_everything(built.complex);
    return built;
  } catch (const InputError& error) {
    BOOST_FAIL("refused:\n" + text_of(error.problems));
    throw;
  }
}

/// Twice the area of a facet in the plane z = 0.
mpq_class double_area(const Complex& complex, int facet = 0) {
  const CanonicalComplex canonical = CanonicalReader(canonical_text(complex)).read();
  const Rational3 normal = facet_normal(canonical, canonical.facets[facet]);
  return boundary_area(canonical, canonical.facets[facet]) / normal[2];
}

const Edges outer_loop{{0, 1}, {1, 2}, {2, 3}, {3, 0}};

}  // namespace

BOOST_AUTO_TEST_SUITE(complex_build)

BOOST_AUTO_TEST_CASE(triangle_keeps_its_orientation) {
  const auto up = checked(InputMaker().vertices({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}).facet({{0, 1, 2}}, {}, 7));
  BOOST_TEST((up.complex.facets[0].boundary == Edges{{0, 1}, {1, 2}, {2, 0}}));
  BOOST_TEST((up.complex.facets[0].normal == IntegerVector{0, 0, 1}));
  BOOST_TEST(up.complex.facets[0].marker == 7);
  BOOST_TEST(up.complex.facets[0].line == 101);
  const auto down = checked(InputMaker().vertices({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}).facet({{0, 2, 1}}));
  BOOST_TEST((down.complex.facets[0].boundary == Edges{{0, 2}, {1, 0}, {2, 1}}));
  BOOST_TEST((down.complex.facets[0].normal == IntegerVector{0, 0, -1}));
}

BOOST_AUTO_TEST_CASE(polygons_keep_their_orientation_in_every_direction) {
  // A square in six planes, clockwise and counter-clockwise; the first corner is reflex in the second shape.
  for (int axis = 0; axis < 3; ++axis)
    for (const bool reverse : {false, true}) {
      std::vector<Position> corners;
      for (const auto& [x, y] : std::vector<std::array<double, 2>>{{1, 1}, {0, 3}, {0, 0}, {3, 0}}) {
        Position corner{};
        corner[(axis + 1) % 3] = x;
        corner[(axis + 2) % 3] = y;
        corners.push_back(corner);
      }
      const std::vector<int> loop = reverse ? std::vector<int>{3, 2, 1, 0} : std::vector<int>{0, 1, 2, 3};
      const auto built = checked(InputMaker().vertices(corners).facet({loop}));
      IntegerVector normal{0, 0, 0};
      normal[axis] = reverse ? -1 : 1;
      BOOST_TEST((built.complex.facets[0].normal == normal));
      BOOST_TEST((built.complex.facets[0].triangles.size() == 2));
      BOOST_TEST((built.complex.facets[0].boundary ==
                  (reverse ? Edges{{0, 3}, {1, 0}, {2, 1}, {3, 2}} : Edges{{0, 1}, {1, 2}, {2, 3}, {3, 0}})));
    }
}

BOOST_AUTO_TEST_CASE(scale_is_the_smallest_that_fits) {
  const auto scale_for = [](double size) {
    return checked(InputMaker().vertices({{0, 0, 0}, {size, 0, 0}, {0, size, 0}}).facet({{0, 1, 2}})).complex.scale;
  };
  BOOST_TEST(scale_for(1) == 0);
  BOOST_TEST(scale_for(1.5) == 1);
  BOOST_TEST(scale_for(2) == 1);
  BOOST_TEST(scale_for(0.25) == -2);
  BOOST_TEST(scale_for(1e300) == 997);
  BOOST_TEST(scale_for(5e-324) == -1074);
}

BOOST_AUTO_TEST_CASE(inner_loop_without_a_hole_point_is_a_constraint) {
  const auto built = checked(InputMaker().vertices(nested_squares()).facet({{0, 1, 2, 3}, {4, 5, 6, 7}}));
  const Facet& facet = built.complex.facets[0];
  BOOST_TEST((facet.boundary == outer_loop));
  BOOST_TEST((facet.constraints == Edges{{4, 5}, {4, 7}, {5, 6}, {6, 7}}));
  BOOST_TEST(double_area(built.complex) == 2);
}

BOOST_AUTO_TEST_CASE(hole_point_removes_the_inner_loop) {
  // The seed is far from the plane: its orthogonal projection counts.
  const auto built =
      checked(InputMaker().vertices(nested_squares()).facet({{0, 1, 2, 3}, {4, 5, 6, 7}}, {{0.5, 0.5, 9}}));
  const Facet& facet = built.complex.facets[0];
  BOOST_TEST((facet.boundary == Edges{{0, 1}, {1, 2}, {2, 3}, {3, 0}, {4, 7}, {5, 4}, {6, 5}, {7, 6}}));
  BOOST_TEST(facet.constraints.empty());
  BOOST_TEST(double_area(built.complex) == mpq_class(3, 2));
}

BOOST_AUTO_TEST_CASE(hole_point_between_the_loops_leaves_the_island) {
  const auto built =
      checked(InputMaker().vertices(nested_squares()).facet({{0, 1, 2, 3}, {4, 5, 6, 7}}, {{0.1, 0.5, 0}}));
  BOOST_TEST((built.complex.facets[0].boundary == Edges{{4, 5}, {5, 6}, {6, 7}, {7, 4}}));
  BOOST_TEST(double_area(built.complex) == mpq_class(1, 2));
  // The outer loop is in no facet any more, but stays in the complex.
  BOOST_TEST(built.complex.segments.size() == 8U);
  BOOST_TEST(has_remark(built.report, "edge 0-1 of facet 0 (line 101) lies outside"));
}

BOOST_AUTO_TEST_CASE(size_does_not_matter) {
  // Whatever a filter overflows or underflows to, the result is that of the unit square.
  const auto reference =
      checked(InputMaker().vertices(nested_squares()).facet({{0, 1, 2, 3}, {4, 5, 6, 7}, {0, 4}}, {{0.5, 0.5, 0.25}}));
  for (const double size : {0x1p1020, 0x1p500, 0x1p-500, 0x1p-1020}) {
    auto vertices = nested_squares();
    for (Position& position : vertices)
      for (double& coordinate : position) coordinate *= size;
    const auto built = checked(InputMaker().vertices(vertices).facet({{0, 1, 2, 3}, {4, 5, 6, 7}, {0, 4}},
                                                                     {{0.5 * size, 0.5 * size, 0.25 * size}}));
    BOOST_TEST((built.complex.facets[0].boundary == reference.complex.facets[0].boundary));
    BOOST_TEST((built.complex.facets[0].constraints == reference.complex.facets[0].constraints));
    BOOST_TEST((built.complex.facets[0].triangles.size() == reference.complex.facets[0].triangles.size()));
  }
}

BOOST_AUTO_TEST_CASE(oblique_planes_resolve_holes_orthogonally) {
  // Plane x + y + z = 12. The hole is the loop 3-4-5 with the centroid (4,4,4); the seed is (4,4,4) + 5 (1,1,1).
  const std::vector<Position> vertices{{12, 0, 0}, {0, 12, 0}, {0, 0, 12}, {6, 3, 3}, {3, 6, 3}, {3, 3, 6}};
  const auto built = checked(InputMaker().vertices(vertices).facet({{0, 1, 2}, {3, 4, 5}}, {{9, 9, 9}}));
  BOOST_TEST(built.complex.facets[0].boundary.size() == 6U);
  BOOST_TEST((built.complex.facets[0].normal == IntegerVector{1, 1, 1}));
}

BOOST_AUTO_TEST_CASE(slit_dangling_segment_and_isolated_vertex) {
  auto vertices = nested_squares();
  vertices.push_back({0.5, 0.625, 0});
  const auto built = checked(InputMaker().vertices(vertices).facet({{0, 1, 2, 3}, {4, 5}, {2, 6}, {7}, {8}}));
  const Facet& facet = built.complex.facets[0];
  BOOST_TEST((facet.boundary == outer_loop));
  BOOST_TEST((facet.constraints == Edges{{2, 6}, {4, 5}}));
  BOOST_TEST((facet.isolated == std::vector<VertexId>{7, 8}));
  BOOST_TEST(built.complex.segments.size() == 6U);
}

BOOST_AUTO_TEST_CASE(bridge_in_a_loop_is_an_inner_constraint) {
  // One loop that walks to the inner square and back, as modellers write facets with holes.
  const auto built =
      checked(InputMaker().vertices(nested_squares()).facet({{0, 1, 2, 3, 0, 4, 7, 6, 5, 4}}, {{0.5, 0.5, 0}}));
  BOOST_TEST((built.complex.facets[0].constraints == Edges{{0, 4}}));
  BOOST_TEST(double_area(built.complex) == mpq_class(3, 2));
}

BOOST_AUTO_TEST_CASE(segments_may_close_a_ring) {
  const auto built = checked(InputMaker().vertices(square()).facet({{0, 1}, {2, 1}, {2, 3}, {0, 3}}));
  BOOST_TEST(built.complex.facets[0].boundary.size() == 4U);
  BOOST_TEST(built.complex.facets[0].triangles.size() == 2U);
}

BOOST_AUTO_TEST_CASE(separate_and_pinched_loops) {
  // Two triangles that share vertex 2, and a third one apart: one facet.
  const std::vector<Position> vertices{{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {4, 2, 0},
                                       {2, 4, 0}, {8, 0, 0}, {9, 0, 0}, {8, 1, 0}};
  const auto built = checked(InputMaker().vertices(vertices).facet({{0, 1, 2}, {2, 3, 4}, {5, 6, 7}}));
  BOOST_TEST(built.complex.facets[0].triangles.size() == 3U);
  BOOST_TEST(double_area(built.complex) == 4 + 4 + 1);
}

BOOST_AUTO_TEST_CASE(island_in_a_hole) {
  auto vertices = nested_squares();
  for (const Position& corner : std::vector<Position>{{0.375, 0.375, 0}, {0.625, 0.375, 0}, {0.5, 0.625, 0}})
    vertices.push_back(corner);
  const auto built =
      checked(InputMaker().vertices(vertices).facet({{0, 1, 2, 3}, {4, 5, 6, 7}, {8, 9, 10}}, {{0.3125, 0.5, 0}}));
  BOOST_TEST(built.complex.facets[0].boundary.size() == 11U);
  BOOST_TEST(double_area(built.complex) == mpq_class(3, 2) + mpq_class(1, 16));
}

BOOST_AUTO_TEST_CASE(hole_filled_by_another_facet) {
  const auto built = checked(InputMaker()
                                 .vertices(nested_squares())
                                 .facet({{0, 1, 2, 3}, {4, 5, 6, 7}}, {{0.5, 0.5, 0}})
                                 .facet({{7, 6, 5, 4}}));
  BOOST_TEST(built.complex.segments.size() == 8U);
  BOOST_TEST(double_area(built.complex, 0) == mpq_class(3, 2));
  BOOST_TEST((built.complex.facets[1].boundary == Edges{{4, 7}, {5, 4}, {6, 5}, {7, 6}}));
}

BOOST_AUTO_TEST_CASE(coplanar_neighbours_stay_separate) {
  const auto built = checked(InputMaker().vertices(square()).facet({{0, 1, 2}}).facet({{0, 2, 3}}));
  BOOST_TEST(built.complex.facets.size() == 2U);
  BOOST_TEST(built.complex.segments.size() == 5U);
}

BOOST_AUTO_TEST_CASE(vertex_on_a_segment_splits_it_everywhere) {
  // Vertex 4 is on the edge 0-1 of two facets and on a segment along it; 5 splits a dangling segment.
  const std::vector<Position> vertices{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {0, 0, 4},
                                       {3, 0, 0}, {1, 1, 0}, {2, 2, 0}, {8, 0, 0}};
  const auto built = checked(
      InputMaker().vertices(vertices).facet({{0, 1, 2}, {0, 6}}).facet({{0, 1, 3}}).segment(0, 7, 5).segment(1, 2));
  const Complex& complex = built.complex;
  BOOST_TEST((complex.facets[0].boundary == Edges{{0, 4}, {1, 6}, {2, 0}, {4, 1}, {6, 2}}));
  BOOST_TEST((complex.facets[0].constraints == Edges{{0, 5}, {5, 6}}));
  BOOST_TEST((complex.facets[1].boundary == Edges{{0, 4}, {1, 3}, {3, 0}, {4, 1}}));
  BOOST_TEST((complex.segments ==
              std::vector<Segment>{{0, 2}, {0, 3}, {0, 4}, {0, 5}, {1, 3}, {1, 4}, {1, 6}, {1, 7}, {2, 6}, {5, 6}}));
  // The marker of the segment 0-7 is on all its pieces.
  BOOST_TEST(complex.segment_markers[complex.find_segment(4, 0)] == 5);
  BOOST_TEST(complex.segment_markers[complex.find_segment(4, 1)] == 5);
  BOOST_TEST(complex.segment_markers[complex.find_segment(1, 7)] == 5);
  BOOST_TEST(complex.segment_markers[complex.find_segment(0, 2)] == 0);
  BOOST_TEST(complex.find_segment(0, 1) == -1);
  std::vector<std::array<int, 3>> splits;
  for (const auto& split : built.report.split_segments) splits.push_back({split.first, split.second, split.on_it});
  BOOST_TEST((splits == std::vector<std::array<int, 3>>{{0, 1, 4}, {0, 6, 5}, {0, 7, 4}, {0, 7, 1}, {1, 2, 6}}));
}

BOOST_AUTO_TEST_CASE(vertex_in_a_facet_becomes_a_vertex_of_it) {
  // A triangle stands with one corner on the square: TetGen wants the corner listed, we say what we did.
  auto vertices = nested_squares();
  vertices.push_back({0.25, 0.25, 1});
  vertices.push_back({0.75, 0.25, 1});
  const auto built = checked(InputMaker().vertices(vertices).facet({{0, 1, 2, 3}}).facet({{4, 8, 9}}));
  BOOST_TEST((built.complex.facets[0].isolated == std::vector<VertexId>{4, 5, 6, 7}));
  BOOST_TEST(has_remark(built.report, "vertex 4 (line 5) lies in facet 0 (line 101)"));
}

BOOST_AUTO_TEST_CASE(segment_in_a_facet_becomes_a_constraint_of_it) {
  // A wall stands on the square and a ridge runs along its diagonal.
  auto vertices = nested_squares();
  vertices.push_back({0.25, 0.25, 1});
  const auto built =
      checked(InputMaker().vertices(vertices).facet({{0, 1, 2, 3}}).facet({{4, 5, 8}}).segment(0, 4).segment(6, 2));
  BOOST_TEST((built.complex.facets[0].constraints == Edges{{0, 4}, {2, 6}, {4, 5}}));
  BOOST_TEST((built.complex.facets[0].isolated == std::vector<VertexId>{7}));
  BOOST_TEST(has_remark(built.report, "edge 4-5 of facet 1 (line 102) lies in facet 0"));
  BOOST_TEST(has_remark(built.report, "segment 0 from 0 to 4 (line 201) lies in facet 0"));
}

BOOST_AUTO_TEST_CASE(chord_outside_of_a_region_is_no_part_of_it) {
  // A C-shape; a segment of the same plane closes its mouth, which must not fill it.
  const std::vector<Position> vertices{{0, 0, 0}, {3, 0, 0}, {3, 1, 0}, {1, 1, 0},  {1, 2, 0},
                                       {3, 2, 0}, {3, 3, 0}, {0, 3, 0}, {2, 1.5, 0}};
  const auto built =
      checked(InputMaker().vertices(vertices).facet({{0, 1, 2, 3, 4, 5, 6, 7}}).segment(2, 5).segment(8, 2));
  BOOST_TEST(double_area(built.complex) == 14);
  BOOST_TEST(built.complex.facets[0].constraints.empty());
  BOOST_TEST(built.complex.facets[0].isolated.empty());
  BOOST_TEST(built.complex.find_segment(2, 5) >= 0);
}

BOOST_AUTO_TEST_CASE(hanging_segments_and_lone_vertices) {
  const auto built = checked(InputMaker().vertices({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 5}}).segment(2, 0, 3));
  BOOST_TEST(built.complex.vertices.size() == 4U);
  BOOST_TEST((built.complex.segments == std::vector<Segment>{{0, 2}}));
  BOOST_TEST((built.complex.segment_markers == std::vector<int>{3}));
  BOOST_TEST(built.complex.facets.empty());
}

BOOST_AUTO_TEST_CASE(identical_vertices_merge_on_request) {
  const Input input = InputMaker()
                          .vertices({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 0, -0.0}, {1, 1, 0}, {0, 1, 0}})
                          .facet({{0, 1, 2}})
                          .facet({{3, 4, 5}});
  BuildOptions options;
  options.merge_identical_vertices = true;
  const BuiltComplex built = build_complex(input, options);
  require_everything(built.complex);
  BOOST_TEST(built.complex.vertices.size() == 4U);
  BOOST_TEST(built.complex.segments.size() == 5U);
  BOOST_TEST((built.report.input_index == std::vector<int>{0, 1, 2, 4}));
  BOOST_TEST(has_remark(built.report, "2 vertices"));
}

BOOST_AUTO_TEST_CASE(repeated_corners_are_ignored_aloud) {
  auto vertices = square();
  vertices.push_back({0.5, 0.25, 0});
  const auto built = checked(InputMaker().vertices(vertices).facet({{0, 1, 1, 2, 3, 0}, {4, 4}}));
  BOOST_TEST((built.complex.facets[0].boundary == outer_loop));
  BOOST_TEST((built.complex.facets[0].isolated == std::vector<VertexId>{4}));
  BOOST_TEST(has_remark(built.report, "repeats a corner"));
}

BOOST_AUTO_TEST_SUITE_END()
