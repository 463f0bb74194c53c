# SPDX-License-Identifier: Apache-2.0
"""The cases of make_certificates.py: accepted, rejected and declined ones here, malformed ones in malformed_cases.py."""
from fractions import Fraction as Q

from claim_cases import Cases, write_claims
from malformed_cases import write_malformed
from mutant_cases import write_for_mutants
from mutant_claims import write_claims_for_mutants
from mutant_features import write_features_for_mutants
from mutant_sizes import write_sizes_for_mutants
from refutation_cases import write_refutations
from facet_cases import write_facets
from text_cases import write_text


def write_all(m):
    write_accepted(m)
    write_rejected_structure(m)
    write_rejected_geometry(m)
    write_rejected_rows(m)
    write_declined(m)
    write_malformed(m)
    write_claims(m)
    write_refutations(m)
    write_for_mutants(m)
    write_text(m)
    write_facets(m)
    cases = Cases(m)
    write_claims_for_mutants(m, cases)
    write_sizes_for_mutants(m, cases)
    write_features_for_mutants(m, cases)


def write_accepted(m):
    m.accept("worked-example", m.worked(), "the worked example of the specification")
    m.accept("worked-example-raw-zstd", m.zstd_raw(m.worked().text()), "the same in a zstd frame of raw blocks")
    m.accept("nothing", m.Certificate(3, [], [], []), "no vertices at all")
    m.accept("single-vertex", m.Certificate(3, [(1, 2, Q(1, 3))], [], []), "one vertex and nothing else")
    m.accept("cube", m.cube(), "six squares, eight vertices, two cells of one circle each: ties within the plane, inside the constraints")
    m.accept("square-diagonal-free", m.square(extra=[(Q(1, 2), Q(1, 2), 2), (Q(1, 2), Q(1, 2), -2)]),
             "one square facet: either diagonal will do")
    offset = m.planar([(0, 0), (4, 0), (0, 4)], [0, 1, 2], extra=[(1, 1, 1)])
    offset.cells = ["0 0 1 2 C -1/4"]
    m.accept("offset", offset, "a vertex within the smallest sphere, outside the one with the offset")
    offset = m.planar([(0, 0), (4, 0), (0, 4)], [0, 1, 2], extra=[(1, 1, -1)])
    offset.cells = ["0 0 1 2 C 3/10"]
    m.accept("offset-positive", offset, "the same below, with a positive offset")
    m.accept("hole", m.with_hole(), "a facet with a hole; its cells are isosceles trapezoids with ties")
    m.accept("slit", m.with_slit(), "an inner constraint that lies free in the facet")
    dangling = m.planar(m.SLIT[:5], [0, 1, 2, 3], inner=[(0, 4)])
    m.accept("dangling", dangling, "an inner constraint that hangs on a corner of the facet")
    m.accept("isolated", m.planar(m.SLIT[:5], [0, 1, 2, 3], isolated=[4]), "an isolated vertex")
    m.accept("slit-with-point", slit_with_point(m), "an inner constraint that carries a point")
    m.accept("rows-boxes", m.rows_and_boxes(), "a row, its protector and two boxes")
    m.accept("rows-boxes-dim2", m.rows_and_boxes(2), "the same in dimension 2")
    m.accept("rows-inner", rows_inner(m), "an inner constraint with protectors on both sides")
    m.accept("folded", m.folded(), "two facets in different planes; their common edge carries a point")
    m.accept("hanging", hanging(m), "hanging segments only, one of them of three parts")
    m.accept("coplanar", m.planar(m.SLIT, [0, 1, 2, 3], isolated=[4, 5]), "dimension 3, but all points lie in one plane")
    m.accept("dim2-thirds", m.Certificate(2, [(Q(1, 3), Q(1, 7)), (Q(4, 3), Q(1, 7)), (Q(4, 3), Q(8, 7)), (Q(1, 3), Q(8, 7))],
             m.undirected(m.loop([0, 1, 2, 3])), [dict(corners=(0, 1, 2), boundary=m.loop([0, 1, 2, 3]))], cells=["0 0 1 2 C", "0 0 2 3 C"]),
             "dimension 2, W not a power of two, an exact tie")
    m.accept("dim2-circle", m.circle(2), "24 points on a circle whose denominators have no common multiple of use")
    m.accept("dim3-circle", m.circle(3, extra=[(0, 0, 2), (0, 0, -2)]), "the same in dimension 3, with points above and below")
    m.accept("dim2-hanging", m.Certificate(2, [(0, 0), (4, 0)], [(0, 1)], [], points=[("edge 0", (1, 0))], hanging=[(0, 0, 2), (0, 2, 1)]),
             "dimension 2 without a facet")
    m.accept("nearly-degenerate", nearly_degenerate(m), "a cell whose circle is far larger than the domain")
    m.accept("two-loops-at-a-vertex", bow_tie(m), "two boundary loops that meet at a vertex")


