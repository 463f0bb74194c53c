// SPDX-License-Identifier: Apache-2.0
// Rules `distinct`, `carrier`, `cell` and `box`.
#include "filter.h"
#include "rules.h"

#include <algorithm>
#include <numeric>

std::optional<Violation> ruleDistinct(Check& check) {
    const Points& points = check.certificate.points;
    std::vector<std::pair<std::uint64_t, std::uint32_t>> order(points.size());
    for (std::uint32_t p = 0; p < order.size(); ++p) order[p] = {points.hash(p), p};
    std::sort(order.begin(), order.end());
    // Points of one hash value are ordered by exact comparison: no input makes this slow.
    std::uint32_t later = none, earlier = none;
    for (std::size_t first = 0; first < order.size();) {
        std::size_t last = first + 1;
        while (last < order.size() && order[last].first == order[first].first) ++last;
        if (last - first > 1) {
            std::sort(order.begin() + static_cast<std::ptrdiff_t>(first), order.begin() + static_cast<std::ptrdiff_t>(last),
                      [&points](const auto& a, const auto& b) {
                          for (int axis = 0; axis < (points.hasCommon() ? 3 : 4); ++axis) {
                              const int order = mpz_cmp(points.coordinate(a.second, axis), points.coordinate(b.second, axis));
                              if (order != 0) return order < 0;
                          }
                          return a.second < b.second;
                      });
            for (std::size_t i = first + 1, start = first; i < last; ++i) {
                if (!points.equal(order[i].second, order[start].second)) start = i;
                else if (order[i].second < later) {
                    later = order[i].second;
                    earlier = order[start].second;
                }
            }
        }
        first = last;
    }
    if (later == none) return std::nullopt;
    return Violation{check.certificate.pointLine(later), objectName("point", later, "point", earlier)};
}

namespace {

struct PlaneTest {
    // n.(x - p), p in the plane of the facet.
    int side(const Certificate& c, std::uint32_t facet, std::uint32_t x) {
        c.points.difference(d, x, c.facets[facet].corner[0]);
        mpz_set_ui(value, 0);
        for (int axis = 0; axis < 3; ++axis)
            mpz_addmul(value, View(c.directions, 3 * std::size_t{facet} + static_cast<std::size_t>(axis)), d[axis]);
        return sign(value);
    }
    Vector d;
    Integer value;
};

// An axis along which the ends of a segment differ: they are distinct.
int axisOf(const Certificate& c, Pair ends) {
    int axis = 0;
    while (axis < 2 && c.points.compare(ends.first, ends.second, axis) == 0) ++axis;
    return axis;
}

bool strictlyBetween(const Certificate& c, std::uint32_t x, Pair ends, Vector& u, Vector& w, Vector& product) {
    c.points.difference(u, ends.second, ends.first);
    c.points.difference(w, x, ends.first);
    cross(product, u, w);
    if (!isZero(product)) return false;
    const int axis = axisOf(c, ends);
    const int first = c.points.compare(ends.first, x, axis), second = c.points.compare(x, ends.second, axis);
    return first != 0 && first == second;
}

// The points that each segment carries, in order from its first vertex to its second.
void orderCarried(Certificate& c) {
    c.carriedFirst.assign(c.segments.size() + 1, 0);
    for (const Steiner& point : c.steiner)
        if (onSegment(point.kind)) ++c.carriedFirst[point.carrier + 1];
    std::partial_sum(c.carriedFirst.begin(), c.carriedFirst.end(), c.carriedFirst.begin());
    c.carried.resize(c.carriedFirst.back());
    std::vector<std::size_t> next(c.carriedFirst.begin(), c.carriedFirst.end() - 1);
    for (std::uint32_t i = 0; i < c.steiner.size(); ++i)
        if (onSegment(c.steiner[i].kind)) c.carried[next[c.steiner[i].carrier]++] = c.vertexCount + i;
    c.rank.assign(c.steiner.size(), none);
    for (std::uint32_t s = 0; s < c.segments.size(); ++s) {
        if (c.carriedCount(s) == 0) continue;
        const Pair ends = c.segments[s];
        const int axis = axisOf(c, ends);
        const int forward = c.points.compare(ends.first, ends.second, axis);
        const auto first = c.carried.begin() + static_cast<std::ptrdiff_t>(c.carriedFirst[s]);
        const auto last = c.carried.begin() + static_cast<std::ptrdiff_t>(c.carriedFirst[s + 1]);
        std::sort(first, last, [&](std::uint32_t p, std::uint32_t q) { return c.points.compare(p, q, axis) * forward > 0; });
        for (auto i = first; i != last; ++i) c.rank[*i - c.vertexCount] = static_cast<std::uint32_t>(i - first);
    }
}

// Whether all points of the certificate lie in one plane.
bool allInOnePlane(const Certificate& c) {
    const std::uint32_t count = c.pointCount();
    if (!c.facets.empty()) {
        PlaneTest plane;
        for (std::uint32_t x = 0; x < count; ++x)
            if (c.pointPlane[x] != c.facetPlane[0] && plane.side(c, 0, x) != 0) return false;
        return true;
    }
    Vector u, w, normal;
    Integer value;
    bool found = false;
    for (std::uint32_t x = 2; x < count; ++x) {
        c.points.difference(w, x, 0);
        if (found) {
            dot(value, normal, w);
            if (sign(value) != 0) return false;
        } else {
            c.points.difference(u, 1, 0);
            cross(normal, u, w);
            found = !isZero(normal);
        }
    }
    return true;
}

}  // namespace

