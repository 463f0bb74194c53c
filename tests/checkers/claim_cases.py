# SPDX-License-Identifier: Apache-2.0
"""Claims about lemmas that hold by a hair, and that fail by one. The objects that fail are found here again, by formulas of their own."""
from fractions import Fraction as Q

from claim_bases import BETA, C, H, K, MIDDLE, Assembly, Edge, Square, circle, dot, exact_root, flat, norm, sub, tilted
from malformed_cases import write_malformed_claims

TINY = Q(1, 2 ** 80)


def edge_of(first_bad, good, bad):
    """The two neighbouring multiples of TINY between which a condition fails; the numbers are rounded, and tested first."""
    good, bad = Q(round(good / TINY)), Q(round(bad / TINY))
    assert first_bad(good * TINY) is None and first_bad(bad * TINY) is not None
    while abs(good - bad) > 1:
        middle = (good + bad) // 2
        good, bad = (middle, bad) if first_bad(middle * TINY) is None else (good, middle)
    return good * TINY, bad * TINY


def angle(m, factor, cosine):
    return "angle %d %s" % (factor, m.rational(cosine))


def chebyshev(j, c):
    before, t = 1, c
    for _ in range(j - 1):
        before, t = t, 2 * c * t - before
    return t


class Cases:
    def __init__(self, m):
        self.m = m
        self.flat2 = Assembly(m, [(Square(), lambda p: p)], dim=2)
        self.flat3 = Assembly(m, [(Square(), flat)])
        self.book = Assembly(m, [(Square(), flat), (Square(), tilted(Q(-3, 5), Q(4, 5)))])
        self.all = self.parameters()

    def parameters(self, **changes):
        m = self.m
        values = {"r": m.rational(1), "h": m.rational(H), "angle": "%d %s" % (K, m.rational(C)), "beta": "2", "offset": None, "chord": "1", "r-max": m.rational(Q(2, 3))}
        values.update({k.replace("_", "-"): v for k, v in changes.items()})
        return [k + " " + (v if isinstance(v, str) else m.rational(v)) for k, v in values.items() if v is not None]

    def good(self, name, base, claims, parameters, reason):
        c = base if isinstance(base, self.m.Certificate) else base.certificate(self.m, claims, parameters)
        self.m.accept("claim-" + name, c, reason)
        return c

    def bad(self, name, base, claims, parameters, lemma, line, thing, reason):
        c = base if isinstance(base, self.m.Certificate) else base.certificate(self.m, claims, parameters)
        if isinstance(line, int):
            line = "t " + c.cells[line]
        self.m.reject("claim-" + name, c, lemma, line, thing, reason)

    def hair(self, lemma, name, base, parameter, first_bad, values, line, reason, also=()):
        """A parameter just on the good side, and just beyond; line(object's key) gives the line and the object."""
        good, bad = edge_of(first_bad, *values)
        claims = [lemma] + list(also)
        self.good(name + "-hair", base, claims, parameter(good), reason + ": holds by a hair")
        where, thing = line(first_bad(bad))
        self.bad(name, base, claims, parameter(bad), lemma, where, thing, reason + ": fails by a hair")


def first(pairs):
    return min((key for key, bad in pairs if bad), default=None)


def cell(t):
    return t, "cell-%d" % t


def write_claims(m):
    k = Cases(m)
    k.good("all-dim2", k.flat2, k.flat2.counts(), k.all, "every claim, dimension 2; H-offset, H-chord and L21 without any room")
    k.good("all-dim3", k.book, k.book.counts(), k.all, "every claim, two facets at an edge")
    write_sizes(k)
    write_hypotheses(k)
    write_local(k)
    write_spheres(k)
    write_features(k)
    write_rules(k)
    write_misfits(k)
    write_malformed_claims(m, k.flat2, k.all)


