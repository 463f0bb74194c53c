# SPDX-License-Identifier: Apache-2.0
"""Claims about lemmas that were added because a changed checker (mutation/mutate_checker.py) was noticed by no other certificate."""
from fractions import Fraction as Q
from math import radians, tan

from claim_bases import BETA, C, H, MIDDLE, Assembly, Edge, Square, flat, tilted
from claim_cases import TINY, angle, chebyshev, local


# ---- the same certificate, told otherwise ---------------------------------------------------------------------------

def renumbered(c, order):
    """The Steiner points in another order: `order` has their old places."""
    n = len(c.vertices)
    new = {n + old: n + k for k, old in enumerate(order)}
    number = lambda x: new.get(int(x), int(x))

    def line(text, first, last):
        words = text.split()
        return " ".join(words[:first] + [str(number(x)) for x in words[first:last]] + words[last:])
    c.points = [c.points[old] for old in order]
    c.cells = [line(text, 1, 4) for text in c.cells]
    c.rows = [(head, [number(x) for x in members]) for head, members in c.rows]
    c.hanging = [(s, number(a), number(b)) for s, a, b in c.hanging]
    c.evidence = [line(text, 2, 6) for text in c.evidence]
    return c


def reordered(c, order):
    """The cells in another order, the boxes numbered anew."""
    boxes, c.cells = {}, [c.cells[old] for old in order]
    for k, text in enumerate(c.cells):
        words = text.split()
        if words[4] == "R":
            words[5] = str(boxes.setdefault(words[5], len(boxes)))
            c.cells[k] = " ".join(words)
    return c


def turned(text, steps):
    """A cell that begins at another corner."""
    words = text.split()
    words[1:4] = words[1 + steps:4] + words[1:1 + steps]
    return " ".join(words)


def last(c, number, steps=0):
    """The same with this cell at the end, beginning at another corner; its new number too."""
    reordered(c, [k for k in range(len(c.cells)) if k != number] + [number])
    c.cells[-1] = turned(c.cells[-1], steps)
    return c, len(c.cells) - 1


def on_circle(degrees, radius=1):
    """About there, with rational coordinates, exactly at this distance."""
    t = Q(round(tan(radians(degrees / 2)) * 1000), 1000)
    return radius * (1 - t * t) / (1 + t * t), radius * 2 * t / (1 + t * t)


def plane(p):
    return p


def write_claims_for_mutants(m, k):
    write_told_otherwise(m, k)
    write_counts(m, k)
    write_angles(m, k)
    write_local(m, k)


def write_told_otherwise(m, k):
    def kind(c, place):
        return c.points[place][0].split()[0]
    c = k.book.certificate(m, k.book.counts(), k.all)
    renumbered(c, range(len(c.points) - 1, -1, -1))
    reordered(c, range(len(c.cells) - 1, -1, -1))
    c.cells = [turned(text, number % 3) for number, text in enumerate(c.cells)]
    k.good("all-dim3-backwards", c, (), (), "every claim; the last points and cells come first")
    c = k.flat2.certificate(m, k.flat2.counts(), k.all)
    kinds = ["arc", "projection", "edge", "interior", "offset"]
    renumbered(c, sorted(range(len(c.points)), key=lambda p: kinds.index(kind(c, p))))
    k.good("all-dim2-arcs-first", c, (), (), "every claim; points of arcs come first, offset points last")


def incircle(m, dim, faces):
    """Right triangles with sides 3, 4, 5, each with the centre of its incircle as its only offset point: six T cells, no others.
    faces: maps from the plane; the leg of length 4 is common to all."""
    places, facets, points, cells = [], [], [], []

    def number(list_, thing):
        if thing not in list_:
            list_.append(thing)
        return list_.index(thing)
    corners = [(Q(0), Q(0)), (Q(4), Q(0)), (Q(0), Q(3))]
    rings = [[number(places, f(p)) for p in corners] for f in faces]
    segments = m.undirected(e for ring in rings for e in m.loop(ring))
    for number_of, (f, ring) in enumerate(zip(faces, rings)):
        facets.append(dict(corners=ring, boundary=m.loop(ring)))
        feet = []
        for i, p in enumerate([(1, 0), (Q(8, 5), Q(9, 5)), (0, 1)]):
            segment = segments.index(tuple(sorted((ring[i], ring[(i + 1) % 3]))))
            feet.append(len(places) + number(points, ("projection %d" % segment, f(p))))
        centre = len(places) + number(points, ("offset %d" % number_of, f((1, 1))))
        for i in range(3):
            cells += ["%d %d %d %d T" % (number_of, ring[i], feet[i], centre), "%d %d %d %d T" % (number_of, ring[i], centre, feet[i - 1])]
    return m.Certificate(dim, places, segments, facets, points=points, cells=cells)


