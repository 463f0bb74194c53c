#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""read_certificate.py CERT [CELL]: reads a certificate (docs/certificate-format.md) and recomputes the sphere of one cell by hand, in rationals.

Standard library only. It shows how a certificate is read and what its heart, the rule `emptiness`, means; it is no checker. CELL is a number
from 0; without it, every cell is computed and the tightest is shown. Compressed certificates: zstd -d first.
"""
import sys
from fractions import Fraction


class Lines:
    """The records of the text, one after the other."""

    def __init__(self, path):
        with open(path, encoding="ascii") as file:
            self.lines = file.read().split("\n")
        self.at = 0

    def record(self, word=None):
        fields = self.lines[self.at].split(" ")
        self.at += 1
        if word is not None and fields[0] != word:
            raise SystemExit("line %d: %r where %r is expected" % (self.at, fields[0], word))
        return fields

    def section(self, word):
        """As many records as the section's header announces."""
        return [self.record() for _ in range(int(self.record(word)[1]))]


def point(fields, dimension):
    """Integers X Y [Z] W in hexadecimal: the point X/W, Y/W, Z/W."""
    *numerators, weight = [int(field, 16) for field in fields]
    return tuple(Fraction(numerator, weight) for numerator in numerators) + (Fraction(0),) * (3 - dimension)


def read(path):
    lines = Lines(path)
    lines.record("confidel-certificate")
    lines.record("plc")
    dimension = int(lines.record("dim")[1])
    points = [point(row[1:], dimension) for row in lines.section("vertices")]
    lines.section("segments")
    facets = []
    for _ in range(int(lines.record("facets")[1])):
        facets.append([int(field) for field in lines.record("f")[1:]])
        for part in ("b", "c", "p"):
            lines.section(part)
    lines.record("end")
    for section in ("claims", "notes", "parameters"):
        lines.section(section)
    points += [point(row[3:], dimension) for row in lines.section("points")]
    cells = []
    for row in lines.section("cells"):
        offset = Fraction(0)
        if "/" in row[-1]:
            numerator, denominator = row[-1].split("/")
            offset = Fraction(int(numerator, 16), int(denominator, 16))
        cells.append((int(row[1]), [int(field) for field in row[2:5]], offset))
    return points, facets, cells


def minus(a, b):
    return tuple(x - y for x, y in zip(a, b))


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def sphere(points, facet, corners, offset):
    """Centre and squared radius: the circumcentre in the triangle's plane, moved by the offset times the facet's normal."""
    a, b, c = (points[corner] for corner in corners)
    u, w = minus(b, a), minus(c, a)
    n = cross(u, w)
    k = 2 * dot(n, n)
    centre = tuple(a[i] + (dot(u, u) * cross(w, n)[i] + dot(w, w) * cross(n, u)[i]) / k for i in range(3))
    i, j, l = (points[vertex] for vertex in facet)
    normal = cross(minus(j, i), minus(l, i))
    centre = tuple(x + offset * y for x, y in zip(centre, normal))
    return centre, dot(minus(a, centre), minus(a, centre)), normal


def tightest(points, facets, cell):
    """The point off the cell's plane with the smallest power relative to the squared radius; raises if a point is where none may be."""
    facet, corners, offset = cell
    centre, squared_radius, normal = sphere(points, facets[facet], corners, offset)
    best = None
    for index, x in enumerate(points):
        power = dot(minus(x, centre), minus(x, centre)) - squared_radius
        off_plane = dot(normal, minus(x, points[corners[0]])) != 0
        if power < 0 or (power == 0 and off_plane):
            raise SystemExit("point %d lies in the sphere of the cell with corners %s: this proves nothing" % (index, corners))
        if off_plane and (best is None or power / squared_radius < best[0]):
            best = (power / squared_radius, index)
    return best, centre, squared_radius


def main():
    if len(sys.argv) not in (2, 3):
        raise SystemExit(__doc__)
    points, facets, cells = read(sys.argv[1])
    chosen = range(len(cells)) if len(sys.argv) == 2 else [int(sys.argv[2])]
    results = [(tightest(points, facets, cells[cell]), cell) for cell in chosen]
    print("%d points, %d facets, %d cells; %d spheres computed, all empty" % (len(points), len(facets), len(cells), len(results)))
    tight = [result for result in results if result[0][0] is not None]
    if not tight:
        print("no point lies off the planes of these cells")
        return
    ((power, index), centre, squared_radius), cell = min(tight, key=lambda result: result[0][0][0])
    print("cell %d of facet %d with corners %s" % (cell, cells[cell][0], cells[cell][1]))
    print("  centre  (%s)" % ", ".join(map(str, centre)))
    print("  r^2   = %s" % squared_radius)
    print("  nearest off its plane: point %d at (%s), power %s r^2 = %.6g r^2" % (index, ", ".join(map(str, points[index])), power, power))


main()
