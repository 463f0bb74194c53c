#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""inputs_test.py BINARIES [--strategy NAME]: every small input of the list is VERIFIED, with few enough points, with the same bytes in
every run and for every number of threads, compressed and not; the checker program agrees when it is run by itself.

The strategy is conform's own if none is named. The table of points is graded's; a better strategy has fewer."""
import os
import sys
import tempfile

import inputs
from harness import EXAMPLES, Programs, content, last_line


def check_input(programs, strategy, folder, name, path, expected):
    first, second, packed = (os.path.join(folder, n) for n in ("first.cert", "second.cert", "packed.cert.zst"))
    report = programs.expect_verified(name, path, first, "--threads", 1, *strategy)
    if report is None:
        return
    points = report["vertices"] + report["steiner_points"]
    print("%-20s %6d points%s" % (name, points, "" if expected is None else ", table: %d" % expected), flush=True)
    if expected is not None:
        programs.expect(points <= inputs.ALLOWANCE * expected, "%s: %d points, more than %g x %d" % (name, points, inputs.ALLOWANCE, expected))
    check_report(programs, name, first, report)

    bytes_of_first = content(first)
    programs.expect_verified(name, path, second, "--threads", 2, *strategy)
    programs.expect(content(second) == bytes_of_first, name + ": the bytes depend on the number of threads")
    programs.expect_verified(name, path, second, "--threads", 2, *strategy)
    programs.expect(content(second) == bytes_of_first, name + ": two runs give different bytes")

    code, canonical, _ = programs.run("canonical", path)
    plc = os.path.join(folder, "canonical.plc")
    with open(plc, "w", newline="") as file:
        file.write(canonical)
    programs.expect(code == 0 and canonical.encode() in bytes_of_first, name + ": `canonical` is what the certificate embeds")
    code, out, _ = programs.run(first, "--complex", plc, program=programs.checker)
    programs.expect(code == 0 and last_line(out) == "s VERIFIED", name + ": the checker run by itself")

    programs.expect_verified(name, path, packed, *strategy)
    programs.expect(content(packed)[:4] == b"\x28\xb5\x2f\xfd", name + ": .zst is a zstd frame")
    programs.expect(os.path.getsize(packed) < len(bytes_of_first), name + ": .zst is smaller")
    code, out, _ = programs.run(packed, "--complex", plc, program=programs.checker)
    programs.expect(code == 0 and last_line(out) == "s VERIFIED", name + ": the checker reads .zst")
    for file in (first, second, packed, plc):
        os.unlink(file)
    programs.expect(not [f for f in os.listdir(folder) if "partial" in f or "cert" in f], name + ": something else is left behind")


def check_report(programs, name, certificate, report):
    """The report counts what the certificate holds."""
    lines = content(certificate).decode("ascii").split("\n")
    counts = {word: sum(line.startswith(word + " ") for line in lines) for word in "vsfqth"}
    kinds, cells = {}, {}
    for line in lines:
        fields = line.split(" ")
        if fields[0] == "q":
            kinds[fields[1]] = kinds.get(fields[1], 0) + 1
        if fields[0] == "t":
            cells[fields[5]] = cells.get(fields[5], 0) + 1
    programs.expect(report["vertices"] == counts["v"] and report["segments"] == counts["s"] and report["facets"] == counts["f"], name + ": counts of the complex")
    programs.expect(report["steiner_points"] == counts["q"] and report["points_by_kind"] == kinds, name + ": points by kind")
    programs.expect(report["cells"] == counts["t"] and report["cells_by_kind"] == cells, name + ": cells by kind")
    programs.expect(report["certificate"]["bytes"] == os.path.getsize(certificate), name + ": bytes of the certificate")
    programs.expect(report["smallest_relative_power"] is None or report["smallest_relative_power"] > 0, name + ": smallest relative power")
    programs.expect(report["peak_memory_bytes"] > 1 << 20, name + ": peak memory")
    programs.expect(all(value >= 0 for value in report["seconds"].values()), name + ": seconds by stage")


def main():
    programs = Programs(sys.argv[1])
    with tempfile.TemporaryDirectory() as made, tempfile.TemporaryDirectory() as folder:
        for name, path, expected in inputs.write_all(made, EXAMPLES):
            check_input(programs, sys.argv[2:], folder, name, path, expected)
    programs.finish()


main()
