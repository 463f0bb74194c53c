// SPDX-License-Identifier: Apache-2.0
#include "sphere.h"

#include <algorithm>

void Sphere::setCell(const Cell& cell) {
    cell_ = &cell;
    origin_ = cell.corner[0];
    exact_ = false;
    filtered_ = normals_ != nullptr && ball_.setCell(c_, *normals_, cell);
}

void Sphere::setBall(std::uint32_t a, std::uint32_t b) {
    cell_ = nullptr;
    origin_ = a;
    end_ = b;
    exact_ = false;
    filtered_ = normals_ != nullptr;
    if (filtered_) ball_.setBall(points_, a, b);
}

void Sphere::makeExact() {
    if (exact_) return;
    exact_ = true;
    if (cell_ != nullptr) makeCell();
    else makeBall();
}

void Sphere::makeCell() {
    const auto [a, b, c] = cell_->corner;
    points_.difference(u_, b, a);
    points_.difference(w_, c, a);
    if (!points_.hasCommon()) {
        for (int i = 0; i < 3; ++i) {
            mpz_mul(u_[i], u_[i], points_.weight(c));
            mpz_mul(w_[i], w_[i], points_.weight(b));
        }
        mpz_mul(extra_, points_.weight(b), points_.weight(c));
        mpz_mul(scale_, extra_, points_.weight(a));
    }
    dot(uu_, u_, u_);
    dot(ww_, w_, w_);
    dot(uw_, u_, w_);
    mpz_mul(denominator_, uu_, ww_);
    mpz_submul(denominator_, uw_, uw_);
    mpz_sub(alpha_, uu_, uw_);
    mpz_mul(alpha_, alpha_, ww_);
    mpz_sub(beta_, ww_, uw_);
    mpz_mul(beta_, beta_, uu_);
    for (int i = 0; i < 3; ++i) {
        mpz_mul(v_[i], alpha_, u_[i]);
        mpz_addmul(v_[i], beta_, w_[i]);
    }
    if (cell_->offset != none) addOffset();
}

// The facet's normal is stored as N = n times a positive number s; with m the factor from true to scaled lengths the
// centre moves by (numerator / denominator) m N / s. With a common denominator s = m^2.
void Sphere::addOffset() {
    const Cell& cell = *cell_;
    const View numerator(c_.offsets, 2 * std::size_t{cell.offset}), denominator(c_.offsets, 2 * std::size_t{cell.offset} + 1);
    mpz_mul(value_, denominator_, numerator);
    mpz_mul_2exp(value_, value_, 1);
    if (points_.hasCommon()) {
        mpz_mul(square_, denominator, points_.common());
    } else {
        mpz_mul(value_, value_, scale_);
        mpz_mul(square_, denominator, View(c_.normalScales, cell.facet));
    }
    mpz_mul(denominator_, denominator_, square_);
    for (int i = 0; i < 3; ++i) {
        mpz_mul(v_[i], v_[i], square_);
        mpz_addmul(v_[i], value_, View(c_.normals, 3 * std::size_t{cell.facet} + static_cast<std::size_t>(i)));
    }
}

// (x-a).(x-b) = |d|^2 - d.u
void Sphere::makeBall() {
    points_.difference(v_, end_, origin_);
    mpz_set_ui(denominator_, 1);
    if (!points_.hasCommon()) {
        mpz_set(extra_, points_.weight(end_));
        mpz_mul(scale_, extra_, points_.weight(origin_));
    }
}

int Sphere::power(std::uint32_t x) {
    makeExact();
    points_.difference(d_, x, origin_);
    if (!points_.hasCommon())
        for (int i = 0; i < 3; ++i) mpz_mul(d_[i], d_[i], extra_);
    dot(square_, d_, d_);
    mpz_mul(value_, denominator_, square_);
    if (points_.hasCommon()) {
        for (int i = 0; i < 3; ++i) mpz_submul(value_, d_[i], v_[i]);
    } else {
        // d is a true difference times scale and the weight of x.
        mpz_set(q_, points_.weight(x));
        dot(square_, d_, v_);
        mpz_submul(value_, square_, q_);
    }
    return sign(value_);
}

