// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/complex/build.h"

#include <cmath>
#include <map>

#include "core/complex/draft.h"
#include "core/complex/merge.h"

namespace confidel {

namespace {

using namespace building;

void throw_if_any(Draft& draft) {
  if (draft.problems.empty()) return;
  std::stable_sort(draft.problems.begin(), draft.problems.end(),
                   [](const Problem& a, const Problem& b) { return a.place.line < b.place.line; });
  throw InputError(std::move(draft.problems));
}

double squared_distance(const Point& a, const Point& b) {
  double sum = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const double step = (a.high(axis) - b.high(axis)) + (a.low(axis) - b.low(axis));
    sum += step * step;
  }
  return sum;
}

double squared_area(const Point& a, const Point& b, const Point& c) {
  std::array<double, 3> u{}, v{};
  for (int axis = 0; axis < 3; ++axis) {
    u[axis] = (b.high(axis) - a.high(axis)) + (b.low(axis) - a.low(axis));
    v[axis] = (c.high(axis) - a.high(axis)) + (c.low(axis) - a.low(axis));
  }
  const double x = u[1] * v[2] - u[2] * v[1], y = u[2] * v[0] - u[0] * v[2], z = u[0] * v[1] - u[1] * v[0];
  return x * x + y * y + z * z;
}

/// Three vertices that span the plane well: the first boundary vertex, the farthest vertex from it, and the one that
/// makes the largest triangle with them. Doubles choose (the same on every machine), exact predicates decide. It
/// depends on the region's vertices only, so the canonical text does not depend on how ties were triangulated.
std::array<VertexId, 3> choose_frame(const std::vector<Point>& points, const FacetDraft& facet) {
  const Region& region = facet.region;
  std::vector<VertexId> vertices = region.isolated;
  for (const auto* edges : {&region.boundary, &region.constraints})
    for (const auto& edge : *edges) vertices.insert(vertices.end(), edge.begin(), edge.end());
  sort_unique(vertices);

  const VertexId first = region.boundary.front()[0];
  VertexId second = region.boundary.front()[1];
  for (const VertexId vertex : vertices)
    if (squared_distance(points[first], points[vertex]) > squared_distance(points[first], points[second]))
      second = vertex;
  VertexId third = -1;
  double greatest = -1;
  for (const VertexId vertex : vertices) {
    const double area = squared_area(points[first], points[second], points[vertex]);
    if (area > greatest && !collinear(points[first], points[second], points[vertex])) greatest = area, third = vertex;
  }
  std::array<VertexId, 3> frame{first, second, third};
  const Projection projection = projection_of(facet.normal);
  if (planar_orientation(projection, points[first], points[second], points[third]) < 0) std::swap(frame[1], frame[2]);
  std::rotate(frame.begin(), std::min_element(frame.begin(), frame.end()), frame.end());
  return frame;
}

Facet finished_facet(const Draft& draft, FacetDraft& source) {
  Facet facet;
  facet.frame = choose_frame(draft.vertices, source);
  facet.boundary = std::move(source.region.boundary);
  facet.constraints = std::move(source.region.constraints);
  facet.isolated = std::move(source.region.isolated);
  facet.triangles = std::move(source.region.triangles);
  facet.normal = std::move(source.normal);
  if (source.source >= 0) {
    facet.marker = draft.input.facets[source.source].marker;
    facet.line = draft.input.facets[source.source].line;
  }
  return facet;
}

void collect_segments(const Draft& draft, Complex& complex) {
  std::map<Segment, int> markers;  // what the input says last about a segment, unless it says nothing
  for (const SegmentDraft& segment : draft.segments) {
    int& marker = markers[segment.ends];
    if (segment.marker != 0) marker = segment.marker;
  }
  for (const Facet& facet : complex.facets) {
    for (const auto& [a, b] : facet.boundary) markers.try_emplace(make_segment(a, b), 0);
    for (const auto& [a, b] : facet.constraints) markers.try_emplace(make_segment(a, b), 0);
  }
  complex.segments.reserve(markers.size());
  complex.segment_markers.reserve(markers.size());
  for (const auto& [segment, marker] : markers) {
    complex.segments.push_back(segment);
    complex.segment_markers.push_back(marker);
  }
}

}  // namespace

BuiltComplex build_complex(const Input& input, const BuildOptions& options) {
  Draft draft(input);
  draft_vertices(draft, options);
  draft_segments(draft);
  if (input.dimension == 3) {
    if (input.facets.empty() && input.segments.empty())
      draft.add_problem("E-EMPTY", 0, "the file has neither facets nor segments: there is nothing to conform to");
    draft_facets(draft);
  }
  split_edges(draft);
  const auto crossings = find_crossing_edges(draft);
  if (input.dimension == 3) {
    resolve_regions(draft, crossings);
    find_crossing_facets(draft, crossings);
  } else if (crossings.empty()) {
    draft_domain(draft);
  }
  throw_if_any(draft);

  BuiltComplex built;
  built.complex.dimension = input.dimension;
  built.complex.scale = draft.scale;
  for (FacetDraft& facet : draft.facets) built.complex.facets.push_back(finished_facet(draft, facet));
  collect_segments(draft, built.complex);
  built.complex.vertices = std::move(draft.vertices);
  built.report = std::move(draft.report);
  built.report.input_index = std::move(draft.origin);
  using Merging = BuildOptions::Merging;
  if (options.merge_coplanar == Merging::on || (options.merge_coplanar == Merging::automatic && input.triangle_soup)) {
    std::vector<Segment> stated;
    for (const SegmentDraft& segment : draft.segments) stated.push_back(segment.ends);
    sort_unique(stated);
    const MergeSummary merged = merge_coplanar_facets(built.complex, stated);
    if (merged.segments_removed > 0)
      built.report.remarks.push_back(std::to_string(merged.facets_before) + " facets are " + std::to_string(merged.facets_after) +
                                     " after merging exactly coplanar neighbours; " + std::to_string(merged.segments_removed) +
                                     " segments between them are no constraints (--merge-coplanar off keeps them)");
  }
  return built;
}

}  // namespace confidel
