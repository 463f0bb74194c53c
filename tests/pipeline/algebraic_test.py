#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""`confidel lemma --kernel algebraic FILE`: the lemmas on points that are exactly where the paper wants them, next to the rational ones.

  algebraic_test.py BIN"""
import json
import math
import os
import sys
import tempfile

from harness import EXAMPLES, Programs, last_line


def report_of(programs, name, path, *options, code=0):
    done, out, err = programs.run("lemma", "--kernel", "algebraic", path, "--json", *options)
    if not programs.expect(done == code, "%s: exit %d, not %d: %s" % (name, done, code, err[-300:])):
        return None
    report = json.loads(out)
    report["rows"] = {row["id"]: row for row in report["lemmas"]}
    return report


def test_repaired(programs, name, path, divided):
    """Everything holds; what the paper says with = does so exactly, and the rational kernel misses it by its rounding only."""
    report = report_of(programs, name, path)
    if report is None:
        return None
    programs.expect(report["good"] and report["strategy"] == "repaired", name + ": not good")
    rows = report["rows"]
    programs.expect(len(rows) == 28, "%s: %d lemmas" % (name, len(rows)))
    left_out = {"L20"} if report["filled"] else {"L8", "L16", "L17", "L19", "L20", "L23"}
    for lemma, row in rows.items():
        if lemma in left_out:
            programs.expect(row["verdict"] == "not tested" and row["reason"], "%s: %s is tested" % (name, lemma))
            continue
        programs.expect(row["verdict"] == "holds" and row["failures"] == 0, "%s, %s: %s" % (name, lemma, row))
        programs.expect(row["rational"] is not None and row["rational"]["failures"] == 0, "%s, %s: %s" % (name, lemma, row))
        programs.expect(row["slack"] is None or row["slack"] >= 0, "%s, %s: a negative slack that holds" % (name, lemma))
    # Equality where the paper has it: on every object, and at the pair that makes the constant.
    by_chord = "2 r sin" in report["parameters"]["h"]
    for lemma in ("H-ball", "H-offset", "H-chord" if by_chord else "L14"):
        programs.expect(0 < rows[lemma]["objects"] and (rows[lemma]["equalities"] == rows[lemma]["objects"] or lemma == "L14" and rows[lemma]["equalities"] > 0), "%s, %s: %s" % (name, lemma, rows[lemma]))
    programs.expect(rows["L21"]["equalities"] > 0 and rows["L21"]["slack"] == 0, "%s: r is not a third of the least distance" % name)
    equal = {equality["statement"]: equality for equality in report["equalities"]}
    programs.expect(len(equal) >= 5 and all(e["exact"] == e["objects"] for e in equal.values() if e["everywhere"]), "%s: %s" % (name, equal))
    programs.expect(all(e["rational_deviation"] < 1e-5 for e in equal.values()), "%s: the rational strategy rounds too much" % name)
    if divided:
        programs.expect(rows["L1"]["equalities"] == rows["L1"]["objects"] and all(e["exact"] == e["objects"] for e in equal.values()), "%s: chords are not h" % name)
    # Static cells have nearly the same slack in both kernels.
    for lemma in ("L5", "L7", "L9", "L10") if by_chord else ("L5", "L7"):
        exact, rational = rows[lemma]["slack"], rows[lemma]["rational"]["slack"]
        programs.expect((exact is None) == (rational is None) and (exact is None or math.isclose(exact, rational, rel_tol=2e-2, abs_tol=1e-6)), "%s, %s: %s and %s" % (name, lemma, exact, rational))
    return report


def test_paper(programs):
    """The paper's parameters fail where the rational run says so."""
    for example, beta, statement in (("w3.smesh", "1/3", "L18"), ("w3.smesh", "1/4", "L18"), ("w3.smesh", "", "L5"), ("w2.smesh", "1/4", "L10"), ("g3.smesh", "1/3", "L18")):
        name = "%s, beta %s" % (example, beta or "as printed")
        report = report_of(programs, name, os.path.join(EXAMPLES, example), "--strategy", "paper", *(["--beta", beta] if beta else []), code=1)
        if report is None:
            continue
        row = report["rows"][statement]
        programs.expect(report["refutes"] == statement and row["failures"] > 0 and (row["rational"]["failures"] > 0 or statement == "L5"), "%s: %s" % (name, row))
        if statement in ("L10", "L18"):
            programs.expect(report["rows"]["L10"]["failures"] > 0, "%s: L10 %s" % (name, report["rows"]["L10"]))
        programs.expect(all(e["exact"] == e["objects"] for e in report["equalities"] if e["everywhere"]), "%s: hypotheses do not hold exactly" % name)


def test_limits(programs, folder):
    path = os.path.join(EXAMPLES, "cube.off")
    code, out, _ = programs.run("lemma", "--kernel", "algebraic", path, "--max-points", "100")
    programs.expect(code == 3 and last_line(out).startswith("s UNDECIDED max-points reached=500"), "a limit: exit %d, %r" % (code, out))
    code, out, _ = programs.run("lemma", "--kernel", "algebraic", os.path.join(EXAMPLES, "w3.smesh"), "--json")
    programs.expect(code == 3 and json.loads(out)["verdict"].startswith("s UNDECIDED max-points"), "W3, repaired: exit %d, %r" % (code, out))
    for arguments in (["--kernel", "algebraic", os.path.join(EXAMPLES, "house.poly")], ["--kernel", "algebraic", path, "--beta", "1/3"], [path],
                      ["--kernel", "algebraic", os.path.join(folder, "none.off")]):
        code, _, err = programs.run("lemma", *arguments)
        programs.expect(code in (2, 4) and "error[" in err, "%s: exit %d, %r" % (arguments, code, err))
    first = programs.run("lemma", "--kernel", "algebraic", path, "--max-points", "500")
    programs.expect(first == programs.run("lemma", "--kernel", "algebraic", path, "--max-points", "500"), "two runs differ")


def main():
    programs = Programs(sys.argv[1])
    with tempfile.TemporaryDirectory() as folder:
        # Two triangles with one edge in common, 30 degrees apart, the other apexes not opposite.
        wedge = os.path.join(folder, "wedge-30.off")
        with open(wedge, "w") as file:
            file.write("OFF\n4 2 0\n0 0 0\n4 0 0\n1 4 0\n2.5 3.4641016151377544 2\n3 0 1 2\n3 0 1 3\n")
        for name, path, divided in (("tetrahedron", os.path.join(EXAMPLES, "tetrahedron.off"), True), ("cube", os.path.join(EXAMPLES, "cube.off"), True),
                                    ("fan", os.path.join(EXAMPLES, "fan.off"), False), ("fan, skew", os.path.join(EXAMPLES, "fan-skew.off"), False),
                                    ("skew wedge", wedge, False), ("flagpole", os.path.join(EXAMPLES, "flagpole.obj"), False)):
            test_repaired(programs, name, path, divided)
        test_paper(programs)
        test_limits(programs, folder)
    programs.finish()


main()
