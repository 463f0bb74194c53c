// SPDX-License-Identifier: GPL-3.0-or-later
// A growing spatial index over points: an octree with buckets over approximate positions.
#pragma once

#include <array>
#include <cmath>
#include <vector>

#include "core/numbers/point.h"

namespace confidel {

/// Insert-only. Query results are a superset of the exact ones as long as the caller inflates its ball by the error of its centre:
/// positions are nearest doubles, and every box test is closed.
class PointIndex {
 public:
  using Position = std::array<double, 3>;

  /// A box that contains every point that will be inserted (others are accepted, but make queries slow).
  PointIndex(const Position& low, const Position& high);
  /// Empty, with a box that contains these points.
  explicit PointIndex(const std::vector<Point>& points);

  void insert(int id, const Position& position);
  bool empty() const { return size_ == 0; }
  std::size_t size() const { return size_; }

  /// Calls visit(id) for each point in the closed ball, and possibly for some just outside, until it returns true.
  /// Returns whether it did. The order is deterministic.
  template <class Visit>
  bool visit_ball(const Position& centre, double radius, Visit&& visit) const {
    if (empty()) return false;
    // One part in 2^40 covers the roundings of the tests below.
    const double reach = radius * (1 + 0x1p-40) + 0x1p-1000;
    return visit_node(0, centre_, half_, centre, reach, reach * reach * (1 + 0x1p-40), visit);
  }

 private:
  struct Node {
    int child = -1;  ///< index of the first of eight children, or -1: a leaf
    int block = -1;  ///< a leaf's newest block, the only one that may be partly filled
    int count = 0;   ///< entries of a leaf
  };
  // Entries of a leaf lie side by side: a query's cost is the memory that it touches.
  struct Block {
    static constexpr int size = 4;
    std::array<Position, size> positions;
    std::array<int, size> ids;
    int next = -1;
  };

  template <class Visit>
  bool visit_node(int index, const Position& middle, double half, const Position& centre, double reach, double square,
                  Visit& visit) const {
    double distance = 0;
    for (int axis = 0; axis < 3; ++axis) {
      const double gap = std::abs(centre[axis] - middle[axis]) - half * (1 + 0x1p-40);
      if (gap > reach) return false;
      if (gap > 0) distance += gap * gap;
    }
    if (distance > square) return false;
    const Node& node = nodes_[index];
    if (node.child < 0) {
      int filled = in_newest_block(node);
      for (int b = node.block; b >= 0; b = blocks_[b].next, filled = Block::size) {
        const Block& block = blocks_[b];
        for (int entry = filled - 1; entry >= 0; --entry) {
          const Position& p = block.positions[entry];
          const double x = p[0] - centre[0], y = p[1] - centre[1], z = p[2] - centre[2];
          if (x * x + y * y + z * z <= square && visit(block.ids[entry])) return true;
        }
      }
      return false;
    }
    const double quarter = half / 2;
    // Octants that the ball's box does not reach need no visit: a bit per axis and side.
    int beyond[2] = {0, 0};
    for (int axis = 0; axis < 3; ++axis) {
      const double gap = middle[axis] - centre[axis];
      if (-gap > reach) beyond[0] |= 1 << axis;
      if (gap > reach) beyond[1] |= 1 << axis;
    }
    for (int k = 0; k < 8; ++k) {
      if ((k & beyond[1]) != 0 || (~k & beyond[0]) != 0) continue;
      if (nodes_[node.child + k].child < 0 && nodes_[node.child + k].block < 0) continue;
      const Position next{middle[0] + (k & 1 ? quarter : -quarter), middle[1] + (k & 2 ? quarter : -quarter),
                          middle[2] + (k & 4 ? quarter : -quarter)};
      if (visit_node(node.child + k, next, quarter, centre, reach, square, visit)) return true;
    }
    return false;
  }

  static int in_newest_block(const Node& leaf) { return (leaf.count - 1) % Block::size + 1; }

  static int octant(const Position& middle, const Position& position) {
    return (position[0] >= middle[0]) + 2 * (position[1] >= middle[1]) + 4 * (position[2] >= middle[2]);
  }

  Position centre_{};
  double half_ = 1;
  void add(int node, int id, const Position& position);

  std::size_t size_ = 0;
  std::vector<Node> nodes_;
  std::vector<Block> blocks_;
  int unused_ = -1;  ///< first of the blocks that a divided leaf gave back
};

}  // namespace confidel
