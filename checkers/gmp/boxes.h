// SPDX-License-Identifier: Apache-2.0
// A tree over boxes on the conservative grid of Points: finds everything that may be near a given box.
#pragma once

#include "frame.h"
#include "sphere.h"

#include <limits>

struct GridBox {
    std::int64_t low[3], high[3];
    std::uint32_t id;
    void add(const Points& points, std::uint32_t p) {
        for (std::size_t i = 0; i < 3; ++i) {
            low[i] = std::min(low[i], points.grid(p)[i]);
            high[i] = std::max(high[i], points.grid(p)[i] + 1);
        }
    }
    Wide gap2(const GridBox& other) const {  // a lower bound on the square of the distance
        Wide sum = 0;
        for (int i = 0; i < 3; ++i) {
            const std::int64_t gap = std::max(other.low[i] - high[i], low[i] - other.high[i]);
            if (gap > 0) sum += static_cast<Wide>(gap) * gap;
        }
        return sum;
    }
};
GridBox boxOf(const Points& points, std::initializer_list<std::uint32_t> of, std::uint32_t id);

// At least the given square of a length, on the grid. (No two points are farther apart than 2^52.)
constexpr Wide unboundedGap = Wide{1} << 120;
Wide gridSquare(const Points& points, const Rational& square);
// The same for a rounded factor, with some room.
Wide scaledGap(Wide gap, double factor);

class BoxTree {
public:
    explicit BoxTree(std::vector<GridBox> boxes);

    // Calls visitor.visit(id) for every box that may be within visitor.bound(), the near ones first.
    template <class Visitor>
    void search(const GridBox& query, Visitor& visitor) const {
        struct Waiting {
            std::size_t node;
            Wide gap;
        };
        if (nodes_.empty()) return;
        Waiting stack[80];
        int depth = 0;
        stack[depth++] = {0, nodes_[0].box.gap2(query)};
        while (depth > 0) {
            const Waiting entry = stack[--depth];
            if (entry.gap > visitor.bound()) continue;
            const Node& node = nodes_[entry.node];
            if (node.second != 0) {
                const Waiting one{entry.node + 1, nodes_[entry.node + 1].box.gap2(query)};
                const Waiting two{node.second, nodes_[node.second].box.gap2(query)};
                stack[depth++] = one.gap <= two.gap ? two : one;
                stack[depth++] = one.gap <= two.gap ? one : two;
                continue;
            }
            for (std::uint32_t i = node.first; i < node.first + node.count; ++i)
                if (items_[i].gap2(query) <= visitor.bound()) visitor.visit(items_[i].id);
        }
    }

private:
    struct Node {
        GridBox box;
        std::size_t second;  // 0: a leaf; the first child follows its parent
        std::uint32_t first, count;
    };
    void build(std::size_t first, std::size_t last);

    std::vector<GridBox> items_;
    std::vector<Node> nodes_;
};
