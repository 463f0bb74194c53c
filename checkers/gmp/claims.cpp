// SPDX-License-Identifier: Apache-2.0
// The table of claims: what each needs, how many objects it has, in what order they are tested.
#include "lemmas.h"

#include <cstring>

void Findings::failed(std::uint64_t line, const std::string& object) {
    const std::lock_guard<std::mutex> guard(mutex_);
    ++report.failures;
    // Of several objects on one line the one that would come first by number: the same for every number of threads.
    const auto before = [](const std::string& a, const std::string& b) { return a.size() != b.size() ? a.size() < b.size() : a < b; };
    std::optional<Violation>& first = report.violation;
    if (!first || line < first->line || (line == first->line && before(object, first->object))) first = Violation{line, object};
}

void Findings::keep(double value, std::uint64_t line, const std::string& object) {
    const std::lock_guard<std::mutex> guard(mutex_);
    if (report.hasSlack && std::tie(report.slack, report.line, report.object) <= std::tie(value, line, object)) return;
    report.hasSlack = true;
    report.slack = value;
    report.line = line;
    report.object = object;
    best_.store(value);
}

namespace {

struct LemmaRule {
    const char* needs;  // letters: r, h, a(ngle), c(hord), m (r-max); * parameters of its own
    std::uint64_t (*count)(const Instance&);
    void (*test)(const Instance&, Findings&);
};

template <char... kinds>
std::uint64_t cells(const Instance& i) {
    std::uint64_t count = 0;
    for (std::size_t t = i.firstCell; t < i.endCell; ++t) count += ((i.c.cells[t].kind == kinds) || ...) ? 1 : 0;
    return count;
}
std::uint64_t allCells(const Instance& i) { return i.endCell - i.firstCell; }
std::uint64_t openingCells(const Instance& i) {
    std::uint64_t count = 0;
    for (std::size_t t = i.firstCell; t < i.endCell; ++t) count += i.shapes->opens(t) ? 1 : 0;
    return count;
}
std::uint64_t boxes(const Instance& i) { return i.shapes->boxes.size(); }
std::uint64_t outlineEdges(const Instance& i) { return i.shapes->outline.size(); }
std::uint64_t segmentEnds(const Instance& i) { return 2 * i.c.segments.size(); }
std::uint64_t one(const Instance&) { return 1; }
std::uint64_t rimPoints(const Instance& i) { return i.rimPoints().size(); }
std::uint64_t interiorPoints(const Instance& i) {
    return static_cast<std::uint64_t>(std::count_if(i.c.steiner.begin(), i.c.steiner.end(), [](const Steiner& s) { return s.kind == PointKind::interior; }));
}
template <bool ordered>
std::uint64_t protectorPairs(const Instance& i) {
    std::uint64_t count = 0;
    eachProtectorPair(i.c, [&](std::size_t one, std::size_t two) {
        if (!ordered) ++count;
        else if (i.c.facetPlane[i.c.rows[one].facet] != i.c.facetPlane[i.c.rows[two].facet]) count += 2;
    });
    return count;
}
std::uint64_t triples(const Instance& i) {
    std::uint64_t count = 0;
    eachTriple(i, [&](std::uint32_t, std::uint32_t, std::uint32_t) { ++count; });
    return count;
}
std::uint64_t facets(const Instance& i) { return i.c.facets.size(); }
std::uint64_t verticesAndSegments(const Instance& i) { return std::uint64_t{i.c.vertexCount} + i.c.segments.size(); }
std::uint64_t subsegments(const Instance& i) { return i.c.hanging.size(); }

const LemmaRule lemmaRules[] = {
    {"a", segmentEnds, testHAngle},            // H-angle
    {"*", cells<'T', 'S'>, testHBall},         // H-ball
    {"*", cells<'T'>, testHOffset},            // H-offset
    {"rhac", one, testHChord},                 // H-chord
    {"h", cells<'S'>, testL1},
    {"h", boxes, testL2},
    {"h", cells<'S'>, testL3},
    {"h", boxes, testL4},
    {"", openingCells, testL5},
    {"h", rimPoints, testL6},
    {"", cells<'T'>, testL7},
    {"h", interiorPoints, testL8},
    {"", cells<'T'>, testL9},
    {"", cells<'S'>, testL10},
    {"", cells<'S'>, testL11},
    {"", protectorPairs<true>, testL12},
    {"", cells<'R'>, testL13},
    {"h", protectorPairs<false>, testL14},
    {"a", triples, testL15},
    {"*", cells<'C'>, testL16},
    {"", outlineEdges, testL17},
    {"", allCells, nullptr},                   // L18
    {"", allCells, nullptr},                   // L18b
    {"", facets, nullptr},                     // L19
    {"m", allCells, testL20},
    {"*", verticesAndSegments, testL21},
    {"", subsegments, nullptr},                // L22
    {"h", outlineEdges, testL23},
};
static_assert(std::size(lemmaRules) == lemmaNames.size());
const LemmaRule& ruleOf(Lemma lemma) { return lemmaRules[static_cast<std::size_t>(lemma)]; }

// The first parameter that a letter asks for and that is not there.
const char* missingGlobal(const Parameters& p, const char* letters) {
    for (; *letters != '\0'; ++letters) {
        if (*letters == 'r' && !p.r) return "r";
        if (*letters == 'h' && !p.h) return "h";
        if (*letters == 'a' && !p.angle) return "angle";
        if (*letters == 'c' && !p.chord) return "chord";
        if (*letters == 'm' && !p.rMax) return "r-max";
    }
    return nullptr;
}

// Local: a ball for every vertex of a T or S cell, a row for every segment that carries a corner of a T cell.
const char* missingLocal(const Certificate& c, bool balls, bool rows) {
    const Parameters& p = c.claims.parameters;
    for (const Cell& cell : c.cells)
        for (const std::uint32_t x : cell.corner) {
            if (balls && (cell.kind == 'T' || cell.kind == 'S') && x < c.vertexCount && p.ball(x) == nullptr) return "ball";
            if (!rows || cell.kind != 'T' || x < c.vertexCount) continue;
            const Steiner& point = c.steiner[x - c.vertexCount];
            if (onSegment(point.kind) && p.row(point.carrier) == nullptr) return "row";
        }
    return nullptr;
}

const char* missingParameter(const Certificate& c, Lemma lemma) {
    const Parameters& p = c.claims.parameters;
    switch (lemma) {
        case Lemma::hBall: return p.local() ? missingLocal(c, true, false) : missingGlobal(p, c.dimension == 3 ? "rh" : "r");
        case Lemma::hOffset:
            if (p.local()) return missingLocal(c, true, true);
            if (const char* name = missingGlobal(p, "ra")) return name;
            return p.beta || p.offset ? nullptr : "beta";
        case Lemma::l16: return p.r ? missingGlobal(p, "h") : nullptr;
        case Lemma::l21: return p.local() ? missingLocal(c, true, true) : missingGlobal(p, "r");
        default: return missingGlobal(p, ruleOf(lemma).needs);
    }
}

Instance makeInstance(Check& check) {
    const Certificate& c = check.certificate;
    Instance i{check, c, c.claims.parameters, check.shapes.get(), 0, c.cells.size(), {}, {}, {}, {}, {}};
    if (i.p.angle) i.angle.emplace(i.p.angle->cosine, i.p.angle->factor);
    i.segmentsAt.resize(c.vertexCount);
    i.facetsAt.resize(c.vertexCount);
    for (std::uint32_t s = 0; s < c.segments.size(); ++s)
        for (const std::uint32_t v : {c.segments[s].first, c.segments[s].second}) i.segmentsAt[v].push_back(s);
    for (std::uint32_t f = 0; f < c.facets.size(); ++f)
        for (std::size_t k = c.facetVertexFirst[f]; k < c.facetVertexFirst[f + 1]; ++k) i.facetsAt[c.facetVertices[k]].push_back(f);
    std::vector<std::pair<Pair, std::uint32_t>> corners;
    for (std::uint32_t t = 0; t < c.cells.size(); ++t)
        for (const std::uint32_t x : c.cells[t].corner)
            if (x < c.vertexCount) corners.push_back({{c.cells[t].facet, x}, t});
    std::sort(corners.begin(), corners.end());
    for (const auto& [place, t] : corners) {
        i.facetCorners.push_back(place);
        i.cornerCells.push_back(t);
    }
    return i;
}

// The parameters, the count; then the claim can be tested for the cells that are asked for.
std::optional<Violation> prepare(Instance& i, const Claim& claim, ClaimReport& report) {
    report.lemma = claim.lemma;
    if (const char* name = missingParameter(i.c, claim.lemma)) report.violation = Violation{claim.line, objectName("parameter", name)};
    if (report.violation) return report.violation;
    i.firstCell = 0;
    i.endCell = i.c.cells.size();
    report.objects = ruleOf(claim.lemma).count(i);
    if (report.objects != claim.count) report.violation = Violation{claim.line, objectName("count", report.objects)};
    i.firstCell = i.check.firstCell;
    i.endCell = i.check.endCell;
    report.objects = ruleOf(claim.lemma).count(i);
    return report.violation;
}

}  // namespace

