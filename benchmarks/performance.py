#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Side by side in one run: Confidel and its peers, with ratios. Writes docs/performance.md.

    ./run bench                   builds the peers, then this; minutes
    ./run bench --quick           small inputs only
"""
import argparse
import datetime
import glob
import json
import math
import os
import platform
import subprocess
import sys
import tempfile

ROOT = os.path.normpath(os.path.join(os.path.dirname(os.path.abspath(__file__)), ".."))


def run(command, timeout):
    try:
        return subprocess.run(command, stdin=subprocess.DEVNULL, capture_output=True, text=True, timeout=timeout)
    except subprocess.TimeoutExpired:
        return None


def skew_wedge(path, degrees):
    a = math.radians(degrees)
    corners = [(0, 0, 0), (1, 0, 0), (0.5, math.sqrt(0.75), 0), (0.3, math.sqrt(0.75) * math.cos(a), math.sqrt(0.75) * math.sin(a))]
    with open(path, "w") as file:
        file.write("OFF\n4 2 0\n" + "".join("%r %r %r\n" % corner for corner in corners) + "3 0 1 2\n3 0 1 3\n")


def fitted_exponent(pairs):
    pairs = [(math.log(x), math.log(y)) for x, y in pairs if x > 0 and y > 0]
    if len(pairs) < 2:
        return None
    mx, my = sum(p[0] for p in pairs) / len(pairs), sum(p[1] for p in pairs) / len(pairs)
    spread = sum((p[0] - mx) ** 2 for p in pairs)
    return sum((p[0] - mx) * (p[1] - my) for p in pairs) / spread if spread > 0 else None


def check(binaries, certificate, threads=1):
    """Seconds of confidel-check, without the start of the program; the shortest of three runs."""
    times = []
    for _ in range(3):
        done = run([os.path.join(binaries, "confidel-check"), certificate, "--threads", str(threads), "--json"], 600)
        if done is None:
            return math.nan
        times.append(json.loads(done.stdout)["seconds"])
    return min(times)


def reading(binaries, certificate, folder):
    """Seconds of reading alone, with two threads: with a wrong digest at the end, which is the first thing that is tested."""
    with open(certificate, "rb") as file:
        text = file.read()
    path = os.path.join(folder, "digest.cert")
    with open(path, "wb") as file:
        file.write(text[:-2] + (b"1" if text[-2:-1] == b"0" else b"0") + b"\n")
    return check(binaries, path, 2)


def growth(binaries, folder, angles):
    """Graded on skew wedges: one input, more and more points; and checking against CGAL's construction of the same points."""
    yield ("| angle | points | cells | placing s | us per point | certificate bytes | checking s | us per cell | with all lemmas s | reading MB/s | CGAL doubles, building s "
           "| checking : building | with lemmas : building | checking : placing | lemmas alone : placing |")
    yield "|" + "---|" * 15
    placing, checking = [], []
    for degrees in angles:
        source = os.path.join(folder, "wedge.off")
        skew_wedge(source, degrees)
        reports, seconds = {}, {}
        for claims in ("conforms", "lemmas"):
            certificate = os.path.join(folder, claims + ".cert")
            done = run([os.path.join(binaries, "confidel"), "conform", source, "-o", certificate, "--strategy", "graded", "--json", "-j", "1", "--max-points", "0", "--claims", claims], 1200)
            if done is None or done.returncode != 0:
                break
            reports[claims], seconds[claims] = json.loads(done.stdout), check(binaries, certificate)
        if len(seconds) < 2:
            yield "| %g | - |" % degrees + " |" * 13
            continue
        report = reports["lemmas"]
        points, place = report["vertices"] + report["steiner_points"], min(r["seconds"]["placement"] for r in reports.values())
        with open(certificate) as file:
            cells = next(int(line.split()[1]) for line in file if line.startswith("cells "))
        size, read = os.path.getsize(certificate), reading(binaries, certificate, folder)
        peer = run([os.path.join(binaries, "checking-peer"), certificate], 600)
        build = float(peer.stdout.split()[1]) if peer is not None and peer.returncode == 0 else math.nan
        placing.append((points, place))
        checking.append((points, seconds["conforms"]))
        ratio = lambda a, b: a / b if b > 0 else math.nan
        yield "| %g | %d | %d | %.3f | %.1f | %d | %.3f | %.2f | %.3f | %.0f | %.4f | %.2f | %.2f | %.2f | %.2f |" % (
            degrees, points, cells, place, 1e6 * place / points, size, seconds["conforms"], ratio(1e6 * seconds["conforms"], cells), seconds["lemmas"], ratio(size / 1e6, read), build,
            ratio(seconds["conforms"], build), ratio(seconds["lemmas"], build), ratio(seconds["conforms"], place), ratio(seconds["lemmas"] - seconds["conforms"], place))
    for name, pairs in (("placing", placing), ("checking", checking)):
        exponent = fitted_exponent([pair for pair in pairs if pair[0] >= 200])
        if exponent is not None:
            yield ""
            yield "Seconds of %s grow like points^%.2f (fitted above 200 points)." % (name, exponent)


