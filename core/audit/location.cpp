// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/audit/location.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <unordered_map>

#include "core/complex/broad_phase.h"
#include "core/numbers/predicates.h"
#include "core/planar/frame.h"

namespace confidel {
namespace {

using building::Box;

/// sqrt(numerator / denominator) / 2^exponent, whatever the integers' size. Pre: numerator >= 0, denominator > 0.
double root_of_quotient(const mpz_class& numerator, const mpz_class& denominator, int exponent) {
  long shift = 0, below = 0;
  const double value = mpz_get_d_2exp(&shift, numerator.get_mpz_t()), divisor = mpz_get_d_2exp(&below, denominator.get_mpz_t());
  const long power = shift - below;
  return std::ldexp(std::sqrt(std::ldexp(value / divisor, static_cast<int>(power & 1))), static_cast<int>(power >> 1) - exponent);
}

/// Distances in the input's units, rounded; computed from exact differences, since they are far below the coordinates' rounding errors. They
/// are reported, not decided upon.
class Distances {
 public:
  explicit Distances(const Complex& complex) : complex_(complex) {}

  /// Of p from the segment; infinite if it does not project into its interior.
  double to_segment(const Segment& segment, const Point& p) const {
    const Difference u = difference(complex_.vertices[segment[1]], complex_.vertices[segment[0]]);
    const Difference d = difference(p, complex_.vertices[segment[0]]);
    const mpz_class along = dot(u.vector, d.vector), uu = dot(u.vector, u.vector);
    // 0 < d.u < u.u, the differences having their own powers of two.
    const mpz_class whole = uu << std::max(0, d.exponent - u.exponent), part = along << std::max(0, u.exponent - d.exponent);
    if (part <= 0 || part >= whole) return INFINITY;
    const IntegerVector moment = cross(u.vector, d.vector);
    return std::ldexp(root_of_quotient(dot(moment, moment), uu, d.exponent), complex_.scale);
  }

  /// Of p from the triangle's plane; infinite if it projects outside of the triangle by more than a hair.
  double to_triangle(const std::array<VertexId, 3>& corners, const Point& p) const {
    const Point &a = complex_.vertices[corners[0]], &b = complex_.vertices[corners[1]], &c = complex_.vertices[corners[2]];
    const Double3 u = approximate_difference(b, a), w = approximate_difference(c, a), d = approximate_difference(p, a), n = cross(u, w);
    const double nn = dot(n, n), s = dot(cross(d, w), n) / nn, t = dot(cross(u, d), n) / nn;
    constexpr double hair = 1e-9;
    if (!(s > -hair && t > -hair && s + t < 1 + hair)) return INFINITY;
    const IntegerVector normal = plane_normal(a, b, c);
    const Difference step = difference(p, a);
    const mpz_class height = dot(normal, step.vector);
    return std::ldexp(root_of_quotient(height * height, dot(normal, normal), step.exponent), complex_.scale);
  }

 private:
  const Complex& complex_;
};

Box inflated(Box box, double by) {
  for (int axis = 0; axis < 3; ++axis) box.low[axis] -= by, box.high[axis] += by;
  return box;
}

class Locator {
 public:
  Locator(const Complex& complex, const Mesh& mesh, double near) : complex_(complex), mesh_(mesh), near_(near), distances_(complex) {}

  Locations run() {
    match_points();
    for (const VertexId vertex : all_vertices()) positions_.push_back(complex_.input_position(vertex).approximate());
    for (std::size_t point = 0; point < mesh_.points.size(); ++point) point_boxes_.push_back(inflated({mesh_.points[point], mesh_.points[point]}, near_));
    near_facets_.resize(mesh_.points.size());
    find_on_segments();
    find_on_facets();
    finish();
    return std::move(result_);
  }

 private:
  std::vector<VertexId> all_vertices() const {
    std::vector<VertexId> vertices(complex_.vertices.size());
    for (std::size_t i = 0; i < vertices.size(); ++i) vertices[i] = static_cast<VertexId>(i);
    return vertices;
  }

  void match_points() {
    std::unordered_map<Point, int, PointHash> point_at;
    for (const auto& [x, y, z] : mesh_.points) {
      const int id = static_cast<int>(result_.points.size());
      result_.points.push_back(Point::from_doubles(x, y, z).scaled(-complex_.scale));
      if (!point_at.emplace(result_.points.back(), id).second) result_.duplicates.push_back(id);
    }
    result_.vertex_of_point.assign(result_.points.size(), -1);
    for (const VertexId vertex : all_vertices()) {
      const auto found = point_at.find(complex_.vertices[vertex]);
      result_.point_of_vertex.push_back(found == point_at.end() ? -1 : found->second);
      if (found != point_at.end()) result_.vertex_of_point[found->second] = vertex;
    }
  }

  bool is_candidate(int point) const {
    return result_.vertex_of_point[point] < 0 && !std::binary_search(result_.duplicates.begin(), result_.duplicates.end(), point);
  }

  void find_on_segments() {
    result_.on_segment.resize(complex_.segments.size());
    std::vector<Box> boxes;
    for (const Segment& segment : complex_.segments) boxes.push_back(inflated(building::bounding_box(positions_, segment), near_));
    building::for_each_meeting_pair(point_boxes_, boxes, [&](int point, int index) {
      if (!is_candidate(point)) return;
      const Segment& segment = complex_.segments[index];
      const Point &a = complex_.vertices[segment[0]], &b = complex_.vertices[segment[1]], &p = result_.points[point];
      if (collinear(a, b, p)) {
        if (strictly_between(a, b, p)) result_.on_segment[index].push_back(point), on_segment_.insert(point);
        return;
      }
      const double distance = distances_.to_segment(segment, p);
      if (distance <= near_) add_near(point, {point, true, index, distance});
    });
    for (std::size_t s = 0; s < complex_.segments.size(); ++s) {
      auto& points = result_.on_segment[s];
      // On a line, lexicographic order is order along it.
      const bool forward = Point::compare(complex_.vertices[complex_.segments[s][0]], complex_.vertices[complex_.segments[s][1]]) < 0;
      std::sort(points.begin(), points.end(), [&](int i, int j) {
        const int order = Point::compare(result_.points[i], result_.points[j]);
        return forward ? order < 0 : order > 0;
      });
    }
  }

