// SPDX-License-Identifier: Apache-2.0
#include "shapes.h"

#include "frame.h"
#include "group.h"

#include <algorithm>
#include <tuple>

Shapes::Shapes(const Certificate& certificate) : c_(certificate), first_(c_.cells.size(), 0), boxNumber_(c_.cells.size(), none) {
    edges_.reserve(3 * c_.cells.size());
    for (std::uint32_t t = 0; t < c_.cells.size(); ++t)
        for (int i = 0; i < 3; ++i) edges_.push_back({c_.cells[t].corner[i], c_.cells[t].facet, c_.cells[t].corner[(i + 1) % 3], t});
    firstEdge_ = groupByKey(edges_, c_.pointCount(), [](const Edge& e) { return e.from; });
    const auto start = edges_.begin();
    for (std::size_t x = 0; x + 1 < firstEdge_.size(); ++x)
        std::sort(start + static_cast<std::ptrdiff_t>(firstEdge_[x]), start + static_cast<std::ptrdiff_t>(firstEdge_[x + 1]),
                  [](const Edge& a, const Edge& b) { return std::tie(a.facet, a.to, a.cell) < std::tie(b.facet, b.to, b.cell); });
}

std::uint32_t Shapes::cellAt(std::uint32_t facet, std::uint32_t from, std::uint32_t to) const {
    const auto last = edges_.begin() + static_cast<std::ptrdiff_t>(firstEdge_[from + 1]);
    const auto found = std::lower_bound(edges_.begin() + static_cast<std::ptrdiff_t>(firstEdge_[from]), last, std::tie(facet, to),
                                        [](const Edge& e, const auto& wanted) { return std::tie(e.facet, e.to) < wanted; });
    return found != last && found->facet == facet && found->to == to ? found->cell : none;
}

// The segment that carries x, if one does. (By rule `cell` a corner's segment belongs to the cell's facet.)
std::uint32_t Shapes::segmentOf(std::uint32_t x) const {
    return x < c_.vertexCount || !onSegment(kindOf(x)) ? none : c_.steiner[x - c_.vertexCount].carrier;
}

bool Shapes::beginAtVertex(std::size_t t) {
    const auto& corners = c_.cells[t].corner;
    const auto vertex = std::find_if(std::begin(corners), std::end(corners), [this](std::uint32_t x) { return x < c_.vertexCount; });
    first_[t] = static_cast<std::uint8_t>(vertex - std::begin(corners));
    return vertex != std::end(corners);
}

bool Shapes::triangle(std::size_t t) {
    if (!beginAtVertex(t)) return false;
    const std::uint32_t v = corner(t, 0), one = corner(t, 1), two = corner(t, 2);
    const std::uint32_t m = isSteiner(one, PointKind::projection) ? one : two, a = m == one ? two : one;
    if (!isSteiner(m, PointKind::projection) || !isSteiner(a, PointKind::offset)) return false;
    const Pair ends = c_.segments[segmentOf(m)];
    if (ends.first != v && ends.second != v) return false;
    const Frame f(c_, {m, v, a});
    return sgn(Whole(f[1] * f[2])) == 0;
}

bool Shapes::spoke(std::size_t t) {
    const auto rim = [this](std::uint32_t x) { return isSteiner(x, PointKind::arc) || isSteiner(x, PointKind::offset); };
    return beginAtVertex(t) && rim(corner(t, 1)) && rim(corner(t, 2));
}

