// SPDX-License-Identifier: Apache-2.0
// L21: disjoint entities of the complex are far apart.
#include "lemmas.h"

namespace {

// Vertices, segments and (in dimension 3) facets under one numbering, in the order of their lines.
class Entities {
public:
    explicit Entities(const Certificate& certificate)
        : c(certificate), segments_(c.vertexCount), facets_(segments_ + static_cast<std::uint32_t>(c.segments.size())) {
        for (std::uint32_t v = 0; v < c.vertexCount; ++v) {
            places_.push_back(place(c, v));
            boxes.push_back(boxOf(c.points, {v}, v));
        }
        for (std::uint32_t s = 0; s < c.segments.size(); ++s) boxes.push_back(boxOf(c.points, {c.segments[s].first, c.segments[s].second}, segments_ + s));
        if (c.dimension == 3)
            for (std::uint32_t f = 0; f < c.facets.size(); ++f) {
                GridBox box = boxOf(c.points, {c.facets[f].corner[0]}, facets_ + f);
                for (std::size_t k = c.facetVertexFirst[f]; k < c.facetVertexFirst[f + 1]; ++k) box.add(c.points, c.facetVertices[k]);
                boxes.push_back(box);
            }
    }

    std::uint32_t objects() const { return facets_; }  // vertices and segments
    bool isVertex(std::uint32_t id) const { return id < segments_; }
    bool isFacet(std::uint32_t id) const { return id >= facets_; }
    std::uint32_t ofSegment(std::uint32_t s) const { return segments_ + s; }
    std::uint64_t line(std::uint32_t id) const {
        return isVertex(id) ? c.vertexLine + id : isFacet(id) ? c.facets[id - facets_].line : c.segmentLine + (id - segments_);
    }
    std::string name(std::uint32_t id) const {
        return isVertex(id) ? objectName("vertex", id) : isFacet(id) ? objectName("facet", id - facets_) : objectName("segment", id - segments_);
    }

    // The squared distance of a vertex or segment and another entity, if they are disjoint and it is bounded (section 2).
    std::optional<Rational> distance(std::uint32_t one, std::uint32_t two) const {
        if (one == two) return std::nullopt;
        if (isVertex(two) && !isVertex(one)) std::swap(one, two);
        if (isVertex(one)) {
            if (isVertex(two)) return (places_[two] - places_[one]) * (places_[two] - places_[one]);
            if (isFacet(two)) return vertexFacet(one, two - facets_);
            const Pair ends = c.segments[two - segments_];
            if (ends.first == one || ends.second == one) return std::nullopt;
            return distanceToSegment(places_[one], places_[ends.first], places_[ends.second]);
        }
        const Pair ends = c.segments[one - segments_];
        if (isFacet(two)) {
            const std::uint32_t f = two - facets_;
            if (c.vertexOccurs(f, ends.first) || c.vertexOccurs(f, ends.second) || !meets(places_[ends.first], places_[ends.second], f)) return std::nullopt;
            return Rational(0);
        }
        const Pair other = c.segments[two - segments_];
        if (ends.first == other.first || ends.first == other.second || ends.second == other.first || ends.second == other.second) return std::nullopt;
        return distanceOfSegments(places_[ends.first], places_[ends.second], places_[other.first], places_[other.second]);
    }

    std::vector<GridBox> boxes;

private:
    Place normal(std::uint32_t f) const {
        const Vec n = direction(c, f);
        return {n.x, n.y, n.z};
    }

    std::optional<Rational> vertexFacet(std::uint32_t v, std::uint32_t f) const {
        if (c.vertexOccurs(f, v)) return std::nullopt;
        const Place n = normal(f);
        const Rational height = n * (places_[v] - places_[c.facets[f].corner[0]]), nn = n * n;
        if (!inRegion(places_[v] - Rational(height / nn) * n, f)) return std::nullopt;
        return height * height / nn;
    }

