#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""mesh_test.py BINARIES: meshes written by `conform --mesh`, read by this script and judged in rationals: Delaunay, filling what they should, with markers."""
import json
import os
import sys
import tempfile
from fractions import Fraction

from harness import EXAMPLES, Programs, content


def rows(path):
    lines = [line.split() for line in open(path) if line.strip()]
    return lines[0], lines[1:]


def read_node(base):
    """Points, tetrahedra, their attributes, faces, edges; the latter with markers."""
    number = lambda text: Fraction(text) if "/" in text else Fraction(float(text))
    points = [tuple(map(number, row[1:])) for row in rows(base + ".node")[1]]
    first = int(rows(base + ".node")[1][0][0])
    corners = lambda row, count: tuple(int(field) - first for field in row[1:1 + count])
    header, elements = rows(base + ".ele")
    count = int(header[1])
    faces = [(corners(row, 3), int(row[4])) for row in rows(base + ".face")[1]] if os.path.exists(base + ".face") else []
    edges = [(corners(row, 2), int(row[3])) for row in rows(base + ".edge")[1]]
    return points, [corners(row, count) for row in elements], [row[1 + count:] for row in elements], faces, edges


def minus(a, b):
    return tuple(x - y for x, y in zip(a, b))


def determinant(matrix):
    if len(matrix) == 1:
        return matrix[0][0]
    return sum((-1) ** i * row[0] * determinant([other[1:] for j, other in enumerate(matrix) if j != i]) for i, row in enumerate(matrix) if row[0] != 0)


def volume(points, tetrahedron):
    a, *others = (points[i] for i in tetrahedron)
    return determinant([minus(p, a) for p in others]) / 6


def is_delaunay(points, tetrahedra):
    """No point strictly inside of a circumscribed sphere, by its definition."""
    for t in tetrahedra:
        a, *others = (points[i] for i in t)
        lifted = [minus(p, a) for p in others]
        sign = 1 if determinant(lifted) > 0 else -1
        for i, x in enumerate(points):
            if i not in t:
                d = [list(v) + [sum(c * c for c in v)] for v in lifted + [minus(x, a)]]
                if determinant(d) * sign < 0:
                    return False
    return True


def area_vectors(points, faces, marker):
    return sum((abs(c) for c in [sum(cross_component(points, f, k) for f, m in faces if m == marker) for k in range(3)]), Fraction(0))


def cross_component(points, face, k):
    a, b, c = (points[i] for i in face)
    u, w = minus(b, a), minus(c, a)
    i, j = (k + 1) % 3, (k + 2) % 3
    return abs(u[i] * w[j] - u[j] * w[i])


BOXES = """# A cube of edge 4 with markers, a hollow cube of edge 1 in it, two regions separated by a square.
20 3 0 0
%s
13 1
%s
1
1 0.5 0.5 0.5
2
1 3.5 3.5 1 7 -1
2 3.5 3.5 3 8 -1
"""


def boxes():
    """Points 1-8 the outer cube, 9-16 the inner one (0.25 to 1.25), 17-20 the square at height 2 between the outer walls."""
    cube = lambda low, high: [(x, y, z) for z in (low, high) for x, y in ((low, low), (high, low), (high, high), (low, high))]
    points = cube(0, 4) + cube(0.25, 1.25) + [(0, 0, 2), (4, 0, 2), (4, 4, 2), (0, 4, 2)]
    squares = [(1, 2, 3, 4), (5, 6, 7, 8)]
    inner = [(9, 10, 11, 12), (13, 14, 15, 16), (9, 10, 14, 13), (10, 11, 15, 14), (11, 12, 16, 15), (12, 9, 13, 16)]
    # The outer walls, each with the middle square's edge in it.
    walls = [((1, 2, 18, 6, 5, 17), 17, 18), ((2, 3, 19, 7, 6, 18), 18, 19), ((3, 4, 20, 8, 7, 19), 19, 20), ((4, 1, 17, 5, 8, 20), 20, 17)]
    facets = ["1 0 %d\n4 %d %d %d %d\n" % ((11 + i,) + square) for i, square in enumerate(squares)]
    facets += ["1 0 30\n4 %d %d %d %d\n" % square for square in inner]
    facets += ["2 0 20\n6 %s\n2 %d %d\n" % (" ".join(map(str, loop)), a, b) for loop, a, b in walls]
    facets += ["1 0 40\n4 17 18 19 20\n"]
    return BOXES % ("\n".join("%d %r %r %r" % ((i + 1,) + p) for i, p in enumerate(points)), "".join(facets).rstrip("\n"))


