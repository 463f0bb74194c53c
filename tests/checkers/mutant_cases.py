# SPDX-License-Identifier: Apache-2.0
"""Cases that were added because a changed checker (mutation/mutate_checker.py) was noticed by no other."""
from fractions import Fraction as Q


def standing(points):
    """(y, z) in the plane x = 0."""
    return [(0, y, z) for y, z in points]


def write_for_mutants(m):
    write_distinct(m)
    write_planes(m)
    write_pairs(m)
    write_boxes(m)
    write_details(m)
    write_hanging(m)
    write_pierced(m)


def write_distinct(m):
    c = m.worked()
    c.points[0] = ("interior 0", (0, 0, 0))
    m.reject("distinct-first-vertex", c, "distinct", "q interior 0 0 0 0 1", "point-5-point-0", "a point coincides with vertex 0")
    many = m.Certificate(3, [(1, 2, 3)] * 40, [], [])
    m.reject("distinct-forty", many, "distinct", ("v 1 2 3 1", 2), "point-1-point-0", "forty vertices at one place: more than a sort of few leaves in their order")
    mixed = m.Certificate(3, [(i, 0, 0) for i in range(40)] + [(7, 0, 0), (3, 0, 0)], [], [])
    for axis, name in enumerate("xyz"):
        pair = []
        for value in same_hash(axis):
            point = [1, 1, 1]
            point[axis] = value
            pair.append(tuple(point))
        m.reject("distinct-one-hash-" + name, m.Certificate(3, pair * 2, [], []), "distinct", ("v %x %x %x 1" % pair[0], 2), "point-2-point-0",
                 "two points in turn that differ in %s and have one hash value in the checker" % name)
    # Weights without a small common multiple: then there is no common denominator.
    first, second = [(Q(1, w),) * 3 for w in same_hash(3)]
    others = [(Q(2 * k + 7, 10 ** 38 + 2 * k + 1), 0, 0) for k in range(40)]
    weighted = m.Certificate(3, [first, others[0], first, second, *others[1:], second], [], [])
    m.reject("distinct-one-hash-w", weighted, "distinct", ("v 1 1 1 %x" % first[0].denominator, 2), "point-2-point-0", "points that differ in W and have one hash value; no common denominator")
    m.reject("distinct-two-pairs", mixed, "distinct", ("v 7 0 0 1", 2), "point-40-point-7", "two pairs coincide: the smaller of the later ones is named")


def same_hash(axis):
    """Two numbers of 128 bits, positive, that Points::hash takes for one, as one of the coordinates x y z W, the others 1."""
    mask = (1 << 64) - 1

    def mix(state, value):
        state = (state ^ value) * 0xff51afd7ed558ccd & mask
        return state ^ state >> 32
    state = 0x9e3779b97f4a7c15
    for _ in range(axis):
        state = mix(mix(state, 2), 1)
    state = mix(state, 4)
    first, second = mix(state, 3), mix(state, 5)
    high = 1 << 62 | 12345
    return high << 64 | 3, (high ^ first ^ second) << 64 | 5


