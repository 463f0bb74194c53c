// SPDX-License-Identifier: Apache-2.0
// Rule `rows`.
#include "rules.h"

#include <algorithm>

namespace {

// x_i are the points of the segment's row, q_i those of the protector.
class ProtectorRow {
public:
    explicit ProtectorRow(const Certificate& certificate) : c(certificate) {}

    void check(std::size_t number, const Row& row, const Row& own, Earliest& earliest) {
        const char role = c.role(row.facet, row.segment);
        if (role == 0) return earliest.offer(row.line, objectName("row", number, "segment", row.segment, "not-in-facet"));
        if (role != 'c' && role != row.side) return earliest.offer(row.line, objectName("row", number, "side"));
        if (row.count != own.count) return earliest.offer(row.line, objectName("row", number, "count"));
        for (std::uint32_t i = 0; i < row.count; ++i) {
            const std::uint32_t x = c.rowPoints[own.first + i], q = c.rowPoints[row.first + i];
            const auto fail = [&](const char* fault) { earliest.offer(row.line + 1 + i, objectName("row", number, "point", q, fault)); };
            if (q < c.vertexCount || c.steiner[q - c.vertexCount].kind != PointKind::offset) return fail("kind");
            if (c.steiner[q - c.vertexCount].carrier != row.facet) return fail("carrier");
            c.points.difference(o, q, x);
            c.points.differenceScale(scale, q, x);
            if (i > 0) {
                if (!equalsFirst()) return fail("vector");
                continue;
            }
            // o is not zero: the points are distinct, and x is another one, or the row of the segment is at fault, which is said first.
            c.points.difference(along, c.segments[row.segment].second, c.segments[row.segment].first);
            dot(value, o, along);
            if (sign(value) != 0) return fail("not-orthogonal");
            // Left of the segment, seen from the positive side: n.(along x o) > 0, decided along one axis, as all is in the plane.
            const int j = (c.normalAxis[row.facet] + 1) % 3, k = (c.normalAxis[row.facet] + 2) % 3;
            mpz_mul(value, along[j], o[k]);
            mpz_submul(value, along[k], o[j]);
            const int side = sign(value) * c.normalSign[row.facet];
            if (side != (row.side == '+' ? 1 : -1)) return fail("side");
            for (const int axis : {0, 1, 2}) mpz_set(firstVector[axis], o[axis]);
            mpz_set(firstScale, scale);
        }
    }

private:
    bool equalsFirst() {
        for (int axis = 0; axis < 3; ++axis) {
            mpz_mul(value, o[axis], firstScale);
            mpz_submul(value, firstVector[axis], scale);
            if (sign(value) != 0) return false;
        }
        return true;
    }

    const Certificate& c;
    Vector o, along, firstVector;
    Integer value, scale, firstScale;
};

void checkOwn(const Certificate& c, std::size_t number, const Row& row, Earliest& earliest) {
    const std::uint32_t count = c.carriedCount(row.segment);
    for (std::uint32_t i = 0; i < std::min(count, row.count); ++i) {
        const std::uint32_t x = c.rowPoints[row.first + i];
        if (x != c.carried[c.carriedFirst[row.segment] + i])
            return earliest.offer(row.line + 1 + i, objectName("row", number, "point", x));
    }
    if (count != row.count) earliest.offer(row.line, objectName("row", number, "count"));
}

}  // namespace

std::optional<Violation> ruleRows(Check& check) {
    const Certificate& c = check.certificate;
    Earliest earliest;
    ProtectorRow protector(c);
    const Row* own = nullptr;
    for (std::size_t i = 0; i < c.rows.size(); ++i) {
        const Row& row = c.rows[i];
        if (row.facet == none) {
            own = &row;
            checkOwn(c, i, row, earliest);
        } else if (own == nullptr || own->segment != row.segment) {
            earliest.offer(row.line, objectName("row", i, "without-segment-row"));
        } else {
            protector.check(i, row, *own, earliest);
        }
    }
    return earliest.result();
}
