#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""json_test.py BINARIES: docs/json.md against what the commands write: every field is documented, every documented field occurs."""
import json
import os
import re
import sys
import tempfile

from harness import EXAMPLES, ROOT, Programs

# Keys that are data: kinds of points and cells, and what confidel-check and campaign.json hold (their own pages).
DATA = {"points_by_kind", "cells_by_kind", "checker", "plan", "parameters", "tetrahedron_corner"}


def sections():
    with open(os.path.join(ROOT, "docs/json.md"), encoding="utf-8") as file:
        text = file.read()
    for part in text.split("\n## ")[1:]:
        match = re.match(r"`confidel ([a-z]+)`|(Bad input)", part)
        yield match.group(1) or match.group(2), part


def keys(value):
    if isinstance(value, dict):
        for key, inner in value.items():
            yield key
            if key not in DATA:
                yield from keys(inner)
    elif isinstance(value, list):
        for inner in value:
            yield from keys(inner)


def main():
    programs = Programs(sys.argv[1])
    seen = {}
    with tempfile.TemporaryDirectory() as folder:
        bad = os.path.join(folder, "bad.off")
        with open(bad, "w") as file:
            file.write("OFF\n3 1 0\n0 0 0\n1 0\n0 1 0\n3 0 1 2\n")
        hanging = os.path.join(folder, "planar.poly")
        with open(hanging, "w") as file:
            file.write("5 2 0 0\n0 0 0\n1 4 0\n2 4 4\n3 0 4\n4 2 0\n5 0\n0 0 1\n1 1 2\n2 2 3\n3 3 0\n4 0 2\n0\n")
        cert, example = os.path.join(folder, "x.cert"), lambda name: os.path.join(EXAMPLES, name)
        out = lambda name: os.path.join(folder, name)
        runs = (("Bad input", 2, ("info", bad)), ("Bad input", 2, ("conform", bad, "-o", cert)), ("info", 0, ("info", example("hanging-edge.obj"))),
                ("info", 0, ("info", hanging)), ("canonical", 0, ("canonical", example("cube.off"), "-o", out("cube.plc"))),
                ("conform", 0, ("conform", example("w3.smesh"), "-o", cert, "--mesh", out("w3.vtu"))),
                ("conform", 3, ("conform", example("w3.smesh"), "-o", cert, "--strategy", "graded", "--max-points", "20")),
                ("audit", 0, ("audit", example("cube.off"), example("cube-mesh.node"))),
                ("audit", 1, ("audit", example("w3.smesh"), out("moved.node"))),
                ("convert", 0, ("convert", example("crossing.poly"), out("c.poly"), "--split-crossings")),
                ("draw", 0, ("draw", cert, "-o", out("picture.html"))),
                ("report", 0, ("report", example("campaign"), "-o", out("report.html"))),
                ("generate", 0, ("generate", "--list")), ("generate", 0, ("generate", "wedge", "--seed", "7", "-o", out("wedge"))),
                ("campaign", 0, ("campaign", "run", "--seeds", "0..3", "--strategy", "lean,graded", "--out", out("runs"))),
                ("campaign", 0, ("campaign", "cover", out("runs"))),
                ("shrink", 0, ("shrink", example("cube.off"), "--keep", "verified", "-o", out("small"))),
                ("falsify", 3, ("falsify", "power", "--strategy", "lean", "--time-limit", "2s", "--out", out("tight"))),
                ("falsify", 1, ("falsify", "L10", "--strategy", "paper", "--time-limit", "60s", "--out", out("found"))),
                ("lemma", 0, ("lemma", "list")), ("lemma", 0, ("lemma", "check", "all", out("graded.cert"))), ("lemma", 1, ("lemma", "check", "L18", os.path.join(ROOT, "tests/certificates/reject/emptiness-in-plane.cert"))),
                ("lemma", 0, ("lemma", "--kernel", "algebraic")), ("lemma", 0, ("lemma", "--kernel", "algebraic", example("tetrahedron.off"))),
                ("paper", 0, ("paper",)), ("explain", 0, ("explain",)), ("explain", 0, ("explain", "L1")))
        programs.expect_verified("graded", example("fan.off"), out("graded.cert"), "--strategy", "graded")
        with open(out("moved.node"), "w") as file:
            file.write("5 3 0 0\n0 0 0 0\n1 10 0 0\n2 0 10 0\n3 0 0 10\n4 5 5 0.000000001\n")
        with open(out("moved.ele"), "w") as file:
            file.write("1 4 0\n0 0 1 2 3\n")
        for name, expected, arguments in runs:
            code, text, _ = programs.run(*arguments, "--json")
            if programs.expect(code == expected, "%s: exit %d" % (arguments, code)):
                seen.setdefault(name, set()).update(keys(json.loads(text)))
    documented = dict(sections())
    programs.expect(set(documented) >= set(seen), "sections: %s" % sorted(set(documented) ^ set(seen)))
    for name, found in seen.items():
        words = set(re.findall(r"`([a-z_0-9]+)`", documented.get(name, "")))
        programs.expect(found <= words, "%s: not in docs/json.md: %s" % (name, sorted(found - words)))
        fields = set(re.findall(r"`([a-z_0-9]+)`", "".join(re.findall(r"^\| (.*?) \|", documented.get(name, ""), re.M))))
        programs.expect(fields <= found, "%s: documented, but never written: %s" % (name, sorted(fields - found)))
    programs.finish()


main()
