// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/complex/repair.h"

#include <fmt/format.h>

#include <cmath>
#include <map>
#include <set>

#include "core/complex/draft.h"
#include "core/complex/intersection.h"

namespace confidel {
namespace {

using namespace building;
using Position = std::array<double, 3>;

Point exact(const Position& position) { return Point::from_doubles(position[0], position[1], position[2]); }

std::string name(const char* what, std::size_t index, int line, const Input& input) {
  return fmt::format("{} {}{}", what, index + static_cast<std::size_t>(input.first_index), Draft::line_name(line));
}

// --- facets that are not flat ----------------------------------------------------------------------------------------------------

class FacetCutter {
 public:
  FacetCutter(const Input& input, std::size_t index) : input_(input), facet_(input.facets[index]), name_(name("facet", index, facet_.line, input)) {}

  bool is_flat() {
    for (const InputPolygon& polygon : facet_.polygons)
      for (const int corner : polygon.corners) {
        if (corner < 0 || corner >= static_cast<int>(input_.vertices.size())) fail("E-INDEX", "has a corner that does not exist");
        corners_.push_back(corner);
      }
    sort_unique(corners_);
    for (const int corner : corners_) points_.push_back(exact(input_.vertices[corner].position));
    // The first three corners that span a plane decide.
    std::size_t second = 1, third = 2;
    while (second < points_.size() && points_[second] == points_[0]) ++second;
    while (third < points_.size() && collinear(points_[0], points_[second], points_[third])) ++third;
    if (third >= points_.size()) return true;  // It has no area: that is not for triangles to repair.
    for (const Point& point : points_)
      if (orientation(points_[0], points_[second], points_[third], point) != 0) return false;
    return true;
  }

  std::vector<InputFacet> cut() {
    if (!facet_.holes.empty()) fail("E-NONCOPLANAR", "is not flat and has hole points: which side of it they mean is unclear; give its holes as facets");
    project();
    collect_edges();
    IntegerVector up{0, 0, 1};
    const std::vector<Segment> no_edges;
    const std::vector<VertexId> no_points;
    const std::vector<Point> no_seeds;
    const std::vector<Position> no_positions;
    const Region region = enclosed_region({flat_, positions_, up, edges_, no_edges, no_points, no_points, no_seeds, no_positions, false});
    if (region.triangles.empty()) fail("E-DEGENERATE-FACET", "is not flat, and its loops enclose nothing when seen along a coordinate axis; triangulate it by hand");
    std::vector<InputFacet> result;
    for (const auto& triangle : region.triangles) {
      InputFacet part;
      part.marker = facet_.marker;
      part.line = facet_.line;
      part.polygons.push_back({{corners_[triangle[0]], corners_[triangle[1]], corners_[triangle[2]]}, facet_.line});
      result.push_back(std::move(part));
    }
    std::sort(result.begin(), result.end(), [](const InputFacet& a, const InputFacet& b) { return a.polygons[0].corners < b.polygons[0].corners; });
    return result;
  }

  const std::string& facet_name() const { return name_; }

 private:
  [[noreturn]] void fail(const char* code, const char* why) const { throw InputError({{code, {input_.file, facet_.line, 0}, fmt::format("{} {}", name_, why)}}); }

  int local(int corner) const { return static_cast<int>(std::lower_bound(corners_.begin(), corners_.end(), corner) - corners_.begin()); }

  /// Along the axis in which the loops' area vector is greatest (doubles choose).
  void project() {
    Position area{};
    for (const InputPolygon& polygon : facet_.polygons)
      for (std::size_t i = 0; i < polygon.corners.size(); ++i) {
        const Position &a = input_.vertices[polygon.corners[i]].position, &b = input_.vertices[polygon.corners[(i + 1) % polygon.corners.size()]].position;
        for (int axis = 0; axis < 3; ++axis) area[axis] += (a[(axis + 1) % 3] - b[(axis + 1) % 3]) * (a[(axis + 2) % 3] + b[(axis + 2) % 3]);
      }
    int axis = 2;
    for (const int each : {1, 0})
      if (std::abs(area[each]) > std::abs(area[axis])) axis = each;
    for (const int corner : corners_) {
      const Position& at = input_.vertices[corner].position;
      positions_.push_back({at[(axis + 1) % 3], at[(axis + 2) % 3], 0});
      flat_.push_back(exact(positions_.back()));
    }
  }

