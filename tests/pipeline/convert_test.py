#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""convert_test.py BINARIES: formats there and back give the same complex; repairs are made on request only, exactly where needed, and reported."""
import json
import os
import random
import struct
import sys
import tempfile
from fractions import Fraction

from harness import EXAMPLES, Programs, content


def sha(programs, path, *options):
    code, out, err = programs.run("info", path, "--json", *options)
    return json.loads(out)["sha256"] if code == 0 else "exit %d: %s" % (code, err)


def check_formats(programs, folder):
    keep = ("--merge-coplanar", "off")
    for name in ("w3.smesh", "cube.off", "facet-parts.poly", "hanging-edge.obj", "tetrahedron.off", "g3.smesh"):
        path = os.path.join(EXAMPLES, name)
        written = 0
        for suffix in (".smesh", ".poly", ".off", ".obj"):
            out = os.path.join(folder, "there" + suffix)
            code, _, err = programs.run("convert", path, out)
            if code == 2:  # The format cannot hold it, and says what can.
                programs.expect("error[E-FORMAT]" in err and "write ." in err and not os.path.exists(out), "%s to %s: %r" % (name, suffix, err))
                continue
            written += 1
            programs.expect(code == 0 and sha(programs, path, *keep) == sha(programs, out, *keep), "%s to %s: another complex" % (name, suffix))
            back = os.path.join(folder, "back" + suffix)
            programs.expect(programs.run("convert", out, back)[0] == 0 and content(out) == content(back), "%s: writing %s twice differs" % (name, suffix))
            os.unlink(out)
        programs.expect(written >= 1, name + ": no format holds it")
    for bad in ("x.stl", "x", "x.vtk"):
        code, _, err = programs.run("convert", os.path.join(EXAMPLES, "cube.off"), os.path.join(folder, bad))
        programs.expect(code == 2 and "E-FORMAT" in err, bad + ": no error")


def check_digits(programs, folder):
    """Every double comes back bit by bit; zeros and exponents included."""
    generator = random.Random(9)
    numbers = [0.1, 1 / 3, 5e-324, 1.7976931348623157e308, -0.0, 2400000.000000001, 123456789012345680.0]
    numbers += [struct.unpack("<d", struct.pack("<Q", generator.getrandbits(64) & ~(1 << 62)))[0] for _ in range(60)]
    numbers = [x for x in numbers if x == x and abs(x) != float("inf")]
    path, out = os.path.join(folder, "digits.obj"), os.path.join(folder, "digits.off")
    with open(path, "w") as file:
        for x in numbers:
            file.write("v %r %r %r\n" % (x, -x, x))
        file.write("f 1 2 3\n")
    code, _, err = programs.run("convert", path, out)
    rows = [line.split() for line in open(out).read().split("\n")[2:2 + len(numbers)]] if code == 0 else []
    programs.expect([float(row[0]).hex() for row in rows] == [(x + 0.0).hex() for x in numbers], "digits are lost: %s" % err)


def check_merge(programs, folder):
    path, out = os.path.join(folder, "twice.off"), os.path.join(folder, "once.off")
    with open(path, "w") as file:
        file.write("OFF\n6 2 0\n0 0 0\n1 0 0\n0 1 0\n1 -0.0 0\n0 1 0\n1 1 1e-300\n3 0 1 2\n3 3 5 4\n")
    for options, vertices in (((), 6), (("--merge", "off"), 6), (("--merge", "exact"), 4)):
        code, text, _ = programs.run("convert", path, out, "--json", *options)
        report = json.loads(text)
        programs.expect(code == 0 and report["vertices"] == vertices and len(report["repairs"]) == 6 - vertices, "%s: %s" % (options, report))
    programs.expect(programs.run("info", out)[0] == 0 and programs.run("info", path)[0] == 2, "merged is valid, unmerged is not")