def slit_with_point(m):
    points = m.SLIT + [(3, Q(5, 2))]
    c = m.planar(points, [0, 1, 2, 3], inner=[(4, 5)])
    del c.vertices[6]
    c.points = [("edge 4", (3, Q(5, 2), 0))]
    return c


def rows_inner(m):
    points = [(0, 0), (12, 0), (13, 11), (0, 10), (3, 5), (9, 5)] + [(5, 5), (7, 5)] + [(5, 6), (7, 6)] + [(5, 4), (7, 4)]
    boxes = [(6, 7, 9, 8), (6, 10, 11, 7)]
    polygons = m.delaunay(points)
    rest = [p for p in polygons if set(p) not in [set(b) for b in boxes]]
    cells = m.fans(rest)
    for number, (a, b, c, d) in enumerate(boxes):
        cells += ["0 %d %d %d R %d" % (a, b, c, number), "0 %d %d %d R %d" % (a, c, d, number)]
    segments = m.undirected(m.loop([0, 1, 2, 3]) + [(4, 5)])
    number = segments.index((4, 5))
    kinds = ["edge %d" % number] * 2 + ["offset 0"] * 4
    return m.Certificate(3, m.lift(points[:6]), segments, [dict(corners=(0, 1, 2), boundary=m.loop([0, 1, 2, 3]), inner=[(4, 5)])],
                         points=list(zip(kinds, m.lift(points[6:]))), cells=cells,
                         rows=[("%d 2" % number, [6, 7]), ("%d 2 0 +" % number, [8, 9]), ("%d 2 0 -" % number, [10, 11])])


def hanging(m):
    return m.Certificate(3, [(0, 0, 0), (9, 0, 0), (0, 5, 1), (0, 9, 1)], [(0, 1), (2, 3)], [],
                         points=[("edge 0", (6, 0, 0)), ("projection 0", (2, 0, 0))],
                         hanging=[(0, 0, 5), (0, 5, 4), (0, 4, 1), (1, 2, 3)])


def nearly_degenerate(m):
    """Three corners that are nearly collinear: the radius is about 2^60 times the extent."""
    tiny = Q(1, 2 ** 62)
    return m.planar([(0, 0), (1, -tiny), (2, 0)], [0, 1, 2], extra=[(1, -1, 1), (0, -1, -1), (3, -2, 1)])


def bow_tie(m):
    points = [(0, 0), (4, 1), (3, 4), (-4, 1), (-3, 4)]
    loops = m.loop([0, 1, 2]) + m.loop([0, 4, 3])
    return m.Certificate(3, m.lift(points), m.undirected(loops), [dict(corners=(0, 1, 2), boundary=loops)], cells=["0 0 1 2 C", "0 0 4 3 C"])


