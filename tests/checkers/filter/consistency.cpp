// SPDX-License-Identifier: Apache-2.0
// The float filter of confidel-check against exact arithmetic, on spheres that are hard for it: points on the sphere and one unit away from
// it, slivers, coordinates far outside the range of doubles, scales that differ by many powers of two.
// A ball of the filter has to contain the exact one (tested in rationals, from the coordinates), what the filter takes to be outside has to
// have a positive exact power, and a sign that it gives has to be the exact one. Also that it decides what is clear, and that its error
// bound is not idle: some ball needs a good part of the room that it has. usage: consistency [CASES]
#include "checkers/gmp/index.h"

#include <gmpxx.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <random>

namespace {

std::mt19937_64 generator(20261122);
long below(long bound) { return static_cast<long>(generator() % static_cast<std::uint64_t>(bound)); }
mpz_class bits(int count) {
    mpz_class value = 0;
    for (; count > 0; count -= 32) value = value * (mpz_class(1) << std::min(count, 32)) + below(1L << std::min(count, 32));
    return below(2) != 0 ? value : mpz_class(-value);
}

mpq_class quotient(const mpz_class& a, const mpz_class& b) {
    mpq_class value(a, b);
    value.canonicalize();
    return value;
}

struct Place {
    mpq_class x[3];
};
mpq_class dot(const Place& a, const Place& b) { return a.x[0] * b.x[0] + a.x[1] * b.x[1] + a.x[2] * b.x[2]; }
Place operator-(const Place& a, const Place& b) { return {{a.x[0] - b.x[0], a.x[1] - b.x[1], a.x[2] - b.x[2]}}; }
Place operator+(const Place& a, const Place& b) { return {{a.x[0] + b.x[0], a.x[1] + b.x[1], a.x[2] + b.x[2]}}; }
Place operator*(const mpq_class& t, const Place& a) { return {{t * a.x[0], t * a.x[1], t * a.x[2]}}; }
Place cross(const Place& a, const Place& b) {
    return {{a.x[1] * b.x[2] - a.x[2] * b.x[1], a.x[2] * b.x[0] - a.x[0] * b.x[2], a.x[0] * b.x[1] - a.x[1] * b.x[0]}};
}
// Rounded up and down far more finely than any room that the filter leaves.
mpf_class root(const mpq_class& square) { return sqrt(mpf_class(square, 4096)); }

long failures = 0, tested = 0, decided = 0, inDoubt = 0, clear = 0, clearDecided = 0, visited = 0, detailed = 0, detailedVisited = 0, orientations = 0, orientationsDecided = 0;
double mostRoom[3] = {0, 0, 0};  // of cells, cells with an offset, subsegments: the part that was needed of what there was

void fail(const char* what) {
    if (++failures <= 10) std::printf("FAILED %s\n", what);
}

// One facet with corners 0, 1, 2 and any other points; cells and subsegments over the first points.
class Case {
public:
    explicit Case(std::vector<Place> given) : places(std::move(given)) {
        certificate.vertexCount = static_cast<std::uint32_t>(places.size());
        for (const Place& p : places) {
            mpz_class weight = 1;
            for (const mpq_class& x : p.x) weight = lcm(weight, x.get_den());
            for (const mpq_class& x : p.x) certificate.points.raw().append(mpz_class(x * weight).get_mpz_t());
            certificate.points.raw().append(weight.get_mpz_t());
        }
        certificate.points.prepare();
        certificate.pointPlane.assign(places.size(), none);
        Facet facet{};
        for (std::uint32_t i = 0; i < 3; ++i) facet.corner[i] = i;
        certificate.facets.push_back(facet);
        Vector u, w, n;
        certificate.points.difference(u, 1, 0);
        certificate.points.difference(w, 2, 0);
        cross(n, u, w);
        for (int i = 0; i < 3; ++i) certificate.normals.append(n[i]);
        Integer scale, other;
        certificate.points.differenceScale(scale, 1, 0);
        certificate.points.differenceScale(other, 2, 0);
        mpz_mul(scale, scale, other);
        if (!certificate.points.hasCommon()) certificate.normalScales.append(scale);
        normals = std::make_unique<FloatNormals>(certificate);
        for (const unsigned long part : {5, 3}) certificate.offsets.append(mpz_class(part).get_mpz_t());  // of no cell here
        for (std::uint32_t i = 0; i < places.size(); ++i) all.push_back(i);
        index = std::make_unique<Index>(certificate, all, 1);
        unit = 1;
        if (certificate.points.hasCommon()) unit = mpq_class(mpz_class(certificate.points.common()));
        if (certificate.points.shift() >= 0) unit *= mpz_class(1) << static_cast<mp_bitcnt_t>(certificate.points.shift());
        else unit /= mpz_class(1) << static_cast<mp_bitcnt_t>(-certificate.points.shift());
        for (std::uint32_t i = 0; i < places.size(); ++i)
            for (std::size_t axis = 0; axis < 3; ++axis) {
                const mpq_class x = unit * (places[i].x[axis] - places[0].x[axis]), low = mpz_class(certificate.points.grid(i)[axis]);
                if (x < low || x > low + 1 || abs(low) > (mpz_class(1) << 48)) fail("a point is not in its box of the grid");
            }
    }