def check_triangulate(programs, folder):
    bent, out = os.path.join(EXAMPLES, "bent.off"), os.path.join(folder, "flat.off")
    programs.expect(programs.run("info", bent)[0] == 2, "bent.off is flat")
    code, text, _ = programs.run("convert", bent, out, "--facets", "triangulate", "--json")
    report = json.loads(text)
    programs.expect(code == 0 and report["facets"] == 3 and [r["kind"] for r in report["repairs"]] == ["triangulate"], "bent.off: %s" % report)
    programs.expect(programs.run("info", out)[0] == 0, "the triangles of bent.off are no complex")
    # A cube whose squares are flat is left alone; a bent polygon that is not convex is cut inside of itself.
    code, text, _ = programs.run("convert", os.path.join(EXAMPLES, "cube.off"), out, "--facets", "triangulate", "--json")
    programs.expect(code == 0 and json.loads(text)["repairs"] == [] and json.loads(text)["facets"] == 6, "cube.off was changed")
    with open(os.path.join(folder, "l.off"), "w") as file:
        file.write("OFF\n6 1 0\n0 0 0\n3 0 0.25\n3 1 0\n1 1 0\n1 3 0.125\n0 3 0\n6 0 1 2 3 4 5\n")
    code, text, _ = programs.run("convert", os.path.join(folder, "l.off"), out, "--facets", "triangulate", "--json")
    programs.expect(code == 0 and json.loads(text)["facets"] == 4, "an L of six corners is four triangles")
    lines = open(out).read().split("\n")
    points = [tuple(map(Fraction, line.split())) for line in lines[2:8]]
    area = Fraction(0)
    for line in lines[8:12]:
        a, b, c = (points[int(i)] for i in line.split()[1:])
        area += abs((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])) / 2
    programs.expect(area == 5, "the triangles cover the L once: %s" % area)
    for name, rows in (("cross.off", "4 1 0\n0 0 0\n1 1 0.5\n1 0 0\n0 1 0\n4 0 1 2 3\n"), ("index.off", "3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 7\n")):
        with open(os.path.join(folder, name), "w") as file:
            file.write("OFF\n" + rows)
        code, _, err = programs.run("convert", os.path.join(folder, name), out, "--facets", "triangulate")
        programs.expect(code == 2 and "error[E-" in err, "%s: %d %r" % (name, code, err))


def planar(path):
    fields = [line.split() for line in open(path) if line.strip() and not line.startswith("#")]
    count, base = int(fields[0][0]), int(fields[1][0])
    points = [tuple(map(Fraction, map(float, row[1:3]))) for row in fields[1:1 + count]]
    segments = int(fields[1 + count][0])
    return points, [tuple(int(i) - base for i in row[1:3]) for row in fields[2 + count:2 + count + segments]]


def crossings(points, segments):
    turn = lambda a, b, c: (points[b][0] - points[a][0]) * (points[c][1] - points[a][1]) - (points[b][1] - points[a][1]) * (points[c][0] - points[a][0])
    found = 0
    for i, (a, b) in enumerate(segments):
        for c, d in segments[:i]:
            if not {a, b} & {c, d} and turn(a, b, c) * turn(a, b, d) < 0 and turn(c, d, a) * turn(c, d, b) < 0:
                found += 1
    return found


def check_split(programs, folder):
    out = os.path.join(folder, "split.poly")
    path = os.path.join(EXAMPLES, "crossing.poly")
    programs.expect(crossings(*planar(path)) == 3 and programs.run("info", path)[0] == 2, "crossing.poly")
    code, text, _ = programs.run("convert", path, out, "--split-crossings", "--json")
    report = json.loads(text)
    points, segments = planar(out)
    programs.expect(code == 0 and crossings(points, segments) == 0 and len(points) == 9 and len(segments) == 9, "crossing.poly: %s" % report)
    moved = [repair["moved"] for repair in report["repairs"]]
    programs.expect(moved.count(0) == 1 and report["greatest_move"] == max(moved) < 1e-15, "what is no double is said: %s" % moved)
    programs.expect((Fraction(2), Fraction(2)) in points, "an exact crossing stays exact")
    programs.expect(programs.run("info", out)[0] == 0, "what was split is valid")
    generator = random.Random(5)
    for case in range(6):
        path = os.path.join(folder, "random.poly")
        with open(path, "w") as file:
            # Many thin crossings near a point, at several sizes.
            file.write("40 2 0 0\n")
            scale = 10.0 ** generator.randint(-8, 8)
            for i in range(40):
                file.write("%d %r %r\n" % (i, generator.random() * scale, generator.random() * scale * (1e-6 if case == 3 else 1)))
            file.write("20 0\n" + "".join("%d %d %d\n" % (i, 2 * i, 2 * i + 1) for i in range(20)) + "0\n")
        code, text, err = programs.run("convert", path, out, "--split-crossings", "--json")
        programs.expect(code == 0 and crossings(*planar(out)) == 0, "random segments %d: %d %s" % (case, code, err))
        programs.expect(programs.run("info", out)[0] == 0, "random segments %d: not valid" % case)
        again = programs.run("convert", out, out, "--split-crossings", "--json")[1]
        programs.expect(json.loads(again)["repairs"] == [], "random segments %d: splitting again does something" % case)
    code, _, err = programs.run("convert", os.path.join(EXAMPLES, "cube.off"), out, "--split-crossings")
    programs.expect(code == 2 and "E-FORMAT" in err, "crossings in space")


def main():
    programs = Programs(sys.argv[1])
    for check in (check_formats, check_digits, check_merge, check_triangulate, check_split):
        with tempfile.TemporaryDirectory() as folder:
            check(programs, folder)
    programs.finish()


main()
