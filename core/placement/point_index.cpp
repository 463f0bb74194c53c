// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/placement/point_index.h"

#include <algorithm>
#include <utility>

namespace confidel {
namespace {
constexpr int bucket_size = 8;
constexpr int greatest_depth = 80;

// The lowest (sign -1) or highest (1) coordinates.
PointIndex::Position corner(const std::vector<Point>& points, int sign) {
  PointIndex::Position extreme;
  extreme.fill(-sign * 1e300);
  for (const Point& p : points)
    for (int axis = 0; axis < 3; ++axis) extreme[axis] = sign * std::max(sign * extreme[axis], sign * p.approximate(axis));
  return extreme;
}
}  // namespace

PointIndex::PointIndex(const Position& low, const Position& high) {
  half_ = 0x1p-900;
  for (int axis = 0; axis < 3; ++axis) {
    centre_[axis] = low[axis] / 2 + high[axis] / 2;
    half_ = std::max(half_, (high[axis] - low[axis]) * 0.5 * (1 + 0x1p-30));
  }
  nodes_.emplace_back();
}

PointIndex::PointIndex(const std::vector<Point>& points) : PointIndex(corner(points, -1), corner(points, 1)) {}

void PointIndex::add(int node, int id, const Position& position) {
  const int entry = nodes_[node].count % Block::size;
  if (entry == 0) {
    int block = unused_;
    if (block >= 0) {
      unused_ = blocks_[block].next;
    } else {
      block = static_cast<int>(blocks_.size());
      blocks_.emplace_back();
    }
    blocks_[block].next = nodes_[node].block;
    nodes_[node].block = block;
  }
  Block& block = blocks_[nodes_[node].block];
  block.positions[entry] = position;
  block.ids[entry] = id;
  ++nodes_[node].count;
}

void PointIndex::insert(int id, const Position& position) {
  // A point outside the root's box would be missed by pruning: grow the box. Its octant lists stay valid only in an empty tree,
  // so the tree is rebuilt; callers give a box, and this does not happen.
  const auto outside = [&] {
    for (int axis = 0; axis < 3; ++axis)
      if (std::abs(position[axis] - centre_[axis]) > half_) return true;
    return false;
  };
  while (outside()) {
    half_ *= 2;
    const std::vector<Node> nodes = std::exchange(nodes_, std::vector<Node>(1));
    const std::vector<Block> blocks = std::exchange(blocks_, {});
    size_ = 0;
    unused_ = -1;
    for (const Node& leaf : nodes) {
      int filled = in_newest_block(leaf);
      for (int b = leaf.block; b >= 0; b = blocks[b].next, filled = Block::size)
        for (int entry = 0; entry < filled; ++entry) insert(blocks[b].ids[entry], blocks[b].positions[entry]);
    }
  }

  int node = 0;
  Position middle = centre_;
  double half = half_;
  int depth = 0;
  const auto descend = [&](int& from, Position& at, double& size, const Position& target) {
    const int k = octant(at, target);
    size /= 2;
    for (int axis = 0; axis < 3; ++axis) at[axis] += (k >> axis) & 1 ? size : -size;
    from = nodes_[from].child + k;
  };
  while (nodes_[node].child >= 0) {
    descend(node, middle, half, position);
    ++depth;
  }
  add(node, id, position);
  ++size_;
  while (nodes_[node].count > bucket_size && depth < greatest_depth) {
    const int child = static_cast<int>(nodes_.size());
    nodes_.resize(nodes_.size() + 8);
    int filled = in_newest_block(nodes_[node]);
    for (int b = nodes_[node].block; b >= 0; filled = Block::size) {
      const Block block = blocks_[b];
      blocks_[b].next = unused_;
      unused_ = b;
      for (int entry = filled - 1; entry >= 0; --entry)
        add(child + octant(middle, block.positions[entry]), block.ids[entry], block.positions[entry]);
      b = block.next;
    }
    nodes_[node].child = child;
    nodes_[node].block = -1;
    nodes_[node].count = 0;
    descend(node, middle, half, position);
    ++depth;
  }
}

}  // namespace confidel