def write_sizes(k):
    m, base = k.m, k.flat2
    place = base.place
    spokes = [(t, tuple(map(place, corners))) for t, (_, corners, kind) in enumerate(base.cells) if kind == "S"]
    widths = [(b, norm(sub(place(box[1]), place(box[0]))), norm(sub(place(box[3]), place(box[0])))) for b, (_, box) in enumerate(base.boxes)]
    h_is = lambda value: ["h " + m.rational(value)]

    def box_line(b):
        return len(base.cells) + 2 * b, "box-%d" % b

    # Widths are rational: equality itself.
    width = exact_root(min(w2 for _, w2, _ in widths))
    for name, h in (("L2-short", width), ("L2-long", 2 * width / 3)):
        k.good(name + "-exact", base, ["L2"], h_is(h), "boxes whose width is exactly the bound")
    k.good("L4-exact", base, ["L4"], h_is(width), "boxes of width h")
    k.good("L20-r-exact", base, ["L20"], k.parameters(r=Q(19, 15)), "r is exactly 1.9 r_max")

    base_length = lambda corners: norm(sub(corners[1], corners[2]))
    k.hair("L1", "L1-short", base, h_is, lambda h: first((t, h * h > base_length(s)) for t, s in spokes), (H, 1), cell, "the shortest base of a spoke triangle")
    k.hair("L1", "L1-long", base, h_is, lambda h: first((t, 4 * base_length(s) > 9 * h * h) for t, s in spokes), (H, Q(1, 10)), cell, "the longest base of a spoke triangle")
    k.hair("L2", "L2-short", base, h_is, lambda h: first((b, h * h > w2) for b, w2, _ in widths), (H, 1), box_line, "the width of boxes")
    k.hair("L2", "L2-long", base, h_is, lambda h: first((b, 4 * w2 > 9 * h * h) for b, w2, _ in widths), (H, Q(1, 10)), box_line, "the width of boxes, from above")

    def bulges(h, corners):
        u, w = sub(corners[1], corners[0]), sub(corners[2], corners[0])
        b2, d, x = base_length(corners), dot(u, w), (u[0] * w[1] - u[1] * w[0]) ** 2
        return not (b2 <= h * h and d >= 0) and not (d > 0 and (b2 - h * h) ** 2 * x <= 4 * h * h * b2 * d * d)
    k.hair("L3", "L3", base, h_is, lambda h: first((t, bulges(h, s)) for t, s in spokes), (H, Q(1, 100)), cell, "the bulge of a spoke triangle")
    k.hair("L4", "L4", base, h_is, lambda h: first((b, w2 > h * h and (w2 - h * h) ** 2 > 4 * h * h * d2) for b, w2, d2 in widths), (H, Q(1, 20)), box_line, "the bulge of a box")
    # A spoke triangle with more than a right angle at v, its base below h: the first case needs D >= 0.
    wide = Assembly(m, [(Square(h=None, arcs=[[]] * 4, edges=[Edge(Q(1, 8), 1, 1)] * 4), lambda p: p)], dim=2)
    k.good("L3-first-case", wide, ["L3"], h_is(2), "bases below h need no bound on the bulge")

    rim = [(p, q) for p, (carrier, _) in enumerate(base.points, 4) for q, (other, _) in enumerate(base.points, 4)
           if q < p and {carrier.split()[0], other.split()[0]} <= {"arc", "offset"}]

    def point_pair(key):
        return "q %s %s" % (base.points[key[0] - 4][0], m.homogeneous(base.points[key[0] - 4][1])), "point-%d-point-%d" % key
    k.hair("L6", "L6", base, h_is, lambda h: first((pair, norm(sub(place(pair[0]), place(pair[1]))) < h * h) for pair in rim), (H, 1), point_pair, "neighbours of the outline")

    radius2 = [(t, circle(*map(place, corners))[1]) for t, (_, corners, _) in enumerate(base.cells)]
    radius2 += [(len(base.cells) + 2 * b, circle(*map(place, box[:3]))[1]) for b, (_, box) in enumerate(base.boxes)]
    name = lambda t: (t, "cell-%d-radius" % t)
    k.hair("L20", "L20", base, lambda r: ["r-max " + m.rational(r)], lambda r: first((t, r2 > r * r) for t, r2 in radius2), (1, Q(1, 10)), name, "the largest circumradius")
    k.hair("L20", "L20-r", base, lambda r: k.parameters(r=r), lambda r: 100 * r * r > 361 * Q(4, 9) or None, (1, 2),
           lambda _: ("r " + m.rational(edge_of(lambda r: 100 * r * r > 361 * Q(4, 9) or None, 1, 2)[1]), "r"), "r and the largest circumradius")
    inner = {t for t, (_, _, kind) in enumerate(base.cells) if kind == "C"}
    k.hair("L16", "L16-radius", base, h_is, lambda h: first((t, 256 * r2 > 289 * h * h) for t, r2 in radius2 if t in inner), (1, Q(1, 10)), name, "the largest circle of a C cell")
    write_outline(k)
    write_insertions(k)


def outline_edges(base):
    """(C cell, A, B, opposite corners of the C cell and of the other one)"""
    edges = {}
    everything = base.cells + [(f, t, "R") for f, b in base.boxes for t in ((b[0], b[1], b[2]), (b[0], b[2], b[3]))]
    for f, t, kind in everything:
        edges.update({(f, t[i], t[(i + 1) % 3]): (t[(i + 2) % 3], kind) for i in range(3)})
    for number, (f, t, kind) in enumerate(base.cells):
        for i in range(3):
            a, b, x = t[i], t[(i + 1) % 3], t[(i + 2) % 3]
            if kind == "C" and edges.get((f, b, a), (0, "C"))[1] != "C":
                yield number, a, b, x, edges[(f, b, a)][0]


