// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/placement/point_index.h"

#include <algorithm>

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
    std::vector<int> ids;
    std::vector<Position> positions;
    ids.swap(ids_);
    positions.swap(positions_);
    nodes_.assign(1, Node());
    next_.clear();
    for (std::size_t i = 0; i < ids.size(); ++i) insert(ids[i], positions[i]);
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
  const int entry = static_cast<int>(ids_.size());
  ids_.push_back(id);
  positions_.push_back(position);
  next_.push_back(nodes_[node].head);
  nodes_[node].head = entry;
  ++nodes_[node].count;
  while (nodes_[node].count > bucket_size && depth < greatest_depth) {
    const int child = static_cast<int>(nodes_.size());
    nodes_.resize(nodes_.size() + 8);
    for (int e = nodes_[node].head; e >= 0;) {
      const int following = next_[e];
      Node& target = nodes_[child + octant(middle, positions_[e])];
      next_[e] = target.head;
      target.head = e;
      ++target.count;
      e = following;
    }
    nodes_[node].child = child;
    nodes_[node].head = -1;
    nodes_[node].count = 0;
    descend(node, middle, half, position);
    ++depth;
  }
}

}  // namespace confidel
