#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""audit_test.py BINARIES: the audit against definitions tried in rationals on small random meshes; formats; points off their planes; certificates."""
import base64
import json
import os
import random
import struct
import sys
import tempfile
from fractions import Fraction

from harness import EXAMPLES, Programs, content, last_line


def minus(a, b):
    return tuple(x - y for x, y in zip(a, b))


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def has_sphere(triangle, others):
    """Is there a sphere through the corners with nothing in it, and nothing on it off the plane? By its definition."""
    a, b, c = triangle
    u, w = minus(b, a), minus(c, a)
    n = cross(u, w)
    centre = tuple((dot(u, u) * x + dot(w, w) * y) / (2 * dot(n, n)) for x, y in zip(cross(w, n), cross(n, u)))
    low = high = None
    for x in others:
        d = minus(x, a)
        power, height = dot(d, d) - 2 * dot(d, centre), dot(n, d)
        if height == 0 and power < 0:
            return False
        if height > 0:
            high = power / (2 * height) if high is None else min(high, power / (2 * height))
        if height < 0:
            low = power / (2 * height) if low is None else max(low, power / (2 * height))
    return low is None or high is None or low < high


def write_off(path, points, faces):
    with open(path, "w") as file:
        file.write("OFF\n%d %d 0\n" % (len(points), len(faces)))
        file.write("".join("%r %r %r\n" % point for point in points) + "".join("%d %s\n" % (len(f), " ".join(map(str, f))) for f in faces))


def write_node(path, points, base=0):
    with open(path, "w") as file:
        file.write("%d 3 0 0\n" % len(points) + "".join("%d %r %r %r\n" % ((i + base,) + point) for i, point in enumerate(points)))


def check_random(programs, folder):
    """One triangle, and points around it: on a coarse grid, so that ties and coplanar points occur."""
    generator, answers = random.Random(3), {}
    plc, mesh = os.path.join(folder, "t.off"), os.path.join(folder, "t.node")
    for case in range(120):
        size = generator.choice((3, 5, 100))
        point = lambda: tuple(float(generator.randint(-size, size)) for _ in range(3))
        triangle = [point() for _ in range(3)]
        if cross(minus(triangle[1], triangle[0]), minus(triangle[2], triangle[0])) == (0, 0, 0):
            continue
        others = list({point() for _ in range(generator.randint(1, 5))} - set(triangle))
        exact = [tuple(map(Fraction, p)) for p in triangle + others]
        # Points on the triangle itself cut it; that is tested elsewhere.
        n = cross(minus(exact[1], exact[0]), minus(exact[2], exact[0]))
        inside = lambda x: dot(n, minus(x, exact[0])) == 0 and all(
            dot(n, cross(minus(exact[(i + 1) % 3], exact[i]), minus(x, exact[i]))) >= 0 for i in range(3))
        if any(inside(x) for x in exact[3:]):
            continue
        write_off(plc, triangle, [(0, 1, 2)])
        write_node(mesh, triangle + others)
        code, text, err = programs.run("audit", plc, mesh, "--json")
        expected = has_sphere(exact[:3], exact[3:])
        tie = any(dot(n, minus(x, exact[0])) == 0 for x in exact[3:])
        if not programs.expect(code in (0, 1), "case %d: exit %d: %s" % (case, code, err)):
            continue
        facet = json.loads(text)["facets"][0]
        # A tie beyond an edge, in the plane, is refused although a sphere is empty: then the witness is on the circle.
        good = (facet["standing"] == "holds") == expected or (expected and tie and facet["witness"]["relative_depth"] == 0)
        programs.expect(good and (code == 0) == (facet["standing"] == "holds"), "case %d: %s, but %s" % (case, facet, expected))
        if not expected:
            witness = facet["witness"]
            pair = [exact[i] for i in witness["points"]]
            programs.expect(not has_sphere(exact[:3], pair), "case %d: the witness %s proves nothing" % (case, witness))
        answers[(expected, facet["standing"])] = answers.get((expected, facet["standing"]), 0) + 1
    programs.expect(answers.get((True, "holds"), 0) > 20 and answers.get((False, "fails"), 0) > 20, "one-sided cases: %s" % answers)


