#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The campaign commands as a user has them: campaign_test.py BIN"""
import glob
import json
import os
import shutil
import signal
import subprocess
import sys
import tempfile
import time

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.join(HERE, "..", "pipeline"))
from harness import Programs, content, last_line

# Rejects every certificate of a complex with at least two facets, as a broken producer would make it.
FALSE_CHECKER = r"""#!/bin/sh
case "$1" in --version) exit 0 ;; esac
facets=$(sed -n 's/^facets //p' "$1")
if [ "$facets" -ge 2 ]; then echo '{}'; echo 's REJECTED emptiness 7 cell-0-point-1' >&2; exit 5; fi
echo '{}'; echo 's VERIFIED' >&2
"""


def records(folder):
    result = []
    for path in sorted(glob.glob(os.path.join(folder, "block-*.jsonl"))):
        result += [json.loads(line) for line in open(path)]
    for record in result:
        record.pop("seconds", None)
    return result


def same_lines(folder):
    """What a folder says, without what differs from run to run."""
    return [json.dumps(record, sort_keys=True) for record in records(folder)]


def check_generate(programs, folder):
    code, out, _ = programs.run("generate", "--list")
    names = [line.split()[0] for line in out.splitlines()]
    programs.expect(code == 0 and len(names) > 25 and "wedge" in names, "generate --list")
    stem = os.path.join(folder, "made")
    for name in names:
        code, out, err = programs.run("generate", name, "--seed", 18446744073709551615)
        again = programs.run("generate", name, "--seed", 18446744073709551615)
        programs.expect(code == 0 and out == again[1] and out.startswith("# confidel generate"), "generate %s: %d %s" % (name, code, err))
        programs.expect(programs.run("generate", name, "-o", stem + name)[0] == 0, "generate %s -o" % name)
        made = glob.glob(stem + name + ".*")
        if programs.expect(len(made) == 1, "one file is made: %s" % made):
            code = programs.run("info", made[0])[0]
            programs.expect(code == (2 if name == "invalid" else 0), "info of %s: %d" % (name, code))
    for arguments in (["generate"], ["generate", "nothing"], ["generate", "wedge", "-o", stem + ".off"], ["generate", "wedge", "--seed", "-1"]):
        code, out, err = programs.run(*arguments)
        programs.expect(code == 2 and "error[E-USAGE]" in err and out == "", "%s: %d %s" % (arguments, code, err))


def check_runs(programs, folder):
    whole, cut = os.path.join(folder, "whole"), os.path.join(folder, "cut")
    options = ["--seeds", "3..20", "--block", "4", "--strategy", "lean,graded", "--max-points", "2000"]
    code, out, err = programs.run("campaign", "run", *options, "--out", whole)
    programs.expect(code == 0 and last_line(out) == "36 runs, 0 in blocks that were there already, 0 unexpected", "campaign run: %d %s %s" % (code, out, err))
    programs.expect(sorted(os.listdir(whole)) == ["block-%08d-%08d.jsonl" % (a, min(a + 3, 20)) for a in range(3, 21, 4)] + ["campaign.json"], "what is in the folder: %s" % os.listdir(whole))
    before = {name: content(os.path.join(whole, name)) for name in os.listdir(whole)}
    code, out, err = programs.run("campaign", "run", *options, "--out", whole)
    programs.expect(code == 0 and last_line(out) == "0 runs, 36 in blocks that were there already, 0 unexpected", "again: %s" % out)
    programs.expect(before == {name: content(os.path.join(whole, name)) for name in os.listdir(whole)}, "a second run changes nothing")
    for shard in (1, 0, 2):
        if shard == 2:
            code, _, err = programs.run("campaign", "cover", cut)
            programs.expect(code == 5 and "missing" in err, "a missing shard: %d %s" % (code, err))
        code, out, err = programs.run("campaign", "run", *options, "--out", cut, "--shard", "%d/3" % shard, "-j", "1")
        programs.expect(code == 0, "shard %d: %d %s" % (shard, code, err))
    programs.expect(same_lines(whole) == same_lines(cut), "shards say what one run says")
    code, out, err = programs.run("campaign", "cover", cut, "--replay", "3")
    programs.expect(code == 0 and last_line(out) == "36 records of 18 seeds, 0 unexpected", "cover: %d %s %s" % (code, last_line(out), err))
    lines = out.splitlines()
    programs.expect(any(line.startswith("| all | lean | 18 |") for line in lines) and any(line.startswith("| power | graded |") for line in lines), "the summary: " + out)
    for arguments in (["--seeds", "3..20", "--out", whole], ["--seeds", "0..", "--out", folder], ["--seeds", "5..3", "--out", folder], ["--seeds", "0..3", "--out", folder, "--shard", "3/3"],
                      ["--seeds", "0..3", "--out", folder, "--family", "nothing"], ["--seeds", "0..3", "--out", folder, "--strategy", "lean,hopeful"]):
        code, out, err = programs.run("campaign", "run", *arguments)
        programs.expect(code == 2 and "error[E-USAGE]" in err, "%s: %d %s" % (arguments, code, err))
    programs.expect(programs.run("campaign", "cover", os.path.join(folder, "nowhere"))[0] == 4, "cover without a campaign")
    return whole