def write_rejected_structure(m):
    text = m.worked().text()
    last = text.split("\n")[-2]
    swapped = last[:-1] + ("4" if last[-1] != "4" else "5")
    m.reject("hash", text.replace(last, swapped), "hash", swapped, "digest", "one digit of the digest differs")
    m.reject("hash-note", text.replace("by hand", "by hans"), "hash", last, "digest", "a note was changed")

    def worked_with(name, rule, line, thing, reason, **facet):
        c = m.worked()
        c.vertices.append((3, 3, 0))
        c.cells = [cell.replace("5", "6") for cell in c.cells]
        c.hanging = [(3, 3, 7), (3, 7, 4)]
        c.segments = facet.pop("segments", c.segments)
        c.facets[0].update(facet)
        m.reject(name, c, rule, line, thing, reason)

    worked_with("complex-corner-elsewhere", "complex", "f 0 1 5", "facet-0-vertex-5", "a corner of the f line that does not occur in the facet", corners=(0, 1, 5))
    worked_with("complex-corner-twice", "complex", "f 0 1 1", "facet-0-collinear", "the f line names a vertex twice", corners=(0, 1, 1))
    worked_with("complex-no-segment", "complex", ("0 1", 1), "facet-0-edge-0-1-no-segment", "a boundary edge that is no segment",
                segments=[(0, 2), (1, 2), (3, 4), (3, 5)])
    worked_with("complex-loop-edge", "complex", ("1 1", 1), "facet-0-edge-1-1-no-segment", "a boundary edge from a vertex to itself",
                boundary=m.loop([0, 1, 2]) + [(1, 1)])
    worked_with("complex-constraint-no-segment", "complex", ("0 5", 1), "facet-0-constraint-0-5-no-segment", "an inner constraint that is no segment", inner=[(0, 5)])
    worked_with("complex-constraint-on-boundary", "complex", ("0 1", 2), "facet-0-constraint-0-1-on-boundary", "a segment as boundary edge and as inner constraint",
                inner=[(0, 1)])
    worked_with("complex-both-directions", "complex", ("1 0", 1), "facet-0-edge-1-0-both-directions", "a boundary edge in both directions",
                boundary=[(0, 1), (1, 0), (1, 2), (2, 1), (2, 0), (0, 2)])
    worked_with("complex-unbalanced", "complex", ("0 1", 1), "facet-0-vertex-0-unbalanced", "two edges leave a vertex and none arrives",
                boundary=[(0, 1), (1, 2), (0, 2)])
    worked_with("complex-not-isolated-boundary", "complex", ("2", 1), "facet-0-vertex-2-not-isolated", "an isolated vertex on the boundary", isolated=[2])
    worked_with("complex-not-isolated-inner", "complex", ("5", 1), "facet-0-vertex-5-not-isolated", "an isolated vertex on an inner constraint",
                inner=[(0, 5)], isolated=[5], segments=[(0, 1), (0, 2), (0, 5), (1, 2)][:4] + [(3, 4)])
    worked_with("complex-off-plane-isolated", "complex", ("4", 1), "facet-0-vertex-4", "an isolated vertex outside the plane", isolated=[4])
    worked_with("complex-off-plane-inner", "complex", ("3 4", 1), "facet-0-vertex-3", "an inner constraint outside the plane", inner=[(3, 4)])
    bent = m.square()
    bent.vertices[3] = (0, 1, Q(1, 2 ** 80))
    m.reject("complex-off-plane-boundary", bent, "complex", ("2 3", 1), "facet-0-vertex-3", "a corner a little outside the plane")
    collinear = m.planar([(0, 0), (2, 0), (4, 0), (2, 3)], [0, 2, 3])
    collinear.facets[0].update(corners=(0, 1, 2), isolated=[1])
    m.reject("complex-collinear", collinear, "complex", "f 0 1 2", "facet-0-collinear", "the f line names collinear vertices")
    clockwise = m.square(dim=2)
    clockwise.facets[0]["corners"] = (0, 2, 1)
    m.reject("complex-clockwise", clockwise, "complex", "f 0 2 1", "facet-0-clockwise", "clockwise in dimension 2")

    c = m.worked()
    c.vertices[4] = c.vertices[3]
    m.reject("distinct-vertices", c, "distinct", ("v 1 1 5 1", 2), "point-4-point-3", "two vertices coincide")
    c = m.worked()
    c.points.append(("interior 0", (1, 1, 0)))
    m.reject("distinct-points", c, "distinct", ("q interior 0 1 1 0 1", 2), "point-7-point-5", "two points coincide")
    c = m.worked()
    c.points[1] = ("edge 3", (1, 1, 5))
    m.reject("distinct-vertex-point", c, "distinct", "q edge 3 1 1 5 1", "point-6-point-3", "a point coincides with a vertex")

    for name, point, reason in [("off-line", (1, Q(5, 4), 7), "a point beside its segment"), ("beyond", (1, 1, 11), "a point beyond the end of its segment"),
                                ("before", (1, 1, 4), "a point before the start of its segment")]:
        c = m.worked()
        c.points[1] = ("edge 3", point)
        m.reject("carrier-" + name, c, "carrier", "q edge 3 " + m.homogeneous(point), "point-6-segment-3", reason)
    c = m.worked()
    c.points[0] = ("arc 0", (1, 1, Q(1, 2 ** 70)))
    m.reject("carrier-off-plane", c, "carrier", "q arc 0 " + m.homogeneous(c.points[0][1]), "point-5-facet-0", "a point a little outside its facet's plane")
    c = m.worked()
    c.points.append(("offset 0", (1, 2, 0)))
    m.reject("carrier-in-no-cell", c, "carrier", "q offset 0 1 2 0 1", "point-7-in-no-cell", "a point of a facet that is a corner of no cell")

    for name, old, new, thing, reason in [
            ("foreign-vertex", "t 0 0 1 5 C", "t 0 3 1 5 C", "cell-0-point-3", "a corner that is no vertex of the facet"),
            ("foreign-point", "t 0 0 1 5 C", "t 0 0 1 6 C", "cell-0-point-6", "a corner carried by a segment of no facet"),
            ("clockwise", "t 0 0 1 5 C", "t 0 1 0 5 C", "cell-0-clockwise", "a clockwise cell"),
            ("twice-a-corner", "t 0 0 1 5 C", "t 0 0 1 1 C", "cell-0-collinear", "a cell with a corner twice")]:
        m.reject("cell-" + name, m.edited(m.worked(), old, new), "cell", new, thing, reason)
    c = m.folded()
    c.points.append(("interior 1", (2, 0, 1)))
    c.cells += ["0 0 1 5 C", "1 0 1 5 C"]
    m.reject("cell-foreign-facet", c, "cell", "t 0 0 1 5 C", "cell-4-point-5", "a corner carried by another facet")
    c = slit_with_point(m)
    c.cells.append("0 4 6 5 C")
    m.reject("cell-collinear", c, "cell", "t 0 4 6 5 C", "cell-%d-collinear" % (len(c.cells) - 1), "a cell with collinear corners")

    c = m.folded()
    c.cells = ["0 0 4 2 R 0", "1 4 1 3 R 0"] + [c.cells[1], c.cells[2]]
    m.reject("box-two-facets", c, "box", "t 0 0 4 2 R 0", "box-0-two-facets", "a box in two facets")
    c = m.cube()
    c.cells[0], c.cells[1] = "0 0 2 3 R 0", "0 0 2 3 R 0"
    m.reject("box-one-triangle", c, "box", ("t 0 0 2 3 R 0", 1), "box-0-no-common-edge", "both halves of a box are the same triangle")
    c = m.with_slit()
    c.cells = [cell[:-1] + "R 0" for cell in c.cells[:2]] + c.cells[2:]
    first = "t " + c.cells[0]
    shared = len(set(c.cells[0].split()[1:4]) & set(c.cells[1].split()[1:4]))
    m.reject("box-no-parallelogram", c, "box", first, "box-0-no-parallelogram" if shared == 2 else "box-0-no-common-edge", "a box that is no parallelogram")
    rhombus = m.planar([(0, 0), (5, 0), (8, 4), (3, 4)], [0, 1, 2, 3])
    rhombus.cells = [cell[:-1] + "R 0" for cell in rhombus.cells]
    m.reject("box-rhombus", rhombus, "box", "t " + rhombus.cells[0], "box-0-no-right-angle", "a box that is a rhombus")

    m.reject("tiling-overlap", m.edited(m.worked(), "cells 3", ["cells 4", "t 0 0 1 2 C"]).replace("end 5 4 1 2 3", "end 5 4 1 2 4"), "tiling",
             "t 0 0 1 5 C", "cell-1-edge-0-1-twice", "a cell that covers the others")
    c = m.cube()
    c.cells.append("0 0 2 3 C")
    m.reject("tiling-twice", c, "tiling", ("t 0 0 2 3 C", 2), "cell-12-edge-0-2-twice", "a cell twice")
    c = m.worked()
    del c.cells[2]
    m.reject("tiling-missing-cell", c, "tiling", ("2 0", 1), "facet-0-edge-2-0", "a cell is missing: a boundary edge is not covered")
    c = m.with_slit()
    inner = [cell for cell in c.cells if not any({a, b} <= set(map(int, cell.split()[1:4])) for a, b in m.loop([0, 1, 2, 3]))]
    c.cells.remove(inner[0])
    broken = open_edge(c, [0, 1, 2, 3])
    m.reject("tiling-gap", c, "tiling", broken[0], broken[1], "a cell inside is missing: an inner edge is left over")
    c = m.with_hole()
    c.cells += ["0 4 5 6 C", "0 4 6 7 C"]
    m.reject("tiling-hole-filled", c, "tiling", ("4 7", 1), "facet-0-edge-4-7", "cells fill a hole")
    flipped = m.planar([(0, 0), (6, 0), (6, 2), (0, 2), (3, Q(1, 2)), (3, Q(3, 2))], [0, 1, 2, 3], inner=[(0, 2)])
    flipped.facets[0]["isolated"] = [4, 5]
    m.reject("tiling-constraint-crossed", flipped, "tiling", ("0 2", 1), "facet-0-constraint-0-2-edge-0-2", "an inner constraint that the cells cross")
    c = slit_with_point(m)
    coarse = m.with_slit()
    c.cells = coarse.cells
    m.reject("tiling-constraint-coarse", c, "tiling", ("4 5", 1), "facet-0-constraint-4-5-edge-4-6", "the cells pass over a point carried by an inner constraint")
    c = m.planar(m.SLIT[:4], [0, 1, 2, 3])
    c.vertices.append((2, 2, 0))
    c.facets[0]["isolated"] = [4]
    m.reject("tiling-isolated", c, "tiling", "4", "facet-0-vertex-4-in-no-cell", "an isolated vertex that is a corner of no cell")
    c = m.worked()
    c.points, c.cells, c.hanging = [("edge 3", (1, 1, 7))], [], [(3, 3, 5), (3, 5, 4)]
    m.reject("tiling-no-cell", c, "tiling", "f 0 1 2", "facet-0-no-cell", "a facet without cells")