std::optional<Violation> ruleCarrier(Check& check) {
    Certificate& c = check.certificate;
    std::vector<bool> used(c.steiner.size(), false);
    for (const Cell& cell : c.cells)
        for (const std::uint32_t x : cell.corner)
            if (x >= c.vertexCount) {
                const Steiner& point = c.steiner[x - c.vertexCount];
                if (c.claims.refutation || (!onSegment(point.kind) && point.carrier == cell.facet)) used[x - c.vertexCount] = true;
            }
    Earliest earliest;
    inParallel(c.steiner.size(), check.threads, 1024, [&] {
        return [&, plane = std::make_unique<PlaneTest>(), v = std::make_unique<Vector[]>(3)](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) {
                const auto x = static_cast<std::uint32_t>(c.vertexCount + i);
                const Steiner point = c.steiner[i];
                if (onSegment(point.kind)) {
                    if (!strictlyBetween(c, x, c.segments[point.carrier], v[0], v[1], v[2]))
                        earliest.offer(c.pointLine(x), objectName("point", x, "segment", point.carrier));
                    else if (c.claims.refutation && !used[i]) earliest.offer(c.pointLine(x), objectName("point", x, "in-no-cell"));
                } else if (plane->side(c, point.carrier, x) != 0) {
                    earliest.offer(c.pointLine(x), objectName("point", x, "facet", point.carrier));
                } else if (!used[i]) {
                    earliest.offer(c.pointLine(x), objectName("point", x, "in-no-cell"));
                }
            }
        };
    });
    if (const auto violation = earliest.result()) return violation;
    orderCarried(c);
    c.coplanar = c.dimension == 3 && allInOnePlane(c);
    return std::nullopt;
}

