// SPDX-License-Identifier: GPL-3.0-or-later
// The complex while it is being built: every step reads the draft, refines it, and appends the problems that it finds.
#pragma once

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "core/complex/build.h"
#include "core/complex/enclosed_region.h"

namespace confidel::building {

struct FacetDraft {
  int source = 0;  ///< index in Input::facets
  IntegerVector normal;
  /// One loop of three corners and nothing else: then the corners, on the normal's positive side counter-clockwise.
  bool is_triangle = false;
  std::array<VertexId, 3> corners{};
  std::vector<Segment> edges;          ///< what bounds the region: sorted, unique; atomic after split_edges
  std::vector<VertexId> points;        ///< vertices listed by themselves: sorted
  bool has_loop = false;               ///< a polygon with at least three corners
  std::vector<Segment> guest_edges;    ///< segments of others that lie in the region
  std::vector<VertexId> guest_points;  ///< vertices of others that lie in the region
  bool sound = true;                   ///< false: its edges cross each other, it cannot be triangulated
  Region region;
};

struct SegmentDraft {
  Segment ends{};
  int source = -1;  ///< index in Input::segments; -1 if made
  int marker = 0;
};

/// Where an edge comes from, for messages. Sorted by ends, one per edge.
struct EdgeRecord {
  Segment ends{};
  int facet = -1;    ///< index in Input::facets, or
  int segment = -1;  ///< index in Input::segments
  int line = 0;
};

struct Draft {
  explicit Draft(const Input& source) : input(source) {}

  const Input& input;
  int scale = 0;
  std::vector<Point> vertices;                   ///< distinct, working coordinates
  std::vector<std::array<double, 3>> positions;  ///< the same, as the input has them
  std::vector<int> origin;                       ///< first input index of each vertex
  std::vector<VertexId> vertex_of;               ///< vertex of each input index
  std::vector<FacetDraft> facets;
  std::vector<SegmentDraft> segments;
  std::vector<EdgeRecord> edges;
  std::vector<Problem> problems;
  BuildReport report;

  void add_problem(const std::string& code, int line, const std::string& message);
  /// The same for a line of the file that the vertices come from, which may be a companion .node.
  void add_vertex_problem(const std::string& code, int line, const std::string& message);
  void add_remark(const std::string& remark) { report.remarks.push_back(remark); }

  // Names for messages, in the file's own numbering, with lines where they are known.
  std::string vertex_name(VertexId vertex) const;
  std::string facet_name(int source) const;
  std::string segment_name(int source) const;
  std::string edge_name(const EdgeRecord& edge) const;
  /// "(line 12)" with a leading blank, or nothing.
  static std::string line_name(int line);
};

inline Segment make_segment(VertexId a, VertexId b) { return a < b ? Segment{a, b} : Segment{b, a}; }

template <typename Element>
void sort_unique(std::vector<Element>& elements) {
  std::sort(elements.begin(), elements.end());
  elements.erase(std::unique(elements.begin(), elements.end()), elements.end());
}

// The steps, in the order of build_complex.

/// Vertices in working coordinates; duplicates are problems unless they may be merged.
void draft_vertices(Draft& draft, const BuildOptions& options);
/// Segments, and facets with their planes: indices, degenerate facets, vertices off the plane. Faulty facets are left
/// out.
void draft_facets(Draft& draft);
void draft_segments(Draft& draft);
/// Splits edges at the vertices that lie on them, and fills Draft::edges.
void split_edges(Draft& draft);
/// Edges that cross edges: pairs of indices in Draft::edges. Facets whose own edges cross each other become unsound.
std::vector<std::pair<int, int>> find_crossing_edges(Draft& draft);
/// Regions of all sound facets; vertices and segments of others that lie in them are added to them.
void resolve_regions(Draft& draft, const std::vector<std::pair<int, int>>& crossings);
/// Facets that cross or overlap, and segments that pierce facets. Pre: resolve_regions.
void find_crossing_facets(Draft& draft, const std::vector<std::pair<int, int>>& crossings);
/// Dimension 2: the one facet.
void draft_domain(Draft& draft);

}  // namespace confidel::building
