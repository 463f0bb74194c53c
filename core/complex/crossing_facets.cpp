// SPDX-License-Identifier: GPL-3.0-or-later
// Facets that meet in more than common vertices and segments. Every vertex in a facet is one of its vertices by now,
// and every segment in it one of its edges; so two facets meet wrongly iff two of their triangles have a piece of a
// line in common that is no edge of both on a segment, or an area.
#include <fmt/format.h>

#include <map>
#include <set>

#include "core/complex/broad_phase.h"
#include "core/complex/draft.h"
#include "core/complex/intersection.h"

namespace confidel::building {

namespace {

struct Triangle {
  int facet = 0;  ///< index in Draft::facets
  std::array<VertexId, 3> corners{};
};

class FacetCrossings {
 public:
  FacetCrossings(Draft& draft, const std::vector<std::pair<int, int>>& crossings)
      : draft_(draft), crossings_(crossings) {
    for (std::size_t f = 0; f < draft.facets.size(); ++f) {
      const FacetDraft& facet = draft.facets[f];
      if (!facet.sound) continue;
      for (const auto& corners : facet.region.triangles) {
        triangles_.push_back({static_cast<int>(f), corners});
        boxes_.push_back(bounding_box(draft.positions, corners));
      }
    }
    for (const EdgeRecord& edge : draft.edges) segments_.push_back(edge.ends);
    for (const auto& [first, second] : crossings) crossing_edges_.insert({first, second});
  }

  void report() {
    for_each_meeting_pair(boxes_, [&](int i, int j) { test(std::min(i, j), std::max(i, j)); });
    for (const auto& [pair, found] : found_) report_pair(pair, found);
    report_piercing_segments();
  }

 private:
  struct Found {
    Meeting meeting;
    int first, second;  ///< triangles
  };

  Corners corners_of(const Triangle& triangle) const {
    const auto& [a, b, c] = triangle.corners;
    return {&draft_.vertices[a], &draft_.vertices[b], &draft_.vertices[c]};
  }

  bool is_segment(const Segment& edge) const { return std::binary_search(segments_.begin(), segments_.end(), edge); }

  void test(int i, int j) {
    const Triangle &first = triangles_[i], &second = triangles_[j];
    if (first.facet == second.facet) return;
    std::vector<VertexId> common;
    for (const VertexId corner : first.corners)
      if (std::find(second.corners.begin(), second.corners.end(), corner) != second.corners.end())
        common.push_back(corner);
    Meeting meeting = Meeting::none;
    if (common.size() == 3) {
      meeting = Meeting::area;
    } else {
      const bool on_segment = common.size() == 2 && is_segment(make_segment(common[0], common[1]));
      if ((common.size() < 2 || on_segment) && meet_in_common_corners(corners_of(first), corners_of(second))) return;
      meeting = meeting_of(corners_of(first), corners_of(second));
      // Triangles in different planes with two common corners meet in their common edge: right, if it is a segment.
      if (meeting == Meeting::line && on_segment) return;
    }
    if (meeting == Meeting::none) return;
    const std::pair<int, int> facets = std::minmax(first.facet, second.facet);
    const Found found{meeting, i, j};
    const auto [entry, is_new] = found_.emplace(facets, found);
    // The order of the pairs is the broad phase's business: keep the least, so that messages are reproducible.
    if (!is_new && std::pair(i, j) < std::pair(entry->second.first, entry->second.second)) entry->second = found;
  }

  int line_of(int facet) const { return draft_.input.facets[draft_.facets[facet].source].line; }
  std::string name_of(int facet) const { return draft_.facet_name(draft_.facets[facet].source); }

  /// Was the meeting of these facets said already? Yes if their edges cross; and a crossing edge of one that runs in
  /// the other could not become an edge of that.
  bool is_known(const std::pair<int, int>& pair) const {
    const FacetDraft &first = draft_.facets[pair.first], &second = draft_.facets[pair.second];
    for (const auto& [i, j] : crossings_) {
      const Segment &a = draft_.edges[i].ends, &b = draft_.edges[j].ends;
      if ((has_edge(first, a) && has_edge(second, b)) || (has_edge(first, b) && has_edge(second, a))) return true;
      for (const Segment& edge : {a, b})
        if ((has_edge(first, edge) && has_guest_end(second, edge)) ||
            (has_edge(second, edge) && has_guest_end(first, edge)))
          return true;
    }
    return false;
  }

  static bool has_edge(const FacetDraft& facet, const Segment& edge) {
    return std::binary_search(facet.edges.begin(), facet.edges.end(), edge);
  }
  static bool has_guest_end(const FacetDraft& facet, const Segment& edge) {
    const auto is_guest = [&](VertexId vertex) {
      return std::binary_search(facet.guest_points.begin(), facet.guest_points.end(), vertex);
    };
    return is_guest(edge[0]) || is_guest(edge[1]);
  }

