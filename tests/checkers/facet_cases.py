# SPDX-License-Identifier: Apache-2.0
"""Cases for mutants (mutation/mutate_checker.py) of the complex, of tilings, kinds of cells, spheres and points without a common denominator: the second of several
objects is at fault, the last one, or one whose corners stand in another order."""
from fractions import Fraction as Q
from math import isqrt

from claim_bases import Assembly, Square
from claim_cases import TINY, Cases, angle, chebyshev, outline_edges


def write_facets(m):
    write_second_records(m)
    write_second_facets(m)
    write_tilings(m)
    write_weighted(m)
    write_long_spheres(m)
    write_offsets(m)
    write_kinds(m)
    write_angles(m)
    write_near(m)


def turn(c, count):
    """The same, x y z moved round."""
    move = lambda p: tuple(p[(i - count) % 3] for i in range(3))
    c.vertices = [move(p) for p in c.vertices]
    c.points = [(kind, move(p)) for kind, p in c.points]
    return c


def write_second_records(m):
    """The complex: the second inner constraint or isolated vertex, the last boundary edge."""
    def case(name, rule_line, thing, reason, heights=(), inner=((4, 5), (6, 7)), isolated=(8, 9), extra=(), missing=(), corners=(0, 1, 2)):
        points = [(0, 0), (12, 0), (12, 12), (0, 12), (1, 1), (2, 3), (5, 1), (6, 5), (9, 7), (7, 10)]
        boundary = m.loop([0, 1, 2, 3]) + list(extra)
        c = m.Certificate(3, [(x, y, Q(v in heights, 2 ** 70)) for v, (x, y) in enumerate(points)], [e for e in m.undirected(boundary + list(inner)) if e not in missing],
                          [dict(corners=corners, boundary=boundary, inner=inner, isolated=isolated)], cells=["0 0 1 2 C"])
        m.reject("complex-" + name, c, "complex", rule_line, thing, reason)
    case("second-constraint-first", ("6 7", 1), "facet-0-vertex-6", "the first vertex of the second inner constraint is outside the plane", heights=[6])
    case("second-constraint-second", ("6 7", 1), "facet-0-vertex-7", "the second vertex of the second inner constraint is outside the plane", heights=[7])
    case("second-isolated", ("9", 1), "facet-0-vertex-9", "the second isolated vertex is outside the plane", heights=[9])
    case("second-constraint-no-segment", ("6 7", 1), "facet-0-constraint-6-7-no-segment", "the second inner constraint is no segment", missing=[(6, 7)])
    case("second-not-isolated", ("9", 1), "facet-0-vertex-9-not-isolated", "the second isolated vertex is on an inner constraint", inner=[(4, 5), (6, 9)])
    case("first-edge", ("0 1", 1), "facet-0-vertex-0", "a vertex outside the plane, which the first boundary edge names", heights=[0], corners=(1, 2, 3))
    case("last-edge", ("9 8", 1), "facet-0-vertex-9", "a vertex outside the plane of which only the last boundary edge knows", heights=[9], isolated=(), extra=[(9, 8)])