    // Whether the segment p q has a point of the facet.
    bool meets(const Place& p, const Place& q, std::uint32_t f) const {
        const Place n = normal(f), origin = places_[c.facets[f].corner[0]];
        const Rational up = n * (p - origin), uq = n * (q - origin);
        if (sgn(up) == 0 && inRegion(p, f)) return true;
        if (sgn(uq) == 0 && inRegion(q, f)) return true;
        // What lies in the plane, with both ends beside the facet, meets the facet in a boundary edge first.
        return sgn(up) * sgn(uq) < 0 && inRegion(p + Rational(up / (up - uq)) * (q - p), f);
    }

    // Whether an odd number of boundary edges separate a point of the plane from infinity. On a boundary edge either answer
    // will do: that edge is a segment as near as the facet, and its line comes before the facet's.
    bool inRegion(const Place& x, std::uint32_t f) const {
        const Facet& facet = c.facets[f];
        const int drop = c.normalAxis[f];
        const auto first = [drop](const Place& p) -> const Rational& { return drop == 0 ? p.y : p.x; };
        const auto second = [drop](const Place& p) -> const Rational& { return drop == 2 ? p.y : p.z; };
        bool inside = false;
        for (std::size_t k = facet.boundary; k < facet.boundary + facet.boundaryCount; ++k) {
            const Place &a = places_[c.boundary[k].first], &b = places_[c.boundary[k].second];
            // Edges that cross the ray towards larger first coordinates; an end on the ray counts as below it.
            const bool rises = second(b) > second(x);
            if ((second(a) > second(x)) == rises) continue;
            // Whether x is to the left of a b.
            const bool left = (first(b) - first(a)) * (second(x) - second(a)) > (second(b) - second(a)) * (first(x) - first(a));
            if (left == rises) inside = !inside;
        }
        return inside;
    }

    const Certificate& c;
    const std::uint32_t segments_, facets_;  // the first number of each
    std::vector<Place> places_;
};

// One vertex or segment against all that is near.
struct FeatureVisitor {
    void visit(std::uint32_t other) {
        // With one radius for all, a pair of vertices or segments is looked at once.
        if (global && other < id) return;
        if (segmentsAndFacetsOnly && entities.isVertex(other)) return;
        const std::optional<Rational> d2 = entities.distance(id, other);
        if (!d2) return;
        if (*d2 < least) violating = std::min(violating, other);
        out.slack(rounded(Rational(*d2 / least - 1)), entities.line(std::max(id, other)), [&] { return name(other); });
    }
    Wide bound() const { return std::max(gap, scaledGap(gap, 1 + out.best())); }
    std::string name(std::uint32_t other) const { return objectName(entities.name(std::max(id, other)), entities.name(std::min(id, other))); }

    const Entities& entities;
    Findings& out;
    std::uint32_t id;
    bool global, segmentsAndFacetsOnly;
    Rational least;  // 9 r^2
    Wide gap;
    std::uint32_t violating = none;
};

}  // namespace

void testL21(const Instance& i, Findings& out) {
    const Entities entities(i.c);
    const BoxTree tree(entities.boxes);
    const bool local = i.p.local();
    const std::size_t count = local ? i.p.balls.size() + i.p.rows.size() : entities.objects();
    inParallel(count, i.check.threads, 16, [&] {
        return [&](std::size_t begin, std::size_t end) {
            for (std::size_t k = begin; k < end; ++k) {
                const bool isRow = local && k >= i.p.balls.size();
                const RowParameter* row = isRow ? &i.p.rows[k - i.p.balls.size()] : nullptr;
                const std::uint32_t id = isRow ? entities.ofSegment(row->segment) : local ? i.p.balls[k].vertex : static_cast<std::uint32_t>(k);
                const Rational& r = isRow ? row->offset : local ? i.p.balls[k].radius : i.p.r->value;
                const Rational least = 9 * r * r;
                FeatureVisitor visitor{entities, out, id, !local, isRow, least, gridSquare(i.c.points, least)};
                tree.search(entities.boxes[id], visitor);
                if (visitor.violating != none) out.failed(entities.line(std::max(id, visitor.violating)), visitor.name(visitor.violating));
            }
        };
    });
}
