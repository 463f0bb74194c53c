#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The planar strategies end to end: random PSLGs with small angles through every strategy, the bound of circumradii, the refutation of
the printed d_e, the refusal with an estimate. usage: planar_test.py BINARIES [SEEDS [FIRST]]"""
import math
import os
import random
import sys
import tempfile

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from harness import EXAMPLES, Programs, last_line


def side(x, y, z):
    d = (y[0] - x[0]) * (z[1] - x[1]) - (y[1] - x[1]) * (z[0] - x[0])
    return (d > 0) - (d < 0)


def on_segment(x, y, z):
    return side(x, y, z) == 0 and min(x[0], y[0]) <= z[0] <= max(x[0], y[0]) and min(x[1], y[1]) <= z[1] <= max(x[1], y[1])


def crosses(p, q, a, b):
    if len({p, q, a, b}) < 4:  # they share an end: only an overlap matters
        common = ({p, q} & {a, b}).pop()
        x, y = ({p, q} - {common}).pop(), ({a, b} - {common}).pop()
        return side(common, x, y) == 0 and (x[0] - common[0]) * (y[0] - common[0]) + (x[1] - common[1]) * (y[1] - common[1]) > 0
    return (side(p, q, a) * side(p, q, b) < 0 and side(a, b, p) * side(a, b, q) < 0) or \
        on_segment(p, q, a) or on_segment(p, q, b) or on_segment(a, b, p) or on_segment(a, b, q)


def pslg(seed):
    """A few points, segments that do not cross: on even seeds in a coarse grid, small enough for global parameters; else in a fine one, now
    and then with a bundle of edges at angles of few degrees."""
    rng = random.Random(seed)
    if seed % 2 == 0:
        points = [(6 * i + rng.randrange(-2, 3) / 2, 6 * j + rng.randrange(-2, 3) / 2) for i in range(2) for j in range(2)]
        points = points[:rng.randrange(3, 5)]
        return poly(points, [tuple(rng.sample(range(len(points)), 2)) for _ in range(4)])
    points = list({(rng.randrange(24), rng.randrange(24)) for _ in range(rng.randrange(3, 8))})
    if rng.random() < 0.4:
        centre = points[0]
        start = rng.uniform(0, 6.28)
        for i in range(rng.randrange(2, 4)):
            angle = start + math.radians(i * rng.uniform(1, 4))
            length = rng.uniform(8, 20)
            points.append((centre[0] + round(length * math.cos(angle) * 64) / 64, centre[1] + round(length * math.sin(angle) * 64) / 64))
        wanted = [(0, len(points) - 1 - i) for i in range(2)]
    else:
        wanted = []
    wanted += [tuple(rng.sample(range(len(points)), 2)) for _ in range(8)]
    return poly(points, wanted)


def poly(points, wanted):
    segments = []
    for a, b in wanted:
        p, q = points[a], points[b]
        if p == q or {a, b} in [set(s) for s in segments]:
            continue
        if any(crosses(p, q, points[c], points[d]) for c, d in segments):
            continue
        # No vertex on a segment: that would split it, which is legal but tested elsewhere.
        if any(i not in (a, b) and on_segment(p, q, x) for i, x in enumerate(points)):
            continue
        segments.append((a, b))
    lines = ["%d 2 0 0" % len(points)] + ["%d %r %r" % (i + 1, p[0], p[1]) for i, p in enumerate(points)]
    lines += ["%d 0" % len(segments)] + ["%d %d %d" % (i + 1, a + 1, b + 1) for i, (a, b) in enumerate(segments)] + ["0"]
    return "\n".join(lines) + "\n"


def main():
    programs = Programs(sys.argv[1])
    seeds = int(sys.argv[2]) if len(sys.argv) > 2 else 25
    first = int(sys.argv[3]) if len(sys.argv) > 3 else 0
    verdicts = {}
    with tempfile.TemporaryDirectory() as folder:
        certificate = os.path.join(folder, "x.cert")
        for seed in range(first, first + seeds):
            path = os.path.join(folder, "%d.poly" % seed)
            with open(path, "w") as file:
                file.write(pslg(seed))
            for strategy in ("lean", "graded", "saalfeld", "repaired"):
                code, out, err = programs.run("conform", path, "-o", certificate, "--strategy", strategy, "--max-points", 8000, "-j", 1)
                verdict = last_line(out)
                limited = code == 3 and verdict.startswith("s UNDECIDED max-points") and strategy in ("repaired", "saalfeld")
                programs.expect((code == 0 and verdict == "s VERIFIED") or limited, "seed %d, %s: exit %d, %r %r" % (seed, strategy, code, verdict, err[-200:]))
                verdicts[strategy, verdict.split(" ")[1]] = verdicts.get((strategy, verdict.split(" ")[1]), 0) + 1
        print(verdicts)
        programs.expect(verdicts.get(("repaired", "VERIFIED"), 0) * 4 >= seeds, "too few inputs are small enough for the repaired strategy")

        corner = os.path.join(EXAMPLES, "corner-45.poly")
        code, out, _ = programs.run("conform", corner, "-o", certificate, "--strategy", "paper")
        programs.expect(code == 1 and last_line(out).startswith("s REFUTED L5 "), "corner-45, paper: exit %d, %r" % (code, last_line(out)))
        code, out, _ = programs.run(certificate, program=programs.checker)
        programs.expect(code == 1 and last_line(out).startswith("s REFUTED L5 "), "corner-45, checker alone: exit %d, %r" % (code, last_line(out)))
        programs.expect_verified("corner-45, beta = phi/3", corner, certificate, "--strategy", "paper", "--beta", "1/3")
        report = programs.expect_verified("corner-45, R <= 1/4", corner, certificate, "--strategy", "repaired", "--max-circumradius", "0.25")
        if report:
            claims = {claim["id"]: claim for claim in report["checker"]["claims"]}
            for name in ("H-angle", "H-ball", "L1", "L2", "L3", "L4", "L5", "L6", "L7", "L8", "L9", "L17", "L18", "L19", "L20", "L21", "L23"):
                programs.expect(name in claims and claims[name]["failures"] == 0 and claims[name]["objects"] > 0, "corner-45: claim " + name)
        for name in ("courtyard.poly", "star-1.poly"):
            for strategy in ("lean", "graded"):
                programs.expect_verified(name + ", " + strategy, os.path.join(EXAMPLES, name), certificate, "--strategy", strategy)
        code, out, _ = programs.run("conform", os.path.join(EXAMPLES, "star-1.poly"), "-o", os.path.join(folder, "none.cert"), "--strategy", "repaired")
        programs.expect(code == 3 and "estimate=" in last_line(out), "star-1, repaired: exit %d, %r" % (code, last_line(out)))
        programs.expect(not os.path.exists(os.path.join(folder, "none.cert")), "a refused run leaves no file")
    programs.finish()


if __name__ == "__main__":
    main()
