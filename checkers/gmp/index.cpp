// SPDX-License-Identifier: Apache-2.0
#include "index.h"

#include <algorithm>
#include <numeric>
#include <thread>

namespace {
constexpr std::size_t leafSize = 4;
constexpr std::size_t worthAThread = 50000;
}

void Reach::setOuter(const Sphere& sphere, double relativePower, bool wanted) {
    const double radius2 = sphere.boundsFit() ? static_cast<double>(sphere.radius2) : mpz_get_d(sphere.longRadius2);
    outer = wanted ? radius2 * (1 + relativePower) * (1 + 1e-12) : -1;
}

namespace {
std::vector<std::uint32_t> allPoints(const Certificate& certificate) {
    std::vector<std::uint32_t> points(certificate.pointCount());
    std::iota(points.begin(), points.end(), std::uint32_t{0});
    return points;
}
}  // namespace

Index::Index(const Certificate& certificate, unsigned threads) : Index(certificate, allPoints(certificate), threads) {}

Index::Index(const Certificate& certificate, const std::vector<std::uint32_t>& points, unsigned threads) {
    for (const std::uint32_t p : points) {
        const auto& grid = certificate.points.grid(p);
        items_.push_back({{grid[0], grid[1], grid[2]}, p, certificate.pointPlane[p]});
    }
    if (!items_.empty()) nodes_ = build(0, items_.size(), threads);
}

std::vector<Index::Node> Index::build(std::size_t first, std::size_t last, unsigned threads) {
    Node node{};
    node.plane = items_[first].plane;
    for (int i = 0; i < 3; ++i) node.low[i] = node.high[i] = items_[first].low[i];
    for (std::size_t k = first; k < last; ++k) {
        for (int i = 0; i < 3; ++i) {
            node.low[i] = std::min(node.low[i], items_[k].low[i]);
            node.high[i] = std::max(node.high[i], items_[k].low[i] + 1);
        }
        if (items_[k].plane != node.plane) node.plane = none;
    }
    if (last - first <= leafSize) {
        node.first = static_cast<std::uint32_t>(first);
        node.count = static_cast<std::uint32_t>(last - first);
        return {node};
    }
    int axis = 0;
    for (int i = 1; i < 3; ++i)
        if (node.high[i] - node.low[i] > node.high[axis] - node.low[axis]) axis = i;
    const std::size_t middle = first + (last - first) / 2;
    std::nth_element(items_.begin() + static_cast<std::ptrdiff_t>(first), items_.begin() + static_cast<std::ptrdiff_t>(middle),
                     items_.begin() + static_cast<std::ptrdiff_t>(last), [axis](const Item& a, const Item& b) {
                         return a.low[axis] != b.low[axis] ? a.low[axis] < b.low[axis] : a.point < b.point;
                     });
    std::vector<Node> left, right;
    if (threads > 1 && last - first > worthAThread) {
        std::thread other([&] { right = build(middle, last, threads / 2); });
        left = build(first, middle, threads - threads / 2);
        other.join();
    } else {
        left = build(first, middle, 1);
        right = build(middle, last, 1);
    }
    node.second = static_cast<std::uint32_t>(left.size() + 1);
    std::vector<Node> all;
    all.reserve(1 + left.size() + right.size());
    all.push_back(node);
    all.insert(all.end(), left.begin(), left.end());
    all.insert(all.end(), right.begin(), right.end());
    return all;
}