def open_edge(c, ring):
    """The first cell, in order, with an edge that is left over and not on the boundary."""
    triangles = [tuple(map(int, cell.split()[1:4])) for cell in c.cells]
    edges = {(t[i], t[(i + 1) % 3]) for t in triangles for i in range(3)}
    boundary = set(zip(ring, ring[1:] + ring[:1]))
    for number, t in enumerate(triangles):
        left = [e for e in sorted((min(a, b), max(a, b), a, b) for a, b in zip(t, t[1:] + t[:1]))
                if (e[3], e[2]) not in edges and (e[2], e[3]) not in boundary]
        if left:
            return "t " + c.cells[number], "cell-%d-edge-%d-%d-open" % (number, left[0][2], left[0][3])
    raise SystemExit("no open edge")


def write_rejected_geometry(m):
    c = m.planar([(0, 0), (4, 0), (0, 4)], [0, 1, 2], extra=[(1, 1, 1)])
    m.reject("emptiness-off-plane-in", c, "emptiness", "t 0 0 1 2 C", "cell-0-point-3", "a point strictly in the sphere")
    c = m.planar([(0, 0), (4, 0), (0, 4)], [0, 1, 2], extra=[(1, 1, 1)])
    c.cells = ["0 0 1 2 C 1/4"]
    m.reject("emptiness-offset-wrong-side", c, "emptiness", "t 0 0 1 2 C 1/4", "cell-0-point-3", "an offset to the wrong side")
    c.cells = ["0 0 1 2 C -5/20"]
    m.reject("emptiness-offset-on", c, "emptiness", "t 0 0 1 2 C -5/20", "cell-0-point-3", "an offset that leaves the point exactly on the sphere")
    c = m.planar([(0, 0), (4, 0), (0, 4)], [0, 1, 2], extra=[(4, 4, 0)])
    c.vertices[3] = (2, 4, 2)
    m.reject("emptiness-off-plane-on", c, "emptiness", "t 0 0 1 2 C", "cell-0-point-3", "a point off the plane exactly on the sphere")
    c.vertices[3] = (2, 4, 2 + Q(1, 2 ** 90))
    m.accept("off-plane-just-outside", c, "a point off the plane by 2^-90 outside the sphere")
    c.vertices[3] = (2, 4, 2 - Q(1, 2 ** 90))
    m.reject("emptiness-off-plane-just-in", c, "emptiness", "t 0 0 1 2 C", "cell-0-point-3", "a point off the plane by 2^-90 in the sphere")
    flat = m.planar([(0, 0), (4, -1), (8, 0), (4, 1)], [0, 1, 2, 3])
    flat.cells = ["0 0 1 2 C", "0 0 2 3 C"]
    m.reject("emptiness-in-plane", flat, "emptiness", "t 0 0 1 2 C", "cell-0-point-3", "the wrong diagonal")
    c = m.folded()
    c.cells = ["0 0 1 2 C", "1 0 1 3 C"]
    m.reject("emptiness-point-passed-over", c, "emptiness", "t 0 0 1 2 C", "cell-0-point-4", "the cells pass over a point carried by the boundary")
    c = nearly_degenerate(m)
    c.vertices.append((1, -1, 0))
    m.accept("huge-sphere-other-side", c, "a point on the other side of a circle that is far larger than the domain")
    c.vertices[-1] = (1, 1, 0)
    m.reject("emptiness-huge-sphere", c, "emptiness", "t 0 0 1 2 C", "cell-0-point-6", "a point in a circle that is far larger than the domain")
    c = m.circle(2)
    c.vertices = [p if i != 7 else (p[0] * (1 - Q(1, 10 ** 40)), p[1] * (1 - Q(1, 10 ** 40))) for i, p in enumerate(c.vertices)]
    m.reject("emptiness-dim2-circle", c, "emptiness", "t 0 0 1 2 C", "cell-0-point-7", "a point by 10^-40 in a circle, denominators without a common multiple of use")

    c = m.two_triangles()
    m.reject("tie-two-facets", c, "tie", "t 0 0 1 2 C", "cell-0-point-3", "the common edge of two coplanar facets: the other diagonal ties")
    m.reject("tie-coplanar", m.two_triangles(apexes=False), "tie", "t 0 0 1 2 C", "cell-0-point-3", "the same with all points in one plane")
    c = m.square(inner=[(0, 2)], extra=[(Q(1, 2), Q(1, 2), 2), (Q(1, 2), Q(1, 2), -2)])
    m.reject("tie-inner", c, "tie", "t 0 0 1 2 C", "cell-0-point-3", "the diagonal of a square as an inner constraint")
    m.reject("tie-dim2", m.square(dim=2, inner=[(0, 2)]), "tie", "t 0 0 1 2 C", "cell-0-point-3", "the same in dimension 2")
    outside = m.Certificate(3, m.lift([(-3, -4), (3, -4), (0, 5), (0, -5)]), m.undirected(m.loop([0, 1, 2])),
                            [dict(corners=(0, 1, 2), boundary=m.loop([0, 1, 2]))], cells=["0 0 1 2 C"])
    m.reject("tie-outside-facet", outside, "tie", "t 0 0 1 2 C", "cell-0-point-3", "a point on the circle behind a boundary edge, of no facet")

    c = m.worked()
    c.hanging = [(3, 3, 4)]
    c.points = c.points[:1]
    c.vertices.append((Q(3, 2), 1, 7))
    c.cells = [cell.replace("5", "6") for cell in c.cells]
    m.reject("hanging-in-ball", c, "hanging", "h 3 3 4", "subsegment-0-point-5", "a vertex in the ball of a hanging edge")
    c.vertices[5] = (3, 1, 7)
    m.reject("hanging-on-ball", c, "hanging", "h 3 3 4", "subsegment-0-point-5", "a vertex exactly on the ball of a hanging edge")
    c.vertices[5] = (3 + Q(1, 2 ** 70), 1, 7)
    m.accept("hanging-just-outside", c, "a vertex by 2^-70 outside the ball of a hanging edge")
    c = m.planar([(-1, -1), (1, -1), (1, 1), (-1, 1), (0, 0)], [0, 1, 2, 3], isolated=[4], segments=[(5, 6)],
                 extra=[(Q(-6, 5), 0, Q(11, 10)), (Q(6, 5), 0, Q(11, 10))])
    c.hanging = [(4, 5, 6)]
    m.reject("hanging-over-facet", c, "hanging", "h 4 5 6", "subsegment-0-point-4", "a hanging edge too close over a point of a facet")
    for name, parts, line, thing, reason in [
            ("missing", [], "s 3 4", "segment-3-not-covered", "a hanging segment without subsegments"),
            ("incomplete", [(3, 3, 6)], "h 3 3 6", "segment-3-not-covered", "the last subsegment is missing"),
            ("start", [(3, 6, 4)], "h 3 6 4", "subsegment-0-point-6-not-next", "the first subsegment is missing"),
            ("gap", [(3, 3, 6), (3, 3, 4)], "h 3 3 4", "subsegment-1-point-3-not-next", "a subsegment does not begin where the one before ends"),
            ("back", [(3, 3, 6), (3, 6, 3), (3, 3, 4)], "h 3 6 3", "subsegment-1-point-3-not-forward", "a subsegment that goes back"),
            ("foreign", [(3, 3, 5), (3, 5, 4)], "h 3 3 5", "subsegment-0-point-5-not-on-segment", "a subsegment that leaves the segment"),
            ("passes-over", [(3, 3, 4)], "h 3 3 4", "subsegment-0-point-6", "a subsegment that passes over a point"),
            ("not-hanging", [(0, 0, 1), (3, 3, 6), (3, 6, 4)], "h 0 0 1", "subsegment-0-segment-0-not-hanging", "a segment that belongs to a facet")]:
        c = m.worked()
        c.hanging = parts
        m.reject("hanging-" + name, c, "hanging", line, thing, reason)