    // The cell of the first three points, beginning with any of them. (Point 0 is the origin of the grid.)
    void testCell(const mpq_class* offset) {
        Cell cell{};
        cell.offset = none;
        const auto turn = static_cast<std::uint32_t>(below(6));
        for (std::uint32_t i = 0; i < 3; ++i) cell.corner[i] = turn < 3 ? i : (i + turn) % 3;
        const Place u = places[1] - places[0], w = places[2] - places[0], n = cross(u, w);
        const mpq_class uu = dot(u, u), ww = dot(w, w), uw = dot(u, w), nn = dot(n, n);
        if (sgn(nn) == 0) return;
        Place z = mpq_class(ww * (uu - uw) / (2 * nn)) * u + mpq_class(uu * (ww - uw) / (2 * nn)) * w;
        if (offset != nullptr) {
            cell.offset = static_cast<std::uint32_t>(certificate.offsets.size() / 2);
            certificate.offsets.append(offset->get_num_mpz_t());
            certificate.offsets.append(offset->get_den_mpz_t());
            z = z + *offset * n;
        }
        Sphere sphere(certificate, normals.get());
        sphere.setCell(cell);
        // Clear: every corner's angle is far above the flattest that the filter accepts.
        const mpq_class longest = std::max(uu, ww), clearAspect = mpz_class(1) << 34;
        const bool wellShaped = offset == nullptr && nn > clearAspect * longest / (unit * unit);
        if (wellShaped) ++clear;
        if (wellShaped && sphere.floatBall() != nullptr) ++clearDecided;
        testBall(sphere, places[0] + z, dot(z, z), offset != nullptr ? 1 : 0);
    }
    void testSubsegment(std::uint32_t a, std::uint32_t b) {
        Sphere sphere(certificate, normals.get());
        sphere.setBall(a, b);
        const Place half = mpq_class(1, 2) * (places[b] - places[a]);
        testBall(sphere, places[a] + half, dot(half, half), 2);
    }
    void testOrientation(std::uint32_t p, std::uint32_t q, std::uint32_t r) {
        const Place n = cross(places[q] - places[p], places[r] - places[p]);
        for (int axis = 0; axis < 3; ++axis) {
            const int sign = floatOrientation(certificate.points, p, q, r, (axis + 1) % 3, (axis + 2) % 3);
            ++orientations;
            if (sign != 0) ++orientationsDecided;
            if (sign != 0 && sign != sgn(n.x[axis])) fail("an orientation");
        }
    }

private:
    struct Seen {
        void begin(Reach& reach) { reach.setOuter(outer, outer > 0); }
        void near(std::uint32_t x) { points.push_back(x); }
        void far(std::uint32_t x) {
            if (outer <= 0) fail("a far point is not wanted");
            others.push_back(x);
        }
        double outer;
        std::vector<std::uint32_t> points, others;
    };

