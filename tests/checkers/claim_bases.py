# SPDX-License-Identifier: Apache-2.0
"""Protected facets for the claims of docs/lemma-claims.md, in exact fractions: arcs, protectors, boxes, and an interior refined to R <= h."""
from fractions import Fraction as Q
from math import isqrt

C, K = Q(60, 61), 4                      # psi = 10.4 degrees, phi' = 41.6 degrees
BETA = (Q(3479, 3721), Q(1320, 3721))    # 2 psi: cosine and sine
H = Q(22, 61)                            # 2 sin psi: the longest chord that H-chord allows for r = 1
MIDDLE = (Q(20, 29), Q(21, 29))          # of the arc from beta to 90 degrees - beta


def sub(a, b):
    return tuple(x - y for x, y in zip(a, b))


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def norm(a):
    return dot(a, a)


def exact_root(square):
    result = Q(isqrt(square.numerator), isqrt(square.denominator))
    assert result * result == square
    return result


def circle(a, b, c):
    """Centre and squared radius, in the plane."""
    (ux, uy), (wx, wy) = sub(b, a), sub(c, a)
    twice = 2 * (ux * wy - uy * wx)
    uu, ww = ux * ux + uy * uy, wx * wx + wy * wy
    z = (wy * uu - uy * ww) / twice, (ux * ww - wx * uu) / twice
    return (a[0] + z[0], a[1] + z[1]), z[0] ** 2 + z[1] ** 2


def triangulate(points):
    """The Delaunay triangles of points in the plane (Bowyer and Watson, exact; ties as they come)."""
    far = 1000
    all_points = dict(enumerate(points))
    all_points.update({-1: (-far, -far), -2: (far, -far), -3: (0, far)})
    triangles = {(-1, -2, -3): circle(*[all_points[i] for i in (-1, -2, -3)])}
    for number, p in enumerate(points):
        insert(all_points, triangles, number, p)
    return {t: c for t, c in triangles.items() if min(t) >= 0}


def insert(points, triangles, number, p):
    points[number] = p
    bad = [t for t, (z, r2) in triangles.items() if dot(sub(p, z), sub(p, z)) < r2]
    edges = {(t[i], t[(i + 1) % 3]) for t in bad for i in range(3)}
    for t in bad:
        del triangles[t]
    for a, b in edges:
        if (b, a) not in edges:
            triangles[(a, b, number)] = circle(points[a], points[b], p)


class Edge:
    """An edge of the square: offset d of its protector, distances of the first and last row point from the corners, number of intervals."""

    def __init__(self, d=BETA[1], start=BETA[0], stop=BETA[0], count=3):
        self.d, self.start, self.stop, self.count = d, start, stop, count