std::optional<Violation> ruleCell(Check& check) {
    const Certificate& c = check.certificate;
    const auto belongs = [&c](std::uint32_t x, std::uint32_t facet) {
        if (x < c.vertexCount) return c.vertexOccurs(facet, x);
        const Steiner& point = c.steiner[x - c.vertexCount];
        return onSegment(point.kind) ? c.role(facet, point.carrier) != 0 : point.carrier == facet;
    };
    Earliest earliest;
    inParallel(c.cells.size(), check.threads, 1024, [&] {
        return [&, v = std::make_unique<Vector[]>(2), value = std::make_unique<Integer>()](std::size_t begin, std::size_t end) {
            for (std::size_t t = begin; t < end; ++t) {
                const Cell& cell = c.cells[t];
                bool all = true;
                for (const std::uint32_t x : cell.corner)
                    if (all && !belongs(x, cell.facet)) {
                        earliest.offer(c.cellLine + t, objectName("cell", t, "point", x));
                        all = false;
                    }
                if (!all) continue;
                // The corners lie in the facet's plane, so one component of the cross product decides.
                const int j = (c.normalAxis[cell.facet] + 1) % 3, k = (c.normalAxis[cell.facet] + 2) % 3;
                if (!check.exact && floatOrientation(c.points, cell.corner[0], cell.corner[1], cell.corner[2], j, k) == c.normalSign[cell.facet]) continue;
                c.points.difference(v[0], cell.corner[1], cell.corner[0]);
                c.points.difference(v[1], cell.corner[2], cell.corner[0]);
                mpz_mul(*value, v[0][j], v[1][k]);
                mpz_submul(*value, v[0][k], v[1][j]);
                const int orientation = sign(*value) * c.normalSign[cell.facet];
                if (orientation == 0) earliest.offer(c.cellLine + t, objectName("cell", t, "collinear"));
                if (orientation < 0) earliest.offer(c.cellLine + t, objectName("cell", t, "clockwise"));
            }
        };
    });
    return earliest.result();
}

namespace {

// p - q = r - s, all differences exact.
bool equalDifferences(const Points& points, std::uint32_t p, std::uint32_t q, std::uint32_t r, std::uint32_t s) {
    Vector left, right;
    Integer leftScale, rightScale;
    points.difference(left, p, q);
    points.difference(right, r, s);
    points.differenceScale(leftScale, p, q);
    points.differenceScale(rightScale, r, s);
    for (int axis = 0; axis < 3; ++axis) {
        mpz_mul(left[axis], left[axis], rightScale);
        mpz_mul(right[axis], right[axis], leftScale);
        if (mpz_cmp(left[axis], right[axis]) != 0) return false;
    }
    return true;
}

std::optional<std::string> boxFault(const Certificate& c, const Cell& first, const Cell& second) {
    if (first.facet != second.facet) return "two-facets";
    int shared = 0, opposite = 0;
    std::uint32_t p0 = 0, p1 = 0, p2 = 0, p3 = 0;
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) {
            const std::uint32_t a = first.corner[i], b = first.corner[(i + 1) % 3];
            const std::uint32_t d = second.corner[j], e = second.corner[(j + 1) % 3];
            if ((a == d && b == e) || (a == e && b == d)) ++shared;
            if (a != e || b != d) continue;
            ++opposite;
            p0 = first.corner[(i + 2) % 3];
            p1 = a;
            p2 = second.corner[(j + 2) % 3];
            p3 = b;
        }
    if (shared != 1 || opposite != 1) return "no-common-edge";
    if (!equalDifferences(c.points, p1, p0, p2, p3)) return "no-parallelogram";
    Vector u, w;
    Integer value;
    c.points.difference(u, p1, p0);
    c.points.difference(w, p3, p0);
    dot(value, u, w);
    if (sign(value) != 0) return "no-right-angle";
    return std::nullopt;
}

}  // namespace

std::optional<Violation> ruleBox(Check& check) {
    const Certificate& c = check.certificate;
    Earliest earliest;
    for (std::size_t t = 0, box = 0; t + 1 < c.cells.size(); ++t) {
        if (c.cells[t].kind != 'R') continue;
        // The reader has made sure that the two triangles stand on consecutive lines.
        if (const auto fault = boxFault(c, c.cells[t], c.cells[t + 1])) {
            earliest.offer(c.cellLine + t, objectName("box", box, *fault));
            break;
        }
        ++t;
        ++box;
    }
    return earliest.result();
}
