# SPDX-License-Identifier: Apache-2.0
"""Claims about sizes, distances and spheres that were added because a changed checker (mutation/mutate_checker.py) was noticed by no other certificate:
values exactly at a bound, the last object, another facet near by."""
from fractions import Fraction as Q

from claim_bases import BETA, H, MIDDLE, Assembly, Edge, Square, circle, exact_root, flat, norm, sub, tilted
from claim_cases import TINY, outline_edges
from mutant_claims import claiming, incircle, last, on_circle, plane, renumbered, reordered, turned

FAR = Q(11 * 2 ** 40)


def write_sizes_for_mutants(m, k):
    write_bases(m, k)
    write_boxes(m, k)
    write_outlines(m, k)
    write_turns(m, k)
    write_neighbours(m, k)
    write_insertions(m, k)
    write_spheres(m, k)


def flat_square(m, **arguments):
    return Assembly(m, [(Square(**arguments), plane)], dim=2)


def between(cosine, sine, radius=1):
    """The point of the unit circle that makes twice this angle with the direction of BETA: its distance from there is 2 sin."""
    c, s = cosine * cosine - sine * sine, 2 * cosine * sine
    return (radius * (c * BETA[0] - s * BETA[1]), radius * (s * BETA[0] + c * BETA[1]))


def write_bases(m, k):
    """Spoke triangles: bases 2 sin psi and less."""
    h_is = lambda h: ["h " + m.rational(h)]
    narrow, wide = flat_square(m, arcs=[[between(Q(60, 61), Q(11, 61))]] * 4), flat_square(m, arcs=[[between(Q(40, 41), Q(9, 41))]] * 4)
    k.good("L1-short-exact", narrow, ["L1"], h_is(H), "the shortest base is exactly h")
    k.good("L1-long-exact", wide, ["L1"], h_is(Q(2, 3) * Q(18, 41)), "the longest base is exactly 3 h/2")
    k.good("L3-base-exact", wide, ["L3"], h_is(Q(18, 41)), "the longest base is exactly h: no bulge is compared")
    k.good("L3-bulge-exact", wide, ["L3"], h_is(Q(18, 41) * Q(9, 40)), "the largest bulge is exactly as the bound")
    k.good("L20-exact", wide, ["L20"], ["r-max " + m.rational(Q(41, 80))], "the largest circumradius is exactly r_max")
    uneven = flat_square(m, arcs=[[MIDDLE]] * 3 + [[on_circle(48)]])
    longest = max((norm(sub(uneven.place(p), uneven.place(q))), t) for t, (_, (_, p, q), kind) in enumerate(uneven.cells) if kind == "S")[1]
    c, number = last(uneven.certificate(m, ["L1"], h_is(Q(31, 100))), longest)
    k.bad("L1-last-cell", c, (), (), "L1", number, "cell-%d" % number, "the last cell alone has a base that is too long")
    # A right angle at a vertex between two T cells, at an obtuse corner.
    trapezoid = Square(corners=[(Q(x), Q(y)) for x, y in ((0, 0), (6, 0), (3, 4), (0, 4))], h=None, edges=[Edge(Q(1, 3), 1, 1)] * 4, arcs=[[]] * 4)
    k.good("L3-right-angle", Assembly(m, [(trapezoid, plane)], dim=2), ["L3"], h_is(2), "a spoke triangle with a right angle at v")


def write_boxes(m, k):
    h_is = lambda h: ["h " + m.rational(h)]
    wide = flat_square(m, h=None, edges=[Edge()] * 3 + [Edge(count=1)])
    box = len(wide.boxes) - 1
    for lemma in ("L2", "L4"):
        k.bad(lemma + "-last-box", wide, [lemma], h_is(Q(37, 100)), lemma, len(wide.cells) + 2 * box, "box-%d" % box, "the last box alone is too wide")
    k.good("L4-bulge-exact", flat_square(m, side=2 * BETA[0] + 4 * BETA[1]), ["L4"], h_is(Q(2, 3) * BETA[1]), "the bulge of all boxes is exactly as the bound")
    gap = Q(8, 5) * BETA[1]
    k.good("L14-exact", Assembly(m, [(Square(), flat), (Square(), tilted(Q(-7, 25), Q(24, 25)))]), ["L14"], h_is(Q(2, 3) * gap), "protectors of two facets exactly 3 h/2 apart")


