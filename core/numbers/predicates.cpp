// SPDX-License-Identifier: GPL-3.0-or-later
//
// Error bounds of the filters. Let u = 2^-53 and M >= 2^-100 the greatest magnitude of the points involved.
// A coordinate is high + low with an error of at most 2^-104 M, |low| <= 2^-52 |high|. The difference of two coordinates is
// computed as d = (ah - bh) + (al - bl); with delta its true value,
//   |d - delta| <= 2^-103 M (representation) + u (|delta| + 2^-51 M) + u 2^-51 M + u |d| (roundings) <= 2.01 u |d| + 2^-101 M.
// Let e = |d| + 2^-48 M. As 2^-101 M = u 2^-48 M, |d - delta| <= 2.1 u e and |d| <= e: every difference has, relative to its e, an
// error of at most 2.1 u. A polynomial of degree k whose monomials each pass through at most r roundings then has an error of at
// most (2.1 k + r + 1) u times its permanent (the polynomial over e with all signs positive), where the 1 covers second-order terms
// and the rounding of the permanent. The constants below are these numbers, rounded up generously. No underflow: e >= 2^-148, so a
// permanent of degree <= 6 is at least 2^-888, and an underflow's absolute error of 2^-1074 vanishes in the 1. Overflow gives an
// infinite or undefined bound, which decides nothing. (Coordinates below 2^-900 have an absolute error below 2^-1000: covered likewise.)
//
// Short coordinates. Let g = 2^-e, where e is the greatest exponent of the points: coordinates and differences are multiples of g, monomials of
// degree k and their sums multiples of g^k. If the permanent is below 2^53 g^k (2^52 is tested: it is computed with roundings), then nothing
// was rounded, except in factors of something that is zero: any other factor of degree j is multiplied by at least g^(k-j) and so is itself
// below 2^53 g^j. The computed sign is the exact one then, 0 included: grids, where ties abound, need no integers.
#include "core/numbers/predicates.h"

#include <algorithm>
#include <cmath>