def check_regions(programs, folder):
    path, mesh = os.path.join(folder, "boxes.poly"), os.path.join(folder, "out.node")
    with open(path, "w") as file:
        file.write(boxes())
    for keep, wanted in (("hull", Fraction(64)), ("regions", Fraction(63))):
        report = programs.expect_verified("boxes", path, os.path.join(folder, "b.cert"), "--mesh", mesh, "--keep", keep, "--exact-text")
        if report is None:
            return
        points, tetrahedra, attributes, faces, edges = read_node(mesh[:-5])
        total = sum(volume(points, t) for t in tetrahedra)
        programs.expect(total == wanted and min(volume(points, t) for t in tetrahedra) > 0, "%s: volume %s" % (keep, total))
        programs.expect(is_delaunay(points, tetrahedra), keep + ": not Delaunay")
        of_region = lambda name: sum(volume(points, t) for t, a in zip(tetrahedra, attributes) if float(a[0]) == name)
        programs.expect((of_region(7), of_region(8), of_region(0)) == (31, 32, wanted - 63), "%s: regions %s %s %s" % (keep, of_region(7), of_region(8), of_region(0)))
        for marker, doubled in ((11, 32), (12, 32), (20, 128), (30, 12), (40, 32)):
            programs.expect(area_vectors(points, faces, marker) == doubled, "%s: faces of marker %d do not cover their facets" % (keep, marker))
        length = sum(sum(abs(c) for c in minus(points[a], points[b])) for (a, b), _ in edges)
        programs.expect(length == 12 * 4 + 12 + 16, "%s: edges of length %s" % (keep, length))
        sides = {tuple(sorted(t[:i] + t[i + 1:])) for t in tetrahedra for i in range(4)}
        if keep == "hull":
            programs.expect(all(tuple(sorted(f)) in sides for f, _ in faces), "faces that are no sides of tetrahedra")
    # A hole's point on a facet means nothing.
    with open(path, "w") as file:
        file.write(boxes().replace("1 0.5 0.5 0.5", "1 0.5 0.5 0.25"))
    code, _, err = programs.run("conform", path, "-o", os.path.join(folder, "b.cert"), "--mesh", mesh, "--keep", "regions")
    programs.expect(code == 2 and "E-HOLE" in err, "a hole's point on a facet: %d %r" % (code, err))


def check_exact(programs, folder):
    """Steiner points that are no doubles: the rational mesh is Delaunay, the rounded one is audited, and both say the same as the report."""
    path, mesh = os.path.join(EXAMPLES, "fan-skew.off"), os.path.join(folder, "w.node")
    report = programs.expect_verified("fan-skew", path, os.path.join(folder, "w.cert"), "--mesh", mesh, "--exact-text", "--strategy", "graded")
    points, tetrahedra, _, faces, _ = read_node(mesh[:-5])
    programs.expect(is_delaunay(points, tetrahedra[:60]), "fan-skew: not Delaunay")
    programs.expect(report["mesh"]["rounded"]["moved_points"] > 10, "all points are doubles: choose another example")
    moved = [p for p in points if any(Fraction(float(c)) != c for c in p)]
    programs.expect(len(moved) == report["mesh"]["rounded"]["moved_points"], "points that move: %d, %s" % (len(moved), report["mesh"]))
    far = max([sum((Fraction(float(c)) - c) ** 2 for c in p) for p in points] + [Fraction(0)])
    programs.expect(abs(report["mesh"]["rounded"]["greatest_move"] - float(far) ** 0.5) <= 1e-9 * float(far) ** 0.5, "greatest move")
    report = programs.expect_verified("fan-skew", path, os.path.join(folder, "w.cert"), "--mesh", mesh, "--strategy", "graded")
    code, text, _ = programs.run("audit", path, mesh, "--json")
    audit = json.loads(text)
    programs.expect(audit["conforms"] == report["mesh"]["rounded"]["conforms"], "the audit of what was written says something else than the report")
    programs.expect(sum(f["standing"] == "holds" for f in audit["facets"]) == report["mesh"]["rounded"]["facets_that_hold"], "facets that hold")
    rounded = read_node(mesh[:-5])[0]
    programs.expect(rounded == [tuple(Fraction(float(c)) for c in p) for p in points], "the doubles are not the nearest ones")


