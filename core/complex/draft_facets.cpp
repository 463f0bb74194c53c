// SPDX-License-Identifier: GPL-3.0-or-later
// Facets of the input, each by itself: indices, plane, degenerate facets.
#include <fmt/format.h>

#include <cmath>
#include <optional>

#include "core/complex/draft.h"

namespace confidel::building {

namespace {

struct Polygon {
  std::vector<VertexId> corners;  ///< no two consecutive ones equal, also not the last and the first
  int line = 0;
};

class FacetReader {
 public:
  FacetReader(Draft& draft, int source) : draft_(draft), facet_(draft.input.facets[source]) { result_.source = source; }

  std::optional<FacetDraft> read() {
    if (!read_polygons() || !find_plane() || !is_planar()) return std::nullopt;
    collect_edges();
    orient();
    return std::move(result_);
  }

 private:
  std::string name() const { return draft_.facet_name(result_.source); }
  int line_of(const InputPolygon& polygon) const { return polygon.line > 0 ? polygon.line : facet_.line; }

  bool read_polygons() {
    const Input& input = draft_.input;
    const int count = static_cast<int>(input.vertices.size());
    bool valid = true;
    for (const InputPolygon& polygon : facet_.polygons) {
      Polygon cleaned;
      cleaned.line = line_of(polygon);
      for (const int corner : polygon.corners) {
        if (corner < 0 || corner >= count) {
          draft_.add_problem(
              "E-INDEX", cleaned.line,
              fmt::format("{} has the corner {}, which does not exist: vertices are numbered {} to {}", name(),
                          corner + input.first_index, input.first_index, count - 1 + input.first_index));
          valid = false;
          continue;
        }
        const VertexId vertex = draft_.vertex_of[corner];
        if (cleaned.corners.empty() || cleaned.corners.back() != vertex) cleaned.corners.push_back(vertex);
      }
      while (cleaned.corners.size() > 1 && cleaned.corners.front() == cleaned.corners.back())
        cleaned.corners.pop_back();
      if (valid && !accept(polygon, cleaned)) valid = false;
      polygons_.push_back(std::move(cleaned));
    }
    return valid;
  }

  /// Repeated corners: harmless ones are reported, a loop that is none is refused.
  bool accept(const InputPolygon& polygon, const Polygon& cleaned) {
    if (cleaned.corners.size() == polygon.corners.size()) return true;
    if (polygon.corners.size() >= 3 && cleaned.corners.size() < 3) {
      draft_.add_problem(
          "E-DEGENERATE-FACET", cleaned.line,
          fmt::format("a polygon of {} has {} corners, but only {} different ones: remove it or correct it", name(),
                      polygon.corners.size(), cleaned.corners.size()));
      return false;
    }
    draft_.add_remark(fmt::format("a polygon of {} repeats a corner{}: the repetition is ignored", name(),
                                  Draft::line_name(cleaned.line)));
    return true;
  }

  /// The corners, those of loops first, in the order of the file.
  std::vector<VertexId> corners_in_order() const {
    std::vector<VertexId> corners;
    for (const bool loops : {true, false})
      for (const Polygon& polygon : polygons_)
        if ((polygon.corners.size() >= 3) == loops)
          corners.insert(corners.end(), polygon.corners.begin(), polygon.corners.end());
    return corners;
  }

  bool find_plane() {
    corners_ = corners_in_order();
    const auto& points = draft_.vertices;
    std::size_t second = 1;
    while (second < corners_.size() && corners_[second] == corners_[0]) ++second;
    for (std::size_t third = second + 1; third < corners_.size(); ++third) {
      const Point &a = points[corners_[0]], &b = points[corners_[second]], &c = points[corners_[third]];
      if (collinear(a, b, c)) continue;
      plane_ = {corners_[0], corners_[second], corners_[third]};
      result_.normal = plane_normal(a, b, c);
      return true;
    }
    draft_.add_problem(
        "E-DEGENERATE-FACET", facet_.line,
        fmt::format("all {} corners of {} lie on one line: it has no area; remove it", corners_.size(), name()));
    return false;
  }

  /// Refuses the facet and names the vertex that is farthest from the plane.
  bool is_planar() {
    const auto& points = draft_.vertices;
    std::vector<VertexId> off_plane;
    for (const VertexId corner : corners_)
      if (std::find(plane_.begin(), plane_.end(), corner) == plane_.end() &&
          orientation(points[plane_[0]], points[plane_[1]], points[plane_[2]], points[corner]) != 0)
        off_plane.push_back(corner);
    if (off_plane.empty()) return true;
    sort_unique(off_plane);
    const mpq_class diameter_squared = squared_diameter();
    VertexId farthest = off_plane.front();
    double greatest = -1;
    for (const VertexId vertex : off_plane) {
      const double distance = relative_distance(vertex, diameter_squared);
      if (distance > greatest) greatest = distance, farthest = vertex;
    }
    draft_.add_problem(
        "E-NONCOPLANAR", facet_.line,
        fmt::format("{} is not flat: {} is off the plane of its corners {}, {}, {} by {:.3g} of the facet's "
                    "size{}; triangulate the facet or correct the coordinates",
                    name(), draft_.vertex_name(farthest), number(plane_[0]), number(plane_[1]), number(plane_[2]),
                    greatest,
                    off_plane.size() > 1 ? fmt::format(", and {} more", off_plane.size() - 1) : std::string()));
    return false;
  }

