#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""`confidel lemma` and confidel-check, which share no code, on the same certificates: objects, failures and slacks of every claim agree.

  lemmas_test.py BIN"""
import hashlib
import json
import os
import sys
import tempfile

import inputs
from harness import EXAMPLES, ROOT, Programs, last_line

LEMMAS = ["H-angle", "H-ball", "H-offset", "H-chord"] + ["L%d" % n for n in range(1, 19)] + ["L18b"] + ["L%d" % n for n in range(19, 24)]
GRADED = ["H-ball", "H-offset", "L5", "L7", "L9", "L10", "L11", "L12", "L13", "L16", "L17", "L18", "L18b", "L19", "L21", "L22"]
CERTIFICATES = os.path.join(ROOT, "tests", "certificates")


def compare(programs, name, certificate):
    """Both tables; the verdicts of the claims agree, and what was counted. Returns the checker's exit code, or None if it ended early."""
    code, out, _ = programs.run(certificate, "--json", program=programs.checker)
    checker = json.loads(out)
    rule = checker.get("rule") if code == 5 else None
    ours_code, out, err = programs.run("lemma", "check", "all", certificate, "--json")
    if not programs.expect(ours_code in (0, 1), "%s: lemma check ends with %d: %s" % (name, ours_code, err[-300:])):
        return code
    ours = {entry["id"]: entry for entry in json.loads(out)["lemmas"]}
    for claim in checker.get("claims", []):
        if claim["id"] == rule:  # rejected: it ended there
            continue
        own = ours[claim["id"]]
        programs.expect(own["claimed"] and own.get("objects") == claim["objects"] and own.get("failures") == 0, "%s, %s: %s, the checker %s" % (name, claim["id"], own, claim))
        one, other = own.get("slack"), claim["slack"]
        # Slacks are rounded: the checker's below 1e-12 are rounding alone.
        same = (one is None) == (other is None) and (one is None or abs(one - other) <= max(1e-12, 1e-3 * max(abs(one), abs(other))))
        programs.expect(same, "%s, %s: slack %s, the checker %s" % (name, claim["id"], one, other))
    if code == 0:
        programs.expect(ours_code == 0, "%s: verified, but lemma check ends with %d" % (name, ours_code))
    with open(certificate, "rb") as file:
        refutes = b"\nrefutes " in file.read()
    if rule in LEMMAS and not refutes:  # a bad refutation is rejected under its own ID, whether the lemma holds or not
        entry = ours[rule]
        programs.expect(entry["verdict"] != "holds", "%s: the checker rejects %s, lemma check says that it holds" % (name, rule))
    return code


def test_examples(programs, folder):
    for example in sorted(inputs.EXAMPLES):
        certificate = os.path.join(folder, example + ".cert")
        if programs.expect_verified(example, os.path.join(EXAMPLES, example), certificate, "--strategy", "graded") is None:
            continue
        with open(certificate) as file:
            claims = [line.split()[1] for line in file if line.startswith("claim ")]
        # Vertices that lie alone in a facet are corners of C cells: the lemmas on kinds are not about these.
        lonely = example.endswith(".poly")
        programs.expect(set(claims) >= {"conforms", "L18", "L18b", "L19", "L22"} if lonely else claims == ["conforms"] + GRADED, "%s: claims %s" % (example, claims))
        compare(programs, example, certificate)


def test_manifest(programs):
    """Certificates made by hand, good and bad."""
    claimed = 0
    with open(os.path.join(CERTIFICATES, "MANIFEST.tsv")) as file:
        for line in file:
            fields = line.rstrip("\n").split("\t")
            if line.startswith("#") or len(fields) < 3 or fields[1] not in ("0", "1", "5"):
                continue
            path = os.path.join(CERTIFICATES, fields[0])
            with open(path, "rb") as certificate:
                text = certificate.read()
            if b"\nclaim L" in text or b"\nclaim H" in text:
                claimed += 1
                compare(programs, fields[0], path)
    print("%d certificates of the manifest make claims about lemmas" % claimed)


def sealed(lines):
    """The text of the lines with the right digest."""
    body = "".join(line + "\n" for line in lines[:-1])
    end = lines[-1].split(" ")
    end[-1] = hashlib.sha256(body.encode()).hexdigest()
    return body + " ".join(end) + "\n"