def check_depth(programs, folder):
    """A point on the axis of a triangle's smallest sphere, ever less deep: the depth that is said is the depth."""
    plc, mesh = os.path.join(folder, "t.off"), os.path.join(folder, "t.node")
    corners = [(3.0, 4.0, 0.0), (-5.0, 0.0, 0.0), (3.0, -4.0, 0.0)]
    write_off(plc, corners, [(0, 1, 2)])
    for height in (4.0, 1.0, 2.0 ** -30, 2.0 ** -100):
        write_node(mesh, corners + [(0.0, 0.0, height), (0.0, 0.0, -height)])
        code, text, _ = programs.run("audit", plc, mesh, "--json")
        depth = json.loads(text)["facets"][0]["witness"]["relative_depth"]
        expected = float(1 - Fraction(height) ** 2 / 25)  # equally deep: the smallest sphere, radius 5
        programs.expect(code == 1 and abs(depth - expected) <= 1e-12 * expected, "depth %r where %r is right" % (depth, expected))
    # Just inside, and exactly on, the sphere of radius 5: a depth of about 2^-50, and a tie.
    for bump, expected in ((2.0 ** -50, 2 * 2.0 ** -50 / 5), (0.0, 0.0)):
        write_node(mesh, corners + [(0.0, 0.0, 5.0 - bump), (0.0, 0.0, -5.0)])
        code, text, _ = programs.run("audit", plc, mesh, "--json")
        depth = json.loads(text)["facets"][0]["witness"]["relative_depth"]
        programs.expect(code == 1 and abs(depth - expected / 2) <= 0.01 * expected, "depth %r, about %r expected" % (depth, expected / 2))


def check_off_plane(programs, folder):
    """A point meant to lie on a slanted facet, rounded beside it: the facet is no union of Delaunay triangles any more, by very little."""
    plc, mesh = os.path.join(folder, "s.off"), os.path.join(folder, "s.node")
    corners = [(0.0, 0.0, 0.0), (3.0, 0.0, 1.0), (0.0, 3.0, 1.0), (1.0, 1.0, 6.0)]
    write_off(plc, corners, [(0, 1, 2), (0, 1, 3)])
    beside = (1.0, 1.0, 2 / 3)  # the plane is x + y = 3 z
    write_node(mesh, corners + [beside], base=1)
    code, text, _ = programs.run("audit", plc, mesh, "--json")
    report = json.loads(text)
    distance = float(abs(Fraction(beside[2]) - Fraction(2, 3)) * 3) / 11 ** 0.5
    programs.expect(code == 1 and len(report["off"]) == 1 and report["off"][0]["point"] == 5, "off the plane: %s" % report["off"])
    programs.expect(abs(report["greatest_distance"] - distance) < 1e-3 * distance, "distance %r, right is %r" % (report["greatest_distance"], distance))
    programs.expect(report["facets"][0]["standing"] == "fails" and report["facets"][1]["standing"] == "holds", "standing of the facets")
    programs.expect(report["certificate"]["verdict"] == "s VERIFIED" and report["certificate"]["about"] == "the parts that hold", "certificate of the rest")
    on = (1.0, 1.0, 0.5)
    plc2 = os.path.join(folder, "s2.off")
    write_off(plc2, [(0.0, 0.0, 0.0), (4.0, 0.0, 1.0), (0.0, 4.0, 1.0), (1.0, 1.0, -4.0)], [(0, 1, 2), (0, 1, 3)])
    write_node(mesh, [(0.0, 0.0, 0.0), (4.0, 0.0, 1.0), (0.0, 4.0, 1.0), (1.0, 1.0, -4.0), on])
    certificate = os.path.join(folder, "s2.cert")
    code, text, _ = programs.run("audit", plc2, mesh, "-o", certificate, "--json")
    report = json.loads(text)
    programs.expect(code == 0 and report["off"] == [] and report["facets"][0]["pieces"] == 3 and report["certificate"]["about"] == "the input", "on the plane: %s" % report)
    programs.expect(programs.run("canonical", plc2, "-o", certificate + ".plc", "--merge-coplanar", "auto")[0] == 0, "canonical")
    code, text, _ = programs.run(certificate, "--complex", certificate + ".plc", program=programs.checker)
    programs.expect(code == 0 and last_line(text) == "s VERIFIED", "the certificate of a mesh that conforms: %r" % text)
    write_node(mesh, corners[:3])
    code, text, _ = programs.run("audit", plc, mesh, "--json")
    programs.expect(code == 1 and json.loads(text)["facets"][1]["missing_vertices"] == [3], "a missing vertex")