def write_outline(k):
    m = k.m
    # A point close to the outline: its angle over an edge is obtuse.
    coarse = Assembly(m, [(Square(interior=[(Q(3, 2), BETA[1] + Q(1, 10))]), lambda p: p)], dim=2)
    place = coarse.place
    deep = [((t, a, b), dot(sub(place(a), place(x)), sub(place(b), place(x))), 4 * circle(*map(place, coarse.cells[t][1]))[1] - norm(sub(place(a), place(b))))
            for t, a, b, x, _ in outline_edges(coarse)]
    k.hair("L23", "L23", coarse, lambda h: ["h " + m.rational(h)], lambda h: first((key, d < 0 and depth > h * h) for key, d, depth in deep), (3, Q(1, 10)),
           lambda key: (key[0], "cell-%d-edge-%d-%d" % key), "a circle that reaches beyond the outline")

    def with_point(move):
        # The circle of the first spoke triangle of corner 0, and the point on it that is halfway beyond its base.
        tip = (BETA[0], BETA[1])
        z, _ = circle((0, 0), tip, (Q(20, 29), Q(21, 29)))
        x, y = z[0] * 2, z[1] * 2   # opposite of v: on the circle, beyond the base
        return Assembly(m, [(Square(h=None, interior=[(x * (1 + move), y * (1 + move))]), lambda p: p)], dim=2)
    k.good("L17-hair", with_point(TINY), ["L17"], (), "an inner point just outside the circle of a spoke triangle")
    c = with_point(-TINY)
    number, y = min((e[0], e[4]) for e in outline_edges(c) if is_inside(c, e))
    k.bad("L17", c, ["L17"], (), "L17", number, "cell-%d-point-%d" % (number, y), "an inner point just in the circle of a spoke triangle")


def is_inside(base, edge):
    number, _, _, _, y = edge
    z, r2 = circle(*map(base.place, base.cells[number][1]))
    return norm(sub(base.place(y), z)) < r2


def write_insertions(k):
    m, base = k.m, k.flat2
    place = base.place
    steps = base.all_insertions()
    first_ones = [p for p, (carrier, _) in enumerate(base.points, 4) if carrier.split()[0] in ("arc", "offset")]
    edges = [(a, b) for _, a, b, _, _ in outline_edges(base)]

    def segment_distance(x, a, b):
        t = max(Q(0), min(Q(1), dot(sub(x, a), sub(b, a)) / norm(sub(b, a))))
        return norm(sub(x, (a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1]))))

    facts = []
    for n, (_, corners, p) in enumerate(steps):
        z, r2 = circle(*map(place, corners))
        near = min((norm(sub(place(x), z)), x) for x in first_ones + [s[2] for s in steps[:n]])
        wall = min(segment_distance(z, place(a), place(b)) for a, b in edges)
        facts.append((n, p, norm(sub(place(p), z)), r2, near, wall))

    def line(key):
        n, fault = key
        return "c %d %d %d %d %d" % ((steps[n][0],) + steps[n][1] + (steps[n][2],)), "point-%d-%s" % (steps[n][2], fault)

    def failing(h):
        for n, p, moved, r2, near, wall in facts:
            for fault, bad in (("radius", r2 <= h * h), ("centre", 4096 * moved > h * h), ("point-%d" % near[1], near[0] <= h * h), ("edge", 4 * wall < h * h)):
                if bad:
                    return n, fault
        return None
    h_is = lambda value: ["h " + m.rational(value)]
    k.hair("L8", "L8-radius", base, h_is, failing, (H, 1), line, "R > h, or the distance from other points")
    k.hair("L8", "L8-centre", base, h_is, failing, (H, Q(1, 100)), line, "a point inserted near the circumcentre")
    evidence = base.certificate(m, ["L8"], h_is(H)).evidence

    def changed(name, lines, where, thing, reason):
        c = base.certificate(m, ["L8"], h_is(H))
        c.evidence = lines
        k.bad("L8-" + name, c, ["L8"], (), "L8", where, thing, reason)
    last, inner = evidence[-1], steps[-1][2]
    q = lambda p: "q %s %s" % (base.points[p - 4][0], m.homogeneous(base.points[p - 4][1]))
    changed("missing", evidence[:-1], q(inner), "point-%d-missing" % inner, "an interior point without evidence")
    changed("twice", evidence + [last], (last, 2), "point-%d-twice" % inner, "an interior point inserted twice")
    uses = next(n for n, (_, corners, _) in enumerate(steps) if any(base.points[x - 4][0].startswith("interior") for x in corners if x >= 4))
    later = next(x for x in steps[uses][1] if base.points[x - 4][0].startswith("interior"))
    changed("order", [evidence[uses]] + evidence[:uses] + evidence[uses + 1:], evidence[uses], "point-%d-corner-%d" % (steps[uses][2], later), "a triangle with a corner that comes later")
    row = next(p for p, (carrier, _) in enumerate(base.points, 4) if carrier.startswith("edge"))
    words = evidence[0].split()
    wrong = " ".join(words[:2] + [str(row)] + words[3:])
    changed("corner", [wrong] + evidence[1:], wrong, "point-%d-corner-%d" % (steps[0][2], row), "a triangle with a corner on a segment")
    wrong = " ".join(words[:3] + [words[2]] + words[4:])
    changed("collinear", [wrong] + evidence[1:], wrong, "point-%s-collinear" % words[5], "a triangle with a corner twice")
    wrong = " ".join(words[:5] + [str(first_ones[0])])
    changed("kind", evidence + [wrong], wrong, "point-%d-kind" % first_ones[0], "evidence for a point that is not interior")