    // The search passes over what is outside, and, if that is wanted, over what has a greater power relative to the square of the radius.
    void testSearch(Sphere& sphere, const Place& centre, const mpq_class& radius2) {
        Seen seen;
        seen.outer = below(2) == 0 ? 0 : std::ldexp(static_cast<double>(1 + below(1000)), -static_cast<int>(below(24)));
        searchSphere(*index, sphere, none, seen);
        std::sort(seen.points.begin(), seen.points.end());
        std::sort(seen.others.begin(), seen.others.end());
        const mpq_class most = mpq_class(seen.outer) * radius2;
        for (std::uint32_t x = 0; x < places.size(); ++x) {
            const Place d = places[x] - centre;
            const mpq_class power = dot(d, d) - radius2;
            if (sphere.power(x) != sgn(power)) fail("an exact power");
            if (std::binary_search(seen.points.begin(), seen.points.end(), x)) continue;
            ++decided;
            if (sgn(power) <= 0) fail("a point in or on the ball is taken to be outside");
            if (power <= most && !std::binary_search(seen.others.begin(), seen.others.end(), x)) fail("a point that is near enough is not seen");
        }
        visited += static_cast<long>(seen.points.size());
    }

    void testBall(Sphere& sphere, const Place& centre, const mpq_class& radius2, int kind) {
        testSearch(sphere, centre, radius2);
        const FloatBall* ball = sphere.floatBall();
        if (ball == nullptr) {
            ++inDoubt;
            return;
        }
        ++tested;
        // In units of the grid, from point 0.
        const Place exact = unit * (centre - places[0]);
        const Place moved = exact - Place{{ball->centre[0], ball->centre[1], ball->centre[2]}};
        const mpf_class needed = root(dot(moved, moved)) + root(radius2 * unit * unit), there = root(mpq_class(ball->radius2));
        if (needed > there) fail("a ball does not contain the exact one");
        // What the ball is larger by, and how much of it is needed.
        const mpf_class smallest = root(radius2 * unit * unit) - root(dot(moved, moved));
        if (smallest < there) mostRoom[kind] = std::max(mostRoom[kind], mpf_class((needed - smallest) / (there - smallest)).get_d());
    }