def vtu(points, tetrahedra, binary):
    def array(kind, name, values, code, extra=""):
        flat = [value for row in values for value in row]
        if binary:
            data = struct.pack("<%d%s" % (len(flat), code), *flat)
            text = base64.b64encode(struct.pack("<Q", len(data)) + data).decode()
        else:
            text = " ".join(map(repr, flat))
        return '<DataArray type="%s" Name="%s" %s format="%s">%s</DataArray>' % (kind, name, extra, "binary" if binary else "ascii", text)
    return ('<?xml version="1.0"?><VTKFile type="UnstructuredGrid" version="1.0" byte_order="LittleEndian" header_type="UInt64"><UnstructuredGrid>'
            '<Piece NumberOfPoints="%d" NumberOfCells="%d"><Points>%s</Points><Cells>%s%s%s</Cells></Piece></UnstructuredGrid></VTKFile>' % (
                len(points), len(tetrahedra), array("Float64", "Points", points, "d", 'NumberOfComponents="3"'), array("Int64", "connectivity", tetrahedra, "q"),
                array("Int64", "offsets", [(4 * (i + 1),) for i in range(len(tetrahedra))], "q"), array("UInt8", "types", [(10,)] * len(tetrahedra), "B")))


def check_formats(programs, folder):
    """The same mesh in every format is judged the same; damaged files are errors with a place."""
    plc = os.path.join(EXAMPLES, "cube.off")
    points = [(0.0, 0.0, 0.0), (1.0, 0.0, 0.0), (1.0, 1.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0), (1.0, 0.0, 1.0), (1.0, 1.0, 1.0), (0.0, 1.0, 1.0), (0.3, 0.5, 0.5)]
    tetrahedra = [(0, 1, 2, 8), (0, 2, 3, 8), (4, 5, 6, 8), (4, 6, 7, 8)]
    text = {"ascii.vtu": vtu(points, tetrahedra, False), "binary.vtu": vtu(points, tetrahedra, True)}
    rows = lambda base: "".join("%d %s\n" % (i + base, " ".join(str(c + base) for c in t)) for i, t in enumerate(tetrahedra))
    for base in (0, 1):
        text["base%d.node" % base] = "# points\n9 3 0 0\n" + "".join("%d %r %r %r\n" % ((i + base,) + p) for i, p in enumerate(points))
        text["base%d.ele" % base] = "4 4 0\n" + rows(base) + "# Generated by tetgen\n"
    text["m.mesh"] = "MeshVersionFormatted 1\n\nDimension\n3\n\nVertices\n9\n" + "".join("%r %r %r 0\n" % p for p in points) + "Triangles\n0\nTetrahedra\n4\n" + "".join(
        "%d %d %d %d 0\n" % tuple(c + 1 for c in t) for t in tetrahedra) + "End\n"
    for name, body in text.items():
        with open(os.path.join(folder, name), "w") as file:
            file.write(body)
    seen = set()
    for name in ("ascii.vtu", "binary.vtu", "base0.node", "base0", "base1.ele", "m.mesh"):
        code, out, err = programs.run("audit", plc, os.path.join(folder, name), "--json")
        if programs.expect(code == 0, "%s: exit %d %s" % (name, code, err)):
            report = json.loads(out)
            seen.add((report["points"], report["tetrahedra"], report["inner_points"], tuple(f["subfaces"] for f in report["facets"])))
    programs.expect(seen == {(9, 4, 1, (2, 2, 0, 0, 0, 0))}, "formats differ: %s" % seen)
    bad = {"short.node": text["base0.node"][:-12], "corner.vtu": text["ascii.vtu"].replace("0 1 2 8", "0 1 2 9"), "cut.vtu": text["binary.vtu"][:-60],
           "appended.vtu": text["binary.vtu"].replace('format="binary"', 'format="appended"'), "wedge.vtu": text["ascii.vtu"].replace("10 10", "10 13"),
           "base64.vtu": text["binary.vtu"].replace('format="binary">', 'format="binary">!!!!'), "row.mesh": text["m.mesh"].replace("0 0.0 0.0 0\n", "0 0.0 0\n", 1),
           "empty.vtu": "", "nan.vtu": text["ascii.vtu"].replace("0.3", "nan"), "x.msh": "$MeshFormat\n"}
    for name, body in bad.items():
        with open(os.path.join(folder, name), "w") as file:
            file.write(body)
        code, out, err = programs.run("audit", plc, os.path.join(folder, name))
        programs.expect(code == 2 and "error[E-" in err and "\ns " not in "\n" + out, "%s: %d %r" % (name, code, err))
    # Every cut of a binary .vtu and of a .node is an error, or the same mesh.
    generator = random.Random(1)
    for name in ("binary.vtu", "base1.node", "m.mesh"):
        for _ in range(12):
            cut = os.path.join(folder, "cut" + name[-5:])
            with open(cut, "w") as file:
                file.write(text[name][:generator.randrange(len(text[name]))])
            code = programs.run("audit", plc, cut)[0]
            programs.expect(code in (0, 1, 2), "%s cut: exit %d" % (name, code))
    programs.expect(programs.run("audit", plc, os.path.join(folder, "missing.vtu"))[0] == 4, "a missing mesh")