def write_hypotheses(k):
    m = k.m
    flat2, flat3 = k.flat2, k.flat3
    tip = (0, "cell-0-point-%d" % flat2.cells[0][1][2])
    wide = lambda c: chebyshev(4, c) <= 0 or 2 * chebyshev(4, c) ** 2 < 1 or None
    worst = edge_of(wide, C, Q(98, 100))[1]
    k.hair("H-angle", "H-angle-quarter", flat2, lambda c: [angle(m, 4, c)], wide, (C, Q(98, 100)), lambda _: (angle(m, 4, worst), "angle-4"), "phi' and pi/4")
    pair = lambda: m.Certificate(2, [(0, 0), (5, 0), (4, 3)], [(0, 1), (0, 2)], [], hanging=[(0, 0, 1), (1, 0, 2)])
    for c, name in ((Q(4, 5), "H-angle-hair"), (Q(4, 5) - TINY, "H-angle")):
        text = pair()
        text.claims.append("claim H-angle 4")
        text.parameters = [angle(m, 1, c)]
        if c == Q(4, 5):
            k.good(name, text, (), (), "two segments that make exactly the angle phi'")
        else:
            k.bad(name, text, (), (), "H-angle", "s 0 2", "segment-1-segment-0", "two segments that make less than phi'")
    k.bad("H-angle-pi", flat2, ["H-angle"], [angle(m, 64, C)], "H-angle", angle(m, 64, C), "angle-64", "K psi is beyond pi")

    k.bad("H-ball-dim2", flat2, ["H-ball"], k.parameters(r=1 + TINY), "H-ball", *tip, "a point that is not exactly on the circle")
    for name, beyond in (("H-ball-small", Q(1, 2)), ("H-ball-large", Q(2))):
        k.hair("H-ball", name, flat3, lambda r: k.parameters(r=r), lambda r: 7 * abs(1 - r * r) > H * H or None, (Q(1), beyond), lambda _: tip, "points near the sphere")

    k.bad("H-offset-beta", flat2, ["H-offset"], k.parameters(angle="4 " + m.rational(C + TINY)), "H-offset", *tip, "beta is more than 2 psi")
    k.hair("H-offset", "H-offset", flat2, lambda c: k.parameters(beta=None, offset="1", angle="4 " + m.rational(c)),
           lambda c: BETA[1] ** 2 > 4 * (1 - c * c) or None, (C, Q(99, 100)), lambda _: tip, "the offset and the sine of psi")
    k.bad("H-offset-beta-factor", flat2, ["H-offset"], k.parameters(beta="3"), "H-offset", "beta 3", "beta-3", "2 J > K")
    k.bad("H-offset-factor", flat2, ["H-offset"], k.parameters(beta=None, offset="2"), "H-offset", "offset 2", "offset-2", "4 J > K")
    k.bad("H-offset-huge-factor", flat2, ["H-offset"], k.parameters(beta="2147483647"), "H-offset", "beta 2147483647", "beta-2147483647", "a factor for which no polynomial must be computed")
    k.bad("H-chord", flat2, ["H-chord"], k.parameters(h=H + TINY), "H-chord", "chord 1", "chord-1", "h is more than the chord of 2 psi")
    k.bad("H-chord-factor", flat2, ["H-chord"], k.parameters(chord="2"), "H-chord", "chord 2", "chord-2", "4 J > K")
    k.bad("H-chord-pi", flat2, ["H-chord"], k.parameters(angle="40 " + m.rational(C)), "H-chord", angle(m, 40, C), "angle-40", "K psi is beyond pi")


def local(k, base, r=1, d=BETA[1], a=Q(9, 10), b=Q(199, 200)):
    text = k.m.rational
    return ["ball %d %s" % (v, text(r)) for v in range(len(base.vertices))] + ["row %d %s" % (s, " ".join(map(text, (d, a, b, a, b)))) for s in range(len(base.segments))]


