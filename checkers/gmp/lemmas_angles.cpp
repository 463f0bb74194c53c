// SPDX-License-Identifier: Apache-2.0
// Hypotheses about angles and sizes, and L15.
#include "lemmas.h"

#include <cmath>

namespace {

// The end of segment e at v against the other segments there: t >= cos of the angle. The first one that fails, or none.
std::uint32_t sharperSegment(const Instance& i, std::uint32_t v, std::uint32_t e, const Rational& t) {
    for (const std::uint32_t other : i.segmentsAt[v]) {
        if (other == e) continue;
        const Frame f(i.c, {v, i.otherEnd(e, v), i.otherEnd(other, v)});
        if (!atLeastCosine(t, f[1], f[2])) return other;
    }
    return none;
}

std::string segmentPair(std::uint32_t a, std::uint32_t b) { return objectName("segment", std::max(a, b), "segment", std::min(a, b)); }

// "K psi < pi", which all claims with multiples of psi need; and J times `factor` at most K.
bool multipleGood(const Instance& i, const FactorParameter& j, std::uint32_t factor, const char* name, Findings& out) {
    const bool good = std::uint64_t{factor} * j.value <= i.p.angle->factor;
    if (!good) out.failed(j.line, objectName(name, j.value));
    if (!i.angleBelowPi()) out.failed(i.p.angle->line, objectName("angle", i.p.angle->factor));
    return good && i.angleBelowPi();
}

}  // namespace

void testHAngle(const Instance& i, Findings& out) {
    const Rational& t = i.angle->T[i.p.angle->factor];
    if (!i.angleBelowPi() || sgn(t) <= 0 || 2 * t * t < 1) out.failed(i.p.angle->line, objectName("angle", i.p.angle->factor));
    for (std::uint32_t e = 0; e < i.c.segments.size(); ++e)
        for (const std::uint32_t v : {i.c.segments[e].first, i.c.segments[e].second}) {
            std::uint32_t worst = none;  // the one with the smallest line of a pair
            for (const std::uint32_t other : i.segmentsAt[v]) {
                if (other == e) continue;
                const Frame f(i.c, {v, i.otherEnd(e, v), i.otherEnd(other, v)});
                if (!atLeastCosine(t, f[1], f[2])) worst = std::min(worst, other);
                out.slack(rounded(t) - cosine(f[1], f[2]), i.c.segmentLine + std::max(e, other), [&] { return segmentPair(e, other); });
            }
            if (worst != none) out.failed(i.c.segmentLine + std::max(e, worst), segmentPair(e, worst));
        }
}

void testHBall(const Instance& i, Findings& out) {
    const bool local = i.p.local(), planar = i.c.dimension == 2;
    static const Rational zero = 0;
    i.eachCell("TS", [&](std::size_t t) {
        const std::uint32_t v = i.shapes->corner(t, 0);
        const Rational& r = local ? i.p.ball(v)->radius : i.p.r->value;
        const Rational& h = local || planar ? zero : i.p.h->value;
        for (int k = 1; k < 3; ++k) {
            const std::uint32_t p = i.shapes->corner(t, k);
            if (!i.isRim(p)) continue;  // m of a T cell
            const Frame f(i.c, {v, p}, {&r, &h});
            const Whole r2 = square(f.length(r)), h2 = square(f.length(h)), d2 = norm(f[1]);
            const bool good = local ? 15 * r2 <= 16 * d2 && 16 * d2 <= 17 * r2 : 7 * abs(d2 - r2) <= h2;
            if (!good) return out.failed(i.cellLine(t), objectName("cell", t, "point", p));
        }
    });
}

namespace {

// The bounds of the offset d of segment e at its end number `end`: parts (1) and (2) of H-offset, local.
bool offsetGood(const Instance& i, std::uint32_t e, int end) {
    const std::uint32_t v = end == 0 ? i.c.segments[e].first : i.c.segments[e].second;
    const RowParameter& row = *i.p.row(e);
    const Rational d2 = row.offset * row.offset, r2 = i.p.ball(v)->radius * i.p.ball(v)->radius;
    const Chebyshev a(row.a[end], 3);
    if (4 * d2 > r2 || !a.belowPi(3) || sharperSegment(i, v, e, a.T[3]) != none || d2 > r2 * (1 - row.a[end] * row.a[end])) return false;
    if (i.c.dimension == 2) return true;
    const Chebyshev b(row.b[end], 10);
    if (!b.belowPi(10) || d2 > r2 * (1 - b.T[7] * b.T[7])) return false;
    for (const std::uint32_t f : i.facetsAt[v]) {
        if (i.c.role(f, e) != 0) continue;
        for (const std::uint32_t other : i.segmentsAt[v]) {
            if (i.c.role(f, other) == 0) continue;
            const Frame frame(i.c, {v, i.otherEnd(e, v), i.otherEnd(other, v)});
            if (!atLeastCosine(b.T[10], frame[1], frame[2])) return false;
        }
        if (cellOverSegment(i, f, v, e) && (sgn(b.T[10]) < 0 || !steepEnough(i, f, v, e, b.T[10]))) return false;
    }
    return true;
}

}  // namespace