def write_planes(m):
    """A plane in which only x decides, and whether all points lie in one plane."""
    upright = m.Certificate(3, standing([(0, 0), (4, 0), (0, 4)]), [(0, 1), (0, 2), (1, 2)], [dict(corners=(0, 1, 2), boundary=m.loop([0, 1, 2]))],
                            points=[("interior 0", (0, 1, 1))], cells=["0 0 1 3 C", "0 1 2 3 C", "0 2 0 3 C"])
    m.accept("upright", upright, "a facet in the plane x = 0")
    upright.points = [("interior 0", (Q(1, 2 ** 70), 1, 1))]
    m.reject("carrier-off-upright-plane", upright, "carrier", "q interior 0 " + m.homogeneous(upright.points[0][1]), "point-3-facet-0", "a point a little outside the plane x = 0")
    c = m.folded()
    c.points.append(("interior 0", (2, 1, 0)))
    c.cells += ["1 0 1 5 C"]
    m.reject("carrier-only-in-other-facet", c, "carrier", "q interior 0 2 1 0 1", "point-5-in-no-cell", "a point of a facet that is a corner of a cell of another facet only")
    for name, points, reason in [
            ("coplanar-loose", [(0, 0, 1), (1, 0, 1), (2, 0, 1), (5, 7, 1), (6, 1, 1)], "vertices and no facet, all in one plane; the first three on a line"),
            ("not-coplanar-second", [(0, 0, 0), (5, 5, 5), (1, 0, 0), (0, 1, 0), (3, 2, 0)], "all but vertex 1 in one plane"),
            ("not-coplanar-third", [(0, 0, 0), (1, 0, 0), (5, 5, 5), (0, 1, 0), (3, 2, 0), (4, 7, 0)], "all but vertex 2 in one plane"),
            ("not-coplanar-last", [(0, 0, 0), (1, 0, 0), (0, 1, 0), (3, 2, 0), (4, 7, 1)], "all but the last vertex in one plane"),
            ("coplanar-beside", None, "a facet, and a vertex beside it in its plane"),
            ("coplanar-collinear", [(0, 0, 0), (1, 1, 1), (2, 2, 2), (3, 3, 3)], "vertices on a line")]:
        c = m.Certificate(3, points, [], []) if points else m.planar([(0, 0), (4, 0), (0, 4)], [0, 1, 2], extra=[(9, 9, 0)])
        m.accept(name, c, reason)
    below = m.planar([(0, 0), (4, 0), (0, 4)], [0, 1, 2])
    below.vertices.insert(0, (9, 9, 9))
    below.segments, below.cells = [(1, 2), (1, 3), (2, 3)], ["0 1 2 3 C"]
    below.facets = [dict(corners=(1, 2, 3), boundary=m.loop([1, 2, 3]))]
    m.accept("not-coplanar-first", below, "all but vertex 0 in the facet's plane")
    above = m.planar([(0, 0), (4, 0), (0, 4)], [0, 1, 2], extra=[(9, 9, 9)])
    m.accept("not-coplanar-facet", above, "all but the last vertex in the facet's plane")


def two_facets(m, first, second, offset=""):
    """Two triangles far from each other."""
    vertices = list(first) + list(second)
    loops = [m.loop([0, 1, 2]), m.loop([3, 4, 5])]
    return m.Certificate(3, vertices, m.undirected(loops[0] + loops[1]), [dict(corners=(0, 1, 2), boundary=loops[0]), dict(corners=(3, 4, 5), boundary=loops[1])],
                         cells=["0 0 1 2 C", "1 3 4 5 C" + offset])


def write_pairs(m):
    """The smallest relative power is that of a point of the other facet, whose plane differs little from this one: REPORTS.tsv has it."""
    flat = [(0, 0, 0), (4, 0, 0), (0, 4, 0)]
    wall = [(0, 0, 0), (2, -2, 0), (0, 0, 3)]           # normal (1, 1, 0)
    for name, first, second, reason in [
            ("parallel", flat, [(9, 0, 1), (13, 0, 1), (9, 4, 1)], "two parallel planes"),
            ("parallel-other-side", flat, [(9, 0, 1), (9, 4, 1), (13, 0, 1)], "two parallel planes, the facets seen from opposite sides"),
            ("parallel-x", standing([(0, 0), (4, 0), (0, 4)]), [(1, y, z) for y, z in [(9, 0), (13, 0), (9, 4)]], "the planes x = 0 and x = 1"),
            ("parallel-y", [(0, 0, 0), (0, 0, 4), (4, 0, 0)], [(9, 1, 0), (9, 1, 4), (13, 1, 0)], "the planes y = 0 and y = 1"),
            ("normals-x", wall, [(10, -20, 0), (12, -24, 0), (10, -20, 3)], "normals (1,1,0) and (2,1,0), both planes through the origin"),
            ("normals-y", wall, [(20, -10, 0), (24, -12, 0), (20, -10, 3)], "normals (1,1,0) and (1,2,0)"),
            ("normals-z", flat, [(9, 0, 0), (13, 0, 0), (9, 0, 4)], "normals (0,0,1) and (0,1,0)"),
            ("coplanar-opposite", flat, [(9, 0, 0), (9, 4, 0), (13, 0, 0)], "one plane, the facets seen from opposite sides"),
            ("coplanar-away", [(Q(1, 3), 0, 5), (4, 0, 5), (0, 4, 5)], [(9, 0, 5), (9, 4, 5), (13, Q(1, 7), 5)], "one plane that is not through the origin")]:
        m.accept("pair-" + name, two_facets(m, first, second), reason)
    near = two_facets(m, flat, [(9, 0, 0), (13, 0, 0), (9, 4, 0)], " 1/4")
    near.vertices.append((10, 1, -1))
    m.accept("offset-second-facet", near, "a sphere with an offset in the second facet, which alone leaves a vertex outside")
    near.cells[1] = "1 3 4 5 C"
    m.reject("offset-second-facet-without", near, "emptiness", "t 1 3 4 5 C", "cell-1-point-6", "the same without the offset")
    # In floats one component of the second facet's normal is out of range: the cell has to be in doubt.
    tiny = Q(1, 2 ** 300)
    for name, x, y, turn in [("x", tiny, 0, lambda p: p), ("y", 0, tiny, lambda p: p), ("z", tiny, 0, lambda p: p[1:] + p[:1])]:
        tilted = two_facets(m, map(turn, flat), map(turn, [(9, 0, 0), (13, 0, x), (9, 4, y)]), " -1/4")
        tilted.vertices.append(turn((10, 1, -1)))
        m.reject("offset-normal-tiny-" + name, tilted, "emptiness", "t 1 3 4 5 C -1/4", "cell-1-point-6", "a facet whose normal has a component %s of 2^-298, and a sphere with an offset" % name)
    offset = " -1" + "0" * 275 + "/1"
    huge = two_facets(m, flat, [(9, 0, 0), (13, 0, 0), (9, 4, 0)], offset)
    huge.vertices.append((10, 1, -1))
    m.reject("offset-huge", huge, "emptiness", "t 1 3 4 5 C" + offset, "cell-1-point-6", "an offset of -2^1100, which as a double is infinite, along (0,0,16)")


