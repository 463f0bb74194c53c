#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Coverage-guided fuzzing with clang's libFuzzer, under the address and undefined behaviour sanitizers: nightly.py [TARGET ...] [--seconds 300]

Targets: the readers poly, smesh, off, obj, edg, stl, ply, mesh, and checker (the certificate's reader and all rules). Needs clang and the libraries that
./run installs. What it finds is in build/fuzz/TARGET-* and makes it fail. --keep N puts up to N small new inputs per target, those that reach most, into corpus/,
which replay_test.py feeds to the ordinary programs."""
import argparse
import concurrent.futures
import glob
import os
import shutil
import signal
import subprocess
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
ROOT = os.path.normpath(os.path.join(HERE, "..", ".."))
BUILD = os.path.join(ROOT, "build", "fuzz")
READERS = ("poly", "smesh", "off", "obj", "edg", "stl", "ply", "mesh")
FLAGS = ["-std=c++20", "-O1", "-g1", "-w", "-fsanitize=fuzzer-no-link,address,undefined", "-fno-sanitize-recover=undefined", "-fno-sanitize=function,vptr", "-ffp-contract=off", "-I", ROOT]
LARGEST = 4096


def compile_one(source):
    target = os.path.join(BUILD, os.path.relpath(source, ROOT).replace("/", "-") + ".o")
    cache = ["ccache"] if shutil.which("ccache") else []
    for command in [*cache, "clang++"], ["clang++"]:
        done = subprocess.run([*command, *FLAGS, "-c", source, "-o", target], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
        if done.returncode == 0:
            return target
        ended = signal.Signals(-done.returncode).name if done.returncode < 0 else "exit code %d" % done.returncode
        print("%s: %s: %s\n%s" % (os.path.relpath(source, ROOT), " ".join(command), ended, done.stdout[-3000:] or "(it said nothing)"), file=sys.stderr, flush=True)
        if done.stdout.strip():  # else it was ended from outside, or the cache failed: once more without it
            break
    raise RuntimeError("%s cannot be compiled" % source)


def program(name, sources, libraries, jobs):
    path = os.path.join(BUILD, name)
    with concurrent.futures.ThreadPoolExecutor(jobs) as pool:
        objects = list(pool.map(compile_one, sources))
    subprocess.run(["clang++", "-fsanitize=fuzzer,address,undefined", *objects, *libraries, "-o", path], check=True)
    return path


def sources_of(*patterns, without=()):
    return sorted(path for pattern in patterns for path in glob.glob(os.path.join(ROOT, pattern)) if os.path.basename(path) not in without)


def build(jobs, wanted):
    os.makedirs(BUILD, exist_ok=True)
    programs = {}
    if set(wanted) & set(READERS):
        # With the planar layer, which the validity test needs nothing of, left out.
        programs["reader"] = program("fuzz-reader", [os.path.join(HERE, "reader_fuzz.cpp"), *sources_of("core/numbers/*.cpp", "core/complex/*.cpp", "core/io/*.cpp", "campaigns/instance.cpp")],
                                     ["-lgmpxx", "-lgmp", "-lmpfr", "-lfmt", "-lcrypto"], jobs)
    if "checker" in wanted:
        programs["checker"] = program("fuzz-checker", [os.path.join(HERE, "checker_fuzz.cpp"), *sources_of("checkers/gmp/*.cpp", without=("main.cpp", "limits.cpp"))],
                                      ["-lgmp", "-lzstd", "-lcrypto", "-lpthread"], jobs)
    return programs


def seeds_for(target, confidel):
    """A folder of inputs to begin with: the tests' and examples, and some generated ones."""
    folder = os.path.join(BUILD, "seeds-" + target)
    os.makedirs(folder, exist_ok=True)
    if target == "checker":
        found = glob.glob(os.path.join(ROOT, "tests", "certificates", "*", "*.cert"))
    else:
        found = glob.glob(os.path.join(ROOT, "examples", "*." + target)) + glob.glob(os.path.join(ROOT, "tests", "**", "*." + target), recursive=True)
        if os.access(confidel, os.X_OK) and target in ("poly", "smesh", "obj"):
            for seed in range(60):
                subprocess.run([confidel, "generate", "all", "--seed", str(seed), "-o", os.path.join(folder, "generated-%d" % seed)], check=True)
    for number, path in enumerate(sorted(found)):
        if os.path.getsize(path) <= LARGEST:
            shutil.copy(path, os.path.join(folder, "%d-%s" % (number, os.path.basename(path))))
    for path in glob.glob(os.path.join(HERE, "corpus", target, "*")):
        shutil.copy(path, folder)
    for path in glob.glob(os.path.join(folder, "generated-*")):
        if not path.endswith("." + target):
            os.remove(path)
    return folder


def fuzz(target, path, seconds, confidel, keep):
    corpus = os.path.join(BUILD, "corpus-" + target)
    os.makedirs(corpus, exist_ok=True)
    seeds = seeds_for(target, confidel)
    environment = dict(os.environ, CONFIDEL_FUZZ_FORMAT=target, UBSAN_OPTIONS="print_stacktrace=1")
    prefix = os.path.join(BUILD, target + "-")
    command = [path, corpus, seeds, "-max_total_time=%d" % seconds, "-max_len=%d" % LARGEST, "-timeout=10", "-rss_limit_mb=2048", "-artifact_prefix=" + prefix, "-print_final_stats=1", "-verbosity=0"]
    with open(os.path.join(BUILD, target + ".log"), "w") as log:
        code = subprocess.run(command, env=environment, stdout=log, stderr=subprocess.STDOUT).returncode
    runs = [line.split()[-1] for line in open(os.path.join(BUILD, target + ".log"), errors="replace") if "number_of_executed_units" in line]
    print("%-8s %s: %s runs, %d inputs in the corpus" % (target, "good" if code == 0 else "FAILED, see build/fuzz/%s.log" % target, runs[0] if runs else "?", len(os.listdir(corpus))), flush=True)
    if keep and code == 0:
        small = os.path.join(BUILD, "small-" + target)
        shutil.rmtree(small, ignore_errors=True)
        os.makedirs(small)
        subprocess.run([path, "-merge=1", "-max_len=700", "-verbosity=0", small, corpus], env=environment, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        target_folder = os.path.join(HERE, "corpus", target)
        os.makedirs(target_folder, exist_ok=True)
        for name in sorted(os.listdir(small), key=lambda name: os.path.getsize(os.path.join(small, name)))[-keep:]:
            shutil.copy(os.path.join(small, name), target_folder)
    return code == 0


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("targets", nargs="*", default=[])
    parser.add_argument("--seconds", type=int, default=300, help="for each target")
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--keep", type=int, default=0)
    parser.add_argument("--bin", default=os.path.join(ROOT, "build", "release", "bin"))
    options = parser.parse_args()
    wanted = options.targets or [*READERS, "checker"]
    if set(wanted) - {*READERS, "checker"}:
        parser.error("targets are " + ", ".join([*READERS, "checker"]))
    programs = build(options.jobs, wanted)
    with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
        good = list(pool.map(lambda target: fuzz(target, programs["checker" if target == "checker" else "reader"], options.seconds, os.path.join(options.bin, "confidel"), options.keep), wanted))
    return 0 if all(good) else 1


if __name__ == "__main__":
    sys.exit(main())
