# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs the programs and counts what fails."""
import json
import os
import subprocess
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
ROOT = os.path.normpath(os.path.join(HERE, "..", ".."))
EXAMPLES = os.path.join(ROOT, "examples")


class Programs:
    def __init__(self, binaries):
        self.confidel = os.path.join(os.path.abspath(binaries), "confidel")
        self.checker = os.path.join(os.path.abspath(binaries), "confidel-check")
        self.failures = 0
        self.checks = 0

    def expect(self, good, message):
        self.checks += 1
        if not good:
            self.failures += 1
            print("FAILED " + message, flush=True)
        return good

    def run(self, *arguments, program=None, **options):
        done = subprocess.run([program or self.confidel, *map(str, arguments)], capture_output=True, text=True, **options)
        return done.returncode, done.stdout, done.stderr

    def expect_verified(self, name, path, certificate, *options):
        """conform with --json: the report, or None."""
        code, out, err = self.run("conform", path, "-o", certificate, "--json", *options)
        if not self.expect(code == 0 and last_line(err) == "s VERIFIED", "%s: exit %d, %r, %r" % (name, code, last_line(err), err[-300:])):
            return None
        report = json.loads(out)
        self.expect(report["exit"] == 0 and report["verdict"] == "s VERIFIED", name + ": the report's verdict")
        return report

    def finish(self):
        print("%d checks, %d failures" % (self.checks, self.failures))
        sys.exit(1 if self.failures else 0)


def last_line(text):
    return text.rstrip("\n").split("\n")[-1]


def content(path):
    with open(path, "rb") as file:
        return file.read()