def check_forgeries(programs, whole, folder):
    """Whatever is changed, left out or added is refused."""
    def forged(name, change):
        copy = os.path.join(folder, "forged")
        shutil.rmtree(copy, ignore_errors=True)
        shutil.copytree(whole, copy)
        change(copy)
        code, out, err = programs.run("campaign", "cover", copy, "--replay", "36")
        programs.expect(code == 5 and "error[E-COVER]" in err and "s " not in out[:2], "forged: %s: %d %s" % (name, code, err))

    block = "block-00000007-00000010.jsonl"

    def edit(old, new):
        def change(copy):
            path = os.path.join(copy, block)
            text = open(path).read()
            assert old in text, old
            open(path, "w").write(text.replace(old, new, 1))
        return change

    def rewritten(change_records):
        """With a digest that is right: only generating or running again can tell."""
        def change(copy):
            path = os.path.join(copy, block)
            lines = [json.loads(line) for line in open(path)]
            change_records(lines[:-1])
            import hashlib
            text = "".join(json.dumps({k: v for k, v in line.items() if k != "seconds"}, separators=(",", ":")) + "\n" for line in lines[:-1])
            lines[-1]["sha256"] = hashlib.sha256(text.encode()).hexdigest()
            open(path, "w").write("".join(json.dumps(line, separators=(",", ":")) + "\n" for line in lines))
        return change

    forged("a missing block", lambda copy: os.remove(os.path.join(copy, block)))
    forged("an overlapping block", lambda copy: shutil.copy(os.path.join(copy, block), os.path.join(copy, "block-00000008-00000010.jsonl")))
    forged("another block's records", lambda copy: shutil.copy(os.path.join(copy, "block-00000003-00000006.jsonl"), os.path.join(copy, block)))
    forged("a changed record", edit('"expected":true', '"expected":false'))
    forged("no digest", lambda copy: open(os.path.join(copy, block), "w").close())
    forged("text", edit("{", "["))
    forged("another program", edit('"confidel":"', '"confidel":"0'))
    forged("another input", rewritten(lambda lines: lines[0].update(input="0" * 64)))
    forged("another result", rewritten(lambda lines: lines[0].update(verdict="s UNDECIDED max-points reached=7")))


