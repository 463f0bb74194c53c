// SPDX-License-Identifier: Apache-2.0
// Reads the complex, section 2 of the format.
#include "read.h"

std::uint32_t readCount(Text& text) {
    text.space();
    const std::uint32_t count = text.index();
    text.finish();
    return count;
}

void readLiteral(Text& text, std::string_view keyword, std::string_view value, std::initializer_list<std::string_view> miscounted) {
    text.begin(keyword, miscounted);
    text.space();
    const char* where = text.mark();
    if (text.word() != value)
        text.failAt(where, "E-SYNTAX", "expected `" + std::string(keyword) + " " + std::string(value) + "`");
    text.finish();
}

void readCoordinates(Text& text, int dimension, IntegerStore& store) {
    const std::size_t first = store.size();
    text.space();
    const char* start = text.mark();
    for (int axis = 0; axis < dimension; ++axis) {
        text.integer(store);
        text.space();
    }
    if (dimension == 2) store.append(nullptr, 0);
    const char* where = text.mark();
    text.integer(store);
    text.finish();
    const View w(store, first + 3);
    if (sign(w) <= 0) text.failAt(where, "E-VALUE", "W is not positive");
    // For a power of two the greatest common divisor is 1 exactly if something is odd.
    const bool anyOdd = mpz_odd_p(static_cast<mpz_srcptr>(w)) || mpz_odd_p(static_cast<mpz_srcptr>(View(store, first))) ||
                        mpz_odd_p(static_cast<mpz_srcptr>(View(store, first + 1))) || mpz_odd_p(static_cast<mpz_srcptr>(View(store, first + 2)));
    bool prime = anyOdd && mpz_popcount(w) == 1;
    if (anyOdd && !prime) {
        Integer divisor;
        mpz_set(divisor, w);
        for (std::size_t axis = 0; axis < 3 && !prime; ++axis) {
            mpz_gcd(divisor, divisor, View(store, first + axis));
            prime = mpz_cmp_ui(divisor.value, 1) == 0;
        }
        prime = mpz_cmp_ui(divisor.value, 1) == 0;
    }
    if (!prime) text.failAt(start, "E-VALUE", "the coordinates have a common divisor");
}

namespace {

void readSegments(Text& text, Certificate& c) {
    text.begin("segments", {"v"});
    const std::uint32_t count = readCount(text);
    c.segmentLine = text.line() + 1;
    for (std::uint32_t s = 0; s < count; ++s) {
        text.begin("s", {"facets"});
        text.space();
        const char* where = text.mark();
        const std::uint32_t a = text.indexBelow(c.vertexCount, "vertex");
        text.space();
        const std::uint32_t b = text.indexBelow(c.vertexCount, "vertex");
        text.finish();
        if (a >= b) text.failAt(where, "E-ORDER", "the first vertex of a segment is not below the second");
        if (s > 0 && c.segments.back() >= Pair{a, b}) text.failAt(where, "E-ORDER", "segments are not strictly increasing");
        c.segments.push_back({a, b});
    }
}

void readPairs(Text& text, const Certificate& c, std::vector<Pair>& pairs, std::uint32_t count, bool ascending, std::string_view next) {
    for (std::uint32_t i = 0; i < count; ++i) {
        text.beginNumber({next});
        const char* where = text.mark();
        const std::uint32_t a = text.indexBelow(c.vertexCount, "vertex");
        text.space();
        const std::uint32_t b = text.indexBelow(c.vertexCount, "vertex");
        text.finish();
        if (ascending && a >= b) text.failAt(where, "E-ORDER", "the first vertex of an inner constraint is not below the second");
        if (i > 0 && pairs.back() >= Pair{a, b}) text.failAt(where, "E-ORDER", "lines are not strictly increasing");
        pairs.push_back({a, b});
    }
}

void readFacet(Text& text, Certificate& c, std::uint32_t number) {
    if (number == 0) text.begin("f", {"end", "s"});
    else text.begin("f", {"end", "#"});
    Facet facet{};
    facet.line = text.line();
    for (std::uint32_t& corner : facet.corner) {
        text.space();
        corner = text.indexBelow(c.vertexCount, "vertex");
    }
    text.finish();
    text.begin("b");
    text.space();
    const char* where = text.mark();
    facet.boundaryCount = text.index();
    text.finish();
    if (facet.boundaryCount < 3) text.failAt(where, "E-VALUE", "a facet has at least three boundary edges");
    facet.boundary = c.boundary.size();
    readPairs(text, c, c.boundary, facet.boundaryCount, false, "c");
    text.begin("c", {"#"});
    facet.innerCount = readCount(text);
    facet.inner = c.inner.size();
    readPairs(text, c, c.inner, facet.innerCount, true, "p");
    text.begin("p", {"#"});
    facet.isolatedCount = readCount(text);
    facet.isolated = c.isolated.size();
    for (std::uint32_t i = 0; i < facet.isolatedCount; ++i) {
        text.beginNumber({"f", "end"});
        const char* start = text.mark();
        const std::uint32_t a = text.indexBelow(c.vertexCount, "vertex");
        text.finish();
        if (i > 0 && c.isolated.back() >= a) text.failAt(start, "E-ORDER", "lines are not strictly increasing");
        c.isolated.push_back(a);
    }
    c.facets.push_back(facet);
}

}  // namespace

void readComplex(Text& text, Certificate& c, const std::string& complexPath) {
    text.begin("plc");
    text.startComplex(complexPath);
    text.space();
    const char* where = text.mark();
    if (text.word() != "1") text.failAt(where, "E-SYNTAX", "expected `plc 1`");
    text.finish();

    text.begin("dim");
    text.space();
    where = text.mark();
    const std::uint32_t dimension = text.index();
    text.finish();
    if (dimension != 2 && dimension != 3) text.failAt(where, "E-VALUE", "the dimension is 2 or 3");
    c.dimension = static_cast<int>(dimension);

    text.begin("vertices");
    const std::uint32_t vertices = readCount(text);
    c.vertexLine = text.line() + 1;
    for (std::uint32_t v = 0; v < vertices; ++v) {
        text.begin("v", {"segments"});
        readCoordinates(text, c.dimension, c.points.raw());
        ++c.vertexCount;
    }
    readSegments(text, c);

    text.begin("facets", {"s"});
    text.space();
    where = text.mark();
    const std::uint32_t facets = text.index();
    text.finish();
    if (c.dimension == 2 && facets > 1) text.failAt(where, "E-VALUE", "in dimension 2 there is at most one facet");
    for (std::uint32_t f = 0; f < facets; ++f) readFacet(text, c, f);
    text.begin("end", {"f", "#"});
    text.finish();
    c.complexDigest = text.endComplex();
    c.differenceLine = text.firstDifference();
}