def check_formats(programs, folder):
    path = os.path.join(EXAMPLES, "cube.off")
    counts = set()
    for suffix in (".vtu", ".node", ".mesh"):
        mesh = os.path.join(folder, "cube" + suffix)
        programs.expect_verified(suffix, path, os.path.join(folder, "c.cert"), "--mesh", mesh)
        first = content(mesh)
        programs.expect_verified(suffix, path, os.path.join(folder, "c.cert"), "--mesh", mesh, "-j", 1)
        programs.expect(content(mesh) == first, suffix + ": other bytes with one thread")
        code, text, err = programs.run("audit", path, mesh, "--json")
        if programs.expect(code == 0, "%s is not read again: %s" % (suffix, err)):
            report = json.loads(text)
            counts.add((report["points"], report["tetrahedra"], report["faces"]))
        try:
            import meshio
        except ImportError:
            continue
        if suffix != ".node" or hasattr(meshio, "tetgen"):
            read = meshio.read(mesh)
            cells = {block.type: len(block.data) for block in read.cells}
            programs.expect(len(read.points) == 8 and cells.get("tetra", 0) >= 5, "%s: meshio reads %s" % (suffix, cells))
    programs.expect(len(counts) == 1, "formats differ: %s" % counts)
    off = os.path.join(folder, "surface.off")
    programs.expect_verified("off", path, os.path.join(folder, "c.cert"), "--mesh", off)
    programs.expect(programs.run("info", off)[0] == 0, "the surface is no complex")
    for arguments in (("--mesh", os.path.join(folder, "x.stl")), ("--mesh", os.path.join(folder, "x.vtu"), "--exact-text")):
        code, text, err = programs.run("conform", path, "-o", os.path.join(folder, "never.cert"), *arguments)
        programs.expect(code == 2 and "E-FORMAT" in err and not os.path.exists(os.path.join(folder, "never.cert")), "%s: %d %r" % (arguments, code, err))


def check_planar(programs, folder):
    path, mesh = os.path.join(folder, "p.poly"), os.path.join(folder, "p.node")
    with open(path, "w") as file:
        # A square with a notch in its upper side, and a hole: the domain is what the segments enclose, whatever is kept.
        file.write("9 2 0 0\n1 0 0\n2 4 0\n3 4 4\n4 2 3\n5 0 4\n6 1 1\n7 2 1\n8 2 2\n9 1 2\n9 1\n" + "".join(
            "%d %d %d %d\n" % (i + 1, a, b, 5) for i, (a, b) in enumerate(((1, 2), (2, 3), (3, 4), (4, 5), (5, 1), (6, 7), (7, 8), (8, 9), (9, 6)))) +
            "1\n1 1.5 1.5\n1\n1 3 3 2 -1\n")
    for keep, wanted in (("hull", 13), ("regions", 13)):
        if programs.expect_verified("planar", path, os.path.join(folder, "p.cert"), "--mesh", mesh, "--keep", keep, "--exact-text") is None:
            return
        points, triangles, _, _, edges = read_node(mesh[:-5])
        area = sum(determinant([minus(points[b], points[a]), minus(points[c], points[a])]) for a, b, c in triangles) / 2
        programs.expect(area == wanted and {m for _, m in edges} == {5}, "planar, %s: area %s" % (keep, area))


def main():
    programs = Programs(sys.argv[1])
    for check in (check_regions, check_exact, check_formats, check_planar):
        with tempfile.TemporaryDirectory() as folder:
            check(programs, folder)
    programs.finish()


main()
