#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""confidel-check and confidel-check-verified on everything that `confidel conform` writes: the same verdict and rule.

    agreement_test.py BIN VERIFIED [--random 40] [--mutants 10] [--seed 1]

Inputs: examples/, and random complexes (complexes.py). Each is certified by both strategies, with coplanar neighbours merged and not
(where that makes a difference). Both checkers answer to each certificate, alone, with its complex and with another one, and to
mutants of it. Disagreements are kept in the folder `disagreements` of the working directory and make the test fail. A rule that is broken in two
places may be rejected with different lines: these are counted.
Ends with 77 (skipped) when the verified checker is not built: it needs coq and ocaml (./run proofs)."""
import argparse
import collections
import os
import random
import subprocess
import sys
import tempfile
import time

HERE = os.path.dirname(os.path.abspath(__file__))
ROOT = os.path.normpath(os.path.join(HERE, "..", "..", ".."))
sys.path[:0] = [HERE, os.path.join(HERE, "..", "verified"), os.path.join(ROOT, "tests", "pipeline")]
import complexes
import inputs
import mutants

MOST_POINTS = 4000    # more is UNDECIDED, and left out
LARGE = 60000         # bytes of a certificate that gets fewer mutants
OTHER = "plc 1\ndim 3\nvertices 1\nv 0 0 0 1\nsegments 0\nfacets 0\nend\n"


class Comparison:
    def __init__(self, gmp, verified):
        self.gmp, self.verified = gmp, verified
        self.verdicts, self.failures, self.compared, self.other_lines = collections.Counter(), [], 0, 0

    def compare(self, name, path, *options):
        """The common answer; a disagreement is noted and its certificate kept."""
        ours, theirs = mutants.answer(self.gmp, path, *options), mutants.answer(self.verified, path, *options)
        self.compared += 1
        self.verdicts[ours[1].split(" ")[2] if ours[0] == 5 else "exit %d" % ours[0]] += 1
        self.other_lines += ours != theirs and not mutants.differ(ours, theirs)
        if mutants.differ(ours, theirs) or ours[0] not in (0, 2, 3, 5):
            self.fail("%s: confidel-check %s, confidel-check-verified %s" % (name, ours, theirs))
            os.makedirs("disagreements", exist_ok=True)
            with open(path) as source, open(os.path.join("disagreements", name.replace(" ", "_") + ".cert"), "w") as target:
                target.write(source.read())
        return ours

    def fail(self, message):
        self.failures.append(message)
        print("FAILED " + message, flush=True)


def conform(binary, source, certificate, *options):
    # Claims about lemmas are for confidel-check alone.
    done = subprocess.run([binary, "conform", source, "-o", certificate, "-q", "--claims", "conforms", "--max-points", str(MOST_POINTS), *options],
                          capture_output=True, text=True, timeout=300)
    return done.returncode, (done.stdout + done.stderr).strip()


def sources(folder, count, seed):
    examples = os.path.join(ROOT, "examples")
    for name in sorted(inputs.EXAMPLES):
        yield name, os.path.join(examples, name)
    for name, suffix, text in complexes.generate(count, seed):
        path = os.path.join(folder, name + suffix)
        with open(path, "w") as file:
            file.write(text)
        yield name, path


def certificates(confidel, comparison, name, source, folder, tally):
    """(name, path) of every certificate that conform writes for the source; the same bytes only once."""
    seen = set()
    for strategy in ("lean", "graded"):
        for merge in ("on", "off"):
            path = os.path.join(folder, "%s.%s.%s.cert" % (name, strategy, merge))
            code, said = conform(confidel, source, path, "--strategy", strategy, "--merge-coplanar", merge)
            if code == 3:
                tally["undecided"] += 1
            elif code != 0:
                comparison.fail("%s, %s, merge %s: conform ends with %d: %s" % (name, strategy, merge, code, said[-300:]))
            else:
                with open(path) as file:
                    text = file.read()
                if text not in seen:
                    seen.add(text)
                    yield "%s %s merge-%s" % (name, strategy, merge), path, text


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("bin")
    parser.add_argument("verified")
    parser.add_argument("--random", type=int, default=40)
    parser.add_argument("--mutants", type=int, default=10)
    parser.add_argument("--seed", type=int, default=1)
    options = parser.parse_args()
    mutants.skip_without(options.verified)
    confidel = os.path.join(options.bin, "confidel")
    comparison = Comparison(os.path.join(options.bin, "confidel-check"), os.path.abspath(options.verified))
    tally, clock = collections.Counter(), time.time()
    with tempfile.TemporaryDirectory() as folder:
        plc, other, mutant = (os.path.join(folder, name) for name in ("complex.plc", "other.plc", "mutant.cert"))
        with open(other, "w") as file:
            file.write(OTHER)
        for name, source in sources(folder, options.random, options.seed):
            tally["complexes"] += 1
            for title, path, text in certificates(confidel, comparison, name, source, folder, tally):
                tally["certificates"] += 1
                lines = text.split("\n")[:-1]
                with open(plc, "w") as file:
                    file.write("\n".join(lines[1:lines.index("end") + 1]) + "\n")
                if comparison.compare(title, path, "--complex", plc)[0] != 0:
                    comparison.fail(title + ": conform said VERIFIED, confidel-check does not")
                if comparison.compare(title, path, "--complex", other)[1].split(" ")[2:3] != ["complex"]:
                    comparison.fail(title + ": another complex is accepted")
                rnd = random.Random("%d %s" % (options.seed, title))
                for k in range(options.mutants if len(text) < LARGE else min(options.mutants, 3)):
                    with open(mutant, "w") as file:
                        file.write(mutants.mutate(lines, rnd))
                    comparison.compare("%s mutant %d" % (title, k), mutant)
                    tally["mutants"] += 1
    for key, n in sorted(comparison.verdicts.items()):
        print("%6d %s" % (n, key))
    print("%d complexes, %d certificates, %d mutants, %d runs of conform undecided; %d comparisons, %d with different lines, %d failures, %.0f s" % (
        tally["complexes"], tally["certificates"], tally["mutants"], tally["undecided"], comparison.compared, comparison.other_lines, len(comparison.failures), time.time() - clock))
    if tally["certificates"] < tally["complexes"] or comparison.verdicts["exit 0"] == 0:
        comparison.fail("too few certificates to mean anything")
    return 1 if comparison.failures else 0


if __name__ == "__main__":
    sys.exit(main())
