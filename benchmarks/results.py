#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Measures `confidel conform` on ../shared/data/3d and examples/, and writes docs/results.md.

    ./run results                 everything; the largest input takes minutes
    ./run results --quick         without the slow inputs
"""
import argparse
import datetime
import fnmatch
import json
import os
import platform
import re
import subprocess
import sys
import tempfile

ROOT = os.path.normpath(os.path.join(os.path.dirname(os.path.abspath(__file__)), ".."))
SUFFIXES = (".poly", ".smesh", ".off", ".obj", ".stl", ".ply", ".mesh")
SLOW = ("attene-bracket.off",)
INVALID = ("bent.off", "crossing.poly")  # examples of what `convert` repairs
STAGES = ("read", "features", "placement", "write", "check")


class Strategy:
    def __init__(self, title, note, options):
        self.title, self.note, self.options = title, note, options


def run(command, timeout=None):
    return subprocess.run(command, stdin=subprocess.DEVNULL, capture_output=True, text=True, timeout=timeout)


def strategies(confidel):
    """What this build of confidel offers."""
    usage = run([confidel, "conform", "--help"]).stdout
    names = re.search(r"--strategy\b[^{]*\{([^}]*)\}", usage)
    names = names.group(1).split(",") if names else ["graded"]
    merging = "--merge-coplanar" in usage

    def options(name, merge):
        return ["--strategy", name] + (["--merge-coplanar", merge] if merging else [])

    result = [Strategy("graded", "every input facet kept", options("graded", "off"))]
    if "lean" in names and merging:
        result.append(Strategy("lean, merged", "exactly coplanar neighbours are one facet", options("lean", "on")))
        result.append(Strategy("lean, not merged", "every input facet kept", options("lean", "off")))
    elif "lean" in names:
        result.append(Strategy("lean", "every input facet kept", options("lean", "off")))
    return result


def inputs(arguments):
    """(name shown, path) and notes about what is absent."""
    found, notes = [], []
    for label, folder in (("shared/data/3d", arguments.data), ("examples", os.path.join(ROOT, "examples"))):
        files = sorted(os.listdir(folder)) if os.path.isdir(folder) else []
        files = [file for file in files if file.endswith(SUFFIXES) and file not in INVALID and fnmatch.fnmatch(file, arguments.only)]
        if not files:
            notes.append("Nothing from `%s`: %s." % (label, "no file is wanted" if os.path.isdir(folder) else "the folder is absent here"))
        for file in files:
            if arguments.quick and file in SLOW:
                notes.append("`%s` was left out (`--quick`)." % file)
            else:
                found.append((file if label != "examples" else "examples/" + file, os.path.join(folder, file)))
    return found, notes


def conform(confidel, path, strategy, arguments, folder):
    """The report of one run; always with verdict and exit."""
    command = [confidel, "conform", path, "-o", os.path.join(folder, "result.cert"), "--json", "--time-limit", str(arguments.time_limit)]
    command += strategy.options + (["--threads", str(arguments.threads)] if arguments.threads else [])
    try:
        done = run(command, arguments.time_limit * 1.5 + 60)
    except subprocess.TimeoutExpired:
        return {"verdict": "no answer in time", "exit": None}
    try:
        return json.loads(done.stdout)
    except ValueError:
        first = done.stderr.strip().split("\n")[0]
        code = re.search(r"error\[(E-[A-Z]+)\]", first)
        return {"verdict": code.group(1) if code else first[:60] or "no report", "exit": done.returncode}


def count(value):
    return "" if value is None else format(round(value), ",")


def seconds(value):
    return "" if value is None else "%.2f" % value if value < 9.95 else "%.0f" % value


def size(value):
    if value is None:
        return ""
    for unit, scale in (("GB", 1e9), ("MB", 1e6), ("kB", 1e3)):
        if value >= scale:
            return "%.3g %s" % (value / scale, unit) if value < 99.5 * scale else "%.0f %s" % (value / scale, unit)
    return "%d B" % value


def power(value):
    return "%.2g" % value if isinstance(value, (int, float)) else ""


def verdict(report):
    text = report["verdict"]
    return text[2:] if text.startswith("s ") else "%s (exit %s)" % (text, report["exit"])


def construction(report):
    return sum(report["seconds"].get(stage, 0) for stage in STAGES[:-1])


def row(name, facts, report):
    used = report.get("seconds", {})
    ratio = "%.2f" % (used["check"] / construction(report)) if "check" in used and construction(report) > 0 else ""
    cells = [name, count(facts.get("triangles")), count(report.get("facets")), count(report.get("steiner_points")), count(report.get("estimated_points")),
             count(report.get("cells"))]
    cells += [seconds(used.get(stage)) for stage in STAGES] + [ratio, size(report.get("peak_memory_bytes")),
                                                               size(report.get("certificate", {}).get("bytes")), power(report.get("smallest_relative_power")),
                                                               verdict(report)]
    return "| " + " | ".join(cells) + " |\n"


HEADS = ["file", "triangles", "facets", "Steiner points", "estimate"] + ["cells"] + list(STAGES) + [
    "check : rest", "peak memory", "certificate", "smallest relative power", "verdict"]


def heading(heads):
    return "| " + " | ".join(heads) + " |\n|" + "---|" * len(heads) + "\n"


def machine():
    model = "unknown processor"
    memory = ""
    try:
        model = re.search(r"model name\s*: (.*)", open("/proc/cpuinfo").read()).group(1)
        memory = ", %.0f GB" % (int(re.search(r"MemTotal:\s*(\d+)", open("/proc/meminfo").read()).group(1)) / 1e6)
    except (OSError, AttributeError):
        pass
    return "%s, %d logical processors%s, %s" % (model, os.cpu_count() or 0, memory, platform.system() + " " + platform.release())


def compared(results, chosen):
    """Steiner points and seconds of all strategies side by side."""
    text = heading(["file"] + [title for s in chosen for title in (s.title, "s")])
    for name, _, reports in results:
        cells = [name]
        for report in reports:
            good = report["verdict"] == "s VERIFIED"
            cells += [count(report.get("steiner_points")) if good else verdict(report), seconds(report.get("seconds", {}).get("total"))]
        text += "| " + " | ".join(cells) + " |\n"
    return text


def page(results, chosen, notes, command, load):
    text = "# Results\n\nWritten by `%s` (benchmarks/results.py) on %s. Do not edit.\n\n" % (command, datetime.date.today().isoformat())
    for i, strategy in enumerate(chosen):
        verified = sum(reports[i]["verdict"] == "s VERIFIED" for _, _, reports in results)
        text += "* **%s** (%s): %d of %d VERIFIED.\n" % (strategy.title, strategy.note, verified, len(results))
    text += "* Machine: %s. Load average at the beginning %.1f. Such machines are shared and noisy: use the ratios, not the seconds.\n" % (machine(), load)
    text += "".join("* %s\n" % note for note in notes) + "\n"
    if len(chosen) > 1:
        text += "## Steiner points by strategy\n\n`s`: seconds for everything, the check included. Where the verdict is not VERIFIED, it stands instead.\n\n"
        text += compared(results, chosen) + "\n"
    text += """## Columns