def joined(m, one, two, by):
    """Both certificates in one, the second one moved."""
    n1, n2, q1, s1, f1 = len(one.vertices), len(two.vertices), len(one.points), len(one.segments), len(one.facets)
    of_one = lambda x: x if x < n1 else x + n2
    of_two = lambda x: x + n1 if x < n2 else x + n1 + q1
    place = lambda p: tuple(a + b for a, b in zip(p, by))
    boxes = sum(" R " in cell for cell in one.cells) // 2

    def cell(text, point, facet, box):
        words = text.split()
        words = [str(int(words[0]) + facet)] + [str(point(int(x))) for x in words[1:4]] + words[4:]
        if words[4] == "R":
            words[5] = str(int(words[5]) + box)
        return " ".join(words)

    def carried(entry, segment, facet):
        kind, carrier = entry.split()
        return "%s %d" % (kind, int(carrier) + (segment if kind in ("projection", "edge") else facet))

    def row(header, segment, facet):
        words = header.split()
        return " ".join([str(int(words[0]) + segment), words[1]] + ([str(int(words[2]) + facet), words[3]] if len(words) > 2 else []))
    c = m.Certificate(one.dim, one.vertices + [place(p) for p in two.vertices], one.segments + [(a + n1, b + n1) for a, b in two.segments], one.facets)
    move = lambda edges: [(a + n1, b + n1) for a, b in edges]
    c.facets += [dict(corners=tuple(v + n1 for v in f["corners"]), boundary=move(f["boundary"]), inner=move(f.get("inner", [])), isolated=[v + n1 for v in f.get("isolated", [])]) for f in two.facets]
    c.points = one.points + [(carried(entry, s1, f1), place(p)) for entry, p in two.points]
    c.cells = [cell(text, of_one, 0, 0) for text in one.cells] + [cell(text, of_two, f1, boxes) for text in two.cells]
    c.rows = [(header, [of_one(x) for x in row_points]) for header, row_points in one.rows] + [(row(header, s1, f1), [of_two(x) for x in row_points]) for header, row_points in two.rows]
    c.hanging = [(s, of_one(a), of_one(b)) for s, a, b in one.hanging] + [(s + s1, of_two(a), of_two(b)) for s, a, b in two.hanging]
    return c


def write_second_facets(m):
    """The second facet has inner constraints, rows and boxes of its own, as the first has."""
    from certificate_cases import rows_inner, slit_with_point
    away = (100, 7, 31)
    pair = lambda: joined(m, rows_inner(m), rows_inner(m), away)
    m.accept("second-rows-inner", pair(), "two facets, each with an inner constraint that has protectors on both sides")
    m.accept("second-mixed", joined(m, slit_with_point(m), joined(m, m.worked(), m.rows_and_boxes(), (-50, 3, 9)), away), "facets with a slit, a row and boxes, and hanging segments")
    c = pair()
    header, members = c.rows[4]
    assert header.split()[2:] == ["1", "+"]
    wrong = " ".join(header.split()[:2] + ["0", "+"])
    c.rows[4] = (wrong, members)
    m.reject("rows-of-first-facet", c, "rows", "r " + wrong, "row-4-segment-%s-not-in-facet" % wrong.split()[0], "a protector in a facet whose inner constraint comes before its segment")
    c = pair()
    c.points[-1] = ("offset 0", c.points[-1][1])
    m.reject("carrier-of-first-facet", c, "carrier", "q offset 0 " + m.homogeneous(c.points[-1][1]), "point-%d-facet-0" % (len(c.vertices) + len(c.points) - 1), "the last point is carried by another facet")