    Certificate certificate;
    std::vector<Place> places;
    std::vector<std::uint32_t> all;
    std::unique_ptr<FloatNormals> normals;
    std::unique_ptr<Index> index;
    mpq_class unit;  // of coordinates, in units of the grid
};

// Images of one vector under changes of order and sign lie on one sphere around 0; so does what is one unit further in or out not.
std::vector<Place> sphereOfImages(int size) {
    const mpz_class x[3] = {bits(size) + 1, bits(size) + 2, bits(size)};
    std::vector<Place> images;
    int order[3] = {0, 1, 2};
    do
        for (int signs = 0; signs < 8; ++signs) {
            Place p;
            for (int i = 0; i < 3; ++i) p.x[i] = (signs >> i & 1) != 0 ? mpz_class(-x[order[i]]) : x[order[i]];
            images.push_back(p);
        }
    while (std::next_permutation(order, order + 3));
    std::shuffle(images.begin(), images.end(), generator);
    return images;
}

void move(std::vector<Place>& places, const mpq_class& scale, const Place& by) {
    for (Place& p : places) p = scale * p + by;
}
mpq_class anyScale() {
    mpq_class scale = mpz_class(1 + below(1000));
    const mpz_class power = mpz_class(1) << static_cast<mp_bitcnt_t>(below(4) == 0 ? 1500 + below(800) : below(60));
    if (below(2) != 0) scale *= power;
    else scale /= power;
    if (below(2) != 0) scale /= 3 + 2 * below(1000);
    scale.canonicalize();
    return scale;
}
// Points that make the grid coarse: up to 2^size away.
void addExtent(std::vector<Place>& places, int size) {
    for (int k = 0; k < 2; ++k) places.push_back({{bits(size), bits(size), bits(size)}});
}
Place anywhere(int size) { return {{quotient(bits(size), 7), quotient(bits(size), 11), quotient(bits(size), 13)}}; }

void onSpheres() {
    std::vector<Place> places = sphereOfImages(static_cast<int>(4 + below(40)));
    // Corners P, Q, -P: the smallest circle has its centre in 0.
    places[2] = mpq_class(-1) * places[0];
    for (std::size_t i = 3; i < 20; ++i) {
        Place p = places[i];
        p.x[below(3)] += below(2) != 0 ? 1 : -1;
        places.push_back(p);
    }
    if (below(2) != 0) addExtent(places, static_cast<int>(8 + below(70)));
    if (below(4) == 0) places.push_back(anywhere(30));  // weights of their own
    move(places, anyScale(), anywhere(static_cast<int>(below(60))));
    Case test(places);
    test.testCell(nullptr);
    test.testSubsegment(0, 2);
    test.testOrientation(0, 1, 2);
    // A sphere of the same points that is not the smallest of its cell: the centre is t n away from the circle's.
    if (below(2) == 0) return;
    const auto square = [](const Place& a) { return dot(a, a); };
    Place a = places[3], b = places[4], c = places[5];
    const Place u = b - a, w = c - a, n = cross(u, w);
    if (sgn(square(n)) == 0) return;
    const Place middle = mpq_class(1, 2) * (places[0] + places[2]);
    std::swap(places[0], places[3]);
    std::swap(places[1], places[4]);
    std::swap(places[2], places[5]);
    const mpq_class offset = dot(middle - a, n) / square(n);
    Case other(places);
    if (sgn(offset) != 0) other.testCell(&offset);
}

// A detail with many points in one cell of the grid, or in a few: images on a sphere, and points beside it.
void details() {
    const int size = static_cast<int>(4 + below(30));
    std::vector<Place> places = sphereOfImages(size), images = places;
    places[2] = mpq_class(-1) * places[0];
    const long unit = 1 + below(1L << std::max(1, size - 4));
    for (int k = 0; k < 3; ++k)
        for (Place p : images) {
            p.x[below(3)] += quotient((below(2) != 0 ? 1 : -1) * unit, 1 + 2 * below(2));
            places.push_back(p);
        }
    for (int k = 0; k < 600; ++k) places.push_back({{bits(size + 3), bits(size + 3), bits(size + 3)}});
    addExtent(places, size + (below(4) == 0 ? 40 : 56) + static_cast<int>(below(20)));
    if (below(4) == 0) places.push_back(anywhere(30));  // weights of their own
    move(places, anyScale(), anywhere(static_cast<int>(below(60))));
    const long before = visited;
    Case test(places);
    const mpq_class offset = quotient(1 + below(1000), 1 + below(1000)) * (below(2) != 0 ? 1 : -1);
    test.testCell(nullptr);
    test.testSubsegment(0, 2);
    detailed += 2 * static_cast<long>(places.size());
    detailedVisited += visited - before;
    test.testCell(&offset);
    test.testSubsegment(1, static_cast<std::uint32_t>(3 + below(40)));
    test.testSubsegment(1, static_cast<std::uint32_t>(places.size() - 1));
}

void slivers() {
    const int size = static_cast<int>(20 + below(40)), height = static_cast<int>(1 + below(size));
    std::vector<Place> places{anywhere(10), {{bits(size), bits(size), bits(size)}}, {}};
    const mpq_class t = quotient(1 + below(1 << 20), 1 << 20);
    const Place along = places[1] - places[0];
    places[2] = places[0] + t * along + Place{{bits(height), bits(height), bits(height)}};
    for (int k = 0; k < 6; ++k) places.push_back(places[static_cast<std::size_t>(below(3))] + anywhere(static_cast<int>(below(size))));
    addExtent(places, static_cast<int>(below(3) == 0 ? 8 : size + below(20)));
    move(places, anyScale(), anywhere(static_cast<int>(below(60))));
    Case test(places);
    test.testCell(nullptr);
    const mpq_class offset = quotient(1 + below(1000), 1 + below(1000)) * (below(2) != 0 ? 1 : -1) / anyScale();
    test.testCell(&offset);
    for (std::uint32_t k = 1; k + 1 < places.size(); ++k) {
        test.testSubsegment(k, k + 1);
        test.testOrientation(k - 1, k, k + 1);
    }
}

// Small triangles beside a large extent, with coordinates just below and above integers of the grid: the room has to be used.
void roundings() {
    const auto edge = [](int size) -> mpq_class {
        const mpq_class fraction = quotient(below(2) != 0 ? 1 : 4095, 4096);
        return mpq_class(bits(size)) + fraction;
    };
    const int size = static_cast<int>(17 + below(28));
    std::vector<Place> places;
    for (int k = 0; k < 6; ++k) places.push_back({{edge(size), edge(size), edge(below(2) != 0 ? size : 17)}});
    std::rotate(places.begin(), places.begin() + 3, places.end());
    if (below(2) != 0) {
        // Three points nearly on a line, the middle one rounded the other way than the ends, and the line across the grid's diagonal: the worst case of (1).
        const mpq_class length = mpz_class(1) << static_cast<mp_bitcnt_t>(size), height = mpz_class((below(1 << 10) + (1 << 18)) * (below(2) != 0 ? 1 : -1)), fraction = quotient(4095, 4096);
        places[0] = {{0, 0, 0}};
        places[1] = {{length + fraction, fraction - length, fraction}};
        places[2] = {{height - length + fraction, height + length + fraction, height + fraction}};
        // The same, so near to the line that the orientation is in doubt, or just not.
        places[3] = {{below(8) - length + fraction - 6, below(8) + length + fraction - 6, fraction}};
    }
    const mpq_class extent = mpz_class(1) << 47;
    places.push_back(places[0] + Place{{extent, extent, -extent}});
    Case test(places);
    test.testCell(nullptr);
    for (std::uint32_t k = 1; k + 1 < places.size(); ++k) {
        test.testSubsegment(k, k + 1);
        test.testOrientation(k - 1, k, k + 1);
    }
    test.testOrientation(0, 1, 3);
}

// Centres so far away along one axis that the rounding of the offset is larger than all other errors.
void farCentres() {
    const auto axis = static_cast<std::size_t>(below(3));
    std::vector<Place> places;
    for (int k = 0; k < 6; ++k) places.push_back({{bits(20), bits(20), bits(20)}});
    for (std::size_t k = 0; k < 3; ++k) places[k].x[axis] = 7;
    addExtent(places, 30);
    Case test(places);
    const mpq_class offset = quotient(bits(60), 2 * below(1L << 55) + 1);
    if (sgn(offset) != 0) test.testCell(&offset);
}

}  // namespace