triangles: of the input's facets, triangulated · facets: after merging, if any · estimate: all points, vertices included, as foreseen early in the run, or the
number itself where the run ended before an estimate was due · cells: triangles of the certificate · read ... check: seconds by stage; `check` is the separate program on the written
file · check : rest: its seconds over those of the four stages before · peak memory: of the producer · smallest relative power: how close the nearest point off
the plane comes to a sphere, relative to the sphere's radius squared (docs/certificate-format.md).

"""
    for i, strategy in enumerate(chosen):
        text += "## %s\n\n`confidel conform FILE -o CERT %s`\n\n" % (strategy.title.capitalize(), " ".join(strategy.options)) + heading(HEADS)
        text += "".join(row(name, facts, reports[i]) for name, facts, reports in results) + "\n"
    return text.rstrip("\n") + "\n"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--quick", action="store_true", help="leave out the slow inputs: " + ", ".join(SLOW))
    parser.add_argument("--time-limit", type=float, default=1200, metavar="SECONDS", help="for each run (default 1200)")
    parser.add_argument("--threads", type=int, default=0, help="default: as many as there are")
    parser.add_argument("--only", default="*", metavar="PATTERN", help="only files whose name matches")
    parser.add_argument("--bin", default=os.path.join(ROOT, "build", "release", "bin"), help="where confidel is")
    parser.add_argument("--data", default=os.path.join(ROOT, "..", "shared", "data", "3d"), help="further inputs (default ../shared/data/3d)")
    parser.add_argument("--output", default=os.path.join(ROOT, "docs", "results.md"))
    arguments = parser.parse_args()
    confidel = os.path.join(arguments.bin, "confidel")
    if not os.access(confidel, os.X_OK):
        parser.error("no program %s; ./run build makes it" % confidel)
    load = os.getloadavg()[0]
    chosen = strategies(confidel)
    files, notes = inputs(arguments)
    if not files:
        parser.error("no input: " + " ".join(notes))
    results = []
    with tempfile.TemporaryDirectory() as folder:
        for name, path in files:
            about = run([confidel, "info", path, "--json"] + (["--merge-coplanar", "off"] if len(chosen) > 1 else []))
            facts = json.loads(about.stdout) if about.returncode == 0 else {}
            reports = []
            for strategy in chosen:
                reports.append(conform(confidel, path, strategy, arguments, folder))
                print("%-36s %-18s %9s points %8s s  %s" % (name, strategy.title, count(reports[-1].get("steiner_points")),
                                                           seconds(reports[-1].get("seconds", {}).get("total")), verdict(reports[-1])), file=sys.stderr)
            results.append((name, facts, reports))
    command = "./run results" + (" --quick" if arguments.quick else "") + (" --only '%s'" % arguments.only if arguments.only != "*" else "")
    partial = arguments.output + ".partial"
    with open(partial, "w") as file:
        file.write(page(results, chosen, notes, command, load))
    os.replace(partial, arguments.output)
    return 0


if __name__ == "__main__":
    sys.exit(main())
