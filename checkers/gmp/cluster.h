// SPDX-License-Identifier: Apache-2.0
// A kd-tree of exact boxes over points that the grid of Points hardly tells apart: a detail far smaller than the extent of all points.
#pragma once

#include "sphere.h"

class Cluster {
public:
    static constexpr std::uint32_t fewest = 32;  // below, testing each point is cheaper

    Cluster(const Points& points, std::vector<std::uint32_t> members);

    // Calls visitor.near(point) for all in or on the sphere, visitor.far(point) for others unless the square of their distance, relative to that of
    // the radius, is proved to be above limit(); negative: there are no others.
    template <class Limit, class Visitor>
    void search(Sphere& sphere, const Limit& limit, Visitor& visitor) const {
        search(0, sphere, limit, visitor);
    }

private:
    struct Node {
        ExactBox box;
        std::uint32_t first, last, second;  // second: of two children, the first one follows its parent; 0: a leaf of members
    };
    void build(const Points& points, std::uint32_t first, std::uint32_t last, int axis);

    template <class Limit, class Visitor>
    void search(std::uint32_t number, Sphere& sphere, const Limit& limit, Visitor& visitor) const {
        const Node& node = nodes_[number];
        const bool near = sphere.mayMeet(node.box);
        if (!near && sphere.relativeGap() > limit()) return;
        if (node.second != 0) {
            search(number + 1, sphere, limit, visitor);
            search(node.second, sphere, limit, visitor);
            return;
        }
        for (std::uint32_t i = node.first; i < node.last; ++i) {
            if (near) visitor.near(members_[i]);
            else visitor.far(members_[i]);
        }
    }

    std::vector<std::uint32_t> members_;
    std::vector<Node> nodes_;
};
