// SPDX-License-Identifier: Apache-2.0
// Rule `tiling`.
#include "group.h"
#include "rules.h"

#include <algorithm>
#include <span>
#include <tuple>

namespace {

struct DirectedEdge {
    std::uint32_t low, high, cell;
    bool reversed;  // from high to low
    bool sameLine(const DirectedEdge& other) const { return low == other.low && high == other.high; }
    bool operator<(const DirectedEdge& other) const {
        if (low != other.low) return low < other.low;
        if (high != other.high) return high < other.high;
        return reversed != other.reversed ? other.reversed : cell < other.cell;
    }
};

struct ChainLink {
    std::uint32_t boundary, from, to;  // positions along the directed boundary edge
    std::uint32_t cell;
    bool operator<(const ChainLink& other) const {
        return std::tie(boundary, from, to, cell) < std::tie(other.boundary, other.from, other.to, other.cell);
    }
};

class FacetTiling {
public:
    FacetTiling(const Certificate& certificate, Earliest& violations) : c(certificate), earliest(violations) {}

    // `edges` are those of the facet's cells, by their lower end.
    void check(std::uint32_t f, std::span<DirectedEdge> edgesOfFacet) {
        const Facet& facet = c.facets[f];
        edges = edgesOfFacet;
        if (edges.empty()) earliest.offer(facet.line, objectName("facet", f, "no-cell"));
        for (std::size_t i = 0; i < edges.size();) {
            std::size_t end = i + 1;
            while (end < edges.size() && edges[end].low == edges[i].low) ++end;
            std::sort(edges.begin() + static_cast<std::ptrdiff_t>(i), edges.begin() + static_cast<std::ptrdiff_t>(end));
            i = end;
        }
        chains(f);
        for (std::size_t i = 0; i < facet.innerCount; ++i) {
            const auto [a, b] = c.inner[facet.inner + i];
            const std::uint32_t segment = c.findSegment(a, b);
            std::uint32_t from = a;
            for (std::size_t k = c.carriedFirst[segment]; k <= c.carriedFirst[segment + 1]; ++k) {
                const std::uint32_t to = k < c.carriedFirst[segment + 1] ? c.carried[k] : b;
                if (!hasEdge(from, to)) {
                    earliest.offer(facet.innerLine() + i, objectName("facet", f, "constraint", a, b, "edge", from, to));
                    break;
                }
                from = to;
            }
        }
        if (facet.isolatedCount == 0) return;
        corners.clear();
        for (const DirectedEdge& edge : edges) {
            corners.push_back(edge.low);
            corners.push_back(edge.high);
        }
        std::sort(corners.begin(), corners.end());
        for (std::size_t i = 0; i < facet.isolatedCount; ++i) {
            const std::uint32_t v = c.isolated[facet.isolated + i];
            if (!std::binary_search(corners.begin(), corners.end(), v))
                earliest.offer(facet.isolatedLine() + i, objectName("facet", f, "vertex", v, "in-no-cell"));
        }
    }

private:
    bool hasEdge(std::uint32_t a, std::uint32_t b) const {
        const DirectedEdge wanted{std::min(a, b), std::max(a, b), 0, false};
        const auto found = std::lower_bound(edges.begin(), edges.end(), wanted);
        return found != edges.end() && found->sameLine(wanted);
    }

    // Position of a point on a segment, directed as the boundary edge; 0 for its start.
    std::uint32_t position(std::uint32_t point, std::uint32_t segment, bool forward) const {
        const std::uint32_t last = c.carriedCount(segment) + 1;
        std::uint32_t place = last;
        if (point >= c.vertexCount) place = c.rank[point - c.vertexCount] + 1;
        else if (point == c.segments[segment].first) place = 0;
        return forward ? place : last - place;
    }

    // What is left after removing opposite pairs has to be one chain per boundary edge.
    void chains(std::uint32_t f) {
        links.clear();
        for (std::size_t i = 0; i < edges.size();) {
            std::size_t end = i + 1;
            while (end < edges.size() && edges[end].sameLine(edges[i])) ++end;
            std::size_t forward = 0;
            for (std::size_t k = i; k < end; ++k) {
                if (k > i && edges[k].reversed == edges[k - 1].reversed) offerEdge(edges[k], "twice");
                if (!edges[k].reversed) ++forward;
            }
            if (2 * forward != end - i) leftOver(f, edges[2 * forward > end - i ? i + forward - 1 : end - 1]);
            i = end;
        }
        std::sort(links.begin(), links.end());
        const Facet& facet = c.facets[f];
        std::size_t next = 0;
        for (std::uint32_t i = 0; i < facet.boundaryCount; ++i) {
            const auto [a, b] = c.boundary[facet.boundary + i];
            const std::uint32_t last = c.carriedCount(c.findSegment(a, b)) + 1;
            std::uint32_t reached = 0;
            bool good = true;
            for (; next < links.size() && links[next].boundary == i; ++next) {
                good = good && links[next].from == reached;
                reached = links[next].to;
            }
            if (!good || reached != last) earliest.offer(facet.boundaryLine() + i, objectName("facet", f, "edge", a, b));
        }
    }

    void leftOver(std::uint32_t f, const DirectedEdge& edge) {
        const std::uint32_t from = edge.reversed ? edge.high : edge.low, to = edge.reversed ? edge.low : edge.high;
        const std::uint32_t segment = c.segmentThrough(from, to);
        const char role = segment == none ? char{0} : c.role(f, segment);
        if (role != '+' && role != '-') return offerEdge(edge, "open");
        const bool forward = role == '+';
        const Pair ends = c.segments[segment];
        const std::uint32_t boundary = forward ? c.findBoundary(f, ends.first, ends.second) : c.findBoundary(f, ends.second, ends.first);
        const std::uint32_t start = position(from, segment, forward), stop = position(to, segment, forward);
        if (start >= stop) return offerEdge(edge, "backward");
        links.push_back({boundary, start, stop, edge.cell});
    }

    void offerEdge(const DirectedEdge& edge, const char* fault) {
        const std::uint32_t from = edge.reversed ? edge.high : edge.low, to = edge.reversed ? edge.low : edge.high;
        earliest.offer(c.cellLine + edge.cell, objectName("cell", edge.cell, "edge", from, to, fault));
    }

    const Certificate& c;
    Earliest& earliest;
    std::span<DirectedEdge> edges;
    std::vector<ChainLink> links;
    std::vector<std::uint32_t> corners;
};

}  // namespace

std::optional<Violation> ruleTiling(Check& check) {
    const Certificate& c = check.certificate;
    std::vector<DirectedEdge> edges;
    edges.reserve(3 * c.cells.size());
    for (std::uint32_t t = 0; t < c.cells.size(); ++t)
        for (int k = 0; k < 3; ++k) {
            const std::uint32_t a = c.cells[t].corner[k], b = c.cells[t].corner[(k + 1) % 3];
            edges.push_back({std::min(a, b), std::max(a, b), t, a > b});
        }
    groupByKey(edges, c.pointCount(), [](const DirectedEdge& e) { return e.low; });
    const std::vector<std::size_t> first = groupByKey(edges, c.facets.size(), [&c](const DirectedEdge& e) { return c.cells[e.cell].facet; });
    Earliest earliest;
    inParallel(c.facets.size(), check.threads, 1, [&] {
        return [&, tiling = FacetTiling(c, earliest)](std::size_t begin, std::size_t end) mutable {
            for (std::size_t f = begin; f < end; ++f)
                tiling.check(static_cast<std::uint32_t>(f), std::span(edges).subspan(first[f], first[f + 1] - first[f]));
        };
    });
    return earliest.result();
}
