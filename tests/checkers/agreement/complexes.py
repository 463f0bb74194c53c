# SPDX-License-Identifier: Apache-2.0
"""Small random valid complexes, all from a seed, with small integer or dyadic coordinates: (name, suffix, text)."""
import math
import random


def obj(vertices, faces, lines=()):
    text = "".join("v %s\n" % " ".join("%r" % float(x) for x in vertex) for vertex in vertices)
    text += "".join("f %s\n" % " ".join(str(i + 1) for i in face) for face in faces)
    return text + "".join("l %d %d\n" % (a + 1, b + 1) for a, b in lines)


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def det(a, b, c):
    return sum(x * y for x, y in zip(a, cross(b, c)))


def corner(rnd, size):
    return tuple(rnd.randint(-size, size) for _ in range(3))


def triangle_in(rnd, cell, size):
    """Three points that span a plane, strictly within the cube of the cell's place in a grid; or two."""
    while True:
        a, b, c = (corner(rnd, size) for _ in range(3))
        normal = cross([y - x for x, y in zip(a, b)], [y - x for x, y in zip(a, c)])
        if any(normal):
            return [tuple((2 * size + 1) * place + x for place, x in zip(cell, p)) for p in (a, b, c)]


def cells(rnd, count):
    return rnd.sample([(x, y, z) for x in range(3) for y in range(3) for z in range(3)], count)


def disjoint(rnd):
    """Triangles and hanging edges, each in its own cube."""
    size, vertices, faces, lines = rnd.choice([3, 10, 1000]), [], [], []
    for cell in cells(rnd, rnd.randint(3, 8)):
        first = len(vertices)
        points = triangle_in(rnd, cell, size)
        if rnd.random() < 0.3:
            vertices += points[:2]
            lines.append((first, first + 1))
        else:
            vertices += points
            faces.append((first, first + 1, first + 2))
    return obj(vertices, faces, lines)


def star(rnd):
    """Triangles and hanging edges that share one vertex and nothing else: their arcs on the sphere about it do not meet."""
    size, arcs, rays = rnd.choice([4, 12, 40]), [], []

    def apart(a, b, c, d):
        """The great arcs ab and cd meet neither each other nor each other's reflection (sufficient)."""
        return det(a, b, c) * det(a, b, d) > 0 or det(c, d, a) * det(c, d, b) > 0

    wanted = rnd.randint(2, 5)
    for _ in range(400):
        a, b = corner(rnd, size), corner(rnd, size)
        if len(arcs) < wanted and any(cross(a, b)) and all(apart(a, b, *arc) for arc in arcs):
            arcs.append((a, b))
    for _ in range(rnd.randint(0, 2)):
        e = corner(rnd, size)
        if any(e) and all(det(*arc, e) for arc in arcs) and all(any(cross(e, ray)) for ray in rays):
            rays.append(e)
    vertices, faces, lines = [(0, 0, 0)], [], []
    for a, b in arcs:
        faces.append((0, len(vertices), len(vertices) + 1))
        vertices += [a, b]
    for e in rays:
        lines.append((0, len(vertices)))
        vertices.append(e)
    return obj(vertices, faces, lines)


def book(rnd):
    """Blades at a common edge, in different directions."""
    size, directions = rnd.choice([3, 8, 20]), []
    for _ in range(rnd.randint(2, 6)):
        d = (rnd.randint(-size, size), rnd.randint(-size, size))
        if any(d) and all(d[0] * e[1] != d[1] * e[0] or d[0] * e[0] + d[1] * e[1] < 0 for e in directions):
            directions.append(d)
    vertices = [(0, 0, 0), (0, 0, size)] + [(x, y, rnd.randint(-1, size + 1)) for x, y in directions]
    return obj(vertices, [(0, 1, i + 2) for i in range(len(directions))])


def hanging(rnd):
    """Edges that hang over a square, at dyadic heights; one may stand on its corner."""
    square = [(0, 0, 0), (8, 0, 0), (8, 8, 0), (0, 8, 0)]
    vertices, lines = list(square), []
    for k in range(rnd.randint(1, 3)):
        height = 2.0 ** -rnd.randint(0, 5)
        y = 1 + 2 * k
        lines.append((len(vertices), len(vertices) + 1))
        vertices += [(rnd.randint(0, 3), y, height), (rnd.randint(4, 9), y + rnd.choice([0, 0.5, 1]), height * rnd.choice([1, 1.5]))]
    if rnd.random() < 0.5:
        lines.append((0, len(vertices)))
        vertices.append((rnd.randint(-2, 0), rnd.randint(-2, 0), rnd.randint(1, 4)))
    return obj(vertices, [(0, 1, 2, 3)] if rnd.random() < 0.7 else [(0, 1, 2), (0, 2, 3)], lines)


def soup(rnd):
    """A polygon's triangles in one plane, with a point inside, and blades across: merging coplanar neighbours matters."""
    n, size = rnd.randint(4, 7), rnd.choice([2, 5])
    ring = [(x, y) for x in range(-size, size + 1) for y in range(-size, size + 1) if max(abs(x), abs(y)) == size]
    ring.sort(key=lambda p: math.atan2(p[1], p[0]))
    while True:
        chosen = [ring[i] for i in sorted(rnd.sample(range(len(ring)), n))]
        turns = [a[0] * b[1] - a[1] * b[0] for a, b in zip(chosen, chosen[1:] + chosen[:1])]
        if all(turn > 0 for turn in turns):
            break
    skew = rnd.choice([(0, 0), (1, 0), (1, 2)])
    vertices = [(0, 0, 0)] + [(x, y, skew[0] * x + skew[1] * y) for x, y in chosen]
    faces = [(0, i + 1, (i + 1) % n + 1) for i in range(n)]
    if rnd.random() < 0.6:
        vertices.append((vertices[1][0], vertices[1][1], vertices[1][2] + rnd.choice([1, -2, 0.25])))
        faces.append((0, 1, len(vertices) - 1))
    return obj(vertices, faces)


def planar(rnd):
    """Dimension 2: segments, each in its own square of a grid, some joined to the next one."""
    lines, size = [], rnd.choice([3, 10])
    for cell in rnd.sample([(x, y) for x in range(3) for y in range(3)], rnd.randint(2, 6)):
        while True:
            a, b, c = ([(2 * size + 1) * place + rnd.randint(-size, size) for place in cell] for _ in range(3))
            if a != b and a != c and (b[0] - a[0]) * (c[1] - a[1]) != (b[1] - a[1]) * (c[0] - a[0]):
                break
        lines.append("%d %d %d %d" % (*a, *b))
        if rnd.random() < 0.5:
            lines.append("%d %d %d %d" % (*a, *c))
    return "%d\n" % len(lines) + "\n".join(lines) + "\n"


FAMILIES = ((disjoint, ".obj"), (star, ".obj"), (book, ".obj"), (hanging, ".obj"), (soup, ".obj"), (planar, ".edg"))


def generate(count, seed):
    for k in range(count):
        family, suffix = FAMILIES[k % len(FAMILIES)]
        yield "%s-%d" % (family.__name__, k // len(FAMILIES)), suffix, family(random.Random("%s %d %d" % (family.__name__, seed, k)))
