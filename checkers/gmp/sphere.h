// SPDX-License-Identifier: Apache-2.0
// The sphere of a cell, or the diametral ball of a subsegment, in exact integers.
//
// With the corner a as origin, u = b-a, w = c-a and d = x-a, the smallest sphere through a, b, c has its centre at
//     z0 - a = V / (2 D),   D = |u x w|^2,   V = |u|^2 (w x n') + |w|^2 (n' x u),   n' = u x w,
// and the power of x is |d|^2 - d.V/D. Expanding the triple products,
//     V = |w|^2 (|u|^2 - u.w) u + |u|^2 (|w|^2 - u.w) w,   D = |u|^2 |w|^2 - (u.w)^2.
// An offset t along n adds 2 t D n to V. Only D |d|^2 - d.V is computed: its sign is that of the power.
#pragma once

#include "filter.h"

__extension__ typedef __int128 Wide;  // squares of grid lengths

// Points with the lowest and the highest coordinate along each axis, among those in the box.
struct ExactBox {
    std::uint32_t low[3], high[3];
};

class Sphere {
public:
    // Without `normals` there is no float filter.
    Sphere(const Certificate& certificate, const FloatNormals* normals) : c_(certificate), points_(certificate.points), normals_(normals) {}

    void setCell(const Cell& cell);
    void setBall(std::uint32_t a, std::uint32_t b);
    // A ball that contains this one; null: in doubt, or there is no filter.
    const FloatBall* floatBall() const { return filtered_ ? &ball_ : nullptr; }
    // The sign of the power of x.
    int power(std::uint32_t x);
    // After power(x): whether x is in the plane of a facet that contains the sphere's first corner.
    bool inPlane(std::uint32_t facet);
    // After power(x): power / radius^2, rounded.
    double relativePower();

    // False: all of the box is proved outside.
    bool mayMeet(const ExactBox& box);
    // After mayMeet(box): at most the square of the distance of the centre from the box / radius^2, rounded.
    double relativeGap();

    // Conservative bounds on the grid of Points: the centre lies in [centre, centre + 2], the square of the radius is at most radius2.
    void computeBounds();
    bool boundsFit() const { return fits_; }  // in 64 and 128 bits; else only the long ones are set
    std::int64_t centre[3] = {};
    Wide radius2 = 0;
    Integer longCentre[3], longRadius2;

private:
    void makeExact();
    void makeCell();
    void addOffset();
    void makeBall();
    double quotient() const;  // square_ / other_

    const Certificate& c_;
    const Points& points_;
    const FloatNormals* normals_;
    FloatBall ball_;
    bool filtered_ = false, exact_ = false;  // exact_: the integers below belong to the cell or subsegment that was set
    const Cell* cell_ = nullptr;             // null: a subsegment
    std::uint32_t origin_ = 0, end_ = 0;
    Vector u_, w_, v_, d_;
    Integer uu_, ww_, uw_, alpha_, beta_, denominator_, value_, square_, other_;
    Integer scale_, extra_, q_;  // without a common denominator: u, w are true differences times scale
    bool fits_ = false;
};