  int number(VertexId vertex) const { return draft_.origin[vertex] + draft_.input.first_index; }

  /// Distance from the plane over the facet's diameter: for the reader, but computed exactly before it is rounded,
  /// since it may be far below the rounding errors of the coordinates.
  double relative_distance(VertexId vertex, const mpq_class& diameter_squared) const {
    const Difference offset = difference(draft_.vertices[vertex], draft_.vertices[plane_[0]]);
    const mpz_class along = dot(offset.vector, result_.normal);
    mpq_class ratio = times_power_of_two(mpq_class(along * along), -2 * offset.exponent);
    ratio /= diameter_squared * dot(result_.normal, result_.normal);
    // The square may be too small for a double when its root is not.
    return square_root(ratio);
  }

  static double square_root(const mpq_class& square) {
    long exponents[2];
    const double numerator = mpz_get_d_2exp(&exponents[0], square.get_num_mpz_t());
    const double denominator = mpz_get_d_2exp(&exponents[1], square.get_den_mpz_t());
    const long exponent = exponents[0] - exponents[1];
    const long odd = exponent % 2;
    return std::ldexp(std::sqrt(std::ldexp(numerator / denominator, static_cast<int>(odd))),
                      static_cast<int>((exponent - odd) / 2));
  }

  /// The square of the greatest distance from the first corner: the diameter, up to a factor of 2.
  mpq_class squared_diameter() const {
    mpq_class greatest = 0;
    for (const VertexId corner : corners_) {
      const Difference reach = difference(draft_.vertices[corner], draft_.vertices[plane_[0]]);
      const mpq_class square = times_power_of_two(dot(reach.vector, reach.vector), -2 * reach.exponent);
      if (square > greatest) greatest = square;
    }
    return greatest;
  }

  void collect_edges() {
    for (const Polygon& polygon : polygons_) {
      const auto& corners = polygon.corners;
      if (corners.size() == 1) result_.points.push_back(corners[0]);
      for (std::size_t i = 0; corners.size() > 1 && i < corners.size(); ++i)
        result_.edges.push_back(make_segment(corners[i], corners[(i + 1) % corners.size()]));
      result_.has_loop = result_.has_loop || corners.size() >= 3;
    }
    sort_unique(result_.edges);
    sort_unique(result_.points);
  }

  /// The positive side is the one from which the first loop runs counter-clockwise, so that surfaces keep their
  /// orientation.
  void orient() {
    for (const Polygon& polygon : polygons_) {
      if (polygon.corners.size() < 3) continue;
      if (polygon.corners.size() > 3 && loop_area_sign(polygon.corners) < 0)
        for (mpz_class& component : result_.normal) component = -component;
      break;
    }
    if (polygons_.size() != 1 || polygons_[0].corners.size() != 3 || !facet_.holes.empty()) return;
    result_.is_triangle = true;
    std::copy_n(polygons_[0].corners.begin(), 3, result_.corners.begin());
    std::rotate(result_.corners.begin(), std::min_element(result_.corners.begin(), result_.corners.end()),
                result_.corners.end());
  }

  /// Sign of the area vector's component along the normal.
  int loop_area_sign(const std::vector<VertexId>& loop) const {
    mpq_class sum = 0;
    const Point& origin = draft_.vertices[loop[0]];
    for (std::size_t i = 1; i + 1 < loop.size(); ++i) {
      const Difference a = difference(draft_.vertices[loop[i]], origin);
      const Difference b = difference(draft_.vertices[loop[i + 1]], origin);
      sum += times_power_of_two(dot(cross(a.vector, b.vector), result_.normal), -(a.exponent + b.exponent));
    }
    return sgn(sum);
  }

  Draft& draft_;
  const InputFacet& facet_;
  std::vector<Polygon> polygons_;
  std::vector<VertexId> corners_;
  std::array<VertexId, 3> plane_{};
  FacetDraft result_;
};

}  // namespace

void draft_facets(Draft& draft) {
  for (std::size_t source = 0; source < draft.input.facets.size(); ++source)
    if (auto facet = FacetReader(draft, static_cast<int>(source)).read()) draft.facets.push_back(std::move(*facet));
}

}  // namespace confidel::building