def write_outlines(m, k):
    def with_point(p, **arguments):
        return flat_square(m, interior=[p], **arguments)
    # On the circle of the first spoke triangle of corner 0, opposite to the corner.
    z, _ = circle((0, 0), BETA, MIDDLE)
    k.good("L17-on", with_point((z[0] * 2, z[1] * 2), h=None), ["L17"], (), "a vertex exactly on the circle of a C cell")
    half = (Q(3, 2) - BETA[0]) / 3   # half of a box
    right = with_point((Q(3, 2), BETA[1] + half))
    k.good("L23-right-angle", right, ["L23"], ["h " + m.rational(H)], "a C cell with a right angle over the outline")
    deep = with_point((Q(3, 2), BETA[1] + Q(1, 10)))
    depth = max(4 * circle(*map(deep.place, deep.cells[t][1]))[1] - norm(sub(deep.place(a), deep.place(b))) for t, a, b, x, _ in outline_edges(deep)
                if sum(p * q for p, q in zip(sub(deep.place(a), deep.place(x)), sub(deep.place(b), deep.place(x)))) < 0)
    k.good("L23-exact", deep, ["L23"], ["h " + m.rational(exact_root(depth))], "a circle that reaches beyond the outline exactly as far as it may")
    octagon = flat_square(m, h=None, edges=[Edge(Q(1, 2), Q(3, 4), Q(3, 4), 1)] * 4, arcs=[[]] * 4)
    k.good("L16-radius-exact", octagon, ["L16"], ["h " + m.rational(Q(16, 17) * Q(5, 4))], "the radius of C cells is exactly 17 h/16")


def write_turns(m, k):
    """L5 at corners of 180 degrees and more."""
    corners = [(Q(6), Q(0)), (Q(9), Q(-11, 20)), (Q(9), Q(3)), (Q(0), Q(3)), (Q(0), Q(0)), (Q(3), Q(0))]
    straight = [on_circle(angle) for angle in (57, 90, 123)]
    arcs = [[on_circle(angle) for angle in (55, 92, 130)], [on_circle(50)], [MIDDLE], [MIDDLE], [MIDDLE], straight]
    flat_angle = Square(corners=corners, h=None, edges=[Edge(count=n) for n in (3, 5, 18, 3, 3, 3)], arcs=arcs)
    k.good("L5-reflex", Assembly(m, [(flat_angle, plane)], dim=2), ["L5"], (), "corners of exactly 180 degrees, and of little more: there is nothing to compare")
    beside = Square(corners=[(Q(x), Q(y)) for x, y in ((3, 0), (6, 0), (6, 3), (0, 3), (0, 0))], h=None, edges=[Edge(count=n) for n in (3, 3, 9, 3, 3)], arcs=[straight] + [[MIDDLE]] * 4)
    k.good("L5-straight", Assembly(m, [(beside, plane)], dim=2), ["L5"], (), "a corner of exactly 180 degrees: there is nothing to compare")
    corners = [(Q(x), Q(y)) for x, y in ((6, 0), (6, 6), (3, 6), (3, 3), (0, 3), (0, 0))]
    notch = [on_circle(angle) for angle in (57, 95, 135, 175, 213)]
    hook = Square(corners=corners, h=None, edges=[Edge(count=n) for n in (9, 3, 3, 3, 3, 9)], arcs=[[MIDDLE]] * 3 + [notch] + [[MIDDLE]] * 2)
    k.good("L5-notch", Assembly(m, [(hook, plane)], dim=2), ["L5"], (), "a corner of 270 degrees")


def write_neighbours(m, k):
    """L6: points of one facet."""
    base = k.flat2
    rim = [p for p, (carrier, _) in enumerate(base.points, 4) if carrier.split()[0] in ("arc", "offset")]
    least, p, q = min((norm(sub(base.place(p), base.place(q))), p, q) for p in rim for q in rim if q < p)
    k.good("L6-exact", base, ["L6"], ["h " + m.rational(exact_root(least))], "neighbours exactly h apart")
    near = [(0, on_circle(42)), (0, on_circle(44))]
    crowded = flat_square(m, h=None, arcs=[[MIDDLE]] * 3 + [[p for _, p in near]])
    c = crowded.certificate(m, ["L6"], ["h 1/8"])
    number = [crowded.points[-2][0], crowded.points[-1][0]]
    assert number == ["arc 0", "arc 0"]
    last_point = len(crowded.points) + 3
    k.bad("L6-last", c, (), (), "L6", "q " + " ".join((crowded.points[-1][0], m.homogeneous(crowded.points[-1][1]))), "point-%d-point-%d" % (last_point, last_point - 1), "the last two points alone are too near")


# ---- L8 -------------------------------------------------------------------------------------------------------------