def claiming(c, parameters, **counts):
    c.claims += ["claim %s %d" % (name.replace("_", "-"), count) for name, count in counts.items()]
    c.parameters = list(parameters)
    return c


def write_counts(m, k):
    """Parameters that are needed, and how many objects there are."""
    lines = local(k, k.flat2)
    k.good("local-balls-only", k.flat2, ["H-ball"], [line for line in lines if line.startswith("ball")], "H-ball needs no `row`")
    k.good("local-r-max", k.flat2, ["H-ball", "L20"], ["r-max 2/3"] + lines, "r-max is no parameter of global strategies alone")
    k.bad("local-no-row-middle", k.flat2, ["H-offset"], lines[:-2] + lines[-1:], "H-offset", "claim H-offset 8", "parameter-row", "a segment without an offset, before one that has one")
    rows = ["row %d 1/2 9/10 9/10 9/10 9/10" % s for s in range(3)]
    balls = ["ball %d 3/4" % v for v in range(3)]
    k.good("local-no-boxes", claiming(incircle(m, 2, [plane]), balls + rows, L21=6), (), (), "a triangle of T cells alone")
    k.bad("local-no-boxes-row", claiming(incircle(m, 2, [plane]), balls + rows[1:], L21=6), (), (), "L21", "claim L21 6", "parameter-row",
          "a segment without an offset, on which T cells are all there is; its point is the first of all")
    k.bad("L7-no-box", claiming(incircle(m, 2, [plane]), (), L7=6), (), (), "L7", 0, "cell-0-point-6", "a T cell without a box")
    c = k.flat2.certificate(m, ["L1"], ())
    c.claims[-1] = "claim L1 9"
    k.bad("no-h-and-count", c, (), (), "L1", "claim L1 9", "parameter-h", "a parameter is missing, and the count is wrong: the parameter is tested first")
    c = k.flat2.certificate(m, ["L6"], ["h 1/" + "1" + "0" * 150])
    k.good("L6-slack-beyond-doubles", c, (), (), "a spacing of 2^-600: no double can tell the slack")
    tiny = Q(1, 2 ** 520)
    c = m.Certificate(3, [(0, 0, 0), (tiny, 0, 0), (0, tiny, 0), (0, 0, 1)], [(0, 1), (0, 2), (1, 2)], [dict(corners=(0, 1, 2), boundary=m.loop([0, 1, 2]))], cells=["0 0 1 2 C"])
    k.good("L18-slack-beyond-doubles", claiming(c, (), L18=1), (), (), "a triangle so small that no double can tell the relative power of a point")
    c = Assembly(m, [(Square(), plane)], hanging=[((Q(0), Q(0)), (Q(-1), Q(-1)))], vertices=[(Q(-1), Q(-1))], dim=2)
    k.good("L15-dim2", c, ["L15"], [angle(m, 1, C)], "a segment at a corner of the facet, dimension 2: no triple")
    back = tilted(Q(-3, 5), Q(4, 5))
    others = [flat((Q(3), Q(3))), flat((Q(0), Q(3))), back((Q(3), Q(3))), back((Q(0), Q(3)))]
    k.good("pairs-last-segment", Assembly(m, [(Square(), flat), (Square(), back)], first=others), ["L12", "L14"], ["h " + m.rational(H)], "two facets at the last segment: the last rows are a pair")
    c = Assembly(m, [(Square(), flat), (Square(), tilted(-1, 0))]).certificate(m, (), ["h " + m.rational(H)])
    k.good("L12-coplanar", claiming(c, c.parameters, L12=0, L14=1), (), (), "two facets in one plane at an edge: no pair of L12")


