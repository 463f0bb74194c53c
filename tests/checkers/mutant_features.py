# SPDX-License-Identifier: Apache-2.0
"""L21, rows, refutations and malformed claims that were added because a changed checker (mutation/mutate_checker.py) was noticed by no other certificate."""
from fractions import Fraction as Q

from claim_cases import TINY, local
from mutant_cases import NOTCHED
from mutant_claims import claiming, on_circle, renumbered
from refutation_cases import Refutation, Writer, cap, wedge


def write_features_for_mutants(m, k):
    write_features(m, k)
    write_rows(m)
    write_malformed(m, k)
    writer = Writer(m)
    write_crossing(m, writer)
    write_points(m, writer)
    write_pairs(m, writer)


def triangle(m, extra, segments=(), at=(0, 0, 0), offset="-a/1"):
    """A right triangle with legs of 12 in a plane z = constant, with other vertices; the sphere of its only cell lies almost all below."""
    c = m.planar([(0, 0), (12, 0), (0, 12)], [0, 1, 2], extra=extra, segments=segments)
    c.vertices = [tuple(x + y for x, y in zip(v, at)) for v in c.vertices]
    c.cells = ["0 0 1 2 C " + offset]
    c.hanging = [(c.segments.index(s),) + s for s in sorted(segments)]
    return c


def write_features(m, k):
    claim = lambda c, parameters: claiming(c, parameters, L21=len(c.vertices) + len(c.segments))
    at = (1, 2, 5)
    k.good("L21-facet-away-hair", claim(triangle(m, [(3, 3, 3)], at=at), ["r 1/1"]), (), (), "a vertex exactly 3 r over a facet, away from the origin")
    k.bad("L21-facet-away", claim(triangle(m, [(3, 3, 3)], at=at), ["r " + m.rational(1 + TINY)]), (), (), "L21", "f 0 1 2", "facet-0-vertex-3", "the same, just closer")
    # Two vertices exactly 3 r apart: then the search looks no farther than that.
    near = triangle(m, [(40, 0, 0), (43, 0, 0), (1, 9, 3 - TINY)])
    k.bad("L21-last-corner", claim(near, ["r 1/1"]), (), (), "L21", "f 0 1 2", "facet-0-vertex-5", "a vertex just closer than 3 r to a facet, near its last vertex alone")
    tiny = ["r " + m.rational(TINY)]
    for name, p, q in (("up", (-1, 3, -1), (3, 3, 1)), ("down", (-1, 3, 3), (3, 3, -3))):
        c = triangle(m, [p, q], [(3, 4)], at=at)
        k.bad("L21-slanted-" + name, claim(c, tiny), (), (), "L21", "f 0 1 2", "facet-0-segment-3", "a slanted segment through a facet, away from the origin")
    k.good("L21-in-plane", claim(triangle(m, [(20, 1, 0), (21, 2, 0)], [(3, 4)]), tiny), (), (), "a segment in the plane of a facet, beside it")
    c = m.Certificate(3, [(0, 0, 0), (1, 0, 0), (2**22, 3, 0)], [(0, 1)], [], hanging=[(0, 0, 1)])
    k.good("L22-far", claiming(c, [], L22=1), (), (), "a hanging edge with nothing near: the slack is large, and is found")
    # With `row` alone: the ends of the segment count as its parts only.
    row = ["row 3 %s 1/2 1/2 1/2 1/2" % m.rational(TINY)]
    for name, ends in (("first", [(3, 3, 0), (3, 3, 9)]), ("second", [(3, 3, 9), (3, 3, 0)])):
        c = triangle(m, ends, [(3, 4)])
        k.bad("local-L21-touches-" + name, claim(c, row), (), (), "L21", "f 0 1 2", "facet-0-segment-3", "the %s end of a segment in a facet" % name)
    for name, ends in (("above", [(3, 3, 1), (3, 3, 9)]), ("below", [(3, 3, -9), (3, 3, -1)])):
        c = triangle(m, ends, [(3, 4)], offset="-a/1" if name == "above" else "a/1")
        k.good("local-L21-" + name, claim(c, row), (), (), "an upright segment %s a facet" % name)
    lifted = [(x, y, 5) for x, y in NOTCHED]
    loop = m.loop([0, 1, 2, 3, 4])
    segments = m.undirected(loop + [(5, 6)])
    c = m.Certificate(3, lifted + [(6, 2, 4), (6, 2, 7)], segments, [dict(corners=(0, 1, 2), boundary=loop)], cells=["0 0 1 3 C", "0 1 2 3 C", "0 0 3 4 C"], hanging=[(5, 5, 6)])
    k.bad("L21-pierced-away", claim(c, tiny), (), (), "L21", "f 0 1 2", "facet-0-segment-5", "a segment through a facet in the plane z = 5")


