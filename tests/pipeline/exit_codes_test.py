#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""exit_codes_test.py BINARIES: every exit code of docs/certificate-format.md section 6, of every program that can end with it, one by one."""
import os
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import time

import inputs
from harness import EXAMPLES, ROOT, Programs, last_line

CUBE, W3 = os.path.join(EXAMPLES, "cube.off"), os.path.join(EXAMPLES, "w3.smesh")
CERTIFICATES = os.path.join(ROOT, "tests", "certificates")


def interrupted(command):
    process = subprocess.Popen([str(part) for part in command], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    time.sleep(0.3)
    process.send_signal(signal.SIGINT)
    return process.wait()


def main():
    programs = Programs(sys.argv[1])
    tested = set()

    def expect(code, name, *arguments, program=None, line=None):
        got, out, err = programs.run(*arguments, program=program)
        programs.expect(got == code, "%s: exit %d where %d is right: %s" % (name, got, code, err[-200:]))
        if line is not None:
            programs.expect(re.match(line, last_line(out)), "%s: last line %r" % (name, last_line(out)))
        tested.add(code)

    with tempfile.TemporaryDirectory() as folder:
        inside = lambda name: os.path.join(folder, name)
        cert = inside("c.cert")
        moved = inside("moved.node")
        with open(moved, "w") as file:
            file.write("4 3 0 0\n0 0 0 0\n1 1 0 0\n2 0 1 0\n3 0 0 1\n")
        sharp = inside("sharp.off")
        with open(sharp, "w") as file:
            file.write(inputs.wedge(0.25, 0.3))
        with open(inside("bad.off"), "w") as file:
            file.write("OFF\n")
        for name, arguments in (("info", (CUBE,)), ("canonical", (CUBE,)), ("conform", (CUBE, "-o", cert)), ("explain", ("L1",)), ("convert", (CUBE, inside("c.obj"))),
                                ("audit", (CUBE, os.path.join(EXAMPLES, "cube-mesh.node"))), ("completion", ("bash",)), ("manual", ())):
            expect(0, name, name, *arguments)
        expect(0, "checker", cert, program=programs.checker, line="s VERIFIED$")
        expect(1, "audit", "audit", CUBE, moved, line="s REFUTED conforms ")
        for name, arguments in (("info", (inside("bad.off"),)), ("canonical", (inside("bad.off"),)), ("conform", (inside("bad.off"), "-o", inside("x"))), ("explain", ("nothing",)),
                                ("convert", (inside("bad.off"), inside("x.off"))), ("audit", (CUBE, inside("bad.off"))), ("completion", ("csh",)), ("manual", ("nothing",)), ("nothing", ())):
            expect(2, name, name, *arguments)
        expect(2, "checker", inside("bad.off"), program=programs.checker)
        expect(3, "conform", "conform", W3, "-o", inside("x.cert"), "--strategy", "graded", "--max-points", 50, line="s UNDECIDED max-points ")
        expect(3, "checker", os.path.join(CERTIFICATES, "decline", "newer.cert"), program=programs.checker, line="s UNDECIDED newer-version")
        hanging, near = inside("h.obj"), inside("near.node")
        with open(hanging, "w") as file:
            file.write("v 0 0 0\nv 4 0 0\nl 1 2\n")
        with open(near, "w") as file:
            file.write("5 3 0 0\n0 0 0 0\n1 4 0 0\n2 2 1 0\n3 2 0 9\n4 2 0 -9\n")
        expect(3, "audit", "audit", hanging, near, line="s UNDECIDED no-certificate")
        for name, arguments in (("info", ("/no/such.off",)), ("canonical", (CUBE, "-o", "/no/such/file")), ("conform", (CUBE, "-o", "/no/such/file")), ("convert", (CUBE, "/no/such/file.off")),
                                ("audit", (CUBE, "/no/such.vtu")), ("manual", ("--output", "/no/such"))):
            expect(4, name, name, *arguments)
        expect(4, "checker", "/no/such.cert", program=programs.checker)
        expect(5, "checker", os.path.join(CERTIFICATES, "reject", "hash.cert"), program=programs.checker, line="s REJECTED hash ")
        alone = inside("alone")
        os.mkdir(alone)
        shutil.copy2(programs.confidel, alone)
        with open(os.path.join(alone, "confidel-check"), "w") as file:
            file.write("#!/bin/sh\necho 's REJECTED emptiness 1 cell-0' >&2\nexit 5\n")
        os.chmod(os.path.join(alone, "confidel-check"), 0o755)
        expect(70, "conform", "conform", CUBE, "-o", cert, program=os.path.join(alone, "confidel"))
        expect(70, "audit", "audit", CUBE, os.path.join(EXAMPLES, "cube-mesh.node"), program=os.path.join(alone, "confidel"))
        code = interrupted([programs.confidel, "conform", sharp, "-o", inside("i.cert"), "--strategy", "graded"])
        programs.expect(code == 130, "interrupted: exit %d" % code)
        tested.add(130)
    with open(os.path.join(ROOT, "docs/certificate-format.md"), encoding="utf-8") as file:
        section = file.read().split("## 6.")[1].split("## 7.")[0]
    stated = {int(code) for code in re.findall(r"^\| (\d+) \|", section, re.M)}
    programs.expect(stated == tested, "codes that are stated: %s, tested: %s" % (sorted(stated), sorted(tested)))
    programs.finish()


main()
