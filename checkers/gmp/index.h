// SPDX-License-Identifier: Apache-2.0
// A kd-tree over the conservative integer boxes of the points. A point or a whole node is passed over only when
// integer arithmetic proves it outside the sphere; all that is left is tested exactly by the caller.
#pragma once

#include "sphere.h"

// How far a box is from a sphere.
enum class Zone { near, far, beyond };  // perhaps in or on it; outside it; of no interest at all

// `outer` only serves the search for the smallest relative power, so it may be rounded.
struct Reach {
    double outer = -1;
    void setOuter(const Sphere& sphere, double relativePower, bool wanted);
};

struct ShortReach : Reach {
    explicit ShortReach(const Sphere& sphere) : inner(sphere.radius2) {
        for (int i = 0; i < 3; ++i) {
            low[i] = sphere.centre[i];
            high[i] = sphere.centre[i] + 2;
        }
    }
    // The box is [boxLow, boxHigh]; key is the square of a lower bound on its distance from the centre.
    Zone zone(const std::int64_t* boxLow, const std::int64_t* boxHigh, double& key) const {
        Wide sum = 0;
        for (int i = 0; i < 3; ++i) {
            std::int64_t gap = boxLow[i] - high[i];
            if (gap < 0) gap = low[i] - boxHigh[i];
            if (gap > 0) sum += static_cast<Wide>(gap) * gap;
        }
        key = static_cast<double>(sum);
        if (sum <= inner) return Zone::near;
        return key <= outer ? Zone::far : Zone::beyond;
    }
    std::int64_t low[3], high[3];
    Wide inner;
};

struct LongReach : Reach {
    explicit LongReach(const Sphere& sphere) : sphere(sphere) {}
    Zone zone(const std::int64_t* boxLow, const std::int64_t* boxHigh, double& key) {
        mpz_set_ui(sum, 0);
        for (int i = 0; i < 3; ++i) {
            mpz_set_si(gap, boxLow[i]);
            mpz_sub(gap, gap, sphere.longCentre[i]);
            mpz_sub_ui(gap, gap, 2);
            if (sign(gap) < 0) {
                mpz_set_si(gap, boxHigh[i]);
                mpz_sub(gap, sphere.longCentre[i], gap);
            }
            if (sign(gap) > 0) mpz_addmul(sum, gap, gap);
        }
        key = mpz_get_d(sum);
        if (mpz_cmp(sum, sphere.longRadius2) <= 0) return Zone::near;
        return key <= outer ? Zone::far : Zone::beyond;
    }
    const Sphere& sphere;
    Integer sum, gap;
};

// Calls search(reach) with the sphere's reach, in machine words where its bounds fit.
template <class Search>
void withReach(const Sphere& sphere, const Search& search) {
    if (sphere.boundsFit()) {
        ShortReach reach(sphere);
        search(reach);
    } else {
        LongReach reach(sphere);
        search(reach);
    }
}

class Index {
public:
    Index(const Certificate& certificate, unsigned threads);  // of all points
    Index(const Certificate& certificate, const std::vector<std::uint32_t>& points, unsigned threads);

    // Calls visitor.near(point) and visitor.far(point), the latter not for points whose only plane is `plane`.
    template <class SomeReach, class Visitor>
    void search(SomeReach& reach, std::uint32_t plane, Visitor& visitor) const;

private:
    struct Item {
        std::int64_t low[3];
        std::uint32_t point, plane;
    };
    struct Node {
        std::int64_t low[3], high[3];
        std::uint32_t second;        // distance to the second child, the first one follows; 0: a leaf
        std::uint32_t first, count;  // items of a leaf
        std::uint32_t plane;         // the plane of all points below, if it is one and their only one; else none
    };
    std::vector<Node> build(std::size_t first, std::size_t last, unsigned threads);

    std::vector<Item> items_;
    std::vector<Node> nodes_;
};

template <class SomeReach, class Visitor>
void Index::search(SomeReach& reach, std::uint32_t plane, Visitor& visitor) const {
    struct Waiting {
        const Node* node;
        Zone zone;
        double key;
    };
    Waiting stack[80];  // at most one per level and one more; there are fewer than 2^32 points
    int depth = 0;
    const auto ofInterest = [plane](Zone zone, std::uint32_t nodePlane) {
        return zone == Zone::near || (zone == Zone::far && (nodePlane == none || nodePlane != plane));
    };
    const auto look = [&](const Node* node) {
        Waiting entry{node, Zone::near, 0};
        entry.zone = reach.zone(node->low, node->high, entry.key);
        return entry;
    };
    if (nodes_.empty()) return;
    stack[depth++] = look(nodes_.data());
    while (depth > 0) {
        const Waiting entry = stack[--depth];
        const Node* node = entry.node;
        if (!ofInterest(entry.zone, node->plane) || (entry.zone == Zone::far && entry.key > reach.outer)) continue;
        if (node->second != 0) {
            const Waiting one = look(node + 1), two = look(node + node->second);
            const bool oneFirst = one.key <= two.key;
            const Waiting& later = oneFirst ? two : one;
            const Waiting& sooner = oneFirst ? one : two;
            if (ofInterest(later.zone, later.node->plane)) stack[depth++] = later;
            if (ofInterest(sooner.zone, sooner.node->plane)) stack[depth++] = sooner;
            continue;
        }
        for (std::uint32_t i = node->first; i < node->first + node->count; ++i) {
            const Item& item = items_[i];
            const std::int64_t high[3] = {item.low[0] + 1, item.low[1] + 1, item.low[2] + 1};
            double key = 0;
            const Zone zone = reach.zone(item.low, high, key);
            if (zone == Zone::near) visitor.near(item.point);
            else if (ofInterest(zone, item.plane)) visitor.far(item.point);
        }
    }
}