  void collect_edges() {
    for (const InputPolygon& polygon : facet_.polygons)
      for (std::size_t i = 0; i < polygon.corners.size(); ++i) {
        const int a = local(polygon.corners[i]), b = local(polygon.corners[(i + 1) % polygon.corners.size()]);
        if (a != b) edges_.push_back(make_segment(a, b));
      }
    sort_unique(edges_);
    // One facet's corners are few: all pairs.
    for (std::size_t i = 0; i < edges_.size(); ++i) {
      const Point &a = flat_[edges_[i][0]], &b = flat_[edges_[i][1]];
      if (a == b) fail("E-NONCOPLANAR", "is not flat and stands upright on its projection: triangulate it by hand");
      for (std::size_t v = 0; v < flat_.size(); ++v)
        if (static_cast<int>(v) != edges_[i][0] && static_cast<int>(v) != edges_[i][1] && collinear(a, b, flat_[v]) && (flat_[v] == a || flat_[v] == b || strictly_between(a, b, flat_[v])))
          fail("E-NONCOPLANAR", "is not flat and touches itself when seen along a coordinate axis: triangulate it by hand");
      for (std::size_t j = 0; j < i; ++j) {
        const Segment &s = edges_[i], &t = edges_[j];
        if (s[0] == t[0] || s[0] == t[1] || s[1] == t[0] || s[1] == t[1]) continue;
        if (planar_segments_cross(a, b, flat_[t[0]], flat_[t[1]])) fail("E-NONCOPLANAR", "is not flat and crosses itself when seen along a coordinate axis: triangulate it by hand");
      }
    }
  }

  const Input& input_;
  const InputFacet& facet_;
  std::string name_;
  std::vector<int> corners_;  ///< sorted; the places in it number the projected points
  std::vector<Point> points_, flat_;
  std::vector<Position> positions_;
  std::vector<Segment> edges_;
};

// --- crossings in the plane --------------------------------------------------------------------------------------------------------

/// The nearest double, ties to even as everywhere.
double nearest(const mpq_class& value) {
  const double truncated = value.get_d();
  double best = truncated;
  mpq_class least = abs(value - mpq_class(truncated));
  for (const double candidate : {std::nextafter(truncated, INFINITY), std::nextafter(truncated, -INFINITY)}) {
    const mpq_class distance = abs(value - mpq_class(candidate));
    if (distance < least) least = distance, best = candidate;
  }
  return best + 0.0;  // no negative zero
}

class CrossingSplitter {
 public:
  explicit CrossingSplitter(Input& input) : input_(input) {}

  /// Splits all crossings once; false if there were none.
  bool round(std::vector<Repair>& repairs) {
    Draft draft(input_);
    draft_vertices(draft, {});
    draft_segments(draft);
    split_edges(draft);
    if (!draft.problems.empty()) {
      std::vector<Problem> problems = std::move(draft.problems);
      throw InputError(std::move(problems));
    }
    const auto crossings = find_crossing_edges(draft);
    if (crossings.empty()) return false;
    for (std::size_t i = 0; i < input_.vertices.size(); ++i) vertex_at_[key(input_.vertices[i].position)] = static_cast<int>(i);
    std::map<int, std::vector<int>> stations;  // of each edge that is crossed: vertices on it
    for (const auto& [i, j] : crossings) {
      const int vertex = crossing_vertex(draft, i, j, repairs);
      for (const int edge : {i, j})
        if (draft.origin[draft.edges[edge].ends[0]] != vertex && draft.origin[draft.edges[edge].ends[1]] != vertex) stations[edge].push_back(vertex);
    }
    std::vector<InputSegment> segments;
    std::set<std::array<int, 2>> known;
    const auto add = [&](int a, int b, const InputSegment& source) {
      if (a == b || !known.insert({std::min(a, b), std::max(a, b)}).second) return;
      InputSegment piece = source;
      piece.ends = {a, b};
      segments.push_back(piece);
    };
    for (std::size_t edge = 0; edge < draft.edges.size(); ++edge) {
      const EdgeRecord& record = draft.edges[edge];
      const InputSegment& source = input_.segments[record.segment];
      std::vector<int> chain = stations.count(static_cast<int>(edge)) != 0 ? ordered(draft, record, stations[static_cast<int>(edge)]) : std::vector<int>();
      chain.insert(chain.begin(), draft.origin[record.ends[0]]);
      chain.push_back(draft.origin[record.ends[1]]);
      for (std::size_t i = 0; i + 1 < chain.size(); ++i) add(chain[i], chain[i + 1], source);
    }
    input_.segments = std::move(segments);
    return true;
  }

 private:
  using Key = std::array<double, 2>;
  static Key key(const Position& position) { return {position[0] + 0.0, position[1] + 0.0}; }

