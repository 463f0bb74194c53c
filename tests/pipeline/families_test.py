#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""families_test.py BINARIES [--seeds N] [--first SEED]: the two families on which refinement without protection does not end, VERIFIED by
the lean strategy with local protection alone: 20 random triangles at one vertex, 12 random blades on one edge. CI runs two seeds of
each, --seeds 40 is the whole."""
import argparse
import math
import os
import random
import tempfile
import time

from harness import Programs


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def cones_cross(s, t):
    """Do the sectors that two pairs of directions span cross?"""
    (a, b), (c, d) = s, t
    n, m = cross(a, b), cross(c, d)
    line = cross(n, m)
    for sign in (1, -1):
        x = [sign * value for value in line]
        if dot(cross(a, x), n) > 0 and dot(cross(x, b), n) > 0 and dot(cross(c, x), m) > 0 and dot(cross(x, d), m) > 0:
            return True
    return False


def star(seed, count=20):
    source = random.Random(seed)

    def direction():
        while True:
            p = [source.uniform(-1, 1) for _ in range(3)]
            if 0.1 < dot(p, p) < 1:
                return p

    pairs = []
    while len(pairs) < count:
        pair = (direction(), direction())
        if math.acos(dot(*pair) / math.sqrt(dot(pair[0], pair[0]) * dot(pair[1], pair[1]))) > 1.5:
            continue
        if not any(cones_cross(pair, other) for other in pairs):
            pairs.append(pair)
    vertices = [[0, 0, 0]] + [p for pair in pairs for p in pair]
    return vertices, [(0, 2 * i + 1, 2 * i + 2) for i in range(count)]


def blades(seed, count=12):
    source = random.Random(seed)
    vertices = [[0, 0, 0], [0, 0, 1]]
    for _ in range(count):
        angle, away = source.uniform(0, 2 * math.pi), source.uniform(0.3, 1)
        vertices.append([away * math.cos(angle), away * math.sin(angle), source.uniform(-0.3, 1.3)])
    return vertices, [(0, 1, i + 2) for i in range(count)]


def smesh(vertices, facets):
    lines = ["%d 3 0 0" % len(vertices)]
    lines += ["%d %r %r %r" % (i, *map(float, vertex)) for i, vertex in enumerate(vertices)]
    lines += ["%d 0" % len(facets)] + ["3 %d %d %d" % facet for facet in facets] + ["0"]
    return "\n".join(lines) + "\n"


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("binaries")
    parser.add_argument("--seeds", type=int, default=2)
    parser.add_argument("--first", type=int, default=0)
    arguments = parser.parse_args()
    programs = Programs(arguments.binaries)
    with tempfile.TemporaryDirectory() as folder:
        path, certificate = os.path.join(folder, "in.smesh"), os.path.join(folder, "out.cert")
        for seed in range(arguments.first, arguments.first + arguments.seeds):
            for family in (star, blades):
                with open(path, "w") as file:
                    file.write(smesh(*family(seed)))
                name = "%s %d" % (family.__name__, seed)
                begin = time.time()
                report = programs.expect_verified(name, path, certificate)
                if report is None:
                    continue
                lean = report["lean"]
                print("%-10s %6d points, %d balls, %d rows, %5.1f s" % (name, report["steiner_points"], lean["protected_vertices"],
                                                                      lean["protected_segments"], time.time() - begin), flush=True)
                programs.expect(lean["protected_vertices"] > 0, name + ": no vertex was protected, the family is not what it was")
                programs.expect(not lean["protected_by_graded"], name + ": protection did not stay local: " + lean["reason"])
    programs.finish()


main()