class Square:
    """A protected square facet: points as (kind, edge or None, place), cells as (corners, kind). Numbers below 4 are its corners.

    corners: of another polygon, counter-clockwise, with edges of rational lengths; then all that is said of four holds for their number. arcs: for each corner the points of its arc, in the frame of the edge that leaves it. interior: points that are there before Chew's refinement to R <= h (None: no refinement)."""

    def __init__(self, side=3, h=H, edges=None, arcs=None, interior=(), denominator=256, corners=None):
        self.corners = corners or [(Q(0), Q(0)), (Q(side), Q(0)), (Q(side), Q(side)), (Q(0), Q(side))]
        self.n = n = len(self.corners)
        self.points, self.cells, self.boxes, self.rows, self.insertions = [], [], [], [], []
        edges, arcs = edges or [Edge()] * n, arcs or [[MIDDLE]] * n
        rims = []
        for i in range(n):
            whole = sub(self.corners[(i + 1) % n], self.corners[i])
            side = exact_root(norm(whole))
            along = tuple(x / side for x in whole)
            inward = (-along[1], along[0])
            place = lambda u, w: tuple(self.corners[i][k] + u * along[k] + w * inward[k] for k in (0, 1))
            e, row, shield = edges[i], [], []
            for k in range(e.count + 1):
                u = e.start + (side - e.start - e.stop) * Q(k, e.count)
                row.append(self.add("projection" if k in (0, e.count) else "edge", i, place(u, 0)))
                shield.append(self.add("offset", None, place(u, e.d)))
            rims.append([self.add("arc", None, place(u, w)) for u, w in arcs[i]])
            self.rows.append((i, row, shield))
        self.outline = []
        for i in range(n):
            row, shield = self.rows[i][1:]
            last_row, last_shield = self.rows[i - 1][1:]
            end = last_shield[-1]
            if self.place(end) == self.place(shield[0]):  # protectors that meet: no spoke triangle
                self.points[end - n] = None
                last_shield[-1] = end = shield[0]
            ring = [shield[0]] + rims[i] + ([end] if end != shield[0] else [])
            self.cells.append(((i, row[0], shield[0]), "T"))
            self.cells += [((i, p, q), "S") for p, q in zip(ring, ring[1:])]
            self.cells.append(((i, end, last_row[-1]), "T"))
            self.outline += list(reversed(ring[1:])) + shield[:-1]
        for i, row, shield in self.rows:
            self.boxes += [(row[k], row[k + 1], shield[k + 1], shield[k]) for k in range(len(row) - 1)]
        for p in interior:
            self.add("interior", None, p)
        self.refine(h, denominator, [len(self.points) + n - len(interior) + k for k in range(len(interior))])

    def add(self, kind, carrier, place):
        self.points.append((kind, carrier, place))
        return self.n - 1 + len(self.points)

    def place(self, p):
        return self.corners[p] if p < self.n else self.points[p - self.n][2]

    def refine(self, h, denominator, interior):
        """Chew's refinement of the polygon of the outline."""
        numbers = self.outline + interior
        points = [self.place(p) for p in self.outline]
        ring = len(points)
        triangles = triangulate(points + [self.place(p) for p in interior])
        places = dict(enumerate(points + [self.place(p) for p in interior]))
        kept = {}

        def inside(t):
            if t not in kept:
                middle = tuple(sum(places[i][k] for i in t) / 3 for k in (0, 1))
                kept[t] = sum((a[1] > middle[1]) != (b[1] > middle[1]) and (b[0] - a[0]) * (middle[1] - a[1]) / (b[1] - a[1]) + a[0] > middle[0]
                              for a, b in zip(points, points[1:] + points[:1])) % 2 == 1
            return kept[t]

        while h is not None:
            large = [(r2, t) for t, (z, r2) in sorted(triangles.items()) if r2 > h * h and inside(t)]
            if not large:
                break
            r2, t = max(large)
            z = triangles[t][0]
            p = tuple(Q(round(x * denominator), denominator) for x in z)
            assert 4096 * dot(sub(p, z), sub(p, z)) <= h * h
            self.insertions.append((tuple(numbers[i] for i in t), self.add("interior", None, p)))
            numbers.append(self.insertions[-1][1])
            insert(places, triangles, len(numbers) - 1, p)
        self.cells += [(tuple(numbers[i] for i in t), "C") for t in sorted(triangles) if inside(t)]


def flat(p):
    return (p[0], p[1], Q(0))


def tilted(cosine, sine):
    """The plane through the first edge that makes this angle with the plane of `flat`."""
    return lambda p: (p[0], p[1] * cosine, p[1] * sine)


