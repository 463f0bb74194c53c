// SPDX-License-Identifier: GPL-3.0-or-later
// The regions of the facets, and what others have in them.
#include <fmt/format.h>

#include <set>

#include "core/complex/broad_phase.h"
#include "core/complex/draft.h"

namespace confidel::building {

namespace {

Region triangle_region(const FacetDraft& facet) {
  Region region;
  const auto& [a, b, c] = facet.corners;
  region.boundary = {{a, b}, {b, c}, {c, a}};
  std::sort(region.boundary.begin(), region.boundary.end());
  region.triangles = {facet.corners};
  region.encloses = true;
  return region;
}

Region region_of(const Draft& draft, const FacetDraft& facet, const std::vector<std::array<double, 3>>& holes,
                 bool hull_if_open) {
  if (facet.is_triangle && facet.edges.size() == 3 && facet.guest_edges.empty() && facet.guest_points.empty())
    return triangle_region(facet);
  std::vector<Point> seeds;
  for (const auto& [x, y, z] : holes) seeds.push_back(Point::from_doubles(x, y, z).scaled(-draft.scale));
  return enclosed_region({draft.vertices, draft.positions, facet.normal, facet.edges, facet.guest_edges, facet.points,
                          facet.guest_points, seeds, holes, hull_if_open});
}

std::string seed_name(const Draft& draft, const std::array<double, 3>& seed) {
  if (draft.input.dimension == 2) return fmt::format("hole point ({}, {})", seed[0], seed[1]);
  return fmt::format("hole point ({}, {}, {})", seed[0], seed[1], seed[2]);
}

/// Appends what is wrong with a region by itself.
void judge(Draft& draft, FacetDraft& facet, const std::vector<std::array<double, 3>>& holes) {
  const Region& region = facet.region;
  const int line = facet.source < 0 ? 0 : draft.input.facets[facet.source].line;
  const std::string name = draft.facet_name(facet.source);
  if (!region.encloses) {
    facet.sound = false;
    if (facet.has_loop)
      draft.add_problem("E-DEGENERATE-FACET", line,
                        fmt::format("the loops of {} enclose no area; remove or correct it", name));
    else
      draft.add_problem("E-OPEN-LOOP", line,
                        fmt::format("the segments of {} close no loop: it has no area; close it", name));
    return;
  }
  for (std::size_t i = 0; i < holes.size(); ++i) {
    if (region.seeds[i] == Region::Seed::on_edge)
      draft.add_problem(
          "E-HOLE", line,
          fmt::format("the {} of {} lies exactly on an edge or a vertex: it is unclear what it removes; move it into "
                      "the hole",
                      seed_name(draft, holes[i]), name));
    if (region.seeds[i] == Region::Seed::outside)
      draft.add_remark(
          fmt::format("the {} of {} lies outside of it: it removes nothing", seed_name(draft, holes[i]), name));
  }
  if (region.triangles.empty()) {
    facet.sound = false;
    draft.add_problem("E-HOLE", line,
                      fmt::format("the hole points of {} remove all of it; close the holes with loops", name));
  }
}

std::vector<VertexId> vertices_of(const Region& region) {
  std::vector<VertexId> vertices = region.isolated;
  for (const auto* edges : {&region.boundary, &region.constraints})
    for (const auto& edge : *edges) vertices.insert(vertices.end(), edge.begin(), edge.end());
  sort_unique(vertices);
  return vertices;
}

/// Vertices that lie in a facet without being one of its vertices.
void find_guest_points(Draft& draft, const std::vector<std::vector<VertexId>>& facet_vertices) {
  std::vector<Box> vertex_boxes, triangle_boxes;
  std::vector<std::pair<int, const std::array<VertexId, 3>*>> triangles;
  for (const auto& position : draft.positions) vertex_boxes.push_back({position, position});
  for (std::size_t f = 0; f < draft.facets.size(); ++f)
    for (const auto& triangle : draft.facets[f].region.triangles) {
      triangles.emplace_back(static_cast<int>(f), &triangle);
      triangle_boxes.push_back(bounding_box(draft.positions, triangle));
    }
  for_each_meeting_pair(vertex_boxes, triangle_boxes, [&](int vertex, int index) {
    const auto& [f, triangle] = triangles[index];
    const auto& [a, b, c] = *triangle;
    if (vertex == a || vertex == b || vertex == c) return;
    const auto& points = draft.vertices;
    if (orientation(points[a], points[b], points[c], points[vertex]) != 0) return;
    FacetDraft& facet = draft.facets[f];
    const Projection projection = projection_of(facet.normal);
    const auto inside = [&](VertexId from, VertexId to) {
      return planar_orientation(projection, points[from], points[to], points[vertex]) >= 0;
    };
    if (!inside(a, b) || !inside(b, c) || !inside(c, a)) return;
    if (!std::binary_search(facet_vertices[f].begin(), facet_vertices[f].end(), vertex))
      facet.guest_points.push_back(vertex);
  });
  for (FacetDraft& facet : draft.facets) sort_unique(facet.guest_points);
}

/// Edges of others between two vertices of a facet: they lie in its plane, in the region or outside of it.
void find_guest_edges(Draft& draft, const std::vector<std::vector<VertexId>>& facet_vertices,
                      const std::set<int>& crossing) {
  std::vector<std::vector<int>> facets_at(draft.vertices.size());
  for (std::size_t f = 0; f < draft.facets.size(); ++f) {
    for (const VertexId vertex : facet_vertices[f]) facets_at[vertex].push_back(static_cast<int>(f));
    for (const VertexId vertex : draft.facets[f].guest_points) facets_at[vertex].push_back(static_cast<int>(f));
  }
  for (std::size_t index = 0; index < draft.edges.size(); ++index) {
    if (crossing.count(static_cast<int>(index)) != 0) continue;
    const Segment edge = draft.edges[index].ends;
    const auto* fewer = &facets_at[edge[0]];
    const auto* more = &facets_at[edge[1]];
    if (fewer->size() > more->size()) std::swap(fewer, more);
    for (const int f : *fewer) {
      if (!std::binary_search(more->begin(), more->end(), f)) continue;
      FacetDraft& facet = draft.facets[f];
      if (!std::binary_search(facet.edges.begin(), facet.edges.end(), edge)) facet.guest_edges.push_back(edge);
    }
  }
  for (FacetDraft& facet : draft.facets) sort_unique(facet.guest_edges);
}

void remark_on_guests(Draft& draft, const FacetDraft& facet) {
  for (const VertexId vertex : facet.guest_points)
    draft.add_remark(fmt::format("{} lies in {}, which does not list it: it becomes a vertex of that facet",
                                 draft.vertex_name(vertex), draft.facet_name(facet.source)));
  for (const Segment& edge : facet.region.constraints) {
    if (!std::binary_search(facet.guest_edges.begin(), facet.guest_edges.end(), edge)) continue;
    const auto record = std::lower_bound(draft.edges.begin(), draft.edges.end(), edge,
                                         [](const EdgeRecord& a, const Segment& b) { return a.ends < b; });
    draft.add_remark(fmt::format("{} lies in {}, which does not list it: it becomes an inner constraint of that facet",
                                 draft.edge_name(*record), draft.facet_name(facet.source)));
  }
}

/// What a facet lists outside of its region is no part of it, but stays in the complex.
void release_outside(Draft& draft, const FacetDraft& facet) {
  for (const Segment& edge : facet.region.outside_edges) {
    draft.segments.push_back({edge, -1, 0});
    draft.add_remark(
        fmt::format("edge {}-{} of {} lies outside of the region that the facet bounds: it is no part of the facet",
                    draft.origin[edge[0]] + draft.input.first_index, draft.origin[edge[1]] + draft.input.first_index,
                    draft.facet_name(facet.source)));
  }
  for (const VertexId vertex : facet.region.outside_points)
    draft.add_remark(fmt::format("{} is listed by {}, but lies outside of its region", draft.vertex_name(vertex),
                                 draft.facet_name(facet.source)));
}

}  // namespace

void resolve_regions(Draft& draft, const std::vector<std::pair<int, int>>& crossings) {
  std::vector<std::vector<VertexId>> facet_vertices(draft.facets.size());
  for (std::size_t f = 0; f < draft.facets.size(); ++f) {
    FacetDraft& facet = draft.facets[f];
    if (!facet.sound) continue;
    const auto& holes = draft.input.facets[facet.source].holes;
    facet.region = region_of(draft, facet, holes, false);
    judge(draft, facet, holes);
    facet_vertices[f] = vertices_of(facet.region);
  }
  std::set<int> crossing;
  for (const auto& [first, second] : crossings) crossing.insert({first, second});
  find_guest_points(draft, facet_vertices);
  find_guest_edges(draft, facet_vertices, crossing);
  for (FacetDraft& facet : draft.facets) {
    if (!facet.sound) continue;
    if (!facet.guest_points.empty() || !facet.guest_edges.empty()) {
      facet.region = region_of(draft, facet, draft.input.facets[facet.source].holes, false);
      remark_on_guests(draft, facet);
    }
    release_outside(draft, facet);
  }
}

void draft_domain(Draft& draft) {
  FacetDraft domain;
  domain.source = -1;
  domain.normal = {0, 0, 1};
  domain.has_loop = true;
  for (const SegmentDraft& segment : draft.segments) domain.edges.push_back(segment.ends);
  sort_unique(domain.edges);
  for (VertexId vertex = 0; vertex < static_cast<VertexId>(draft.vertices.size()); ++vertex)
    domain.points.push_back(vertex);
  domain.region = region_of(draft, domain, draft.input.holes, true);
  const Region& region = domain.region;
  if (!region.encloses) {
    draft.add_remark("all vertices lie on one line: there is no domain, segments are hanging");
    return;
  }
  judge(draft, domain, draft.input.holes);
  for (const Segment& edge : region.hull_edges) draft.segments.push_back({edge, -1, 0});
  draft.report.artificial_segments = static_cast<int>(region.hull_edges.size());
  if (!region.hull_edges.empty())
    draft.add_remark(fmt::format(
        "the segments enclose nothing but holes: the domain is the convex hull, {} artificial segments close it",
        region.hull_edges.size()));
  if (!region.outside_edges.empty())
    draft.add_remark(
        fmt::format("{} segments lie outside of the domain: they are hanging", region.outside_edges.size()));
  if (!region.outside_points.empty())
    draft.add_remark(fmt::format("{} vertices lie outside of the domain", region.outside_points.size()));
  draft.facets.push_back(std::move(domain));
}

}  // namespace confidel::building
