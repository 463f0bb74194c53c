// SPDX-License-Identifier: Apache-2.0
// Rules `emptiness`, `tie` and `hanging`: all of them ask which points lie in or on a sphere.
#include "index.h"
#include "rules.h"

#include <algorithm>
#include <limits>

namespace {

struct Shared {
    explicit Shared(Check& c) : check(c), certificate(c.certificate), index(indexOfAll(c)) {}
    Check& check;
    const Certificate& certificate;
    const Index& index;
    Earliest emptiness, tie;
    std::atomic<double> smallest{std::numeric_limits<double>::infinity()};
    std::atomic<std::uint64_t> ties{0};
    std::mutex mutex;
};

// Looks at all points in or on the spheres of cells.
class CellWorker {
public:
    explicit CellWorker(Shared& shared)
        : shared_(shared), c_(shared.certificate), sphere_(c_, shared.check.floatNormals.get()), wanted_(c_.dimension == 3 && !c_.coplanar) {}
    ~CellWorker() {
        const std::lock_guard<std::mutex> guard(shared_.mutex);
        if (best_.betterThan(shared_.check.smallest)) shared_.check.smallest = best_;
        shared_.ties += ties_;
    }
    CellWorker(const CellWorker&) = delete;
    CellWorker& operator=(const CellWorker&) = delete;

    void check(std::size_t t) {
        line_ = c_.cellLine + t;
        if (line_ > shared_.emptiness.line()) return;
        number_ = t;
        cell_ = &c_.cells[t];
        sphere_.setCell(*cell_);
        plane_ = c_.facetPlane[cell_->facet];
        violating_ = crossing_ = none;
        searchSphere(shared_.index, sphere_, plane_, *this);
        if (violating_ != none) shared_.emptiness.offer(line_, objectName("cell", t, "point", violating_));
        if (crossing_ != none) shared_.tie.offer(line_, objectName("cell", t, "point", crossing_));
    }

    void begin(Reach& reach) {
        reach_ = &reach;
        reach.setOuter(shared_.smallest.load(std::memory_order_relaxed), wanted_);
    }
    void near(std::uint32_t x) {
        if (isCorner(x)) return;
        const int sign = sphere_.power(x);
        if (sign < 0) {
            violating_ = std::min(violating_, x);
        } else if (sign > 0) {
            if (wanted_ && c_.pointPlane[x] != plane_) candidate(x);
        } else if (c_.pointPlane[x] == plane_ || sphere_.inPlane(cell_->facet)) {
            ++ties_;
            if (x < crossing_ && crosses(x)) crossing_ = x;
        } else {
            violating_ = std::min(violating_, x);
        }
    }
    void far(std::uint32_t x) {
        if (isCorner(x)) return;
        if (sphere_.power(x) > 0) candidate(x);
    }

private:
    bool isCorner(std::uint32_t x) const { return x == cell_->corner[0] || x == cell_->corner[1] || x == cell_->corner[2]; }

    // Only for the report.
    void candidate(std::uint32_t x) {
        if (sphere_.inPlane(cell_->facet)) return;
        const SmallestPower found{sphere_.relativePower(), line_, x};
        if (!found.betterThan(best_)) return;
        best_ = found;
        double known = shared_.smallest.load(std::memory_order_relaxed);
        while (found.value < known && !shared_.smallest.compare_exchange_weak(known, found.value)) {}
        reach_->setOuter(std::min(known, found.value), wanted_);
    }

    // Rule `tie`: whether x is strictly on the other side of an edge of the cell that lies on a segment of the facet.
    bool crosses(std::uint32_t x) {
        const int j = (c_.normalAxis[cell_->facet] + 1) % 3, k = (c_.normalAxis[cell_->facet] + 2) % 3;
        for (int i = 0; i < 3; ++i) {
            const std::uint32_t from = cell_->corner[i], to = cell_->corner[(i + 1) % 3];
            const std::uint32_t segment = c_.segmentThrough(from, to);
            if (segment == none || c_.role(cell_->facet, segment) == 0) continue;
            c_.points.difference(along_, to, from);
            c_.points.difference(across_, x, from);
            mpz_mul(side_, along_[j], across_[k]);
            mpz_submul(side_, along_[k], across_[j]);
            if (sign(side_) * c_.normalSign[cell_->facet] < 0) return true;
        }
        return false;
    }

    Shared& shared_;
    const Certificate& c_;
    Sphere sphere_;
    const bool wanted_;
    Reach* reach_ = nullptr;
    const Cell* cell_ = nullptr;
    std::size_t number_ = 0;
    std::uint64_t line_ = 0, ties_ = 0;
    std::uint32_t plane_ = none, violating_ = none, crossing_ = none;
    SmallestPower best_;
    Vector along_, across_;
    Integer side_;
};

class BallWorker {
public:
    BallWorker(Shared& shared, Earliest& earliest)
        : shared_(shared), c_(shared.certificate), earliest_(earliest), sphere_(c_, shared.check.floatNormals.get()), wanted_(c_.claims.find(Lemma::l22) != nullptr) {}
    ~BallWorker() {
        const std::lock_guard<std::mutex> guard(shared_.mutex);
        if (best_.betterThan(shared_.check.smallestHanging)) shared_.check.smallestHanging = best_;
    }
    BallWorker(const BallWorker&) = delete;
    BallWorker& operator=(const BallWorker&) = delete;