namespace confidel {
namespace {

constexpr double unit = 0x1p-53;
constexpr double floor_factor = 0x1p-48;

struct Vector {
  double x, y, z;     // the computed differences
  double ex, ey, ez;  // their e
};

inline double difference_of(const Point& to, const Point& from, int axis) {
  return (to.high(axis) - from.high(axis)) + (to.low(axis) - from.low(axis));
}

inline Vector vector_of(const Point& to, const Point& from, double floor) {
  const double x = difference_of(to, from, 0);
  const double y = difference_of(to, from, 1);
  const double z = difference_of(to, from, 2);
  return {x, y, z, std::abs(x) + floor, std::abs(y) + floor, std::abs(z) + floor};
}

template <class... Points>
inline double floor_of(const Points&... points) {
  return floor_factor * std::max({points.magnitude()...});
}

constexpr int undecided = 2;

inline int decide(double value, double bound) {
  if (value > bound) return 1;
  if (value < -bound) return -1;
  return undecided;
}

// See "short coordinates" above. permanent: not scaled by the unit.
template <class... Points>
inline bool without_rounding(double permanent, int degree, const Points&... points) {
  const int exponent = std::max({points.exponent()...});
  if (std::abs(exponent) > 150 || !(permanent < std::ldexp(1.0, 52 - degree * exponent))) return false;
  const auto is_short = [](const Point& p) { return p.low(0) == 0 && p.low(1) == 0 && p.low(2) == 0; };
  return (is_short(points) && ...);
}

inline int sign_of(double value) { return (value > 0) - (value < 0); }

// Differences to a common reference as integers over one common denominator, in thread-local storage: the exact stage
// allocates nothing once it is warm.
struct Workspace {
  IntegerVector d[4];
  mpz_class t[24];
};

Workspace& workspace() {
  thread_local Workspace space;
  return space;
}

template <int N>
void exact_differences(const Point& reference, const std::array<const Point*, N>& points, Workspace& space) {
  int exponent = reference.exponent();
  for (const Point* point : points) exponent = std::max(exponent, point->exponent());
  mpz_class& base = space.t[0];
  for (int axis = 0; axis < 3; ++axis) {
    mpz_mul_2exp(base.get_mpz_t(), reference.numerator(axis).get_mpz_t(), exponent - reference.exponent());
    for (int i = 0; i < N; ++i) {
      auto* target = space.d[i][axis].get_mpz_t();
      mpz_mul_2exp(target, points[i]->numerator(axis).get_mpz_t(), exponent - points[i]->exponent());
      mpz_sub(target, target, base.get_mpz_t());
    }
  }
}

// result = a[i] b[j] - a[j] b[i]
void minor_of(mpz_class& result, const IntegerVector& a, const IntegerVector& b, int i, int j) {
  mpz_mul(result.get_mpz_t(), a[i].get_mpz_t(), b[j].get_mpz_t());
  mpz_submul(result.get_mpz_t(), a[j].get_mpz_t(), b[i].get_mpz_t());
}

void cross_into(mpz_class* result, const IntegerVector& a, const IntegerVector& b) {
  minor_of(result[0], a, b, 1, 2);
  minor_of(result[1], a, b, 2, 0);
  minor_of(result[2], a, b, 0, 1);
}

void dot_into(mpz_class& result, const mpz_class* a, const mpz_class* b) {
  mpz_mul(result.get_mpz_t(), a[0].get_mpz_t(), b[0].get_mpz_t());
  mpz_addmul(result.get_mpz_t(), a[1].get_mpz_t(), b[1].get_mpz_t());
  mpz_addmul(result.get_mpz_t(), a[2].get_mpz_t(), b[2].get_mpz_t());
}

int exact_orientation(const Point& a, const Point& b, const Point& c, const Point& d) {
  Workspace& s = workspace();
  exact_differences<3>(a, {&b, &c, &d}, s);
  cross_into(&s.t[1], s.d[0], s.d[1]);
  dot_into(s.t[4], &s.t[1], s.d[2].data());
  return sgn(s.t[4]);
}

constexpr int first_axis[3] = {1, 2, 0};
constexpr int second_axis[3] = {2, 0, 1};

int exact_planar_orientation(Projection projection, const Point& a, const Point& b, const Point& c) {
  Workspace& s = workspace();
  exact_differences<2>(a, {&b, &c}, s);
  minor_of(s.t[1], s.d[0], s.d[1], first_axis[projection.axis], second_axis[projection.axis]);
  return sgn(s.t[1]) * projection.sign;
}

int exact_planar_in_circle(Projection projection, const Point& a, const Point& b, const Point& c, const Point& d) {
  Workspace& s = workspace();
  exact_differences<3>(d, {&a, &b, &c}, s);
  const int i = first_axis[projection.axis];
  const int j = second_axis[projection.axis];
  mpz_class& sum = s.t[1];
  sum = 0;
  for (int k = 0; k < 3; ++k) {
    dot_into(s.t[2], s.d[k].data(), s.d[k].data());
    minor_of(s.t[3], s.d[(k + 1) % 3], s.d[(k + 2) % 3], i, j);
    mpz_addmul(sum.get_mpz_t(), s.t[2].get_mpz_t(), s.t[3].get_mpz_t());
  }
  return sgn(sum) * projection.sign;
}

int exact_diametral_power(const Point& a, const Point& b, const Point& c, const Point& x) {
  Workspace& s = workspace();
  exact_differences<3>(a, {&b, &c, &x}, s);
  const IntegerVector &u = s.d[0], &w = s.d[1], &d = s.d[2];
  // |n|^2 P0 = |n|^2 |d|^2 - d . (|u|^2 (w x n) + |w|^2 (n x u)), n = u x w; as d.(w x n) = (d x w).n and d.(n x u) = (u x d).n.
  cross_into(&s.t[1], u, w);  // n in t[1..3]
  cross_into(&s.t[4], d, w);
  cross_into(&s.t[7], u, d);
  dot_into(s.t[10], &s.t[4], &s.t[1]);         // (d x w).n
  dot_into(s.t[11], &s.t[7], &s.t[1]);         // (u x d).n
  dot_into(s.t[12], u.data(), u.data());       // |u|^2
  dot_into(s.t[13], w.data(), w.data());       // |w|^2
  dot_into(s.t[14], &s.t[1], &s.t[1]);         // |n|^2
  dot_into(s.t[15], d.data(), d.data());       // |d|^2
  mpz_mul(s.t[16].get_mpz_t(), s.t[14].get_mpz_t(), s.t[15].get_mpz_t());
  mpz_submul(s.t[16].get_mpz_t(), s.t[12].get_mpz_t(), s.t[10].get_mpz_t());
  mpz_submul(s.t[16].get_mpz_t(), s.t[13].get_mpz_t(), s.t[11].get_mpz_t());
  return sgn(s.t[16]);
}

int exact_in_sphere(const Point& a, const Point& b, const Point& c, const Point& d, const Point& e) {
  Workspace& s = workspace();
  exact_differences<4>(e, {&a, &b, &c, &d}, s);
  // The determinant of the rows (d_i, |d_i|^2), expanded along the last column.
  mpz_class& sum = s.t[1];
  sum = 0;
  for (int k = 0; k < 4; ++k) {
    const IntegerVector& p = s.d[(k + 1) % 4];
    const IntegerVector& q = s.d[(k + 2) % 4];
    const IntegerVector& r = s.d[(k + 3) % 4];
    cross_into(&s.t[2], p, q);
    dot_into(s.t[5], &s.t[2], r.data());
    dot_into(s.t[6], s.d[k].data(), s.d[k].data());
    if (k % 2 == 0)
      mpz_addmul(sum.get_mpz_t(), s.t[5].get_mpz_t(), s.t[6].get_mpz_t());
    else
      mpz_submul(sum.get_mpz_t(), s.t[5].get_mpz_t(), s.t[6].get_mpz_t());
  }
  return sgn(sum);
}

inline double determinant(const Vector& p, const Vector& q, const Vector& r) {
  return p.x * (q.y * r.z - q.z * r.y) + p.y * (q.z * r.x - q.x * r.z) + p.z * (q.x * r.y - q.y * r.x);
}

inline double permanent(const Vector& p, const Vector& q, const Vector& r) {
  return p.ex * (q.ey * r.ez + q.ez * r.ey) + p.ey * (q.ez * r.ex + q.ex * r.ez) + p.ez * (q.ex * r.ey + q.ey * r.ex);
}

inline double square(const Vector& p) { return p.x * p.x + p.y * p.y + p.z * p.z; }
inline double square_bound(const Vector& p) { return p.ex * p.ex + p.ey * p.ey + p.ez * p.ez; }

}  // namespace

int orientation(const Point& a, const Point& b, const Point& c, const Point& d) {
  const double floor = floor_of(a, b, c, d);
  const Vector p = vector_of(b, a, floor);
  const Vector q = vector_of(c, a, floor);
  const Vector r = vector_of(d, a, floor);
  // degree 3, at most 5 roundings
  const double value = determinant(p, q, r), bound = permanent(p, q, r);
  const int sign = decide(value, 16 * unit * bound);
  if (sign != undecided) return sign;
  return without_rounding(bound, 3, a, b, c, d) ? sign_of(value) : exact_orientation(a, b, c, d);
}

bool collinear(const Point& a, const Point& b, const Point& c) {
  const double floor = floor_of(a, b, c);
  const Vector p = vector_of(b, a, floor);
  const Vector q = vector_of(c, a, floor);
  // degree 2, 2 roundings: one component that is certainly not zero decides
  if (decide(p.y * q.z - p.z * q.y, 8 * unit * (p.ey * q.ez + p.ez * q.ey)) != undecided) return false;
  if (decide(p.z * q.x - p.x * q.z, 8 * unit * (p.ez * q.ex + p.ex * q.ez)) != undecided) return false;
  if (decide(p.x * q.y - p.y * q.x, 8 * unit * (p.ex * q.ey + p.ey * q.ex)) != undecided) return false;
  Workspace& s = workspace();
  exact_differences<2>(a, {&b, &c}, s);
  cross_into(&s.t[1], s.d[0], s.d[1]);
  return s.t[1] == 0 && s.t[2] == 0 && s.t[3] == 0;
}

Projection projection_of(const IntegerVector& normal) {
  Projection result;
  for (int axis : {1, 0})
    if (mpz_cmpabs(normal[axis].get_mpz_t(), normal[result.axis].get_mpz_t()) > 0) result.axis = axis;
  result.sign = sgn(normal[result.axis]);
  return result;
}

int planar_orientation(Projection projection, const Point& a, const Point& b, const Point& c) {
  const int i = first_axis[projection.axis];
  const int j = second_axis[projection.axis];
  const double floor = floor_of(a, b, c);
  const double px = difference_of(b, a, i), py = difference_of(b, a, j);
  const double qx = difference_of(c, a, i), qy = difference_of(c, a, j);
  const double bound = (std::abs(px) + floor) * (std::abs(qy) + floor) + (std::abs(py) + floor) * (std::abs(qx) + floor);
  // degree 2, 2 roundings
  const double value = px * qy - py * qx;
  const int sign = decide(value, 8 * unit * bound);
  if (sign != undecided) return sign * projection.sign;
  return without_rounding(bound, 2, a, b, c) ? sign_of(value) * projection.sign : exact_planar_orientation(projection, a, b, c);
}

int planar_compare_axis(Projection projection, int which, const Point& a, const Point& b) {
  // A negative sign exchanges the axes, so that orientation is that of the pair (axis 0, axis 1).
  const int axis = (which == 0) == (projection.sign > 0) ? first_axis[projection.axis] : second_axis[projection.axis];
  if (a.high(axis) != b.high(axis)) return a.high(axis) < b.high(axis) ? -1 : 1;
  Workspace& s = workspace();
  const int exponent = std::max(a.exponent(), b.exponent());
  mpz_mul_2exp(s.t[0].get_mpz_t(), a.numerator(axis).get_mpz_t(), exponent - a.exponent());
  mpz_mul_2exp(s.t[1].get_mpz_t(), b.numerator(axis).get_mpz_t(), exponent - b.exponent());
  const int sign = cmp(s.t[0], s.t[1]);
  return (sign > 0) - (sign < 0);
}

int planar_compare(Projection projection, const Point& a, const Point& b) {
  const int sign = planar_compare_axis(projection, 0, a, b);
  return sign != 0 ? sign : planar_compare_axis(projection, 1, a, b);
}

int planar_in_circle(Projection projection, const Point& a, const Point& b, const Point& c, const Point& d) {
  const int i = first_axis[projection.axis];
  const int j = second_axis[projection.axis];
  const double floor = floor_of(a, b, c, d);
  const Vector v[3] = {vector_of(a, d, floor), vector_of(b, d, floor), vector_of(c, d, floor)};
  const auto component = [](const Vector& p, int axis) { return axis == 0 ? p.x : axis == 1 ? p.y : p.z; };
  const auto bound_of = [](const Vector& p, int axis) { return axis == 0 ? p.ex : axis == 1 ? p.ey : p.ez; };
  double value = 0, bound = 0;
  for (int k = 0; k < 3; ++k) {
    const Vector &p = v[(k + 1) % 3], &q = v[(k + 2) % 3];
    value += square(v[k]) * (component(p, i) * component(q, j) - component(p, j) * component(q, i));
    bound += square_bound(v[k]) * (bound_of(p, i) * bound_of(q, j) + bound_of(p, j) * bound_of(q, i));
  }
  // degree 4, at most 3 + 2 + 1 + 3 roundings
  const int sign = decide(value, 24 * unit * bound);
  if (sign != undecided) return sign * projection.sign;
  return without_rounding(bound, 4, a, b, c, d) ? sign_of(value) * projection.sign : exact_planar_in_circle(projection, a, b, c, d);
}

int diametral_power(const Point& a, const Point& b, const Point& c, const Point& x) {
  const double floor = floor_of(a, b, c, x);
  const Vector u = vector_of(b, a, floor);
  const Vector w = vector_of(c, a, floor);
  const Vector d = vector_of(x, a, floor);
  const double nx = u.y * w.z - u.z * w.y, ny = u.z * w.x - u.x * w.z, nz = u.x * w.y - u.y * w.x;
  const double enx = u.ey * w.ez + u.ez * w.ey, eny = u.ez * w.ex + u.ex * w.ez, enz = u.ex * w.ey + u.ey * w.ex;
  const double dwn = (d.y * w.z - d.z * w.y) * nx + (d.z * w.x - d.x * w.z) * ny + (d.x * w.y - d.y * w.x) * nz;
  const double udn = (u.y * d.z - u.z * d.y) * nx + (u.z * d.x - u.x * d.z) * ny + (u.x * d.y - u.y * d.x) * nz;
  const double edwn = (d.ey * w.ez + d.ez * w.ey) * enx + (d.ez * w.ex + d.ex * w.ez) * eny + (d.ex * w.ey + d.ey * w.ex) * enz;
  const double eudn = (u.ey * d.ez + u.ez * d.ey) * enx + (u.ez * d.ex + u.ex * d.ez) * eny + (u.ex * d.ey + u.ey * d.ex) * enz;
  const double value = (nx * nx + ny * ny + nz * nz) * square(d) - square(u) * dwn - square(w) * udn;
  const double bound = (enx * enx + eny * eny + enz * enz) * square_bound(d) + square_bound(u) * edwn + square_bound(w) * eudn;
  // degree 6, at most 2 + 2 + 3 + 3 + 1 + 2 roundings in a monomial
  const int sign = decide(value, 40 * unit * bound);
  if (sign != undecided) return sign;
  return without_rounding(bound, 6, a, b, c, x) ? sign_of(value) : exact_diametral_power(a, b, c, x);
}

int diametral_power(const Point& a, const Point& b, const Point& x) {
  const double floor = floor_of(a, b, x);
  const Vector p = vector_of(x, a, floor);
  const Vector q = vector_of(x, b, floor);
  // degree 2, 3 roundings
  const int sign = decide(p.x * q.x + p.y * q.y + p.z * q.z, 10 * unit * (p.ex * q.ex + p.ey * q.ey + p.ez * q.ez));
  if (sign != undecided) return sign;
  Workspace& s = workspace();
  exact_differences<2>(x, {&a, &b}, s);
  dot_into(s.t[1], s.d[0].data(), s.d[1].data());
  return sgn(s.t[1]);
}

int in_sphere(const Point& a, const Point& b, const Point& c, const Point& d, const Point& e) {
  const double floor = floor_of(a, b, c, d, e);
  const Vector v[4] = {vector_of(a, e, floor), vector_of(b, e, floor), vector_of(c, e, floor), vector_of(d, e, floor)};
  double value = 0, bound = 0;
  for (int k = 0; k < 4; ++k) {
    const Vector &p = v[(k + 1) % 4], &q = v[(k + 2) % 4], &r = v[(k + 3) % 4];
    const double term = square(v[k]) * determinant(p, q, r);
    value += k % 2 == 0 ? term : -term;
    bound += square_bound(v[k]) * permanent(p, q, r);
  }
  // degree 5, at most 3 + 5 + 1 + 3 roundings
  const int sign = decide(value, 40 * unit * bound);
  if (sign != undecided) return sign;
  return without_rounding(bound, 5, a, b, c, d, e) ? sign_of(value) : exact_in_sphere(a, b, c, d, e);
}

int compare_distance(const Point& p, const Point& a, const Point& b) {
  const double floor = floor_of(p, a, b);
  const Vector x = vector_of(a, p, floor);
  const Vector y = vector_of(b, p, floor);
  // degree 2, 4 roundings
  const int sign = decide(square(x) - square(y), 10 * unit * (square_bound(x) + square_bound(y)));
  if (sign != undecided) return sign;
  Workspace& s = workspace();
  exact_differences<2>(p, {&a, &b}, s);
  dot_into(s.t[1], s.d[0].data(), s.d[0].data());
  dot_into(s.t[2], s.d[1].data(), s.d[1].data());
  const int exact = cmp(s.t[1], s.t[2]);
  return (exact > 0) - (exact < 0);
}

bool strictly_between(const Point& a, const Point& b, const Point& p) { return diametral_power(a, b, p) < 0; }

}  // namespace confidel