def write_local(k):
    flat2, book = k.flat2, k.book
    tip = (0, "cell-0-point-%d" % flat2.cells[0][1][2])
    k.good("local-dim2", flat2, ["H-ball", "H-offset", "L21"], local(k, flat2), "local radii and offsets")
    k.good("local-dim3", book, ["H-ball", "H-offset", "L21"], local(k, book), "the same with two facets at an edge")
    for name, beyond in (("small", Q(1, 2)), ("large", Q(2))):
        k.hair("H-ball", "local-H-ball-" + name, flat2, lambda r: local(k, flat2, r=r), lambda r: not 15 * r * r <= 16 <= 17 * r * r or None, (Q(1), beyond), lambda _: tip, "points near their own sphere")
    d2 = BETA[1] ** 2
    for name, beyond in (("small", Q(1, 9)), ("large", Q(1))):
        k.hair("H-offset", "local-H-offset-" + name, flat2, lambda d: local(k, flat2, d=d), lambda d: not 15 * d * d <= 16 * d2 <= 17 * d * d or None, (BETA[1], beyond), lambda _: tip, "points near their offset")
    wrong_a = lambda a: chebyshev(3, a) < 0 or d2 > 1 - a * a or None
    for name, beyond in (("wide", Q(8, 10)), ("narrow", Q(99, 100))):
        k.hair("H-offset", "local-H-offset-A-" + name, flat2, lambda a: local(k, flat2, a=a), wrong_a, (Q(9, 10), beyond), lambda _: tip, "A, the cosine of a third of the angle between segments")
    k.hair("H-offset", "local-H-offset-B-narrow", book, lambda b: local(k, book, b=b), lambda b: d2 > 1 - chebyshev(7, b) ** 2 or None, (Q(199, 200), Q(9999, 10000)),
           lambda _: (0, "cell-0-point-%d" % book.cells[0][1][2]), "B and the offset")
    # The first segment with another facet at its end: the one of the closing cell at vertex 0. There is a right angle to the common segment.
    k.hair("H-offset", "local-H-offset-B-wide", book, lambda b: local(k, book, b=b), lambda b: chebyshev(10, b) < 0 or None, (Q(199, 200), Q(98, 100)),
           lambda _: (3, "cell-3-point-%d" % book.cells[3][1][1]), "B and the angle to segments of other facets")
    k.bad("local-L21-vertex", flat2, ["L21"], local(k, flat2, r=1 + TINY), "L21", "v 3 0 1", "vertex-1-vertex-0", "a vertex with another one closer than 3 r")
    k.good("local-L21-segment-hair", flat2, ["L21"], local(k, flat2, d=Q(1)), "segments exactly 3 d apart")
    k.bad("local-L21-segment", flat2, ["L21"], local(k, flat2, d=1 + TINY), "L21", "s 1 2", "segment-2-segment-1", "segments closer than 3 d")
    lines = local(k, flat2)
    for name in ("H-ball", "H-offset", "L21"):
        k.bad("local-no-ball-" + name, flat2, [name], lines[1:], name, "claim %s %d" % (name, flat2.counts()[name]), "parameter-ball", "a vertex without a ball")
    for name in ("H-offset", "L21"):
        k.bad("local-no-row-" + name, flat2, [name], lines[:-1], name, "claim %s %d" % (name, flat2.counts()[name]), "parameter-row", "a segment without an offset")


def vertex_over(k, number):
    """A vertex over the middle of a triangle, so high that it is just outside its smallest sphere, and just inside."""
    base = k.flat3
    triangles = [t for _, t, _ in base.cells] + [t for _, b in base.boxes for t in ((b[0], b[1], b[2]), (b[0], b[2], b[3]))]
    corners = [base.place(p)[:2] for p in triangles[number]]
    z, r2 = circle(*corners)
    middle = tuple(sum(p[i] for p in corners) / 3 for i in (0, 1))
    left = r2 - norm(sub(middle, z))
    high, low = edge_of(lambda height: height * height <= left or None, 2, Q(1, 1000))
    return [Assembly(k.m, [(Square(), flat)], vertices=[middle + (height,)]) for height in (high, low)]