def write_angles(m, k):
    flat2, flat3 = k.flat2, k.flat3
    opposite = m.Certificate(2, [(0, 0), (5, 0), (-5, 0)], [(0, 1), (0, 2)], [], hanging=[(0, 0, 1), (1, 0, 2)])
    opposite.claims.append("claim H-angle 4")
    for factor, reason in ((35, "K psi is just beyond 2 pi"), (14, "K psi is below pi, its cosine -0.8")):
        opposite.parameters = [angle(m, factor, C)]
        k.bad("H-angle-%d" % factor, opposite, (), (), "H-angle", angle(m, factor, C), "angle-%d" % factor, reason)
    k.good("H-offset-exact", Assembly(m, [(Square(edges=[Edge(d=H)] * 4), plane)], dim=2), ["H-offset"], k.parameters(beta=None, offset="1"), "an offset of exactly 2 r sin psi")

    def at_corner(corner, x, y, z, vertex_first=False):
        apex = (Q(corner[0]) + x, Q(corner[1]) + y, z)
        return Assembly(m, [(Square(), flat)], vertices=[apex], hanging=[((Q(corner[0]), Q(corner[1]), Q(0)), apex)], first=[apex] if vertex_first else ())
    steep = (Q(3, 13), Q(-4, 13), Q(12, 13))
    k.good("L15-last-segment", at_corner((0, 3), *steep), ["L15"], [angle(m, 1, Q(5, 13))], "the last segment, at the last vertex of the facet, at exactly the angle")
    k.good("L15-last-vertex", at_corner((0, 3), *steep, vertex_first=True), ["L15"], [angle(m, 1, Q(5, 13))], "a segment to the last vertex, at exactly the angle")
    rising = at_corner((0, 0), Q(3, 13), Q(4, 13), Q(12, 13))
    over = next(t for t, (_, (v, p, q), kind) in enumerate(rising.cells) if v == 0 and kind == "S" and
                all(sign * (rising.place(x)[0] * 4 - rising.place(x)[1] * 3) > 0 for sign, x in ((1, p), (-1, q))))
    number = rising.segments.index((0, 4))
    for steps in range(3):
        c, _ = last(rising.certificate(m, ["L15"], [angle(m, 1, Q(5, 13) - TINY)]), over, steps)
        k.bad("L15-last-cell-%d" % steps, c, (), (), "L15", "f 0 1 2", "facet-0-segment-%d-vertex-0" % number, "a segment at too small an angle; the cell below it is the last, v one of its corners")
    level = at_corner((0, 0), Q(0), Q(3, 5), Q(4, 5))
    k.bad("L15-over-last-edge", level, ["L15"], [angle(m, 1, Q(3, 5) - TINY)], "L15", "f 0 1 2", "facet-0-segment-%d-vertex-0" % level.segments.index((0, 4)), "a segment over the other edge of the facet")
    upright = at_corner((0, 0), Q(0), Q(0), Q(1))
    for factor, cosine, reason in ((2, Q(3, 5), "the cosine of K psi is negative"), (6, Q(12, 25), "K psi is just beyond 2 pi")):
        k.bad("L15-angle-%d" % factor, upright, ["L15"], [angle(m, factor, cosine)], "L15", "f 0 1 2", "facet-0-segment-%d-vertex-0" % upright.segments.index((0, 4)), "an upright segment; " + reason)