void testHOffset(const Instance& i, Findings& out) {
    const bool local = i.p.local();
    const FactorParameter* factor = local ? nullptr : i.p.beta ? &*i.p.beta : &*i.p.offset;
    if (!local && !multipleGood(i, *factor, i.p.beta ? 2 : 4, i.p.beta ? "beta" : "offset", out)) return;
    const Rational t = local ? Rational(0) : i.angle->T[factor->value], t2 = t * t;
    std::vector<std::atomic<std::int8_t>> known(local ? 2 * i.c.segments.size() : 0);  // of each end: 0 unknown, 1 good, -1 bad
    i.eachCell("T", [&](std::size_t cell) {
        const std::uint32_t v = i.shapes->corner(cell, 0), m = i.shapes->foot(cell), a = i.shapes->tip(cell);
        const auto fail = [&] { out.failed(i.cellLine(cell), objectName("cell", cell, "point", a)); };
        if (!local && i.p.beta) {
            const Frame f(i.c, {v, m, a});
            const Whole side = norm(f[2]), along = side - norm(f[2] - f[1]);
            if (along * t2.get_den() < t2.get_num() * side) fail();
            out.slack(ratio(along, side) - rounded(t2), i.cellLine(cell), [&] { return objectName("cell", cell); });
            return;
        }
        if (!local) {
            const Rational& r = i.p.r->value;
            const Frame f(i.c, {m, a}, {&r});
            if (norm(f[1]) * t2.get_den() > 4 * square(f.length(r)) * (t2.get_den() - t2.get_num())) fail();
            return;
        }
        const std::uint32_t e = i.c.steiner[m - i.c.vertexCount].carrier;
        const int end = i.c.segments[e].first == v ? 0 : 1;
        std::atomic<std::int8_t>& good = known[2 * std::size_t{e} + static_cast<std::size_t>(end)];
        if (good.load() == 0) good.store(offsetGood(i, e, end) ? 1 : -1);
        const Rational& d = i.p.row(e)->offset;
        const Frame f(i.c, {m, a}, {&d});
        const Whole d2 = square(f.length(d)), found = norm(f[1]);
        if (good.load() < 0 || 15 * d2 > 16 * found || 16 * found > 17 * d2) fail();
    });
}

void testHChord(const Instance& i, Findings& out) {
    const FactorParameter& chord = *i.p.chord;
    if (!multipleGood(i, chord, 4, "chord", out)) return;
    const Rational& t = i.angle->T[chord.value];
    const Rational bound = 4 * i.p.r->value * i.p.r->value * (1 - t * t), h2 = i.p.h->value * i.p.h->value;
    if (h2 > bound) out.failed(chord.line, objectName("chord", chord.value));
    out.slack(rounded(Rational(bound / h2 - 1)), chord.line, [&] { return objectName("chord", chord.value); });
}

bool cellOverSegment(const Instance& i, std::uint32_t facet, std::uint32_t v, std::uint32_t e) {
    const Vec n = direction(i.c, facet);
    for (const std::uint32_t t : i.cellsAt(facet, v)) {
        const Cell& cell = i.c.cells[t];
        const int k = cell.corner[0] == v ? 0 : cell.corner[1] == v ? 1 : 2;
        const Frame f(i.c, {v, cell.corner[(k + 1) % 3], cell.corner[(k + 2) % 3], i.otherEnd(e, v)});
        const Vec& u = f[3];
        if (sgn(Whole(n * cross(f[1], u))) >= 0 && sgn(Whole(n * cross(u, f[2]))) >= 0) return true;
    }
    return false;
}

bool steepEnough(const Instance& i, std::uint32_t facet, std::uint32_t v, std::uint32_t e, const Rational& t, double* sine2) {
    const Frame f(i.c, {v, i.otherEnd(e, v)});
    const Vec n = direction(i.c, facet);
    const Whole height = square(f[1] * n), full = norm(f[1]) * norm(n);
    if (sine2 != nullptr) *sine2 = ratio(height, full);
    const Rational t2 = t * t;
    return height * t2.get_den() >= (t2.get_den() - t2.get_num()) * full;
}

void testL15(const Instance& i, Findings& out) {
    const Rational& t = i.angle->T[i.p.angle->factor];
    const double bound = rounded(Rational(1 - t * t));
    const bool angleGood = i.angleBelowPi() && sgn(t) > 0;
    eachTriple(i, [&](std::uint32_t v, std::uint32_t e, std::uint32_t f) {
        if (!cellOverSegment(i, f, v, e)) return;
        double sine2 = 0;
        const auto name = [&] { return objectName("facet", f, "segment", e, "vertex", v); };
        if (!steepEnough(i, f, v, e, t, &sine2) || !angleGood) out.failed(i.c.facets[f].line, name());
        out.slack(sine2 / bound - 1, i.c.facets[f].line, name);
    });
}