class Assembly:
    """Faces (a Square, and where it lies) with common vertices and row points, as the parts of a certificate; numbers as in the text.

    vertices: others, after the corners of the faces; first: vertices that come before all others."""

    def __init__(self, m, faces, vertices=(), hanging=(), dim=3, first=()):
        self.faces, self.dim = faces, dim
        self.vertices = list(first)
        for square, embed in faces:
            self.vertices += [v for v in map(embed, square.corners) if v not in self.vertices]
        self.vertices += [v for v in vertices if v not in self.vertices]
        loops = [[self.vertices.index(v) for v in map(embed, square.corners)] for square, embed in faces]
        ends = [tuple(sorted((self.vertices.index(a), self.vertices.index(b)))) for a, b in hanging]
        self.segments = m.undirected([e for ring in loops for e in m.loop(ring)] + ends)
        self.facets = [dict(corners=ring[:3], boundary=m.loop(ring)) for ring in loops]
        self.points, self.number, self.rows = [], [], {}
        for f, (square, embed) in enumerate(faces):
            n = square.n
            number = {i: loops[f][i] for i in range(n)}
            for i, point in enumerate(square.points, n):
                if point is None:
                    continue
                kind, edge, place = point
                carrier = f if edge is None else self.segments.index(tuple(sorted((loops[f][edge], loops[f][(edge + 1) % n]))))
                entry = ("%s %d" % (kind, carrier), embed(place))
                if entry not in self.points:
                    self.points.append(entry)
                number[i] = len(self.vertices) + self.points.index(entry)
            self.number.append(number)
        self.cells = []
        for f, (square, embed) in enumerate(faces):
            number = self.number[f]
            self.cells += [(f, tuple(number[p] for p in t), kind) for t, kind in square.cells]
            for edge, row, shield in square.rows:
                a, b = loops[f][edge], loops[f][(edge + 1) % square.n]
                s = self.segments.index((min(a, b), max(a, b)))
                row, shield = [number[p] for p in row], [number[p] for p in shield]
                self.rows[(s, -1)] = ("%d %d" % (s, len(row)), row if a < b else row[::-1])
                self.rows[(s, f)] = ("%d %d %d %s" % (s, len(row), f, "+" if a < b else "-"), shield if a < b else shield[::-1])
        self.boxes = [(f, tuple(self.number[f][p] for p in box)) for f, (square, _) in enumerate(faces) for box in square.boxes]
        self.hanging = [(self.segments.index(e),) + e for e in sorted(ends)]

    def counts(self):
        of = lambda *kinds: sum(kind in kinds for _, _, kind in self.cells)
        kinds = [carrier.split()[0] for carrier, _ in self.points]
        rim = kinds.count("offset") + kinds.count("arc")
        total, outline = len(self.cells) + 2 * len(self.boxes), sum(len(square.outline) for square, _ in self.faces)
        shields = {}
        for s, f in self.rows:
            if f >= 0:
                shields[s] = shields.get(s, 0) + 1
        pairs = sum(k * (k - 1) // 2 for k in shields.values())
        triples = 0
        for ring in self.facets:
            edges = [tuple(sorted(e)) for e in ring["boundary"]]
            corners = {v for e in edges for v in e}
            triples += sum(v in corners for s in self.segments if s not in edges for v in s)
        return {"H-angle": 2 * len(self.segments), "H-ball": of("T", "S"), "H-offset": of("T"), "H-chord": 1, "L1": of("S"), "L2": len(self.boxes), "L3": of("S"),
                "L4": len(self.boxes), "L5": of("T") // 2, "L6": rim, "L7": of("T"), "L8": kinds.count("interior"), "L9": of("T"), "L10": of("S"), "L11": of("S"), "L12": 2 * pairs,
                "L13": 2 * len(self.boxes), "L14": pairs, "L15": triples if self.dim == 3 else 0, "L16": of("C"), "L17": outline, "L18": total, "L18b": total, "L19": len(self.facets),
                "L20": total, "L21": len(self.vertices) + len(self.segments), "L22": len(self.hanging), "L23": outline}

    def certificate(self, m, claims, parameters=()):
        c = m.Certificate(self.dim, self.vertices, self.segments, self.facets, points=self.points, hanging=self.hanging)
        c.cells = ["%d %d %d %d %s" % ((f,) + t + (kind,)) for f, t, kind in self.cells]
        for number, (f, (a, b, d, e)) in enumerate(self.boxes):
            c.cells += ["%d %d %d %d R %d" % (f, a, b, d, number), "%d %d %d %d R %d" % (f, a, d, e, number)]
        c.rows = [self.rows[key] for key in sorted(self.rows)]
        counts = self.counts()
        c.claims += ["claim %s %d" % (name, counts[name]) for name in counts if name in claims]
        c.parameters = list(parameters)
        if "L8" in claims:
            c.evidence = ["c %d %d %d %d %d" % ((f,) + t + (p,)) for f, t, p in self.all_insertions()]
        return c

    def all_insertions(self):
        return [(f, tuple(self.number[f][p] for p in t), self.number[f][p]) for f, (square, _) in enumerate(self.faces) for t, p in square.insertions]

    def place(self, p):
        return self.vertices[p] if p < len(self.vertices) else self.points[p - len(self.vertices)][1]