def write_local(m, k):
    """The conditions of local strategies: one or the other facet, segment, or bound decides."""
    flat2, flat3 = k.flat2, k.flat3
    edge17 = (Q(13, 20), Q(4, 5))   # its norm is 17/16
    near = lambda scale: Assembly(m, [(Square(arcs=[[tuple(x * scale for x in edge17)]] + [[MIDDLE]] * 3), plane)], dim=2)
    k.good("local-H-ball-exact", near(1), ["H-ball"], local(k, flat2), "a point at 17/16 of the squared radius exactly")
    base = near(1 + TINY)
    c = base.certificate(m, ["H-ball"], local(k, flat2))
    order = [0, 2, 1] + list(range(3, len(c.cells)))
    k.bad("local-H-ball-second-corner", reordered(c, order), (), (), "H-ball", 1, "cell-1-point-%d" % base.cells[2][1][1],
          "a point just too far away: the first cell that has it has it right after the vertex")
    twelve = Assembly(m, [(Square(edges=[Edge(Q(5, 13), Q(12, 13), Q(12, 13))] * 4), plane)], dim=2)
    k.good("local-H-offset-A-exact", twelve, ["H-offset"], local(k, twelve, d=Q(5, 13), a=Q(12, 13)), "an offset of exactly r sin(arccos A)")
    spiral = lambda p: (4 * p[0] - p[1], p[0] + 4 * p[1])
    k.good("local-H-offset-exact", Assembly(m, [(Square(), spiral)], dim=2), ["H-offset"], local(k, flat2, r=4, d=4 * BETA[1]), "offsets of 17/16 of the square exactly")
    k.good("local-H-offset-B-dim2", flat2, ["H-offset"], local(k, flat2, b=Q(1, 2)), "B counts in dimension 3 only")

    # A against a segment that belongs to no facet, at 3/7 to the second segment.
    rising = Assembly(m, [(Square(), flat)], vertices=[(Q(2, 7), Q(3, 7), Q(6, 7))], hanging=[((0, 0, 0), (Q(2, 7), Q(3, 7), Q(6, 7)))])
    tip = lambda base, t: (t, "cell-%d-point-%d" % (t, next(p for p in base.cells[t][1] if p >= len(base.vertices) and base.points[p - len(base.vertices)][0].startswith("offset"))))
    k.hair("H-offset", "local-H-offset-A-hanging", rising, lambda a: local(k, rising, a=a), lambda a: chebyshev(3, a) < Q(3, 7) or None, (Q(933, 1000), Q(92, 100)),
           lambda _: tip(rising, 3), "A and the angle to a hanging segment")
    # B in a single facet: only 10 arccos B < pi, and the offset.
    straight = lambda b: any(chebyshev_second(j, b) <= 0 for j in range(10)) or None
    k.good("local-H-offset-B-alone", flat3, ["H-offset"], local(k, flat3, b=Q(956, 1000)), "10 arccos B is below pi, 11 arccos B beyond")
    k.hair("H-offset", "local-H-offset-B-pi", flat3, lambda b: local(k, flat3, b=b), straight, (Q(956, 1000), Q(950, 1000)), lambda _: tip(flat3, 0), "10 arccos B and pi")
    b = Q(899, 901)
    cosine, sine = chebyshev(7, b), Q(60, 901) * chebyshev_second(6, b)
    exact = Assembly(m, [(Square(edges=[Edge(sine, cosine, cosine)] * 4), flat)])
    k.good("local-H-offset-B-exact", exact, ["H-offset"], local(k, exact, d=sine, a=Q(88, 100), b=b), "an offset of exactly r sin(7 arccos B)")
    # Another facet at the vertex: one of its segments is near; or it is near, but none of its segments.
    a = Q(9305, 10000)
    aside = Assembly(m, [(Square(), flat), (Square(), spanned((3, -2, 6), (-6, -3, 2)))])
    k.hair("H-offset", "local-H-offset-B-segment", aside, lambda b: local(k, aside, a=a, b=b), lambda b: chebyshev(10, b) < Q(3, 7) or None, (Q(199, 200), Q(98, 100)), lambda _: tip(aside, 0),
           "B and a segment of a facet that is not below")
    above = Assembly(m, [(Square(), flat), (Square(), spanned((2, 3, 6), (-6, -2, 3)))])
    k.hair("H-offset", "local-H-offset-B-facet", above, lambda b: local(k, above, a=a, b=b), lambda b: chebyshev(10, b) < 0 or Q(36, 49) < 1 - chebyshev(10, b) ** 2 or None, (Q(199, 200), Q(98, 100)),
           lambda _: tip(above, next(t for t, (f, t_, kind) in enumerate(above.cells) if f == 1 and kind == "T")), "B and a facet below, whose segments are farther away")

    # A vertex between two segments that make a straight angle.
    long = Assembly(m, [(Square(corners=[(Q(x), Q(y)) for x, y in ((3, 0), (6, 0), (6, 3), (0, 3), (0, 0))], h=None, edges=[Edge()] * 2 + [Edge(count=9), Edge(), Edge()],
                                arcs=[[(Q(3, 5), Q(4, 5)), (Q(0), Q(1)), (Q(-3, 5), Q(4, 5))]] + [[MIDDLE]] * 4), plane)], dim=2)

    def at_middle(radius, a):
        lines = local(k, long)
        lines[0] = "ball 0 " + m.rational(radius)
        text, wide, narrow, b = m.rational(BETA[1]), m.rational(a), m.rational(Q(9, 10)), m.rational(Q(199, 200))
        for segment in ((0, 1), (0, 4)):
            s = long.segments.index(segment)
            lines[len(long.vertices) + s] = "row %d %s %s" % (s, text, " ".join((wide, b, narrow, b)))
        return lines
    k.good("local-H-offset-r-exact", long, ["H-offset"], at_middle(2 * BETA[1], Q(3, 5)), "r is exactly 2 d; 3 arccos A is below pi, 4 arccos A beyond")
    k.bad("local-H-offset-r", long, ["H-offset"], at_middle(2 * BETA[1] - TINY, Q(3, 5)), "H-offset", *tip(long, 0), "r is just below 2 d")
    k.good("local-H-offset-A-pi-hair", long, ["H-offset"], at_middle(2 * BETA[1], Q(1, 2) + TINY), "3 arccos A is just below pi")
    k.bad("local-H-offset-A-pi", long, ["H-offset"], at_middle(2 * BETA[1], Q(1, 2)), "H-offset", *tip(long, 0), "3 arccos A is pi")


def chebyshev_second(j, c):
    before, u = 0, 1
    for _ in range(j):
        before, u = u, 2 * c * u - before
    return u


def spanned(e, f):
    """The plane through the origin with these two directions, both of length 7."""
    return lambda p: tuple((p[0] * e[i] + p[1] * f[i]) / 7 for i in range(3))