def behind(c, first):
    """The same with one more vertex before all others, from which the grid is counted."""
    c.vertices.insert(0, first)
    c.segments = [(a + 1, b + 1) for a, b in c.segments]
    for facet in c.facets:
        facet["corners"] = [v + 1 for v in facet["corners"]]
        facet["boundary"] = [(a + 1, b + 1) for a, b in facet["boundary"]]
    c.cells = ["%s %d %d %d %s" % (f, int(a) + 1, int(b) + 1, int(d) + 1, kind) for f, a, b, d, kind in (cell.split() for cell in c.cells)]
    c.hanging = [(s, a + 1, b + 1) for s, a, b in c.hanging]
    return c


def write_details(m):
    """So many points in one cell of the grid, because others are very far away, that they get a tree of their own; then the same without a common
    denominator, and far from the first vertex on either side."""
    around = [(x, y, z) for z in (-3, 3) for y in range(-3, 6) for x in range(-3, 6)]
    far, spread = (2 ** 90, -2 ** 91, 2 ** 89), [(sign * k * 2 ** 87, sign * (19 - k) * 2 ** 87, sign * k * k * 2 ** 83) for k in range(1, 19) for sign in (1, -1)]
    weights = [(Q(2 ** 90 + 3 * k, 10 ** 40 + 7919 * k), 6, 5) for k in range(12)]
    for name, others, first in [("", [far], None), ("weights-", [far] + weights, None), ("positive-", spread, -2 ** 89), ("negative-", spread, 2 ** 89)]:
        by = 0 if first is None else 1
        placed = lambda c: c if first is None else behind(c, (first, first, first))
        def facet(place, where):
            c = m.planar([(0, 0), (4, 0), (0, 4)], [0, 1, 2], extra=around + others)
            c.vertices[place] = where
            return placed(c)
        cell = "t 0 %d %d %d C" % (by, by + 1, by + 2)
        for place, on, just in [(60, (2, 4, 2), (2, 4, 2 + Q(1, 2 ** 90))), (100, (2, 0, -2), (2, 0, -2 - Q(1, 2 ** 90))), (140, (4, 2, 2), (4, 2, 2 + Q(1, 2 ** 90)))]:
            m.accept("detail-%s%d-just-outside" % (name, place), facet(place, just), "a point by 2^-90 outside the sphere, among many in one cell of the grid")
            m.reject("detail-%s%d-on" % (name, place), facet(place, on), "emptiness", cell, "cell-0-point-%d" % (place + by), "the same exactly on the sphere")
        def hanging(where):
            c = m.planar([(0, 0), (4, 0), (0, 4)], [0, 1, 2], extra=[(0, 0, 5), (0, 0, 9)] + around + others, segments=[(3, 4)])
            c.vertices[95] = where
            c.hanging = [(3, 3, 4)]
            return placed(c)
        m.accept("detail-%shanging-just-outside" % name, hanging((0, 2, 7 + Q(1, 2 ** 90))), "a vertex by 2^-90 outside the ball of a hanging edge, among many in one cell of the grid")
        m.reject("detail-%shanging-on" % name, hanging((0, 2, 7)), "hanging", "h 3 %d %d" % (3 + by, 4 + by), "subsegment-0-point-%d" % (95 + by), "the same exactly on the ball")
    side = 2 ** 70
    above = [(x, y, z + 4 * side - (2 ** 38 if k == 97 else 0)) for k, (x, y, z) in enumerate(around)]
    m.accept("detail-above", m.planar([(0, 0), (side, 0), (0, side)], [0, 1, 2], extra=above + spread), "the smallest relative power is that of a detail, far outside the sphere: REPORTS.tsv has it")


