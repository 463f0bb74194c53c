# SPDX-License-Identifier: Apache-2.0
"""Refutations: points that satisfy the hypotheses and still lie in the sphere of a cell; and what is wrong with others."""
from fractions import Fraction as Q

from claim_bases import dot, sub
from claim_cases import TINY, norm

HYPOTHESES = ("H-angle", "H-ball", "H-offset", "H-chord", "L1", "L21")


def centre(a, b, c):
    u, w = sub(b, a), sub(c, a)
    uu, ww, uw = norm(u), norm(w), dot(u, w)
    alpha, beta, twice = ww * (uu - uw), uu * (ww - uw), 2 * (uu * ww - uw * uw)
    return tuple(a[i] + (alpha * u[i] + beta * w[i]) / twice for i in range(len(a)))


class Refutation:
    """The complex is given by rings; cells name points by their places."""

    def __init__(self, m, dim, vertices, rings, parameters, points, cells):
        self.m, self.dim, self.vertices, self.rings, self.parameters = m, dim, vertices, rings, parameters
        self.points, self.cells = list(points), list(cells)   # (kind, carrier, place); (facet, places, kind)
        self.segments = m.undirected(e for ring in rings for e in m.loop(ring))
        self.claims = None

    def number(self, p):
        return self.vertices.index(p) if p in self.vertices else len(self.vertices) + [place for _, _, place in self.points].index(p)

    def power(self, t, p):
        z = centre(*self.cells[t][1][:3])
        return norm(sub(p, z)) - norm(sub(self.cells[t][1][0], z))

    def certificate(self, lemma, evidence):
        m = self.m
        c = m.Certificate(self.dim, self.vertices, self.segments, [dict(corners=ring[:2] + [ring[min(3, len(ring) - 1)]], boundary=m.loop(ring)) for ring in self.rings])
        c.points = [("%s %d" % (kind, carrier), place) for kind, carrier, place in self.points]
        boxes = 0
        for f, places, kind in self.cells:
            t = [self.number(p) for p in places]
            c.cells.append("%d %d %d %d %s" % ((f,) + tuple(t) + (kind if kind != "R" else "R %d" % (boxes // 2),)))
            boxes += kind == "R"
        of = lambda *kinds: sum(kind in kinds for _, _, kind in self.cells)
        counts = (2 * len(self.segments), of("T", "S"), of("T"), 1, of("S"), len(self.vertices) + len(self.segments))
        c.claims = ["claim %s %d" % pair for pair in zip(HYPOTHESES, counts)] + ["refutes " + lemma]
        c.parameters, c.evidence = list(self.parameters), ["x " + " ".join(map(str, evidence))]
        return c


def wedge(m):
    """Three facets at one edge, with small angles between their planes but none between their other segments: what makes a Refutation, and the planes."""
    c, s = Q(24, 25), Q(7, 25)
    flat, up, down = (lambda x, y: (Q(x), Q(y), Q(0))), (lambda x, y: (Q(x), y * c, y * s)), (lambda x, y: (Q(x), y * c, -y * s))
    left, right = Q(-48, 5), Q(108, 5)
    outer = [up(right, Q(36, 5)), up(right, Q(72, 5)), up(left, Q(72, 5)), up(left, Q(36, 5))]
    lower = [down(right, Q(-36, 5)), down(right, Q(72, 5)), down(left, Q(72, 5)), down(left, Q(-36, 5))]
    vertices = [flat(0, 0), flat(12, 0), flat(12, 12), flat(0, 12)] + outer + lower
    rings = [[0, 1, 2, 3], [0, 1, 4, 5, 6, 7], [0, 1, 8, 9, 10, 11]]
    parameters = ["r 1/1", "h " + m.rational(Q(3, 10)), "angle 4 " + m.rational(Q(60, 61)), "offset 1", "chord 1"]
    return (lambda points, cells: Refutation(m, 3, vertices, rings, parameters, points, cells)), flat, up, down


def cap(m, r):
    """W2: a spoke triangle, and a T cell of another facet."""
    vertices = [(Q(0), Q(0), Q(0)), (Q(12), Q(0), Q(0)), (Q(0), Q(12), Q(0)), (Q(12), Q(12), Q(1))]
    foot = tuple(r * Q(40, 41) * x / 17 for x in vertices[3])
    across, length = (145, -144, -12), Q(204707, 1000)   # orthogonal to the segment, in the facet; its length
    tip = tuple(foot[i] + r * Q(9, 41) / length * across[i] for i in range(3))
    p, q = (r * Q(4, 5), r * Q(3, 5), Q(0)), (r * Q(3, 5), r * Q(4, 5), Q(0))
    parameters = ["r " + m.rational(r), "h " + m.rational(r / 4), "angle 4 " + m.rational(Q(981, 1000)), "offset 1", "chord 1"]
    points = [("projection", 2, foot), ("offset", 1, tip), ("arc", 0, p), ("arc", 0, q)]
    v = vertices[0]
    return Refutation(m, 3, vertices, [[0, 1, 2], [0, 1, 3]], parameters, points, [(0, (v, p, q), "S"), (1, (v, tip, foot), "T")])


def write_refutations(m):
    cases = Writer(m)
    cases.crossing()
    cases.cap()
    cases.wedge()


class Writer:
    def __init__(self, m):
        self.m = m

    def good(self, name, base, lemma, evidence, thing, reason):
        c = base.certificate(lemma, evidence)
        self.m.add("refute/%s.cert" % name, c.text(), 1, "s REFUTED %s %s" % (lemma, thing), reason)
        return c

    def bad(self, name, base, lemma, evidence, thing, reason, rule=None, line=None, change=None):
        c = base.certificate(lemma, evidence)
        if change:
            change(c)
        self.m.reject("refute-" + name, c, rule or lemma, line or c.evidence[0], thing, reason)

    def crossing(self):
        """Dimension 2, an angle of 45 degrees: beta = 22.6 at one segment, 22.8 at the other; the paper allows up to 22.97."""
        m, r = self.m, Q(15, 16)
        v, far, top = (Q(0), Q(0)), (Q(4), Q(0)), (Q(4), Q(4))
        parameters = ["r " + m.rational(r), "h 1/4", "angle 4 " + m.rational(Q(613, 625)), "offset 1", "chord 1"]

        def base(t, scale=1):
            a = (r * Q(12, 13) * scale, r * Q(5, 13) * scale)
            second = (r * (1 - t * t) / (1 + t * t), r * 2 * t / (1 + t * t))
            foot = ((second[0] + second[1]) / 2,) * 2
            points = [("projection", 0, (a[0], Q(0))), ("offset", 0, a), ("projection", 1, foot), ("offset", 0, second)]
            return Refutation(m, 2, [v, far, top], [[0, 1, 2]], parameters, points, [(0, (v, (a[0], Q(0)), a), "T"), (0, (v, second, foot), "T")])
        crossed = base(Q(10, 51))
        power = m.rational(crossed.power(0, crossed.points[2][2]))
        evidence, thing = [0, 1, power], "cell-0-cell-1"
        self.good("L5", crossed, "L5", evidence, thing, "protectors at an angle of 45 degrees that cross")
        self.bad("L5-power", crossed, "L5", [0, 1, m.rational(crossed.power(0, crossed.points[2][2]) + TINY)], thing, "a wrong power")
        self.bad("L5-turned", crossed, "L5", [1, 0, power], "cell-1-cell-0", "the closing cell first")
        self.bad("L5-same", crossed, "L5", [0, 0, power], "cell-0-cell-0", "the same cell twice")
        touching = base(Q(1, 5))   # a' = a: they are one point, so both cells have it
        touching.points.pop()
        self.good("L5-touching", touching, "L5", [0, 1, m.rational(touching.power(0, touching.points[2][2]))], thing, "protectors that meet in one point")
        apart = base(Q(1, 5) + TINY)
        self.bad("L5-apart", apart, "L5", [0, 1, m.rational(apart.power(0, apart.points[2][2]))], thing, "protectors that just do not cross")
        cells = crossed.certificate("L5", evidence).cells
        self.bad("L5-kinds", crossed, "L5", evidence, "cell-0-kind", "a cell of the wrong kind", "kinds", "t " + cells[0][:-1] + "S", lambda c: c.cells.__setitem__(0, cells[0][:-1] + "S"))
        self.bad("L5-point-unused", crossed, "L5", evidence, "point-7-in-no-cell", "a row point that is a corner of no cell", "carrier", "q edge 0 1 0 1",
                 lambda c: c.points.append(("edge 0", (1, 0))))
        self.bad("L5-H-angle", crossed, "L5", evidence, "segment-1-segment-0", "the angle is larger than the smallest between segments", "H-angle", "s 0 2",
                 lambda c: c.parameters.__setitem__(2, "angle 4 " + m.rational(Q(98078, 100000))))
        self.bad("L5-H-ball", crossed, "L5", evidence, "cell-0-point-4", "the radius is another one", "H-ball", "t " + cells[0], lambda c: c.parameters.__setitem__(0, "r " + m.rational(r - TINY)))
        self.bad("L5-H-offset", crossed, "L5", evidence, "cell-0-point-4", "the offset is larger than the angle allows", "H-offset", "t " + cells[0],
                 lambda c: c.parameters.__setitem__(2, "angle 4 " + m.rational(Q(99, 100))))
        self.bad("L5-H-chord", crossed, "L5", evidence, "chord-1", "the spacing is larger than the chord", "H-chord", "chord 1", lambda c: c.parameters.__setitem__(1, "h 1/2"))
        self.bad("L5-count", crossed, "L5", evidence, "count-6", "a claim with a wrong count", "H-angle", "claim H-angle 5", lambda c: c.claims.__setitem__(0, "claim H-angle 5"))
        self.bad("L5-parameter", crossed, "L5", evidence, "parameter-chord", "a parameter is missing", "H-chord", "claim H-chord 1", lambda c: c.parameters.pop())
        near = Refutation(m, 2, [v, (Q(14, 5), Q(0)), (Q(14, 5), Q(14, 5))], [[0, 1, 2]], crossed.parameters, crossed.points, crossed.cells)
        self.bad("L5-L21", near, "L5", evidence, "vertex-1-vertex-0", "the radius is more than a third of a distance", "L21", "v e 0 5")
        self.malformed(crossed, evidence)

    def malformed(self, base, evidence):
        m = self.m

        def case(name, code, line, reason, change):
            c = base.certificate("L5", evidence)
            change(c)
            m.malformed("refute-" + name, c.text(), code, line, reason)
        claims = base.certificate("L5", evidence).claims
        point, rest = m.rational(Q(-1, 2)), " ".join(map(str, evidence[:2]))
        case("claim-missing", "E-ORDER", claims[4], "a hypothesis that is not claimed", lambda c: c.claims.pop(3))
        case("claim-order", "E-ORDER", claims[1], "hypotheses out of order", lambda c: c.claims.__setitem__(slice(0, 2), claims[1::-1]))
        case("claim-more", "E-ORDER", "claim L2 0", "another claim", lambda c: c.claims.insert(5, "claim L2 0"))
        case("conforms", "E-ORDER", "refutes L5", "a refutation that claims `conforms`", lambda c: c.claims.__setitem__(slice(0, 6), ["claim conforms"]))
        case("conforms-late", "E-ORDER", "claim conforms", "`conforms` after other claims", lambda c: c.claims.insert(1, "claim conforms"))
        case("without-refutes", "E-ORDER", claims[5], "hypotheses without a refutation", lambda c: c.claims.pop())
        case("twice", "E-ORDER", "refutes L9", "two refutations", lambda c: c.claims.append("refutes L9"))
        case("alone", "E-ORDER", "refutes L5", "a refutation without hypotheses", lambda c: c.claims.__setitem__(slice(0, 6), []))
        case("unknown", "E-SYNTAX", "refutes L4", "a lemma that cannot be refuted", lambda c: c.claims.__setitem__(6, "refutes L4"))
        case("field", "E-SYNTAX", "refutes L5 1", "a field too many", lambda c: c.claims.__setitem__(6, "refutes L5 1"))
        case("evidence-none", "E-SYNTAX", "evidence 0", "no evidence", lambda c: c.evidence.clear())
        case("evidence-two", "E-SYNTAX", "evidence 2", "two lines of evidence", lambda c: c.evidence.append(c.evidence[0]))
        case("evidence-kind", "E-SYNTAX", "c 0 0 1 2 3", "evidence for L8", lambda c: c.evidence.__setitem__(0, "c 0 0 1 2 3"))
        case("evidence-cell", "E-RANGE", "x 0 2 " + point, "a cell that does not exist", lambda c: c.evidence.__setitem__(0, "x 0 2 " + point))
        case("evidence-short", "E-SYNTAX", "x " + rest, "evidence without a power", lambda c: c.evidence.__setitem__(0, "x " + rest))
        case("evidence-long", "E-SYNTAX", "x %s %s %s" % (rest, point, point), "evidence with a field too many", lambda c: c.evidence.__setitem__(0, "x %s %s %s" % (rest, point, point)))
        case("evidence-rational", "E-VALUE", "x %s -2/4" % rest, "a power not in lowest terms", lambda c: c.evidence.__setitem__(0, "x %s -2/4" % rest))

    def cap(self):
        """W2: the projection on a segment of another facet lies in the sphere of a spoke triangle."""
        m, r = self.m, Q(1, 7)
        base = cap(m, r)
        vertices, parameters, points = base.vertices, base.parameters, base.points
        foot, tip, p, q = (place for _, _, place in points)
        power = base.power(0, foot)
        assert power == Q(-6400, 200039) * r * r
        evidence, thing = [0, 4, m.rational(power)], "cell-0-point-4"
        self.good("L10", base, "L10", evidence, thing, "the paper's parameters: the witness W2, of radius 1/7")
        self.bad("L10-power", base, "L10", [0, 4, m.rational(power * 2)], thing, "a wrong power")
        self.bad("L10-positive", base, "L10", [1, 6, m.rational(base.power(1, p))], "cell-1-point-6", "a cell that is no spoke triangle")
        self.bad("L10-tip", base, "L10", [0, 5, m.rational(base.power(0, tip))], "cell-0-point-5", "a point that is no projection")
        self.bad("L10-as-L11", base, "L11", [0, 4, m.rational(power)], thing, "a projection as evidence against L11")
        self.bad("L10-as-L9", base, "L9", [0, 4, m.rational(power)], thing, "a spoke triangle as evidence against L9")
        self.bad("L10-as-L13", base, "L13", [0, 4, m.rational(power)], thing, "a spoke triangle as evidence against L13")
        self.bad("L10-corner", base, "L10", [0, 6, "0/1"], "cell-0-point-6", "a corner of the cell")
        outside = [0, 3, m.rational(base.power(0, vertices[3]))]
        self.bad("L10-outside", base, "L9", outside, "cell-0-point-3", "a point outside the sphere")
        low = Refutation(m, 3, vertices, base.rings, ["r " + m.rational(r), "h " + m.rational(r / 6)] + parameters[2:], points, base.cells)
        self.bad("L10-L1", low, "L10", evidence, "cell-0", "the base of the spoke triangle is longer than 3h/2", "L1", "t 0 0 6 7 S")
        large = Q(17, 100)
        scaled = lambda place: tuple(x * large / r for x in place)
        grown = Refutation(m, 3, vertices, base.rings, ["r " + m.rational(large), "h " + m.rational(large / 4)] + parameters[2:], [(k, c, scaled(x)) for k, c, x in points],
                           [(f, tuple(map(scaled, t)), k) for f, t, k in base.cells])
        self.bad("L10-L21", grown, "L10", [0, 4, m.rational(power * (large / r) ** 2)], "segment-3-segment-2", "the radius is more than a third of the smallest distance", "L21", "s 1 2")
        unmarked = base.certificate("L10", evidence)
        unmarked.points[0] = ("edge 2", unmarked.points[0][1])
        m.reject("refute-L10-foot", unmarked, "kinds", "t 1 0 5 4 T", "cell-1-kind", "the point is not of kind projection")

    def wedge(self):
        """Two or three facets at one edge, with small angles between their planes but none between their other segments."""
        m = self.m
        make, flat, up, down = wedge(m)
        vertices, (c, s) = make([], []).vertices, (Q(24, 25), Q(7, 25))
        v = vertices[0]

        spoke = [flat(Q(12, 13), Q(5, 13)), flat(Q(20, 29), Q(21, 29))]
        other = [up(c, s), up(Q(4, 5), Q(3, 5))]
        base = make([("arc", 0, p) for p in spoke] + [("arc", 1, p) for p in other], [(0, (v,) + tuple(spoke), "S"), (1, (v,) + tuple(other), "S")])
        evidence = [0, 15, m.rational(base.power(0, other[1]))]
        self.good("L11", base, "L11", evidence, "cell-0-point-15", "the arc of another facet at a small angle")
        self.bad("L11-power", base, "L11", [0, 15, m.rational(base.power(0, other[1]) - TINY)], "cell-0-point-15", "a wrong power")
        self.bad("L11-positive", base, "L11", [0, 14, m.rational(base.power(0, other[0]))], "cell-0-point-14", "the power is positive")
        self.bad("L11-as-L10", base, "L10", evidence, "cell-0-point-15", "a point of an arc as evidence against L10")
        loose = make(base.points + [("interior", 1, up(Q(1, 2), Q(1, 4))), ("arc", 1, up(Q(3, 5), Q(2, 5))), ("arc", 1, up(Q(2, 5), Q(2, 5)))], base.cells)
        loose.cells.append((1, tuple(p for _, _, p in loose.points[4:]), "C"))
        for number in (16, 17):
            self.bad("L11-loose-%d" % number, loose, "L11", [0, number, m.rational(loose.power(0, loose.points[number - 12][2]))], "cell-0-point-%d" % number,
                     "a point that no hypothesis speaks of")

        x, d, y, e = Q(35, 37), Q(12, 37), c, s
        foot, tip, next_foot, next_tip = flat(x, 0), flat(x, d), flat(x + Q(7, 20), 0), flat(x + Q(7, 20), d)
        far, above = flat(y, 0), up(y, e)
        points = [("projection", 0, foot), ("offset", 0, tip), ("edge", 0, next_foot), ("offset", 0, next_tip), ("projection", 0, far), ("offset", 1, above)]
        base = make(points, [(0, (v, foot, tip), "T"), (0, (foot, next_foot, next_tip), "R"), (0, (foot, next_tip, tip), "R"), (1, (v, far, above), "T")])
        evidence = [1, 17, m.rational(base.power(1, above))]
        self.good("L13", base, "L13", evidence, "cell-1-point-17", "a protector of another facet in the sphere of a box")
        self.bad("L13-power", base, "L13", evidence[:2] + [m.rational(-base.power(1, above))], "cell-1-point-17", "the power without its sign")
        self.bad("L13-corner", base, "L13", [1, 13, "0/1"], "cell-1-point-13", "a corner of the box, though not of the cell")
        self.bad("L13-as-L9", base, "L9", evidence, "cell-1-point-17", "a box as evidence against L9")
        self.bad("L13-row", base, "L13", [2, 14, m.rational(base.power(2, next_foot))], "cell-2-point-14", "another corner of the box")

        scale = Q(1989, 2000)
        near = [(scale * x, scale * d)] * 2
        feet, tips = flat(near[0][0], 0), [up(*near[0]), down(*near[1])]
        points = [("projection", 0, foot), ("offset", 0, tip), ("projection", 0, feet), ("offset", 1, tips[0]), ("offset", 2, tips[1])]
        base = make(points, [(0, (v, foot, tip), "T"), (1, (v, feet, tips[0]), "T"), (2, (v, feet, tips[1]), "T")])
        power = base.power(0, tips[0])
        evidence = [0, 15, m.rational(power)]
        self.good("L9", base, "L9", evidence, "cell-0-point-15", "the protector of another facet, nearer to the vertex, in the sphere of T")
        self.bad("L9-power", base, "L9", [0, 15, m.rational(power + TINY)], "cell-0-point-15", "a wrong power")
        self.bad("L9-corner", base, "L9", [0, 13, "0/1"], "cell-0-point-13", "a corner of the cell")
        self.bad("L9-positive", base, "L9", [0, 1, m.rational(base.power(0, vertices[1]))], "cell-0-point-1", "the power is positive")
        n = Q(144)   # of the first facet: (12,0,0) x (0,12,0) = (0,0,144)
        height = n * tips[0][2]
        t1, t2 = power / (2 * -height), power / (2 * height)
        evidence = [0, 16, m.rational(t1), 15, m.rational(t2)]
        self.good("L18", base, "L18", evidence, "cell-0-point-16-point-15", "two points on both sides that no sphere leaves out")
        self.bad("L18-turned", base, "L18", [0, 15, m.rational(t2), 16, m.rational(t1)], "cell-0-point-15-point-16", "the points are given in the wrong order")
        self.bad("L18-value", base, "L18", [0, 16, m.rational(t1 + TINY), 15, m.rational(t2)], "cell-0-point-16-point-15", "a wrong offset")
        away = vertices[4]
        free = base.power(0, away) / (2 * n * away[2])
        self.bad("L18-free", base, "L18", [0, 16, m.rational(t1), 4, m.rational(free)], "cell-0-point-16-point-4", "two points that some sphere leaves out")
        m.malformed("refute-L18-short", base.certificate("L18", evidence[:3]).text(), "E-SYNTAX", "x 0 16 " + m.rational(t1), "evidence against L18 without its second point")
