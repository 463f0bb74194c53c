// SPDX-License-Identifier: Apache-2.0
// Reads the certificate around the complex, section 3 of the format.
#include "read.h"

#include <algorithm>
#include <tuple>

namespace {

void readFirstLine(Text& text) {
    text.begin("confidel-certificate");
    text.space();
    const char* where = text.mark();
    const std::string_view version = text.word();
    text.finish();
    const bool number = std::all_of(version.begin(), version.end(), [](char c) { return c >= '0' && c <= '9'; }) && version[0] != '0';
    if (!number) text.failAt(where, "E-SYNTAX", "expected a version number from 1 on");
    if (version != "1") throw Declined{"newer-version"};
}

void readNotes(Text& text) {
    text.begin("notes", {"claim", "refutes"});
    const std::uint32_t count = readCount(text);
    for (std::uint32_t i = 0; i < count; ++i) {
        text.begin("n", {"parameters"});
        text.space();
        const char* where = text.mark();
        const std::string_view key = text.word();
        if (!std::all_of(key.begin(), key.end(), [](char c) { return (c >= 'a' && c <= 'z') || c == '-'; }))
            text.failAt(where, "E-SYNTAX", "a key consists of a-z and `-`");
        text.space();
        text.rest();
    }
}

void readSteiner(Text& text, Certificate& c) {
    static constexpr std::string_view names[] = {"projection", "edge", "offset", "arc", "interior"};
    text.begin("points", {"r", "h", "angle", "beta", "offset", "chord", "r-max", "ball", "row"});
    const std::uint32_t count = readCount(text);
    if (std::uint64_t{c.vertexCount} + count > (std::uint64_t{1} << 31)) throw Declined{"too-large"};
    c.steinerLine = text.line() + 1;
    for (std::uint32_t i = 0; i < count; ++i) {
        text.begin("q", {"cells"});
        text.space();
        const char* where = text.mark();
        const std::string_view name = text.word();
        const auto found = std::find(std::begin(names), std::end(names), name);
        if (found == std::end(names)) text.failAt(where, "E-SYNTAX", "unknown kind of point");
        const auto kind = static_cast<PointKind>(found - std::begin(names));
        text.space();
        const std::uint32_t carrier = onSegment(kind) ? text.indexBelow(c.segments.size(), "segment")
                                                      : text.indexBelow(c.facets.size(), "facet");
        readCoordinates(text, c.dimension, c.points.raw());
        c.steiner.push_back({kind, carrier});
    }
}

std::uint32_t readOffset(Text& text, Certificate& c) {
    const char* where = text.mark();
    const std::size_t first = c.offsets.size();
    text.integer(c.offsets, '/');
    text.slash();
    text.integer(c.offsets);
    const View numerator(c.offsets, first), denominator(c.offsets, first + 1);
    Integer divisor;
    mpz_gcd(divisor, numerator, denominator);
    if (sign(denominator) <= 0) text.failAt(where, "E-VALUE", "the denominator is not positive");
    if (mpz_cmp_ui(divisor.value, 1) != 0) text.failAt(where, "E-VALUE", "not in lowest terms");
    if (sign(numerator) == 0) text.failAt(where, "E-VALUE", "an offset is not zero");
    if (c.dimension == 2) text.failAt(where, "E-VALUE", "an offset in dimension 2");
    return static_cast<std::uint32_t>(first / 2);
}

void readCells(Text& text, Certificate& c) {
    text.begin("cells", {"q"});
    const std::uint32_t count = readCount(text);
    c.cellLine = text.line() + 1;
    const std::uint64_t points = c.pointCount();
    std::uint32_t box = 0;
    bool half = false;  // the second triangle of `box` has to follow
    for (std::uint32_t i = 0; i < count; ++i) {
        text.begin("t", {"rows"});
        Cell cell{};
        cell.offset = none;
        text.space();
        cell.facet = text.indexBelow(c.facets.size(), "facet");
        for (std::uint32_t& corner : cell.corner) {
            text.space();
            corner = text.indexBelow(points, "point");
        }
        text.space();
        const char* where = text.mark();
        const std::string_view kind = text.word();
        if (kind != "T" && kind != "S" && kind != "R" && kind != "C") text.failAt(where, "E-SYNTAX", "unknown kind of cell");
        cell.kind = kind[0];
        if (cell.kind == 'R') {
            text.space();
            where = text.mark();
            if (text.index() != box) text.failAt(where, "E-ORDER", "boxes are numbered in order, on two consecutive lines each");
            if (half) ++box;
            half = !half;
        } else if (half) {
            text.failAt(where, "E-ORDER", "the second triangle of the box has to follow");
        }
        if (!text.atEnd()) {
            text.space();
            cell.offset = readOffset(text, c);
        }
        text.finish();
        c.cells.push_back(cell);
    }
    text.begin("rows", {"t"});
    c.boxCount = box;
    if (half) text.failAt(text.mark(), "E-ORDER", "the second triangle of the box has to follow");
}

// The line `rows R` has been begun.
void readRows(Text& text, Certificate& c) {
    const std::uint32_t count = readCount(text);
    const std::uint64_t points = c.pointCount();
    for (std::uint32_t i = 0; i < count; ++i) {
        if (i == 0) text.begin("r", {"hanging"});
        else text.begin("r", {"hanging", "#"});
        Row row{};
        row.line = text.line();
        row.facet = none;
        row.side = '+';
        text.space();
        const char* start = text.mark();
        row.segment = text.indexBelow(c.segments.size(), "segment");
        text.space();
        const char* where = text.mark();
        row.count = text.index();
        if (!text.atEnd()) {
            text.space();
            row.facet = text.indexBelow(c.facets.size(), "facet");
            text.space();
            const char* sideMark = text.mark();
            const std::string_view side = text.word();
            if (side != "+" && side != "-") text.failAt(sideMark, "E-SYNTAX", "a side is `+` or `-`");
            row.side = side[0];
        }
        text.finish();
        if (row.count < 2) text.failAt(where, "E-VALUE", "a row has at least two points");
        // `none` + 1 is 0: the segment's own block comes first; '+' < '-' in ASCII.
        const auto key = [](const Row& r) { return std::tuple{r.segment, r.facet + 1, r.side}; };
        if (i > 0 && key(c.rows.back()) >= key(row)) text.failAt(start, "E-ORDER", "rows are not strictly increasing");
        row.first = c.rowPoints.size();
        for (std::uint32_t k = 0; k < row.count; ++k) {
            text.beginNumber({"r", "hanging"});
            c.rowPoints.push_back(text.indexBelow(points, "point"));
            text.finish();
        }
        c.rows.push_back(row);
    }
}

void readHanging(Text& text, Certificate& c) {
    text.begin("hanging", {"r", "#"});
    const std::uint32_t count = readCount(text);
    c.hangingLine = text.line() + 1;
    const std::uint64_t points = c.pointCount();
    for (std::uint32_t i = 0; i < count; ++i) {
        text.begin("h", {"evidence"});
        Subsegment part{};
        text.space();
        const char* where = text.mark();
        part.segment = text.indexBelow(c.segments.size(), "segment");
        text.space();
        part.a = text.indexBelow(points, "point");
        text.space();
        part.b = text.indexBelow(points, "point");
        text.finish();
        if (i > 0 && c.hanging.back().segment > part.segment) text.failAt(where, "E-ORDER", "segments are not increasing");
        c.hanging.push_back(part);
    }
}

void readEnd(Text& text, Certificate& c) {
    text.begin("end", {"c", "x"});
    c.endLine = text.line();
    c.digest = text.digestBeforeThisLine();
    for (const std::size_t count : {std::size_t{c.vertexCount}, c.segments.size(), c.facets.size(), c.steiner.size(),
                                    c.cells.size(), c.rows.size(), c.hanging.size()}) {
        text.space();
        const char* where = text.mark();
        if (text.index() != count) text.failAt(where, "E-COUNT", "differs from the count announced");
    }
    text.space();
    const char* where = text.mark();
    c.statedDigest = text.word();
    if (c.statedDigest.size() != 64 || !std::all_of(c.statedDigest.begin(), c.statedDigest.end(), [](char x) {
            return (x >= '0' && x <= '9') || (x >= 'a' && x <= 'f');
        }))
        text.failAt(where, "E-SYNTAX", "a digest has 64 hexadecimal digits in lower case");
    text.finish();
    text.expectEnd();
}

}  // namespace

void readCertificate(Certificate& c, const std::string& path, const std::string& complexPath, unsigned threads) {
    Text text(path, threads > 1);
    readFirstLine(text);
    readComplex(text, c, complexPath);
    readClaims(text, c.claims);
    readNotes(text);
    readParameters(text, c);
    readSteiner(text, c);
    readCells(text, c);
    readRows(text, c);
    readHanging(text, c);
    readEvidence(text, c);
    readEnd(text, c);
}