def write_tilings(m):
    from certificate_cases import slit_with_point
    # The inner constraint carries a point; its second part is crossed.
    c = slit_with_point(m)
    flip(c, (6, 5))
    m.reject("tiling-constraint-second-part", c, "tiling", ("4 5", 1), "facet-0-constraint-4-5-edge-6-5", "the cells cross the second part of an inner constraint")
    c = m.planar([(0, 0), (6, 0), (6, 2), (0, 2), (3, Q(1, 2)), (3, Q(3, 2))], [0, 1, 2, 3], inner=[(0, 4), (1, 3)], isolated=[5])
    m.reject("tiling-second-constraint", c, "tiling", ("1 3", 1), "facet-0-constraint-1-3-edge-1-3", "the second of two inner constraints is crossed")
    c = m.planar(m.SLIT[:5], [0, 1, 2, 3], isolated=[4, 5])
    c.vertices.append((3, 2, 0))
    m.reject("tiling-second-isolated", c, "tiling", "5", "facet-0-vertex-5-in-no-cell", "the second isolated vertex is a corner of no cell")
    c = m.planar(m.SLIT + [(3, 1), (4, 4)], [0, 1, 2, 3], inner=[(4, 5)], isolated=[6, 7])
    sides = {direction: next(t for t in c.cells if direction in edges_of(t)) for direction in ((4, 5), (5, 4))}
    c.cells.remove(sides[(4, 5)])
    c.cells.remove(sides[(5, 4)])
    c.cells.insert(0, sides[(4, 5)])
    m.reject("tiling-constraint-one-side", c, "tiling", "t " + c.cells[0], "cell-0-edge-4-5-open", "cells on one side of an inner constraint only, the first of all cells")
    # Two points on the first edge; the cell at the middle part is missing.
    points = [(0, 0), (9, 0), (9, 5), (0, 5), (3, 0), (6, 0)]
    c = m.planar(points, [0, 1, 2, 3])
    del c.vertices[4:]
    c.points = [("edge 0", (3, 0, 0)), ("edge 0", (6, 0, 0))]
    c.cells = [t for t in c.cells if (4, 5) not in edges_of(t)]
    m.reject("tiling-chain-gap", c, "tiling", ("0 1", 1), "facet-0-edge-0-1", "the cell at the middle part of a boundary edge is missing")

    # A notch, and a cell in it. Numbers run the other way round in the second polygon.
    notched = [(0, 0), (12, 0), (12, 8), (6, 4), (0, 8)]

    def polygon(numbers, cells, points=()):
        places = dict(zip(numbers, notched))
        ring = m.loop(list(numbers))
        return m.Certificate(3, m.lift([places[v] for v in sorted(places)]), m.undirected(ring), [dict(corners=numbers[:3], boundary=ring)], points=points, cells=["0 %d %d %d C" % t for t in cells])
    c = polygon((0, 1, 2, 3, 4), [(0, 1, 3), (1, 2, 3), (0, 3, 4), (1, 2, 3), (2, 4, 3)])
    m.reject("tiling-three-cells", c, "tiling", ("3 4", 1), "facet-0-edge-3-4", "an edge of two cells on the right side and of one beyond, which also takes away the next edge")
    c = polygon((0, 4, 3, 2, 1), [(0, 2, 1), (4, 3, 2), (0, 4, 2), (3, 1, 2), (0, 2, 1), (0, 2, 1), (3, 1, 2)])
    m.reject("tiling-five-cells", c, "tiling", ("3 2", 1), "facet-0-edge-3-2", "an edge of three cells on the right side and of two beyond, which take away the next edge")
    c = polygon((0, 1, 2, 3, 4), [(0, 1, 3), (1, 2, 3), (0, 3, 4), (5, 6, 4)], points=[("edge 3", (8, Q(16, 3), 0)), ("edge 3", (10, Q(20, 3), 0))])
    assert c.segments[3] == (2, 3)
    m.reject("tiling-backward", c, "tiling", "t 0 5 6 4 C", "cell-3-edge-4-5-open", "one cell along a boundary edge, and one beyond it along a part of it")


def edges_of(cell):
    t = list(map(int, cell.split()[1:4]))
    return {(t[i], t[(i + 1) % 3]) for i in range(3)}


def flip(c, edge):
    """The other diagonal of the two cells at an edge."""
    a, b = edge
    first, second = next(t for t in c.cells if (a, b) in edges_of(t)), next(t for t in c.cells if (b, a) in edges_of(t))
    x, y = (next(v for v in map(int, t.split()[1:4]) if v not in edge) for t in (first, second))
    c.cells[c.cells.index(first)] = "0 %d %d %d C" % (a, y, x)
    c.cells[c.cells.index(second)] = "0 %d %d %d C" % (b, x, y)


def uncommon(c, count=16):
    """Vertices far away whose weights have next to nothing in common: then there is no common denominator."""
    c.vertices += [(1000 + 17 * k + Q(2 * k + 7, 10 ** 38 + 2 * k + 1), 900 - 31 * k, 800 + 5 * k * k) for k in range(count)]
    return c


