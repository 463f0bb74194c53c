// SPDX-License-Identifier: Apache-2.0
// Claims about single cells, boxes, edges of outlines, and rows.
#include "lemmas.h"

#include <cmath>

void testL1(const Instance& i, Findings& out) {
    const Rational& h = i.p.h->value;
    i.eachCell("S", [&](std::size_t t) {
        const std::uint32_t a = i.shapes->corner(t, 1), b = i.shapes->corner(t, 2);
        const Frame f(i.c, {a, b}, {&h});
        const Whole h2 = square(f.length(h)), b2 = norm(f[1]);
        const auto name = [&] { return objectName("cell", t); };
        if (b2 < h2 || 4 * b2 > 9 * h2) out.failed(i.cellLine(t), name());
        const double q = ratio(b2, h2);
        out.slack(std::min(q - 1, 2.25 - q), i.cellLine(t), name);
    });
}

void testL2(const Instance& i, Findings& out) {
    const Rational& h = i.p.h->value;
    for (std::size_t b = 0; b < i.shapes->boxes.size(); ++b) {
        const Box& box = i.shapes->boxes[b];
        const Frame f(i.c, {box.corner[0], box.corner[1]}, {&h});
        const Whole h2 = square(f.length(h)), w2 = norm(f[1]);
        const auto name = [&] { return objectName("box", b); };
        if (w2 < h2 || 4 * w2 > 9 * h2) out.failed(i.cellLine(box.cell), name());
        const double q = ratio(w2, h2);
        out.slack(std::min(q - 1, 2.25 - q), i.cellLine(box.cell), name);
    }
}

void testL3(const Instance& i, Findings& out) {
    const Rational& h = i.p.h->value;
    i.eachCell("S", [&](std::size_t t) {
        const Frame f(i.c, {i.shapes->corner(t, 0), i.shapes->corner(t, 1), i.shapes->corner(t, 2)}, {&h});
        const Whole h2 = square(f.length(h)), b2 = norm(f[2] - f[1]), D = f[1] * f[2], X = norm(cross(f[1], f[2]));
        if (b2 <= h2 && sgn(D) >= 0) return;
        const Whole reach = 4 * h2 * b2 * D * D, bulge = square(b2 - h2) * X;
        const auto name = [&] { return objectName("cell", t); };
        if (sgn(D) <= 0 || bulge > reach) out.failed(i.cellLine(t), name());
        out.slack(ratio(reach - bulge, h2 * h2 * X), i.cellLine(t), name);
    });
}

void testL4(const Instance& i, Findings& out) {
    const Rational& h = i.p.h->value;
    for (std::size_t b = 0; b < i.shapes->boxes.size(); ++b) {
        const Box& box = i.shapes->boxes[b];
        const Frame f(i.c, {box.corner[0], box.corner[1], box.corner[3]}, {&h});
        const Whole h2 = square(f.length(h)), w2 = norm(f[1]), d2 = norm(f[2]);
        if (w2 <= h2) continue;
        const Whole reach = 4 * h2 * d2, bulge = square(w2 - h2);
        const auto name = [&] { return objectName("box", b); };
        if (bulge > reach) out.failed(i.cellLine(box.cell), name());
        out.slack(ratio(reach - bulge, h2 * h2), i.cellLine(box.cell), name);
    }
}

void testL5(const Instance& i, Findings& out) {
    i.eachCell("T", [&](std::size_t t) {
        if (!i.shapes->opens(t)) return;
        const std::uint32_t end = i.shapes->closing(t);
        const Frame f(i.c, {i.shapes->corner(t, 0), i.shapes->foot(t), i.shapes->tip(t), i.shapes->foot(end), i.shapes->tip(end)});
        const Vec n = direction(i.c, i.c.cells[t].facet);
        if (sgn(Whole(n * cross(f[1], f[3]))) <= 0) return;
        const Whole turn = n * cross(f[2], f[4]);
        const auto name = [&] { return objectName("cell", t, "cell", end); };
        if (sgn(turn) <= 0) out.failed(i.cellLine(t), name());
        out.slack(sgn(turn) * std::sqrt(ratio(square(turn), norm(f[2]) * norm(f[4]) * norm(n))), i.cellLine(t), name);
    });
}

