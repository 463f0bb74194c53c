#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The tightest object of every lemma over a corpus: writes docs/slacks.md from what confidel-check says of the certificates.

    ./run build && python3 benchmarks/slacks.py
"""
import argparse
import glob
import json
import os
import subprocess
import tempfile

ROOT = os.path.normpath(os.path.join(os.path.dirname(os.path.abspath(__file__)), ".."))
SUFFIXES = (".poly", ".smesh", ".off", ".obj", ".stl", ".ply", ".mesh", ".edg")
LEFT_OUT = ("bent.off", "crossing.poly", "attene-bracket.off")  # invalid on purpose; large


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--binaries", default=os.path.join(ROOT, "build", "release", "bin"))
    parser.add_argument("--data", default=os.path.join(ROOT, "..", "shared", "data"))
    parser.add_argument("--output", default=os.path.join(ROOT, "docs", "slacks.md"))
    arguments = parser.parse_args()
    files = []
    for folder in (os.path.join(ROOT, "examples"), os.path.join(arguments.data, "2d"), os.path.join(arguments.data, "3d")):
        files += sorted(file for file in glob.glob(os.path.join(folder, "*")) if file.endswith(SUFFIXES) and os.path.basename(file) not in LEFT_OUT)
    text = ["# The tightest objects", "",
            "Written by `benchmarks/slacks.py`: what `confidel-check` says of the lemmas that certificates claim ([lemma-claims.md](lemma-claims.md) says what each slack is), over `examples/` and, where they are there, `shared/data/2d` and `3d` (without the bracket). "
            "Slacks near zero are meant to be: sizes take what the lemma allows (L21, H-offset), chords may have the length h exactly (L1, L6)."]
    for strategy, limit in (("graded", 3000000), ("repaired", 30000)):
        total, verified, beyond = {}, 0, 0
        for file in files:
            with tempfile.TemporaryDirectory() as folder:
                done = subprocess.run([os.path.join(arguments.binaries, "confidel"), "conform", file, "-o", os.path.join(folder, "x.cert"), "--strategy", strategy,
                                       "--max-points", str(limit), "--json"], capture_output=True, text=True, stdin=subprocess.DEVNULL)
            report = json.loads(done.stdout)
            if done.returncode == 3:
                beyond += 1
                continue
            assert done.returncode == 0, (file, done.stderr)
            verified += 1
            for claim in report["checker"]["claims"]:
                entry = total.setdefault(claim["id"], {"objects": 0, "failures": 0, "slack": None})
                entry["objects"] += claim["objects"]
                entry["failures"] += claim["failures"]
                if claim["slack"] is not None and (entry["slack"] is None or claim["slack"] < entry["slack"]):
                    entry.update(slack=claim["slack"], file=os.path.basename(file), object=claim["object"])
        text += ["", "## %s" % strategy.capitalize(), "", "%d inputs verified, %d left out for their size (%d points)." % (verified, beyond, limit), "",
                 "| claim | objects | failures | smallest slack | input | object |", "|---|---:|---:|---:|---|---|"]
        for name, entry in total.items():
            text.append("| %s | %d | %d | %s | %s | %s |" % (name, entry["objects"], entry["failures"], "-" if entry["slack"] is None else "%.3g" % entry["slack"],
                                                        entry.get("file", ""), entry.get("object", "")))
    temporary = arguments.output + ".tmp"
    with open(temporary, "w") as file:
        file.write("\n".join(text) + "\n")
    os.replace(temporary, arguments.output)


if __name__ == "__main__":
    main()