int main(int count, char** arguments) {
    const long cases = count > 1 ? std::atol(arguments[1]) : 2000;
    if (!setRoundingToNearest()) return 70;
    for (long k = 0; k < cases; ++k) {
        onSpheres();
        slivers();
        roundings();
        if (k % 64 == 0) details();
    }
    for (long k = 0; k < cases; ++k) farCentres();
    std::printf("%ld balls, %ld in doubt, %ld of %ld clear ones decided; %ld points decided; %ld of %ld orientations decided\n", tested, inDoubt, clearDecided, clear,
                decided, orientationsDecided, orientations);
    std::printf("largest part of the room that was needed: cells %.3f, with offset %.3f, subsegments %.3f\n", mostRoom[0], mostRoom[1], mostRoom[2]);
    // Otherwise a bound that is too small might stay unnoticed.
    if (mostRoom[0] < 0.5 || mostRoom[2] < 0.7) fail("the room of the balls is never used");
    if (clear < cases / 2 || clearDecided != clear) fail("the filter does not decide what is clear");
    std::printf("details: %ld of %ld points visited\n", detailedVisited, detailed);
    if (detailedVisited > detailed * 2 / 3) fail("the search in a detail does not pass over what is outside");
    std::printf("%ld failures\n", failures);
    return failures == 0 ? 0 : 1;
}