def check_interruption(programs, folder):
    out = os.path.join(folder, "interrupted")
    process = subprocess.Popen([programs.confidel, "campaign", "run", "--seeds", "0..400", "--block", "2", "--out", out], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    deadline = time.time() + 120
    while time.time() < deadline and not glob.glob(os.path.join(out, "block-*.jsonl")):
        time.sleep(0.05)
    process.send_signal(signal.SIGINT)
    programs.expect(process.wait(60) == 130, "the exit code of an interruption")
    programs.expect(all(name.endswith((".jsonl", "campaign.json")) for name in os.listdir(out)), "an interruption leaves %s" % os.listdir(out))
    before = {name: content(os.path.join(out, name)) for name in os.listdir(out) if name.startswith("block-")}
    process = subprocess.run([programs.confidel, "campaign", "run", "--seeds", "0..400", "--block", "2", "--out", out, "--shard", "0/50"], capture_output=True, text=True)
    programs.expect(process.returncode == 0, "resuming: " + process.stderr)
    programs.expect(all(content(os.path.join(out, name)) == text for name, text in before.items()), "what was there stays")


def check_failures(programs, folder):
    """A checker that rejects: stored, shrunk, and the campaign fails."""
    binaries = os.path.join(folder, "bin")
    os.makedirs(binaries)
    shutil.copy(programs.confidel, binaries)
    checker = os.path.join(binaries, "confidel-check")
    with open(checker, "w") as file:
        file.write(FALSE_CHECKER)
    os.chmod(checker, 0o755)
    false = os.path.join(binaries, "confidel")
    out = os.path.join(folder, "failing")
    code, said, err = programs.run("campaign", "run", "--family", "fan", "--seeds", "0..1", "--out", out, program=false)
    programs.expect(code == 1 and said.count("UNEXPECTED fan") == 2, "a rejected certificate is unexpected: %d %s %s" % (code, said, err))
    stored = os.path.join(out, "failures", "fan-0-lean")
    programs.expect(sorted(os.listdir(stored)) == ["command.txt", "input.cert", "input.smesh", "record.json", "shrunk.smesh"], "what is stored: %s" % os.listdir(stored))
    shrunk = json.loads(programs.run("info", os.path.join(stored, "shrunk.smesh"), "--json")[1])
    programs.expect(shrunk["facets"] == 2 and shrunk["vertices"] <= 6, "shrunk to two facets: %s" % shrunk)
    programs.expect(json.load(open(os.path.join(stored, "record.json")))["outcome"] == "rejected", "the record")
    command = open(os.path.join(stored, "command.txt")).read().split()
    programs.expect(command[:3] == ["confidel", "conform", "input.smesh"], "the command")
    again = subprocess.run([false, *command[1:]], cwd=stored, capture_output=True, text=True)
    programs.expect(again.returncode == 70, "the stored command shows it again: %d" % again.returncode)
    programs.expect(programs.run("campaign", "cover", out, program=false)[0] == 1, "cover of a failed campaign")

    small = os.path.join(folder, "small.smesh")
    code, said, err = programs.run("shrink", os.path.join(stored, "input.smesh"), "--keep", "rejected:emptiness", "-o", small, program=false)
    programs.expect(code == 0 and os.path.exists(small), "shrink: %d %s" % (code, err))
    code, said, err = programs.run("falsify", "power", "--time-limit", "20", "--out", os.path.join(folder, "found"), program=false)
    programs.expect(code == 1 and last_line(said).startswith("s REJECTED emptiness"), "falsify finds what is rejected: %d %s %s" % (code, said, err))
    found = json.loads(programs.run("info", os.path.join(folder, "found", "power-lean-violation-shrunk.smesh"), "--json")[1])
    programs.expect(found["facets"] == 2, "falsify shrinks it")


def check_shrink(programs, folder):
    source, small = os.path.join(folder, "many.smesh"), os.path.join(folder, "few")
    programs.run("generate", "two-skeleton", "--seed", "3", "-o", source)
    code, out, err = programs.run("shrink", source, "--keep", "verified", "-o", small)
    programs.expect(code == 0, "shrink: %d %s" % (code, err))
    info = json.loads(programs.run("info", small + ".smesh", "--json")[1])
    programs.expect(info["facets"] == 1 and info["vertices"] == 3, "one triangle is enough to be verified: %s" % info)
    for keep in ("rejected", "refuted:L10", "nonsense"):
        code, out, err = programs.run("shrink", source, "--keep", keep, "-o", small + "-not")
        programs.expect(code == 2 and "error[E-USAGE]" in err, "--keep %s: %d %s" % (keep, code, err))
    programs.expect(not glob.glob(small + "-not*"), "nothing is left")


def check_falsify(programs, folder):
    out = os.path.join(folder, "tight")
    code, said, err = programs.run("falsify", "power", "--strategy", "graded", "--max-points", "2000", "--time-limit", "4", "--out", out)
    programs.expect(code == 3 and last_line(said).startswith("s UNDECIDED time-limit smallest="), "falsify power: %d %s %s" % (code, said, err))
    kept = glob.glob(os.path.join(out, "power-graded-*"))
    programs.expect(kept and all(programs.run("info", path)[0] == 0 for path in kept), "the tightest inputs are kept: %s" % kept)
    # From a random start: the paper's strategy violates its Lemma 10.
    code, said, err = programs.run("falsify", "L10", "--strategy", "paper", "--time-limit", "60", "--out", out)
    programs.expect(code == 1 and last_line(said).startswith("s REFUTED L10 "), "falsify L10: %d %s %s" % (code, said, err))
    small = json.loads(programs.run("info", os.path.join(out, "L10-paper-violation-shrunk.smesh"), "--json")[1])
    programs.expect(small["vertices"] <= 5 and small["facets"] <= 3, "the violation of L10 is small: %s" % small)
    code, said, err = programs.run("falsify", "L99", "--time-limit", "60", "--out", out)
    programs.expect(code == 2 and "error[E-USAGE]" in err and "power" in err, "a lemma that nothing reports: %d %s" % (code, err))
    programs.expect(not glob.glob(os.path.join(out, "work-*")), "work files are gone")


def check_cover_cells(programs, folder):
    """Reports on some cells, put together."""
    certificate, other = (os.path.join(HERE, "..", "certificates", "accept", name) for name in ("claim-all-dim3.cert", "dim3-circle.cert"))
    cells = json.loads(programs.run(certificate, "--json", program=programs.checker)[1])["records"]["cells"]

    def part(first, last, of=certificate, change=None):
        path = os.path.join(folder, "part-%d.json" % len(os.listdir(folder)))
        text = programs.run(of, "--json", "--cells", "%d-%d" % (first, last), program=programs.checker)[1]
        if change:
            report = json.loads(text)
            change(report)
            text = json.dumps(report)
        open(path, "w").write(text)
        return path

    def cover(*arguments):
        code, out, err = programs.run("campaign", "cover-cells", certificate, *arguments)
        return code, last_line(out) if code == 0 else err

    a, b, c, middle = part(0, 4), part(5, 8), part(9, 10 * cells), part(4, 8)
    whole = os.path.join(folder, "whole.json")
    open(whole, "w").write(programs.run(certificate, "--json", program=programs.checker)[1])
    for arguments in ((a, b, c), (c, a, b, "--replay", 3), (whole,), (whole, "--replay", 1), (part(0, cells - 1), "--replay", 1)):
        programs.expect(cover(*arguments) == (0, "s VERIFIED"), "cover-cells of all cells: %s %s" % (arguments, cover(*arguments)))

    def stretch(report):
        report["cells-checked"] = [5, 9]
        report["why"] = "cells-5-9"

    def consistent(report):
        report["claims"][6]["objects"] += 1

    def decided(report):
        report["verdict"], report["exit"] = "VERIFIED", 0

    for reports, why in [((a, c), "cells 5 to 8 are in no report"), ((b, c), "cells 0 to 4 are in no report"), ((a, b), "cells 9 to"), ((a, middle, c), "overlaps"), ((a, b, b, c), "overlaps"), ((whole, c), "overlaps"),
                         ((a, part(5, 8, other), c), "another certificate"), ((a, b, c, part(10 * cells, 11 * cells)), "checks no cell"),
                         ((a, part(5, 8, change=stretch), part(10, cells)), "was changed"), ((a, part(5, 8, change=lambda report: report["rules"].update(tiling=99)), c), "was changed"),
                         ((a, part(5, 8, change=lambda report: report.update(verdict="REJECTED", exit=5)), c), "not accepted"), ((a, part(5, 8, change=decided), c), "contradicts itself"),
                         ((a, part(5, 8, change=lambda report: report.update(why="time-limit")), c), "not accepted"), ((a, part(5, 8, change=lambda report: report.update(why="cells-5-9")), c), "contradicts itself"),
                         ((a, part(5, 8, change=lambda report: report.pop("rules")), c), "no complete report"), ((a, part(5, 8, change=lambda report: report.update({"cells-checked": "x"})), c), "no report"),
                         ((a, certificate, c), "no report"), ((a, part(5, 8, change=consistent), c, "--replay", 3), "finds something else")]:
        code, said = cover(*reports)
        programs.expect(code == 5 and "error[E-COVER]" in said and why in said, "cover-cells refuses (%s): %d %s" % (why, code, said))
    programs.expect(cover(a, os.path.join(folder, "missing"))[0] == 4, "a report that is not there")
    rejected = os.path.join(HERE, "..", "certificates", "reject", "emptiness-off-plane-in.cert")
    code, _, err = programs.run("campaign", "cover-cells", rejected, part(1, 1, rejected))
    programs.expect(code == 5 and "does not accept" in err, "a certificate that is rejected: %d %s" % (code, err))


def main():
    programs = Programs(sys.argv[1])
    with tempfile.TemporaryDirectory() as folder:
        check_generate(programs, folder)
        whole = check_runs(programs, folder)
        check_forgeries(programs, whole, folder)
        check_interruption(programs, folder)
        check_failures(programs, folder)
        check_shrink(programs, folder)
        check_falsify(programs, folder)
        check_cover_cells(programs, tempfile.mkdtemp(dir=folder))
    programs.finish()


main()
