// SPDX-License-Identifier: Apache-2.0
// A few points as exact integer vectors from the first of them, and lengths in the same unit: then the inequalities of
// docs/lemma-claims.md, which are homogeneous, can be written as they stand there.
#pragma once

#include "certificate.h"

#include <initializer_list>

struct Vec {
    Whole x, y, z;
};
Vec operator-(const Vec& a, const Vec& b);
Whole operator*(const Vec& a, const Vec& b);  // a.b
Vec cross(const Vec& a, const Vec& b);
inline Whole square(const Whole& a) { return a * a; }
inline Whole norm(const Vec& a) { return a * a; }  // |a|^2

// Rounded, whatever the size of the numbers.
double ratio(const Whole& numerator, const Whole& denominator);
double rounded(const Rational& value);
double cosine(const Vec& a, const Vec& b);

// t >= cos(a, b), for vectors that are not zero.
bool atLeastCosine(const Rational& t, const Vec& a, const Vec& b);

class Frame {
public:
    Frame(const Certificate& c, std::initializer_list<std::uint32_t> points, std::initializer_list<const Rational*> lengths = {});
    const Vec& operator[](std::size_t i) const { return vectors_[i]; }  // point i minus point 0, times the unit
    Whole length(const Rational& value) const { return value.get_num() * (unit_ / value.get_den()); }  // times the unit

private:
    std::array<Vec, 5> vectors_;
    Whole unit_;
};

// A positive multiple of the normal of a facet.
Vec direction(const Certificate& c, std::uint32_t facet);

// The smallest circle of the triangle of a frame's first three points; the origin is the first.
struct Circle {
    explicit Circle(const Frame& frame);
    // P(x) = power(x) / D and R^2 = r / (4 D), in squares of the frame's unit.
    Whole power(const Vec& x) const { return D * norm(x) - x * V; }
    Whole D, r;
    Vec V;  // the centre is V / (2 D)
};

// T_j and U_j of C for j up to `most`.
struct Chebyshev {
    Chebyshev(const Rational& cosine, std::uint32_t most);
    bool belowPi(std::uint32_t j) const;  // j psi < pi, with C = cos psi
    std::vector<Rational> T, U;
};

// Points with rational coordinates, for what is needed seldom.
struct Place {
    Rational x, y, z;
};
Place place(const Certificate& c, std::uint32_t point);
Place operator-(const Place& a, const Place& b);
Place operator+(const Place& a, const Place& b);
Place operator*(const Rational& t, const Place& a);
Rational operator*(const Place& a, const Place& b);
Place cross(const Place& a, const Place& b);
Place centre(const Place& a, const Place& b, const Place& c);  // of the smallest circle
Rational distanceToSegment(const Place& x, const Place& a, const Place& b);                       // squared
Rational distanceOfSegments(const Place& a, const Place& b, const Place& c, const Place& d);      // squared
