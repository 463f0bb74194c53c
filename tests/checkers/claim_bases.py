# SPDX-License-Identifier: Apache-2.0
"""Protected facets for the claims of docs/lemma-claims.md, in exact fractions: arcs, protectors, boxes, and an interior refined to R <= h."""
from fractions import Fraction as Q

C, K = Q(60, 61), 4                      # psi = 10.4 degrees, phi' = 41.6 degrees
BETA = (Q(3479, 3721), Q(1320, 3721))    # 2 psi: cosine and sine
H = Q(22, 61)                            # 2 sin psi: the longest chord that H-chord allows for r = 1
MIDDLE = (Q(20, 29), Q(21, 29))          # of the arc from beta to 90 degrees - beta


def sub(a, b):
    return tuple(x - y for x, y in zip(a, b))


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


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


class Square:
    """A square facet of side 3 with r = 1: points as (kind, carrier name, place), cells as (corners, kind)."""

    def __init__(self, count=3, side=3, h=H, arc=(MIDDLE,), denominator=256):
        self.corners = [(Q(0), Q(0)), (Q(side), Q(0)), (Q(side), Q(side)), (Q(0), Q(side))]
        self.points, self.cells, self.boxes, self.rows, self.insertions = [], [], [], [], []
        cosine, sine = BETA
        length = side - 2 * cosine
        frames = [((1, 0), (0, 1)), ((0, 1), (-1, 0)), ((-1, 0), (0, -1)), ((0, -1), (1, 0))]
        rims = []
        for i, (along, inward) in enumerate(frames):
            place = lambda u, w: tuple(self.corners[i][k] + u * along[k] + w * inward[k] for k in (0, 1))
            row = [self.add("projection" if k in (0, count) else "edge", i, place(cosine + length * k / count, 0)) for k in range(count + 1)]
            shield = [self.add("offset", None, place(cosine + length * k / count, sine)) for k in range(count + 1)]
            rim = [self.add("arc", None, place(u, w)) for u, w in arc]
            self.rows.append((i, row, shield))
            rims.append(rim)
        outline = []
        for i in range(4):
            row, shield = self.rows[i][1:]
            last_row, last_shield = self.rows[i - 1][1:]
            ring = [shield[0]] + rims[i] + [last_shield[-1]]
            self.cells.append(((i, row[0], shield[0]), "T"))
            self.cells += [((i, p, q), "S") for p, q in zip(ring, ring[1:])]
            self.cells.append(((i, last_shield[-1], last_row[-1]), "T"))
            self.boxes += [(row[k], row[k + 1], shield[k + 1], shield[k]) for k in range(count)]
            outline += list(reversed(ring[1:])) + shield[:-1]
        # counter-clockwise: the fan's rim from the last protector to the first, then the protector
        self.outline = outline
        self.refine(h, denominator)

    def add(self, kind, carrier, place):
        self.points.append((kind, carrier, place))
        return 3 + len(self.points)

    def place(self, p):
        return self.corners[p] if p < 4 else self.points[p - 4][2]

    def refine(self, h, denominator):
        """Chew's refinement of the polygon of the outline."""
        numbers = list(self.outline)
        points = [self.place(p) for p in numbers]
        triangles = triangulate(points)
        places = dict(enumerate(points))
        places.update({-1: (-1000, -1000), -2: (1000, -1000), -3: (0, 1000)})
        full = dict(triangles)
        ring = len(self.outline)

        def inside(t):
            middle = tuple(sum(places[i][k] for i in t) / 3 for k in (0, 1))
            count = 0
            for a, b in zip(points[:ring], points[1:ring] + points[:1]):
                if (a[1] > middle[1]) != (b[1] > middle[1]):
                    count += (b[0] - a[0]) * (middle[1] - a[1]) / (b[1] - a[1]) + a[0] > middle[0]
            return count % 2 == 1

        while True:
            large = [(r2, t) for t, (z, r2) in sorted(full.items()) if r2 > h * h and inside(t)]
            if not large:
                break
            r2, t = max(large)
            z = full[t][0]
            p = tuple(Q(round(x * denominator), denominator) for x in z)
            assert 4096 * dot(sub(p, z), sub(p, z)) <= h * h
            self.insertions.append((tuple(numbers[i] for i in t), self.add("interior", None, p)))
            numbers.append(self.insertions[-1][1])
            insert(places, full, len(numbers) - 1, p)
        self.cells += [(tuple(numbers[i] for i in t), "C") for t in sorted(full) if inside(t)]
