// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/oracle/subdivisions.h"

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Regular_triangulation_3.h>
#include <CGAL/Regular_triangulation_cell_base_3.h>
#include <CGAL/Regular_triangulation_vertex_base_3.h>
#include <CGAL/Triangulation_vertex_base_with_info_3.h>

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <random>

#include "tests/core/complex/triangulation_rules.h"
#include "tests/support/rationals.h"

namespace confidel::test {
namespace {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Triple = std::array<int, 3>;

Kernel::Point_3 kernel_point(const Rational3& p) {
  const auto number = [](const mpq_class& x) { return Kernel::FT(Kernel::FT::ET(x)); };
  return {number(p[0]), number(p[1]), number(p[2])};
}

/// Edges and triangles of a subdivision.
struct Faces {
  std::set<Pair> edges;
  std::set<Triple> triangles;
};

template <class Triangulation>
Faces faces_of(const Triangulation& triangulation) {
  Faces faces;
  if (triangulation.dimension() >= 1)
    for (const auto& e : triangulation.finite_edges()) {
      Pair edge{e.first->vertex(e.second)->info(), e.first->vertex(e.third)->info()};
      std::sort(edge.begin(), edge.end());
      faces.edges.insert(edge);
    }
  if (triangulation.dimension() >= 2)
    for (const auto& f : triangulation.finite_facets()) {
      Triple t;
      for (int i = 0, k = 0; i < 4; ++i)
        if (i != f.second) t[k++] = f.first->vertex(i)->info();
      std::sort(t.begin(), t.end());
      faces.triangles.insert(t);
    }
  return faces;
}

std::vector<int> shuffled(std::size_t count, std::mt19937_64& generator) {
  std::vector<int> order(count);
  for (std::size_t i = 0; i < count; ++i) order[i] = static_cast<int>(i);
  for (std::size_t i = count; i > 1; --i) std::swap(order[i - 1], order[generator() % i]);
  return order;
}

Faces delaunay(const std::vector<Kernel::Point_3>& points, std::mt19937_64& generator) {
  using Vertex = CGAL::Triangulation_vertex_base_with_info_3<int, Kernel>;
  using Structure = CGAL::Triangulation_data_structure_3<Vertex, CGAL::Delaunay_triangulation_cell_base_3<Kernel>>;
  CGAL::Delaunay_triangulation_3<Kernel, Structure> triangulation;
  for (const int i : shuffled(points.size(), generator)) triangulation.insert(points[i])->info() = i;
  require(triangulation.number_of_vertices() == points.size(), "points are distinct");
  return faces_of(triangulation);
}

Faces perturbed_delaunay(const std::vector<Kernel::Point_3>& points, std::mt19937_64& generator, const std::vector<int>& raised = {}) {
  using Vertex = CGAL::Triangulation_vertex_base_with_info_3<int, Kernel, CGAL::Regular_triangulation_vertex_base_3<Kernel>>;
  using Structure = CGAL::Triangulation_data_structure_3<Vertex, CGAL::Regular_triangulation_cell_base_3<Kernel>>;
  using Triangulation = CGAL::Regular_triangulation_3<Kernel, Structure>;
  Triangulation triangulation;
  for (const int i : shuffled(points.size(), generator)) {
    // Below every non-zero power of points with up to about 300 bits.
    // Points of equal and greatest weight are lifted onto a plane below all others of their sphere: their simplex is a face.
    const bool first = std::find(raised.begin(), raised.end(), i) != raised.end();
    const mpq_class weight = (first ? power_of_two(32) : mpq_class(static_cast<unsigned long>(generator() >> 33))) * power_of_two(-4000);
    const auto vertex = triangulation.insert(Triangulation::Weighted_point(points[i], Kernel::FT(Kernel::FT::ET(weight))));
    require(vertex != nullptr, "no point is hidden");
    vertex->info() = i;
  }
  require(triangulation.number_of_vertices() == points.size(), "all points are vertices");
  return faces_of(triangulation);
}

/// Precomputed for one complex and its points.
class Judge {
 public:
  Judge(const CanonicalComplex& complex, const std::vector<Rational3>& points) : complex_(complex), points_(points) {
    for (const auto& [a, b] : complex.segments) {
      std::map<mpq_class, int> on_it;
      for (std::size_t i = 0; i < points.size(); ++i) {
        mpq_class t;
        if (parameter_on_line(points[a], points[b], points[i], t) && t >= 0 && t <= 1) on_it[t] = static_cast<int>(i);
      }
      for (auto place = on_it.begin(); std::next(place) != on_it.end(); ++place)
        pieces_.push_back({std::min(place->second, std::next(place)->second), std::max(place->second, std::next(place)->second)});
    }
    for (const CanonicalFacet& facet : complex.facets) {
      std::vector<char> in_plane(points.size());
      const Rational3 normal = facet_normal(complex, facet);
      for (std::size_t i = 0; i < points.size(); ++i) in_plane[i] = scalar(normal, minus(points[i], points[facet.frame[0]])) == 0;
      in_plane_.push_back(in_plane);
    }
  }