// The tip a of a T cell, with the next corners of the box beyond m a and of the spoke triangle beyond v a.
void testL7(const Instance& i, Findings& out) {
    i.eachCell("T", [&](std::size_t t) {
        const std::uint32_t facet = i.c.cells[t].facet, v = i.shapes->corner(t, 0), m = i.shapes->foot(t), a = i.shapes->tip(t);
        const bool opens = i.shapes->opens(t);  // then its directed edges are v m, m a, a v
        const std::uint32_t box = opens ? i.shapes->cellAt(facet, a, m) : i.shapes->cellAt(facet, m, a);
        const std::uint32_t spoke = opens ? i.shapes->cellAt(facet, v, a) : i.shapes->cellAt(facet, a, v);
        std::uint32_t p = none, q = none;
        if (box != none && i.c.cells[box].kind == 'R') {
            const std::uint32_t* ring = i.shapes->boxOf(box).corner;  // 2 and 3 are of kind offset; m a is a side, by rule `tiling`
            q = ring[2] == a ? ring[3] : ring[2];
        }
        if (spoke != none && i.c.cells[spoke].kind == 'S')
            for (const std::uint32_t x : i.c.cells[spoke].corner)
                if (x != v && x != a) p = x;
        const auto name = [&] { return objectName("cell", t, "point", a); };
        if (p == none || q == none) return out.failed(i.cellLine(t), name());
        const Frame f(i.c, {a, q, p});
        if (sgn(Whole(f[1] * f[2])) > 0) out.failed(i.cellLine(t), name());
        out.slack(-cosine(f[1], f[2]), i.cellLine(t), name);
    });
}

namespace {

// The offset vectors of two protectors of one row, from a common point of the segment.
Frame offsetVectors(const Certificate& c, std::size_t i, std::size_t j, std::initializer_list<const Rational*> lengths = {}) {
    std::size_t own = i;
    while (c.rows[own].facet != none) --own;
    return Frame(c, {c.rowPoints[c.rows[own].first], c.rowPoints[c.rows[i].first], c.rowPoints[c.rows[j].first]}, lengths);
}

}  // namespace

void testL12(const Instance& i, Findings& out) {
    eachProtectorPair(i.c, [&](std::size_t one, std::size_t two) {
        if (i.c.facetPlane[i.c.rows[one].facet] == i.c.facetPlane[i.c.rows[two].facet]) return;
        const Frame f = offsetVectors(i.c, one, two);
        for (const bool turned : {false, true}) {
            const Vec &o = f[turned ? 2 : 1], &other = f[turned ? 1 : 2];
            const Whole product = other * (other - o);
            const auto name = [&] { return turned ? objectName("row", two, "row", one) : objectName("row", one, "row", two); };
            if (sgn(product) <= 0) out.failed(i.c.rows[two].line, name());
            out.slack(ratio(product, norm(other)), i.c.rows[two].line, name);
        }
    });
}

void testL14(const Instance& i, Findings& out) {
    const Rational& h = i.p.h->value;
    eachProtectorPair(i.c, [&](std::size_t one, std::size_t two) {
        const Frame f = offsetVectors(i.c, one, two, {&h});
        const Whole h2 = square(f.length(h)), d2 = norm(f[1] - f[2]);
        const auto name = [&] { return objectName("row", one, "row", two); };
        if (9 * h2 > 4 * d2) out.failed(i.c.rows[two].line, name());
        out.slack(ratio(4 * d2, 9 * h2) - 1, i.c.rows[two].line, name);
    });
}

void testL17(const Instance& i, Findings& out) {
    for (const OutlineEdge& edge : i.shapes->outline) {
        const std::uint32_t* corner = i.c.cells[edge.cell].corner;
        const Frame f(i.c, {corner[0], corner[1], corner[2], edge.y});
        const Circle circle(f);
        const Whole power = circle.power(f[3]);
        const auto name = [&] { return objectName("cell", edge.cell, "point", edge.y); };
        if (sgn(power) < 0) out.failed(i.cellLine(edge.cell), name());
        out.slack(ratio(4 * power, circle.r), i.cellLine(edge.cell), name);
    }
}

void testL20(const Instance& i, Findings& out) {
    const Rational& most = i.p.rMax->value;
    if (i.p.r && 100 * i.p.r->value * i.p.r->value > 361 * most * most) out.failed(i.p.r->line, "r");
    i.eachCell("TSRC", [&](std::size_t t) {
        const std::uint32_t* corner = i.c.cells[t].corner;
        const Frame f(i.c, {corner[0], corner[1], corner[2]}, {&most});
        const Circle circle(f);
        const Whole bound = 4 * circle.D * square(f.length(most));
        if (circle.r > bound) out.failed(i.cellLine(t), objectName("cell", t, "radius"));
        out.slack(ratio(bound, circle.r) - 1, i.cellLine(t), [&] { return objectName("cell", t, "radius"); });
    });
}

void testL23(const Instance& i, Findings& out) {
    const Rational& h = i.p.h->value;
    for (const OutlineEdge& edge : i.shapes->outline) {
        const Frame f(i.c, {edge.x, edge.a, edge.b}, {&h});
        if (sgn(Whole(f[1] * f[2])) >= 0) continue;
        const Circle circle(f);
        // h^2 - (4 R^2 - |AB|^2), times D
        const Whole h2 = square(f.length(h)), room = (h2 + norm(f[2] - f[1])) * circle.D - circle.r;
        const auto name = [&] { return objectName("cell", edge.cell, "edge", edge.a, edge.b); };
        if (sgn(room) < 0) out.failed(i.cellLine(edge.cell), name());
        out.slack(ratio(room, h2 * circle.D), i.cellLine(edge.cell), name);
    }
}
