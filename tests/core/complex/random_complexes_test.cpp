// SPDX-License-Identifier: GPL-3.0-or-later
// build_complex against all pairs in rationals, on random triangles, polygons and segments of a small grid.
#include <rapidcheck.h>

#include <boost/test/unit_test.hpp>

#include "core/complex/build.h"
#include "tests/core/complex/brute_force.h"
#include "tests/core/complex/generators.h"
#include "tests/core/complex/inputs.h"
#include "tests/core/complex/triangulation_rules.h"

using namespace confidel;
using namespace confidel::test;

namespace {

Rational3 rational(const Input& input, int vertex) {
  const auto& [x, y, z] = input.vertices[vertex].position;
  return {mpq_class(x), mpq_class(y), mpq_class(z)};
}

bool is_vertex(const Input& input, const Rational3& point) {
  for (std::size_t i = 0; i < input.vertices.size(); ++i)
    if (rational(input, static_cast<int>(i)) == point) return true;
  return false;
}

Shape polygon_of(const Input& input, const InputFacet& facet) {
  Shape corners;
  for (const int corner : facet.polygons[0].corners) corners.push_back(rational(input, corner));
  return corners;
}

bool is_degenerate(const Shape& polygon) {
  return times(minus(polygon[1], polygon[0]), minus(polygon[2], polygon[0])) == Rational3{0, 0, 0};
}

using Lines = std::vector<Shape>;

/// All edges of facets, and all segments.
Lines edges_of(const Input& input) {
  Lines edges;
  for (const InputFacet& facet : input.facets) {
    const Shape polygon = polygon_of(input, facet);
    for (std::size_t i = 0; i < polygon.size(); ++i) edges.push_back({polygon[i], polygon[(i + 1) % polygon.size()]});
  }
  for (const InputSegment& segment : input.segments)
    if (segment.ends[0] != segment.ends[1])
      edges.push_back({rational(input, segment.ends[0]), rational(input, segment.ends[1])});
  return edges;
}

/// Is the segment between two points covered by edges? Walks as far as any edge along the line reaches.
bool is_covered(const Shape& part, const Lines& edges) {
  const Rational3 along = minus(part[1], part[0]);
  Rational3 reached = part[0];
  for (bool moved = true; moved && scalar(along, minus(part[1], reached)) > 0;) {
    moved = false;
    for (const Shape& edge : edges) {
      if (times(along, minus(edge[1], edge[0])) != Rational3{0, 0, 0} || !on_segment(reached, edge[0], edge[1]))
        continue;
      for (const Rational3& end : edge)
        if (scalar(along, minus(end, reached)) > 0) reached = end, moved = true;
    }
  }
  return scalar(along, minus(part[1], reached)) <= 0;
}

/// What two triangles of a valid complex may have in common: points that are vertices, and lines between vertices along
/// edges.
bool may_meet(const Input& input, const Lines& edges, const Shape& a, const Shape& b) {
  const Shape common = common_part(a, b);
  if (has_area(common)) return false;
  const Shape ends = ends_of(common);
  for (const Rational3& end : ends)
    if (!is_vertex(input, end)) return false;
  return ends.size() < 2 || is_covered(ends, edges);
}

/// The same for a segment; ab may run within a triangle, then it is an inner constraint.
bool may_meet_segment(const Input& input, const Shape& ab, const Shape& triangle) {
  for (const Rational3& end : ends_of(common_part(ab, triangle)))
    if (!is_vertex(input, end)) return false;
  return true;
}

bool segments_may_meet(const Input& input, const Shape& ab, const Shape& cd) {
  const Rational3 u = minus(ab[1], ab[0]), v = minus(cd[1], cd[0]), w = minus(cd[0], ab[0]), n = times(u, v);
  if (n == Rational3{0, 0, 0} || scalar(n, w) != 0) return true;
  const mpq_class s = scalar(times(w, v), n) / scalar(n, n), t = scalar(times(w, u), n) / scalar(n, n);
  if (s < 0 || s > 1 || t < 0 || t > 1) return true;
  return is_vertex(input, between(ab[0], ab[1], s));
}

bool is_valid_by_all_pairs(const Input& input) {
  std::vector<Shape> polygons, segments;
  for (std::size_t i = 0; i < input.vertices.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (rational(input, static_cast<int>(i)) == rational(input, static_cast<int>(j))) return false;
  for (const InputFacet& facet : input.facets) polygons.push_back(polygon_of(input, facet));
  for (const InputSegment& segment : input.segments)
    if (segment.ends[0] != segment.ends[1])
      segments.push_back({rational(input, segment.ends[0]), rational(input, segment.ends[1])});
  if (std::any_of(polygons.begin(), polygons.end(), is_degenerate)) return false;
  const Lines edges = edges_of(input);
  for (std::size_t i = 0; i < polygons.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j)
      if (!may_meet(input, edges, polygons[i], polygons[j])) return false;
    for (const Shape& segment : segments)
      if (!may_meet_segment(input, segment, polygons[i])) return false;
  }
  for (std::size_t i = 0; i < segments.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (!segments_may_meet(input, segments[i], segments[j])) return false;
  return true;
}

/// Triangles, parallelograms and segments between vertices of a grid of the given height.
Input random_soup(int grid, int height, int vertex_count) {
  std::vector<Position> positions;
  const auto vertex_at = [&](const Position& position) {
    const auto found = std::find(positions.begin(), positions.end(), position);
    if (found == positions.end()) return positions.push_back(position), static_cast<int>(positions.size()) - 1;
    return static_cast<int>(found - positions.begin());
  };
  for (int i = 0; i < vertex_count; ++i) {
    const double x = *whole_range(0, grid), y = *whole_range(0, grid), z = *whole_range(0, height);
    vertex_at({x, y, z});
  }
  const auto corner = whole_range(0, static_cast<int>(positions.size()));
  InputMaker maker;
  for (int i = *whole_range(1, 5); i > 0; --i) {
    const int a = *corner, b = *corner, c = *corner;
    if (a == b || b == c || c == a) continue;
    if (*rc::gen::arbitrary<bool>()) {
      maker.facet({{a, b, c}});
      continue;
    }
    Position fourth{};
    for (int axis = 0; axis < 3; ++axis) fourth[axis] = positions[a][axis] + positions[c][axis] - positions[b][axis];
    maker.facet({{a, b, c, vertex_at(fourth)}});
  }
  for (int i = *whole_range(0, 4); i > 0; --i) maker.segment(*corner, *corner);
  return maker.vertices(positions);
}

/// Every polygon is covered by its facet, and every segment by segments.
void require_coverage(const Input& input, const Complex& complex, const CanonicalComplex& canonical) {
  for (std::size_t i = 0; i < input.facets.size(); ++i) {
    const Shape polygon = polygon_of(input, input.facets[i]);
    Rational3 area = times(minus(polygon[1], polygon[0]), minus(polygon[2], polygon[0]));
    if (polygon.size() == 4) area = {2 * area[0], 2 * area[1], 2 * area[2]};
    const Rational3 normal = facet_normal(canonical, canonical.facets[i]);
    require(boundary_area(canonical, canonical.facets[i]) == scalar(normal, area),
            "area and orientation are the input's");
  }
  for (const InputSegment& segment : input.segments) {
    const Rational3 a = rational(input, segment.ends[0]), b = rational(input, segment.ends[1]);
    Rational3 sum{0, 0, 0};
    for (const auto& [first, second] : complex.segments) {
      const Rational3 &p = canonical.vertices[first], &q = canonical.vertices[second];
      if (!on_segment(p, a, b) || !on_segment(q, a, b)) continue;
      const bool forwards = scalar(minus(q, p), minus(b, a)) > 0;
      const Rational3 piece = forwards ? minus(q, p) : minus(p, q);
      for (int axis = 0; axis < 3; ++axis) sum[axis] += piece[axis];
    }
    require(sum == minus(b, a), "segments cover the input's");
  }
}

void check_against_all_pairs(int grid, int height, int vertex_count, int& valid, int& invalid) {
  const Input input = random_soup(grid, height, vertex_count);
  if (input.facets.empty() && input.segments.empty()) return;
  const bool expected = is_valid_by_all_pairs(input);
  (expected ? valid : invalid) += 1;
  const auto problems = problems_of(input);
  RC_LOG() << text_of(problems);
  for (const auto& vertex : input.vertices)
    RC_LOG() << vertex.position[0] << " " << vertex.position[1] << " " << vertex.position[2] << "\n";
  for (const auto& facet : input.facets) {
    for (const int corner : facet.polygons[0].corners) RC_LOG() << corner << " ";
    RC_LOG() << "facet\n";
  }
  for (const auto& segment : input.segments) RC_LOG() << segment.ends[0] << " " << segment.ends[1] << " segment\n";
  RC_ASSERT(problems.empty() == expected);
  if (!expected) return;
  const BuiltComplex built = build_complex(input);
  require_coverage(input, built.complex, require_everything(built.complex));
}

}  // namespace

BOOST_AUTO_TEST_SUITE(complex_random)

BOOST_AUTO_TEST_CASE(soups_are_valid_iff_all_pairs_are) {
  int valid = 0, invalid = 0;
  const auto check = [&](const std::string& name, int grid, int height, int vertex_count) {
    BOOST_TEST(rc::check(name, [&] { check_against_all_pairs(grid, height, vertex_count, valid, invalid); }));
  };
  check("dense grid", 3, 3, 9);
  check("wide grid", 5, 5, 12);
  check("few vertices", 3, 3, 6);
  check("two layers", 4, 2, 8);
  check("one plane", 4, 1, 8);
  BOOST_TEST_MESSAGE(valid << " valid, " << invalid << " invalid");
  BOOST_TEST(valid > 10);
  BOOST_TEST(invalid > 10);
}

BOOST_AUTO_TEST_CASE(order_of_the_facets_does_not_matter) {
  const bool passed = rc::check("reversed", [] {
    Input input = random_soup(3, 3, 8);
    if (input.facets.empty()) return;
    const auto problems = problems_of(input);
    const auto canonical = [](const Input& source) {
      Complex complex = build_complex(source).complex;
      std::vector<std::vector<std::array<VertexId, 2>>> boundaries;
      for (const Facet& facet : complex.facets)
        boundaries.push_back(facet.boundary), boundaries.push_back(facet.constraints);
      std::sort(boundaries.begin(), boundaries.end());
      return std::pair(complex.segments, boundaries);
    };
    Input reversed = input;
    std::reverse(reversed.facets.begin(), reversed.facets.end());
    std::reverse(reversed.segments.begin(), reversed.segments.end());
    RC_ASSERT(problems_of(reversed).size() == problems.size());
    if (problems.empty()) RC_ASSERT(canonical(input) == canonical(reversed));
  });
  BOOST_TEST(passed);
}

/// Random segments of the plane, as a PSLG and as a facet of two-corner polygons in an oblique plane: the same region.
BOOST_AUTO_TEST_CASE(facets_and_domains_resolve_alike) {
  int compared = 0;
  const bool passed = rc::check("embedded", [&] {
    const auto coordinates = *rc::gen::container<std::vector<int>>(20, whole_range(0, 5));
    InputMaker flat(2), oblique;
    std::vector<Position> plane, space;
    for (int i = 0; i < 10; ++i) {
      const double x = coordinates[2 * i], y = coordinates[2 * i + 1];
      const Position position{x, y, 0};
      if (std::find(plane.begin(), plane.end(), position) != plane.end()) continue;
      plane.push_back(position);
      space.push_back({y, 3 * x - 5 * y + 1, x});  // the normal's greatest component is negative or positive, along y
    }
    flat.vertices(plane);
    oblique.vertices(space);
    const int count = static_cast<int>(plane.size());
    std::vector<std::vector<int>> polygons;
    for (int i = *whole_range(3, 14); i > 0; --i) {
      const int a = *whole_range(0, count), b = *whole_range(0, count);
      if (a == b) continue;
      flat.segment(a, b);
      polygons.push_back({a, b});
    }
    for (int i = 0; i < count; ++i) polygons.push_back({i});
    oblique.facet(polygons);
    const auto planar_problems = problems_of(flat), spatial_problems = problems_of(oblique);
    if (!planar_problems.empty()) {
      RC_ASSERT(!spatial_problems.empty());
      return;
    }
    const BuiltComplex planar = build_complex(flat);
    if (planar.complex.facets.empty() || planar.report.artificial_segments > 0) {
      RC_ASSERT(!spatial_problems.empty());
      return;
    }
    ++compared;
    RC_ASSERT(spatial_problems.empty());
    const BuiltComplex spatial = build_complex(oblique);
    require_everything(planar.complex);
    require_everything(spatial.complex);
    const Facet &p = planar.complex.facets[0], &s = spatial.complex.facets[0];
    auto mirrored = p.boundary;
    for (auto& [a, c] : mirrored) std::swap(a, c);
    std::sort(mirrored.begin(), mirrored.end());
    RC_ASSERT(s.boundary == p.boundary || s.boundary == mirrored);
    RC_ASSERT(s.constraints == p.constraints);
    RC_ASSERT(s.isolated == p.isolated);
    RC_ASSERT(spatial.complex.segments == planar.complex.segments);
  });
  BOOST_TEST(passed);
  BOOST_TEST_MESSAGE(compared << " compared");
  BOOST_TEST(compared > 0);
}

BOOST_AUTO_TEST_SUITE_END()
