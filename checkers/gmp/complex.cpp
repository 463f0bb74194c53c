// SPDX-License-Identifier: Apache-2.0
// Rules `hash` and `complex`, and look-ups in the complex.
#include "filter.h"
#include "rules.h"

#include <algorithm>
#include <unordered_map>

std::uint32_t Certificate::findSegment(std::uint32_t a, std::uint32_t b) const {
    const Pair wanted{std::min(a, b), std::max(a, b)};
    const auto found = std::lower_bound(segments.begin(), segments.end(), wanted);
    return found != segments.end() && *found == wanted ? static_cast<std::uint32_t>(found - segments.begin()) : none;
}

std::uint32_t Certificate::segmentThrough(std::uint32_t p, std::uint32_t q) const {
    const auto carrier = [this](std::uint32_t x) {
        return x >= vertexCount && onSegment(steiner[x - vertexCount].kind) ? steiner[x - vertexCount].carrier : none;
    };
    if (p < vertexCount && q < vertexCount) return findSegment(p, q);
    const std::uint32_t segment = p >= vertexCount ? carrier(p) : carrier(q);
    if (segment == none) return none;
    const auto lies = [&](std::uint32_t x) {
        return x < vertexCount ? segments[segment].first == x || segments[segment].second == x : carrier(x) == segment;
    };
    return lies(p) && lies(q) ? segment : none;
}

std::uint32_t Certificate::findBoundary(std::uint32_t facet, std::uint32_t a, std::uint32_t c) const {
    const auto first = boundary.begin() + static_cast<std::ptrdiff_t>(facets[facet].boundary);
    const auto last = first + facets[facet].boundaryCount;
    const auto found = std::lower_bound(first, last, Pair{a, c});
    return found != last && *found == Pair{a, c} ? static_cast<std::uint32_t>(found - first) : none;
}

char Certificate::role(std::uint32_t facet, std::uint32_t segment) const {
    const Pair ends = segments[segment];
    if (findBoundary(facet, ends.first, ends.second) != none) return '+';
    if (findBoundary(facet, ends.second, ends.first) != none) return '-';
    const auto first = inner.begin() + static_cast<std::ptrdiff_t>(facets[facet].inner);
    return std::binary_search(first, first + facets[facet].innerCount, ends) ? 'c' : 0;
}

bool Certificate::vertexOccurs(std::uint32_t facet, std::uint32_t vertex) const {
    const auto first = facetVertices.begin();
    return std::binary_search(first + static_cast<std::ptrdiff_t>(facetVertexFirst[facet]),
                              first + static_cast<std::ptrdiff_t>(facetVertexFirst[facet + 1]), vertex);
}

std::optional<Violation> ruleHash(Check& check) {
    const Certificate& c = check.certificate;
    if (c.digest != c.statedDigest) return Violation{c.endLine, "digest"};
    return std::nullopt;
}

namespace {

class ComplexRule {
public:
    explicit ComplexRule(Certificate& certificate) : c(certificate) {}

    std::optional<Violation> run() {
        if (c.differenceLine != 0) earliest.offer(c.differenceLine, "other-complex");
        c.segmentUsed.assign(c.segments.size(), false);
        c.facetVertexFirst.push_back(0);
        for (std::uint32_t f = 0; f < c.facets.size(); ++f) {
            collectVertices(f);
            checkPlane(f);
            checkEdges(f);
            checkIsolated(f);
        }
        if (const auto violation = earliest.result()) return violation;
        assignPlanes();
        return std::nullopt;
    }

private:
    void collectVertices(std::uint32_t f) {
        const Facet& facet = c.facets[f];
        occurring.clear();
        starts.clear();
        ends.clear();
        for (std::size_t i = 0; i < facet.boundaryCount; ++i) {
            starts.push_back(c.boundary[facet.boundary + i].first);
            ends.push_back(c.boundary[facet.boundary + i].second);
        }
        occurring = starts;
        occurring.insert(occurring.end(), ends.begin(), ends.end());
        for (std::size_t i = 0; i < facet.innerCount; ++i) {
            occurring.push_back(c.inner[facet.inner + i].first);
            occurring.push_back(c.inner[facet.inner + i].second);
        }
        tied = occurring;
        std::sort(tied.begin(), tied.end());
        for (std::size_t i = 0; i < facet.isolatedCount; ++i) occurring.push_back(c.isolated[facet.isolated + i]);
        std::sort(occurring.begin(), occurring.end());
        occurring.erase(std::unique(occurring.begin(), occurring.end()), occurring.end());
        c.facetVertices.insert(c.facetVertices.end(), occurring.begin(), occurring.end());
        c.facetVertexFirst.push_back(c.facetVertices.size());
    }

