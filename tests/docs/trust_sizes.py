#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The sizes in docs/trust.md, counted again: trust_sizes.py BIN [--update]

Fails when the page and the count differ by more than a tenth (what is not believed: by more than 0.6). Lines are all lines of .cpp and .h files. Libraries and the
compiler are measured on Debian 12 only; elsewhere their rows are not compared.
"""
import glob
import os
import re
import subprocess
import sys

ROOT = os.path.normpath(os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", ".."))
PAGE = os.path.join(ROOT, "docs", "trust.md")
MARKS = ("<!-- sizes begin -->\n", "<!-- sizes end -->\n")
ALLOWED = 0.1


def lines(*patterns):
    files = sorted({file for pattern in patterns for file in glob.glob(os.path.join(ROOT, pattern))})
    if not files:
        raise SystemExit("nothing matches %s" % (patterns,))
    return sum(open(file, "rb").read().count(b"\n") for file in files)


def source(folder):
    return lines(folder + "/*.cpp", folder + "/*.h")


def functions_called(checker, pattern):
    symbols = subprocess.run(["nm", "-D", "--undefined-only", checker], check=True, capture_output=True, text=True).stdout
    return len(set(re.findall(r"\b(?:%s)\w+" % pattern, symbols)))


def library_bytes(checker, name):
    listing = subprocess.run(["ldd", checker], check=True, capture_output=True, text=True).stdout
    return os.path.getsize(os.path.realpath(re.search(r"%s\S* => (\S+)" % re.escape(name), listing).group(1)))


def compiler_bytes():
    path = subprocess.run(["g++", "-print-prog-name=cc1plus"], check=True, capture_output=True, text=True).stdout.strip()
    return os.path.getsize(path)


def measure(checker):
    """Rows: what, number, unit, is it a property of the machine. Rows that are not believed only give the proportion."""
    io, complex_, numbers = source("core/io"), source("core/complex"), source("core/numbers")
    crossings = lines("core/complex/crossing_*.cpp", "core/complex/intersection.*", "core/complex/broad_phase.*")
    return [
        ("`checkers/gmp`", source("checkers/gmp"), "lines", False),
        ("libgmp: functions that the checker calls", functions_called(checker, "__gmp"), "functions", True),
        ("libgmp", library_bytes(checker, "libgmp.so"), "bytes", True),
        ("libcrypto: functions that the checker calls", functions_called(checker, "EVP_"), "functions", True),
        ("libcrypto", library_bytes(checker, "libcrypto.so"), "bytes", True),
        ("libzstd: functions that the checker calls", functions_called(checker, "ZSTD_"), "functions", True),
        ("libzstd", library_bytes(checker, "libzstd.so"), "bytes", True),
        ("libstdc++ and libc", library_bytes(checker, "libstdc++.so") + library_bytes(checker, "libc.so"), "bytes", True),
        ("the compiler (GCC's cc1plus)", compiler_bytes(), "bytes", True),
        ("`core/io`: text to numbers and polygons", io, "lines", False),
        ("`core/complex`: polygons to facets", complex_ - crossings, "lines", False),
        ("`core/complex`: the search for crossings (not believed, see below)", crossings, "lines", False),
        ("`core/numbers`: exact points and predicates", numbers, "lines", False),
        ("all the rest of `core`, `proofs/certificate` and `apps` (not believed)",
         lines("core/*/*.cpp", "core/*/*.h", "proofs/certificate/*", "apps/*.cpp", "apps/*.h") - io - complex_ - numbers, "lines", False),
    ]


def text(number, unit):
    if unit == "bytes":
        return "%.1f MB" % (number / 1e6)
    return "%s %s" % (format(number, ","), unit)


def table(rows):
    return "| what | size |\n|---|---|\n" + "".join("| %s | %s |\n" % (what, text(number, unit)) for what, number, unit, _ in rows)


def written(page):
    return {what: size for what, size in re.findall(r"^\| (.+) \| (.+) \|$", page, re.M)}


def value(size):
    number = float(re.match(r"[\d.,]+", size).group(0).replace(",", ""))
    return number * 1e6 if size.endswith("MB") else number


def main():
    arguments = [argument for argument in sys.argv[1:] if argument != "--update"]
    if len(arguments) != 1:
        raise SystemExit(__doc__)
    rows = measure(os.path.join(arguments[0], "confidel-check"))
    page = open(PAGE).read()
    before, rest = page.split(MARKS[0])
    shown, after = rest.split(MARKS[1])
    if "--update" in sys.argv:
        open(PAGE, "w").write(before + MARKS[0] + table(rows) + MARKS[1] + after)
        return 0
    try:
        debian = open("/etc/debian_version").read().startswith("12")
    except OSError:
        debian = False
    page_says, stale = written(shown), []
    for what, number, unit, machine in rows:
        if machine and not debian:
            continue
        size = page_says.pop(what, None)
        allowed = 0.6 if "(not believed" in what else ALLOWED
        if size is None or abs(value(size) - number) > allowed * number + (5e4 if unit == "bytes" else 0):
            stale.append("%s: the page says %s, counted %s" % (what, size, text(number, unit)))
    if debian:
        stale += ["%s: on the page only" % what for what in page_says if what not in ("what", "---")]
    for line in stale:
        print("FAILED docs/trust.md: " + line)
    print("%d sizes, %d stale%s" % (len(rows), len(stale), "; python3 tests/docs/trust_sizes.py BIN --update" if stale else ""))
    return 1 if stale else 0


if __name__ == "__main__":
    sys.exit(main())
