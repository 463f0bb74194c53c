// SPDX-License-Identifier: GPL-3.0-or-later
// A hierarchy of axis-parallel boxes for nearest searches. Boxes contain what they stand for (outward rounding), and
// a search never skips a box that could hold something nearer than its limit: all rounding errors count against
// skipping.
#pragma once

#include <algorithm>
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

/// A square that any squared distance below the limit is certainly smaller than, in spite of rounding and underflow.
double squared_above(double limit);

/// A box and the ball around it, whose radius is rounded up.
struct Volume {
  explicit Volume(const Box& contents);

  Box box;
  Vector centre;
  double radius;
};

/// What a search starts from: everything in a box, or a segment in its box. Pre: coordinates have magnitude <= 1; the
/// true segment has a distance of at most 1e-15 from the given ends'.
class Probe {
 public:
  explicit Probe(const Box& box) : box_(box) {}
  Probe(const Box& box, const Vector& from, const Vector& to);

  /// To be compared with squared_above(limit).
  double squared_distance(const Volume& volume) const {
    double squared = 0;
    for (int k = 0; k < 3; ++k) {
      const double gap = std::max({0.0, volume.box.lower[k] - box_.upper[k], box_.lower[k] - volume.box.upper[k]});
      squared += gap * gap;
    }
    return squared;
  }

  /// A slanted segment fills little of its box: where the box is too near, its distance to the ball says more.
  bool passes_by(const Volume& volume, double limit) const {
    if (!is_segment_) return false;
    Vector gap;
    double projection = 0;
    for (int k = 0; k < 3; ++k) {
      gap[k] = volume.centre[k] - from_[k];
      projection += along_[k] * gap[k];
    }
    const double parameter = std::clamp(projection * inverse_squared_length_, 0.0, 1.0);
    double squared = 0;
    for (int k = 0; k < 3; ++k) {
      const double rest = gap[k] - parameter * along_[k];
      squared += rest * rest;
    }
    // An inaccurate parameter makes the distance too long by less than 1e-14, like all other rounding here.
    const double reach = limit + volume.radius + 1e-13;
    return squared > reach * reach;
  }

 private:
  Box box_;
  bool is_segment_ = false;
  Vector from_{};
  Vector along_{};
  double inverse_squared_length_ = 0;
};

/// Up to three labels of an item, -1 for none; a node has those that all its items share.
using Labels = std::array<int, 3>;

class BoundingVolumes {
 public:
  /// labels: none, or one entry per box.
  explicit BoundingVolumes(const std::vector<Box>& boxes, const std::vector<Labels>& labels = {});

  /// Calls visit(item, limit) for every item whose labels are not excluded(labels) and whose box may be nearer to the
  /// probe than the limit; visit returns the limit from then on (not above the one that it got). Order of visits:
  /// deterministic, roughly near ones first. Returns the last limit.
  template <class Excluded, class Visit>
  double search(const Probe& probe, double limit, Excluded excluded, Visit visit) const {
    if (nodes_.empty()) return limit;
    double squared_limit = squared_above(limit);
    std::array<Pending, 128> stack;  // deeper than any tree of 2^31 items split at medians
    int size = 0;
    stack[size++] = {0, probe.squared_distance(nodes_[0].volume)};
    while (size > 0) {
      const Pending pending = stack[--size];
      const Node& node = nodes_[pending.node];
      if (pending.squared_distance >= squared_limit || excluded(node.labels) || probe.passes_by(node.volume, limit)) {
        continue;
      }
      if (node.count > 0) {
        for (int i = node.first; i < node.first + node.count; ++i) {
          if (probe.squared_distance(volumes_[i]) >= squared_limit || excluded(labels_[i]) ||
              probe.passes_by(volumes_[i], limit)) {
            continue;
          }
          const double nearer = visit(items_[i], limit);
          if (nearer < limit) {
            limit = nearer;
            squared_limit = squared_above(limit);
          }
        }
        continue;
      }
      Pending near{pending.node + 1, probe.squared_distance(nodes_[pending.node + 1].volume)};
      Pending far{node.first, probe.squared_distance(nodes_[node.first].volume)};
      if (far.squared_distance < near.squared_distance) std::swap(near, far);
      stack[size++] = far;
      stack[size++] = near;
    }
    return limit;
  }

 private:
  /// A leaf has count > 0 items from first; an inner node has its left child after it and its right child at first.
  struct Node {
    Volume volume;
    Labels labels;
    int first = 0;
    int count = 0;
  };
  struct Pending {
    int node;
    double squared_distance;
  };

  void build(const std::vector<Box>& boxes, const std::vector<Labels>& labels, int begin, int end);

  std::vector<Node> nodes_;
  /// In the order of the leaves.
  std::vector<int> items_;
  std::vector<Volume> volumes_;
  std::vector<Labels> labels_;
};

}  // namespace confidel
