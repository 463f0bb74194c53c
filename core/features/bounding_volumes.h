// SPDX-License-Identifier: GPL-3.0-or-later
// A hierarchy of axis-parallel boxes for nearest searches. Boxes contain what they stand for (outward rounding), and
// a search never skips a box that could hold something nearer than its limit: all rounding errors count against
// skipping.
#pragma once

#include <array>
#include <limits>
#include <utility>
#include <vector>

namespace confidel {

/// Doubles in three dimensions: what filters compute with.
using Vector = std::array<double, 3>;

struct Box {
  Vector lower{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity(),
               std::numeric_limits<double>::infinity()};
  Vector upper{-std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity(),
               -std::numeric_limits<double>::infinity()};

  void extend(const Box& other);
};

/// What a search starts from: everything in a box, or a segment with that box. The segment's ends are doubles; the
/// true segment may be off by 1e-15.
struct Probe {
  Box box;
  bool is_segment = false;
  std::array<Vector, 2> ends{};
};

/// A square that any squared distance below the limit is certainly smaller than, in spite of rounding and underflow.
double squared_above(double limit);

/// A lower bound of the squared distance between the probe and a box, to be compared with squared_above only.
/// Pre: coordinates have magnitude <= 1.
double squared_distance_below(const Probe& probe, const Box& box, double squared_limit);

class BoundingVolumes {
 public:
  explicit BoundingVolumes(const std::vector<Box>& boxes);

  /// Calls visit(item, limit) for every item whose box may be nearer to the probe than the limit; visit returns
  /// the limit from then on (not above the one that it got). Order of visits: deterministic, roughly near ones first.
  /// Returns the last limit.
  template <class Visit>
  double search(const Probe& probe, double limit, Visit visit) const {
    if (nodes_.empty()) return limit;
    double squared_limit = squared_above(limit);
    std::array<Pending, 128> stack;  // deeper than any tree of 2^31 items split at medians
    int size = 0;
    stack[size++] = {0, squared_distance_below(probe, nodes_[0].box, squared_limit)};
    while (size > 0) {
      const Pending pending = stack[--size];
      if (pending.squared_distance >= squared_limit) continue;
      const Node& node = nodes_[pending.node];
      if (node.count > 0) {
        for (int i = node.first; i < node.first + node.count; ++i) {
          if (squared_distance_below(probe, boxes_[i], squared_limit) >= squared_limit) continue;
          const double nearer = visit(items_[i], limit);
          if (nearer < limit) {
            limit = nearer;
            squared_limit = squared_above(limit);
          }
        }
        continue;
      }
      Pending left{pending.node + 1, squared_distance_below(probe, nodes_[pending.node + 1].box, squared_limit)};
      Pending right{node.first, squared_distance_below(probe, nodes_[node.first].box, squared_limit)};
      if (left.squared_distance <= right.squared_distance) std::swap(left, right);
      stack[size++] = left;
      stack[size++] = right;
    }
    return limit;
  }

 private:
  /// A leaf has count > 0 items from first; an inner node has its left child after it and its right child at first.
  struct Node {
    Box box;
    int first = 0;
    int count = 0;
  };
  struct Pending {
    int node;
    double squared_distance;
  };

  void build(const std::vector<Box>& boxes, int begin, int end);

  std::vector<Node> nodes_;
  /// In the order of the leaves.
  std::vector<int> items_;
  std::vector<Box> boxes_;
};

}  // namespace confidel