def write_hanging(m):
    def parts(name, hanging, thing, reason):
        c = m.worked()
        c.hanging = hanging
        m.reject("hanging-" + name, c, "hanging", "h %d %d %d" % hanging[0], thing, reason)
    parts("part-of-a-point", [(3, 3, 3), (3, 3, 6), (3, 6, 4)], "subsegment-0-point-3-not-forward", "a subsegment from a point to itself")
    parts("over-vertex", [(3, 3, 0), (3, 0, 4)], "subsegment-0-point-0-not-on-segment", "a hanging segment by way of a vertex")
    two = m.worked()
    two.vertices += [(9, 1, 5), (9, 1, 9)]
    two.segments.append((5, 6))
    two.points = [two.points[0], ("edge 4", (9, 1, 7))]
    two.cells = [cell.replace("5", "7") for cell in two.cells]
    two.hanging = [(3, 3, 8), (3, 8, 4), (4, 5, 8), (4, 8, 6)]
    m.reject("hanging-other-point", two, "hanging", "h 3 3 8", "subsegment-0-point-8-not-on-segment", "a hanging segment by way of another one's point")
    two.hanging = [(3, 3, 4), (4, 5, 8), (4, 8, 6)]
    two.vertices += [(Q(7, 2), 1, 7), (12, 1, 6)]
    two.cells = [cell.replace("7", "9") for cell in two.cells]
    two.hanging = [(3, 3, 4), (4, 5, 10), (4, 10, 6)]
    two.claims.append("claim L22 3")
    m.accept("hanging-first-tightest", two, "of three subsegments the first one's ball has the nearest point: REPORTS.tsv has its slack")
    diagonal = m.square(segments=[(0, 2)], extra=[(Q(1, 2), Q(1, 2), 2)])
    diagonal.hanging = [(diagonal.segments.index((0, 2)), 0, 2)]
    m.reject("hanging-diagonal", diagonal, "hanging", "h %d 0 2" % diagonal.hanging[0][0], "subsegment-0-point-1", "the diagonal of a square as a hanging segment: no tie of the facet")


def write_boxes(m):
    """Each edge of either triangle of a box as the common one."""
    square = m.square()
    for turn in range(3):
        for other in range(3):
            first, second = [0, 1, 2], [0, 2, 3]
            first, second = first[turn:] + first[:turn], second[other:] + second[:other]
            square.cells = ["0 %d %d %d R 0" % tuple(first), "0 %d %d %d R 0" % tuple(second)]
            m.accept("box-turned-%d-%d" % (turn, other), square, "a box whose triangles begin at other corners")
    c = m.rows_and_boxes()
    place = [i for i, cell in enumerate(c.cells) if "R" not in cell][0]
    rest, boxes = [cell for cell in c.cells if "R" not in cell], [cell for cell in c.cells if "R" in cell]
    a = rest[place].split()[:4]
    c.cells = rest[:3] + [" ".join(a) + " R 0", " ".join(a) + " R 0"] + [cell[:-1] + str(int(cell[-1]) + 1) for cell in boxes]
    m.reject("box-after-cells", c, "box", ("t " + c.cells[3], 1), "box-0-no-common-edge", "a box at fault that is not the first cell")
    over = m.square()
    over.cells = ["0 0 1 2 R 0", "0 0 1 3 R 0"]
    m.reject("box-one-side", over, "box", "t 0 0 1 2 R 0", "box-0-no-common-edge", "the triangles of a box lie on one side of their common edge")
    ring = [(0, 0), (2, 0), (2, 3), (0, 2)]
    upright = m.Certificate(3, standing(ring), m.undirected(m.loop([0, 1, 2, 3])), [dict(corners=(0, 1, 2), boundary=m.loop([0, 1, 2, 3]))],
                            cells=["0 0 1 2 R 0", "0 0 2 3 R 0"])
    m.reject("box-no-parallelogram-z", upright, "box", "t 0 0 1 2 R 0", "box-0-no-parallelogram", "right-angled at one corner; opposite sides differ in z alone")
    ring = [(0, 0), (2, 0), (3, 2), (0, 2)]
    flat = m.Certificate(3, [(x, y, 0) for x, y in ring], m.undirected(m.loop([0, 1, 2, 3])), [dict(corners=(0, 1, 2), boundary=m.loop([0, 1, 2, 3]))],
                         cells=["0 0 1 2 R 0", "0 0 2 3 R 0"])
    m.reject("box-no-parallelogram-x", flat, "box", "t 0 0 1 2 R 0", "box-0-no-parallelogram", "the same, in x alone")


