// SPDX-License-Identifier: Apache-2.0
// L6 and L8: points of a facet and the spacing h.
#include "lemmas.h"

namespace {

// Distances of a place from points, in rationals. What is farther than the spacing, and gives no new slack, is passed over.
struct Nearest {
    Wide bound() const { return std::max(inner, scaledGap(unit, 1 + out.best())); }
    const Instance& i;
    Findings& out;
    Wide inner, unit;  // on the grid: the square that has to be kept, and the one that slacks refer to
};

struct RimNearest : Nearest {
    void visit(std::uint32_t x) {
        if (x == p || i.c.steiner[x - i.c.vertexCount].carrier != i.c.steiner[p - i.c.vertexCount].carrier) return;
        const Rational& h = i.p.h->value;
        const Frame f(i.c, {p, x}, {&h});
        const Whole h2 = square(f.length(h)), d2 = norm(f[1]);
        if (d2 < h2) violating = std::min(violating, x);
        out.slack(ratio(d2, h2) - 1, i.c.pointLine(std::max(p, x)), [&] { return name(x); });
    }
    std::string name(std::uint32_t x) const { return objectName("point", std::max(p, x), "point", std::min(p, x)); }
    std::uint32_t p, violating = none;
};

}  // namespace

void testL6(const Instance& i, Findings& out) {
    const std::vector<std::uint32_t> rim = i.rimPoints();
    std::vector<GridBox> boxes;
    for (const std::uint32_t p : rim) boxes.push_back(boxOf(i.c.points, {p}, p));
    const BoxTree tree(boxes);
    const Wide h2 = gridSquare(i.c.points, i.p.h->value * i.p.h->value);
    inParallel(rim.size(), i.check.threads, 64, [&] {
        return [&](std::size_t begin, std::size_t end) {
            for (std::size_t k = begin; k < end; ++k) {
                RimNearest nearest{{i, out, h2, h2}, rim[k]};
                tree.search(boxes[k], nearest);
                if (nearest.violating != none)
                    out.failed(i.c.pointLine(std::max(rim[k], nearest.violating)), nearest.name(nearest.violating));
            }
        };
    });
}

namespace {

// The insertion of an interior point at the circumcentre z0 of a triangle. (That it is a corner of C cells only has been tested by rule `kinds`.)
class InsertionTest {
public:
    InsertionTest(const Instance& instance, Findings& out)
        : i(instance), c(instance.c), out_(out), h2_(instance.p.h->value * instance.p.h->value), order_(c.steiner.size(), none) {
        for (std::uint32_t k = 0; k < c.claims.insertions.size(); ++k) {
            const std::uint32_t x = c.claims.insertions[k].point;
            if (x >= c.vertexCount && order_[x - c.vertexCount] == none) order_[x - c.vertexCount] = k;
        }
        std::vector<GridBox> points, edges;
        for (std::uint32_t x = c.vertexCount; x < c.pointCount(); ++x)
            if (i.isRim(x) || interior(x)) points.push_back(boxOf(c.points, {x}, x));
        for (std::uint32_t k = 0; k < i.shapes->outline.size(); ++k)
            edges.push_back(boxOf(c.points, {i.shapes->outline[k].a, i.shapes->outline[k].b}, k));
        points_ = std::make_unique<BoxTree>(std::move(points));
        edges_ = std::make_unique<BoxTree>(std::move(edges));
        grid_ = gridSquare(c.points, h2_);
        quarter_ = gridSquare(c.points, h2_ / 4);
    }

    void testMissing() {
        for (std::uint32_t x = c.vertexCount; x < c.pointCount(); ++x)
            if (interior(x) && order_[x - c.vertexCount] == none) out_.failed(c.pointLine(x), objectName("point", x, "missing"));
    }