  /// Empty if the subdivision conforms.
  std::string fault(const Faces& faces) {
    for (const auto& [a, b] : pieces_)
      if (!faces.edges.count({a, b})) return "piece " + std::to_string(a) + " " + std::to_string(b) + " of a segment is missing";
    // Triangles cross no segment now, so each is inside or outside: those inside must add up to the facet.
    for (std::size_t f = 0; f < complex_.facets.size(); ++f) {
      mpq_class area = 0;
      for (const Triple& t : faces.triangles)
        if (in_plane_[f][t[0]] && in_plane_[f][t[1]] && in_plane_[f][t[2]]) area += area_inside(f, t);
      if (area != boundary_area(complex_, complex_.facets[f])) return "facet " + std::to_string(f) + " is not covered";
    }
    return "";
  }

 private:
  /// Twice the triangle's area times the normal's length, if its centroid is in the facet (winding number by a ray), or 0.
  mpq_class area_inside(std::size_t f, const Triple& t) {
    const auto [place, fresh] = known_.try_emplace({f, t}, 0);
    if (!fresh) return place->second;
    const CanonicalFacet& facet = complex_.facets[f];
    const Rational3 normal = facet_normal(complex_, facet);
    int axis = 0;
    while (normal[axis] == 0) ++axis;
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    const Rational3 centre = scaled(mpq_class(1, 3), plus(points_[t[0]], plus(points_[t[1]], points_[t[2]])));
    bool inside = false;
    for (const auto& [a, c] : facet.boundary) {
      const Rational3 &p = points_[a], &q = points_[c];
      if ((p[v] > centre[v]) == (q[v] > centre[v])) continue;
      if (p[u] + (centre[v] - p[v]) * (q[u] - p[u]) / (q[v] - p[v]) > centre[u]) inside = !inside;
    }
    if (inside) place->second = abs(scalar(normal, times(minus(points_[t[1]], points_[t[0]]), minus(points_[t[2]], points_[t[0]]))));
    return place->second;
  }

  const CanonicalComplex& complex_;
  const std::vector<Rational3>& points_;
  std::vector<Pair> pieces_;
  std::vector<std::vector<char>> in_plane_;
  std::map<std::pair<std::size_t, Triple>, mpq_class> known_;
};

}  // namespace

Conformity conformity(const CanonicalComplex& complex, const std::vector<Rational3>& points, int perturbed, std::uint64_t seed) {
  std::mt19937_64 generator(seed);
  std::vector<Kernel::Point_3> kernel_points;
  for (const Rational3& p : points) kernel_points.push_back(kernel_point(p));
  Judge judge(complex, points);
  Conformity result;
  std::set<std::set<Pair>> seen;
  for (int i = 0; i <= perturbed; ++i) {
    const Faces faces = i == 0 ? delaunay(kernel_points, generator) : perturbed_delaunay(kernel_points, generator);
    seen.insert(faces.edges);
    const std::string fault = judge.fault(faces);
    ++result.tried;
    result.conforming += fault.empty();
    if (result.fault.empty()) result.fault = fault;
  }
  result.different = static_cast<int>(seen.size());
  return result;
}

SubdivisionFaces subdivision(const std::vector<Rational3>& points, const std::vector<int>& raised, std::uint64_t seed) {
  std::mt19937_64 generator(seed);
  std::vector<Kernel::Point_3> kernel_points;
  for (const Rational3& p : points) kernel_points.push_back(kernel_point(p));
  const Faces faces = perturbed_delaunay(kernel_points, generator, raised);
  return {{faces.edges.begin(), faces.edges.end()}, {faces.triangles.begin(), faces.triangles.end()}};
}

}  // namespace confidel::test

