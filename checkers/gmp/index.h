// SPDX-License-Identifier: Apache-2.0
// A kd-tree over the conservative integer boxes of the points. A point or a whole node is passed over only when
// integer arithmetic, or the float filter, proves it outside the sphere; all that is left is tested exactly by the caller.
// Boxes are kept as doubles, which hold integers below 2^53 exactly.
#pragma once

#include "cluster.h"
#include "rules.h"

// Up to four boxes of integers.
struct Boxes {
    static constexpr std::uint32_t most = 4;
    double low[3][most], high[3][most];
};

// How far a box is from a sphere.
enum class Zone { near, far, beyond };  // perhaps in or on it; outside it; of no interest at all

// `outer` only serves the search for the smallest relative power, so it may be rounded.
struct Reach {
    explicit Reach(double radius2) : radius2(radius2) {}
    void setOuter(double relativePower, bool wanted) { outer = wanted ? radius2 * (1 + relativePower) * (1 + 1e-12) : -1; }
    double radius2, outer = -1;
};

// zones(boxes, count, zone, key): of each box; key is the square of a lower bound on its distance from the centre.
struct FloatReach : Reach {
    explicit FloatReach(const FloatBall& ball) : Reach(ball.radius2), centre{ball.centre[0], ball.centre[1], ball.centre[2]} {}
    // (6): a box with a key above radius2 has no point in or on the ball.
    void zones(const Boxes& boxes, std::uint32_t count, Zone* zone, double* key) const {
        typedef double Two __attribute__((vector_size(16)));
        for (std::uint32_t first = 0; first < Boxes::most; first += 2) {
            Two sum{};
            for (int i = 0; i < 3; ++i) {
                const Two below = Two{boxes.low[i][first], boxes.low[i][first + 1]} - centre[i];
                const Two above = centre[i] - Two{boxes.high[i][first], boxes.high[i][first + 1]};
                const Two gap = below > above ? below : above, positive = gap > Two{} ? gap : Two{};
                sum += positive * positive;
            }
            key[first] = sum[0];
            key[first + 1] = sum[1];
        }
        for (std::uint32_t i = 0; i < count; ++i) zone[i] = key[i] <= radius2 ? Zone::near : key[i] <= outer ? Zone::far : Zone::beyond;
    }
    double centre[3];
};

struct ShortReach : Reach {
    explicit ShortReach(const Sphere& sphere) : Reach(static_cast<double>(sphere.radius2)), inner(sphere.radius2) {
        for (int i = 0; i < 3; ++i) {
            low[i] = sphere.centre[i];
            high[i] = sphere.centre[i] + 2;
        }
    }
    void zones(const Boxes& boxes, std::uint32_t count, Zone* zone, double* key) const {
        for (std::uint32_t box = 0; box < count; ++box) {
            Wide sum = 0;
            for (int i = 0; i < 3; ++i) {
                std::int64_t gap = static_cast<std::int64_t>(boxes.low[i][box]) - high[i];
                if (gap < 0) gap = low[i] - static_cast<std::int64_t>(boxes.high[i][box]);
                if (gap > 0) sum += static_cast<Wide>(gap) * gap;
            }
            key[box] = static_cast<double>(sum);
            zone[box] = sum <= inner ? Zone::near : key[box] <= outer ? Zone::far : Zone::beyond;
        }
    }
    std::int64_t low[3], high[3];
    Wide inner;
};

struct LongReach : Reach {
    explicit LongReach(const Sphere& sphere) : Reach(mpz_get_d(sphere.longRadius2)), sphere(sphere) {}
    void zones(const Boxes& boxes, std::uint32_t count, Zone* zone, double* key) {
        for (std::uint32_t box = 0; box < count; ++box) {
            mpz_set_ui(sum, 0);
            for (int i = 0; i < 3; ++i) {
                mpz_set_d(gap, boxes.low[i][box]);
                mpz_sub(gap, gap, sphere.longCentre[i]);
                mpz_sub_ui(gap, gap, 2);
                if (sign(gap) < 0) {
                    mpz_set_d(gap, boxes.high[i][box]);
                    mpz_sub(gap, sphere.longCentre[i], gap);
                }
                if (sign(gap) > 0) mpz_addmul(sum, gap, gap);
            }
            key[box] = mpz_get_d(sum);
            zone[box] = mpz_cmp(sum, sphere.longRadius2) <= 0 ? Zone::near : key[box] <= outer ? Zone::far : Zone::beyond;
        }
    }
    const Sphere& sphere;
    Integer sum, gap;
};

