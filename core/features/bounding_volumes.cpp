// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/features/bounding_volumes.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace confidel {

namespace {

constexpr int leaf_size = 4;
/// Below this, squares of gaps may have lost digits to underflow: such boxes are always near.
constexpr double tiny_square = 1e-290;
constexpr Labels no_labels{-1, -1, -1};

Labels shared(Labels a, const Labels& b) {
  for (int& label : a) {
    if (std::find(b.begin(), b.end(), label) == b.end()) label = -1;
  }
  return a;
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

Volume::Volume(const Box& contents) : box(contents) {
  double squared = 0;
  for (int k = 0; k < 3; ++k) {
    centre[k] = 0.5 * (box.lower[k] + box.upper[k]);
    const double half = box.upper[k] - centre[k];
    squared += half * half;
  }
  radius = std::sqrt(squared) * (1 + 0x1p-48);
}

Probe::Probe(const Box& box, const Vector& from, const Vector& to) : box_(box), from_(from) {
  double squared_length = 0;
  for (int k = 0; k < 3; ++k) {
    along_[k] = to[k] - from[k];
    squared_length += along_[k] * along_[k];
  }
  // A shorter segment fills its box well enough.
  if (!(squared_length > 1e-24)) return;
  is_segment_ = true;
  inverse_squared_length_ = 1 / squared_length;
}

BoundingVolumes::BoundingVolumes(const std::vector<Box>& boxes, const std::vector<Labels>& labels)
    : items_(boxes.size()) {
  std::iota(items_.begin(), items_.end(), 0);
  if (boxes.empty()) return;
  nodes_.reserve(boxes.size());
  build(boxes, labels, 0, static_cast<int>(boxes.size()));
  volumes_.reserve(boxes.size());
  for (const int item : items_) volumes_.emplace_back(boxes[item]);
  labels_.assign(boxes.size(), no_labels);
  for (std::size_t i = 0; i < labels.size(); ++i) labels_[i] = labels[items_[i]];
}

void BoundingVolumes::build(const std::vector<Box>& boxes, const std::vector<Labels>& labels, int begin, int end) {
  const auto centre = [&](int item, int axis) { return boxes[item].lower[axis] + boxes[item].upper[axis]; };
  const int index = static_cast<int>(nodes_.size());
  Box whole;
  Box centres;
  Labels common = labels.empty() ? no_labels : labels[items_[begin]];
  for (int i = begin; i < end; ++i) {
    whole.extend(boxes[items_[i]]);
    if (!labels.empty()) common = shared(common, labels[items_[i]]);
    Box point;
    for (int k = 0; k < 3; ++k) point.lower[k] = point.upper[k] = centre(items_[i], k);
    centres.extend(point);
  }
  nodes_.push_back({Volume(whole), common, begin, end - begin});
  if (end - begin <= leaf_size) return;
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
  build(boxes, labels, begin, middle);
  nodes_[index].first = static_cast<int>(nodes_.size());
  nodes_[index].count = 0;
  build(boxes, labels, middle, end);
}

}  // namespace confidel