  void find_on_facets() {
    result_.on_facet.resize(complex_.facets.size());
    std::vector<Box> boxes;
    std::vector<std::pair<FacetId, const std::array<VertexId, 3>*>> triangles;
    for (std::size_t f = 0; f < complex_.facets.size(); ++f)
      for (const auto& triangle : complex_.facets[f].triangles) {
        triangles.emplace_back(static_cast<FacetId>(f), &triangle);
        boxes.push_back(inflated(building::bounding_box(positions_, triangle), near_));
      }
    building::for_each_meeting_pair(point_boxes_, boxes, [&](int point, int index) {
      const auto& [f, corners] = triangles[index];
      if (!is_candidate(point)) return;
      const Point &a = complex_.vertices[(*corners)[0]], &b = complex_.vertices[(*corners)[1]], &c = complex_.vertices[(*corners)[2]];
      const Point& p = result_.points[point];
      if (orientation(a, b, c, p) != 0) {
        const double distance = distances_.to_triangle(*corners, p);
        if (distance <= near_) add_near(point, {point, false, f, distance});
        return;
      }
      const Projection projection = projection_of(complex_.facets[f].normal);
      const auto inside = [&](const Point& from, const Point& to) { return planar_orientation(projection, from, to, p) >= 0; };
      if (!inside(a, b) || !inside(b, c) || !inside(c, a)) return;
      near_facets_[point].insert(f);
      if (on_segment_.count(point) == 0) result_.on_facet[f].push_back(point);
    });
    for (auto& points : result_.on_facet) {
      std::sort(points.begin(), points.end());
      points.erase(std::unique(points.begin(), points.end()), points.end());
    }
  }

  void add_near(int point, const OffCarrier& off) {
    const auto found = nearest_.find(point);
    // A segment is the narrower statement; among equals the nearer one, then the first.
    const auto rank = [](const OffCarrier& each) { return std::make_tuple(!each.on_segment, each.distance, each.carrier); };
    if (found == nearest_.end() || rank(off) < rank(found->second)) nearest_[point] = off;
    if (!off.on_segment) near_facets_[point].insert(off.carrier);
  }

  void finish() {
    const auto facets = facets_of_segments(complex_);
    for (std::size_t s = 0; s < result_.on_segment.size(); ++s)
      for (const int point : result_.on_segment[s]) near_facets_[point].insert(facets[s].begin(), facets[s].end());
    for (const auto& [point, off] : nearest_) {
      if (on_segment_.count(point) != 0) continue;
      if (off.on_segment) near_facets_[point].insert(facets[off.carrier].begin(), facets[off.carrier].end());
      else if (is_on_a_facet(point)) continue;  // exactly on one facet and near another: that is no fault
      result_.off.push_back(off);
    }
    for (std::size_t f = 0; f < complex_.facets.size(); ++f)
      for (const auto* edges : {&complex_.facets[f].boundary, &complex_.facets[f].constraints})
        for (const auto& edge : *edges)
          for (const VertexId vertex : edge)
            if (const int point = result_.point_of_vertex[vertex]; point >= 0) near_facets_[point].insert(static_cast<FacetId>(f));
    for (std::size_t f = 0; f < complex_.facets.size(); ++f)
      for (const VertexId vertex : complex_.facets[f].isolated)
        if (const int point = result_.point_of_vertex[vertex]; point >= 0) near_facets_[point].insert(static_cast<FacetId>(f));
    for (int point = 0; point < static_cast<int>(result_.points.size()); ++point) {
      result_.near_facets.emplace_back(near_facets_[point].begin(), near_facets_[point].end());
      if (is_candidate(point) && near_facets_[point].empty() && on_segment_.count(point) == 0 && nearest_.count(point) == 0) ++result_.inner;
    }
  }

  bool is_on_a_facet(int point) const {
    for (const FacetId f : near_facets_[point])
      if (std::binary_search(result_.on_facet[f].begin(), result_.on_facet[f].end(), point)) return true;
    return false;
  }

  const Complex& complex_;
  const Mesh& mesh_;
  double near_;
  Distances distances_;
  Locations result_;
  std::vector<std::array<double, 3>> positions_;
  std::vector<Box> point_boxes_;
  std::set<int> on_segment_;
  std::map<int, OffCarrier> nearest_;
  std::vector<std::set<FacetId>> near_facets_;
};

}  // namespace

std::vector<std::vector<FacetId>> facets_of_segments(const Complex& complex) {
  std::vector<std::vector<FacetId>> result(complex.segments.size());
  for (std::size_t f = 0; f < complex.facets.size(); ++f)
    for (const auto* edges : {&complex.facets[f].boundary, &complex.facets[f].constraints})
      for (const auto& [a, b] : *edges) {
        auto& list = result[complex.find_segment(a, b)];
        if (list.empty() || list.back() != static_cast<FacetId>(f)) list.push_back(static_cast<FacetId>(f));
      }
  return result;
}

Locations locate(const Complex& complex, const Mesh& mesh, double near) { return Locator(complex, mesh, near).run(); }

}  // namespace confidel
