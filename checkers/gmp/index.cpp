// SPDX-License-Identifier: Apache-2.0
#include "index.h"

#include "group.h"

#include <algorithm>
#include <numeric>
#include <thread>

namespace {
constexpr std::size_t worthAThread = 50000;
constexpr double coarse = 8;  // units of the grid: what the filter cannot tell apart, nor the bounds of a sphere
}

namespace {
std::vector<std::uint32_t> allPoints(const Certificate& certificate) {
    std::vector<std::uint32_t> points(certificate.pointCount());
    std::iota(points.begin(), points.end(), std::uint32_t{0});
    return points;
}
}  // namespace

const Index& indexOfAll(Check& check) {
    if (!check.index) check.index = std::make_shared<Index>(check.certificate, allPoints(check.certificate), check.threads);
    return *check.index;
}

std::vector<std::uint32_t> cellsInOrder(Check& check) {
    const std::vector<std::uint32_t>& ranks = indexOfAll(check).ranks();
    std::vector<std::uint32_t> cells(check.endCell - check.firstCell);
    std::iota(cells.begin(), cells.end(), static_cast<std::uint32_t>(check.firstCell));
    groupByKey(cells, ranks.size(), [&](std::uint32_t t) { return ranks[check.certificate.cells[t].corner[0]]; });
    return cells;
}

Index::Index(const Certificate& certificate, const std::vector<std::uint32_t>& points, unsigned threads) {
    for (const std::uint32_t p : points) {
        const auto& grid = certificate.points.grid(p);
        items_.push_back({{static_cast<double>(grid[0]), static_cast<double>(grid[1]), static_cast<double>(grid[2])}, p, certificate.pointPlane[p]});
    }
    if (!items_.empty()) build(0, items_.size(), threads, nodes_);
    for (Node& node : nodes_) {
        if (node.cluster == none) continue;
        std::vector<std::uint32_t> members;
        for (std::size_t k = node.child[0]; k < node.child[1]; ++k) members.push_back(items_[k].point);
        node.cluster = static_cast<std::uint32_t>(clusters_.size());
        clusters_.emplace_back(certificate.points, std::move(members));
    }
    ranks_.assign(certificate.pointCount(), none);
    for (std::uint32_t i = 0; i < items_.size(); ++i) ranks_[items_[i].point] = i;
}

// The box of all, as if it were one item's.
void Index::enclose(std::size_t first, std::size_t last, double (&low)[3], double (&high)[3]) const {
    for (int i = 0; i < 3; ++i) low[i] = high[i] = items_[first].low[i];
    for (std::size_t k = first; k < last; ++k)
        for (int i = 0; i < 3; ++i) {
            low[i] = std::min(low[i], items_[k].low[i]);
            high[i] = std::max(high[i], items_[k].low[i]);
        }
}

// Smaller ones to the left of `middle`, along the axis of the largest extent.
void Index::split(std::size_t first, std::size_t middle, std::size_t last) {
    double low[3], high[3];
    enclose(first, last, low, high);
    int axis = 0;
    for (int i = 1; i < 3; ++i)
        if (high[i] - low[i] > high[axis] - low[axis]) axis = i;
    const auto at = [this](std::size_t i) { return items_.begin() + static_cast<std::ptrdiff_t>(i); };
    std::nth_element(at(first), at(middle), at(last), [axis](const Item& a, const Item& b) {
        return a.low[axis] != b.low[axis] ? a.low[axis] < b.low[axis] : a.point < b.point;
    });
}

// The box and the plane of one more child, from its own children.
void Index::addChild(Node& node, std::uint32_t child, const Node& below) {
    const std::uint32_t lane = node.count++;
    node.child[lane] = child;
    node.plane[lane] = below.plane[0];
    for (int i = 0; i < 3; ++i) {
        node.boxes.low[i][lane] = *std::min_element(below.boxes.low[i], below.boxes.low[i] + below.count);
        node.boxes.high[i][lane] = *std::max_element(below.boxes.high[i], below.boxes.high[i] + below.count);
    }
    for (std::uint32_t k = 0; k < below.count; ++k)
        if (below.plane[k] != node.plane[lane]) node.plane[lane] = none;
}

// Appends the node of these items, and then all nodes below it.
void Index::build(std::size_t first, std::size_t last, unsigned threads, std::vector<Node>& nodes) {
    const std::size_t number = nodes.size(), count = last - first;
    nodes.push_back(Node{});
    nodes.back().cluster = none;
    if (count >= Cluster::fewest) {
        double low[3], high[3];
        enclose(first, last, low, high);
        if (high[0] - low[0] < coarse && high[1] - low[1] < coarse && high[2] - low[2] < coarse) {
            Node& node = nodes.back();
            for (int i = 0; i < 3; ++i) {
                node.boxes.low[i][0] = low[i];
                node.boxes.high[i][0] = high[i] + 1;
            }
            node.count = 1;
            node.plane[0] = none;
            node.cluster = 0;
            node.child[0] = static_cast<std::uint32_t>(first);
            node.child[1] = static_cast<std::uint32_t>(last);
            return;
        }
    }
    if (count <= Boxes::most) {
        Node& node = nodes.back();
        for (std::size_t k = first; k < last; ++k) {
            const Item& item = items_[k];
            for (int i = 0; i < 3; ++i) {
                node.boxes.low[i][node.count] = item.low[i];
                node.boxes.high[i][node.count] = item.low[i] + 1;
            }
            node.child[node.count] = item.point;
            node.plane[node.count++] = item.plane;
        }
        return;
    }
    // Halves of halves; all leaves are full, but for the last one.
    const auto half = [](std::size_t from, std::size_t to) {
        return std::min(to, from + (to - from + 2 * Boxes::most - 1) / (2 * Boxes::most) * Boxes::most);
    };
    std::size_t bound[5] = {first, 0, half(first, last), 0, last};
    split(first, bound[2], last);
    for (const int k : {1, 3}) {
        bound[k] = half(bound[k - 1], bound[k + 1]);
        if (bound[k] < bound[k + 1]) split(bound[k - 1], bound[k], bound[k + 1]);
    }
    const auto buildPart = [&](int k, unsigned own, std::vector<Node>& target) {
        if (bound[k] < bound[k + 1]) build(bound[k], bound[k + 1], own, target);
    };
    std::vector<Node> part[4];
    const bool parallel = threads > 1 && count > worthAThread;
    std::thread other;
    if (parallel)
        other = std::thread([&] {
            for (const int k : {2, 3}) buildPart(k, threads / 2, part[k]);
        });
    for (const int k : {0, 1, 2, 3}) {
        if (k == 2 && parallel) other.join();
        const std::size_t child = nodes.size();
        if (k < 2 || !parallel) buildPart(k, parallel ? threads - threads / 2 : 1, nodes);
        else nodes.insert(nodes.end(), part[k].begin(), part[k].end());
        if (child < nodes.size()) addChild(nodes[number], inner + static_cast<std::uint32_t>(child - number), Node(nodes[child]));
    }
}