std::optional<Violation> testClaims(Check& check, std::string& name) {
    Instance i = makeInstance(check);
    for (const Claim& claim : i.c.claims.claims) {
        const LemmaRule& rule = ruleOf(claim.lemma);
        if (rule.test == nullptr) continue;
        Findings findings;
        if (!prepare(i, claim, findings.report)) rule.test(i, findings);
        check.claims.push_back(findings.report);
        name = nameOf(claim.lemma);
        if (findings.report.violation) return findings.report.violation;
    }
    return std::nullopt;
}

std::optional<Violation> testCount(Check& check, const Claim& claim) {
    Instance i{check, check.certificate, check.certificate.claims.parameters, nullptr, 0, 0, {}, {}, {}, {}, {}};
    ClaimReport report;
    const auto violation = prepare(i, claim, report);
    check.claims.push_back(report);
    return violation;
}

void reportRule(Check& check, const Claim& claim, const std::optional<Violation>& violation) {
    ClaimReport& report = check.claims.back();
    const Certificate& c = check.certificate;
    report.violation = violation;
    report.failures = violation ? 1 : 0;
    const SmallestPower& smallest = claim.lemma == Lemma::l22 ? check.smallestHanging : check.smallest;
    if ((claim.lemma != Lemma::l18 && claim.lemma != Lemma::l22) || !std::isfinite(smallest.value)) return;
    report.hasSlack = true;
    report.slack = smallest.value;
    report.line = smallest.cellLine;
    report.object = claim.lemma == Lemma::l22 ? objectName("subsegment", smallest.cellLine - c.hangingLine, "point", smallest.point)
                                              : objectName("cell", smallest.cellLine - c.cellLine, "point", smallest.point);
}
