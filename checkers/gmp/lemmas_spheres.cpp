// SPDX-License-Identifier: Apache-2.0
// L9, L10, L11, L13 and L16: no point of some sort lies in the smallest sphere of a cell, nor on it off the plane.
#include "lemmas.h"

namespace {

// What a cell's sphere is tested against: points of the index for which wanted(cell, point).
class SphereTest {
public:
    using Wanted = bool (*)(const Instance&, std::size_t, std::uint32_t);
    SphereTest(const Instance& instance, const Index& index, Wanted wanted, Findings& out)
        : i_(instance), index_(index), wanted_(wanted), out_(out), sphere_(instance.c, instance.check.floatNormals.get()) {}

    // The smallest point that is in the sphere, or on it off the plane; else none.
    std::uint32_t violating(std::size_t t) {
        cell_ = t;
        plane_ = i_.c.facetPlane[i_.c.cells[t].facet];
        violating_ = none;
        sphere_.setCell(i_.c.cells[t]);
        searchSphere(index_, sphere_, none, *this);
        return violating_;
    }
    void begin(Reach& reach) {
        reach_ = &reach;
        reach.setOuter(out_.best(), true);
    }
    void near(std::uint32_t x) {
        if (!wanted_(i_, cell_, x)) return;
        const int sign = sphere_.power(x);
        if (sign > 0) return candidate(x);
        if (sign < 0 || (i_.c.pointPlane[x] != plane_ && !sphere_.inPlane(i_.c.cells[cell_].facet))) violating_ = std::min(violating_, x);
    }
    void far(std::uint32_t x) {
        if (wanted_(i_, cell_, x) && sphere_.power(x) > 0) candidate(x);
    }

private:
    void candidate(std::uint32_t x) {
        out_.slack(sphere_.relativePower(), i_.cellLine(cell_), [&] { return objectName("cell", cell_, "point", x); });
        reach_->setOuter(out_.best(), true);
    }

    const Instance& i_;
    const Index& index_;
    const Wanted wanted_;
    Findings& out_;
    Sphere sphere_;
    Reach* reach_ = nullptr;
    std::size_t cell_ = 0;
    std::uint32_t plane_ = none, violating_ = none;
};

bool noCorner(const Instance& i, std::size_t t, std::uint32_t x) { return !isCorner(i.c.cells[t], x); }

void testSpheres(const Instance& i, Findings& out, char kind, const Index& index, SphereTest::Wanted wanted) {
    inParallel(i.endCell - i.firstCell, i.check.threads, 64, [&] {
        return [&, test = std::make_unique<SphereTest>(i, index, wanted, out)](std::size_t begin, std::size_t end) {
            for (std::size_t t = i.firstCell + begin; t < i.firstCell + end; ++t) {
                if (i.c.cells[t].kind != kind) continue;
                const std::uint32_t x = test->violating(t);
                if (x != none) out.failed(i.cellLine(t), objectName("cell", t, "point", x));
            }
        };
    });
}

}  // namespace

void testL9(const Instance& i, Findings& out) { testSpheres(i, out, 'T', indexOfAll(i.check), noCorner); }

void testL10(const Instance& i, Findings& out) {
    // A foot m is of kind projection, so its segment has the vertex v of its T cell as one of two ends; it may have a T cell at both.
    std::vector<std::uint8_t> ends(i.c.steiner.size(), 0);
    for (std::size_t t = 0; t < i.c.cells.size(); ++t) {
        if (i.c.cells[t].kind != 'T') continue;
        const std::uint32_t m = i.shapes->foot(t) - i.c.vertexCount;
        ends[m] |= i.c.segments[i.c.steiner[m].carrier].first == i.shapes->corner(t, 0) ? 1 : 2;
    }
    for (const int end : {1, 2}) {
        // Feet of T cells at the first end of their segment, then those at the second.
        std::vector<std::uint32_t> feet;
        for (std::uint32_t m = 0; m < ends.size(); ++m)
            if ((ends[m] & end) != 0) feet.push_back(i.c.vertexCount + m);
        const Index index(i.c, feet, i.check.threads);
        testSpheres(i, out, 'S', index, end == 1 ? SphereTest::Wanted([](const Instance& k, std::size_t t, std::uint32_t m) {
            return k.c.segments[k.c.steiner[m - k.c.vertexCount].carrier].first == k.shapes->corner(t, 0);
        }) : SphereTest::Wanted([](const Instance& k, std::size_t t, std::uint32_t m) {
            return k.c.segments[k.c.steiner[m - k.c.vertexCount].carrier].second == k.shapes->corner(t, 0);
        }));
    }
}

void testL11(const Instance& i, Findings& out) {
    testSpheres(i, out, 'S', Index(i.c, i.rimPoints(), i.check.threads), noCorner);
}

void testL13(const Instance& i, Findings& out) {
    testSpheres(i, out, 'R', indexOfAll(i.check), [](const Instance& k, std::size_t t, std::uint32_t x) {
        const std::uint32_t* corner = k.shapes->boxOf(t).corner;
        return std::find(corner, corner + 4, x) == corner + 4;
    });
}

void testL16(const Instance& i, Findings& out) {
    const Index& index = indexOfAll(i.check);
    const std::vector<std::uint32_t> order = cellsInOrder(i.check);
    inParallel(order.size(), i.check.threads, 64, [&] {
        return [&, test = std::make_unique<SphereTest>(i, index, noCorner, out)](std::size_t begin, std::size_t end) {
            for (std::size_t n = begin; n < end; ++n) {
                const std::size_t t = order[n];
                if (i.c.cells[t].kind != 'C') continue;
                std::string fault;
                if (i.p.h) {
                    const Rational& h = i.p.h->value;
                    const std::uint32_t* corner = i.c.cells[t].corner;
                    const Frame f(i.c, {corner[0], corner[1], corner[2]}, {&h});
                    const Circle circle(f);
                    const Whole bound = 289 * square(f.length(h)) * circle.D, size = 64 * circle.r;  // 256 R^2
                    if (size > bound) fault = objectName("cell", t, "radius");
                    out.slack(ratio(bound, size) - 1, i.cellLine(t), [&] { return objectName("cell", t, "radius"); });
                }
                const std::uint32_t x = test->violating(t);
                if (x != none) fault = objectName("cell", t, "point", x);
                if (!fault.empty()) out.failed(i.cellLine(t), fault);
            }
        };
    });
}
