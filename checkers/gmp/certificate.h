// SPDX-License-Identifier: Apache-2.0
// What a certificate says, as read; and what is derived from it, rule by rule.
#pragma once

#include "claims.h"
#include "points.h"

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

constexpr std::uint32_t none = 0xffffffffu;

using Pair = std::pair<std::uint32_t, std::uint32_t>;

enum class PointKind : std::uint8_t { projection, edge, offset, arc, interior };
inline bool onSegment(PointKind kind) { return kind == PointKind::projection || kind == PointKind::edge; }

struct Facet {
    std::uint32_t corner[3];
    std::uint64_t line;
    std::size_t boundary, inner, isolated;                       // first of each in the shared arrays
    std::uint32_t boundaryCount, innerCount, isolatedCount;
    std::uint64_t boundaryLine() const { return line + 2; }      // lines of the first records
    std::uint64_t innerLine() const { return line + 3 + boundaryCount; }
    std::uint64_t isolatedLine() const { return line + 4 + boundaryCount + innerCount; }
};

struct Steiner {
    PointKind kind;
    std::uint32_t carrier;
};

struct Cell {
    std::uint32_t facet;
    std::uint32_t corner[3];
    std::uint32_t offset;  // index of the offset, or none
    char kind;
};

struct Row {
    std::uint32_t segment, facet;  // facet none: the row of the segment itself
    char side;
    std::uint64_t line;
    std::size_t first;
    std::uint32_t count;
};

struct Subsegment { std::uint32_t segment, a, b; };

struct Certificate {
    // As read.
    int dimension = 3;
    std::uint32_t vertexCount = 0;
    std::uint64_t vertexLine = 0, segmentLine = 0, steinerLine = 0, cellLine = 0, hangingLine = 0, endLine = 0;
    Points points;
    std::vector<Pair> segments;
    std::vector<Facet> facets;
    std::vector<Pair> boundary, inner;
    std::vector<std::uint32_t> isolated;
    std::vector<Steiner> steiner;
    std::vector<Cell> cells;
    std::uint64_t boxCount = 0;
    IntegerStore offsets;  // numerator, denominator, ...
    std::vector<Row> rows;
    std::vector<std::uint32_t> rowPoints;
    std::vector<Subsegment> hanging;
    Claims claims;
    std::string complexDigest, statedDigest, digest;
    std::uint64_t differenceLine = 0;  // of the complex and the one given by --complex

    // Derived by rule `complex`.
    std::vector<std::size_t> facetVertexFirst;      // sorted vertices of each facet
    std::vector<std::uint32_t> facetVertices;
    IntegerStore normals;                           // n of each facet times a positive number: 3 each
    IntegerStore normalScales;                      // that number (see normalScale in complex.cpp), only without a common denominator
    IntegerStore directions;                        // n divided by the greatest common divisor: 3 each
    std::vector<std::int8_t> normalAxis;            // an axis along which n is not zero
    std::vector<std::int8_t> normalSign;            // the sign of n there
    std::vector<std::uint32_t> facetPlane;          // facets in one plane have one number
    std::vector<std::uint32_t> pointPlane;          // the one plane in which a point's facets lie, else none
    std::vector<bool> segmentUsed;                  // in some facet
    bool coplanar = false;                          // all points in one plane (dimension 3)
    // Derived by rule `carrier`.
    std::vector<std::size_t> carriedFirst;          // points carried by each segment, in order
    std::vector<std::uint32_t> carried;
    std::vector<std::uint32_t> rank;                // of a Steiner point among those of its segment

    std::uint32_t pointCount() const { return static_cast<std::uint32_t>(vertexCount + steiner.size()); }
    std::uint64_t pointLine(std::uint32_t p) const { return p < vertexCount ? vertexLine + p : steinerLine + (p - vertexCount); }
    std::uint32_t findSegment(std::uint32_t a, std::uint32_t b) const;
    // The segment on which both points lie, as vertices or carried; else none.
    std::uint32_t segmentThrough(std::uint32_t p, std::uint32_t q) const;
    // How a segment belongs to a facet: '+' boundary edge from first to second vertex, '-' the other way, 'c' inner constraint, 0 not.
    char role(std::uint32_t facet, std::uint32_t segment) const;
    std::uint32_t findBoundary(std::uint32_t facet, std::uint32_t a, std::uint32_t c) const;
    bool vertexOccurs(std::uint32_t facet, std::uint32_t vertex) const;
    std::uint32_t carriedCount(std::uint32_t segment) const { return static_cast<std::uint32_t>(carriedFirst[segment + 1] - carriedFirst[segment]); }
};

void readCertificate(Certificate&, const std::string& path, const std::string& complexPath, unsigned threads);
