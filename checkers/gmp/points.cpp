// SPDX-License-Identifier: Apache-2.0
#include "points.h"

#include <algorithm>
#include <optional>

void dot(mpz_ptr result, const Vector& a, const Vector& b) {
    mpz_mul(result, a[0], b[0]);
    mpz_addmul(result, a[1], b[1]);
    mpz_addmul(result, a[2], b[2]);
}
void cross(Vector& result, const Vector& a, const Vector& b) {
    for (int i = 0; i < 3; ++i) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        mpz_mul(result[i], a[j], b[k]);
        mpz_submul(result[i], a[k], b[j]);
    }
}
bool isZero(const Vector& a) { return sign(a[0]) == 0 && sign(a[1]) == 0 && sign(a[2]) == 0; }

void shiftLeft(mpz_ptr result, mpz_srcptr a, long bits) {
    if (bits >= 0) mpz_mul_2exp(result, a, static_cast<mp_bitcnt_t>(bits));
    else mpz_fdiv_q_2exp(result, a, static_cast<mp_bitcnt_t>(-bits));
}

void IntegerStore::append(const mp_limb_t* limbs, int size) {
    static constexpr mp_limb_t zero = 0;  // GMP's macros read the first limb even of 0
    if (size == 0) {
        entries_.push_back({&zero, 0});
        return;
    }
    const auto count = static_cast<std::size_t>(std::abs(size));
    const std::size_t last = chunks_.empty() ? 0 : chunks_.back().capacity();
    // Chunks grow with what has been stored, so that small files stay small.
    if (chunks_.empty() || last - chunks_.back().size() < count) chunks_.emplace_back().reserve(std::max(count, std::clamp<std::size_t>(2 * last, 256, std::size_t{1} << 17)));
    std::vector<mp_limb_t>& chunk = chunks_.back();
    entries_.push_back({chunk.data() + chunk.size(), size});
    chunk.insert(chunk.end(), limbs, limbs + count);
}
void IntegerStore::append(mpz_srcptr value) {
    append(mpz_limbs_read(value), sign(value) * static_cast<int>(mpz_size(value)));
}

// Looks for a common denominator that does not make the coordinates much longer than they are in the file.
bool Points::findCommon() {
    const std::size_t count = store_.size() / 4;
    std::size_t rawLimbs = 0;
    for (std::size_t i = 0; i < store_.size(); ++i) rawLimbs += store_.limbs(i);
    const std::size_t largest = 4 + 4 * rawLimbs / std::max<std::size_t>(count, 1);
    mpz_set_ui(common_, 1);
    for (std::size_t p = 0; p < count; ++p) {
        const View w(store_, 4 * p + 3);
        if (mpz_divisible_p(common_, w)) continue;
        mpz_lcm(common_, common_, w);
        if (mpz_size(common_) > largest) return false;
    }
    std::size_t scaledLimbs = 0;
    for (std::size_t p = 0; p < count; ++p)
        for (std::size_t axis = 0; axis < 3; ++axis)
            if (store_.limbs(4 * p + axis) != 0)
                scaledLimbs += store_.limbs(4 * p + axis) + mpz_size(common_) + 1 - store_.limbs(4 * p + 3);
    return scaledLimbs <= 3 * rawLimbs + 64;
}

void Points::prepare() {
    if (findCommon()) {
        IntegerStore scaled;
        Integer factor, value;
        const std::size_t count = store_.size() / 4;
        for (std::size_t p = 0; p < count; ++p) {
            mpz_divexact(factor, common_, View(store_, 4 * p + 3));
            for (std::size_t axis = 0; axis < 3; ++axis) {
                mpz_mul(value, View(store_, 4 * p + axis), factor);
                scaled.append(value);
            }
        }
        store_ = std::move(scaled);
        hasCommon_ = true;
    }
    makeGrid();
}

void Points::difference(Vector& result, std::uint32_t p, std::uint32_t q) const {
    for (int axis = 0; axis < 3; ++axis) {
        if (hasCommon_) {
            mpz_sub(result[axis], coordinate(p, axis), coordinate(q, axis));
        } else {
            mpz_mul(result[axis], coordinate(p, axis), weight(q));
            mpz_submul(result[axis], coordinate(q, axis), weight(p));
        }
    }
}

void Points::differenceScale(mpz_ptr scale, std::uint32_t p, std::uint32_t q) const {
    if (hasCommon_) mpz_set_ui(scale, 1);
    else mpz_mul(scale, weight(p), weight(q));
}

int Points::compare(std::uint32_t p, std::uint32_t q, int axis) const {
    if (hasCommon_) return mpz_cmp(coordinate(p, axis), coordinate(q, axis));
    Integer left, right;
    mpz_mul(left, coordinate(p, axis), weight(q));
    mpz_mul(right, coordinate(q, axis), weight(p));
    return mpz_cmp(left, right);
}

// Homogeneous coordinates in lowest terms are unique, and so are those over a common denominator.
bool Points::equal(std::uint32_t p, std::uint32_t q) const {
    for (int axis = 0; axis < (hasCommon_ ? 3 : 4); ++axis)
        if (mpz_cmp(coordinate(p, axis), coordinate(q, axis)) != 0) return false;
    return true;
}

std::uint64_t Points::hash(std::uint32_t p) const {
    std::uint64_t state = 0x9e3779b97f4a7c15u;
    const auto mix = [&state](std::uint64_t value) {
        state = (state ^ value) * 0xff51afd7ed558ccdu;
        state ^= state >> 32;
    };
    for (int axis = 0; axis < (hasCommon_ ? 3 : 4); ++axis) {
        const View value = coordinate(p, axis);
        mix(mpz_size(value) * 2 + (sign(value) < 0 ? 1 : 0));
        for (std::size_t i = 0; i < mpz_size(value); ++i) mix(mpz_getlimbn(value, static_cast<mp_size_t>(i)));
    }
    return state;
}

void Points::makeGrid() {
    constexpr long wanted = 48;
    const std::size_t count = size();
    grid_.resize(count);
    Vector d;
    Integer scale, scaled;
    std::optional<long> bits;
    for (std::uint32_t p = 0; p < count; ++p) {
        difference(d, p, 0);
        differenceScale(scale, p, 0);
        for (int axis = 0; axis < 3; ++axis) {
            if (sign(d[axis]) == 0) continue;
            const long size = static_cast<long>(mpz_sizeinbase(d[axis], 2)) - static_cast<long>(mpz_sizeinbase(scale, 2)) + 1;
            bits = std::max(bits.value_or(size), size);
        }
    }
    shift_ = wanted - bits.value_or(0);
    for (std::uint32_t p = 0; p < count; ++p) {
        difference(d, p, 0);
        differenceScale(scale, p, 0);
        for (int axis = 0; axis < 3; ++axis) {
            if (hasCommon_) {
                shiftLeft(scaled, d[axis], shift_);
            } else {
                // A shift to the right floors, and floors nest.
                shiftLeft(scaled, d[axis], shift_);
                mpz_fdiv_q(scaled, scaled, scale);
            }
            grid_[p][static_cast<std::size_t>(axis)] = mpz_get_si(scaled);
        }
    }
}
