// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/complex/broad_phase.h"

#include <CGAL/Box_intersection_d/Box_d.h>
#include <CGAL/box_intersection_d.h>

namespace confidel::building {

namespace {

/// CGAL's box with the index of ours.
class IndexedBox : public CGAL::Box_intersection_d::Box_d<double, 3, CGAL::Box_intersection_d::ID_EXPLICIT> {
  using Base = CGAL::Box_intersection_d::Box_d<double, 3, CGAL::Box_intersection_d::ID_EXPLICIT>;

 public:
  IndexedBox(const Box& box, int index)
      : Base(CGAL::Bbox_3(box.low[0], box.low[1], box.low[2], box.high[0], box.high[1], box.high[2])), index_(index) {}
  int index() const { return index_; }

 private:
  int index_;
};

std::vector<IndexedBox> indexed(const std::vector<Box>& boxes) {
  std::vector<IndexedBox> result;
  result.reserve(boxes.size());
  for (const Box& box : boxes) result.emplace_back(box, static_cast<int>(result.size()));
  return result;
}

}  // namespace

void for_each_meeting_pair(const std::vector<Box>& boxes, const PairCallback& callback) {
  std::vector<IndexedBox> sorted = indexed(boxes);
  CGAL::box_self_intersection_d(sorted.begin(), sorted.end(),
                                [&](const IndexedBox& a, const IndexedBox& b) { callback(a.index(), b.index()); });
}

void for_each_meeting_pair(const std::vector<Box>& first, const std::vector<Box>& second,
                           const PairCallback& callback) {
  std::vector<IndexedBox> a = indexed(first);
  std::vector<IndexedBox> b = indexed(second);
  CGAL::box_intersection_d(a.begin(), a.end(), b.begin(), b.end(),
                           [&](const IndexedBox& x, const IndexedBox& y) { callback(x.index(), y.index()); });
}

}  // namespace confidel::building
