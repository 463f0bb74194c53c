// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/complex/draft.h"

#include <fmt/format.h>

#include <cmath>
#include <map>
#include <unordered_map>

namespace confidel::building {

void Draft::add_problem(const std::string& code, int line, const std::string& message) {
  Problem problem;
  problem.code = code;
  problem.place.file = input.file;
  problem.place.line = line;
  problem.message = message;
  problems.push_back(std::move(problem));
}

void Draft::add_vertex_problem(const std::string& code, int line, const std::string& message) {
  add_problem(code, line, message);
  if (!input.vertex_file.empty()) problems.back().place.file = input.vertex_file;
}

std::string Draft::line_name(int line) { return line > 0 ? fmt::format(" (line {})", line) : std::string(); }

std::string Draft::vertex_name(VertexId vertex) const {
  const int source = origin[vertex];
  return fmt::format("vertex {}{}", source + input.first_index, line_name(input.vertices[source].line));
}

std::string Draft::facet_name(int source) const {
  if (source < 0) return "the domain";
  return fmt::format("facet {}{}", source + input.first_index, line_name(input.facets[source].line));
}

std::string Draft::segment_name(int source) const {
  return fmt::format("segment {}{}", source + input.first_index, line_name(input.segments[source].line));
}

std::string Draft::edge_name(const EdgeRecord& edge) const {
  const int a = origin[edge.ends[0]] + input.first_index, b = origin[edge.ends[1]] + input.first_index;
  if (edge.facet >= 0) return fmt::format("edge {}-{} of {}", a, b, facet_name(edge.facet));
  if (edge.segment < 0) return fmt::format("edge {}-{}", a, b);
  return fmt::format("segment {} from {} to {}{}", edge.segment + input.first_index, a, b, line_name(edge.line));
}

namespace {

/// The smallest scale with all |coordinates| * 2^-scale <= 1.
int scale_of(const Input& input) {
  double greatest = 0;
  for (const InputVertex& vertex : input.vertices)
    for (const double coordinate : vertex.position) greatest = std::max(greatest, std::abs(coordinate));
  if (greatest == 0) return 0;
  int exponent = 0;
  const double fraction = std::frexp(greatest, &exponent);
  return fraction == 0.5 ? exponent - 1 : exponent;
}

bool is_finite(const InputVertex& vertex) {
  return std::all_of(vertex.position.begin(), vertex.position.end(), [](double x) { return std::isfinite(x); });
}

}  // namespace

void draft_vertices(Draft& draft, const BuildOptions& options) {
  const Input& input = draft.input;
  if (input.vertices.empty())
    draft.add_problem("E-EMPTY", 0, "the file has no vertices: there is nothing to conform to");
  for (std::size_t i = 0; i < input.vertices.size(); ++i)
    if (!is_finite(input.vertices[i]))
      draft.add_vertex_problem("E-NUMBER", input.vertices[i].line,
                        fmt::format("vertex {} has a coordinate that is not finite", i + input.first_index));
  if (!draft.problems.empty()) throw InputError(draft.problems);

  draft.scale = scale_of(input);
  std::unordered_map<Point, VertexId, PointHash> known;
  int merged = 0;
  for (std::size_t i = 0; i < input.vertices.size(); ++i) {
    const auto& [x, y, z] = input.vertices[i].position;
    Point point = Point::from_doubles(x, y, z).scaled(-draft.scale);
    const auto [found, is_new] = known.emplace(point, static_cast<VertexId>(draft.vertices.size()));
    draft.vertex_of.push_back(found->second);
    if (is_new) {
      draft.vertices.push_back(std::move(point));
      draft.positions.push_back(input.vertices[i].position);
      draft.origin.push_back(static_cast<int>(i));
    } else if (options.merge_identical_vertices) {
      ++merged;
    } else {
      draft.add_vertex_problem("E-DUPLICATE-VERTEX", input.vertices[i].line,
                        fmt::format("vertex {}{} and {} have the same position; keep one of them, or merge identical "
                                    "vertices explicitly",
                                    i + input.first_index, Draft::line_name(input.vertices[i].line),
                                    draft.vertex_name(found->second)));
    }
  }
  if (merged > 0)
    draft.add_remark(fmt::format("{} vertices with the position of an earlier one were merged with it", merged));
}

void draft_segments(Draft& draft) {
  const Input& input = draft.input;
  std::map<Segment, int> known;
  const int count = static_cast<int>(input.vertices.size());
  for (std::size_t i = 0; i < input.segments.size(); ++i) {
    const InputSegment& segment = input.segments[i];
    const int source = static_cast<int>(i);
    bool valid = true;
    for (const int end : segment.ends) {
      if (end >= 0 && end < count) continue;
      draft.add_problem("E-INDEX", segment.line,
                        fmt::format("segment {} has the end {}, which does not exist: vertices are numbered {} to {}",
                                    source + input.first_index, end + input.first_index, input.first_index,
                                    count - 1 + input.first_index));
      valid = false;
    }
    if (!valid) continue;
    const VertexId a = draft.vertex_of[segment.ends[0]], b = draft.vertex_of[segment.ends[1]];
    if (a != b) {
      draft.segments.push_back({make_segment(a, b), source, segment.marker});
      const auto [first, is_new] = known.emplace(make_segment(a, b), source);
      if (!is_new)
        draft.add_remark(
            fmt::format("{} is the same as {}", draft.segment_name(source), draft.segment_name(first->second)));
    } else {
      draft.add_remark(fmt::format("segment {}{} joins {} with itself: it is left out", source + input.first_index,
                                   Draft::line_name(segment.line), draft.vertex_name(a)));
    }
  }
}

}  // namespace confidel::building
