#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""benchmarks/results.py on one example, and the shape of docs/results.md: results_test.py BIN"""
import os
import subprocess
import sys
import tempfile

ROOT = os.path.normpath(os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", ".."))
SCRIPT = os.path.join(ROOT, "benchmarks", "results.py")


def tables(text):
    """All tables: lists of rows of cells, heads first; the rule below the heads is left out."""
    result, inside = [], False
    for line in text.split("\n"):
        cells = [cell.strip() for cell in line.strip("|").split("|")] if line.startswith("|") else None
        if cells is None:
            inside = False
        elif not inside:
            result.append([cells])
            inside = True
        elif set(cells) != {"---"}:
            result[-1].append(cells)
    return result


def check(name, text):
    found = tables(text)
    assert found, name + ": no table"
    for table in found:
        assert len(table) > 1, name + ": an empty table"
        for row in table:
            assert len(row) == len(table[0]), "%s: %d cells under %d heads: %s" % (name, len(row), len(table[0]), row)
    return found


def main():
    with tempfile.TemporaryDirectory() as folder:
        output = os.path.join(folder, "results.md")
        options = ["--bin", sys.argv[1], "--output", output, "--data", os.path.join(folder, "absent"), "--only", "w3.smesh"]
        subprocess.run([sys.executable, "-B", SCRIPT, *options], check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        text = open(output).read()
        assert "the folder is absent here" in text, "an absent folder is not mentioned"
        last = check("one example", text)[-1]
        values = dict(zip(last[0], last[1]))
        assert values["file"] == "examples/w3.smesh" and values["verdict"] == "VERIFIED", values
        for column in ("triangles", "facets", "Steiner points", "estimate", "cells", "placement", "check", "peak memory", "certificate"):
            assert values[column], "nothing in column " + column
        failed = subprocess.run([sys.executable, "-B", SCRIPT, *options[:-1], "no-such-file"], capture_output=True)
        assert failed.returncode == 2, "no input must be an error"
    check("docs/results.md", open(os.path.join(ROOT, "docs", "results.md")).read())
    print("results: as they should be")
    return 0


if __name__ == "__main__":
    sys.exit(main())
