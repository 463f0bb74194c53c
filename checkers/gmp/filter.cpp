// SPDX-License-Identifier: Apache-2.0
#include "filter.h"

#include <cfenv>
#include <cmath>

namespace {

constexpr double ulp = 0x1p-53;                  // the largest relative error of one rounding
constexpr double largestAspect = 0x1p16;         // (2): |n| >= 2^16 |u|, 2^16 |w|, or the cell is in doubt
constexpr double centreError = 6.25;             // (3)
constexpr double offsetError = 64.0 * ulp;       // (4)
constexpr double ballRoom = 3.0;                 // (5)
constexpr double squareError = 1.0 + 8.0 * ulp;  // (6)
constexpr double orientationError = 1.25, orientationRoom = 2.0;  // (7)

struct Triple {
    double x, y, z;
};
// Integers below 2^49, so they are exact.
Triple difference(const Points& points, std::uint32_t p, std::uint32_t q) {
    const auto &a = points.grid(p), &b = points.grid(q);
    return {static_cast<double>(a[0] - b[0]), static_cast<double>(a[1] - b[1]), static_cast<double>(a[2] - b[2])};
}
double norm2(const Triple& a) { return a.x * a.x + a.y * a.y + a.z * a.z; }
Triple cross(const Triple& a, const Triple& b) { return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x}; }

double square(double a) { return a * a; }

// a / b 2^shift, within 5 units of rounding; NaN out of range, where the result or something on the way to it might not be normal.
double quotient(mpz_srcptr a, mpz_srcptr b, long shift) {
    long top = 0, bottom = 0;
    const double numerator = mpz_get_d_2exp(&top, a), denominator = mpz_get_d_2exp(&bottom, b);
    if (numerator == 0) return 0;
    const long exponent = top - bottom + shift;
    if (exponent < -200 || exponent > 200) return std::numeric_limits<double>::quiet_NaN();
    return std::ldexp(numerator / denominator, static_cast<int>(exponent));
}

}  // namespace

bool setRoundingToNearest() { return std::fesetround(FE_TONEAREST) == 0; }

// A facet's normal is stored as N = n times a positive number s, and the grid's unit is 2^-shift of the unit of coordinates, which are
// multiplied by the common denominator m if there is one: then s = m^2, and t n is t N / s times m 2^shift.
FloatNormals::FloatNormals(const Certificate& c) {
    for (std::uint32_t f = 0; f < c.facets.size(); ++f) {
        std::array<double, 3> normal;
        for (std::size_t i = 0; i < 3; ++i) {
            const View component(c.normals, 3 * std::size_t{f} + i);
            normal[i] = c.points.hasCommon() ? quotient(component, c.points.common(), c.points.shift())
                                             : quotient(component, View(c.normalScales, f), c.points.shift());
        }
        normals_.push_back(normal);
    }
}

bool FloatNormals::offset(const Certificate& c, const Cell& cell, double (&result)[3]) const {
    const double t = quotient(View(c.offsets, 2 * std::size_t{cell.offset}), View(c.offsets, 2 * std::size_t{cell.offset} + 1), 0);
    for (std::size_t i = 0; i < 3; ++i) result[i] = t * normals_[cell.facet][i];
    return !std::isnan(result[0]) && !std::isnan(result[1]) && !std::isnan(result[2]);
}

// With u = b-a, w = c-a, n = u x w and T = |u|^2 w - |w|^2 u the centre is a + Z, Z = T x n / (2 |n|^2), and |Z| is the radius.
bool FloatBall::setCell(const Certificate& c, const FloatNormals& normals, const Cell& cell) {
    const Triple u = difference(c.points, cell.corner[1], cell.corner[0]), w = difference(c.points, cell.corner[2], cell.corner[0]);
    const double uu = norm2(u), ww = norm2(w), longest = uu > ww ? uu : ww;
    const Triple n = cross(u, w);
    const double nn = norm2(n);
    if (!(nn > square(largestAspect) * longest)) return false;
    const Triple v = cross({uu * w.x - ww * u.x, uu * w.y - ww * u.y, uu * w.z - ww * u.z}, n);
    Triple z{v.x / (2 * nn), v.y / (2 * nn), v.z / (2 * nn)};
    double error = centreError * (std::sqrt(norm2(z)) + std::sqrt(longest)) * std::sqrt(longest / nn);
    if (cell.offset != none) {
        double o[3];
        if (!normals.offset(c, cell, o)) return false;
        error += offsetError * std::sqrt(norm2({o[0], o[1], o[2]}));
        z = {z.x + o[0], z.y + o[1], z.z + o[2]};
    }
    const auto& origin = c.points.grid(cell.corner[0]);
    centre[0] = static_cast<double>(origin[0]) + z.x;
    centre[1] = static_cast<double>(origin[1]) + z.y;
    centre[2] = static_cast<double>(origin[2]) + z.z;
    radius2 = square(std::sqrt(norm2(z)) + 2 * error) * squareError;
    return true;
}

void FloatBall::setBall(const Points& points, std::uint32_t a, std::uint32_t b) {
    for (std::size_t i = 0; i < 3; ++i) centre[i] = static_cast<double>(points.grid(a)[i] + points.grid(b)[i]) / 2;
    radius2 = square(std::sqrt(norm2(difference(points, b, a))) / 2 + ballRoom) * squareError;
}

int floatOrientation(const Points& points, std::uint32_t p, std::uint32_t q, std::uint32_t r, int j, int k) {
    const auto difference = [&](std::uint32_t x, int axis) {
        return static_cast<double>(points.grid(x)[static_cast<std::size_t>(axis)] - points.grid(p)[static_cast<std::size_t>(axis)]);
    };
    const double uj = difference(q, j), uk = difference(q, k), wj = difference(r, j), wk = difference(r, k);
    const double determinant = uj * wk - uk * wj;
    const double error = orientationError * (std::fabs(uj) + std::fabs(uk) + std::fabs(wj) + std::fabs(wk)) + orientationRoom;
    return determinant > error ? 1 : determinant < -error ? -1 : 0;
}