def write_spheres(k):
    m = k.m
    base = k.flat3
    inner = next(t for t, (_, _, kind) in enumerate(base.cells) if kind == "C" and t > 25)
    for lemma, number in (("L9", 0), ("L13", len(base.cells)), ("L16", inner)):
        good, bad = vertex_over(k, number)
        k.good(lemma + "-hair", good, [lemma], (), "a vertex just outside the sphere of a cell")
        k.bad(lemma, bad, [lemma], (), lemma, number, "cell-%d-point-4" % number, "a vertex just in the sphere of a cell")

    # A point of the arc on the circle of T, whose diameter is v a: then m is on the circle of v a p.
    c, s = BETA
    (cos, sin) = Q(12, 13), Q(5, 13)
    turned = (cos * (cos * c - sin * s), cos * (cos * s + sin * c))
    arc = lambda p, h=H: Assembly(m, [(Square(arcs=[[p]] * 4, h=h), lambda q: q)], dim=2)
    k.good("L10-on", arc(turned), ["L10"], (), "m exactly on the circle of a spoke triangle")
    k.good("L10-hair", arc(tuple(x * (1 + TINY) for x in turned)), ["L10"], (), "m just outside the circle of a spoke triangle")
    bad = arc(tuple(x * (1 - TINY) for x in turned))
    k.bad("L10", bad, ["L10"], (), "L10", 1, "cell-1-point-%d" % bad.cells[0][1][1], "m just in the circle of a spoke triangle")

    z, _ = circle((0, 0), (c, s), (s, c))
    (cos, sin) = Q(99, 101), Q(20, 101)
    beyond = lambda scale: tuple(z[i] + scale * (cos * z[i] + (-sin * z[1], sin * z[0])[i]) for i in (0, 1))
    k.good("L11-hair", arc(beyond(1 - TINY)), ["L11"], (), "the next point just outside the circle of a spoke triangle")
    bad = arc(beyond(1 + TINY))
    k.bad("L11", bad, ["L11"], (), "L11", 1, "cell-1-point-%d" % bad.cells[2][1][2], "the next point just in the circle of a spoke triangle")

    sharp = lambda move: Assembly(m, [(Square(), flat), (Square(edges=[Edge(d=BETA[1] * Q(3, 5) + move)] + [Edge()] * 3), tilted(Q(3, 5), Q(4, 5)))])
    k.good("L12-hair", sharp(TINY), ["L12"], (), "protectors of two facets, one just longer than the projection of the other")
    k.bad("L12", sharp(0), ["L12"], (), "L12", "r 0 4 1 +", "row-1-row-2", "a protector exactly as long as the projection of another")

    gap = 4 * 2 * BETA[1] ** 2 * Q(8, 5)
    k.hair("L14", "L14", k.book, lambda h: ["h " + m.rational(h)], lambda h: 9 * h * h > gap or None, (H, 1), lambda _: ("r 0 4 1 +", "row-1-row-2"), "protectors of two facets at an edge")

    rising = Assembly(m, [(Square(), flat)], vertices=[(Q(2, 7), Q(3, 7), Q(6, 7))], hanging=[((0, 0, 0), (Q(2, 7), Q(3, 7), Q(6, 7)))])
    number = rising.segments.index((0, 4))
    k.hair("L15", "L15", rising, lambda x: [angle(m, 1, x)], lambda x: 1 - x * x > Q(36, 49) or None, (C, Q(1, 10)),
           lambda _: ("f 0 1 2", "facet-0-segment-%d-vertex-0" % number), "the angle of a segment with a facet")
    aside = Assembly(m, [(Square(), flat)], vertices=[(Q(-2, 7), Q(-3, 7), Q(6, 7))], hanging=[((0, 0, 0), (Q(-2, 7), Q(-3, 7), Q(6, 7)))])
    k.good("L15-aside", aside, ["L15"], [angle(m, 1, Q(1, 10))], "a segment that is not over the facet")
    level = Assembly(m, [(Square(), flat)], vertices=[(Q(3, 5), 0, Q(4, 5))], hanging=[((0, 0, 0), (Q(3, 5), 0, Q(4, 5)))])
    number = level.segments.index((0, 4))
    k.bad("L15-over-edge", level, ["L15"], [angle(m, 1, Q(3, 5) - TINY)], "L15", "f 0 1 2", "facet-0-segment-%d-vertex-0" % number, "a segment over an edge of the facet")

    half = Q(1, 2)
    def kite(move, h=None):
        edges = [Edge(half - move, half, Q(7, 8)), Edge(), Edge(), Edge(half - move, Q(7, 8), half)]
        return Assembly(m, [(Square(edges=edges, arcs=[[], [], [MIDDLE], []], h=h), lambda p: p)], dim=2)
    k.good("L5-hair", kite(TINY, Q(1, 2)), ["L5"], (), "protectors that nearly meet")
    touching = kite(0)
    k.bad("L5", touching, ["L5"], (), "L5", 0, "cell-0-cell-1", "protectors that meet")
    k.bad("L7-no-spoke", touching, ["L7"], (), "L7", 0, "cell-0-point-%d" % touching.cells[0][1][2], "T cells without a spoke triangle between them")
    corner = lambda move: arc((BETA[0] + move, Q(39, 100)), Q(1, 2))
    k.good("L7-hair", corner(0), ["L7"], (), "a right angle between protector and arc")
    bad = corner(TINY)
    k.bad("L7", bad, ["L7"], (), "L7", 0, "cell-0-point-%d" % bad.cells[0][1][2], "an angle between protector and arc just below a right one")


