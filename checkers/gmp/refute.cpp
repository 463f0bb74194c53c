// SPDX-License-Identifier: Apache-2.0
// Refutations: docs/lemma-claims.md, section 5.
#include "lemmas.h"

namespace {

Rational power(const Certificate& c, const Cell& cell, std::uint32_t x) {
    const Place a = place(c, cell.corner[0]), z0 = centre(a, place(c, cell.corner[1]), place(c, cell.corner[2]));
    const Place d = place(c, x) - z0, radius = a - z0;
    return d * d - radius * radius;
}

// L5: the protectors a of an opening and a' of a closing cell cross.
bool crossing(const Certificate& c, const Shapes& shapes, const Refutation& r) {
    if (c.cells[r.second].kind != 'T' || !shapes.opens(r.cell) || shapes.opens(r.second)) return false;
    if (c.cells[r.cell].facet != c.cells[r.second].facet || shapes.corner(r.cell, 0) != shapes.corner(r.second, 0)) return false;
    const Frame f(c, {shapes.corner(r.cell, 0), shapes.foot(r.cell), shapes.tip(r.cell), shapes.foot(r.second), shapes.tip(r.second)});
    const Vec n = direction(c, c.cells[r.cell].facet);
    return sgn(Whole(n * cross(f[1], f[3]))) > 0 && sgn(Whole(n * cross(f[2], f[4]))) <= 0 &&
           r.value == power(c, c.cells[r.cell], shapes.foot(r.second));
}

// The hypotheses speak of vertices and of the corners of T and S cells: only such points refute anything.
bool bound(const Certificate& c, std::uint32_t x) {
    return x < c.vertexCount ||
           std::any_of(c.cells.begin(), c.cells.end(), [x](const Cell& cell) { return (cell.kind == 'T' || cell.kind == 'S') && isCorner(cell, x); });
}

// L10: m is the foot of a T cell with the same vertex.
bool isFoot(const Certificate& c, const Shapes& shapes, std::uint32_t v, std::uint32_t m) {
    for (std::size_t t = 0; t < c.cells.size(); ++t)
        if (c.cells[t].kind == 'T' && shapes.corner(t, 0) == v && shapes.foot(t) == m) return true;
    return false;
}

// L9, L10, L11, L13: a point in the sphere of a cell. (A corner is not in it, nor one of a box: their power is 0.)
bool pointInSphere(const Certificate& c, const Shapes& shapes, const Refutation& r) {
    const Cell& cell = c.cells[r.cell];
    const std::uint32_t x = r.second;
    if (!bound(c, x)) return false;
    const auto isRim = [&] {
        if (x < c.vertexCount) return false;
        const PointKind kind = c.steiner[x - c.vertexCount].kind;
        return kind == PointKind::arc || kind == PointKind::offset;
    };
    bool right = false;
    if (r.lemma == Lemma::l9) right = cell.kind == 'T';
    if (r.lemma == Lemma::l10) right = cell.kind == 'S' && isFoot(c, shapes, shapes.corner(r.cell, 0), x);
    if (r.lemma == Lemma::l11) right = cell.kind == 'S' && isRim();
    if (r.lemma == Lemma::l13) right = cell.kind == 'R';
    return right && sgn(r.value) < 0 && r.value == power(c, cell, x);
}

// L18: two points that no sphere through the corners can leave out together.
bool noSphere(const Certificate& c, const Refutation& r) {
    const Cell& cell = c.cells[r.cell];
    if (cell.kind == 'C' || !bound(c, r.second) || !bound(c, r.point)) return false;
    const std::uint32_t* corner = c.facets[cell.facet].corner;
    const Place origin = place(c, corner[0]), n = cross(place(c, corner[1]) - origin, place(c, corner[2]) - origin);
    const Place a = place(c, cell.corner[0]);
    const Rational g1 = n * (place(c, r.second) - a), g2 = n * (place(c, r.point) - a);
    if (sgn(g1) >= 0 || sgn(g2) <= 0) return false;
    return 2 * g1 * r.value == power(c, cell, r.second) && 2 * g2 * r.other == power(c, cell, r.point) && r.value > r.other;
}

}  // namespace

std::optional<Violation> testRefutation(Check& check, std::string& object) {
    const Certificate& c = check.certificate;
    const Refutation& r = *c.claims.refutation;
    bool good = false;
    if (r.lemma == Lemma::l5) {
        object = objectName("cell", r.cell, "cell", r.second);
        good = crossing(c, *check.shapes, r);
    } else if (r.lemma == Lemma::l18) {
        object = objectName("cell", r.cell, "point", r.second, "point", r.point);
        good = noSphere(c, r);
    } else {
        object = objectName("cell", r.cell, "point", r.second);
        good = pointInSphere(c, *check.shapes, r);
    }
    if (good) return std::nullopt;
    return Violation{r.evidenceLine, object};
}