def check_planar(programs, folder):
    """Dimension 2: a square with a diagonal; the mesh must not put a point into the circles at the diagonal."""
    plc, mesh = os.path.join(folder, "d.poly"), os.path.join(folder, "d.node")
    with open(plc, "w") as file:
        file.write("4 2 0 0\n1 0 0\n2 4 0\n3 5 4\n4 0 4\n1 0\n1 1 3\n0\n")
    for extra, expected in (((), 1), (((2.5, 2.0),), 0), (((2.5, 2.0), (1.0, 3.0)), 0), (((2.5, 2.25),), 1)):
        points = [(0, 0), (4, 0), (5, 4), (0, 4)] + list(extra)
        with open(mesh, "w") as file:
            file.write("%d 2 0 0\n" % len(points) + "".join("%d %r %r\n" % (i, *p) for i, p in enumerate(points)))
        code, text, err = programs.run("audit", plc, mesh, "--json")
        programs.expect(code == expected, "planar, with %s: exit %d, %s" % (extra, code, text or err))


def check_round_trip(programs, folder):
    """Where all coordinates are doubles, our own mesh passes the audit as a whole, and its certificate is about the input."""
    for name in ("cube.off", "facet-parts.poly", "hanging-edge.obj"):
        path, mesh = os.path.join(EXAMPLES, name), os.path.join(folder, "m.node")
        report = programs.expect_verified(name, path, os.path.join(folder, "m.cert"), "--mesh", mesh)
        code, text, err = programs.run("audit", path, mesh, "--json")
        audit = json.loads(text)
        programs.expect((code == 0) == report["mesh"]["rounded"]["conforms"] == audit["conforms"], "%s: %d, %s" % (name, code, report["mesh"]))
        if report["mesh"]["rounded"]["moved_points"] == 0:
            programs.expect(code == 0 and audit["certificate"]["about"] == "the input", "%s: our own mesh: %s" % (name, text[-300:]))


def main():
    programs = Programs(sys.argv[1])
    for check in (check_random, check_depth, check_off_plane, check_formats, check_planar, check_round_trip):
        with tempfile.TemporaryDirectory() as folder:
            check(programs, folder)
    programs.finish()


main()
