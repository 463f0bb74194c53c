// SPDX-License-Identifier: Apache-2.0
// Reads the records of docs/lemma-claims.md, section 1.
#include "read.h"

#include <algorithm>

const BallParameter* Parameters::ball(std::uint32_t vertex) const {
    const auto found = std::lower_bound(balls.begin(), balls.end(), vertex, [](const BallParameter& b, std::uint32_t v) { return b.vertex < v; });
    return found != balls.end() && found->vertex == vertex ? &*found : nullptr;
}
const RowParameter* Parameters::row(std::uint32_t segment) const {
    const auto found = std::lower_bound(rows.begin(), rows.end(), segment, [](const RowParameter& r, std::uint32_t s) { return r.segment < s; });
    return found != rows.end() && found->segment == segment ? &*found : nullptr;
}
const Claim* Claims::find(Lemma lemma) const {
    const auto found = std::find_if(claims.begin(), claims.end(), [lemma](const Claim& claim) { return claim.lemma == lemma; });
    return found != claims.end() ? &*found : nullptr;
}

namespace {

constexpr std::array<Lemma, 6> hypotheses = {Lemma::hAngle, Lemma::hBall, Lemma::hOffset, Lemma::hChord, Lemma::l1, Lemma::l21};
constexpr std::array<Lemma, 6> refutable = {Lemma::l5, Lemma::l9, Lemma::l10, Lemma::l11, Lemma::l13, Lemma::l18};

Lemma readLemma(Text& text) {
    text.space();
    const char* where = text.mark();
    const auto found = std::find(lemmaNames.begin(), lemmaNames.end(), text.word());
    if (found == lemmaNames.end()) text.failAt(where, "E-SYNTAX", "unknown claim");
    return static_cast<Lemma>(found - lemmaNames.begin());
}

// A line of `claims`: the claim of a lemma, `claim conforms` (then nothing), or `refutes` (then claims.refutation is set).
std::optional<Claim> readClaim(Text& text, Claims& claims) {
    text.begin();
    const std::uint64_t line = text.line();
    const char* where = text.mark();
    const std::string_view keyword = text.word();
    if (keyword == "refutes") {
        const Lemma lemma = readLemma(text);
        text.finish();
        if (std::find(refutable.begin(), refutable.end(), lemma) == refutable.end()) text.failAt(where, "E-SYNTAX", "this is not a claim that can be refuted");
        claims.refutation = Refutation{line, 0, lemma, none, none, none, 0, 0};
        return std::nullopt;
    }
    if (keyword == "notes") text.failAt(where, "E-COUNT", "fewer claims than announced");
    if (keyword != "claim") text.failAt(where, "E-SYNTAX", "expected `claim`");
    text.space();
    where = text.mark();
    if (text.word() == "conforms") {
        text.finish();
        return std::nullopt;
    }
    text.rewind(where - 1);
    Claim claim{readLemma(text), 0, line};
    text.space();
    claim.count = text.index();
    text.finish();
    return claim;
}

// The claims of a certificate that refutes are these, all of them.
void readRefutingClaims(Text& text, Claims& claims, std::uint32_t count, std::optional<Claim> claim, const char* start) {
    for (std::uint32_t i = 0; i < count; ++i) {
        if (i > 0) {
            claim = readClaim(text, claims);
            start = text.lineStart();
        }
        const bool good = i < hypotheses.size() ? claim && claim->lemma == hypotheses[i] : i == hypotheses.size() && claims.refutation;
        if (!good || (i + 1 == count && i < hypotheses.size())) text.failAt(start, "E-ORDER", "not the claims of a refutation, in order");
        if (claim) claims.claims.push_back(*claim);
    }
}

Rational readRational(Text& text) {
    text.space();
    const char* where = text.mark();
    IntegerStore store;
    text.integer(store, '/');
    text.slash();
    text.integer(store);
    const View numerator(store, 0), denominator(store, 1);
    if (sign(denominator) <= 0) text.failAt(where, "E-VALUE", "the denominator is not positive");
    Whole divisor;
    mpz_gcd(divisor.get_mpz_t(), numerator, denominator);
    if (divisor != 1) text.failAt(where, "E-VALUE", "not in lowest terms");
    Rational value;
    mpz_set(value.get_num_mpz_t(), numerator);
    mpz_set(value.get_den_mpz_t(), denominator);
    return value;
}

Rational readPositive(Text& text, bool belowOne = false) {
    const char* where = text.mark() + 1;
    Rational value = readRational(text);
    if (sgn(value) <= 0) text.failAt(where, "E-VALUE", "not positive");
    if (belowOne && value >= 1) text.failAt(where, "E-VALUE", "not below 1");
    return value;
}

std::uint32_t readFactor(Text& text, std::uint32_t largest) {
    text.space();
    const char* where = text.mark();
    const std::uint32_t value = text.index();
    if (value < 1 || value > largest) text.failAt(where, "E-VALUE", "out of range");
    return value;
}

enum ParameterKind { lengthR, lengthH, angle, beta, offset, chord, rMax, ball, row };
constexpr std::string_view parameterNames[] = {"r", "h", "angle", "beta", "offset", "chord", "r-max", "ball", "row"};

void readParameter(Text& text, Certificate& c, ParameterKind kind) {
    constexpr std::uint32_t anyFactor = 0x7fffffff;
    Parameters& p = c.claims.parameters;
    const std::uint64_t line = text.line();
    switch (kind) {
        case lengthR: p.r = {line, readPositive(text)}; break;
        case lengthH: p.h = {line, readPositive(text)}; break;
        case rMax: p.rMax = {line, readPositive(text)}; break;
        case angle: {
            const std::uint32_t factor = readFactor(text, 64);
            p.angle = {line, factor, readPositive(text, true)};
            break;
        }
        case beta: p.beta = {line, readFactor(text, anyFactor)}; break;
        case offset: p.offset = {line, readFactor(text, anyFactor)}; break;
        case chord: p.chord = {line, readFactor(text, anyFactor)}; break;
        case ball: {
            text.space();
            const char* where = text.mark();
            const std::uint32_t vertex = text.indexBelow(c.vertexCount, "vertex");
            if (!p.balls.empty() && p.balls.back().vertex >= vertex) text.failAt(where, "E-ORDER", "balls are not strictly increasing");
            p.balls.push_back({line, vertex, readPositive(text)});
            break;
        }
        case row: {
            text.space();
            const char* where = text.mark();
            RowParameter value;
            value.line = line;
            value.segment = text.indexBelow(c.segments.size(), "segment");
            if (!p.rows.empty() && p.rows.back().segment >= value.segment) text.failAt(where, "E-ORDER", "rows are not strictly increasing");
            value.offset = readPositive(text);
            for (int end = 0; end < 2; ++end) {
                value.a[end] = readPositive(text, true);
                value.b[end] = readPositive(text, true);
            }
            p.rows.push_back(std::move(value));
        }
    }
    text.finish();
}

}  // namespace