  void report_pair(const std::pair<int, int>& pair, const Found& found) {
    const int line = std::max(line_of(pair.first), line_of(pair.second));
    if (found.meeting == Meeting::area) {
      const bool same = draft_.facets[pair.first].edges == draft_.facets[pair.second].edges;
      draft_.add_problem("E-OVERLAP", line,
                         fmt::format("{} and {} {}; {}", name_of(pair.second), name_of(pair.first),
                                     same ? "are the same" : "lie in one plane and overlap",
                                     same ? "remove one of them" : "cut them so that they have only edges in common"));
    } else if (!is_known(pair)) {
      draft_.add_problem("E-CROSSING", line,
                         fmt::format("{} and {} cross near {}; make the line where they meet a segment of both",
                                     name_of(pair.second), name_of(pair.first), near(found)));
    }
  }

  /// Rounded middle of the points where edges of one triangle pierce the other, or of common corners.
  std::string near(const Found& found) const {
    std::array<double, 3> sum{};
    int count = 0;
    const auto add = [&](const std::array<double, 3>& point) {
      for (int axis = 0; axis < 3; ++axis) sum[axis] += point[axis];
      ++count;
    };
    for (const auto& [one, other] : {std::pair(found.first, found.second), std::pair(found.second, found.first)})
      for (int k = 0; k < 3; ++k) {
        const VertexId a = triangles_[one].corners[k], b = triangles_[one].corners[(k + 1) % 3];
        const auto& others = triangles_[other].corners;
        if (std::find(others.begin(), others.end(), a) != others.end()) add(draft_.positions[a]);
        if (segment_pierces(draft_.vertices[a], draft_.vertices[b], corners_of(triangles_[other])))
          add(piercing(a, b, other));
      }
    if (count == 0) add(draft_.positions[triangles_[found.first].corners[0]]);
    return fmt::format("({:.6g}, {:.6g}, {:.6g})", sum[0] / count, sum[1] / count, sum[2] / count);
  }

  std::array<double, 3> piercing(VertexId a, VertexId b, int triangle) const {
    const std::array<double, 3>&p = draft_.positions[a], &q = draft_.positions[b];
    const std::array<double, 3>& origin = draft_.positions[triangles_[triangle].corners[0]];
    const IntegerVector& exact = draft_.facets[triangles_[triangle].facet].normal;
    mpz_class greatest = 1;
    for (const mpz_class& component : exact)
      if (abs(component) > greatest) greatest = abs(component);
    double from = 0, to = 0;
    for (int axis = 0; axis < 3; ++axis) {
      const double component = mpq_class(exact[axis], greatest).get_d();
      from += (p[axis] - origin[axis]) * component;
      to += (q[axis] - origin[axis]) * component;
    }
    const double parameter = from == to ? 0.5 : from / (from - to);
    return {p[0] + parameter * (q[0] - p[0]), p[1] + parameter * (q[1] - p[1]), p[2] + parameter * (q[2] - p[2])};
  }

  /// Every edge of a region, as an unordered pair: sorted.
  std::vector<Segment> region_edges() const {
    std::vector<Segment> edges;
    for (const FacetDraft& facet : draft_.facets) {
      if (!facet.sound) continue;
      for (const auto& [a, b] : facet.region.boundary) edges.push_back(make_segment(a, b));
      edges.insert(edges.end(), facet.region.constraints.begin(), facet.region.constraints.end());
    }
    sort_unique(edges);
    return edges;
  }

  /// Edges of no region: those of regions pierce a facet only where two facets cross.
  void report_piercing_segments() {
    const std::vector<Segment> in_regions = region_edges();
    std::vector<Box> boxes;
    std::vector<int> edges;
    for (std::size_t index = 0; index < draft_.edges.size(); ++index)
      if (!std::binary_search(in_regions.begin(), in_regions.end(), draft_.edges[index].ends)) {
        edges.push_back(static_cast<int>(index));
        boxes.push_back(bounding_box(draft_.positions, draft_.edges[index].ends));
      }
    if (boxes.empty()) return;
    std::map<std::pair<int, int>, int> found;  // (edge, facet): triangle
    for_each_meeting_pair(boxes, boxes_, [&](int i, int t) {
      const Segment& edge = draft_.edges[edges[i]].ends;
      if (!segment_pierces(draft_.vertices[edge[0]], draft_.vertices[edge[1]], corners_of(triangles_[t]))) return;
      const auto [entry, is_new] = found.emplace(std::pair(edges[i], triangles_[t].facet), t);
      entry->second = std::min(entry->second, t);
    });
    for (const auto& [pair, t] : found) {
      const EdgeRecord& edge = draft_.edges[pair.first];
      // A crossing with the facet's own edge was reported as such.
      if (crossing_edges_.count(pair.first) != 0) continue;
      const auto point = piercing(edge.ends[0], edge.ends[1], t);
      draft_.add_problem("E-CROSSING", edge.line,
                         fmt::format("{} pierces {} near ({:.6g}, {:.6g}, {:.6g}); make that point a vertex of both",
                                     draft_.edge_name(edge), name_of(pair.second), point[0], point[1], point[2]));
    }
  }

  Draft& draft_;
  const std::vector<std::pair<int, int>>& crossings_;
  std::vector<Triangle> triangles_;
  std::vector<Box> boxes_;
  std::vector<Segment> segments_;
  std::set<int> crossing_edges_;
  std::map<std::pair<int, int>, Found> found_;
};

}  // namespace

void find_crossing_facets(Draft& draft, const std::vector<std::pair<int, int>>& crossings) {
  FacetCrossings(draft, crossings).report();
}

}  // namespace confidel::building