def planar(binaries, files):
    lines, ratios = [], {}
    for file in files:
        done = run([os.path.join(binaries, "planar-peers"), file], 300)
        if done is None:
            lines.append("| %s | not within 300 s |" % os.path.basename(file))
            continue
        for line in done.stdout.splitlines():
            if line.startswith("median ratio "):
                name, value = line[len("median ratio "):].rsplit(": ", 1)
                ratios.setdefault(name, []).append(float(value))
            elif line.startswith("|") and line not in lines:  # the table's head comes once
                lines.append(line)
    yield from lines
    yield ""
    for name, values in ratios.items():
        values = sorted(v for v in values if math.isfinite(v))
        if values:
            yield "* median ratio, %s: %.3g (%d inputs)" % (name, (values[(len(values) - 1) // 2] + values[len(values) // 2]) / 2, len(values))


def conform(binaries, source, folder, *options):
    done = run([os.path.join(binaries, "confidel"), "conform", source, "-o", os.path.join(folder, "x.cert"), "--json", *options], 1800)
    return None if done is None else json.loads(done.stdout)


def large(binaries, folder, angles):
    """Whole runs on all processors: what limits size."""
    yield "| angle | points | cells | placing s | writing s | checking s | all s | peak memory, bytes per point | certificate, bytes per point | verdict |"
    yield "|" + "---|" * 10
    source = os.path.join(folder, "wedge.off")
    for degrees in angles:
        skew_wedge(source, degrees)
        report = conform(binaries, source, folder, "--strategy", "graded", "--max-points", "4000000")
        if report is None or "cells" not in report:
            yield "| %g | refused: about %.3g points expected |" % (degrees, report["estimated_points"] if report else math.nan) + " |" * 7 + " %s |" % (report["verdict"] if report else "-")
            continue
        points, seconds = report["vertices"] + report["steiner_points"], report["seconds"]
        yield "| %g | %d | %d | %.1f | %.1f | %.1f | %.1f | %.0f | %.0f | %s |" % (
            degrees, points, report["cells"], seconds["placement"], seconds["write"], seconds["check"], seconds["total"], report["peak_memory_bytes"] / points,
            report["certificate"]["text_bytes"] / points, report["verdict"])


def wedge(size, corner, degrees):
    a = math.radians(degrees)
    return [tuple(size * x + o for x, o in zip(p, corner)) for p in ((0, 0, 0), (1, 0, 0), (0.4, 1, 0), (0.6, math.cos(a), math.sin(a)))]


SCALES = {
    "two wedges of size 1": [wedge(1, (0, 0, 0), 2), wedge(1, (5, 0, 1), 2)],
    "the same, 1e9 apart": [wedge(1, (0, 0, 0), 2), wedge(1, (1e9, 0, 1e8), 2)],
    "one of 1e-9 beside one of 1e9": [wedge(1e-9, (0, 0, 0), 2), wedge(1e9, (1e9, 0, 1e8), 2)],
    "300 m in UTM coordinates, at the origin": [wedge(300, (0, 0, 0), 1)],
    "300 m in UTM coordinates": [wedge(300, (2.4e6, 5.1e6, 100.123456789), 1)],
    "0.1 degrees": [wedge(1, (0, 0, 0), 0.1)],
    "0.001 degrees": [wedge(1, (0, 0, 0), 0.001)],
}


def scales(binaries, folder, names):
    yield "| input | strategy | points | placing s | checking s | verdict |"
    yield "|" + "---|" * 6
    source = os.path.join(folder, "scales.off")
    for name in names:
        wedges = SCALES[name]
        with open(source, "w") as file:
            file.write("OFF\n%d %d 0\n" % (4 * len(wedges), 2 * len(wedges)) + "".join("%r %r %r\n" % p for w in wedges for p in w))
            file.write("".join("3 %d %d %d\n3 %d %d %d\n" % (4 * i, 4 * i + 1, 4 * i + 2, 4 * i, 4 * i + 1, 4 * i + 3) for i in range(len(wedges))))
        for strategy in ("lean", "graded"):
            report = conform(binaries, source, folder, "--strategy", strategy, "--max-points", "2000000")
            if report is None:
                continue
            points = report["vertices"] + report["steiner_points"] if "steiner_points" in report else "about %.3g expected" % report["estimated_points"]
            yield "| %s | %s | %s | %.2f | %s | %s |" % (name, strategy, points, report["seconds"]["placement"], "%.2f" % report["seconds"]["check"] if "steiner_points" in report else "-", report["verdict"])


def predicates(binaries):
    """benchmarks/predicates.cpp, as a table: nanoseconds."""
    done = run([os.path.join(binaries, "predicate-times"), "--benchmark_format=json", "--benchmark_min_time=0.2"], 600)
    if done is None or done.returncode != 0:
        yield "(Google Benchmark is not installed: libbenchmark-dev)"
        return
    times, kinds = {}, []
    for entry in json.loads(done.stdout)["benchmarks"]:
        predicate, kind, whose = entry["name"].split("/")
        times[predicate, kind, whose] = entry["cpu_time"]
        if (predicate, kind) not in kinds:
            kinds.append((predicate, kind))
    yield "| predicate | points | Confidel | CGAL, doubles | CGAL, exact | Confidel : CGAL, exact |"
    yield "|" + "---|" * 6
    for predicate, kind in sorted(kinds):
        own, doubles, exact = (times.get((predicate, kind, whose)) for whose in ("confidel", "CGAL, doubles", "CGAL, exact"))
        number = lambda t: "-" if t is None else "%.0f" % t
        yield "| %s | %s | %s | %s | %s | %s |" % (predicate, kind, number(own), number(doubles), number(exact), "-" if exact is None else "%.2f" % (own / exact))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--binaries", default=os.path.join(ROOT, "build", "release", "bin"))
    parser.add_argument("--data", default=os.path.join(ROOT, "..", "shared", "data", "2d"))
    parser.add_argument("--output", default=os.path.join(ROOT, "docs", "performance.md"))
    parser.add_argument("--quick", action="store_true")
    arguments = parser.parse_args()
    files = sorted(glob.glob(os.path.join(arguments.data, "*.poly")) + glob.glob(os.path.join(arguments.data, "*.edg")))
    source = "`../shared/data/2d`"
    if not files:
        files, source = sorted(glob.glob(os.path.join(ROOT, "examples", "*.poly"))), "`examples` (shared/data/2d is not here)"
        files = [file for file in files if "facet-parts" not in file]
    if arguments.quick:
        files = [file for file in files if os.path.getsize(file) < 20000]
    angles = (40, 10, 5) if arguments.quick else (40, 20, 10, 5, 2.5, 1.25, 0.8, 0.5, 0.25, 0.135)
    text = ["# Performance, side by side", "",
            "Written by `./run bench%s` on %s: %s, %d processors, load %.1f at the beginning. Ratios matter, not seconds: peers run in the same minutes on the same machine."
            % (" --quick" if arguments.quick else "", datetime.date.today().isoformat(), platform.processor() or platform.machine(), os.cpu_count(), os.getloadavg()[0]), "",
            "## Growth, and the price of checking", "",
            "Graded on the skew wedge (two triangles at one edge), smaller and smaller angles. \"Building\" is the time in which CGAL's inexact-constructions kernel builds the Delaunay tetrahedralization of the same points; it proves nothing about them. "
            "Checking is `confidel-check` on one thread (the shortest of three runs, without the start of the program), reading included (the column of megabytes per second: reading alone, with a second thread for SHA-256): of `--claims conforms`, then with all claims about lemmas.", ""]
    with tempfile.TemporaryDirectory() as folder:
        for line in growth(arguments.binaries, folder, angles):
            text.append(line)
            print(line, flush=True)
    text += ["", "## Planar strategies and CGAL's conformers", "",
             "Inputs: %s. Steiner points (seconds of placing). CGAL's `make_conforming_Delaunay_2` and `make_conforming_Gabriel_2` over its exact kernel and over doubles; only with the exact kernel do they conform on all inputs. "
             "Lean splits a segment only where no empty disk supports it; graded protects everything, also edges that need nothing." % source, ""]
    for line in planar(arguments.binaries, files):
        text.append(line)
        print(line, flush=True)
    sections = [("Large inputs", "Graded on the same wedge, whole runs on all processors. Beyond `--max-points` the answer is UNDECIDED with an estimate.", large, ((0.5,) if arguments.quick else (0.5, 0.25, 0.1, 0.075, 0.01),)),
                ("Small angles, and scales", "Wedges again. Of a detail below 2^-48 of the whole extent the checker's grid sees nothing: it is searched exactly (docs/trust.md, \"Details\").",
                 scales, ([name for name in SCALES if not arguments.quick or name != "0.1 degrees"],))]
    with tempfile.TemporaryDirectory() as folder:
        for title, about, table, more in sections:
            text += ["", "## " + title, "", about, ""]
            for line in table(arguments.binaries, folder, *more):
                text.append(line)
                print(line, flush=True)
    text += ["", "## Predicates", "", "Nanoseconds of one call (`predicate-times`, Google Benchmark). Clear: random points, which the filter decides. Tie: corners of boxes with short coordinates. "
             "CGAL's are those of its two standard kernels on the same points.", ""]
    for line in predicates(arguments.binaries):
        text.append(line)
        print(line, flush=True)
    temporary = arguments.output + ".tmp"
    with open(temporary, "w") as file:
        file.write("\n".join(text) + "\n")
    os.replace(temporary, arguments.output)


if __name__ == "__main__":
    sys.exit(main())
