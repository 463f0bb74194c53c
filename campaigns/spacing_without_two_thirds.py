#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The paper's rule h'' <= d_f, without the factor 2/3 of the repaired strategy, on random inputs: which statements are refuted?
--strategy paper --beta 1/3 takes d_f as it is. Prints how often each verdict came, per family and in all (docs/paper-audit.md).

    python3 campaigns/spacing_without_two_thirds.py [--seeds 120] [--max-points 30000]
"""
import argparse
import collections
import glob
import os
import subprocess
import tempfile

ROOT = os.path.normpath(os.path.join(os.path.dirname(os.path.abspath(__file__)), ".."))
FAMILIES = ("fan", "wedge", "star", "sharp-apex", "hovering-at-edge", "hovering-at-vertex", "disjoint-triangles", "boxes", "cospherical")


def verdict(confidel, family, seed, most):
    with tempfile.TemporaryDirectory() as folder:
        subprocess.run([confidel, "generate", family, "--seed", str(seed), "-o", os.path.join(folder, "x")], check=True, capture_output=True)
        source = glob.glob(os.path.join(folder, "x.*"))[0]
        done = subprocess.run([confidel, "conform", source, "-o", os.path.join(folder, "x.cert"), "-q", "-j", "1", "--strategy", "paper", "--beta", "1/3",
                               "--max-points", str(most)], capture_output=True, text=True)
        words = (done.stdout.strip().split("\n")[-1] or "s exit-%d" % done.returncode).split(" ")
        return " ".join(words[1:3]) if words[1] == "REFUTED" else words[1]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--binaries", default=os.path.join(ROOT, "build", "release", "bin"))
    parser.add_argument("--seeds", type=int, default=120)
    parser.add_argument("--max-points", type=int, default=30000)
    arguments = parser.parse_args()
    confidel = os.path.join(arguments.binaries, "confidel")
    total = collections.Counter()
    for family in FAMILIES:
        here = collections.Counter(verdict(confidel, family, seed, arguments.max_points) for seed in range(arguments.seeds))
        print(family, dict(sorted(here.items())), flush=True)
        total += here
    print("all", dict(sorted(total.items())))


main()