def write_weighted(m):
    """Points without a common denominator."""
    top = 1 + Q(1, 10 ** 9 + 7)
    for count, axes in enumerate(("xyz", "zxy", "yzx")):
        for name, height in (("on", top), ("in", top - TINY), ("out", top + TINY)):
            c = turn(m.circle(3, extra=[(0, 0, height), (0, 0, -2)]), count)
            if name == "out":
                m.accept("weighted-%s-%s" % (name, axes), c, "a point just outside the sphere through 24 points, which have no common denominator")
            else:
                m.reject("weighted-%s-%s" % (name, axes), c, "emptiness", "t " + c.cells[0], "cell-0-point-24", "a point %s the sphere through 24 points, which have no common denominator" % name)
    large = 10 ** 38 + 61
    for name, corners in (("first", [(Q(1, large), 0, 0), (4, 0, 0), (0, 4, 0)]), ("second", [(0, 0, 0), (4 + Q(1, large), 0, 0), (0, 4, 0)]), ("third", [(0, 0, 0), (4, 0, 0), (0, 4 + Q(1, large), 0)])):
        plain = lambda: uncommon(m.Certificate(3, corners + [(1, 1, 1), (1, 1, -9)], m.undirected(m.loop([0, 1, 2])), [dict(corners=(0, 1, 2), boundary=m.loop([0, 1, 2]))], cells=["0 0 1 2 C"]))
        m.reject("weighted-corner-" + name, plain(), "emptiness", "t 0 0 1 2 C", "cell-0-point-3", "a corner with a weight of 127 bits, a vertex in the sphere")
        c = plain()
        c.cells = ["0 0 1 2 C -1/4"]
        m.accept("weighted-offset-" + name, c, "the same, with an offset between two bounds")
    # The grid's origin is outside of the sphere, its first two points have weights of 1 and 127 bits, and the other way round.
    for name, first in (("elsewhere", [(-500, -300, 7), (-600 + Q(1, large), 20, 9)]), ("elsewhere-turned", [(-600 + Q(1, large), 20, 9), (-500, -300, 7)])):
        c = uncommon(m.Certificate(3, first + [(Q(1, 3), Q(1, 7), 0), (4 + Q(1, 11), Q(1, 13), 0), (Q(1, 17), 4 + Q(1, 19), 0), (1 + Q(1, 23), 1 + Q(1, 29), 1 + Q(1, 31))], [(2, 3), (2, 4), (3, 4)],
                                   [dict(corners=(2, 3, 4), boundary=m.loop([2, 3, 4]))], cells=["0 2 3 4 C"]))
        m.reject("weighted-" + name, c, "emptiness", "t 0 2 3 4 C", "cell-0-point-5", "a vertex in a sphere far from the first two vertices, whose weights differ by 126 bits")
    flat, half = [(0, 0, 0), (4, 0, 0), (0, 4, 0)], Q(1, 2)
    c = m.Certificate(3, flat + [(9, 0, half), (13, 0, half), (9, 4, half)], m.undirected(m.loop([0, 1, 2]) + m.loop([3, 4, 5])),
                      [dict(corners=t, boundary=m.loop(list(t))) for t in ((0, 1, 2), (3, 4, 5))], cells=["0 0 1 2 C", "1 3 4 5 C"])
    m.accept("weighted-parallel", uncommon(c), "the planes z = 0 and z = 1/2 without a common denominator: the smallest relative power is that of a point of the other")
    upright = m.Certificate(3, [(1, 2, Q(3, large)), (1, 9, 3), (1, 2, 8)], [(0, 1), (0, 2), (1, 2)], [dict(corners=(0, 1, 2), boundary=m.loop([0, 1, 2]))], cells=["0 0 1 2 C"])
    m.accept("weighted-upright", uncommon(upright), "a facet in the plane x = 1, without a common denominator")