class Index {
public:
    Index(const Certificate& certificate, const std::vector<std::uint32_t>& points, unsigned threads);

    // Calls visitor.near(point) and visitor.far(point), the latter not for most of the points whose only plane is `plane`.
    template <class SomeReach, class Visitor>
    void search(Sphere& sphere, SomeReach& reach, std::uint32_t plane, Visitor& visitor) const;

    // Points that are near each other have ranks that are near each other, mostly.
    const std::vector<std::uint32_t>& ranks() const { return ranks_; }

private:
    struct Item {
        double low[3];
        std::uint32_t point, plane;
    };
    struct Node {
        Boxes boxes;
        std::uint32_t child[Boxes::most];  // a point, or `inner` and the distance to the child's node
        std::uint32_t plane[Boxes::most];  // the plane of all points below, if it is one and their only one; else none
        std::uint32_t count;
        std::uint32_t cluster;  // none, or of which cluster the only box is; child[0] is the first of its items and child[1] the one behind the last
    };
    static constexpr std::uint32_t inner = 1u << 31;  // no point has such a number
    void build(std::size_t first, std::size_t last, unsigned threads, std::vector<Node>& nodes);
    void enclose(std::size_t first, std::size_t last, double (&low)[3], double (&high)[3]) const;
    void split(std::size_t first, std::size_t middle, std::size_t last);
    static void addChild(Node& node, std::uint32_t child, const Node& below);

    std::vector<Item> items_;
    std::vector<Node> nodes_;
    std::vector<Cluster> clusters_;
    std::vector<std::uint32_t> ranks_;
};

// All points of the certificate.
const Index& indexOfAll(Check&);
// The cells that are asked for; those that are near each other follow each other, mostly, so that searches find what they need in the cache.
std::vector<std::uint32_t> cellsInOrder(Check&);

// Searches what is in, on or near a sphere: visitor.begin(reach), then as above.
template <class Visitor>
void searchSphere(const Index& index, Sphere& sphere, std::uint32_t plane, Visitor& visitor) {
    const auto search = [&](auto&& reach) {
        visitor.begin(reach);
        index.search(sphere, reach, plane, visitor);
    };
    if (const FloatBall* ball = sphere.floatBall()) return search(FloatReach(*ball));
    sphere.computeBounds();
    if (sphere.boundsFit()) search(ShortReach(sphere));
    else search(LongReach(sphere));
}

template <class SomeReach, class Visitor>
void Index::search(Sphere& sphere, SomeReach& reach, std::uint32_t plane, Visitor& visitor) const {
    struct Waiting {
        const Node* node;
        Zone zone;
        double key;
    };
    Waiting stack[80];  // at most three per level, and one more; there are fewer than 2^32 points
    int depth = 0;
    if (!nodes_.empty()) stack[depth++] = {nodes_.data(), Zone::near, 0};
    while (depth > 0) {
        const Waiting entry = stack[--depth];
        if (entry.zone == Zone::far && entry.key > reach.outer) continue;
        const Node& node = *entry.node;
        Zone zone[Boxes::most];
        double key[Boxes::most];
        reach.zones(node.boxes, node.count, zone, key);
        if (node.cluster != none) {
            if (zone[0] != Zone::beyond) clusters_[node.cluster].search(sphere, [&reach] { return reach.outer / reach.radius2; }, visitor);
            continue;
        }
        const int before = depth;
        for (std::uint32_t i = 0; i < node.count; ++i) {
            if (zone[i] == Zone::beyond || (zone[i] == Zone::far && node.plane[i] != none && node.plane[i] == plane)) continue;
            if ((node.child[i] & inner) == 0) {
                if (zone[i] == Zone::near) visitor.near(node.child[i]);
                else visitor.far(node.child[i]);
                continue;
            }
            // The nearest one is looked at first.
            int place = depth++;
            for (; place > before && stack[place - 1].key < key[i]; --place) stack[place] = stack[place - 1];
            stack[place] = {&node + (node.child[i] - inner), zone[i], key[i]};
        }
    }
}