class Inserted:
    """A square with one interior point near the centre of a circle through three points of the outline; h is chosen, nothing is refined."""

    def __init__(self, m, place, through, h, embed=plane, others=(), vertices=(), hanging=(), parameters=(), **arguments):
        self.m, self.h, self.parameters = m, h, parameters
        square = Square(h=None, interior=[place], **arguments)
        dim = 2 if embed is plane else 3
        self.base = Assembly(m, [(square, embed), *others], vertices=vertices, hanging=hanging, dim=dim)
        self.point = len(self.base.vertices) + self.find("interior", embed(place))
        self.through = [len(self.base.vertices) + self.find("", embed(p)) for p in through]

    def find(self, kind, place):
        return next(p for p, (carrier, at) in enumerate(self.base.points) if at == place and carrier.startswith(kind))

    def certificate(self, claims=(), corners=None, facet=0):
        c = self.base.certificate(self.m, ["L8", *claims], ["r 1/1"] * ("L21" in claims) + ["h " + self.m.rational(self.h)])
        c.evidence = ["c %d %d %d %d %d" % ((facet,) + tuple(corners or self.through) + (self.point,))]
        return c


def insertion(k, name, inserted, fault, reason, **arguments):
    c = inserted.certificate(**arguments)
    k.bad("L8-" + name, c, (), (), "L8", c.evidence[0], "point-%d-%s" % (inserted.point, fault), reason)


def write_insertions(m, k):
    # Four points of the outline in the middle of its sides; the centre is exactly h/64 beside the new point.
    def crossed(d, embed=plane, h=Q(5, 4), move=Q(-5, 256), across=0, **arguments):
        edges = [Edge(Q(1, 4), Q(3, 4), Q(3, 4), 2) for _ in range(4)]
        edges[1].d = d
        places = [(Q(3, 2), Q(1, 4)), (Q(3, 2), Q(11, 4)), (Q(1, 4), Q(3, 2))]
        return Inserted(m, (Q(3, 2) + move, Q(3, 2) + across), places, h, embed, edges=edges, arcs=[[]] * 4, **arguments)

    def beside(inserted, d):
        place = (3 - d, Q(3, 2))
        return len(inserted.base.vertices) + inserted.find("offset", inserted.base.faces[0][1](place))
    good, on, equal = Q(1, 4) - TINY, Q(1, 4) + TINY, Q(1, 4)
    less = Q(5, 4) - TINY
    first = crossed(good, h=less, move=-less / 64)
    k.good("L8-moved-exact", first.certificate(), (), (), "the new point is exactly h/64 from the centre; all others are farther away than h")
    insertion(k, "moved", crossed(good, h=less, move=-less / 64 - TINY), "centre", "the new point is just farther than h/64 from the centre")
    insertion(k, "radius-exact", crossed(equal, move=0), "radius", "a triangle whose radius is exactly h")
    for name, embed in (("x", plane), ("y", lambda p: (p[1], p[0], Q(0))), ("z", lambda p: (p[1], Q(0), p[0]))):
        bad = crossed(on, embed, h=Q(5, 4) - TINY, move=-(Q(5, 4) - TINY) / 64)
        insertion(k, "near-" + name, bad, "point-%d" % beside(bad, on), "a point exactly h from the centre, and farther from the new point, along " + name)
    # So far away that h is 16 units of the checker's grid.
    bad = crossed(on, h=Q(5, 4) - TINY, move=-(Q(5, 4) - TINY) / 64, vertices=[(FAR, Q(0))])
    insertion(k, "near-coarse", bad, "point-%d" % beside(bad, on), "the same, and a vertex far away")
    bad = crossed(on, h=Q(5, 4) - TINY, move=-(Q(5, 4) - TINY) / 64)
    y = beside(bad, on) - 4
    c = renumbered(bad.certificate(), [p for p in range(len(bad.base.points)) if p != y] + [y])
    k.bad("L8-near-last", c, (), (), "L8", c.evidence[0], "point-%d-point-%d" % (bad.point - 1, len(c.points) + 3), "the same, the last of all points")
    c = first.certificate()
    k.good("L8-first-point", renumbered(c, range(len(c.points) - 1, -1, -1)), (), (), "the new point is the first of all points")
    insertion(k, "corner-vertex", first, "corner-0", "a triangle with a vertex as a corner", corners=[0] + first.through[1:])

    # The centre is beside a long edge of the outline: h/2 from it, and little more than h from its ends.
    def over(short, embed=plane, others=(), vertices=()):
        edges = [Edge(count=2), Edge(), Edge(), Edge()]
        a, b = BETA, (Q(3, 2), BETA[1])
        z = ((a[0] + b[0]) / 2, BETA[1] + Q(4, 25))
        x, y = sub(a, z)
        cosine, sine = Q(40, 41), Q(-9, 41)
        c = (z[0] + cosine * x - sine * y, z[1] + sine * x + cosine * y)
        return Inserted(m, z, [a, b, c], Q(8, 25) + short, embed, others, vertices, edges=edges, arcs=[[c, MIDDLE]] + [[MIDDLE]] * 3)
    k.good("L8-edge-exact", over(0).certificate(), (), (), "the outline is exactly h/2 away")
    bad = over(TINY)
    number, a, b = next((t, a, b) for t, a, b, _, _ in outline_edges(bad.base) if {a, b} == set(bad.through[:2]))
    cells = list(range(len(bad.base.cells) + 2 * len(bad.base.boxes)))
    others = [t for t in cells if t != number]
    steps = bad.base.cells[number][1].index(a)
    for name, order, turn in (("first", [number] + others, steps), ("last", others + [number], (steps + 1) % 3)):
        c = reordered(bad.certificate(), order)
        place = order.index(number)
        c.cells[place] = turned(c.cells[place], turn)
        k.bad("L8-edge-" + name, c, (), (), "L8", c.evidence[0], "point-%d-edge-%d-%d" % (bad.point, a, b), "the %s edge of the outline is just closer than h/2" % name)
    # Another facet so close that its points and its outline are nearer than those of the facet itself.
    above = Square(h=None, edges=[Edge(d=Q(1, 2), count=3), Edge(), Edge(), Edge()]), lambda p: (p[0], p[1], Q(1, 8))
    double = over(0, flat, [above])
    k.bad("L8-other-facet", double.certificate(["L21"]), (), (), "L21", "v 0 0 1 8", "vertex-4-vertex-0", "L8 holds: what is near is in another facet")
    insertion(k, "facet", double, "facet", "evidence that names another facet than the point's", facet=1)
    foreign = len(double.base.vertices) + double.find("offset", above[1]((BETA[0], Q(1, 2))))
    insertion(k, "corner-other-facet", double, "corner-%d" % foreign, "a triangle with a corner in another facet", corners=[foreign] + double.through[1:])


