#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Runs a checker on all test certificates: run_certificates.py CHECKER [--no-mutations | --command-line [--no-frames] [--no-many] [--until-failure]] [--record-reports]

Compares the exit code and the last line (or the error's code and line) with MANIFEST.tsv; checks that manifest,
folder and generator agree; compares reports, and the columns and messages of errors, with REPORTS.tsv; tries the command line (with --command-line that alone, for mutants of the checker); and changes each byte of the worked example.
"""
import filecmp
import hashlib
import json
import os
import re
import resource
import shutil
import signal
import subprocess
import sys
import tempfile
import time
from concurrent.futures import ThreadPoolExecutor

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, HERE)
import make_certificates
CERTIFICATES = os.path.normpath(os.path.join(HERE, "..", "certificates"))
FOLDERS = ("accept", "refute", "reject", "decline", "malformed")
failures = []


def expect(good, message):
    if not good:
        failures.append(message)
        print("FAILED " + message)
        if "--until-failure" in sys.argv:
            sys.exit(1)


def run(checker, *arguments):
    done = subprocess.run([checker, *arguments], stdout=subprocess.PIPE, stderr=subprocess.PIPE)
    return done.returncode, done.stdout.decode("latin-1"), done.stderr.decode("latin-1")


def last_line(text):
    return text.rstrip("\n").split("\n")[-1]


def timeless(text):
    return re.sub(r"^[0-9.]+ seconds, [0-9]+ threads$", "", text, flags=re.M)


def answer(path, code, out, err):
    """What the manifest states: the last line, or the error's code and line."""
    if code != 2:
        return last_line(out)
    match = re.match(re.escape(path) + r":(\d+):(\d+): error\[(E-[A-Z]+)\]: .", err)
    if not match or re.search(r"^s ", out, re.M):
        return "no error line: " + err
    return match.group(3) if match.group(3) == "E-ZSTD" else "%s %s" % (match.group(3), match.group(1))


def check_case(checker, path, code, expected):
    full = os.path.join(CERTIFICATES, path)
    got = run(checker, full)
    expect(got[0] == code and answer(full, *got) == expected, "%s: %d %s, expected %d %s" % (path, got[0], answer(full, *got), code, expected))
    # Without the float filter: the same bytes, but for the time.
    exact = run(checker, full, "--exact", "--threads", "2")
    expect(exact[0] == code and timeless(exact[1]) == timeless(got[1]) and exact[2] == got[2], "%s: --exact" % path)
    for threads in ("1", "3"):
        again = run(checker, full, "--json", "--threads", threads)
        document = json.loads(again[1])
        expect(again[0] == code == document["exit"], "%s: exit code with --json" % path)
        if code != 2:
            expect(last_line(again[2]) == expected, "%s: the verdict on standard error with --json" % path)
        quiet = run(checker, full, "--quiet", "--threads", threads)
        expect(quiet[0] == code and (code == 2 or quiet[1] == expected + "\n"), "%s: --quiet" % path)


def manifest():
    cases = []
    with open(os.path.join(CERTIFICATES, "MANIFEST.tsv")) as file:
        for line in file:
            if not line.startswith("#"):
                path, code, expected, _ = line.rstrip("\n").split("\t")
                cases.append((path, int(code), expected))
    return cases


def check_manifest():
    cases = manifest()
    present = {os.path.join(folder, name) for folder in FOLDERS for name in os.listdir(os.path.join(CERTIFICATES, folder))}
    expect(present == {case[0] for case in cases}, "manifest and folder differ: %s" % sorted(present ^ {case[0] for case in cases}))
    with tempfile.TemporaryDirectory() as folder:
        subprocess.run([sys.executable, "-B", os.path.join(HERE, "make_certificates.py"), folder], check=True)
        for path in [case[0] for case in cases] + ["MANIFEST.tsv"]:
            other = os.path.join(folder, path)
            same = os.path.exists(other) and filecmp.cmp(other, os.path.join(CERTIFICATES, path), shallow=False)
            expect(same, "generating again gives something else: " + path)
    return cases


def reported(checker, path, threads):
    """What the report says besides the verdict: counts, the smallest relative power, and of each claim how many objects and the smallest slack, where."""
    report = json.loads(run(checker, os.path.join(CERTIFICATES, path), "--json", "--threads", threads)[1])
    claims = ["%s %s %s %s %s" % tuple(claim[key] for key in ("id", "objects", "slack", "line", "object")) for claim in report["claims"]]
    return "\t".join([path, json.dumps(report["rules"]), json.dumps(report.get("coplanar")), json.dumps(report.get("smallest-relative-power")), *claims])


def complained(checker, path):
    """The column and the message of an error. What libzstd says, and where it notices, is its own affair."""
    full = os.path.join(CERTIFICATES, path)
    match = re.match(re.escape(full) + r":\d+:(\d+): error\[(E-[A-Z]+)\]: (.*)", run(checker, full)[2])
    own = match and (match.group(2) != "E-ZSTD" or "zstd frame" in match.group(3))
    return "\t".join([path, *((match.group(1), match.group(3)) if own else ())])


def check_reports(checker, cases):
    """Nobody's verdict rests on these numbers, but they are shown to people: a change has to be looked at. --record-reports writes REPORTS.tsv again."""
    produced = sorted(os.path.join("produced", name) for name in os.listdir(os.path.join(CERTIFICATES, "produced")))
    lines = [reported(checker, path, "1") for path in [case[0] for case in cases if case[1] in (0, 1)] + produced]
    lines += [complained(checker, case[0]) for case in cases if case[1] == 2]
    if "--record-reports" in sys.argv:
        with open(os.path.join(CERTIFICATES, "REPORTS.tsv"), "w") as out:
            out.write("".join(line + "\n" for line in lines))
    with open(os.path.join(CERTIFICATES, "REPORTS.tsv")) as file:
        stated = file.read().splitlines()
    expect(len(stated) == len(lines), "REPORTS.tsv has %d lines, not %d" % (len(stated), len(lines)))
    for path in produced:  # as `confidel conform` has written them for inputs of examples/: large enough for the trees of the searches
        code, out, _ = run(checker, os.path.join(CERTIFICATES, path), "--threads", "2")
        expect(code == 0 and last_line(out) == "s VERIFIED", "%s: %d %s" % (path, code, last_line(out)))
    expect(reported(checker, produced[0], "3") == reported(checker, produced[0], "1"), "the report of three threads")
    for line, other in zip(lines, stated):
        expect(line == other, "the report is another: %s\n  recorded %s" % (line, other))


def check_command_line(checker):
    worked = os.path.join(CERTIFICATES, "accept", "worked-example.cert")
    crowded = os.path.join(CERTIFICATES, "reject", "claim-L1-short.cert")
    refuted = os.path.join(CERTIFICATES, "refute", "L5.cert")
    claims = os.path.join(CERTIFICATES, "accept", "claim-all-dim2.cert")
    with open(worked, "rb") as file:
        text = file.read()
    block = text[text.index(b"plc 1\n"):text.index(b"claims 1\n")]
    with tempfile.TemporaryDirectory() as folder:
        def file(name, data):
            path = os.path.join(folder, name)
            with open(path, "wb") as out:
                out.write(data)
            return path
        same = file("same", block)
        for arguments, code, line in [
                ((worked, "--complex", same), 0, "s VERIFIED"),
                ((worked, "--complex", file("other", block.replace(b"v 1 1 9 1", b"v 1 1 8 1"))), 5, "s REJECTED complex 9 other-complex"),
                ((worked, "--complex", file("longer", block + b"\n")), 5, "s REJECTED complex 23 other-complex"),
                ((worked, "--complex", file("shorter", block[:-1])), 5, "s REJECTED complex 23 other-complex"),
                ((worked, "--complex", file("empty", b"")), 5, "s REJECTED complex 2 other-complex"),
                ((worked, "--complex", os.path.join(folder, "missing")), 4, None),
                ((os.path.join(folder, "missing"),), 4, None),
                ((folder,), 4, None),
                ((), 2, None), ((worked, worked), 2, None), ((worked, "--nonsense"), 2, None), ((worked, "--exact"), 0, "s VERIFIED"), ((worked, "--threads"), 2, None),
                ((worked, "--threads", "0"), 2, None), ((worked, "--threads", "x"), 2, None), ((worked, "--memory-limit", "1X"), 2, None),
                ((worked, "--time-limit", "-1"), 2, None),
                ((worked, "--cells", "2-1"), 2, None), ((worked, "--cells", "1"), 2, None), ((worked, "--cells", "01-2"), 2, None), ((worked, "--cells", "-1-2"), 2, None),
                ((worked, "--cells", ""), 2, None), ((worked, "--cells", "1-2x"), 2, None),
                ((worked, "--cells", "0-0"), 3, "s UNDECIDED cells-0-0"), ((worked, "--cells", "0-99"), 3, "s UNDECIDED cells-0-99"),
                ((worked, "--cells", "7-99"), 3, "s UNDECIDED cells-7-99"),
                ((refuted, "--cells", "0-1"), 3, "s UNDECIDED cells-0-1"), ((claims, "--cells", "0-30"), 3, "s UNDECIDED cells-0-30"),
                ((crowded, "--cells", "0-0"), 3, "s UNDECIDED cells-0-0"),
                ((os.path.join(CERTIFICATES, "reject", "emptiness-off-plane-in.cert"), "--cells", "0-0"), 5, "s REJECTED emptiness 28 cell-0-point-3"),
                ((os.path.join(CERTIFICATES, "reject", "emptiness-off-plane-in.cert"), "--cells", "1-1"), 3, "s UNDECIDED cells-1-1"),
                (("--help",), 0, None), (("--version",), 0, None), (("-",), 4, None), (("a-missing-file",), 4, None), (("-x",), 2, None), ((worked, "--complex", ""), 2, None),
                ((worked, "--threads", "1024"), 0, "s VERIFIED"), ((worked, "--threads", "1025"), 2, None), ((worked, "--threads", ""), 2, None),
                ((worked, "--memory-limit", "100000000000000000"), 0, "s VERIFIED"), ((worked, "--memory-limit", "1000000000000000000"), 2, None),
                ((worked, "--memory-limit", "4294967296G"), 0, "s VERIFIED"), ((worked, "--memory-limit", "4294967297G"), 2, None),
                ((worked, "--memory-limit", "0"), 2, None), ((worked, "--memory-limit", ""), 2, None), ((worked, "--memory-limit", "1"), 3, "s UNDECIDED memory-limit"),
                ((worked, "--time-limit", "1000000000"), 0, "s VERIFIED"), ((worked, "--time-limit", "1000000001"), 2, None), ((worked, "--time-limit", ""), 2, None),
                ((worked, "--time-limit", "1s"), 2, None), ((worked, "--time-limit", "1e3"), 2, None), ((worked, "--time-limit", "1.2.3"), 2, None), ((worked, "--time-limit", "9" * 400), 2, None),
                ((worked, "--time-limit", "1000", "--memory-limit", "64M"), 0, "s VERIFIED"),
                ((worked, "--memory-limit", "40K"), 3, "s UNDECIDED memory-limit")]:
            got = run(checker, *arguments)
            expect(got[0] == code and (line is None or last_line(got[1]) == line), "%s: %d %s" % (arguments, got[0], last_line(got[1])))
            if code == 2:
                expect("error[E-USAGE]: " in got[2], "%s: no E-USAGE" % (arguments,))
        # A line that never ends is declined before it is read.
        expect("--cells needs a number" in run(checker, worked, "--cells", "5")[2], "--cells with one number")
        got = run(checker, os.path.join(CERTIFICATES, "decline", "line-endless.cert"), "--memory-limit", "8M")
        expect(got[0] == 3 and last_line(got[1]) == "s UNDECIDED too-large", "an endless line: %d %s" % (got[0], last_line(got[1])))
        # Damage of the file given by --complex: the first block ends in its line 4, or everything is there, and more.
        frame = lambda blocks: b"\x28\xb5\x2f\xfd\x00\x38" + b"".join((len(block) << 3 | last).to_bytes(3, "little") + block for block, last in blocks)
        part = block[:block.index(b"v 4")]
        for data, line in ((frame([(part, 0)]), part.count(b"\n") + 1), (frame([(block, 1)]) + b"\n", block.count(b"\n") + 1)):
            path = file("damaged", data)
            got = run(checker, worked, "--complex", path)
            expect(got[0] == 2 and got[2].startswith("%s:%d:1: error[E-ZSTD]: " % (path, line)), "a damaged complex: %d %s" % (got[0], got[2]))
        expect(run(checker, worked, "--complex", file("packed-complex", frame([(block, 1)])))[0] == 0, "a compressed complex")
        report = json.loads(run(checker, worked, "--json", "--complex", same)[1])
        expect(report["smallest-relative-power"] == {"value": 2, "cell-line": 34, "point": 3}, "the smallest relative power of the worked example")
        expect(report["complex"] == {"sha256": "680b430c4cf762c7e9ef3d597ce3704f7f45f3f7269fa1723b5d7f076d1ad8e3", "compared": True}, "the digest of the complex")
        expect(report["digest"] == text[-65:-1].decode() and report["cells-checked"] == [0, 2], "the digest of the certificate, and the cells that were checked")
        for cells, tested in (("0-0", [0, 0]), ("1-99", [1, 2]), ("7-99", None)):
            expect(json.loads(run(checker, worked, "--json", "--cells", cells)[1]).get("cells-checked") == tested, "the cells that were checked of --cells " + cells)
        expect(json.loads(run(checker, worked, "--json", "--cells", "1-99")[1])["rules"]["emptiness"] == 2 * 7, "the pairs of two cells and seven points")
        wrong = json.loads(run(checker, file("wrong", text[:-65] + b"0" * 64 + b"\n"), "--json")[1])
        expect(wrong["rule"] == "hash" and wrong["digest"] == report["digest"], "the digest is that of the text, not the stated one")
        report = {claim["id"]: claim for claim in json.loads(run(checker, claims, "--json")[1])["claims"]}
        expect(len(report) == 28 and all(claim["failures"] == 0 for claim in report.values()), "all claims are reported")
        expect(report["H-ball"]["slack"] is None and report["H-ball"]["objects"] == 16, "a claim without slack")
        expect(report["H-chord"]["slack"] == 0 and report["L21"]["slack"] == 0 and report["L21"]["object"] == "vertex-1-vertex-0", "claims without room")
        expect(report["L2"]["slack"] == 0.0908988 and report["L2"]["object"] == "box-0", "the slack of L2")
        some = {claim["id"]: claim["objects"] for claim in json.loads(run(checker, claims, "--json", "--cells", "0-3")[1])["claims"]}
        expect((some["H-ball"], some["L9"], some["L13"], some["L2"]) == (4, 2, 0, 12), "the objects of some cells")
        failed = json.loads(run(checker, crowded, "--json")[1])
        expect(failed["rule"] == "L1" and failed["claims"][0]["failures"] >= 1, "a claim that fails")
        check_claims(checker, claims)
        report = json.loads(run(checker, worked, "--json", "--complex", same)[1])
        coplanar = json.loads(run(checker, os.path.join(CERTIFICATES, "accept", "coplanar.cert"), "--json")[1])
        expect(coplanar["coplanar"] is True and report["coplanar"] is False, "coplanar or not")
        check_report_texts(checker, folder, worked, refuted)
        check_limits(checker, folder, worked)
        check_pipe(checker, folder, worked)
        check_large(checker, file, text)
        if "--no-many" not in sys.argv:
            check_many_points(checker, file)
        if shutil.which("zstd") and "--no-frames" not in sys.argv:
            for level in ("-1", "-19"):
                packed = os.path.join(folder, "packed")
                subprocess.run(["zstd", "-q", "-f", level, worked, "-o", packed], check=True)
                expect(run(checker, packed)[0] == 0, "zstd " + level)
                with open(packed, "rb") as source:
                    data = source.read()
                for size in range(4, len(data)):
                    got = run(checker, file("cut", data[:size]))
                    expect(got[0] == 2 and "error[E-ZSTD]" in got[2], "zstd frame cut after %d bytes: %d" % (size, got[0]))


def check_report_texts(checker, folder, worked, refuted):
    """Which answers come with a report, and what is in it and what is not."""
    malformed = os.path.join(CERTIFICATES, "malformed", "truncated-tab.cert")
    rejected = next(os.path.join(CERTIFICATES, path) for path, _, expected in manifest() if expected.startswith("s REJECTED hash "))
    emptiness = os.path.join(CERTIFICATES, "reject", "emptiness-off-plane-in.cert")
    for arguments, code in (((worked,), 0), ((refuted,), 1), ((worked, "--cells", "0-0"), 3), ((rejected,), 5), ((emptiness,), 5)):
        got = run(checker, *arguments)
        expect(got[0] == code and "\ndimension " in got[1] and " seconds, " in got[1], "a report with exit code %d" % code)
        got = run(checker, *arguments, "--quiet")
        expect(got[0] == code and got[1].count("\n") == 1, "--quiet with exit code %d: %s" % (code, got[1]))
    for path, code in ((malformed, 2), (os.path.join(folder, "missing"), 4)):
        expect(run(checker, path)[:2] == (code, ""), "no report with exit code %d" % code)
        expect(set(json.loads(run(checker, path, "--json")[1])) & {"rule", "object", "why", "complex", "digest", "coplanar"} == set(), "fields without a meaning, exit code %d" % code)
    plane = "all points lie in one plane"
    expect(plane in run(checker, os.path.join(CERTIFICATES, "accept", "coplanar.cert"))[1] and plane not in run(checker, worked)[1], "whether all points lie in one plane")
    expect("smallest relative power" not in run(checker, emptiness)[1] and "smallest relative power" in run(checker, worked)[1], "the smallest relative power of what has passed alone")
    fields = lambda *arguments: json.loads(run(checker, *arguments, "--json")[1])
    keys = {"rule", "line", "object", "why"}
    expect(keys & set(fields(worked)) == set() and keys & set(fields(rejected)) == {"rule", "line", "object"}, "fields of a rejection alone")
    expect(keys & set(fields(refuted)) == {"rule", "object"} and fields(refuted)["rule"] == run(checker, refuted)[1].split()[-2], "fields of a refutation")
    some = fields(worked, "--cells", "0-0")
    expect(keys & set(some) == {"why"} and some["why"] == "cells-0-0" and "coplanar" in some, "fields of some cells")
    expect("coplanar" not in fields(rejected) and "smallest-relative-power" not in fields(emptiness), "fields of rules that were not reached")
    # Names are spelt so that the document stays one.
    name = os.path.join(folder, "a \"b\\c\x01\x1f\x7f~!\u00e4")
    shutil.copy(worked, name)
    text = run(checker, name, "--json")[1]
    expect('"certificate":"%s/a \\"b\\\\c\\u0001\\u001f\\u007f~!' % folder in text and json.loads(text)["verdict"] == "VERIFIED", "a name with quotes and control characters: " + text[:300])


def check_large(checker, file, text):
    """So many notes that the digest gets a thread of its own."""
    old = next(line for line in text.split(b"\n") if line.startswith(b"notes "))
    end = text[text.rindex(b"\nend ") + 1:-65]

    def noted(count):
        notes = b"".join(b"n filler %05d %s\n" % (i, b"abcdefghijklmnopqrstuvwxyz" * 3) for i in range(count))
        body = text[:text.rindex(b"\nend ") + 1].replace(old + b"\n", b"notes %d\n" % (count + int(old[6:])) + notes)
        return body, body + end + hashlib.sha256(body).hexdigest().encode() + b"\n"
    body, whole = noted(40000)
    # A frame larger than the buffers, and small ones of large blocks: text is left when the file has ended.
    parts = [whole[i:i + 131072] for i in range(0, len(whole), 131072)]
    frame = make_certificates.zstd_frame([(0, len(part), part) for part in parts], window=7 << 3)
    for cut, expected in ((frame, 0), (frame[:len(frame) // 2], 2)):
        expect(run(checker, file("frame", cut), "--threads", "1")[0] == expected, "%d of %d bytes of a frame" % (len(cut), len(frame)))
    if shutil.which("zstd"):
        packed = lambda text: subprocess.run(["zstd", "-q", "-c", "--no-check"], input=text, stdout=subprocess.PIPE, check=True).stdout
        expect(run(checker, file("frame", packed(noted(1000)[1])), "--threads", "1")[0] == 0, "a frame of a large block")
        # Of two blocks the second one is damaged: a fault in the text of the first one is found before.
        got = run(checker, file("frame", packed(noted(2000)[1].replace(b"n filler 01300 a", b"n filler 01300 \t"))[:-1]), "--threads", "1")
        expect(got[0] == 2 and "error[E-SYNTAX]" in got[2], "a fault before the damage: %d %s" % (got[0], got[2]))
    digest = whole[-65:-1]
    last = body.count(b"\n") + 1
    large = file("large", whole)
    for threads in ("1", "2", "7"):
        expect(run(checker, large, "--threads", threads)[0] == 0, "a large certificate, %s threads" % threads)
        wrong = run(checker, file("wrong", body.replace(b"n filler 39999 a", b"n filler 39999 b") + end + digest + b"\n"), "--threads", threads)
        expect(last_line(wrong[1]) == "s REJECTED hash %d digest" % last, "a changed note, %s threads: %s" % (threads, last_line(wrong[1])))
        cut = run(checker, file("cut", body[:-100]), "--threads", threads)
        expect(cut[0] == 2 and "E-" in cut[2], "a large certificate that ends early, %s threads" % threads)


def check_many_points(checker, file):
    """So many points that two threads build the tree over them: what is in each quarter of it has to be found."""
    count = 30000
    vertices = [b"v %x %x %x 1\n" % (4 * (i % 50) + end, 4 * (i // 50 % 20), 4 * (i // 1000)) for i in range(count) for end in (0, 1)]
    rest = b"segments %d\n" % count + b"".join(b"s %d %d\n" % (2 * i, 2 * i + 1) for i in range(count)) + b"facets 0\nend\nclaims 1\nclaim conforms\nnotes 0\nparameters 0\npoints 0\ncells 0\nrows 0\n"
    rest += b"hanging %d\n" % count + b"".join(b"h %d %d %d\n" % (i, 2 * i, 2 * i + 1) for i in range(count)) + b"evidence 0\n"

    def certificate(near):
        text = list(vertices)
        if near is not None:  # the next segment begins in the middle of this one
            text[2 * near + 2] = b"v %x %x %x 2\n" % (8 * (near % 50) + 1, 8 * (near // 50 % 20), 8 * (near // 1000))
        body = b"confidel-certificate 1\nplc 1\ndim 3\nvertices %d\n" % (2 * count) + b"".join(text) + rest
        return file("many", body + b"end %d %d 0 0 0 0 %d %s\n" % (2 * count, count, count, hashlib.sha256(body).hexdigest().encode())), body.count(b"\n") - count
    path, first = certificate(None)
    for threads in ("2", "5"):
        expect(last_line(run(checker, path, "--threads", threads)[1]) == "s VERIFIED", "60000 points, %s threads" % threads)
    for near in (4155, 4195, 25155, 25195):  # of small and large x and z, along which the tree is split first
        path, first = certificate(near)
        got = last_line(run(checker, path, "--threads", "2")[1])
        expected = "s REJECTED hanging %d subsegment-%d-point-%d" % (first + near, near, 2 * near + 2)
        expect(got == expected, "60000 points: %s, expected %s" % (got, expected))


def check_limits(checker, folder, worked):
    undecided = '{"verdict":"UNDECIDED","why":"memory-limit"}\n'
    expect(run(checker, worked, "--memory-limit", "40K") == (3, "s UNDECIDED memory-limit\n", ""), "--memory-limit")
    expect(run(checker, worked, "--memory-limit", "40K", "--json") == (3, undecided, "s UNDECIDED memory-limit\n"), "--memory-limit with --json")
    # Many vertices and nothing else: a complex larger than any buffer.
    lines = [b"v %x %x %x 1\n" % (i, i * i, 7 * i + 1) for i in range(40000)]
    block = b"plc 1\ndim 3\nvertices 40000\n" + b"".join(lines) + b"segments 0\nfacets 0\nend\n"
    body = b"confidel-certificate 1\n" + block
    body += b"claims 1\nclaim conforms\nnotes 0\nparameters 0\npoints 0\ncells 0\nrows 0\nhanging 0\nevidence 0\n"
    path, same = os.path.join(folder, "vertices"), os.path.join(folder, "vertices.plc")
    with open(path, "wb") as out:
        out.write(body + b"end 40000 0 0 0 0 0 0 " + hashlib.sha256(body).hexdigest().encode() + b"\n")
    for data, line in ((block, None), (block[:-1], block.count(b"\n") - 1), (block + b"x", block.count(b"\n") - 1), (block.replace(b"v 1388 ", b"v 1389 ", 1), 3 + 5000), (block[:300000], block[:300000].count(b"\n"))):
        with open(same, "wb") as out:
            out.write(data)
        got = run(checker, path, "--complex", same)
        expected = "s VERIFIED" if line is None else "s REJECTED complex %d other-complex" % (2 + line)
        expect(last_line(got[1]) == expected, "--complex with %d bytes: %s, expected %s" % (len(data), last_line(got[1]), expected))
    # Memory that was given back is not counted.
    expect(run(checker, path, "--threads", "1", "--memory-limit", "16M")[0] == 0 and run(checker, path, "--memory-limit", "4M")[:2] == (3, "s UNDECIDED memory-limit\n"), "--memory-limit for 40000 vertices")

    # Nor is what has moved counted twice.
    moving = os.path.join(CERTIFICATES, "produced", "corner-45-repaired.cert")
    expect(run(checker, moving, "--exact", "--threads", "1", "--memory-limit", "400K")[0] == 0, "--memory-limit for numbers that grow")

    # A frame with a window of half the limit, and of one byte more than that.
    with open(worked, "rb") as source:
        text = source.read()
    with open(os.path.join(folder, "window"), "wb") as out:
        out.write(make_certificates.zstd_frame([(0, len(text), text)], window=10 << 3))
    for limit, verdict in (("2M", (0, "s VERIFIED")), ("2097150", (3, "s UNDECIDED memory-limit"))):
        got = run(checker, os.path.join(folder, "window"), "--quiet", "--memory-limit", limit)
        expect((got[0], last_line(got[1])) == verdict, "a window of 1 MiB under --memory-limit %s: %d %s" % (limit, got[0], last_line(got[1])))

    def under(megabytes, *arguments):
        limit = lambda: resource.setrlimit(resource.RLIMIT_AS, (megabytes << 20, megabytes << 20))
        return subprocess.run([checker, *arguments], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, preexec_fn=limit)
    if under(24, "--version").returncode == 0:  # not under a sanitizer
        done = under(24, path, "--threads", "1")
        expect(done.returncode == 70 and "out of memory" in done.stderr and done.stdout == "", "no memory: %d %r" % (done.returncode, done.stderr))
    # Without standard input the certificate is file 0.
    done = subprocess.run([checker, worked], stdout=subprocess.PIPE, preexec_fn=lambda: os.close(0))
    expect(done.returncode == 0, "without standard input: %d" % done.returncode)
    expect("cannot be read: No such file" in run(checker, os.path.join(folder, "missing"))[2], "the reason why a file cannot be read")
    with open("/dev/full", "w") as full:
        for arguments, code in (((worked,), 70), ((worked, "--memory-limit", "40K"), 3)):
            done = subprocess.run([checker, *arguments], stdout=full, stderr=subprocess.DEVNULL, timeout=60)
            expect(done.returncode == code, "nowhere to write: %s %d" % (arguments, done.returncode))


def check_claims(checker, claims):
    """What a report says of claims that fail, and of some cells; and columns."""
    some = {claim["id"]: claim["objects"] for claim in json.loads(run(checker, claims, "--json", "--cells", "2-5")[1])["claims"]}
    expect([some[name] for name in ("H-ball", "H-offset", "L1", "L5", "L7", "L10", "L18", "L18b", "L20")] == [4, 2, 2, 1, 2, 2, 4, 4, 4], "the objects of cells 2 to 5")
    # Each object that fails is counted once: both ends, both points; of two vertices, the pair.
    for name, lemma, objects, count in (("H-angle", "H-angle", 4, 2), ("L6-last", "L6", 21, 2), ("L21-vertices", "L21", 2, 1), ("L18", "L18", 1, 1), ("no-h-L1", "L1", 0, 0)):
        report = json.loads(run(checker, os.path.join(CERTIFICATES, "reject", "claim-%s.cert" % name), "--json")[1])
        claim = next(claim for claim in report["claims"] if claim["id"] == lemma)
        expect((claim["objects"], claim["failures"]) == (objects, count), "%s: %s" % (name, claim))
    expected = {path: answer for path, _, answer in manifest()}
    for name in ("claim-L1-last-cell", "claim-L9", "claim-L13", "claim-L16"):
        path = os.path.join("reject", name + ".cert")
        number = re.search(r"cell-(\d+)", expected[path]).group(1)
        got = run(checker, os.path.join(CERTIFICATES, path), "--cells", "%s-%s" % (number, number))
        expect(last_line(got[1]) == expected[path], "%s, the cell at fault alone: %s" % (name, last_line(got[1])))
    for name, column in (("claims-h-zero", 3), ("claims-angle-one", 9), ("claims-ball-twice", 6), ("claims-row-B-second", 29)):
        error = run(checker, os.path.join(CERTIFICATES, "malformed", name + ".cert"))[2]
        expect(re.search(r"\.cert:\d+:%d: error" % column, error), "the column of %s: %s" % (name, error))


def check_pipe(checker, folder, worked):
    """A certificate that arrives in pieces, and one that never does: the time limit and the signals end the wait."""
    pipe = os.path.join(folder, "pieces")
    os.mkfifo(pipe)
    with open(worked, "rb") as file:
        text = file.read()
    process = subprocess.Popen([checker, "--quiet", pipe], stdout=subprocess.PIPE, text=True)
    with open(pipe, "wb", buffering=0) as out:
        for piece in (text[:2], text[2:3], text[3:300], text[300:]):
            try:
                out.write(piece)
            except BrokenPipeError:
                break
            time.sleep(0.1)
    expect(process.communicate()[0] == "s VERIFIED\n", "a certificate in pieces")
    pipe = os.path.join(folder, "pipe")
    os.mkfifo(pipe)
    keep = os.open(pipe, os.O_RDWR)
    expect(run(checker, pipe, "--time-limit", "0.1")[:2] == (3, "s UNDECIDED time-limit\n"), "--time-limit")
    expect(run(checker, pipe, "--time-limit", "0") == (3, "s UNDECIDED time-limit\n", ""), "--time-limit 0")
    for limit in (0.4, 1.2):  # never early
        start = time.monotonic()
        expect(run(checker, pipe, "--json", "--time-limit", str(limit)) == (3, '{"verdict":"UNDECIDED","why":"time-limit"}\n', "s UNDECIDED time-limit\n"), "--time-limit with --json")
        expect(time.monotonic() - start > 0.9 * limit, "--time-limit %g ends early" % limit)
    for number in (signal.SIGINT, signal.SIGTERM):
        process = subprocess.Popen([checker, pipe], stdout=subprocess.PIPE)
        try:
            process.wait(0.3)
        except subprocess.TimeoutExpired:
            process.send_signal(number)
        expect(process.wait() == 130, "signal %d" % number)
        process.stdout.close()
    os.close(keep)


def check_mutations(checker):
    with open(os.path.join(CERTIFICATES, "accept", "worked-example.cert"), "rb") as file:
        text = file.read()
    other = b"0129a-/ \nftCR"

    def mutate(place):
        bad = []
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "mutant.cert")
            values = [text[place] ^ 1, text[place] ^ 0x80, other[place % len(other)], other[(place * 7 + 3) % len(other)]]
            changed = [text[:place] + bytes([v]) + text[place + 1:] for v in values if v != text[place]]
            for data in changed + [text[:place] + text[place + 1:], text[:place]]:
                with open(path, "wb") as out:
                    out.write(data)
                code = run(checker, path, "--quiet")[0]
                if code not in (2, 3, 5):
                    bad.append("mutation of byte %d: exit code %d: %r" % (place, code, data[max(0, place - 10):place + 10]))
        return bad

    with ThreadPoolExecutor(2) as pool:
        for bad in pool.map(mutate, range(len(text))):
            for message in bad:
                expect(False, message)


def main():
    checker = os.path.abspath(sys.argv[1])
    if "--command-line" in sys.argv:
        check_command_line(checker)
        return 1 if failures else 0
    cases = check_manifest()
    with ThreadPoolExecutor(2) as pool:
        list(pool.map(lambda case: check_case(checker, *case), cases))
    check_reports(checker, cases)
    check_command_line(checker)
    if "--no-mutations" not in sys.argv:
        check_mutations(checker)
    print("%d certificates, %d failures" % (len(cases), len(failures)))
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