    void check(std::size_t h) {
        part_ = &c_.hanging[h];
        sphere_.setBall(part_->a, part_->b);
        line_ = c_.hangingLine + h;
        violating_ = none;
        searchSphere(shared_.index, sphere_, none, *this);
        if (violating_ != none) earliest_.offer(c_.hangingLine + h, objectName("subsegment", h, "point", violating_));
    }
    void begin(Reach& reach) {
        reach_ = &reach;
        reach.setOuter(best_.cellLine != 0 ? 4 * best_.value : std::numeric_limits<double>::infinity(), wanted_);
    }
    void near(std::uint32_t x) {
        if (x == part_->a || x == part_->b) return;
        if (sphere_.power(x) <= 0) violating_ = std::min(violating_, x);
        else if (wanted_) candidate(x);
    }
    void far(std::uint32_t x) {
        if (x != part_->a && x != part_->b && sphere_.power(x) > 0) candidate(x);
    }

private:
    // Only for the report of L22: (x-a).(x-b) / |a-b|^2 is a quarter of power / radius^2.
    void candidate(std::uint32_t x) {
        const SmallestPower found{sphere_.relativePower() / 4, line_, x};
        if (!found.betterThan(best_)) return;
        best_ = found;
        reach_->setOuter(4 * best_.value, true);
    }

    Shared& shared_;
    const Certificate& c_;
    Earliest& earliest_;
    Sphere sphere_;
    const bool wanted_;
    Reach* reach_ = nullptr;
    const Subsegment* part_ = nullptr;
    std::uint64_t line_ = 0;
    SmallestPower best_;
    std::uint32_t violating_ = none;
};

// The subsegments of every hanging segment are listed, in order, from end to end.
void checkSubsegments(const Certificate& c, Earliest& earliest) {
    std::size_t h = 0;
    for (std::uint32_t s = 0; s < c.segments.size(); ++s) {
        const Pair ends = c.segments[s];
        std::uint32_t reached = ends.first;
        const std::size_t start = h;
        for (; h < c.hanging.size() && c.hanging[h].segment == s; ++h) {
            const Subsegment& part = c.hanging[h];
            const std::uint64_t line = c.hangingLine + h;
            if (c.segmentUsed[s]) {
                earliest.offer(line, objectName("subsegment", h, "segment", s, "not-hanging"));
                continue;
            }
            const auto place = [&](std::uint32_t x) -> std::uint64_t {
                if (x == ends.first) return 0;
                if (x == ends.second) return std::uint64_t{c.carriedCount(s)} + 1;
                if (x < c.vertexCount) return ~std::uint64_t{0};
                const Steiner& point = c.steiner[x - c.vertexCount];
                return onSegment(point.kind) && point.carrier == s ? std::uint64_t{c.rank[x - c.vertexCount]} + 1 : ~std::uint64_t{0};
            };
            if (part.a != reached) earliest.offer(line, objectName("subsegment", h, "point", part.a, "not-next"));
            else if (place(part.b) == ~std::uint64_t{0}) earliest.offer(line, objectName("subsegment", h, "point", part.b, "not-on-segment"));
            else if (place(part.b) <= place(part.a)) earliest.offer(line, objectName("subsegment", h, "point", part.b, "not-forward"));
            reached = part.b;
        }
        if (c.segmentUsed[s]) continue;
        if (h == start) earliest.offer(c.segmentLine + s, objectName("segment", s, "not-covered"));
        else if (reached != ends.second) earliest.offer(c.hangingLine + h - 1, objectName("segment", s, "not-covered"));
    }
}

}  // namespace

std::optional<Violation> ruleEmptiness(Check& check) {
    Shared shared(check);
    const std::vector<std::uint32_t> order = cellsInOrder(check);
    inParallel(order.size(), check.threads, 64, [&] {
        return [&order, worker = std::make_unique<CellWorker>(shared)](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) worker->check(order[i]);
        };
    });
    check.tieCount = shared.ties;
    check.tieViolation = shared.tie.result();
    return shared.emptiness.result();
}

std::optional<Violation> ruleTie(Check& check) { return check.tieViolation; }

std::optional<Violation> ruleHanging(Check& check) {
    Earliest earliest;
    checkSubsegments(check.certificate, earliest);
    if (!check.certificate.hanging.empty()) {
        Shared shared(check);
        inParallel(check.certificate.hanging.size(), check.threads, 64, [&] {
            return [worker = std::make_unique<BallWorker>(shared, earliest)](std::size_t begin, std::size_t end) {
                for (std::size_t h = begin; h < end; ++h) worker->check(h);
            };
        });
    }
    return earliest.result();
}