    // The three vertices, and every vertex of the facet in their plane.
    void checkPlane(std::uint32_t f) {
        const Facet& facet = c.facets[f];
        for (const std::uint32_t vertex : facet.corner)
            if (!c.vertexOccurs(f, vertex)) earliest.offer(facet.line, objectName("facet", f, "vertex", vertex));
        const std::uint32_t origin = facet.corner[0];
        c.points.difference(u, facet.corner[1], origin);
        c.points.difference(w, facet.corner[2], origin);
        cross(normal, u, w);
        int axis = 0;
        while (axis < 3 && sign(normal[axis]) == 0) ++axis;
        if (axis == 3) {
            earliest.offer(facet.line, objectName("facet", f, "collinear"));
            axis = 0;
        }
        if (c.dimension == 2 && sign(normal[2]) < 0) earliest.offer(facet.line, objectName("facet", f, "clockwise"));
        c.normalAxis.push_back(static_cast<std::int8_t>(axis));
        c.normalSign.push_back(static_cast<std::int8_t>(sign(normal[axis])));
        for (int i = 0; i < 3; ++i) c.normals.append(normal[i]);
        if (!c.points.hasCommon()) {
            c.points.differenceScale(scale, facet.corner[1], origin);
            c.points.differenceScale(value, facet.corner[2], origin);
            mpz_mul(scale, scale, value);
            c.normalScales.append(scale);
        }
        mpz_gcd(value, normal[0], normal[1]);
        mpz_gcd(value, value, normal[2]);
        if (sign(value) != 0)
            for (int i = 0; i < 3; ++i) mpz_divexact(normal[i], normal[i], value);
        for (int i = 0; i < 3; ++i) c.directions.append(normal[i]);
        outside.clear();
        for (const std::uint32_t vertex : occurring) {
            c.points.difference(w, vertex, origin);
            dot(value, normal, w);
            if (sign(value) != 0) outside.push_back(vertex);
        }
        // The record at fault is the first one that names a vertex outside the plane.
        const auto isOutside = [this](std::uint32_t v) { return std::binary_search(outside.begin(), outside.end(), v); };
        const auto offer = [&](std::uint64_t line, std::uint32_t v) {
            if (isOutside(v)) earliest.offer(line, objectName("facet", f, "vertex", v));
        };
        for (std::size_t i = 0; i < facet.boundaryCount; ++i) {
            offer(facet.boundaryLine() + i, c.boundary[facet.boundary + i].first);
            offer(facet.boundaryLine() + i, c.boundary[facet.boundary + i].second);
        }
        for (std::size_t i = 0; i < facet.innerCount; ++i) {
            offer(facet.innerLine() + i, c.inner[facet.inner + i].first);
            offer(facet.innerLine() + i, c.inner[facet.inner + i].second);
        }
        for (std::size_t i = 0; i < facet.isolatedCount; ++i) offer(facet.isolatedLine() + i, c.isolated[facet.isolated + i]);
    }

    void checkEdges(std::uint32_t f) {
        const Facet& facet = c.facets[f];
        std::sort(starts.begin(), starts.end());
        std::sort(ends.begin(), ends.end());
        const auto count = [](const std::vector<std::uint32_t>& sorted, std::uint32_t v) {
            const auto range = std::equal_range(sorted.begin(), sorted.end(), v);
            return range.second - range.first;
        };
        for (std::size_t i = 0; i < facet.boundaryCount; ++i) {
            const auto [a, b] = c.boundary[facet.boundary + i];
            const std::uint64_t line = facet.boundaryLine() + i;
            const std::uint32_t segment = a == b ? none : c.findSegment(a, b);
            if (segment == none) {
                earliest.offer(line, objectName("facet", f, "edge", a, b, "no-segment"));
            } else {
                c.segmentUsed[segment] = true;
                const std::uint32_t opposite = c.findBoundary(f, b, a);
                if (opposite != none && opposite < i) earliest.offer(line, objectName("facet", f, "edge", a, b, "both-directions"));
            }
            for (const std::uint32_t v : {a, b})
                if (count(starts, v) != count(ends, v)) earliest.offer(line, objectName("facet", f, "vertex", v, "unbalanced"));
        }
        for (std::size_t i = 0; i < facet.innerCount; ++i) {
            const auto [a, b] = c.inner[facet.inner + i];
            const std::uint64_t line = facet.innerLine() + i;
            const std::uint32_t segment = c.findSegment(a, b);
            if (segment == none) earliest.offer(line, objectName("facet", f, "constraint", a, b, "no-segment"));
            else c.segmentUsed[segment] = true;
            if (c.findBoundary(f, a, b) != none || c.findBoundary(f, b, a) != none)
                earliest.offer(line, objectName("facet", f, "constraint", a, b, "on-boundary"));
        }
    }

