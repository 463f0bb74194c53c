// SPDX-License-Identifier: Apache-2.0
// The claims of docs/lemma-claims.md, one function each.
#pragma once

#include "boxes.h"
#include "index.h"
#include "shapes.h"

#include <algorithm>
#include <cmath>
#include <span>

// What was found about one claim, by several threads.
class Findings {
public:
    // At most once for each object of the claim.
    void failed(std::uint64_t line, const std::string& object);
    template <class Name>
    void slack(double value, std::uint64_t line, const Name& name) {
        if (!std::isfinite(value) || value > best_.load(std::memory_order_relaxed)) return;
        keep(value, line, name());
    }
    double best() const { return best_.load(std::memory_order_relaxed); }

    ClaimReport report;

private:
    void keep(double value, std::uint64_t line, const std::string& object);
    std::atomic<double> best_{std::numeric_limits<double>::infinity()};
    std::mutex mutex_;
};

struct Instance {
    Check& check;
    const Certificate& c;
    const Parameters& p;
    const Shapes* shapes;  // if rule `kinds` applies
    std::size_t firstCell, endCell;  // the cells that are asked for
    std::optional<Chebyshev> angle;  // of C, up to K
    std::vector<std::vector<std::uint32_t>> segmentsAt, facetsAt;  // of each vertex
    std::vector<Pair> facetCorners;            // (facet, vertex) ...
    std::vector<std::uint32_t> cornerCells;    // ... and a cell of that facet with that corner, sorted

    std::uint64_t cellLine(std::size_t t) const { return c.cellLine + t; }
    // Calls work(t) for the cells of these kinds that are asked for, on several threads.
    template <class Work>
    void eachCell(std::string_view kinds, const Work& work) const {
        inParallel(endCell - firstCell, check.threads, 64, [&] {
            return [&](std::size_t begin, std::size_t end) {
                for (std::size_t t = firstCell + begin; t < firstCell + end; ++t)
                    if (kinds.find(c.cells[t].kind) != kinds.npos) work(t);
            };
        });
    }
    std::span<const std::uint32_t> cellsAt(std::uint32_t facet, std::uint32_t v) const {
        const auto [first, last] = std::equal_range(facetCorners.begin(), facetCorners.end(), Pair{facet, v});
        return {cornerCells.data() + (first - facetCorners.begin()), static_cast<std::size_t>(last - first)};
    }
    bool angleBelowPi() const { return angle->belowPi(p.angle->factor); }
    std::uint32_t otherEnd(std::uint32_t segment, std::uint32_t v) const {
        return c.segments[segment].first == v ? c.segments[segment].second : c.segments[segment].first;
    }
    bool isRim(std::uint32_t x) const {  // of kind arc or offset
        if (x < c.vertexCount) return false;
        const PointKind kind = c.steiner[x - c.vertexCount].kind;
        return kind == PointKind::arc || kind == PointKind::offset;
    }
    std::vector<std::uint32_t> rimPoints() const {
        std::vector<std::uint32_t> points;
        for (std::uint32_t x = c.vertexCount; x < c.pointCount(); ++x)
            if (isRim(x)) points.push_back(x);
        return points;
    }
};

inline bool isCorner(const Cell& cell, std::uint32_t x) { return std::find(std::begin(cell.corner), std::end(cell.corner), x) != std::end(cell.corner); }

// Whether a cell v p q of the facet lies over the direction of segment e at v: n.((p-v) x u) >= 0 and n.(u x (q-v)) >= 0.
bool cellOverSegment(const Instance&, std::uint32_t facet, std::uint32_t v, std::uint32_t e);
// sin^2 of the angle of e with the facet >= 1 - t^2.
bool steepEnough(const Instance&, std::uint32_t facet, std::uint32_t v, std::uint32_t e, const Rational& t, double* sine2 = nullptr);
// Calls use(v, e, f) for the triples of L15.
template <class Use>
void eachTriple(const Instance& i, const Use& use) {
    if (i.c.dimension != 3) return;
    for (std::uint32_t v = 0; v < i.c.vertexCount; ++v)
        for (const std::uint32_t e : i.segmentsAt[v])
            for (const std::uint32_t f : i.facetsAt[v])
                if (i.c.role(f, e) == 0) use(v, e, f);
}
// Calls use(i, j) for the pairs i < j of protectors of one row.
template <class Use>
void eachProtectorPair(const Certificate& c, const Use& use) {
    for (std::size_t j = 1; j < c.rows.size(); ++j)
        for (std::size_t i = j; i-- > 0 && c.rows[i].segment == c.rows[j].segment;)
            if (c.rows[i].facet != none) use(i, j);
}

void testHAngle(const Instance&, Findings&);
void testHBall(const Instance&, Findings&);
void testHOffset(const Instance&, Findings&);
void testHChord(const Instance&, Findings&);
void testL1(const Instance&, Findings&);
void testL2(const Instance&, Findings&);
void testL3(const Instance&, Findings&);
void testL4(const Instance&, Findings&);
void testL5(const Instance&, Findings&);
void testL6(const Instance&, Findings&);
void testL7(const Instance&, Findings&);
void testL8(const Instance&, Findings&);
void testL9(const Instance&, Findings&);
void testL10(const Instance&, Findings&);
void testL11(const Instance&, Findings&);
void testL12(const Instance&, Findings&);
void testL13(const Instance&, Findings&);
void testL14(const Instance&, Findings&);
void testL15(const Instance&, Findings&);
void testL16(const Instance&, Findings&);
void testL17(const Instance&, Findings&);
void testL20(const Instance&, Findings&);
void testL21(const Instance&, Findings&);
void testL23(const Instance&, Findings&);

// The claims but those that stand for a rule (L18, L18b, L19, L22), which are tested with that rule.
std::optional<Violation> testClaims(Check&, std::string& name);
// The count of a claim that stands for a rule; then its report, from what the rule found.
std::optional<Violation> testCount(Check&, const Claim&);
void reportRule(Check&, const Claim&, const std::optional<Violation>&);
// A refutation, after its claims.
std::optional<Violation> testRefutation(Check&, std::string& object);