  int crossing_vertex(const Draft& draft, int i, int j, std::vector<Repair>& repairs) {
    const EdgeRecord &first = draft.edges[i], &second = draft.edges[j];
    const auto place = [&](VertexId vertex) { return exact(draft.positions[vertex]); };
    const auto point = crossing_point(place(first.ends[0]), place(first.ends[1]), place(second.ends[0]), place(second.ends[1]));
    const Position rounded{nearest(point[0]), nearest(point[1]), 0};
    const mpq_class x = point[0] - mpq_class(rounded[0]), y = point[1] - mpq_class(rounded[1]), squared = x * x + y * y;
    const auto [found, is_new] = vertex_at_.emplace(key(rounded), static_cast<int>(input_.vertices.size()));
    if (is_new) input_.vertices.push_back({rounded, 0, 0});
    const double moved = std::sqrt(squared.get_d());
    repairs.push_back({"split",
                       fmt::format("{} and {} are split at {} {} = ({}, {}), {}", draft.edge_name(second), draft.edge_name(first),
                                   is_new ? "the new vertex" : "vertex", found->second + input_.first_index, rounded[0], rounded[1],
                                   squared == 0 ? "exactly their crossing" : fmt::format("{:.3g} away from their crossing ({}, {})", moved, point[0].get_str(), point[1].get_str())),
                       moved});
    return found->second;
  }

  /// Along the edge; exactly, by the projection of the rounded positions on it.
  std::vector<int> ordered(const Draft& draft, const EdgeRecord& edge, std::vector<int> vertices) const {
    const Position &a = draft.positions[edge.ends[0]], &b = draft.positions[edge.ends[1]];
    const auto along = [&](int vertex) {
      const Position& p = input_.vertices[vertex].position;
      return mpq_class((mpq_class(p[0]) - a[0]) * (mpq_class(b[0]) - a[0]) + (mpq_class(p[1]) - a[1]) * (mpq_class(b[1]) - a[1]));
    };
    sort_unique(vertices);
    std::sort(vertices.begin(), vertices.end(), [&](int first, int second) { return along(first) < along(second); });
    return vertices;
  }

  Input& input_;
  std::map<Key, int> vertex_at_;
};

}  // namespace

std::vector<Repair> merge_identical_vertices(Input& input) {
  std::map<Position, int> known;
  std::vector<int> place;
  std::vector<InputVertex> kept;
  std::vector<Repair> repairs;
  for (std::size_t i = 0; i < input.vertices.size(); ++i) {
    Position position = input.vertices[i].position;
    for (double& coordinate : position) coordinate += 0.0;
    const auto [found, is_new] = known.emplace(position, static_cast<int>(kept.size()));
    place.push_back(found->second);
    if (is_new) kept.push_back(input.vertices[i]);
    else repairs.push_back({"merge", fmt::format("{} is merged with the earlier one at ({}, {}, {})", name("vertex", i, input.vertices[i].line, input), position[0], position[1], position[2]), 0});
  }
  if (repairs.empty()) return repairs;
  const auto renumber = [&](int& vertex) {
    if (vertex >= 0 && vertex < static_cast<int>(place.size())) vertex = place[vertex];
  };
  for (InputFacet& facet : input.facets)
    for (InputPolygon& polygon : facet.polygons)
      for (int& corner : polygon.corners) renumber(corner);
  for (InputSegment& segment : input.segments)
    for (int& end : segment.ends) renumber(end);
  input.vertices = std::move(kept);
  return repairs;
}

std::vector<Repair> triangulate_facets(Input& input) {
  std::vector<InputFacet> facets;
  std::vector<Repair> repairs;
  for (std::size_t i = 0; i < input.facets.size(); ++i) {
    FacetCutter cutter(input, i);
    if (cutter.is_flat()) {
      facets.push_back(input.facets[i]);
      continue;
    }
    std::vector<InputFacet> parts = cutter.cut();
    repairs.push_back({"triangulate", fmt::format("{} is not flat: {} triangles take its place", cutter.facet_name(), parts.size()), 0});
    std::move(parts.begin(), parts.end(), std::back_inserter(facets));
  }
  input.facets = std::move(facets);
  return repairs;
}

std::vector<Repair> split_crossings(Input& input) {
  if (input.dimension != 2) throw InputError({{"E-FORMAT", {input.file, 0, 0}, "crossings are split in the plane only: this input is of dimension 3"}});
  constexpr int most_rounds = 100;
  std::vector<Repair> repairs;
  for (int round = 0; round < most_rounds; ++round)
    if (!CrossingSplitter(input).round(repairs)) return repairs;
  throw InputError({{"E-CROSSING", {input.file, 0, 0}, fmt::format("after {} rounds of splitting, rounded segments still cross: the segments are too close together for doubles", most_rounds)}});
}

}  // namespace confidel
