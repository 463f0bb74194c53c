#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""command_line_test.py BINARIES: exit codes, last lines and what is left behind, of `confidel conform` under limits, interruption, bad
input and missing parts."""
import json
import os
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import time

import inputs
from harness import EXAMPLES, Programs, content, last_line

W3 = os.path.join(EXAMPLES, "w3.smesh")
W3_PRIME = os.path.join(EXAMPLES, "w3-prime.smesh")
GRADED = ("--strategy", "graded")  # many points where long runs are wanted


def check_limits(programs, folder):
    out = os.path.join(folder, "limited.cert")
    for options, reason in ((("--max-points", 500), "max-points"), (("--time-limit", "0.3", "--max-points", 0), "time-limit"),
                            (("--memory-limit", "8M"), "memory-limit")):
        code, text, _ = programs.run("conform", W3_PRIME, "-o", out, *GRADED, *options)
        pattern = r"s UNDECIDED %s reached=\d+( estimate=\d+)?$" % reason
        programs.expect(code == 3 and re.match(pattern, last_line(text)), "%s: %d %r" % (options, code, last_line(text)))
        programs.expect(os.listdir(folder) == [], "%s: something is left behind: %s" % (options, os.listdir(folder)))
    code, text, err = programs.run("conform", W3_PRIME, "-o", out, *GRADED, "--max-points", 500, "--json")
    report = json.loads(text)
    programs.expect(code == 3 == report["exit"] and report["verdict"] == last_line(err), "--max-points with --json")
    programs.expect(report["verdict"].startswith("s UNDECIDED max-points") and report["points_reached"] > 0, "the report of a limit")
    # A limit that is not reached changes nothing.
    first, second = os.path.join(folder, "first.cert"), os.path.join(folder, "second.cert")
    programs.expect_verified("limits out of reach", W3, first, "--max-points", 20000, "--time-limit", "5m", "--memory-limit", "2G")
    programs.expect_verified("no limits", W3, second, "--max-points", 0)
    programs.expect(content(first) == content(second), "limits out of reach change the certificate")
    os.unlink(first)
    os.unlink(second)


def check_estimate(programs, folder):
    """Graded says early how many points it expects: within a factor of 3; an UNDECIDED run says so too."""
    out, sharp = os.path.join(folder, "estimated.cert"), os.path.join(folder, "sharp.off")
    with open(sharp, "w") as file:
        file.write(inputs.wedge(0.5, 0.3))
    for path in (W3, W3_PRIME, sharp):
        report = programs.expect_verified(path, path, out, *GRADED)
        points, estimate = report["vertices"] + report["steiner_points"], report["estimated_points"]
        programs.expect(points / 3 <= estimate <= points * 3, "%s: estimate %g for %d points" % (path, estimate, points))
        code, text, _ = programs.run("conform", path, "-o", out, *GRADED, "--max-points", points // 4)
        match = re.match(r"s UNDECIDED max-points reached=(\d+) estimate=(\d+)$", last_line(text))
        programs.expect(code == 3 and match and int(match.group(2)) > points // 4, "%s: no estimate: %r" % (path, last_line(text)))
        os.unlink(out)
    # Found by `confidel falsify estimate`: sheets 0.2 degrees apart, an edge between them with a narrow strip. It passes 4 million points.
    with open(sharp, "w") as file:
        file.write("OFF\n5 4 0\n-21 34 35\n62 -16 49\n-30 29 39\n8 -4 51\n-32 -12 62\n3 0 1 2\n3 0 2 3\n3 0 3 4\n3 0 4 2\n")
    code, text, _ = programs.run("conform", sharp, "-o", out, *GRADED, "--max-points", 1000000)
    match = re.match(r"s UNDECIDED max-points reached=(\d+) estimate=(\d+)$", last_line(text))
    programs.expect(code == 3 and match and int(match.group(1)) < 100000 and int(match.group(2)) > 4000000, "fan: the estimate is too low: %r" % last_line(text))
    os.unlink(sharp)


def check_files(programs, folder):
    out = os.path.join(folder, "out.cert")
    missing = os.path.join(folder, "missing.smesh")
    for arguments, expected in (((missing, "-o", out), 4), ((folder + "/.", "-o", out), None), ((W3, "-o", os.path.join(folder, "no", "x.cert")), 4)):
        code, text, err = programs.run("conform", *arguments)
        programs.expect(code == expected if expected else code in (2, 4), "%s: exit code %d" % (arguments, code))
        programs.expect("error[E-" in err and "\ns " not in "\n" + text, "%s: an error and no verdict" % (arguments,))
        programs.expect(os.listdir(folder) == [], "%s: something is left behind: %s" % (arguments, os.listdir(folder)))
    # What stands at the output's name stays as it is until a new certificate is complete.
    with open(out, "w") as file:
        file.write("mine\n")
    for arguments, expected in (((missing,), 4), ((W3_PRIME, *GRADED, "--max-points", 100), 3)):
        code, _, _ = programs.run("conform", *arguments, "-o", out)
        programs.expect(code == expected and content(out) == b"mine\n", "%s: the old file is gone" % (arguments,))
    programs.expect_verified("overwrite", os.path.join(EXAMPLES, "cube.off"), out)
    programs.expect(content(out).startswith(b"confidel-certificate 1\n"), "a new certificate replaces the old file")
    os.unlink(out)


BAD = {
    "crossing.off": ("OFF\n6 2 0\n0 0 0\n4 0 0\n0 4 0\n1 1 -1\n1 1 1\n2 1 1\n3 0 1 2\n3 3 4 5\n", "E-CROSSING"),
    "not-planar.off": ("OFF\n4 1 0\n0 0 0\n1 0 0\n1 1 1\n0 1 0\n4 0 1 2 3\n", "E-NONCOPLANAR"),
    "twice.off": ("OFF\n4 1 0\n0 0 0\n1 0 0\n0 1 0\n1 0 0\n3 0 1 2\n", "E-DUPLICATE-VERTEX"),
    "index.off": ("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n", "E-INDEX"),
    "flat.off": ("OFF\n3 1 0\n0 0 0\n1 0 0\n2 0 0\n3 0 1 2\n", "E-DEGENERATE-FACET"),
    "short.off": ("OFF\n3 1 0\n0 0 0\n1 0\n0 1 0\n3 0 1 2\n", "E-"),
    "empty.smesh": ("", "E-"),
}


def check_bad_input(programs, folder):
    with tempfile.TemporaryDirectory() as made:
        for name, (text, error) in BAD.items():
            path = os.path.join(made, name)
            with open(path, "w") as file:
                file.write(text)
            for extra in ((), ("--json",)):
                code, out, err = programs.run("conform", path, "-o", os.path.join(folder, "bad.cert"), *extra)
                programs.expect(code == 2 and "error[" + error in err, "%s: %d %r" % (name, code, err))
                programs.expect("\ns " not in "\n" + out, name + ": a verdict about bad input")
                programs.expect(os.listdir(folder) == [], name + ": something was written")
    out = os.path.join(folder, "usage.cert")
    for arguments in ((), ("conform",), ("conform", W3), ("conform", W3, "-o", out, "--nonsense"), ("conform", W3, "-o", out, "--threads", "x"),
                      ("conform", W3, "-o", out, "--max-points", "-1"), ("conform", W3, "-o", out, "--strategy", "none"), ("nonsense", W3)):
        code, _, err = programs.run(*arguments)
        programs.expect(code == 2 and "error[E-USAGE]" in err, "%s: %d %r" % (arguments, code, err))
        programs.expect(os.listdir(folder) == [], "%s: something was written" % (arguments,))


def check_missing_checker(programs, folder):
    """Without the checker program there is no verdict, whatever the rest believes."""
    with tempfile.TemporaryDirectory() as elsewhere:
        alone = os.path.join(elsewhere, "confidel")
        shutil.copy2(programs.confidel, alone)
        out = os.path.join(folder, "unchecked.cert")
        cube = os.path.join(EXAMPLES, "cube.off")
        code, text, err = programs.run("conform", cube, "-o", out, program=alone, env={"PATH": elsewhere})
        programs.expect(code in (4, 70) and "confidel-check" in err and "error[" in err, "without checker: %d %r" % (code, err))
        programs.expect("VERIFIED" not in text and "VERIFIED" not in err, "without checker: a verdict nevertheless")
        for path in os.listdir(folder):
            os.unlink(os.path.join(folder, path))
        # A checker that says no, or nothing, or dies, is believed: its answer is the verdict, and our certificate is at fault.
        for script, expected in (("exit 0", 70), ("echo 's REJECTED emptiness 7 cell-0-point-1' >&2; exit 5", 70), ("kill -9 $$", 70),
                                 ("echo 's UNDECIDED too-large' >&2; exit 3", 3)):
            fake = os.path.join(elsewhere, "confidel-check")
            with open(fake, "w") as file:
                file.write("#!/bin/sh\n%s\n" % script)
            os.chmod(fake, 0o755)
            code, text, err = programs.run("conform", cube, "-o", out, program=alone)
            programs.expect("VERIFIED" not in text, "checker `%s`: the verdict is not the checker's" % script)
            if expected is not None:
                programs.expect(code == expected, "checker `%s`: exit %d" % (script, code))
            for path in os.listdir(folder):
                os.unlink(os.path.join(folder, path))


def running_checkers(folder):
    """Processes whose command line names the folder: what an interrupted run left running."""
    found = []
    for entry in os.listdir("/proc"):
        try:
            if entry.isdigit() and int(entry) != os.getpid() and folder.encode() in content("/proc/%s/cmdline" % entry):
                found.append(int(entry))
        except OSError:
            pass
    return found


def check_interruption(programs, folder):
    """SIGINT and SIGTERM during placement; SIGINT while the checker runs."""
    with tempfile.TemporaryDirectory() as made:
        path = os.path.join(made, "sharp.off")
        with open(path, "w") as file:
            file.write(inputs.wedge(0.25, 0.3))
        for number, delay in ((signal.SIGINT, 0.05), (signal.SIGINT, 1.0), (signal.SIGTERM, 0.5)):
            out = os.path.join(folder, "interrupted.cert.zst")
            process = subprocess.Popen([programs.confidel, "conform", path, "-o", out, *GRADED], stdout=subprocess.PIPE, stderr=subprocess.PIPE)
            time.sleep(delay)
            programs.expect(process.poll() is None, "the long run is over after %g s: choose a longer one" % delay)
            process.send_signal(number)
            text, _ = process.communicate()
            programs.expect(process.returncode == 130, "signal %d after %g s: exit %d" % (number, delay, process.returncode))
            programs.expect(b"\ns " not in b"\n" + text, "signal %d: a verdict nevertheless" % number)
            programs.expect(os.listdir(folder) == [], "signal %d: left behind: %s" % (number, os.listdir(folder)))
    check_interruption_of_writing(programs, folder)


def check_interruption_of_writing(programs, folder):
    """Interrupted as soon as a file appears: it is gone, or it is a complete certificate."""
    for wanted in (".cert.partial", ".plc.partial"):
        out = os.path.join(folder, "w.cert")
        process = subprocess.Popen([programs.confidel, "conform", W3_PRIME, "-o", out, *GRADED], stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        while process.poll() is None and not any(wanted in name for name in os.listdir(folder)):
            time.sleep(0.001)
        process.send_signal(signal.SIGINT)
        process.communicate()
        programs.expect(process.returncode == 130, "interrupted at %s: exit %d" % (wanted, process.returncode))
        left = os.listdir(folder)
        programs.expect(not any("partial" in name or "plc" in name for name in left), "interrupted at %s: left behind: %s" % (wanted, left))
        time.sleep(0.1)
        programs.expect(running_checkers(folder) == [], "interrupted at %s: the checker is still running" % wanted)
        if left:
            code, text, _ = programs.run(out, program=programs.checker)
            programs.expect(code == 0 and last_line(text) == "s VERIFIED", "interrupted at %s: half a certificate" % wanted)
        for name in left:
            os.unlink(os.path.join(folder, name))


def check_output(programs, folder):
    out = os.path.join(folder, "o.cert")
    code, text, err = programs.run("conform", W3, "-o", out, "--quiet")
    programs.expect(code == 0 and text == "s VERIFIED\n" and err == "", "--quiet: %r %r" % (text, err))
    code, text, err = programs.run("conform", W3, "-o", out)
    programs.expect(code == 0 and last_line(text) == "s VERIFIED" and err == "", "no progress in a pipe: %r" % err)
    code, text, err = programs.run("conform", W3, "-o", out, "--json")
    report, end = json.JSONDecoder().raw_decode(text)
    programs.expect(text[end:].strip() == "" and err == "s VERIFIED\n", "--json: one document and nothing else")
    for key in ("steiner_points", "points_by_kind", "cells", "seconds", "peak_memory_bytes", "smallest_relative_power", "complex_sha256", "checker"):
        programs.expect(report.get(key) is not None, "--json: no " + key)
    programs.expect({"read", "features", "placement", "write", "check", "total"} <= set(report["seconds"]), "--json: seconds by stage")
    programs.expect(report["checker"]["complex"] == {"sha256": report["complex_sha256"], "compared": True}, "the checker compared the complex")
    ballast = b"x" * (300 << 20)  # a process begins with the peak of the one that starts it, by getrusage
    report = json.JSONDecoder().raw_decode(programs.run("conform", W3, "-o", out, "--json")[1])[0]
    programs.expect(report["peak_memory_bytes"] < len(ballast), "peak memory of a small input from a large process: %d" % report["peak_memory_bytes"])
    os.unlink(out)


def main():
    programs = Programs(sys.argv[1])
    with tempfile.TemporaryDirectory() as folder:
        for check in (check_output, check_limits, check_estimate, check_files, check_bad_input, check_missing_checker, check_interruption):
            begin = time.time()
            check(programs, folder)
            print("%s: %.1f s" % (check.__name__, time.time() - begin), flush=True)
    programs.finish()


main()