def write_long_spheres(m):
    """Centres 2^61 away along each axis, the corner at the origin of the grid or not."""
    from certificate_cases import nearly_degenerate
    for count, axes in enumerate(("xyz", "zxy", "yzx")):
        for first in range(3):
            c = turn(nearly_degenerate(m), count)
            c.cells = ["0 %d %d %d C" % tuple((i + first) % 3 for i in range(3))]
            if first == 1:
                m.accept("far-centre-" + axes, c, "a cell whose circle is far larger than the domain")
            c.vertices[4] = turn(m.Certificate(3, [(1, Q(1, 10), Q(1, 3))], [], []), count).vertices[0]
            m.reject("far-centre-%s-%d" % (axes, first), c, "emptiness", "t " + c.cells[0], "cell-0-point-4", "the same with a vertex in the sphere")
    # Far from the first vertex, and the other way round.
    for count, axes in enumerate(("xyz", "zxy", "yzx")):
        c = nearly_degenerate(m)
        c.vertices = [(x + 1000, 1500 - y, -z) for x, y, z in c.vertices[:3]] + [(1001, 1499, 0), (7, 1608, 3000), (1000, 1600, 1)]
        c = turn(c, count)
        c.vertices = c.vertices[4:5] + c.vertices[:4] + c.vertices[5:]
        c.segments, c.facets, c.cells = [(1, 2), (1, 3), (2, 3)], [dict(corners=(1, 3, 2), boundary=m.loop([1, 3, 2]))], ["0 1 3 2 C"]
        m.reject("far-centre-%s-moved" % axes, c, "emptiness", "t 0 1 3 2 C", "cell-0-point-4", "a centre 2^61 away, far from the first vertex; a vertex in the sphere")


def write_offsets(m):
    """Three cells, each with an offset that would not do for the others."""
    vertices, facets, cells, segments = [], [], [], []
    for k, (text, points) in enumerate([("-1/4", [(1, 1, 1), (1, 1, -9)]), ("1/4", [(1, 1, -1), (1, 1, 9)]), ("-1/1", [(1, 1, Q(1, 4)), (1, 1, -40)])]):
        n = len(vertices)
        vertices += [(x + 200 * k, y + 10 * k * k, z) for x, y, z in [(0, 0, 0), (4, 0, 0), (0, 4, 0)] + points]
        ring = m.loop([n, n + 1, n + 2])
        segments += m.undirected(ring)
        facets.append(dict(corners=(n, n + 1, n + 2), boundary=ring))
        cells.append("%d %d %d %d C %s" % (k, n, n + 1, n + 2, text))
    c = m.Certificate(3, vertices, segments, facets, cells=cells)
    m.accept("offsets-three", c, "three cells with an offset each, between two bounds")
    c.cells[2] = c.cells[2].replace("-1/1", "-1/4")
    m.reject("offsets-third", c, "emptiness", "t " + c.cells[2], "cell-2-point-13", "the third of them too small")


