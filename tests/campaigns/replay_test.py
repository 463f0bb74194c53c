#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Fixed seeds of every family, both strategies, with the metamorphic variants of some: replay_test.py BIN"""
import os
import subprocess
import sys
import tempfile

# (first and last seed, further options): all families have their turn in each.
CAMPAIGNS = [("1000000..1000101", ["--strategy", "lean,graded", "--max-points", "1500", "--oracle", "150"]),
             ("2000000..2000033", ["--strategy", "lean", "--max-points", "500", "--metamorphic"])]
# Seeds that were answered wrongly once (docs/campaigns.md).
FOUND = [("3975..3975", ["--family", "planar-mutated", "--strategy", "lean,graded", "--max-points", "20000"]),
         ("813..813", ["--family", "planar-mutated", "--strategy", "lean,graded", "--max-points", "3000"]),
         ("6802..6802", ["--family", "two-skeleton", "--strategy", "lean,graded", "--max-points", "3000"]),
         ("741..741", ["--family", "mutated", "--strategy", "lean,graded,repaired", "--max-points", "3000"])]


def main():
    confidel = os.path.join(os.path.abspath(sys.argv[1]), "confidel")
    families = len(subprocess.run([confidel, "generate", "--list"], capture_output=True, text=True, check=True).stdout.splitlines())
    failures = 0
    with tempfile.TemporaryDirectory() as folder:
        for number, (seeds, options) in enumerate(CAMPAIGNS + FOUND):
            first, last = map(int, seeds.split(".."))
            if number < len(CAMPAIGNS) and last - first + 1 < families:
                print("FAILED %s: %d families are more than these seeds" % (seeds, families))
                failures += 1
            out = os.path.join(folder, str(number))
            run = subprocess.run([confidel, "campaign", "run", "--seeds", seeds, "--out", out, "--shrink-time", "20", *options], text=True)
            cover = subprocess.run([confidel, "campaign", "cover", out], text=True)
            failures += run.returncode != 0 or cover.returncode != 0
    sys.exit(1 if failures else 0)


main()