def test_failures(programs, folder):
    """What is claimed of too many objects, or with parameters by a hair too large, fails in both."""
    good = os.path.join(folder, "cube.off.cert")
    with open(good) as file:
        lines = file.read().split("\n")[:-1]

    def scaled(line, field, numerator, denominator):
        fields = line.split(" ")
        top, bottom = (int(part, 16) for part in fields[field].split("/"))
        from fractions import Fraction
        value = Fraction(top * numerator, bottom * denominator)
        fields[field] = "%x/%x" % (value.numerator, value.denominator)
        return " ".join(fields)

    def spoil(name, change, lemma):
        bad = os.path.join(folder, name + ".cert")
        with open(bad, "w") as file:
            file.write(sealed(change(list(lines))))
        code, out, _ = programs.run(bad, program=programs.checker)
        programs.expect(code == 5 and last_line(out).split(" ")[2] == lemma, "%s: confidel-check says %s" % (name, last_line(out)))
        code, out, _ = programs.run("lemma", "check", lemma, bad)
        programs.expect(code == 1, "%s: lemma check %s ends with %d: %s" % (name, lemma, code, out))

    def replace(prefix, function):
        def change(text):
            at = next(i for i, line in enumerate(text) if line.startswith(prefix))
            text[at] = function(text[at])
            return text
        return change
    spoil("count", replace("claim L9 ", lambda line: "claim L9 %d" % (int(line.split(" ")[2]) + 1)), "L9")
    # delta_v / 3 is attained: a ball larger by 2^-38 is too large.
    spoil("ball", replace("ball ", lambda line: scaled(line, 2, 2**38 + 1, 2**38)), "L21")
    spoil("ball-far", replace("ball ", lambda line: scaled(line, 2, 17, 16)), "H-ball")
    spoil("row", replace("row ", lambda line: scaled(line, 2, 32, 33)), "H-offset")


def test_command(programs, folder):
    code, out, _ = programs.run("lemma", "list", "--json")
    entries = json.loads(out)
    programs.expect(code == 0 and [entry["id"] for entry in entries] == LEMMAS, "lemma list")
    programs.expect(all(entry["statement"] and entry["section"] and entry["exact_form"] for entry in entries), "lemma list: every field")
    certificate = os.path.join(folder, "cube.off.cert")
    code, out, _ = programs.run("lemma", "check", "L10", certificate)
    programs.expect(code == 0 and "L10" in out, "lemma check L10")
    programs.expect(programs.run("lemma", "check", "L1", certificate)[0] == 1, "lemma check of a statement whose parameter is missing")
    programs.expect(programs.run("lemma", "check", "L99", certificate)[0] == 2, "lemma check of an unknown lemma")
    programs.expect(programs.run("lemma", "check", "all", os.path.join(folder, "none.cert"))[0] == 4, "lemma check of a missing file")
    programs.expect(programs.run("lemma", "check", "all", os.path.join(EXAMPLES, "cube.off"))[0] == 2, "lemma check of what is no certificate")
    # Every byte of a small certificate changed: an answer or an error, never a crash.
    with open(os.path.join(folder, "tetrahedron.off.cert"), "rb") as file:
        text = file.read()
    broken = os.path.join(folder, "broken.cert")
    for at in range(0, len(text), max(1, len(text) // 60)):
        with open(broken, "wb") as file:
            file.write(text[:at] + bytes([text[at] ^ 1]) + text[at + 1:])
        code, _, err = programs.run("lemma", "check", "all", broken)
        programs.expect(code in (0, 1, 2), "byte %d changed: exit %d, %s" % (at, code, err[-200:]))
    for options, claims in ((["--strategy", "graded", "--claims", "conforms"], 1), ([], 1), (["--claims", "lemmas"], 5)):
        programs.expect_verified("claims", os.path.join(EXAMPLES, "cube.off"), broken, *options)
        with open(broken) as file:
            programs.expect(sum(line.startswith("claim ") for line in file) == claims, "%s: not %d claims" % (options, claims))


def test_algebraic(programs, folder):
    """Exact roots against what rational points leave of the same slacks: placements round within a small part of h."""
    code, out, err = programs.run("lemma", "--kernel", "algebraic", "--json")
    if not programs.expect(code == 0, "lemma --kernel algebraic: exit %d, %s" % (code, err)):
        return
    report = json.loads(out)
    programs.expect(report["good"] and len(report["statements"]) == 7 and all(s["holds"] and s["comparisons"] > 3 for s in report["statements"]), "extremal statements")
    certificate = os.path.join(folder, "repaired.cert")
    if programs.expect_verified("tetrahedron, repaired", os.path.join(EXAMPLES, "tetrahedron.off"), certificate, "--strategy", "repaired") is None:
        return
    compare(programs, "tetrahedron, repaired", certificate)
    code, out, _ = programs.run("lemma", "check", "all", certificate, "--json")
    slacks = {entry["id"]: entry.get("slack") for entry in json.loads(out)["lemmas"]}
    for lemma, exact in report["tetrahedron_corner"]["slack"].items():
        print("%s at the tetrahedron's vertices: %.6f with exact roots, %.6f with rational points" % (lemma, exact, slacks[lemma]))
        programs.expect(abs(slacks[lemma] - exact) <= 1e-2 * exact, "%s: slack %s with exact roots, %s with rational points" % (lemma, exact, slacks[lemma]))
    programs.expect(programs.run("lemma", "--kernel", "algebraic", "list")[0] == 2, "--kernel algebraic with a command")


def main():
    programs = Programs(sys.argv[1])
    with tempfile.TemporaryDirectory() as folder:
        test_examples(programs, folder)
        test_manifest(programs)
        test_failures(programs, folder)
        test_command(programs, folder)
        test_algebraic(programs, folder)
    programs.finish()


main()
