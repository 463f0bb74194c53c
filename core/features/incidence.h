// SPDX-License-Identifier: GPL-3.0-or-later
// Which segments, facets and triangles of the simplicial complex K meet at a vertex or segment.
#pragma once

#include <span>

#include "core/complex/complex.h"

namespace confidel {

/// Lists of items by owner, one after the other. Items are ordered as they were added.
template <class Item>
class Lists {
 public:
  Lists() = default;
  Lists(std::size_t owners, const std::vector<std::pair<int, Item>>& pairs) : begin_(owners + 1), items_(pairs.size()) {
    for (const auto& pair : pairs) ++begin_[pair.first + 1];
    for (std::size_t owner = 0; owner < owners; ++owner) begin_[owner + 1] += begin_[owner];
    auto next = begin_;
    for (const auto& pair : pairs) items_[next[pair.first]++] = pair.second;
  }
  std::span<const Item> operator[](int owner) const {
    return std::span(items_).subspan(begin_[owner], begin_[owner + 1] - begin_[owner]);
  }

 private:
  std::vector<std::size_t> begin_;
  std::vector<Item> items_;
};

/// A triangle of K.
struct Triangle {
  FacetId facet;
  std::array<VertexId, 3> vertices;
};

struct Incidence {
  explicit Incidence(const Complex& complex);

  bool facet_has_vertex(FacetId facet, VertexId vertex) const;
  bool facet_has_segment(FacetId facet, SegmentId segment) const;

  std::vector<Triangle> triangles;
  /// By vertex.
  Lists<SegmentId> segments_at;
  Lists<int> triangles_at;
  /// By vertex, increasing and without repetition.
  Lists<FacetId> facets_at;
  /// By segment: facets that contain it as a boundary edge or constraint, increasing.
  Lists<FacetId> facets_of;
  /// By segment: the third corners of its triangles in those facets, one per sheet.
  Lists<VertexId> sheets_of;
};

}  // namespace confidel