def write_rejected_rows(m):
    def case(name, rows, line, thing, reason, change=None):
        c = m.rows_and_boxes()
        c.rows = rows
        if change:
            change(c)
        m.reject("rows-" + name, c, "rows", line, thing, reason)

    own, protector = ("0 3", [4, 5, 6]), ("0 3 0 +", [7, 8, 9])
    case("order", [("0 3", [4, 6, 5])], ("6", 1), "row-0-point-6", "points of a row out of order")
    case("too-few", [("0 2", [4, 5])], "r 0 2", "row-0-count", "a row that misses a point")
    case("too-many", [("0 4", [4, 5, 6, 1])], "r 0 4", "row-0-count", "a row that names the segment's vertex too")
    case("foreign", [("0 3", [4, 7, 6])], ("7", 1), "row-0-point-7", "a row with a point that the segment does not carry")
    case("protector-alone", [protector], "r 0 3 0 +", "row-0-without-segment-row", "a protector without the row of its segment")
    case("protector-count", [own, ("0 2 0 +", [7, 8])], "r 0 2 0 +", "row-1-count", "a protector with fewer points than its row")
    case("protector-side", [own, ("0 3 0 -", [7, 8, 9])], "r 0 3 0 -", "row-1-side", "a protector on the side where the facet is not")
    case("protector-kind", [own, protector], "7", "row-1-point-7-kind", "a protector that is not of kind offset",
         lambda c: c.points.__setitem__(3, ("interior 0", (2, 1, 0))))
    case("protector-vertex", [own, ("0 3 0 +", [2, 8, 9])], ("2", 1), "row-1-point-2-kind", "a protector that is a vertex")
    case("protector-vector", [own, ("0 3 0 +", [7, 9, 8])], ("9", 1), "row-1-point-9-vector", "protectors with different vectors")
    case("protector-slanted", [("0 3", [4, 5, 6]), ("0 3 0 +", [8, 9, 7])], ("8", 1), "row-1-point-8-not-orthogonal", "protectors that are not opposite to their points")

    c = m.rows_and_boxes()
    c.rows = [own, ("0 3 0 +", [7, 8, 9]), ("1 2", [4, 5])]
    m.reject("rows-empty-segment", c, "rows", "r 1 2", "row-2-count", "a row of a segment that carries no points")
    c = rows_inner(m)
    number = c.rows[0][0].split()[0]
    c.rows[1], c.rows[2] = ("%s 2 0 +" % number, [10, 11]), ("%s 2 0 -" % number, [8, 9])
    m.reject("rows-protector-other-side", c, "rows", "10", "row-1-point-10-side", "protectors on the other side than stated")
    c = m.folded()
    c.vertices += [(0, 9, 9), (4, 9, 9), (9, 20, 9)]
    ring = [4, 5, 6]
    c.segments = m.undirected(c.segments + m.loop(ring))
    c.facets.append(dict(corners=ring, boundary=m.loop(ring)))
    c.points = [("edge 0", (1, 0, 0)), ("edge 0", (3, 0, 0)), ("offset 0", (2, Q(3, 2), 0))]
    c.cells = ["0 0 7 9 C", "0 7 8 9 C", "0 8 1 9 C", "0 1 2 9 C", "0 2 0 9 C", "1 0 7 3 C", "1 7 8 3 C", "1 8 1 3 C", "2 4 5 6 C"]
    c.rows = [("0 2", [7, 8]), ("0 2 2 +", [9, 9])]
    m.reject("rows-foreign-facet", c, "rows", "r 0 2 2 +", "row-1-segment-0-not-in-facet", "a protector in a facet that the segment does not bound")
    c.rows = [("0 2", [7, 8]), ("0 2 1 +", [9, 9])]
    m.reject("rows-protector-carrier", c, "rows", "9", "row-1-point-9-carrier", "a protector carried by another facet")


