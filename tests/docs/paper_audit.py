#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The tables in docs/paper-audit.md are what `confidel paper` prints today, and say what they must: paper_audit.py BIN [--update]"""
import json
import os
import re
import subprocess
import sys
import tempfile

ROOT = os.path.normpath(os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", ".."))
PAGE = os.path.join(ROOT, "docs", "paper-audit.md")
MARKS = ("<!-- confidel paper begin -->\n", "<!-- confidel paper end -->\n")

# What must never change: these inputs refute the paper's parameters. (L5 is the printed d_e.)
REFUTED = {("corner-45.poly", ""): "L5", ("w2.smesh", ""): "L5", ("w3.smesh", ""): "L5", ("g3.smesh", ""): "L5", ("w2.smesh", "1/3"): "L10", ("w2.smesh", "1/4"): "L10",
           ("w3.smesh", "1/3"): "L18", ("w3.smesh", "1/4"): "L18", ("g3.smesh", "1/3"): "L18", ("g3.smesh", "1/4"): "L18",
           ("w3-prime.smesh", "1/3"): "L18", ("w3-prime.smesh", "1/4"): "L18", ("w3-prime.smesh", "1/6"): "L18"}

failures = []


def expect(good, message):
    if not good:
        failures.append(message)
        print("FAILED " + message)


def run(program, *arguments):
    return subprocess.run([program, *arguments], check=False, capture_output=True, text=True)


def check_report(binaries):
    with tempfile.TemporaryDirectory() as folder:
        done = run(os.path.join(binaries, "confidel"), "paper", "--json", "-o", folder)
        expect(done.returncode == 0, "exit code %d: %s" % (done.returncode, done.stderr[-500:]))
        report = json.loads(done.stdout)
        runs = {(r["input"], r["beta"]): r["checker"] for r in report["runs"] if r["strategy"] == "paper"}
        expect(set(runs) == set(REFUTED), "the runs with the paper's parameters")
        for key, statement in REFUTED.items():
            expect(runs.get(key, "").startswith("s REFUTED %s " % statement), "%s: %s" % (key, runs.get(key)))
        repaired = [r["checker"] for r in report["runs"] if r["strategy"] == "repaired"]
        expect(len(repaired) >= 6 and set(repaired) == {"s VERIFIED"}, "repaired runs: %s" % repaired)
        for row in report["statements"]:
            expect(row["verdict"] in ("holds", "refuted", "refuted; holds repaired"), "%s %s: %s" % (row["section"], row["statement"], row["verdict"]))
            expect(row["evidence"], row["statement"] + ": no evidence")
        # The certificates are those that the table speaks of, and nothing else is left.
        names = sorted(os.listdir(folder))
        expect(len(names) == len(report["runs"]) and all(name.endswith(".cert") for name in names), "certificates: %s" % names)
        for name in names:
            code = run(os.path.join(binaries, "confidel-check"), os.path.join(folder, name)).returncode
            expect(code == (0 if "repaired" in name else 1), "%s: exit code %d" % (name, code))


def main():
    binaries = sys.argv[1]
    done = run(os.path.join(binaries, "confidel"), "paper")
    expect(done.returncode == 0 and done.stdout.startswith("| section |"), "confidel paper: %d %s" % (done.returncode, done.stderr[-500:]))
    with open(PAGE, encoding="utf-8") as file:
        text = file.read()
    head, rest = text.split(MARKS[0])
    old, tail = rest.split(MARKS[1])
    new = done.stdout
    if "--update" in sys.argv:
        with open(PAGE, "w", encoding="utf-8") as file:
            file.write(head + MARKS[0] + new + MARKS[1] + tail)
    else:
        # Slacks are rounded and may differ in a digit on another machine; everything else is the same.
        digits = re.compile(r"(slack|>=) -?[0-9.e+-]+")
        for line, (a, b) in enumerate(zip(old.split("\n"), new.split("\n"))):
            expect(digits.sub("", a) == digits.sub("", b), "docs/paper-audit.md is not what `confidel paper` prints (--update writes it): table line %d" % (line + 1))
        expect(old.count("\n") == new.count("\n"), "docs/paper-audit.md has other lines than `confidel paper` prints (--update writes it)")
    check_report(binaries)
    print("%d failures" % len(failures))
    sys.exit(1 if failures else 0)


main()
