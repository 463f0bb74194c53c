#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""global_test.py BINARIES: the global strategies from file to verdict. `repaired` is VERIFIED with all its claims, or refused with an
estimate; the paper's parameters stay refuted on the counterexamples, with the refutations expected."""
import os
import re
import sys
import tempfile

from harness import EXAMPLES, Programs, content, last_line

ALL_CLAIMS = ("H-angle H-ball H-offset H-chord L1 L2 L3 L4 L5 L6 L7 L8 L9 L10 L11 L12 L13 L14 L15 L16 L17 L18 L18b L19 L21 L22 L23").split()
HYPOTHESES = "H-angle H-ball H-offset H-chord L1 L21".split()

# Input, beta: the statement that is refuted.
REFUTED = {
    ("w2.smesh", None): "L5", ("w3.smesh", None): "L5", ("g3.smesh", None): "L5",
    ("w2.smesh", "1/3"): "L10", ("w2.smesh", "1/4"): "L10",
    ("w3.smesh", "1/3"): "L18", ("w3.smesh", "1/4"): "L18",
    ("g3.smesh", "1/3"): "L18", ("g3.smesh", "1/4"): "L18",
    ("w3-prime.smesh", "1/3"): "L18", ("w3-prime.smesh", "1/4"): "L18", ("w3-prime.smesh", "1/6"): "L18",
}


def claims_of(path):
    """The claims' IDs besides `conforms`, and what is refuted."""
    lines = content(path).decode("ascii").split("\n")
    claims = [line.split(" ")[1] for line in lines if line.startswith("claim ") and line != "claim conforms"]
    return claims, [line.split(" ")[1] for line in lines if line.startswith("refutes ")]


# Points of theory.md's prototype; None: it has no figure.
REPAIRED = {"cube.off": 1496, "cube-triangles.off": 1496, "tetrahedron.off": 956, "fan.off": 1260, "fan-skew.off": 1664, "wedge-30.off": 18842, "triangle-20.off": None}


def check_repaired(programs, folder):
    out, again = os.path.join(folder, "repaired.cert"), os.path.join(folder, "again.cert")
    for name, expected in REPAIRED.items():
        path = os.path.join(EXAMPLES, name)
        report = programs.expect_verified("repaired " + name, path, out, "--strategy", "repaired", "--threads", 1)
        if report is None:
            continue
        points = report["vertices"] + report["steiner_points"]
        print("repaired %-20s %6d points, estimate %d" % (name, points, report["estimated_points"]), flush=True)
        if expected is not None:
            programs.expect(0.8 * expected <= points <= 1.2 * expected, "%s: %d points instead of about %d" % (name, points, expected))
        programs.expect(points <= report["estimated_points"] * 1.1 and report["estimated_points"] <= 1.3 * points, name + ": the estimate")
        programs.expect(claims_of(out) == (ALL_CLAIMS, []), "%s: claims %s" % (name, claims_of(out)))
        if points < 2000:
            programs.expect_verified(name, path, again, "--strategy", "repaired", "--threads", 2)
            programs.expect(content(again) == content(out), name + ": the bytes depend on the number of threads")
            os.unlink(again)
        os.unlink(out)
    # A hanging edge, and a vertex inside a facet, are protected like everything else.
    pierced = os.path.join(folder, "pierced.obj")
    with open(pierced, "w") as file:
        file.write("v 0 0 0\nv 4 0 0\nv 4 4 0\nv 0 4 0\nv 2 2 0\nv 3 2.5 2\nf 1 2 3 4\nl 5 6\n")
    if programs.expect_verified("pierced", pierced, out, "--strategy", "repaired") is not None:
        programs.expect(claims_of(out) == (ALL_CLAIMS, []), "pierced: claims")
        os.unlink(out)


def check_refusal(programs, folder):
    out = os.path.join(folder, "refused.cert")
    for name, least in (("w2.smesh", 1e9), ("w3.smesh", 1e10)):
        code, text, _ = programs.run("conform", os.path.join(EXAMPLES, name), "--strategy", "repaired", "-o", out)
        match = re.match(r"s UNDECIDED max-points reached=\d+ estimate=(\d+)$", last_line(text))
        programs.expect(code == 3 and match and float(match.group(1)) >= least, "%s repaired: %d %r" % (name, code, last_line(text)))
        programs.expect(not os.path.exists(out), name + ": a certificate is left behind")


def check_refuted(programs, folder):
    out = os.path.join(folder, "refuted.cert")
    for (name, beta), statement in REFUTED.items():
        options = () if beta is None else ("--beta", beta)
        what = "%s %s" % (name, " ".join(options))
        # No limit keeps a refutation from being found: it needs no points.
        code, text, err = programs.run("conform", os.path.join(EXAMPLES, name), "--strategy", "paper", "--max-points", 100, "-o", out, *options)
        programs.expect(code == 1 and last_line(text).startswith("s REFUTED %s cell-" % statement), "%s: exit %d, %r, %r" % (what, code, last_line(text), err[-300:]))
        if not os.path.exists(out):
            continue
        programs.expect(claims_of(out) == (HYPOTHESES, [statement]), "%s: claims %s" % (what, claims_of(out)))
        programs.expect(os.path.getsize(out) < 20000, what + ": the certificate holds the witnesses only")
        code, again, _ = programs.run(out, program=programs.checker)
        programs.expect(code == 1 and last_line(again) == last_line(text), what + ": the checker run by itself")
        os.unlink(out)


def check_usage(programs, folder):
    out = os.path.join(folder, "usage.cert")
    w3 = os.path.join(EXAMPLES, "w3.smesh")
    for options in (("--beta", "1/3"), ("--strategy", "graded", "--beta", "1/3"), ("--strategy", "paper", "--beta", "0.3"), ("--strategy", "paper", "--beta", "1/2"),
                    ("--strategy", "paper", "--beta", "1/0"), ("--strategy", "paper", "--beta", "1/67")):
        code, text, err = programs.run("conform", w3, "-o", out, *options)
        programs.expect(code == 2 and "error[E-USAGE]" in err and "--beta" in err and not os.path.exists(out), "%s: %d %r" % (options, code, err))


def main():
    programs = Programs(sys.argv[1])
    with tempfile.TemporaryDirectory() as folder:
        check_usage(programs, folder)
        check_refusal(programs, folder)
        check_refuted(programs, folder)
        check_repaired(programs, folder)
        programs.expect(not [name for name in os.listdir(folder) if ".cert" in name or "partial" in name], "something is left behind")
    programs.finish()


main()
