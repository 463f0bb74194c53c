// SPDX-License-Identifier: Apache-2.0
#include "cluster.h"

#include <algorithm>

Cluster::Cluster(const Points& points, std::vector<std::uint32_t> members) : members_(std::move(members)) {
    build(points, 0, static_cast<std::uint32_t>(members_.size()), 0);
}

void Cluster::build(const Points& points, std::uint32_t first, std::uint32_t last, int axis) {
    const auto begin = members_.begin() + first, end = members_.begin() + last;
    const auto before = [&points](int i) {
        return [&points, i](std::uint32_t p, std::uint32_t q) {
            const int order = points.compare(p, q, i);
            return order != 0 ? order < 0 : p < q;
        };
    };
    const std::size_t number = nodes_.size();
    Node node{{}, first, last, 0};
    for (int i = 0; i < 3; ++i) {
        const auto [low, high] = std::minmax_element(begin, end, before(i));
        node.box.low[i] = *low;
        node.box.high[i] = *high;
    }
    nodes_.push_back(node);
    if (last - first <= 4) return;
    const std::uint32_t middle = first + (last - first) / 2;
    std::nth_element(begin, members_.begin() + middle, end, before(axis));
    build(points, first, middle, (axis + 1) % 3);
    nodes_[number].second = static_cast<std::uint32_t>(nodes_.size());
    build(points, middle, last, (axis + 1) % 3);
}