def write_rows(m):
    c = m.rows_and_boxes()
    m.accept("rows-offset-first", renumbered(c, [3, 4, 5, 0, 1, 2]), "the first Steiner point is one of a protector")
    for name, rows, line, thing, reason in (
            ("first", [("0 3", [5, 4, 6])], "5", "row-0-point-5", "the first point of a row is wrong"),
            ("last", [("0 3", [4, 5, 5])], ("5", 2), "row-0-point-5", "the last point of a row is wrong"),
            ("protector-last", [("0 3", [4, 5, 6]), ("0 3 0 +", [7, 8, 8])], ("8", 2), "row-1-point-8-vector", "the last point of a protector is wrong")):
        c = m.rows_and_boxes()
        c.rows = rows
        m.reject("rows-" + name, c, "rows", line, thing, reason)
    points = [(0, 0), (8, 0), (9, 7), (0, 8), (2, 0), (4, 0), (6, 0), (2, 1), (4, 2), (6, 1)]
    for name, embed in (("x", lambda p: (p[1], 0, -p[0])), ("y", lambda p: (p[0], p[1], 0)), ("z", lambda p: (p[0], 0, p[1]))):
        places = [embed(p) for p in points]
        c = m.Certificate(3, places[:4], [(0, 1), (0, 3), (1, 2), (2, 3)], [dict(corners=(0, 1, 2), boundary=m.loop([0, 1, 2, 3]))], cells=m.fans(m.delaunay(points)),
                          points=list(zip(["edge 0"] * 3 + ["offset 0"] * 3, places[4:])), rows=[("0 3", [4, 5, 6]), ("0 3 0 +", [7, 8, 9])])
        m.reject("rows-vector-" + name, c, "rows", "8", "row-1-point-8-vector", "protector vectors that differ in %s alone" % name)


def write_malformed(m, k):
    base = k.flat2
    lines = local(k, base)

    def case(name, place, line, code, wanted, reason):
        c = base.certificate(m, ["H-ball"], lines)
        c.parameters[place] = line
        m.malformed("claims-" + name, c.text(), code, wanted, reason)
    case("ball-twice", 1, lines[0], "E-ORDER", (lines[0], 2), "a ball twice")
    words = lines[4].split()
    for place, name in ((3, "A-first"), (4, "B-first"), (5, "A-second"), (6, "B-second")):
        line = " ".join(words[:place] + ["1/1"] + words[place + 1:])
        case("row-" + name, 4, line, "E-VALUE", line, "a cosine of 1")
    c = base.certificate(m, ["H-ball"], lines)
    c.claims[0] = "refutes H-angle"
    m.malformed("refute-hypothesis", c.text(), "E-SYNTAX", "refutes H-angle", "a hypothesis cannot be refuted")


# ---- refutations ----------------------------------------------------------------------------------------------------