def write_features(k):
    m = k.m
    one = lambda c, r, count: (c.claims.append("claim L21 %d" % count), c.parameters.append("r " + m.rational(r)), c)[-1]

    def both(name, make, count, line, thing, reason):
        k.good(name + "-hair", one(make(), 1, count), (), (), reason + " exactly 3 r apart")
        k.bad(name, one(make(), 1 + TINY, count), (), (), "L21", line, thing, reason + " just closer than 3 r")
    both("L21-vertices", lambda: m.Certificate(3, [(0, 0, 0), (1, 2, 2)], [], []), 2, "v 1 2 2 1", "vertex-1-vertex-0", "two vertices")
    both("L21-ends", lambda: m.Certificate(3, [(0, 0, 0), (1, 2, 2)], [(0, 1)], [], hanging=[(0, 0, 1)]), 3, "v 1 2 2 1", "vertex-1-vertex-0", "the ends of a segment")
    both("L21-vertex-segment", lambda: m.Certificate(3, [(0, 0, 0), (4, 0, 0), (2, 3, 0)], [(0, 1)], [], hanging=[(0, 0, 1)]), 4, "s 0 1", "segment-0-vertex-2", "a vertex and a segment")
    both("L21-segments", lambda: m.Certificate(3, [(-2, 0, 0), (2, 0, 0), (0, -2, 3), (0, 2, 3)], [(0, 1), (2, 3)], [], hanging=[(0, 0, 1), (1, 2, 3)]), 6,
         "s 2 3", "segment-1-segment-0", "two segments")
    both("L21-parallel", lambda: m.Certificate(3, [(0, 0, 0), (4, 0, 0), (3, 0, 3), (7, 0, 3)], [(0, 1), (2, 3)], [], hanging=[(0, 0, 1), (1, 2, 3)]), 6,
         "s 0 1", "segment-0-vertex-2", "two parallel segments")

    def facet(extra, segments=()):
        c = m.planar([(0, 0), (12, 0), (0, 12)], [0, 1, 2], extra=extra, segments=segments)
        c.cells = ["0 0 1 2 C -1/10"]
        return c
    both("L21-facet", lambda: facet([(3, 3, 3)]), 7, "f 0 1 2", "facet-0-vertex-3", "a vertex and a facet")
    k.good("L21-facet-outside", one(facet([(14, 14, 1)]), Q(1, 1), 7), (), (), "a vertex over the plane of a facet, beside the facet")
    k.bad("L21-pierced", one(facet([(3, 3, 9), (3, 3, -9)], [(3, 4)]), TINY, 9), (), (), "L21", "f 0 1 2", "facet-0-segment-3", "a segment through a facet")
    k.bad("L21-touched", one(facet([(6, 6, 0), (6, 6, 9)], [(3, 4)]), TINY, 9), (), (), "L21", "s 1 2", "segment-2-vertex-3", "a segment that ends on an edge of a facet")
    k.bad("L21-lies-in", one(facet([(1, 1, 0), (2, 3, 0)], [(3, 4)]), TINY, 9), (), (), "L21", "f 0 1 2", "facet-0-vertex-3", "a segment in a facet that does not know it")
    hole = m.with_hole()
    hole.vertices.append((3, 3, 1))
    k.good("L21-hole", one(hole, Q(2, 5), 17), (), (), "a vertex over a hole: nearer to the plane than to the facet")


def write_rules(k):
    m = k.m

    def claimed(c, **counts):
        c.claims += ["claim %s %d" % item for item in counts.items()]
        return c
    over = lambda height: m.Certificate(3, [(0, 0, 0), (4, 0, 0), (0, 4, 0), (2, 4, height)], [(0, 1), (0, 2), (1, 2)], [dict(corners=(0, 1, 2), boundary=m.loop([0, 1, 2]))], cells=["0 0 1 2 C"])
    k.good("L18-hair", claimed(over(2 + TINY), L18=1, L18b=1, L19=1, L22=0), (), (), "a point off the plane just outside a sphere")
    k.bad("L18", claimed(over(Q(2)), L18=1, L18b=1, L19=1, L22=0), (), (), "L18", "t 0 0 1 2 C", "cell-0-point-3", "a point off the plane on a sphere")
    k.bad("L18-unclaimed", claimed(over(Q(2)), L18b=1, L19=1, L22=0), (), (), "emptiness", "t 0 0 1 2 C", "cell-0-point-3", "the same, not claimed as L18")
    tied = m.square(dim=2, inner=[(0, 2)])
    k.bad("L18b", claimed(tied, L18=2, L18b=2), (), (), "L18b", "t 0 0 1 2 C", "cell-0-point-3", "the diagonal of a square as an inner constraint")
    free = m.square(dim=2)
    k.good("L18b-free", claimed(free, L18=2, L18b=2, L19=1), (), (), "the diagonal of a square that no constraint needs")
    c = m.worked()
    del c.cells[2]
    k.bad("L19", claimed(c, L19=1), (), (), "L19", ("2 0", 1), "facet-0-edge-2-0", "a cell is missing")
    for x, name in ((3 + TINY, "L22-hair"), (Q(3), "L22")):
        c = m.worked()
        c.hanging = [(3, 3, 4)]
        c.points = c.points[:1]
        c.vertices.append((x, 1, 7))
        c.cells = [text.replace("5", "6") for text in c.cells]
        claimed(c, L22=1)
        if x > 3:
            k.good(name, c, (), (), "a vertex just outside the ball of a hanging edge")
        else:
            k.bad(name, c, (), (), "L22", "h 3 3 4", "subsegment-0-point-5", "a vertex on the ball of a hanging edge")
    # Order: a claim before emptiness, and after tiling.
    both = claimed(over(Q(2)), L18=1, L21=7)
    both.parameters = ["r 1000/1"]
    k.bad("order-L21-L18", both, (), (), "L21", "v 4 0 0 1", "vertex-1-vertex-0", "L18 is tested where emptiness is, after the other claims")


