// SPDX-License-Identifier: GPL-3.0-or-later
// One translation unit, because its number type is slow to compile: CORE's expressions, whose signs are exact by root separation bounds.
#include "proofs/lemmas/algebraic.h"

#include <CGAL/CORE_Expr.h>
#include <fmt/format.h>

#include <array>
#include <limits>

namespace confidel {
namespace {

using Number = CORE::Expr;
using Plane = std::array<Number, 2>;
using Space3 = std::array<Number, 3>;

Number root(const Number& square) { return CORE::sqrt(square); }
Number ratio(int a, int b) { return Number(a) / Number(b); }

Space3 minus(const Space3& a, const Space3& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
Space3 plus(const Space3& a, const Space3& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
Space3 times(const Number& t, const Space3& a) { return {t * a[0], t * a[1], t * a[2]}; }
Number dot(const Space3& a, const Space3& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Space3 cross(const Space3& a, const Space3& b) { return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]}; }

/// cos and sin of an angle.
struct Angle {
  Number cosine, sine;
};
Angle half(const Angle& a) { return {root((1 + a.cosine) / 2), root((1 - a.cosine) / 2)}; }  // up to 180 degrees
Angle sum(const Angle& a, const Angle& b) { return {a.cosine * b.cosine - a.sine * b.sine, a.sine * b.cosine + a.cosine * b.sine}; }
Angle right_angle() { return {0, 1}; }
Angle sixty_degrees() { return {ratio(1, 2), root(Number(3)) / 2}; }
Angle eighteen_degrees() { return {root(10 + 2 * root(Number(5))) / 4, (root(Number(5)) - 1) / 4}; }

/// Squared circumradius of a planar triangle, and how far its circle reaches beyond the side ab, away from c.
Number squared_circumradius(const Plane& a, const Plane& b, const Plane& c) {
  const auto square = [](const Plane& p, const Plane& q) { return (p[0] - q[0]) * (p[0] - q[0]) + (p[1] - q[1]) * (p[1] - q[1]); };
  const Number area = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
  return square(a, b) * square(b, c) * square(c, a) / (4 * area * area);
}

/// Collects comparisons of one statement.
class Decision {
 public:
  Decision(std::string id, std::string statement, std::string settles) : result_{std::move(id), std::move(statement), std::move(settles), 0, true} {}
  void expect(bool good) {
    ++result_.comparisons;
    result_.holds = result_.holds && good;
  }
  AlgebraicResult result() const { return result_; }

 private:
  AlgebraicResult result_;
};

/// How far the circle of a w x d rectangle reaches beyond a side of length w.
Number box_bulge(const Number& w, const Number& d) { return (root(w * w + d * d) - d) / 2; }

AlgebraicResult box_is_extremal() {
  Decision decision("box-bulge", "a box of w = sqrt3 h, d = h bulges exactly h/2; of all w <= sqrt3 h, d >= h only this one does",
                    "2.3: \"can only bulge a distance h/2 (this occurs when d_e = h)\" is true, and attained; L4's form (w^2-h^2)^2 <= 4 h^2 d^2 has the same sign");
  const Number widest = root(Number(3));
  decision.expect(box_bulge(widest, 1) == ratio(1, 2));
  for (int i = 0; i <= 8; ++i)
    for (int j = 0; j <= 8; ++j) {
      const Number w = widest * (1 - ratio(i, 16)), d = 1 + ratio(j, 16), bulge = box_bulge(w, d);
      decision.expect(i == 0 && j == 0 ? bulge == ratio(1, 2) : bulge < ratio(1, 2));
    }
  // By a hair: 2^-40 more in w, or less in d, and it is more than h/2; L4 agrees.
  const Number hair = Number(1) / (Number(1 << 20) * Number(1 << 20));
  for (const auto& [w, d, sign] : {std::tuple<Number, Number, int>{widest, 1, 0}, {widest + hair, 1, 1}, {widest - hair, 1, -1}, {widest, 1 - hair, 1}, {widest, 1 + hair, -1}}) {
    decision.expect((box_bulge(w, d) - ratio(1, 2)).sign() == sign);
    decision.expect(((w * w - 1) * (w * w - 1) - 4 * d * d).sign() == sign);
  }
  return decision.result();
}

AlgebraicResult five_points() {
  Decision decision("five-cocircular", "the box of w = sqrt3 h, d = h and the point h/2 above the middle of its protector: five points of one circle of radius h, that point at distance h from both ends",
                    "2.3: \"five co-circular points could exist in the worst case\": in the plane they do, for these lengths");
  const Number w = root(Number(3));
  const std::array<Plane, 5> points{Plane{0, 0}, {w, 0}, {w, 1}, {0, 1}, {w / 2, ratio(3, 2)}};
  for (const Plane& p : points) {
    const Number x = p[0] - w / 2, y = p[1] - ratio(1, 2);
    decision.expect(x * x + y * y == Number(1));
  }
  for (const int end : {2, 3}) {
    const Number x = points[4][0] - points[end][0], y = points[4][1] - points[end][1];
    decision.expect(x * x + y * y == Number(1));
  }
  return decision.result();
}

AlgebraicResult own_subdivision() {
  Decision decision("box-own-subdivision", "with w <= 3h/2 and d >= h a box bulges at most (sqrt13 - 2)/4 h = 0.4014 h, and a point at distance h from both ends is sqrt7/4 h = 0.6614 h away: more",
                    "2.3: the worst case of five cocircular points never occurs in the paper's own subdivision");
  const Number w = ratio(3, 2), bulge = box_bulge(w, 1), clearance = root(1 - w * w / 4);
  decision.expect(bulge == (root(Number(13)) - 2) / 4);
  decision.expect(clearance == root(Number(7)) / 4);
  decision.expect(bulge < ratio(4015, 10000));
  decision.expect(clearance > ratio(6614, 10000));
  decision.expect(bulge < clearance);
  return decision.result();
}

AlgebraicResult isosceles_bulge() {
  Decision decision("spoke-bulge", "an isosceles triangle with apex pi/3 and base b bulges exactly b/(2 sqrt3) beyond its base; with apex pi/4, pi/6 and pi/12 less; with apex pi/2 more",
                    "2.2: \"extends a distance at most b/(2 sqrt3) beyond the base\" is true and attained at pi/3");
  const Angle sixty = sixty_degrees(), thirty = half(sixty), fifteen = half(thirty), fortyfive = half(right_angle());
  for (const auto& [apex, sign] : {std::pair<Angle, int>{sixty, 0}, {fortyfive, -1}, {thirty, -1}, {fifteen, -1}, {right_angle(), 1}}) {
    // Legs of length 1 from the apex at the origin, symmetric about the axis x.
    const Angle h = half(apex);
    const Plane a{h.cosine, -h.sine}, b{h.cosine, h.sine};
    const Number base = 2 * h.sine, radius = root(squared_circumradius(a, b, {0, 0}));
    const Number bulge = 2 * radius - h.cosine;  // the circle passes through the apex, its centre is on the axis
    decision.expect((bulge - base / (2 * root(Number(3)))).sign() == sign);
  }
  return decision.result();
}

AlgebraicResult equal_division() {
  Decision decision("arc-division", "an arc divided by k = 2, 3, 4, 5, 6: all points exactly on the circle, all chords exactly equal",
                    "2.2: equal subarcs have equal chords; these points are not rational, which is why placements round within budgets");
  const Angle fortyfive = half(right_angle()), sixty = sixty_degrees(), thirty = half(sixty), fifteen = half(thirty), eighteen = eighteen_degrees(), twentytwo = half(fortyfive);
  for (const auto& [step, k] : {std::pair<Angle, int>{fortyfive, 2}, {thirty, 3}, {twentytwo, 4}, {eighteen, 5}, {fifteen, 6}}) {
    Angle at{1, 0};
    const Number chord = 2 - 2 * step.cosine;
    for (int i = 0; i < k; ++i) {
      const Angle next = sum(at, step);
      decision.expect(next.cosine * next.cosine + next.sine * next.sine == Number(1));
      const Number x = next.cosine - at.cosine, y = next.sine - at.sine;
      decision.expect(x * x + y * y == chord);
      at = next;
    }
    decision.expect(at.cosine == Number(0) && at.sine == Number(1));
  }
  return decision.result();
}

AlgebraicResult chord_range() {
  Decision decision("chord-range", "with h the chord of phi/2, the greatest subarc (3 phi/4, excluded) has a chord < 3h/2 < sqrt3 h, the least exactly h; phi = pi/4, pi/6, pi/8, pi/12, pi/16; it comes within h/1000 of 3h/2",
                    "2.2: chords are in [h, 3h/2), not only in [h, sqrt3 h]; the bound 3/2 cannot be improved");
  const Angle fortyfive = half(right_angle()), thirty = half(sixty_degrees());
  for (const Angle& phi : {fortyfive, thirty, half(fortyfive), half(thirty), half(half(fortyfive))}) {
    const Angle eighth = half(half(half(phi)));  // psi = phi/8: h = 2 r sin(2 psi), the longest chord 2 r sin(3 psi)
    const Number h = 2 * eighth.sine * eighth.cosine, longest = eighth.sine * (3 - 4 * eighth.sine * eighth.sine);
    decision.expect(2 * longest < 3 * h);
    decision.expect(longest > h);
    decision.expect(longest * longest < 3 * h * h);
    // An arc of exactly phi: k = floor(2 phi/phi) = 2 subarcs of phi/2, chord h.
    const Angle quarter = half(half(phi));
    decision.expect(quarter.sine == h);
  }
  const Angle small = half(half(half(half(half(fortyfive)))));
  decision.expect(1000 * small.sine * (3 - 4 * small.sine * small.sine) > 1499 * 2 * small.sine * small.cosine);
  return decision.result();
}

AlgebraicResult literal_offset() {
  Decision decision("literal-offset", "with sin(beta) = 2 sin(phi/4), the printed maximum of d_e, beta > phi/2 for phi = pi/4, pi/6 and pi/8; with beta = phi/3 it is not",
                    "2.3: d_e \"computed in the same manner h is computed\" makes the protectors of two edges at the angle phi cross (L5)");
  const Angle fortyfive = half(right_angle()), thirty = half(sixty_degrees());
  for (const Angle& phi : {fortyfive, thirty, half(fortyfive)}) {
    const Number sine = 2 * half(half(phi)).sine;
    decision.expect(sine > half(phi).sine);
  }
  decision.expect(half(thirty).sine < half(fortyfive).sine);  // pi/12 = (pi/4)/3 against pi/8
  return decision.result();
}

/// Power of x over the squared radius of the smallest sphere through a, b, c; exact.
struct Sphere {
  Space3 a, twice_centre;
  Number squared_radius;
  Sphere(const Space3& from, const Space3& b, const Space3& c) : a(from) {
    const Space3 u = minus(b, a), w = minus(c, a), n = cross(u, w);
    twice_centre = times(1 / dot(n, n), plus(times(dot(u, u), cross(w, n)), times(dot(w, w), cross(n, u))));
    squared_radius = dot(twice_centre, twice_centre) / 4;
  }
  Number power(const Space3& x) const {
    const Space3 d = minus(x, a);
    return dot(d, minus(d, twice_centre)) / squared_radius;
  }
};

}  // namespace

std::vector<AlgebraicResult> decide_extremal_statements() {
  return {box_is_extremal(), five_points(), own_subdivision(), isosceles_bulge(), equal_division(), chord_range(), literal_offset()};
}

AlgebraicCorner tetrahedron_corner() {
  // r = 1, phi* = pi/4, beta = phi*/3 = 15 degrees, h = 2 r sin(phi*/12) = 2 sin(3.75 degrees): the 30 degrees that are left of each
  // face's 60 are divided into floor(2 * 30/15) = 4 subarcs of 7.5 degrees, whose chord is h exactly.
  const Angle thirty = half(sixty_degrees()), fifteen = half(thirty), step = half(fifteen);
  const Number spacing = 2 * half(step).sine;
  const Number s = root(Number(2)) / 2;
  const std::array<Space3, 3> edges{Space3{s, s, 0}, {s, 0, s}, {0, s, s}};  // unit vectors, 60 degrees apart
  AlgebraicCorner corner;
  corner.on_sphere = corner.spacing_is_h = corner.right_angles = corner.end_cells_empty = corner.spokes_miss_caps = corner.spokes_empty = true;
  struct Face {
    std::vector<Space3> arc;
  };
  std::array<Face, 3> faces;
  std::vector<Space3> caps;
  for (const Space3& edge : edges) caps.push_back(times(fifteen.cosine, edge));
  for (int f = 0; f < 3; ++f) {
    const Space3 &u = edges[f], &v = edges[(f + 1) % 3];
    const Space3 across = times(1 / sixty_degrees().sine, minus(v, times(sixty_degrees().cosine, u)));  // unit, orthogonal to u in the face
    Angle at = fifteen;
    for (int i = 0; i <= 4; ++i) {
      faces[f].arc.push_back(plus(times(at.cosine, u), times(at.sine, across)));
      at = sum(at, step);
    }
  }
  const Space3 vertex{0, 0, 0};
  const auto same = [](const Space3& a, const Space3& b) { return &a == &b; };
  const auto test = [&](const Space3& a, const Space3& b, const std::vector<Space3>& points, bool& good, double& least) {
    const Sphere sphere(vertex, a, b);
    for (const Space3& x : points) {
      if (same(x, a) || same(x, b)) continue;
      const Number power = sphere.power(x);
      if (power.sign() < 0) good = false;
      // A point is on the sphere: only the corners are, which other lists may repeat.
      if (power.sign() == 0) {
        if (!(x == a) && !(x == b)) good = false;
        continue;
      }
      least = std::min(least, power.doubleValue());
    }
  };
  corner.end_cell_slack = corner.cap_slack = corner.spoke_slack = std::numeric_limits<double>::infinity();
  corner.points = 1 + static_cast<long>(caps.size());
  for (int f = 0; f < 3; ++f) {
    const auto& arc = faces[f].arc;
    corner.points += static_cast<long>(arc.size());
    for (const Space3& p : arc) corner.on_sphere = corner.on_sphere && dot(p, p) == Number(1);
    for (const auto& [m, a] : {std::pair<const Space3&, const Space3&>{caps[f], arc.front()}, {caps[(f + 1) % 3], arc.back()}}) {
      ++corner.end_cells;
      corner.right_angles = corner.right_angles && dot(m, minus(a, m)) == Number(0);
      test(m, a, caps, corner.end_cells_empty, corner.end_cell_slack);
      for (const Face& face : faces) test(m, a, face.arc, corner.end_cells_empty, corner.end_cell_slack);
    }
    for (std::size_t i = 0; i + 1 < arc.size(); ++i) {
      ++corner.spoke_cells;
      const Space3 base = minus(arc[i + 1], arc[i]);
      corner.spacing_is_h = corner.spacing_is_h && dot(base, base) == spacing * spacing;
      test(arc[i], arc[i + 1], caps, corner.spokes_miss_caps, corner.cap_slack);
      for (const Face& face : faces) test(arc[i], arc[i + 1], face.arc, corner.spokes_empty, corner.spoke_slack);
    }
  }
  return corner;
}

}  // namespace confidel