def write_crossing(m, writer):
    """L5: two T cells that are not an opening and a closing one of one vertex and facet, although the protectors cross."""
    r = Q(15, 16)
    v, far, top = (Q(0), Q(0)), (Q(4), Q(0)), (Q(4), Q(4))
    parameters = lambda r: ["r " + m.rational(r), "h " + m.rational(r * Q(4, 15)), "angle 4 " + m.rational(Q(613, 625)), "offset 1", "chord 1"]
    t = Q(10, 51)
    foot, tip = (r * Q(12, 13), Q(0)), (r * Q(12, 13), r * Q(5, 13))
    other = (r * (1 - t * t) / (1 + t * t), r * 2 * t / (1 + t * t))
    other_foot = ((other[0] + other[1]) / 2,) * 2

    def bad(name, base, p, reason):
        writer.bad("L5-" + name, base, "L5", [0, 1, m.rational(base.power(0, p))], "cell-0-cell-1", reason)

    def make(points, cells):
        return Refutation(m, 2, [v, far, top], [[0, 1, 2]], parameters(r), points, cells)
    solid = lambda p: p + (Q(0),)
    points = [("projection", 0, foot), ("offset", 0, tip), ("projection", 1, other_foot), ("offset", 1, other)]
    base = Refutation(m, 3, list(map(solid, (v, far, top))), [[0, 1, 2], [0, 1, 2]], parameters(r), [(kind, carrier, solid(p)) for kind, carrier, p in points],
                      [(0, tuple(map(solid, (v, foot, tip))), "T"), (1, tuple(map(solid, (v, other, other_foot))), "T")])
    bad("other-facet", base, solid(other_foot), "the closing cell is one of another facet")

    small = Q(1, 2)
    scaled = lambda p: (p[0] * small / r, p[1] * small / r)
    corners = [(Q(x), Q(y)) for x, y in ((0, 0), (5, 0), (5, 2), (5, 5))]
    low, tip_low = (Q(5), 2 - small * Q(12, 13)), (5 - small * Q(5, 13), 2 - small * Q(12, 13))
    base = Refutation(m, 2, corners, [[0, 1, 2, 3]], parameters(small), [("projection", 0, scaled(foot)), ("offset", 0, scaled(tip)), ("projection", 2, low), ("offset", 0, tip_low)],
                      [(0, (v, scaled(foot), scaled(tip)), "T"), (0, (corners[2], tip_low, low), "T")])
    bad("other-vertex", base, low, "the closing cell is one of another vertex")

    p, q = on_circle(20, r), on_circle(40, r)
    bad("second-spoke", make([("projection", 0, foot), ("offset", 0, tip), ("arc", 0, p), ("arc", 0, q)], [(0, (v, foot, tip), "T"), (0, (v, p, q), "S")]), q, "the second is a spoke triangle")
    p, q = on_circle(25, r), on_circle(42, r)
    bad("first-spoke", make([("arc", 0, p), ("arc", 0, q), ("projection", 1, other_foot), ("offset", 0, other)], [(0, (v, p, q), "S"), (0, (v, other, other_foot), "T")]), other_foot,
        "the first is a spoke triangle")
    below = (tip[0], -tip[1])
    bad("same-segment", make([("projection", 0, foot), ("offset", 0, tip), ("offset", 0, below)], [(0, (v, foot, tip), "T"), (0, (v, below, foot), "T")]), foot,
        "an opening and a closing cell on both sides of one segment")
    # Two opening cells whose segments make 167 degrees, so that their tips make more than 180.
    u = (Q(-40, 41), Q(9, 41))
    far_end = (6 * u[0], 6 * u[1])
    ring = [v, (Q(6), Q(0)), (Q(6), Q(10)), (far_end[0], Q(10)), far_end]
    low_tip = on_circle(5, r)
    foot_u = tuple(r * Q(12, 13) * x for x in u)
    beyond = (foot_u[0] - r * Q(5, 13) * u[1], foot_u[1] + r * Q(5, 13) * u[0])
    base = Refutation(m, 2, ring, [[0, 1, 2, 3, 4]], parameters(r), [("projection", 0, (low_tip[0], Q(0))), ("offset", 0, low_tip), ("projection", 1, foot_u), ("offset", 0, beyond)],
                      [(0, (v, (low_tip[0], Q(0)), low_tip), "T"), (0, (v, foot_u, beyond), "T")])
    bad("both-open", base, foot_u, "both are opening cells")


def write_points(m, writer):
    """L9, L10, L11: which points may be evidence."""
    make, flat, up, down = wedge(m)
    spoke = [flat(Q(12, 13), Q(5, 13)), flat(Q(20, 29), Q(21, 29))]
    other = [up(Q(24, 25), Q(7, 25)), up(Q(4, 5), Q(3, 5))]
    v = flat(0, 0)
    cells = [(0, (v,) + tuple(spoke), "S"), (1, (v,) + tuple(other), "S")]
    base = make([("arc", 1, other[1]), ("arc", 1, other[0])] + [("arc", 0, p) for p in spoke], cells)
    writer.good("L11-first-point", base, "L11", [0, 12, m.rational(base.power(0, other[1]))], "cell-0-point-12", "the point in the sphere is the first Steiner point")
    writer.bad("L11-vertex", base, "L11", [0, 4, m.rational(base.power(0, base.vertices[4]))], "cell-0-point-4", "a vertex as evidence")
    loose = up(Q(79, 100), Q(59, 100))
    extra = [up(Q(3, 5), Q(2, 5)), up(Q(2, 5), Q(2, 5))]
    base = make([("arc", 1, loose)] + [("arc", 1, p) for p in other] + [("arc", 0, p) for p in spoke] + [("interior", 1, p) for p in extra], cells + [(1, (extra[1], extra[0], loose), "C")])
    power = base.power(0, loose)
    assert power < 0
    writer.bad("L11-loose-first", base, "L11", [0, 12, m.rational(power)], "cell-0-point-12", "the first Steiner point is in the sphere, but no hypothesis speaks of it")

    near = T_cells(m, *[T_SCALE] * 2)
    writer.bad("L9-on", near, "L9", [0, 15, "0/1"], "cell-0-point-15", "a point exactly on the sphere")

    base = cap(m, Q(1, 7))
    base.cells.reverse()
    writer.good("L10-foot-first", base, "L10", [1, 4, m.rational(base.power(1, base.points[0][2]))], "cell-1-point-4", "the witness W2, its T cell first")