// t is the first cell of a box. By rule `box` each of its two cells has one corner that the other one has not.
bool Shapes::rectangle(std::size_t t) {
    const Cell &cell = c_.cells[t], &half = c_.cells[t + 1];
    const auto lacks = [](const Cell& other, std::uint32_t x) { return std::find(std::begin(other.corner), std::end(other.corner), x) == std::end(other.corner); };
    std::uint32_t ring[4] = {};  // in cyclic order
    for (int i = 0; i < 3; ++i)
        if (lacks(half, cell.corner[i])) {
            ring[0] = cell.corner[i];
            ring[1] = cell.corner[(i + 1) % 3];
            ring[3] = cell.corner[(i + 2) % 3];
        }
    for (const std::uint32_t x : half.corner)
        if (lacks(cell, x)) ring[2] = x;
    for (int i = 0; i < 4; ++i) {
        Box box{static_cast<std::uint32_t>(t), {}};
        for (int k = 0; k < 4; ++k) box.corner[k] = ring[(i + k) % 4];
        const std::uint32_t segment = segmentOf(box.corner[0]);
        if (segment == none || segmentOf(box.corner[1]) != segment || !isSteiner(box.corner[2], PointKind::offset) ||
            !isSteiner(box.corner[3], PointKind::offset))
            continue;
        boxNumber_[t] = boxNumber_[t + 1] = static_cast<std::uint32_t>(boxes.size());
        boxes.push_back(box);
        return true;
    }
    return false;
}

bool Shapes::ordinary(std::size_t t) const {
    return std::all_of(std::begin(c_.cells[t].corner), std::end(c_.cells[t].corner), [this](std::uint32_t x) {
        return isSteiner(x, PointKind::arc) || isSteiner(x, PointKind::offset) || isSteiner(x, PointKind::interior);
    });
}

bool Shapes::isOfItsKind(std::size_t t) {
    switch (c_.cells[t].kind) {
        case 'T': return triangle(t);
        case 'S': return spoke(t);
        case 'R': return boxNumber_[t] != none || rectangle(t);
        default: return ordinary(t);
    }
}

std::optional<Violation> Shapes::test(bool fans) {
    Earliest earliest;
    for (std::size_t t = 0; t < c_.cells.size(); ++t) {
        const Cell& cell = c_.cells[t];
        if (!isOfItsKind(t)) return Violation{c_.cellLine + t, objectName("cell", t, "kind")};
        if (cell.offset != none) return Violation{c_.cellLine + t, objectName("cell", t, "offset")};
    }
    if (fans) findFans(earliest);
    return earliest.result();
}

// Every cell of a fan is followed by one with the edge from v to its last corner; ends are kept, so that no cell is passed twice.
void Shapes::findFans(Earliest& earliest) {
    constexpr std::uint32_t unknown = none - 1;
    closing_.assign(c_.cells.size(), unknown);
    std::vector<std::uint32_t> path;
    for (std::uint32_t start = 0; start < c_.cells.size(); ++start) {
        if (!opens(start)) continue;
        path.clear();
        std::uint32_t t = start, end = none;
        for (;;) {
            if (c_.cells[t].kind == 'T' && t != start) {
                if (!opens(t)) end = t;
                break;
            }
            if (closing_[t] != unknown) {
                end = closing_[t];
                break;
            }
            closing_[t] = none;  // met again: the S cells go round in a circle
            path.push_back(t);
            const std::uint32_t next = cellAt(c_.cells[t].facet, corner(t, 0), corner(t, 2));
            if (next == none) break;  // a cell with v as a corner is an S or T cell, and v is its only vertex
            t = next;
        }
        for (const std::uint32_t passed : path) closing_[passed] = end;
        if (end == none) earliest.offer(c_.cellLine + start, objectName("cell", start, "fan"));
    }
}

void Shapes::findOutline() {
    for (std::uint32_t t = 0; t < c_.cells.size(); ++t) {
        if (c_.cells[t].kind != 'C') continue;
        const Cell& cell = c_.cells[t];
        for (int i = 0; i < 3; ++i) {
            const std::uint32_t a = cell.corner[i], b = cell.corner[(i + 1) % 3], other = cellAt(cell.facet, b, a);
            if (other == none || c_.cells[other].kind == 'C') continue;
            std::uint32_t y = none;
            for (const std::uint32_t corner : c_.cells[other].corner)
                if (corner != a && corner != b) y = corner;
            outline.push_back({t, other, a, b, cell.corner[(i + 2) % 3], y});
        }
    }
}

std::optional<Violation> ruleKinds(Check& check) {
    const Certificate& c = check.certificate;
    check.shapes = std::make_shared<Shapes>(c);
    const auto violation = check.shapes->test(!c.claims.refutation);
    if (!violation) check.shapes->findOutline();
    return violation;
}