    void checkIsolated(std::uint32_t f) {
        const Facet& facet = c.facets[f];
        for (std::size_t i = 0; i < facet.isolatedCount; ++i) {
            const std::uint32_t v = c.isolated[facet.isolated + i];
            if (std::binary_search(tied.begin(), tied.end(), v))
                earliest.offer(facet.isolatedLine() + i, objectName("facet", f, "vertex", v, "not-isolated"));
        }
    }

    // Gives facets in one plane one number, and each point the plane of its facets if that is one.
    void assignPlanes() {
        std::unordered_map<std::string, std::uint32_t> planes;
        std::vector<std::uint32_t> segmentPlane(c.segments.size(), none);
        std::vector<bool> segmentMixed(c.segments.size(), false), pointMixed(c.pointCount(), false);
        c.pointPlane.assign(c.pointCount(), none);
        const auto join = [](std::vector<std::uint32_t>& plane, std::vector<bool>& mixed, std::uint32_t i, std::uint32_t p) {
            if (mixed[i]) return;
            if (plane[i] == none) plane[i] = p;
            else if (plane[i] != p) {
                plane[i] = none;
                mixed[i] = true;
            }
        };
        for (std::uint32_t f = 0; f < c.facets.size(); ++f) {
            const Facet& facet = c.facets[f];
            const std::uint32_t p = planes.try_emplace(planeKey(f), static_cast<std::uint32_t>(planes.size())).first->second;
            c.facetPlane.push_back(p);
            for (std::size_t i = c.facetVertexFirst[f]; i < c.facetVertexFirst[f + 1]; ++i) join(c.pointPlane, pointMixed, c.facetVertices[i], p);
            for (std::size_t i = 0; i < facet.boundaryCount; ++i) {
                const auto [a, b] = c.boundary[facet.boundary + i];
                join(segmentPlane, segmentMixed, c.findSegment(a, b), p);
            }
            for (std::size_t i = 0; i < facet.innerCount; ++i) {
                const auto [a, b] = c.inner[facet.inner + i];
                join(segmentPlane, segmentMixed, c.findSegment(a, b), p);
            }
        }
        for (std::uint32_t i = 0; i < c.steiner.size(); ++i) {
            const Steiner& point = c.steiner[i];
            c.pointPlane[c.vertexCount + i] = onSegment(point.kind) ? segmentPlane[point.carrier] : c.facetPlane[point.carrier];
        }
    }

    std::string planeKey(std::uint32_t f) {
        const std::uint32_t origin = c.facets[f].corner[0];
        const int orientation = c.normalSign[f];
        mpz_set_ui(value, 0);
        for (int i = 0; i < 3; ++i) {
            mpz_set(normal[i], View(c.directions, 3 * std::size_t{f} + static_cast<std::size_t>(i)));
            if (orientation < 0) mpz_neg(normal[i], normal[i]);
            mpz_addmul(value, normal[i], c.points.coordinate(origin, i));
        }
        mpz_set_ui(scale, 1);
        if (!c.points.hasCommon()) {
            mpz_set(scale, c.points.weight(origin));
            mpz_gcd(divisor, scale, value);
            mpz_divexact(scale, scale, divisor);
            mpz_divexact(value, value, divisor);
        }
        std::string key;
        for (const mpz_srcptr part : {mpz_srcptr(normal[0]), mpz_srcptr(normal[1]), mpz_srcptr(normal[2]), mpz_srcptr(value), mpz_srcptr(scale)}) {
            key += Whole(part).get_str(62);
            key += ' ';
        }
        return key;
    }

    Certificate& c;
    Earliest earliest;
    std::vector<std::uint32_t> occurring, starts, ends, tied, outside;
    Vector u, w, normal;
    Integer value, scale, divisor;
};

}  // namespace

std::optional<Violation> ruleComplex(Check& check) {
    check.certificate.points.prepare();
    auto violation = ComplexRule(check.certificate).run();
    if (!violation && !check.exact) check.floatNormals = std::make_shared<FloatNormals>(check.certificate);
    return violation;
}
