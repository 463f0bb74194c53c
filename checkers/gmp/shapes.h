// SPDX-License-Identifier: Apache-2.0
// What the kinds of cells mean (docs/lemma-claims.md, section 2): found by rule `kinds`.
#pragma once

#include "rules.h"

struct Box {
    std::uint32_t cell;       // the first of its two cells
    std::uint32_t corner[4];  // in cyclic order; 0 and 1 are the ends of the long side
};

struct OutlineEdge {
    std::uint32_t cell, other;  // the C cell, and the one of another kind
    std::uint32_t a, b;         // from a to b in the C cell
    std::uint32_t x, y;         // the opposite corners of `cell` and `other`
};

class Shapes {
public:
    explicit Shapes(const Certificate& certificate);

    // Corner i of a T or S cell, counter-clockwise from its vertex v = corner(t, 0).
    std::uint32_t corner(std::size_t t, int i) const { return c_.cells[t].corner[(first_[t] + i) % 3]; }
    bool opens(std::size_t t) const { return c_.cells[t].kind == 'T' && onSegment(kindOf(corner(t, 1))); }
    std::uint32_t foot(std::size_t t) const { return corner(t, opens(t) ? 1 : 2); }  // m of a T cell
    std::uint32_t tip(std::size_t t) const { return corner(t, opens(t) ? 2 : 1); }   // a of a T cell
    const Box& boxOf(std::size_t t) const { return boxes[boxNumber_[t]]; }
    // The cell of the facet with this directed edge (the first of several); else none.
    std::uint32_t cellAt(std::uint32_t facet, std::uint32_t from, std::uint32_t to) const;
    // The closing cell of the fan of an opening cell.
    std::uint32_t closing(std::size_t t) const { return closing_[t]; }
    void findOutline();

    std::optional<Violation> test(bool fans);

    std::vector<Box> boxes;
    std::vector<OutlineEdge> outline;

private:
    struct Edge {
        std::uint32_t from, facet, to, cell;
    };
    PointKind kindOf(std::uint32_t x) const { return c_.steiner[x - c_.vertexCount].kind; }
    bool isSteiner(std::uint32_t x, PointKind kind) const { return x >= c_.vertexCount && kindOf(x) == kind; }
    bool isOfItsKind(std::size_t t);
    bool beginAtVertex(std::size_t t);  // of a T or S cell; false: there is none
    bool triangle(std::size_t t);
    bool spoke(std::size_t t);
    bool rectangle(std::size_t t);
    bool ordinary(std::size_t t) const;
    std::uint32_t segmentOf(std::uint32_t x) const;
    void findFans(Earliest& earliest);

    const Certificate& c_;
    std::vector<std::uint8_t> first_;
    std::vector<std::uint32_t> boxNumber_, closing_;
    std::vector<Edge> edges_;            // by first point, facet, second point and cell
    std::vector<std::size_t> firstEdge_;  // of each first point
};

std::optional<Violation> ruleKinds(Check&);
