// SPDX-License-Identifier: Apache-2.0
// Exact integers, vectors and points.
#pragma once

#include <gmp.h>

#include <array>
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <vector>

static_assert(GMP_NUMB_BITS == 64, "limbs of 64 bits without nails are assumed");

struct Integer {
    Integer() { mpz_init(value); }
    ~Integer() { mpz_clear(value); }
    Integer(const Integer&) = delete;
    Integer& operator=(const Integer&) = delete;
    operator mpz_ptr() { return value; }
    operator mpz_srcptr() const { return value; }
    mpz_t value;
};
inline int sign(mpz_srcptr a) { return mpz_sgn(a); }

struct Vector {
    std::array<Integer, 3> component;
    Integer& operator[](int axis) { return component[static_cast<std::size_t>(axis)]; }
    const Integer& operator[](int axis) const { return component[static_cast<std::size_t>(axis)]; }
};
void dot(mpz_ptr result, const Vector& a, const Vector& b);
void cross(Vector& result, const Vector& a, const Vector& b);  // result is neither a nor b
bool isZero(const Vector& a);

// Many integers, packed; memory in proportion to what is appended.
class IntegerStore {
public:
    void append(const mp_limb_t* limbs, int size);  // size < 0: negative, as in GMP
    void append(mpz_srcptr value);
    std::size_t size() const { return entries_.size(); }
    std::size_t limbs(std::size_t i) const { return static_cast<std::size_t>(std::abs(entries_[i].size)); }
    friend class View;

private:
    struct Entry {
        const mp_limb_t* limbs;
        std::int32_t size;
    };
    std::vector<Entry> entries_;
    std::vector<std::vector<mp_limb_t>> chunks_;  // none of them grows beyond its capacity: limbs stay where they are
};

class View {
public:
    View(const IntegerStore& store, std::size_t i) {
        mpz_roinit_n(value_, store.entries_[i].limbs, store.entries_[i].size);
    }
    operator mpz_srcptr() const { return value_; }

private:
    mpz_t value_;
};

// Points with rational coordinates. After prepare() they are either all integers over one common
// denominator (then hasCommon), or each has its own.
class Points {
public:
    // While reading: X Y Z W of each point, in order.
    IntegerStore& raw() { return store_; }
    std::size_t size() const { return hasCommon_ ? store_.size() / 3 : store_.size() / 4; }
    void prepare();

    bool hasCommon() const { return hasCommon_; }
    mpz_srcptr common() const { return common_; }
    View coordinate(std::uint32_t p, int axis) const { return {store_, (hasCommon_ ? 3 : 4) * std::size_t{p} + static_cast<std::size_t>(axis)}; }
    View weight(std::uint32_t p) const { return {store_, 4 * std::size_t{p} + 3}; }  // without a common denominator

    // p - q times a positive number: the common denominator, or the product of both weights.
    void difference(Vector& result, std::uint32_t p, std::uint32_t q) const;
    // That positive number, divided by the common denominator if there is one.
    void differenceScale(mpz_ptr scale, std::uint32_t p, std::uint32_t q) const;
    int compare(std::uint32_t p, std::uint32_t q, int axis) const;
    bool equal(std::uint32_t p, std::uint32_t q) const;
    std::uint64_t hash(std::uint32_t p) const;

    // Conservative coordinates: the coordinates of p, relative to point 0 and times 2^shift (and times the
    // common denominator), lie in [grid, grid+1]. All are below 2^49 in absolute value.
    const std::array<std::int64_t, 3>& grid(std::uint32_t p) const { return grid_[p]; }
    long shift() const { return shift_; }

private:
    bool findCommon();
    void makeGrid();

    IntegerStore store_;
    bool hasCommon_ = false;
    Integer common_;
    std::vector<std::array<std::int64_t, 3>> grid_;
    long shift_ = 0;
};
void shiftLeft(mpz_ptr result, mpz_srcptr a, long bits);  // floor for negative bits