X, D = Q(35, 37), Q(12, 37)
T_SCALE = X * X + D * D * Q(24, 25)   # at this distance the protectors of `up` and `down` are exactly on the sphere of the T cell


def T_cells(m, upper, lower, extra=(), cells=()):
    """As in Writer.wedge for L9: a T cell in each facet, those of the slanted ones nearer to the vertex by these factors."""
    make, flat, up, down = wedge(m)
    feet = [flat(upper * X, 0), flat(lower * X, 0)]
    tips = [up(upper * X, upper * D), down(lower * X, lower * D)]
    points = [("projection", 0, flat(X, 0)), ("offset", 0, flat(X, D)), ("projection", 0, feet[0]), ("offset", 1, tips[0]), ("offset", 2, tips[1])]
    if feet[0] != feet[1]:
        points.append(("projection", 0, feet[1]))
    v = flat(0, 0)
    own = [(0, (v, flat(X, 0), flat(X, D)), "T"), (1, (v, feet[0], tips[0]), "T"), (2, (v, feet[1], tips[1]), "T")]
    return make(points + list(extra), own + list(cells))


def moved(base, by):
    shift = lambda p: tuple(x + y for x, y in zip(p, by))
    return Refutation(base.m, base.dim, list(map(shift, base.vertices)), base.rings, base.parameters, [(kind, carrier, shift(p)) for kind, carrier, p in base.points],
                      [(f, tuple(map(shift, t)), kind) for f, t, kind in base.cells])


def write_pairs(m, writer):
    """L18: two points that no sphere leaves out."""
    def offset(base, t, p):
        return base.power(t, p) / (2 * 144 * (p[2] - base.vertices[0][2]))

    def evidence(base, t, low, high):
        numbers = [len(base.vertices) + place for place in (low, high)]
        places = [base.points[place][2] for place in (low, high)]
        return [t, numbers[0], m.rational(offset(base, t, places[0])), numbers[1], m.rational(offset(base, t, places[1]))], "cell-%d-point-%d-point-%d" % (t, *numbers)
    scale = Q(1989, 2000)
    base = T_cells(m, scale, scale)
    away = moved(base, (Q(1), Q(2), Q(5)))
    writer.good("L18-away", away, "L18", *evidence(away, 0, 4, 3), "two points that no sphere leaves out, away from the origin")
    lines, thing = evidence(base, 0, 4, 3)
    writer.bad("L18-first-corner", base, "L18", [0, 13, "3e8/1"] + lines[3:], "cell-0-point-13-point-15", "the first point is a corner")
    writer.bad("L18-second-corner", base, "L18", lines[:3] + [13, "-3e8/1"], "cell-0-point-16-point-13", "the second point is a corner")
    equal = T_cells(m, 2 * T_SCALE - scale, scale)
    lines, thing = evidence(equal, 0, 4, 3)
    assert lines[2] == lines[4]
    writer.bad("L18-one-sphere", equal, "L18", lines, thing, "two points that exactly one sphere leaves out")
    make, flat, up, down = wedge(m)
    inner = [flat(Q(3, 5), Q(1, 10)), flat(Q(6, 5), Q(-1, 10))]
    ordinary = T_cells(m, scale, scale, [("interior", 0, p) for p in inner], [(0, (flat(X, D), *inner), "C")])
    lines, thing = evidence(ordinary, 3, 4, 3)
    writer.bad("L18-ordinary-cell", ordinary, "L18", lines, thing, "a C cell")
    for name, place, f, embed in (("first", 4, 2, down), ("second", 3, 1, up)):
        loose = T_cells(m, scale, scale, [("interior", f, embed(Q(1, 2), Q(1, 4))), ("interior", f, embed(Q(1, 2), Q(1, 2)))])
        tip = loose.points[place][2]
        loose.cells[f] = (f, (tip, embed(Q(1, 2), Q(1, 2)), embed(Q(1, 2), Q(1, 4))), "C")
        loose.cells.sort(key=lambda cell: cell[2] == "C")
        lines, thing = evidence(loose, 0, 4, 3)
        writer.bad("L18-loose-" + name, loose, "L18", lines, thing, "a point of which no hypothesis speaks, the %s one" % name)