    void test(std::uint32_t number) const {
        const Insertion& insertion = c.claims.insertions[number];
        const std::uint32_t x = insertion.point;
        const auto fail = [&](const auto&... fault) { out_.failed(insertion.line, objectName("point", x, fault...)); };
        if (!interior(x)) return fail("kind");
        if (c.steiner[x - c.vertexCount].carrier != insertion.facet) return fail("facet");
        if (order_[x - c.vertexCount] != number) return fail("twice");
        for (const std::uint32_t corner : insertion.corner)
            if (!present(corner, insertion)) return fail("corner", corner);
        const auto& [a, b, d] = insertion.corner;
        const Rational& h = i.p.h->value;
        const Frame f(c, {a, b, d}, {&h});
        const Circle circle(f);
        if (sgn(circle.D) == 0) return fail("collinear");
        if (circle.r <= 4 * circle.D * square(f.length(h))) return fail("radius");
        const Place z0 = centre(place(c, a), place(c, b), place(c, d)), moved = place(c, x) - z0;
        if (4096 * (moved * moved) > h2_) return fail("centre");
        testDistances(insertion, z0, fail);
    }

private:
    template <class See>
    struct Visitor : Nearest {
        void visit(std::uint32_t id) { see(id); }
        See see;
    };

    template <class Fail>
    void testDistances(const Insertion& insertion, const Place& z0, const Fail& fail) const {
        const std::uint32_t x = insertion.point;
        // The centre is within h/64 of the point: its box is the point's, and larger by more than that on all sides.
        GridBox box = boxOf(c.points, {x}, x);
        const auto room = static_cast<std::int64_t>(__builtin_sqrt(static_cast<double>(grid_)) / 32) + 2;
        for (int axis = 0; axis < 3; ++axis) {
            box.low[axis] -= room;
            box.high[axis] += room;
        }
        std::uint32_t tooNear = none, edgeTooNear = none;
        const auto seePoint = [&](std::uint32_t y) {
            if (!present(y, insertion)) return;
            const Place d = place(c, y) - z0;
            const Rational d2 = d * d;
            if (d2 <= h2_) tooNear = std::min(tooNear, y);
            out_.slack(rounded(Rational(d2 / h2_ - 1)), insertion.line, [&] { return objectName("point", x, "point", y); });
        };
        const auto seeEdge = [&](std::uint32_t k) {
            const OutlineEdge& edge = i.shapes->outline[k];
            if (c.cells[edge.cell].facet != insertion.facet) return;
            const Rational d2 = distanceToSegment(z0, place(c, edge.a), place(c, edge.b));
            if (4 * d2 < h2_) edgeTooNear = std::min(edgeTooNear, k);
            out_.slack(rounded(Rational(4 * d2 / h2_ - 1)), insertion.line, [&] { return objectName("point", x, "edge", edge.a, edge.b); });
        };
        Visitor<decltype(seePoint)> points{{i, out_, grid_, grid_}, seePoint};
        points_->search(box, points);
        if (tooNear != none) return fail("point", tooNear);
        Visitor<decltype(seeEdge)> edges{{i, out_, quarter_, quarter_}, seeEdge};
        edges_->search(box, edges);
        if (edgeTooNear != none) return fail("edge", i.shapes->outline[edgeTooNear].a, i.shapes->outline[edgeTooNear].b);
    }

    bool interior(std::uint32_t x) const { return x >= c.vertexCount && c.steiner[x - c.vertexCount].kind == PointKind::interior; }
    // A point of the facet that is there when this insertion is made.
    bool present(std::uint32_t x, const Insertion& insertion) const {
        if (!i.isRim(x) && !interior(x)) return false;
        if (c.steiner[x - c.vertexCount].carrier != insertion.facet) return false;
        return i.isRim(x) || order_[x - c.vertexCount] < static_cast<std::uint32_t>(&insertion - c.claims.insertions.data());
    }

    const Instance& i;
    const Certificate& c;
    Findings& out_;
    const Rational h2_;
    std::vector<std::uint32_t> order_;  // of the first insertion of each Steiner point
    std::unique_ptr<BoxTree> points_, edges_;
    Wide grid_, quarter_;
};

}  // namespace

void testL8(const Instance& i, Findings& out) {
    InsertionTest test(i, out);
    test.testMissing();
    inParallel(i.c.claims.insertions.size(), i.check.threads, 16, [&] {
        return [&](std::size_t begin, std::size_t end) {
            for (std::size_t k = begin; k < end; ++k) test.test(static_cast<std::uint32_t>(k));
        };
    });
}
