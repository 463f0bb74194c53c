// SPDX-License-Identifier: Apache-2.0
#include "boxes.h"

#include <algorithm>
#include <array>

namespace {
using Limits = std::numeric_limits<std::int64_t>;
}

GridBox boxOf(const Points& points, std::initializer_list<std::uint32_t> of, std::uint32_t id) {
    GridBox box{{Limits::max(), Limits::max(), Limits::max()}, {Limits::min(), Limits::min(), Limits::min()}, id};
    for (const std::uint32_t p : of) box.add(points, p);
    return box;
}

Wide gridSquare(const Points& points, const Rational& square) {
    // Lengths on the grid are true ones times 2^shift, and times the common denominator if there is one.
    Whole numerator = square.get_num();
    if (points.hasCommon()) {
        Whole common;
        mpz_set(common.get_mpz_t(), points.common());
        numerator *= common * common;
    }
    Whole denominator = square.get_den();
    if (points.shift() >= 0) mpz_mul_2exp(numerator.get_mpz_t(), numerator.get_mpz_t(), static_cast<mp_bitcnt_t>(2 * points.shift()));
    else mpz_mul_2exp(denominator.get_mpz_t(), denominator.get_mpz_t(), static_cast<mp_bitcnt_t>(-2 * points.shift()));
    Whole bound;
    mpz_cdiv_q(bound.get_mpz_t(), numerator.get_mpz_t(), denominator.get_mpz_t());
    if (mpz_sizeinbase(bound.get_mpz_t(), 2) > 119) return unboundedGap;
    return static_cast<Wide>(mpz_getlimbn(bound.get_mpz_t(), 1)) << 64 | mpz_getlimbn(bound.get_mpz_t(), 0);
}

Wide scaledGap(Wide gap, double factor) {
    const double product = (static_cast<double>(gap) + 1) * factor * (1 + 1e-9) + 1;
    return product < 1e36 ? static_cast<Wide>(product) : unboundedGap;
}

BoxTree::BoxTree(std::vector<GridBox> boxes) : items_(std::move(boxes)) {
    if (!items_.empty()) build(0, items_.size());
}

void BoxTree::build(std::size_t first, std::size_t last) {
    GridBox box = items_[first];
    // Of the sums of both ends, by which items are split.
    std::array<std::int64_t, 3> low{Limits::max(), Limits::max(), Limits::max()}, high{Limits::min(), Limits::min(), Limits::min()};
    for (std::size_t k = first; k < last; ++k)
        for (std::size_t i = 0; i < 3; ++i) {
            box.low[i] = std::min(box.low[i], items_[k].low[i]);
            box.high[i] = std::max(box.high[i], items_[k].high[i]);
            low[i] = std::min(low[i], items_[k].low[i] + items_[k].high[i]);
            high[i] = std::max(high[i], items_[k].low[i] + items_[k].high[i]);
        }
    const std::size_t number = nodes_.size();
    nodes_.push_back({box, 0, static_cast<std::uint32_t>(first), static_cast<std::uint32_t>(last - first)});
    if (last - first <= 4) return;
    std::size_t axis = 0;
    for (std::size_t i = 1; i < 3; ++i)
        if (high[i] - low[i] > high[axis] - low[axis]) axis = i;
    const std::size_t middle = first + (last - first) / 2;
    const auto at = [this](std::size_t i) { return items_.begin() + static_cast<std::ptrdiff_t>(i); };
    std::nth_element(at(first), at(middle), at(last), [axis](const GridBox& a, const GridBox& b) {
        const std::int64_t x = a.low[axis] + a.high[axis], y = b.low[axis] + b.high[axis];
        return x != y ? x < y : a.id < b.id;
    });
    build(first, middle);
    nodes_[number].second = nodes_.size();
    build(middle, last);
}