# A polygon with corners at one height, a notch and a hole; where segments pass its plane: (x, y), and whether that is in the polygon.
NOTCHED = [(0, 0), (12, 0), (12, 8), (6, 4), (0, 8)]
PASSES = [("inside", (6, 2), True), ("level-with-notch", (2, 4), True), ("level-with-notch-right", (11, 4), True), ("below-notch", (6, Q(7, 2)), True), ("on-edge", (12, 3), True), ("on-slanted-edge", (9, 6), True),
          ("notch", (6, 7), False), ("notch-high", (Q(13, 2), 8), False), ("level-with-corners-left", (-40, 8), False), ("level-with-corners-right", (60, 8), False), ("level-with-base", (-50, 0), False), ("level-with-base-right", (60, 0), False),
          ("left", (-40, 3), False), ("right", (60, 3), False), ("level-left", (-40, 4), False), ("level-right", (60, 4), False), ("above", (5, 60), False), ("below", (5, -50), False)]


def write_pierced(m):
    """L21: does a segment meet a facet? In three positions of the plane, the segment through it, or ending on it."""
    turns = {"xy": lambda x, y, z: (x, y, z), "yz": lambda x, y, z: (z, x, y), "zx": lambda x, y, z: (y, z, x)}
    cells = [(0, 1, 3), (1, 2, 3), (0, 3, 4)]
    for axes, turn in turns.items():
        for name, (x, y), inside in PASSES:
            for how, heights in (("through", (-1, 2)), ("ends", (0, 7)), ("starts", (-7, 0))):
                if (how != "through" and name not in ("inside", "right", "notch")) or (axes != "xy" and name not in ("inside", "on-edge", "notch", "level-with-notch", "left", "above")):
                    continue
                vertices = [turn(a, b, 0) for a, b in NOTCHED] + [turn(x, y, z) for z in heights]
                loop = m.loop([0, 1, 2, 3, 4])
                segments = m.undirected(loop + [(5, 6)])
                c = m.Certificate(3, vertices, segments, [dict(corners=(0, 1, 2), boundary=loop)], cells=["0 %d %d %d C" % t for t in cells], hanging=[(segments.index((5, 6)), 5, 6)])
                c.claims.append("claim L21 %d" % (len(vertices) + len(segments)))
                c.parameters = ["r " + m.rational(Q(1, 1000))]
                reason = "a segment %s the plane, %s" % ({"through": "passes", "ends": "begins in", "starts": "ends in"}[how], "in the facet" if inside else "beside the facet")
                if not inside:
                    m.accept("-".join(("beside", axes, name, how)), c, reason)
                    continue
                # The nearest in the order of entities: a corner of the segment, the segment with an edge, the segment with the facet.
                line, thing = {"through": ("f 0 1 2", "facet-0-segment-5"), "ends": ("f 0 1 2", "facet-0-vertex-5"), "starts": ("f 0 1 2", "facet-0-vertex-6")}[how]
                if name == "on-edge":
                    line, thing = "s 5 6", "segment-5-segment-2"
                if name == "on-slanted-edge":
                    line, thing = "s 5 6", "segment-5-segment-3"
                m.reject("-".join(("pierced", axes, name, how)), c, "L21", line, thing, reason)