def write_kinds(m):
    """Kinds of cells whose corners stand in any order, cells in any order."""
    k = Cases(m)
    everything = k.flat2.counts()

    def changed(change, claims=everything):
        c = k.flat2.certificate(m, claims, k.all)
        change(c)
        return c

    def turned(count):
        def change(c):
            words = [cell.split() for cell in c.cells]
            c.cells = [" ".join(w[:1] + w[1 + count:4] + w[1:1 + count] + w[4:]) for w in words]
        return change
    for count in (1, 2):
        m.accept("kinds-turned-%d" % count, changed(turned(count)), "every claim; the cells begin with their other corners")

    def mixed(c):
        for i, cell in enumerate(c.cells):
            w = cell.split()
            count = (i + i // 3) % 3
            c.cells[i] = " ".join(w[:1] + w[1 + count:4] + w[1:1 + count] + w[4:])
    m.accept("kinds-turned-mixed", changed(mixed), "every claim; each cell begins with another corner")
    of = lambda c, kinds: [cell for cell in c.cells if cell.split()[4] in kinds]
    for name, order in (("C", "CSTR"), ("S", "STRC"), ("R", "RCST")):
        m.accept("kinds-first-" + name, changed(lambda c: setattr(c, "cells", [cell for kind in order for cell in of(c, kind)[::1 if kind == "R" else -1]])),
                 "every claim; the cells in another order, those of kind %s first" % name)

    def other_halves(c):
        for number, (_, (a, b, d, e)) in enumerate(k.flat2.boxes):
            halves = [[(a, b, e), (b, d, e)], [(a, d, e), (a, b, d)], [(b, d, e), (a, b, e)]][number % 3]
            for i, half in enumerate(halves):
                c.cells[len(k.flat2.cells) + 2 * number + i] = "0 %d %d %d R %d" % (*half, number)
    m.accept("kinds-other-halves", changed(other_halves), "every claim; boxes with their other diagonal, or the far half first")
    edge = next(outline_edges(k.flat2))[0]
    m.accept("kinds-first-outline", changed(lambda c: c.cells.insert(0, c.cells.pop(edge))), "every claim; the first cell is a C cell at the outline")
    number = next(i for i, cell in enumerate(k.flat2.cells) if cell[2] == "C" and i > 20)

    def misfit(name, line, fault, change, reason):
        c = changed(change, ["L5"])
        m.reject("kinds-" + name, c, "kinds", "t " + c.cells[line], "cell-%d-%s" % (line, fault), reason)

    def renamed(number, kind):
        def change(c):
            c.cells[number] = c.cells[number][:-1] + kind
        return change
    misfit("C-as-T", number, "kind", renamed(number, "T"), "a T cell without a vertex")
    misfit("C-as-S", number, "kind", renamed(number, "S"), "a spoke triangle without a vertex")
    later = [i for i, cell in enumerate(k.flat2.cells) if cell[2] == "S" and i > 3][0]
    opening = max(i for i in range(later) if k.flat2.cells[i][2] == "T")
    misfit("later-fan", opening, "fan", lambda c: c.cells.__delitem__(later), "a fan with a gap that is not the first")

    tees = [i for i, cell in enumerate(k.flat2.cells) if cell[2] == "T"]
    last = changed(lambda c: None, ["L5"]).cells[tees[-2]]

    def gap_at_last(c):
        c.cells = [cell for i, cell in enumerate(c.cells) if cell != last and i != tees[-2] + 1] + [last]
    c = changed(gap_at_last, ["L5"])
    m.reject("kinds-last-fan", c, "kinds", "t " + last, "cell-%d-fan" % (len(c.cells) - 1), "the last cell opens a fan with a gap")

    # By hand: a square with cells that lie anywhere.
    def square(points, cell):
        corners = [(0, 0), (8, 0), (8, 8), (0, 8)]
        c = m.Certificate(2, corners, m.undirected(m.loop([0, 1, 2, 3])), [dict(corners=(0, 1, 2), boundary=m.loop([0, 1, 2, 3]))], points=points, cells=cell)
        c.claims.append("claim L5 1")
        return c

    def by_hand(name, points, cells, reason):
        m.reject("kinds-" + name, square(points, cells), "kinds", "t " + cells[0], "cell-0-kind", reason)
    # Segments: 0 (0,1), 1 (0,3), 2 (1,2), 3 (2,3).
    by_hand("T-other-segment", [("projection 2", (8, 4)), ("offset 0", (7, 6))], ["0 0 4 5 T"], "a T cell whose m is on a segment that does not end at v")
    box = lambda kinds, places, cells=("0 4 5 6 R 0", "0 4 6 7 R 0"): (list(zip(kinds, places)), list(cells))
    low = [(2, 0), (4, 0), (4, 1), (2, 1)]
    by_hand("R-arc", *box(["edge 0", "edge 0", "offset 0", "arc 0"], low), "a box whose last corner is an arc point")
    by_hand("R-free", *box(["offset 0"] * 4, [(2, 2), (4, 2), (4, 3), (2, 3)]), "a box that is on no segment")
    by_hand("R-two-segments", *box(["edge 0", "edge 2", "offset 0", "offset 0"], [(6, 0), (8, 2), (6, 4), (4, 2)]), "a box whose neighbours are on two segments")
    by_hand("R-across", *box(["edge 0", "edge 0", "edge 3", "edge 3"], [(2, 0), (4, 0), (4, 8), (2, 8)]), "a box from one segment to another")
    by_hand("R-vertex", ([("edge 0", (4, 0)), ("offset 0", (4, 1)), ("offset 0", (0, 1))][:2] + [("edge 1", (0, 1))]), ["0 0 4 5 R 0", "0 0 5 6 R 0"], "a box at a vertex")


def protected(m, corners, feet, offset, rows, apex=0):
    """A polygon with one row point and one protector for each edge: T cells, spoke triangles, and a fan of C cells. feet: where on each edge; rows: A at the first and second vertex of each segment."""
    n = len(corners)
    loop = m.loop(list(range(n)))
    segments = m.undirected(loop)
    points, rims = [], []
    for i, (a, b) in enumerate(loop):
        p, u = corners[a], tuple(y - x for x, y in zip(corners[a], corners[b]))
        length = Q(isqrt(int(u[0] ** 2 + u[1] ** 2)))  # rounded: offsets may be a little wrong
        foot = tuple(x + feet[i] * y for x, y in zip(p, u))
        points.append(("projection %d" % segments.index((min(a, b), max(a, b))), foot))
        rims.append(("offset 0", (foot[0] - u[1] * offset / length, foot[1] + u[0] * offset / length)))
    foot, tip = (lambda i: n + i % n), (lambda i: 2 * n + i % n)
    cells = []
    for i in range(n):
        cells += ["0 %d %d %d T" % (i, foot(i), tip(i)), "0 %d %d %d S" % (i, tip(i), tip(i - 1)), "0 %d %d %d T" % (i, tip(i - 1), foot(i - 1))]
    cells += ["0 %d %d %d C" % (tip(apex), tip(apex + i), tip(apex + i + 1)) for i in range(1, n - 1)]
    c = m.Certificate(2, corners, segments, [dict(corners=(0, n // 2, n - 1), boundary=loop)], points=points + rims, cells=cells)
    c.claims.append("claim H-offset %d" % (2 * n))
    half = m.rational(Q(1, 2))
    c.parameters = ["ball %d 1000/1" % v for v in range(n)] + ["row %d %s %s %s %s %s" % (s, m.rational(offset), m.rational(rows[s][0]), half, m.rational(rows[s][1]), half) for s in range(n)]
    return c


def write_angles(m):
    """Multiples of angles beyond a right one: T_3(A) < 0, and U_2(A) = 0."""
    # The angle of the first corner is exactly three times that with cosine 4/5; those of the others are acute.
    base = Q(4, 5)
    assert chebyshev(3, base) == Q(-44, 125)
    def obtuse(first, others):
        corners = [(Q(0), Q(0)), (Q(125), Q(0)), (Q(-44), Q(117))]
        return protected(m, corners, [Q(1, 5), Q(1, 2), Q(4, 5)], Q(5), {0: (first, others), 1: (first, others), 2: (others, others)})
    wide = Q(99, 100)
    m.accept("obtuse-exact", obtuse(base, wide), "an angle that is exactly three times that of A")
    bad = obtuse(base - TINY, wide)
    m.reject("obtuse", bad, "H-offset", "t " + bad.cells[0], "cell-0-point-6", "an angle just below three times that of A, which is obtuse")
    bad = obtuse(base, base)
    m.reject("obtuse-acute", bad, "H-offset", "t " + bad.cells[3], "cell-3-point-7", "an acute angle, three times that of A is obtuse")
    def straight(a):
        corners = [(Q(0), Q(0)), (Q(4), Q(0)), (Q(8), Q(0)), (Q(8), Q(12)), (Q(0), Q(12))]
        flat = lambda first, second: tuple(a if v == 1 else Q(9, 10) for v in (first, second))
        rows = {s: flat(*ends) for s, ends in enumerate(m.undirected(m.loop(list(range(5)))))}
        return protected(m, corners, [Q(1, 2), Q(1, 2), Q(1, 6), Q(1, 2), Q(5, 6)], Q(1), rows, apex=2)
    m.accept("straight-hair", straight(Q(1, 2) + TINY), "three times A is just less than a straight angle")
    bad = straight(Q(1, 2))
    m.reject("straight", bad, "H-offset", "t " + bad.cells[3], "cell-3-point-11", "three times A is exactly a straight angle")
    k = Cases(m)
    chord_only = lambda c: [line if not line.startswith("angle") else angle(m, 4, c) for line in k.all]
    k.good("H-chord-wide", k.flat2, ["H-chord"], chord_only(Q(3, 4)), "4 psi is 166 degrees")
    k.bad("H-chord-wider", k.flat2, ["H-chord"], chord_only(Q(2, 3)), "H-chord", angle(m, 4, Q(2, 3)), "angle-4", "4 psi is 193 degrees")


def write_near(m):
    """L21 in boxes of the grid."""
    c = m.Certificate(3, [(0, 0, 0), (2, 0, 0)], [], [])
    c.claims.append("claim L21 2")
    c.parameters = ["ball 1 1/1"]
    m.reject("claim-L21-first-vertex", c, "L21", "v 2 0 0 1", "vertex-1-vertex-0", "the first of all entities is too near")
    # Cells of the grid, which is counted from vertex 0, on both sides of an edge of them: their boxes touch. A pair with a slack of 0 comes before, so that the search goes no farther than that.
    far = m.Certificate(3, [(0, 0, 0), (4, 0, 0), (-1, -1, 50), (1, 1, 50), (2 ** 90, 0, 0), (-2 ** 90, 2 ** 90, -2 ** 90)], [], [])
    far.claims.append("claim L21 6")
    far.parameters = ["r 4/3"]
    m.reject("claim-L21-neighbouring-cells", far, "L21", "v 1 1 32 1", "vertex-3-vertex-2", "two vertices just closer than 3 r, in cells of the grid that touch")
    c = m.Certificate(3, [(0, 0, 0), (1000, 0, 0)] + [(k, k * k, 1) for k in range(1, 9)], [], [])
    c.claims.append("claim L21 10")
    # Slacks that differ by little, that of the later pair is smaller: REPORTS.tsv has it. The unit of the grid is 1.
    for name, r, one, two in (("little", Q(1, 3), 1000, 999), ("less", Q(2 ** 20, 3), 10 ** 12, 10 ** 12 - 10)):
        far = m.Certificate(3, [(0, 0, 0), (one, 0, 0), (10 ** 14, 0, 0), (10 ** 14 + two, 0, 0), (2 ** 48 - 1, 7, 9)], [], [])
        far.claims.append("claim L21 5")
        far.parameters = ["r " + m.rational(r)]
        m.accept("claim-L21-slack-" + name, far, "two pairs of vertices whose distances differ by little; the later one is nearer")
    for name, power in (("large", 30), ("larger", 100)):
        c.parameters = ["r " + m.rational(Q(2 ** power, 3))]
        m.reject("claim-L21-" + name, c, "L21", "v 3e8 0 0 1", "vertex-1-vertex-0", "r so large that its square on the grid has more than 128 bits, the lower ones 0")