using namespace confidel::test;

BOOST_AUTO_TEST_SUITE(subdivisions)

BOOST_AUTO_TEST_CASE(the_oracle_sees_ties) {
  // The cube's corners are on one sphere: its squares may have either diagonal.
  CanonicalComplex cube;
  cube.dimension = 3;
  for (int i = 0; i < 8; ++i) cube.vertices.push_back({i & 1, i >> 1 & 1, i >> 2 & 1});
  cube.segments = {{0, 3}};
  const Conformity result = conformity(cube, cube.vertices, 40, 1);
  BOOST_TEST(result.different > 5);
  BOOST_TEST(result.conforming > 0);
  BOOST_TEST(result.conforming < result.tried);
  cube.segments = {{0, 1}, {0, 2}, {4, 5}};
  cube.facets = {{{0, 1, 2}, {{0, 1}, {1, 3}, {2, 0}, {3, 2}}, {}, {}}};
  BOOST_TEST(conformity(cube, cube.vertices, 20, 2).always());
}

BOOST_AUTO_TEST_CASE(the_oracle_sees_the_diagonal_that_ties) {
  // Theory.md, end: a square given as two coplanar triangles, with apexes above and below.
  CanonicalComplex square;
  square.dimension = 3;
  square.vertices = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {mpq_class(1, 2), mpq_class(1, 2), 2}, {mpq_class(1, 2), mpq_class(1, 2), -2}};
  square.segments = {{0, 1}, {0, 2}, {0, 3}, {1, 2}, {2, 3}};
  square.facets = {{{0, 1, 2}, {{0, 1}, {1, 2}, {2, 0}}, {}, {}}, {{0, 2, 3}, {{0, 2}, {2, 3}, {3, 0}}, {}, {}}};
  const Conformity result = conformity(square, square.vertices, 30, 3);
  BOOST_TEST(result.conforming > 0);
  BOOST_TEST(result.conforming < result.tried);
  // As one facet it is covered by either pair of triangles.
  square.segments = {{0, 1}, {0, 3}, {1, 2}, {2, 3}};
  square.facets = {{{0, 1, 2}, {{0, 1}, {1, 2}, {2, 3}, {3, 0}}, {}, {}}};
  BOOST_TEST(conformity(square, square.vertices, 30, 4).always());
}

BOOST_AUTO_TEST_CASE(the_oracle_sees_missing_faces) {
  // W3 without any Steiner points, a facet with a point close above, and a notch that must not count.
  CanonicalComplex complex;
  complex.dimension = 3;
  complex.vertices = {{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {2, 1, 0}, {0, 4, 0}, {1, 3, 5}};
  complex.segments = {{0, 1}, {0, 4}, {1, 2}, {2, 3}, {3, 4}};
  complex.facets = {{{0, 1, 2}, {{0, 1}, {1, 2}, {2, 3}, {3, 4}, {4, 0}}, {}, {}}};
  BOOST_TEST(conformity(complex, complex.vertices, 5, 5).fault == "");
  complex.vertices.push_back({mpq_class(3, 2), mpq_class(3, 4), mpq_class(1, 100)});
  complex.vertices.push_back({mpq_class(3, 2), mpq_class(3, 4), mpq_class(-1, 100)});
  BOOST_TEST(conformity(complex, complex.vertices, 5, 6).conforming == 0);
  const std::vector<Rational3> w3{{0, 0, 0}, {20, 0, 0}, {0, 20, 0}, {20, 20, 1}, {10, 10, -14}};
  CanonicalComplex wedge;
  wedge.dimension = 3;
  wedge.vertices = w3;
  wedge.segments = {{0, 1}, {0, 2}, {0, 3}, {0, 4}, {1, 2}, {1, 3}, {1, 4}};
  wedge.facets = {{{0, 1, 2}, {{0, 1}, {1, 2}, {2, 0}}, {}, {}}, {{0, 1, 3}, {{0, 1}, {1, 3}, {3, 0}}, {}, {}}, {{0, 1, 4}, {{0, 1}, {1, 4}, {4, 0}}, {}, {}}};
  const Conformity result = conformity(wedge, w3, 3, 7);
  BOOST_TEST_MESSAGE("W3 without Steiner points: " << result.fault);
  BOOST_TEST(result.tried == 4);
}

BOOST_AUTO_TEST_SUITE_END()