bool Sphere::inPlane(std::uint32_t facet) {
    mpz_set_ui(other_, 0);
    for (int axis = 0; axis < 3; ++axis)
        mpz_addmul(other_, View(c_.directions, 3 * std::size_t{facet} + static_cast<std::size_t>(axis)), d_[axis]);
    return sign(other_) == 0;
}

double Sphere::relativePower() {
    mpz_mul(square_, value_, denominator_);
    mpz_mul_2exp(square_, square_, 2);
    dot(other_, v_, v_);
    if (!points_.hasCommon()) {
        mpz_mul(other_, other_, q_);
        mpz_mul(other_, other_, q_);
    }
    return quotient();
}

// The vector from the centre to a point x is x - a - V / (2 D). Times 2 D it is an integer for each axis, or rounded down without a common
// denominator; along each axis the nearer end of the box bounds it from below.
bool Sphere::mayMeet(const ExactBox& box) {
    makeExact();
    mpz_set_ui(square_, 0);
    for (int i = 0; i < 3; ++i)
        for (const bool below : {true, false}) {  // the centre is below the box, or above it
            const std::uint32_t x = below ? box.low[i] : box.high[i];
            points_.difference(d_, x, origin_);
            mpz_mul(value_, d_[i], denominator_);
            mpz_mul_2exp(value_, value_, 1);
            if (points_.hasCommon()) {
                mpz_sub(value_, value_, v_[i]);
                if (!below) mpz_neg(value_, value_);
            } else {
                mpz_mul(value_, value_, extra_);
                mpz_submul(value_, v_[i], points_.weight(x));
                if (!below) mpz_neg(value_, value_);
                mpz_fdiv_q(value_, value_, points_.weight(x));
            }
            if (sign(value_) > 0) mpz_addmul(square_, value_, value_);
        }
    dot(other_, v_, v_);
    return mpz_cmp(square_, other_) <= 0;
}

double Sphere::relativeGap() { return quotient(); }

double Sphere::quotient() const {
    long exponent = 0, otherExponent = 0;
    const double mantissa = mpz_get_d_2exp(&exponent, square_), otherMantissa = mpz_get_d_2exp(&otherExponent, other_);
    const long difference = std::clamp(exponent - otherExponent, -2000L, 2000L);
    return __builtin_ldexp(mantissa / otherMantissa, static_cast<int>(difference));
}

void Sphere::computeBounds() {
    makeExact();
    constexpr std::int64_t largest = std::int64_t{1} << 61;
    const std::array<std::int64_t, 3>& start = points_.grid(origin_);
    mpz_mul_2exp(square_, denominator_, 1);
    if (!points_.hasCommon()) mpz_mul(square_, square_, scale_);
    fits_ = true;
    for (int i = 0; i < 3; ++i) {
        shiftLeft(value_, v_[i], points_.shift());  // floors nest
        mpz_fdiv_q(longCentre[i], value_, square_);
        if (mpz_cmpabs_ui(longCentre[i], static_cast<unsigned long>(largest)) >= 0) fits_ = false;
    }
    // The sphere passes through its first corner, and each component of centre - corner is in [floor, floor + 1]: its size is at most |floor| + 1.
    if (fits_) {
        radius2 = 0;
        for (int i = 0; i < 3; ++i) {
            const std::int64_t floor = mpz_get_si(longCentre[i]);
            const Wide reach = std::abs(floor) + 1;
            radius2 += reach * reach;
            centre[i] = start[static_cast<std::size_t>(i)] + floor;
        }
        return;
    }
    mpz_set_ui(longRadius2, 0);
    for (int i = 0; i < 3; ++i) {
        mpz_abs(value_, longCentre[i]);
        mpz_add_ui(value_, value_, 1);
        mpz_addmul(longRadius2, value_, value_);
        mpz_set_si(value_, start[static_cast<std::size_t>(i)]);
        mpz_add(longCentre[i], longCentre[i], value_);
    }
}
