#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Accepted certificates, changed in every way that their meaning suggests: typed_test.py CHECKER [--most N] [--flips PROGRAM]

Every change is rejected (exit 5, or 2 or 3 where the text is no certificate any more), or accepted and then found right by oracle.py, which
judges in rational numbers by brute force. Also: the certificate as it is, but about another complex. --most: of each certificate's changes of one type, at most so
many, evenly chosen. --flips: every bit of the small certificates too (with --most, of the smallest), as it is and with the digest put right, by flips/flips.cpp."""
import argparse
import collections
import concurrent.futures
import glob
import hashlib
import os
import re
import subprocess
import sys
import tempfile

HERE = os.path.dirname(os.path.abspath(__file__))
CERTIFICATES = os.path.normpath(os.path.join(HERE, "..", "..", "certificates"))
sys.path.insert(0, HERE)
import oracle

LARGEST = 20000
LARGEST_OF_SAMPLE = 1500
LARGEST_FLIPPED, LARGEST_FLIPPED_OF_SAMPLE = 1500, 400
COUNTED = {"vertices": "v", "segments": "s", "facets": "f", "points": "q", "cells": "t", "hanging": "h", "rows": "r"}
KINDS = ["projection", "edge", "offset", "arc", "interior"]


def closed(lines):
    """With counts at the end and a digest that are right, so that only the rules can object."""
    n = {}
    for line in lines:
        words = line.split(" ")
        if len(words) == 2 and words[0] in COUNTED and words[1].isdigit():
            n.setdefault(words[0], words[1])
    body = "\n".join(lines[:-1]) + "\n"
    counts = [n.get(k, "0") for k in ("vertices", "segments", "facets", "points", "cells", "rows", "hanging")]
    return body + "end " + " ".join(counts) + " " + hashlib.sha256(body.encode()).hexdigest() + "\n"


def counted(lines, place, by):
    """The count in front of the record at `place` changed by so many."""
    words = lines[place].split(" ")
    name = next(name for name, letter in COUNTED.items() if letter == words[0])
    header = next(i for i, line in enumerate(lines) if re.fullmatch(name + r" \d+", line))
    lines[header] = "%s %d" % (name, int(lines[header].split(" ")[1]) + by)
    return lines


def changed_word(lines, place, word, value):
    words = lines[place].split(" ")
    words[word] = value
    return lines[:place] + [" ".join(words)] + lines[place + 1:]


def hexadecimal(value):
    return "-%x" % -value if value < 0 else "%x" % value


def mutants(lines):
    """(type, text)"""
    for place, line in enumerate(lines):
        words = line.split(" ")
        letter = words[0]
        if letter in ("v", "q"):
            for word in range(1 if letter == "v" else 3, len(words)):
                for by in (-1, 1):
                    yield "coordinate", closed(changed_word(lines, place, word, hexadecimal(int(words[word], 16) + by)))
        if letter == "q":
            for kind in KINDS:
                if kind != words[1]:
                    yield "kind", closed(changed_word(lines, place, 1, kind))
            for by in (-1, 1):
                if int(words[2]) + by >= 0:
                    yield "owner", closed(changed_word(lines, place, 2, str(int(words[2]) + by)))
        if letter in ("t", "h", "s", "f") and len(words) > 2 and words[1].isdigit():
            first, last = (2, 5) if letter == "t" else (1, len(words))
            for a in range(first, last):
                for by in (-1, 1):
                    if int(words[a]) + by >= 0:
                        yield "index", closed(changed_word(lines, place, a, str(int(words[a]) + by)))
                for b in range(a + 1, last):
                    yield "swap", closed(changed_word(changed_word(lines, place, a, words[b]), place, b, words[a]))
        if letter == "t":
            for by in (-1, 1):
                if int(words[1]) + by >= 0:
                    yield "owner", closed(changed_word(lines, place, 1, str(int(words[1]) + by)))
            for kind in "TSRC":
                if kind != words[5]:
                    yield "kind", closed(changed_word(lines, place, 5, kind))
            without = [w for w in words if "/" not in w]
            for offset in ("1/2", "-1/2", "1/1", "-1/100", "1/1000", "ff/1"):
                yield "offset", closed(lines[:place] + [" ".join(without + [offset])] + lines[place + 1:])
            if without != words:
                yield "offset", closed(lines[:place] + [" ".join(without)] + lines[place + 1:])
                negated = words[-1][1:] if words[-1].startswith("-") else "-" + words[-1]
                yield "offset", closed(lines[:place] + [" ".join(without + [negated])] + lines[place + 1:])
        if letter in ("v", "q", "t", "h", "s") and len(words) > 2:
            yield "dropped", closed(dropped(lines, place))
            yield "duplicated", closed(counted(lines[:place] + [line] + lines[place:], place, 1))
            if lines[place + 1].split(" ")[0] == letter:
                yield "reordered", closed(lines[:place] + [lines[place + 1], line] + lines[place + 2:])
        if re.fullmatch(r"\d+( \d+)?", line):
            yield "swap", closed(lines[:place] + [" ".join(reversed(words))] + lines[place + 1:])
            yield "index", closed(lines[:place] + [" ".join([str(int(words[0]) + 1)] + words[1:])] + lines[place + 1:])
        if len(words) == 2 and words[1].isdigit() and not letter.isdigit():
            for by in (-1, 1):
                yield "count", closed(lines[:place] + ["%s %d" % (letter, int(words[1]) + by)] + lines[place + 1:])
        yield "truncated", "\n".join(lines[:place]) + "\n"
    yield from flipped_cells(lines)
    for word in range(1, 8):
        last = lines[-1].split(" ")
        last[word] = str(int(last[word]) + 1)
        yield "count", "\n".join(lines[:-1] + [" ".join(last)]) + "\n"
    yield "digest", "\n".join(lines) .replace(lines[-1][-8:], "00000000") + "\n"


def dropped(lines, place):
    copy = counted(list(lines), place, -1)
    return copy[:place] + copy[place + 1:]


def flipped_cells(lines):
    """Two cells with a common edge, cut along the other diagonal of their quadrilateral: across a tie this may be right."""
    cells = [(place, line.split(" ")) for place, line in enumerate(lines) if line.startswith("t ")]
    for i, (p, a) in enumerate(cells):
        for q, b in cells[i + 1:]:
            if a[1] != b[1]:
                continue
            for x in range(3):
                for y in range(3):
                    e, f, g = a[2 + x], a[2 + (x + 1) % 3], a[2 + (x + 2) % 3]
                    if (e, f) == (b[2 + (y + 1) % 3], b[2 + y]):
                        h = b[2 + (y + 2) % 3]
                        copy = list(lines)
                        copy[p] = " ".join(["t", a[1], g, e, h, "C"])
                        copy[q] = " ".join(["t", a[1], h, f, g, "C"])
                        yield "flipped", closed(copy)


def flipped(program, paths, folder):
    """(name, kind, text) of what was accepted, or answered differently without the filter; and how many there were of each kind."""
    tally = collections.Counter()

    def run(part):
        done = subprocess.run([program, folder, *part], capture_output=True, text=True)
        return done.stdout if done.returncode == 0 else sys.exit("bit-flips: exit %d %s" % (done.returncode, done.stderr))

    with concurrent.futures.ThreadPoolExecutor(2) as pool:
        for out in pool.map(run, [part for part in (paths[i::16] for i in range(16)) if part]):
            for line in out.splitlines():
                number, kind, verdict = line.split(" ", 2)
                tally[kind, verdict] += int(number)
    found = []
    for name in sorted(os.listdir(folder)):
        with open(os.path.join(folder, name), "rb") as file:
            found.append((name, "bit", file.read()))
    return found, tally


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("checker")
    parser.add_argument("--most", type=int, default=0)
    parser.add_argument("--flips", default="")
    options = parser.parse_args()
    checker = os.path.abspath(options.checker)
    failures, tally = [], collections.Counter()

    def judge(job):
        name, kind, data = job
        with tempfile.NamedTemporaryFile(suffix=".cert") as file:
            file.write(data)
            file.flush()
            done, exact = (subprocess.run([checker, file.name, "--quiet", "--threads", "1", *more], capture_output=True) for more in ((), ("--exact",)))
        if (done.returncode, done.stdout, done.stderr) != (exact.returncode, exact.stdout, exact.stderr):
            return kind, "failed", "%s, %s: with --exact: %d %s, without: %d %s" % (name, kind, exact.returncode, exact.stdout, done.returncode, done.stdout)
        if done.returncode not in (0, 2, 3, 5):
            return kind, "failed", "%s, %s: exit %d" % (name, kind, done.returncode)
        if done.returncode != 0:
            return kind, "rejected" if done.returncode == 5 else "no certificate", None
        try:
            wrong = oracle.fault(data.decode())
        except Exception as error:  # what the oracle cannot read should not have been accepted
            wrong = repr(error)
        return kind, "right", wrong and "%s, %s: accepted, but %s is broken:\n%s" % (name, kind, wrong, data.decode())

    jobs, small = [], []
    for path in sorted(glob.glob(os.path.join(CERTIFICATES, "accept", "*.cert"))):
        data = open(path, "rb").read()
        if data[:4] == b"\x28\xb5\x2f\xfd" or len(data) > (LARGEST_OF_SAMPLE if options.most else LARGEST) or b"\nclaims 1\n" not in data:
            continue
        name, text = os.path.basename(path), data.decode()
        if oracle.fault(text) is not None:
            failures.append("%s: the oracle finds %s" % (name, oracle.fault(text)))
        groups = collections.defaultdict(list)
        for kind, mutant in mutants(text.split("\n")[:-1]):
            if mutant != text:
                groups[kind].append(mutant)
        for kind, group in sorted(groups.items()):
            if options.most and len(group) > options.most:
                group = [group[i * len(group) // options.most] for i in range(options.most)]
            jobs += [(name, kind, mutant.encode()) for mutant in group]
        if len(data) < (LARGEST_FLIPPED_OF_SAMPLE if options.most else LARGEST_FLIPPED):
            small.append(path)
    total = 0
    if options.flips:
        with tempfile.TemporaryDirectory() as folder:
            found, flips = flipped(os.path.abspath(options.flips), small, folder)
        tally.update(flips)
        total = sum(flips.values()) - len(found)
        if not flips["bit", "rejected"] or not flips["bit-with-digest", "rejected"]:
            failures.append("no flipped bit was rejected")
        known = set()
        for job in found:  # bits of notes and of names: one certificate, but for the notes
            content = re.sub(rb"(?m)^n .*\n|^end .*\n", b"", job[2])
            if content not in known:
                known.add(content)
                jobs.append(job)
            else:
                total += 1
    with concurrent.futures.ThreadPoolExecutor(2) as pool:
        for kind, verdict, failure in pool.map(judge, jobs):
            tally[kind, verdict] += 1
            if failure:
                failures.append(failure)
    for (kind, verdict), count in sorted(tally.items()):
        print("%7d %-11s %s" % (count, kind, verdict))
    for failure in failures[:5]:
        print("FAILED " + failure)
    print("%d changed certificates, %d failures" % (len(jobs) + total, len(failures)))
    return 1 if failures or not jobs else 0


if __name__ == "__main__":
    sys.exit(main())
