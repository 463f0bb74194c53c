// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/features/bounding_volumes.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace confidel {

namespace {

constexpr int leaf_size = 4;
/// Below this, squares of gaps may have lost digits to underflow: such boxes are always visited.
constexpr double tiny_square = 1e-290;

/// Distance between a segment and a point, with an error below 1e-14 if all coordinates have magnitude <= 1.
double segment_point_distance(const std::array<Vector, 2>& ends, const Vector& point) {
  Vector along;
  Vector gap;
  double squared_length = 0;
  double projection = 0;
  for (int k = 0; k < 3; ++k) {
    along[k] = ends[1][k] - ends[0][k];
    gap[k] = point[k] - ends[0][k];
    squared_length += along[k] * along[k];
    projection += along[k] * gap[k];
  }
  // Whatever parameter comes out, the distance to that point of the segment is at most 1e-15 * length too long.
  const double parameter = squared_length > 0 ? std::clamp(projection / squared_length, 0.0, 1.0) : 0.0;
  double squared = 0;
  for (int k = 0; k < 3; ++k) {
    const double rest = gap[k] - parameter * along[k];
    squared += rest * rest;
  }
  return std::sqrt(squared);
}

}  // namespace

void Box::extend(const Box& other) {
  for (int k = 0; k < 3; ++k) {
    lower[k] = std::min(lower[k], other.lower[k]);
    upper[k] = std::max(upper[k], other.upper[k]);
  }
}

double squared_above(double limit) {
  // 32 units in the last place: more than a gap (1), its square (1), two sums (2) and this square (1) can lose.
  return std::max(limit * limit * (1 + 0x1p-48), tiny_square);
}

double squared_distance_below(const Probe& probe, const Box& box, double squared_limit) {
  double squared = 0;
  for (int k = 0; k < 3; ++k) {
    const double gap = std::max({0.0, box.lower[k] - probe.box.upper[k], probe.box.lower[k] - box.upper[k]});
    squared += gap * gap;
  }
  if (!probe.is_segment || squared >= squared_limit) return squared;
  // A slanted segment fills little of its box. Its distance to the ball around the other box says more, up to an
  // absolute error.
  Vector centre;
  double squared_radius = 0;
  for (int k = 0; k < 3; ++k) {
    centre[k] = 0.5 * (box.lower[k] + box.upper[k]);
    const double half = 0.5 * (box.upper[k] - box.lower[k]);
    squared_radius += half * half;
  }
  const double distance = segment_point_distance(probe.ends, centre) - std::sqrt(squared_radius) - 1e-13;
  return distance > 0 ? std::max(squared, distance * distance) : squared;
}

BoundingVolumes::BoundingVolumes(const std::vector<Box>& boxes) : items_(boxes.size()) {
  std::iota(items_.begin(), items_.end(), 0);
  if (boxes.empty()) return;
  nodes_.reserve(boxes.size());
  build(boxes, 0, static_cast<int>(boxes.size()));
  boxes_.reserve(boxes.size());
  for (const int item : items_) boxes_.push_back(boxes[item]);
}

void BoundingVolumes::build(const std::vector<Box>& boxes, int begin, int end) {
  const auto centre = [&](int item, int axis) { return boxes[item].lower[axis] + boxes[item].upper[axis]; };
  const int index = static_cast<int>(nodes_.size());
  nodes_.emplace_back();
  Box whole;
  Box centres;
  for (int i = begin; i < end; ++i) {
    whole.extend(boxes[items_[i]]);
    Box point;
    for (int k = 0; k < 3; ++k) point.lower[k] = point.upper[k] = centre(items_[i], k);
    centres.extend(point);
  }
  nodes_[index].box = whole;
  if (end - begin <= leaf_size) {
    nodes_[index].first = begin;
    nodes_[index].count = end - begin;
    return;
  }
  int axis = 0;
  for (int k = 1; k < 3; ++k) {
    if (centres.upper[k] - centres.lower[k] > centres.upper[axis] - centres.lower[axis]) axis = k;
  }
  const int middle = begin + (end - begin) / 2;
  // Ties by index: the order must not depend on the library's nth_element alone.
  std::nth_element(items_.begin() + begin, items_.begin() + middle, items_.begin() + end, [&](int a, int b) {
    const double x = centre(a, axis);
    const double y = centre(b, axis);
    return x != y ? x < y : a < b;
  });
  build(boxes, begin, middle);
  nodes_[index].first = static_cast<int>(nodes_.size());
  build(boxes, middle, end);
}

}  // namespace confidel
