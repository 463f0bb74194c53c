#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Writes the test certificates and their manifest: make_certificates.py [FOLDER]

Every expectation is stated by hand: the rule or error code, the text of the line at fault, the object.
Columns of MANIFEST.tsv: path, exit code, expected last line (or error code and line), reason.
"""
import hashlib
import os
import sys
from fractions import Fraction as Q
from math import atan2, gcd, lcm

CASES = []  # (path, bytes, exit code, expectation, reason)
FIRST_LINE = "confidel-certificate 1"


# ---- text ----------------------------------------------------------------------------------------------------------

def homogeneous(point):
    w = 1
    for x in point:
        w = lcm(w, Q(x).denominator)
    return " ".join("%x" % int(x * w) for x in map(Q, point)) + " %x" % w


def rational(x):
    return "%x/%x" % (Q(x).numerator, Q(x).denominator)


def with_end(lines, counts, digest=None):
    text = "".join(line + "\n" for line in lines)
    digest = digest or hashlib.sha256(text.encode()).hexdigest()
    return text + "end %s %s\n" % (" ".join(map(str, counts)), digest)


class Certificate:
    """A certificate under construction; all lists may be edited before lines() or text()."""

    def __init__(self, dim, vertices, segments, facets, points=(), cells=(), rows=(), hanging=(), notes=()):
        self.dim, self.vertices, self.segments = dim, list(vertices), sorted(segments)
        self.facets = [dict(f) for f in facets]   # corners, boundary, inner, isolated
        self.points, self.cells = list(points), list(cells)
        self.rows, self.hanging, self.notes = list(rows), list(hanging), list(notes)
        self.claims, self.parameters, self.evidence = ["claim conforms"], [], []

    def lines(self):
        out = [FIRST_LINE, "plc 1", "dim %d" % self.dim, "vertices %d" % len(self.vertices)]
        out += ["v " + homogeneous(v) for v in self.vertices]
        out += ["segments %d" % len(self.segments)] + ["s %d %d" % s for s in self.segments]
        out += ["facets %d" % len(self.facets)]
        for facet in self.facets:
            out += ["f %d %d %d" % tuple(facet["corners"])]
            out += ["b %d" % len(facet["boundary"])] + ["%d %d" % e for e in sorted(facet["boundary"])]
            inner, isolated = sorted(facet.get("inner", [])), sorted(facet.get("isolated", []))
            out += ["c %d" % len(inner)] + ["%d %d" % e for e in inner]
            out += ["p %d" % len(isolated)] + ["%d" % v for v in isolated]
        out += ["end", "claims %d" % len(self.claims)] + self.claims + ["notes %d" % len(self.notes)]
        out += ["n " + note for note in self.notes]
        out += ["parameters %d" % len(self.parameters)] + self.parameters
        out += ["points %d" % len(self.points)]
        out += ["q %s %s" % (carrier, homogeneous(p)) for carrier, p in self.points]
        out += ["cells %d" % len(self.cells)] + ["t " + cell for cell in self.cells]
        out += ["rows %d" % len(self.rows)]
        for header, members in self.rows:
            out += ["r %s" % header] + ["%d" % m for m in members]
        out += ["hanging %d" % len(self.hanging)] + ["h %d %d %d" % h for h in self.hanging]
        return out + ["evidence %d" % len(self.evidence)] + self.evidence

    def counts(self):
        return [len(x) for x in (self.vertices, self.segments, self.facets, self.points, self.cells, self.rows, self.hanging)]

    def text(self):
        return with_end(self.lines(), self.counts())


def line_of(text, wanted, occurrence=1):
    """Number of the given occurrence of a line; a number stands for itself."""
    if isinstance(wanted, int):
        return wanted
    if isinstance(wanted, tuple):
        wanted, occurrence = wanted
    places = [i + 1 for i, line in enumerate(text.split("\n")) if line == wanted]
    if len(places) < occurrence:
        raise SystemExit("no line %r in:\n%s" % (wanted, text))
    return places[occurrence - 1]


def add(path, data, code, expectation, reason):
    data = data if isinstance(data, bytes) else data.encode("latin-1")
    CASES.append((path, data, code, expectation, reason))


def accept(name, certificate, reason):
    text = certificate if isinstance(certificate, (str, bytes)) else certificate.text()
    add("accept/%s.cert" % name, text, 0, "s VERIFIED", reason)


def reject(name, certificate, rule, line, thing, reason):
    text = certificate if isinstance(certificate, str) else certificate.text()
    add("reject/%s.cert" % name, text, 5, "s REJECTED %s %d %s" % (rule, line_of(text, line), thing), reason)


def malformed(name, data, code, line, reason):
    text = data if isinstance(data, str) else data.decode("latin-1")
    # Where a damaged frame is noticed depends on the library that reads it.
    add("malformed/%s.cert" % name, data, 2, code if code == "E-ZSTD" else "%s %d" % (code, line_of(text, line)), reason)


def decline(name, data, why, reason):
    add("decline/%s.cert" % name, data, 3, "s UNDECIDED " + why, reason)


# ---- geometry of the examples --------------------------------------------------------------------------------------

def orient(a, b, c):
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])


def in_circle(a, b, c, d):
    rows = [(p[0] - d[0], p[1] - d[1]) for p in (a, b, c)]
    rows = [(x, y, x * x + y * y) for x, y in rows]
    (a, b, c), (d, e, f), (g, h, i) = rows
    return a * (e * i - f * h) - b * (d * i - f * g) + c * (d * h - e * g)


def delaunay(points):
    """The Delaunay polygons of points in the plane, by brute force: index lists, counter-clockwise."""
    polygons = set()
    n = len(points)
    for i in range(n):
        for j in range(n):
            for k in range(n):
                if not (i < j and i < k) or orient(points[i], points[j], points[k]) <= 0:
                    continue
                powers = [in_circle(points[i], points[j], points[k], points[m]) for m in range(n)]
                if max(powers) > 0:
                    continue
                on = [m for m in range(n) if powers[m] == 0]
                middle = (sum(points[m][0] for m in on) / len(on), sum(points[m][1] for m in on) / len(on))
                on.sort(key=lambda m: atan2(points[m][1] - middle[1], points[m][0] - middle[0]))
                first = on.index(min(on))
                polygons.add(tuple(on[first:] + on[:first]))
    return sorted(polygons)


def fans(polygons, facet=0):
    return ["%d %d %d %d C" % (facet, p[0], p[i], p[i + 1]) for p in polygons for i in range(1, len(p) - 1)]


def loop(vertices):
    return [(a, b) for a, b in zip(vertices, vertices[1:] + vertices[:1])]


def undirected(edges):
    return sorted(set((min(e), max(e)) for e in edges))


def lift(points, z=0):
    return [(x, y, z) for x, y in points]


def planar(points, ring, inner=(), isolated=(), extra=(), segments=(), dim=3, drop=()):
    """One facet in the plane z = 0 that fills the hull `ring`; extra points above or below; `drop`: polygons in holes."""
    polygons = [p for p in delaunay(points) if p not in drop]
    facet = dict(corners=ring[:3], boundary=loop(ring), inner=list(inner), isolated=list(isolated))
    vertices = (lift(points) if dim == 3 else list(points)) + list(extra)
    return Certificate(dim, vertices, undirected(loop(ring) + list(inner) + list(segments)), [facet], cells=fans(polygons))


def worked():
    return Certificate(
        3, [(0, 0, 0), (4, 0, 0), (0, 4, 0), (1, 1, 5), (1, 1, 9)], [(0, 1), (0, 2), (1, 2), (3, 4)],
        [dict(corners=(0, 1, 2), boundary=loop([0, 1, 2]))],
        points=[("interior 0", (1, 1, 0)), ("edge 3", (1, 1, 7))],
        cells=["0 0 1 5 C", "0 1 2 5 C", "0 2 0 5 C -1/64"], hanging=[(3, 3, 6), (3, 6, 4)], notes=["strategy by hand"])


SQUARE = [(0, 0), (1, 0), (1, 1), (0, 1)]


def square(**arguments):
    return planar(SQUARE, [0, 1, 2, 3], **arguments)


def cube():
    vertices = [(x, y, z) for z in (0, 1) for y in (0, 1) for x in (0, 1)]
    rings = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]]
    cells = ["%d %d %d %d C" % (f, r[0], r[i], r[i + 1]) for f, r in enumerate(rings) for i in (1, 2)]
    segments = undirected(e for r in rings for e in loop(r))
    return Certificate(3, vertices, segments, [dict(corners=r[:3], boundary=loop(r)) for r in rings], cells=cells)


def circle_points(count):
    """Points on the unit circle whose denominators have next to nothing in common."""
    points = []
    m, n = 10 ** 18 + 9, 1
    for i in range(count):
        m, n = 10 ** 18 + 9 + 7919 * i * i, 3 * 10 ** 17 * (i + 1) // 3 + 1
        s = m * m + n * n
        x, y = Q(m * m - n * n, s), Q(2 * m * n, s)
        points.append((x, y) if i % 2 else (x, -y))
    points.sort(key=lambda p: atan2(p[1], p[0]))
    return points


def circle(dim, extra=()):
    points = circle_points(24)
    ring = list(range(len(points)))
    vertices = points if dim == 2 else [(x, y, Q(1, 10 ** 9 + 7)) for x, y in points]
    return Certificate(dim, vertices + list(extra), undirected(loop(ring)), [dict(corners=ring[:3], boundary=loop(ring))], cells=fans([ring]))


def rows_and_boxes(dim=3):
    """A rectangle with an aligned row along its lower side and boxes between."""
    points = [(0, 0), (8, 0), (9, 7), (0, 8)] + [(2, 0), (4, 0), (6, 0)] + [(2, 1), (4, 1), (6, 1)]
    segments = [(0, 1), (0, 3), (1, 2), (2, 3)]
    kinds = ["edge 0", "projection 0", "edge 0", "offset 0", "offset 0", "offset 0"]
    boxes = [(4, 5, 8, 7), (5, 6, 9, 8)]
    polygons = [p for p in delaunay(points) if set(p) not in [set(b) for b in boxes]]
    assert len(polygons) == len(delaunay(points)) - 2
    cells = fans(polygons)
    for number, (a, b, c, d) in enumerate(boxes):
        cells += ["0 %d %d %d R %d" % (a, b, c, number), "0 %d %d %d R %d" % (a, c, d, number)]
    place = lift(points) if dim == 3 else points
    return Certificate(dim, place[:4], segments, [dict(corners=(0, 1, 2), boundary=loop([0, 1, 2, 3]))],
                       points=list(zip(kinds, place[4:])), cells=cells, rows=[("0 3", [4, 5, 6]), ("0 3 0 +", [7, 8, 9])])


def with_hole():
    outer, hole = [(0, 0), (6, 0), (6, 6), (0, 6)], [(2, 2), (4, 2), (4, 4), (2, 4)]
    c = planar(outer + hole, [0, 1, 2, 3], drop=[(4, 5, 6, 7)])
    c.facets[0]["boundary"] = loop([0, 1, 2, 3]) + loop([4, 7, 6, 5])
    c.segments = undirected(c.facets[0]["boundary"])
    return c


SLIT = [(0, 0), (6, 0), (7, 5), (0, 6), (2, 2), (4, 3)]


def with_slit():
    return planar(SLIT, [0, 1, 2, 3], inner=[(4, 5)])


def two_triangles(apexes=True):
    """The unit square as two triangles: their common edge is a diagonal, which ties leave open."""
    vertices = lift(SQUARE) + ([(Q(1, 2), Q(1, 2), 2), (Q(1, 2), Q(1, 2), -2)] if apexes else [])
    facets = [dict(corners=(0, 1, 2), boundary=loop([0, 1, 2])), dict(corners=(0, 2, 3), boundary=loop([0, 2, 3]))]
    return Certificate(3, vertices, undirected(loop([0, 1, 2]) + loop([0, 2, 3])), facets, cells=["0 0 1 2 C", "1 0 2 3 C"])


def folded():
    """Two triangles in different planes with a common edge that carries a point."""
    vertices = [(0, 0, 0), (4, 0, 0), (2, 3, 0), (2, 0, 3)]
    facets = [dict(corners=(0, 1, 2), boundary=loop([0, 1, 2])), dict(corners=(0, 1, 3), boundary=loop([0, 1, 3]))]
    cells = ["0 0 4 2 C", "0 4 1 2 C", "1 0 4 3 C", "1 4 1 3 C"]
    return Certificate(3, vertices, undirected(loop([0, 1, 2]) + loop([0, 1, 3])), facets,
                       points=[("edge 0", (2, 0, 0))], cells=cells)


# ---- zstd without a library: raw and run-length blocks --------------------------------------------------------------

def zstd_frame(blocks, content_size=None, window=None):
    out = b"\x28\xb5\x2f\xfd"
    if content_size is not None:
        out += bytes([0xa0]) + content_size.to_bytes(4, "little")      # single segment, size in four bytes
    else:
        out += b"\x00" + bytes([window])                               # window descriptor
    for i, (kind, size, payload) in enumerate(blocks):
        out += ((size << 3) | (kind << 1) | (i == len(blocks) - 1)).to_bytes(3, "little") + payload
    return out


def zstd_raw(text):
    data = text.encode()
    return zstd_frame([(0, len(data[i:i + 1000]), data[i:i + 1000]) for i in range(0, len(data), 1000)], content_size=len(data))


# ---- cases ---------------------------------------------------------------------------------------------------------

def edited(certificate, old, new, occurrence=1):
    """The certificate's text with one line replaced (None: removed; a list: several lines), the digest made right again."""
    lines = certificate.lines()
    place = [i for i, line in enumerate(lines) if line == old][occurrence - 1]
    lines[place:place + 1] = [] if new is None else new if isinstance(new, list) else [new]
    return with_end(lines, certificate.counts())


def main():
    from certificate_cases import write_all
    write_all(sys.modules[__name__])
    folder = sys.argv[1] if len(sys.argv) > 1 else os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "certificates")
    names = [case[0] for case in CASES]
    if len(set(names)) != len(names):
        raise SystemExit("a name is used twice")
    for path, data, _, _, _ in CASES:
        target = os.path.join(folder, path)
        os.makedirs(os.path.dirname(target), exist_ok=True)
        with open(target, "wb") as file:
            file.write(data)
    with open(os.path.join(folder, "MANIFEST.tsv"), "w") as file:
        file.write("# SPDX-License-Identifier: Apache-2.0\n")
        for path, _, code, expectation, reason in sorted(CASES):
            file.write("%s\t%d\t%s\t%s\n" % (path, code, expectation, reason))


if __name__ == "__main__":
    sys.dont_write_bytecode = True
    main()
