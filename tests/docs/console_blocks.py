#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The `console` blocks of README.md and docs/*.md: every command runs, and says what the page says: console_blocks.py BIN [--update]

Numbers may differ (placement improves, machines are fast or slow), words may not; the verdict's line is compared as it is.
--update writes what the commands say now. A block that shows no output at all is run without comparing, and stays so.
A block `console needs-peers` uses Debian's tetgen and the shared folder's data (as tests/pipeline/data_test.py finds it): without them it is
left out, and that is said. Its commands may end with exit code 1, an audit's refutation.
"""
import os
import re
import shutil
import subprocess
import sys
import tempfile

ROOT = os.path.normpath(os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", ".."))
SHARED = os.environ.get("CONFIDEL_SHARED") or os.path.join(os.path.dirname(ROOT), "shared")
BLOCK = re.compile(r"^```console( needs-peers)?\n(.*?)^```$", re.M | re.S)


def run(command, folder, path):
    environment = dict(os.environ, PATH=path + os.pathsep + os.environ["PATH"])
    return subprocess.run(["bash", "-c", command], cwd=folder, env=environment, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                          stderr=subprocess.STDOUT, text=True, timeout=120)


def steps(block):
    """Pairs of a command and the lines shown below it."""
    result = []
    for line in block.splitlines():
        if line.startswith("$ "):
            result.append((line[2:], []))
        elif not result:
            raise SystemExit("a console block begins without a command: " + line)
        else:
            result[-1][1].append(line)
    return result


def shape(line):
    if line.startswith("s "):
        return line
    line = re.sub(r"\b[0-9a-f]{64}\b", "DIGEST", line)
    return re.sub(r"\d[\d.,]*(e[-+]?\d+)?", "N", line)


def compare(command, shown, said):
    if [shape(line) for line in shown] != [shape(line) for line in said]:
        return ["$ %s: the page shows\n%s\nbut it says\n%s" % (command, "\n".join(shown), "\n".join(said))]
    return []


def check_page(page, path, update, failures):
    """The number of commands that were run."""
    with open(page, encoding="utf-8") as file:
        text = file.read()
    commands, before = 0, len(failures)
    have_peers = shutil.which("tetgen") and os.path.isdir(os.path.join(SHARED, "data", "3d"))
    with tempfile.TemporaryDirectory() as folder:
        os.symlink(os.path.join(ROOT, "examples"), os.path.join(folder, "examples"))
        if have_peers:
            os.symlink(os.path.join(SHARED, "data", "3d"), os.path.join(folder, "data"))

        def renew(match):
            nonlocal commands
            peers = match.group(1) or ""
            if peers and not have_peers:
                print("%s: a block left out: it needs tetgen and the folder %s/data/3d" % (os.path.relpath(page, ROOT), SHARED))
                return match.group(0)
            new, block = "", steps(match.group(2))
            with_output = any(shown for _, shown in block)
            for command, shown in block:
                commands += 1
                done = run(command, folder, path)
                said = done.stdout.splitlines()
                if done.returncode not in ((0, 1) if peers else (0,)):
                    failures.append("%s: $ %s: exit code %d\n%s" % (os.path.relpath(page, ROOT), command, done.returncode, done.stdout))
                if with_output and not update:
                    failures.extend(os.path.relpath(page, ROOT) + ": " + each for each in compare(command, shown, said))
                new += "$ %s\n" % command + ("".join(line + "\n" for line in said) if with_output else "")
            return "```console%s\n%s```" % (peers, new)

        renewed = BLOCK.sub(renew, text)
    if update and len(failures) == before and renewed != text:
        with open(page, "w", encoding="utf-8") as file:
            file.write(renewed)
    return commands


def main():
    arguments = [argument for argument in sys.argv[1:] if argument != "--update"]
    if len(arguments) != 1:
        raise SystemExit(__doc__)
    docs = os.path.join(ROOT, "docs")
    pages = [os.path.join(ROOT, "README.md")] + sorted(os.path.join(docs, name) for name in os.listdir(docs) if name.endswith(".md"))
    failures, commands = [], 0
    for page in pages:
        commands += check_page(page, os.path.abspath(arguments[0]), "--update" in sys.argv, failures)
    for failure in failures:
        print("FAILED " + failure)
    print("%d commands, %d failures%s" % (commands, len(failures), "; python3 tests/docs/console_blocks.py BIN --update" if failures else ""))
    return 1 if failures or not commands else 0


if __name__ == "__main__":
    sys.exit(main())