def write_misfits(k):
    m, base = k.m, k.flat2
    counts = base.counts()
    for name in counts:
        c = base.certificate(m, [name], k.all)
        line = "claim %s %d" % (name, counts[name] + 1)
        c.claims[-1] = line
        k.bad("count-" + name, c, (), (), name, line, "count-%d" % counts[name], "a count that is one too many")
    needs = {"H-angle": ["angle"], "H-ball": ["r"], "H-offset": ["r", "angle", "beta"], "H-chord": ["r", "h", "angle", "chord"], "L15": ["angle"], "L16": ["h"], "L20": ["r-max"], "L21": ["r"]}
    needs.update({"L%d" % n: ["h"] for n in (1, 2, 3, 4, 6, 8, 14, 23)})
    for name, parameters in needs.items():
        for parameter in parameters:
            c = base.certificate(m, [name], [p for p in k.all if not p.startswith(parameter + " ")])
            k.bad("no-%s-%s" % (parameter, name), c, (), (), name, "claim %s %d" % (name, counts[name]), "parameter-" + parameter, "a parameter that the claim needs is not there")
    c = k.flat3.certificate(m, ["H-ball"], [p for p in k.all if not p.startswith("h ")])
    k.bad("no-h-H-ball", c, (), (), "H-ball", "claim H-ball %d" % counts["H-ball"], "parameter-h", "in dimension 3 H-ball needs h")

    def kinds(name, change, line, fault, reason, base=base):
        c = base.certificate(m, ["L5"], ())
        change(c)
        k.bad("kinds-" + name, c, (), (), "kinds", line, fault, reason)

    def cell_text(number, old, new):
        def change(c):
            assert old in c.cells[number]
            c.cells[number] = c.cells[number].replace(old, new)
        return change

    def point_kind(p, kind):
        def change(c):
            p_ = p - len(c.vertices)
            c.points[p_] = (kind + " " + c.points[p_][0].split()[1], c.points[p_][1])
        return change
    v, foot, tip = base.cells[0][1]
    arc = base.cells[1][1][2]
    kinds("T-as-S", cell_text(0, "T", "S"), 0, "cell-0-kind", "a triangle with a row point called S")
    kinds("S-as-T", cell_text(1, "S", "T"), 1, "cell-1-kind", "a spoke triangle called T")
    kinds("S-as-C", cell_text(1, "S", "C"), 1, "cell-1-kind", "a spoke triangle called C")
    kinds("T-foot", point_kind(foot, "edge"), 0, "cell-0-kind", "m is not of kind projection")
    kinds("T-tip", point_kind(tip, "arc"), 0, "cell-0-kind", "a is not of kind offset")
    kinds("S-base", point_kind(arc, "interior"), 1, "cell-1-kind", "a spoke triangle with an interior point")
    kinds("R-corner", point_kind(base.boxes[0][1][2], "arc"), len(base.cells), "cell-%d-kind" % len(base.cells), "a box with an arc point")
    kinds("fan", lambda c: c.cells.__delitem__(2), 0, "cell-0-fan", "a fan with a gap")
    slanted = " ".join(map(str, (0, v, foot, base.boxes[0][1][2], "T")))
    kinds("T-slanted", lambda c: c.cells.__setitem__(0, slanted), "t " + slanted, "cell-0-kind", "a T cell without a right angle")
    free = k.flat3.certificate(m, ["L5"], ())
    free.cells[20] += " 1/100"
    k.bad("kinds-offset", free, (), (), "kinds", 20, "cell-20-offset", "a cell with an offset")