def write_declined(m):
    text = m.worked().text()
    m.decline("newer", text.replace("confidel-certificate 1", "confidel-certificate 2"), "newer-version", "version 2")
    m.decline("much-newer", "confidel-certificate 99999999999999999999\nwhatever\n", "newer-version", "a version beyond all numbers, and other text")
    m.decline("count", text.replace("vertices 5", "vertices 2147483648"), "too-large", "a count of 2^31")
    m.decline("index", text.replace("s 0 1", "s 0 99999999999999999999999"), "too-large", "an index beyond all numbers")
    m.decline("digits", text.replace("v 4 0 0 1", "v 1%s 0 0 1" % ("0" * 65536)), "too-large", "an integer of 65537 digits")
    head = "\n".join(m.worked().lines()[:27]) + "\nn long "
    blocks = [(0, len(head), head.encode())] + [(1, 131072, b"x")] * 9 + [(0, 1, b"\n")]
    m.decline("line", m.zstd_frame(blocks, content_size=len(head) + 9 * 131072 + 1), "too-large", "a line of more than 1048576 bytes, in a zstd frame")
    bomb = [(0, len(head), head.encode())] + [(1, 131072, b"x")] * 8000
    m.decline("bomb", m.zstd_frame(bomb, content_size=len(head) + 8000 * 131072), "too-large", "a zstd frame of 32 kB that is a line of 1 GB")
    m.decline("window", m.zstd_frame([(0, len(text), text.encode())], window=(18 << 3)), "too-large", "a zstd frame with a window of 256 MiB")
