#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The `console` blocks of README.md and docs/: every command runs, and says what the page says: console_blocks.py BIN [--update]

Numbers may differ (placement improves, machines are fast or slow), words may not; the verdict's line is compared as it is.
--update writes what the commands say now. A block that shows no output at all is run without comparing, and stays so.
"""
import glob
import os
import re
import subprocess
import sys
import tempfile

ROOT = os.path.normpath(os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", ".."))
PAGES = [os.path.join(ROOT, "README.md"), *sorted(glob.glob(os.path.join(ROOT, "docs", "*.md")))]
BLOCK = re.compile(r"^```console\n(.*?)^```$", re.M | re.S)


def run(command, folder, path):
    environment = dict(os.environ, PATH=path + os.pathsep + os.environ["PATH"])
    return subprocess.run(["bash", "-c", command], cwd=folder, env=environment, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                          stderr=subprocess.STDOUT, text=True, timeout=120)


def steps(block, name):
    """Pairs of a command and the lines shown below it."""
    result = []
    for line in block.splitlines():
        if line.startswith("$ "):
            result.append((line[2:], []))
        elif not result:
            raise SystemExit(name + ": a console block begins without a command: " + line)
        else:
            result[-1][1].append(line)
    return result


def shape(line):
    if line.startswith("s "):
        return line
    line = re.sub(r"\b[0-9a-f]{64}\b", "DIGEST", line)
    return re.sub(r"\d[\d.,]*(e[-+]?\d+)?", "N", line)


def compare(name, command, shown, said):
    if [shape(line) for line in shown] != [shape(line) for line in said]:
        return ["%s: $ %s: the page shows\n%s\nbut it says\n%s" % (name, command, "\n".join(shown), "\n".join(said))]
    return []


def check(file, path, update):
    """The number of commands in a page, and what is wrong with it. The blocks of a page share a folder."""
    name = os.path.relpath(file, ROOT)
    page, failures, commands = open(file).read(), [], 0
    with tempfile.TemporaryDirectory() as folder:
        os.symlink(os.path.join(ROOT, "examples"), os.path.join(folder, "examples"))

        def renew(match):
            nonlocal commands
            text, block = "", steps(match.group(1), name)
            with_output = any(shown for _, shown in block)
            for command, shown in block:
                commands += 1
                done = run(command, folder, path)
                said = done.stdout.splitlines()
                if done.returncode != 0:
                    failures.append("%s: $ %s: exit code %d\n%s" % (name, command, done.returncode, done.stdout))
                if with_output and not update:
                    failures.extend(compare(name, command, shown, said))
                text += "$ %s\n" % command + ("".join(line + "\n" for line in said) if with_output else "")
            return "```console\n%s```" % text

        renewed = BLOCK.sub(renew, page)
    if update and not failures and renewed != page:
        open(file, "w").write(renewed)
    return commands, failures


def main():
    arguments = [argument for argument in sys.argv[1:] if argument != "--update"]
    if len(arguments) != 1:
        raise SystemExit(__doc__)
    path, update, commands, failures = os.path.abspath(arguments[0]), "--update" in sys.argv, 0, []
    for file in PAGES:
        more, wrong = check(file, path, update)
        commands += more
        failures += wrong
    for failure in failures:
        print("FAILED " + failure)
    print("%d commands, %d failures%s" % (commands, len(failures), "; python3 tests/docs/console_blocks.py BIN --update" if failures else ""))
    return 1 if failures or not commands else 0


if __name__ == "__main__":
    sys.exit(main())