void readClaims(Text& text, Claims& claims) {
    text.begin("claims");
    text.space();
    const char* where = text.mark();
    const std::uint32_t count = text.index();
    text.finish();
    if (count == 0) text.failAt(where, "E-VALUE", "a certificate without a claim");
    const std::optional<Claim> first = readClaim(text, claims);
    if (first || claims.refutation) return readRefutingClaims(text, claims, count, first, text.lineStart());
    for (std::uint32_t i = 1; i < count; ++i) {
        const std::optional<Claim> claim = readClaim(text, claims);
        if (!claim || (!claims.claims.empty() && claims.claims.back().lemma >= claim->lemma))
            text.failAt(text.lineStart(), "E-ORDER", "claims are not in the order of the table");
        claims.claims.push_back(*claim);
    }
}

void readParameters(Text& text, Certificate& c) {
    const Claims& claims = c.claims;
    if (claims.claims.empty()) return readLiteral(text, "parameters", "0", {"n"});
    text.begin("parameters", {"n"});
    const std::uint32_t count = readCount(text);
    int last = -1;
    bool global = false;
    for (std::uint32_t i = 0; i < count; ++i) {
        text.begin();
        const char* where = text.mark();
        const std::string_view word = text.word();
        const auto found = std::find(std::begin(parameterNames), std::end(parameterNames), word);
        if (word == "points") text.failAt(where, "E-COUNT", "fewer parameters than announced");
        if (found == std::end(parameterNames)) text.failAt(where, "E-SYNTAX", "unknown parameter");
        const auto kind = static_cast<ParameterKind>(found - parameterNames);
        if (kind < last || (kind == last && kind < ball) || (kind == offset && claims.parameters.beta) || (kind >= ball && global))
            text.failAt(where, "E-ORDER", "parameters are out of order, twice, or exclude each other");
        last = kind;
        global = global || kind < rMax;
        readParameter(text, c, kind);
    }
}

void readEvidence(Text& text, Certificate& c) {
    Claims& claims = c.claims;
    if (claims.claims.empty()) return readLiteral(text, "evidence", "0", {"h"});
    if (claims.refutation) readLiteral(text, "evidence", "1", {"h"});
    else text.begin("evidence", {"h"});
    const std::uint64_t points = c.pointCount(), cells = c.cells.size();
    const auto next = [&](std::uint64_t bound, const char* what) {
        text.space();
        return text.indexBelow(bound, what);
    };
    if (!claims.refutation) {
        const bool wanted = claims.find(Lemma::l8) != nullptr;
        const std::uint32_t count = readCount(text);
        for (std::uint32_t i = 0; i < count; ++i) {
            text.begin("c", {"end"});
            if (!wanted) text.failAt(text.lineStart(), "E-SYNTAX", "evidence for a claim that is not made");
            Insertion insertion{};
            insertion.line = text.line();
            insertion.facet = next(c.facets.size(), "facet");
            for (std::uint32_t& corner : insertion.corner) corner = next(points, "point");
            insertion.point = next(points, "point");
            text.finish();
            claims.insertions.push_back(insertion);
        }
        return;
    }
    Refutation& refutation = *claims.refutation;
    text.begin("x", {"end"});
    refutation.evidenceLine = text.line();
    refutation.cell = next(cells, "cell");
    refutation.second = refutation.lemma == Lemma::l5 ? next(cells, "cell") : next(points, "point");
    refutation.value = readRational(text);
    if (refutation.lemma == Lemma::l18) {
        refutation.point = next(points, "point");
        refutation.other = readRational(text);
    }
    text.finish();
}