# ---- spheres --------------------------------------------------------------------------------------------------------

def write_spheres(m, k):
    base = k.flat3
    middle = tuple(x / 2 for x in BETA)
    on = Assembly(m, [(Square(), flat)], vertices=[middle + (Q(1, 2),)])
    k.bad("L9-on", on, ["L9"], (), "L9", 0, "cell-0-point-4", "a vertex off the plane exactly on the sphere of a T cell")
    book = incircle(m, 3, [flat, tilted(Q(-3, 5), Q(4, 5))])
    k.good("L9-common-edge", claiming(book, (), L9=12), (), (), "points of an edge of two facets exactly on circles of T cells")
    many = flat_square(m, h=None, arcs=[[on_circle(20.78 + 8.07 * n) for n in range(1, 6)]] * 4)
    k.good("L10-many", many, ["L10"], (), "many points on the arcs, nearer to the circles of spoke triangles than any foot")

    # A T cell that reaches so far, and one at the next corner that is so small, that both feet are in the circle of a spoke triangle there.
    edges = [Edge(Q(3, 20), Q(9, 10), Q(3, 10), 1), Edge(Q(1, 50), Q(3, 100), Q(2, 5), 1), Edge(Q(3, 20), Q(2, 5), Q(2, 5), 1), Edge(Q(3, 20), Q(2, 5), Q(1, 2), 1)]
    square = Square(side=Q(27, 20), h=None, edges=edges, arcs=[[]] * 4)
    for name, vertices in (("second", ()), ("first", square.corners[1::-1])):
        both = Assembly(m, [(square, plane)], dim=2, first=vertices)
        corner = both.vertices.index(square.corners[1])
        number, cell = next((t, corners) for t, (_, corners, kind) in enumerate(both.cells) if kind == "S" and corner in corners)
        foot = next(p for _, corners, kind in both.cells for p in corners if kind == "T" and corner in corners and p >= 4 and both.points[p - 4] == ("projection 0", (Q(21, 20), Q(0))))
        k.bad("L10-both-feet-" + name, both, ["L10"], (), "L10", number, "cell-%d-point-%d" % (number, foot), "both feet of a segment in the circle of a spoke triangle at its %s end" % name)
    near = Assembly(m, [(Square(), flat), (Square(), lambda p: (p[0] - Q(2, 5), p[1] + Q(1, 5), Q(1, 4)))])
    k.bad("L10-other-foot", near, ["L10", "L21"], ["r 1/1"], "L21", "v -8 4 5 14", "vertex-4-vertex-0", "L10 holds: the feet in the spheres are those of other vertices")

    c, s = BETA
    cos, sin = Q(12, 13), Q(5, 13)   # as in claim_cases.py: m is on the circle of v a p
    inside = tuple(x * (1 - TINY) for x in (cos * (cos * c - sin * s), cos * (cos * s + sin * c)))
    arc = flat_square(m, arcs=[[inside]] * 4)
    text = arc.certificate(m, ["L10"], ())
    foot = arc.cells[0][1][1] - 4
    renumbered(text, [p for p in range(len(text.points)) if p != foot] + [foot])
    k.bad("L10-last-cell", last(text, 0)[0], (), (), "L10", 0, "cell-0-point-%d" % (len(text.points) + 3), "the foot is the last of all points, and its T cell the last of all cells")
