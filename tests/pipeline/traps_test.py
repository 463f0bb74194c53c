#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""traps_test.py BINARIES: what others ran into when reading and writing these formats, one by one, at the command line. The readers' unit tests
(tests/core/io) go deeper into each format; here every trap of the list that the formats were chosen by has its name."""
import json
import os
import re
import struct
import sys
import tempfile
from fractions import Fraction

from harness import EXAMPLES, ROOT, Programs

TETRAHEDRON = "0 0 0\n1 0 0\n0 1 0\n0 0 1\n"
FACES = "3 0 1 2\n3 0 1 3\n3 0 2 3\n3 1 2 3\n"


class Traps:
    def __init__(self, programs, folder):
        self.programs, self.folder = programs, folder

    def info(self, name, text):
        path = os.path.join(self.folder, name)
        with open(path, "wb") as file:
            file.write(text if isinstance(text, bytes) else text.encode())
        code, out, err = self.programs.run("info", path, "--json")
        return code, json.loads(out) if out else {}, err

    def valid(self, name, text, vertices=4, facets=4):
        code, report, err = self.info(name, text)
        good = code == 0 and (report["vertices"], report["facets"]) == (vertices, facets)
        self.programs.expect(good, "%s: %d %s %s" % (name, code, {k: report.get(k) for k in ("vertices", "facets")}, err))
        return report

    def refused(self, name, text, code, place):
        got, _, err = self.info(name, text)
        self.programs.expect(got == 2 and re.search(r"%s:%s: error\[%s\]" % (re.escape(name), place, code), err), "%s: %d %r" % (name, got, err[:300]))

    # A facet line `P H m` with marker 0, and hole rows, hung other parsers.
    def facet_lines(self):
        square = "8 3 0 0\n" + "".join("%d %d %d 0\n" % (i, x, y) for i, (x, y) in enumerate(((0, 0), (4, 0), (4, 4), (0, 4), (1, 1), (3, 1), (3, 3), (1, 3))))
        self.valid("markers.poly", square + "1 1\n2 1 0\n4 0 1 2 3\n4 4 5 6 7\n0 2 2 0\n0\n", 8, 1)
        self.valid("no-markers.poly", square + "1 0\n2\n4 0 1 2 3\n4 4 5 6 7\n0\n", 8, 1)
        self.refused("end.poly", square + "1 1\n2 1 0\n4 0 1 2 3\n4 4 5 6 7\n", "E-TRUNCATED", r"\d+:\d+")

    # Comments under OFF, glued counts, counts beside the header, blank and indented comment lines.
    def off_headers(self):
        for i, header in enumerate(("OFF\n# Created by meshio\n4 4 0\n", "OFF4 4 0\n", "OFF 4 4 0\n", "\n   # before\nOFF\n\n  # between\n4 4\n\n", "OFF\n4 4 99\n")):
            self.valid("header%d.off" % i, header + TETRAHEDRON + "\n  # and here\n" + FACES)

    # What we write has no comment between header and counts, and numbers that come back.
    def written(self):
        path, out = os.path.join(self.folder, "digits.off"), os.path.join(self.folder, "out.off")
        with open(path, "w") as file:
            file.write("OFF\n3 1 0\n2400000.000000001 0.1 1e-300\n0 3 0.30000000000000004\n1 1 1e17\n3 0 1 2\n")
        self.programs.run("convert", path, out)
        with open(out) as file:
            lines = file.read().split("\n")
        self.programs.expect(lines[0] == "OFF" and lines[1].split()[:2] == ["3", "1"], "header of what is written: %s" % lines[:2])
        self.programs.expect([float(x) for x in lines[2].split()] == [2400000.000000001, 0.1, 1e-300], "digits are lost: " + lines[2])

    # Merging: bit-identical points only; -0.0 is 0.0; what is merely close stays.
    def merging(self):
        solid = lambda far: "solid s\n" + "".join("facet normal 0 0 nan\nouter loop\n%sendloop\nendfacet\n" % "".join("vertex %s\n" % v for v in t) for t in (
            ("0 0 0", "1 0 0", "0 1 0"), ("%s 0 0" % far, "0 1 0", "0 0 1"))) + "endsolid s\n"
        self.valid("same.stl", solid("-0.0"), 4, 2)
        code, report, err = self.info("close.stl", solid("1e-300"))
        self.programs.expect(code == 2 or report["vertices"] == 5, "1e-300 was merged with 0: %s" % report)

    # Rows that are too long or too short shift nothing.
    def rows(self):
        nodes = "4 3 0 0\n0 0 0 0\n1 1 0 0\n2 0 1 0%s\n3 0 0 1\n1 0\n3 0 1 2\n0\n%s"
        self.valid("right.smesh", nodes % ("", ""), 4, 1)
        self.refused("long.smesh", nodes % (" 5", ""), "E-FIELDS", "4:9")
        self.refused("short.smesh", (nodes % ("", "")).replace("2 0 1 0", "2 0 1"), "E-FIELDS", "4:6")
        self.refused("region.smesh", nodes % ("", "1\n0 1 1\n"), "E-FIELDS", r"10:\d+")

    # Quantised maps cross: refused, with the crossing's exact place; split on request only.
    def crossings(self):
        text = "4 2 0 0\n0 0 0\n1 3 1\n2 0 1\n3 3 0\n2 0\n0 0 1\n1 2 3\n0\n"
        code, _, err = self.info("map.poly", text)
        self.programs.expect(code == 2 and "E-CROSSING" in err and "(1.5, 0.5)" in err, "the crossing is named: %r" % err)
        shared = os.environ.get("CONFIDEL_SHARED") or os.path.join(os.path.dirname(ROOT), "shared")
        real = os.path.join(shared, "data", "bad", "natural-earth-countries-110m.poly")
        if not os.path.isfile(real):
            print("no %s: the real map is left out" % real)
            return
        out = os.path.join(self.folder, "real.poly")
        self.programs.expect(self.programs.run("info", real)[0] == 2, "the real map is accepted")
        code, text, err = self.programs.run("convert", real, out, "--split-crossings", "--json")
        self.programs.expect(code == 0 and len(json.loads(text)["repairs"]) >= 150, "the real map is not split: %s" % err)
        self.programs.expect(self.programs.run("info", out)[0] == 0, "the real map, split, is refused")

    # An open surface is no empty mesh: the convex hull is kept unless one asks for regions, and then it is said.
    def open_surface(self):
        mesh, cert = os.path.join(self.folder, "open.vtu"), os.path.join(self.folder, "open.cert")
        for keep, some in (("hull", True), ("regions", False)):
            report = self.programs.expect_verified("open", os.path.join(EXAMPLES, "fan.off"), cert, "--mesh", mesh, "--keep", keep)
            self.programs.expect(report and (report["mesh"]["tetrahedra"] > 0) == some and report["mesh"]["faces"] > 0 and bool(report["mesh"]["remarks"]) != some,
                                 "open surface, --keep %s: %s" % (keep, report and report["mesh"]))

    # Large coordinates with many digits are exact from the first digit; the decimal 0.1 is the nearest double; nothing is recentred.
    def exact(self):
        x = 2417803.123456789
        path = os.path.join(self.folder, "utm.off")
        with open(path, "w") as file:
            file.write("OFF\n3 1 0\n%r 0.1 0\n%r 1 0\n0 0 1\n3 0 1 2\n" % (x, x + 1))
        _, out, _ = self.programs.run("canonical", path)
        first = [int(field, 16) for field in re.search(r"^v (.*)$", out, re.M).group(1).split()]
        self.programs.expect(Fraction(first[0], first[3]) == Fraction(x) and Fraction(first[1], first[3]) == Fraction(0.1), "coordinates are not the nearest doubles")

    # Numbers: + and Fortran's D are read; octal, hexadecimal, nan, infinity and underflow are not.
    def numbers(self):
        self.valid("plus.off", "OFF\n4 4 0\n+0 0 0\n1.0D0 0 0\n0 1d+0 0\n0 0 .1E1\n" + FACES)
        for bad in ("nan", "inf", "1e400", "1e-400", "0x10", "1,5e", "--1", "1e", "infinity"):
            self.refused("number.off", "OFF\n4 4 0\n%s 0 0\n1 0 0\n0 1 0\n0 0 1\n" % bad + FACES, "E-(NUMBER|FIELDS)", r"3:\d+")
        self.valid("ten.smesh", "12 3 0 0\n" + "".join("%02d %d %d %d\n" % (i, i, i * i, i ** 3) for i in range(12)) + "1 0\n3 08 09 010\n0\n", 12, 1)

    # .vtu: what meshio, ParaView and VTK stumbled upon.
    def vtu(self):
        mesh = os.path.join(self.folder, "cube.vtu")
        self.programs.expect_verified("vtu", os.path.join(EXAMPLES, "cube.off"), os.path.join(self.folder, "c.cert"), "--mesh", mesh)
        with open(mesh) as file:
            text = file.read()
        arrays = dict(re.findall(r'<DataArray type="(\w+)" Name="(\w+)"', text)[i][::-1] for i in range(6))
        self.programs.expect(arrays["connectivity"] == arrays["offsets"] == "Int64" and arrays["types"] == "UInt8" and arrays["Points"] == "Float64", "types: %s" % arrays)
        self.programs.expect('NumberOfComponents="1"' not in text and 'header_type="UInt64"' in text and "appended" not in text, "attributes of the .vtu")

    # Medit: version 1 means float to some and is written with 17 digits by others: numbers are doubles; version 2 is written.
    def medit(self):
        mesh = os.path.join(self.folder, "cube.mesh")
        self.programs.expect_verified("medit", os.path.join(EXAMPLES, "cube.off"), os.path.join(self.folder, "c.cert"), "--mesh", mesh)
        with open(mesh) as file:
            self.programs.expect(file.readline() == "MeshVersionFormatted 2\n", "the version that is written")
        text = "MeshVersionFormatted 1\nDimension 3\nVertices 3\n%s 0 0 0\n1 0 0 0\n0 1 0 0\nTriangles 1\n1 2 3 7\nEnd\n"
        digests = {self.valid("v1.mesh", text % x, 3, 1)["sha256"] for x in ("0.1", "0.10000000000000002", repr(struct.unpack("f", struct.pack("f", 0.1))[0]))}
        self.programs.expect(len(digests) == 3, "version 1 was read as float")

    # A binary .stl may begin with "solid".
    def stl(self):
        triangles = [((0, 0, 0), (1, 0, 0), (0, 1, 0)), ((0, 0, 0), (1, 0, 0), (0, 0, 1))]
        body = b"".join(struct.pack("<12fH", 0, 0, 0, *(c for corner in t for c in corner), 0) for t in triangles)
        self.valid("binary.stl", b"solid like text".ljust(80) + struct.pack("<I", 2) + body, 4, 2)
        code, _, err = self.info("cut.stl", b"solid like text".ljust(80) + struct.pack("<I", 2) + body[:-1])
        self.programs.expect(code == 2 and "error[E-" in err, "a cut binary .stl: %d %r" % (code, err))


def main():
    programs = Programs(sys.argv[1])
    traps = [name for name in vars(Traps) if not name.startswith("_") and name not in ("info", "valid", "refused")]
    for name in traps:
        with tempfile.TemporaryDirectory() as folder:
            getattr(Traps(programs, folder), name)()
    programs.expect(len(traps) >= 12, "traps: %s" % traps)
    programs.finish()


main()
