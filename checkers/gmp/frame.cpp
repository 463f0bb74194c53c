// SPDX-License-Identifier: Apache-2.0
#include "frame.h"

#include <algorithm>
#include <cmath>

Vec operator-(const Vec& a, const Vec& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
Whole operator*(const Vec& a, const Vec& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
Vec cross(const Vec& a, const Vec& b) { return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x}; }

double ratio(const Whole& numerator, const Whole& denominator) {
    long top = 0, bottom = 0;
    const double a = mpz_get_d_2exp(&top, numerator.get_mpz_t()), b = mpz_get_d_2exp(&bottom, denominator.get_mpz_t());
    return std::ldexp(a / b, static_cast<int>(std::clamp(top - bottom, -2000L, 2000L)));
}
double rounded(const Rational& value) { return ratio(value.get_num(), value.get_den()); }
double cosine(const Vec& a, const Vec& b) {
    const Whole product = a * b;
    return sgn(product) * std::sqrt(ratio(square(product), norm(a) * norm(b)));
}

bool atLeastCosine(const Rational& t, const Vec& a, const Vec& b) {
    const Whole product = a * b;
    if (sgn(t) >= 0 && sgn(product) <= 0) return true;
    if (sgn(t) < 0 && sgn(product) >= 0) return false;
    const int order = cmp(square(t.get_num()) * norm(a) * norm(b), square(product) * square(t.get_den()));
    return sgn(t) >= 0 ? order >= 0 : order <= 0;
}

Frame::Frame(const Certificate& c, std::initializer_list<std::uint32_t> points, std::initializer_list<const Rational*> lengths) {
    const Points& all = c.points;
    const auto extend = [this](mpz_srcptr factor) { mpz_lcm(unit_.get_mpz_t(), unit_.get_mpz_t(), factor); };
    if (all.hasCommon()) mpz_set(unit_.get_mpz_t(), all.common());
    else unit_ = 1;
    for (const Rational* length : lengths) extend(length->get_den_mpz_t());
    if (!all.hasCommon())
        for (const std::uint32_t p : points) extend(all.weight(p));
    Whole factor;
    Vec origin;
    std::size_t i = 0;
    for (const std::uint32_t p : points) {
        Vec& v = vectors_[i];
        if (all.hasCommon()) mpz_divexact(factor.get_mpz_t(), unit_.get_mpz_t(), all.common());
        else mpz_divexact(factor.get_mpz_t(), unit_.get_mpz_t(), all.weight(p));
        mpz_mul(v.x.get_mpz_t(), factor.get_mpz_t(), all.coordinate(p, 0));
        mpz_mul(v.y.get_mpz_t(), factor.get_mpz_t(), all.coordinate(p, 1));
        mpz_mul(v.z.get_mpz_t(), factor.get_mpz_t(), all.coordinate(p, 2));
        if (i == 0) origin = v;
        v = v - origin;
        ++i;
    }
}

Vec direction(const Certificate& c, std::uint32_t facet) {
    Vec n;
    mpz_set(n.x.get_mpz_t(), View(c.directions, 3 * std::size_t{facet}));
    mpz_set(n.y.get_mpz_t(), View(c.directions, 3 * std::size_t{facet} + 1));
    mpz_set(n.z.get_mpz_t(), View(c.directions, 3 * std::size_t{facet} + 2));
    return n;
}

Circle::Circle(const Frame& frame) {
    const Vec &u = frame[1], &w = frame[2];
    const Whole uu = norm(u), ww = norm(w), uw = u * w;
    const Whole alpha = ww * (uu - uw), beta = uu * (ww - uw);
    D = uu * ww - uw * uw;
    r = uu * ww * (uu + ww - 2 * uw);
    V = {alpha * u.x + beta * w.x, alpha * u.y + beta * w.y, alpha * u.z + beta * w.z};
}

Chebyshev::Chebyshev(const Rational& cosine, std::uint32_t most) : T{1, cosine}, U{1, 2 * cosine} {
    for (std::uint32_t j = 2; j <= most; ++j) {
        T.push_back(2 * cosine * T[j - 1] - T[j - 2]);
        U.push_back(2 * cosine * U[j - 1] - U[j - 2]);
    }
}
bool Chebyshev::belowPi(std::uint32_t j) const {
    return std::all_of(U.begin(), U.begin() + static_cast<std::ptrdiff_t>(j), [](const Rational& u) { return sgn(u) > 0; });
}

Place place(const Certificate& c, std::uint32_t point) {
    const auto coordinate = [&](int axis) {
        Rational value;
        mpz_set(value.get_num_mpz_t(), c.points.coordinate(point, axis));
        if (c.points.hasCommon()) mpz_set(value.get_den_mpz_t(), c.points.common());
        else mpz_set(value.get_den_mpz_t(), c.points.weight(point));
        value.canonicalize();
        return value;
    };
    return {coordinate(0), coordinate(1), coordinate(2)};
}
Place operator-(const Place& a, const Place& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
Place operator+(const Place& a, const Place& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
Place operator*(const Rational& t, const Place& a) { return {t * a.x, t * a.y, t * a.z}; }
Rational operator*(const Place& a, const Place& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
Place cross(const Place& a, const Place& b) { return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x}; }

Place centre(const Place& a, const Place& b, const Place& c) {
    const Place u = b - a, w = c - a;
    const Rational uu = u * u, ww = w * w, uw = u * w;
    const Rational alpha = ww * (uu - uw), beta = uu * (ww - uw), twice = 2 * (uu * ww - uw * uw);
    return a + Rational(alpha / twice) * u + Rational(beta / twice) * w;
}

Rational distanceToSegment(const Place& x, const Place& a, const Place& b) {
    const Place along = b - a, d = x - a;
    const Rational t = d * along, length = along * along;
    if (sgn(t) <= 0) return d * d;
    if (t >= length) return (x - b) * (x - b);
    return d * d - t * t / length;
}

Rational distanceOfSegments(const Place& a, const Place& b, const Place& c, const Place& d) {
    const Place u = b - a, w = d - c, n = cross(u, w), e = c - a;
    const Rational nn = n * n;
    if (sgn(nn) != 0) {
        // The common perpendicular of the lines counts if its feet are within both segments.
        const Rational s = cross(e, w) * n, t = cross(e, u) * n;
        if (sgn(s) >= 0 && s <= nn && sgn(t) >= 0 && t <= nn) {
            const Rational height = e * n;
            return height * height / nn;
        }
    }
    return std::min({distanceToSegment(a, c, d), distanceToSegment(b, c, d), distanceToSegment(c, a, b), distanceToSegment(d, a, b)});
}
