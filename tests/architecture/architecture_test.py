#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""architecture_test.py: the rules of the house that a compiler does not know. Reads the tracked files (or all, without git)."""
import os
import re
import subprocess
import sys

ROOT = os.path.normpath(os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", ".."))
# A folder of core/ includes only itself and what stands before it.
LAYERS = ("numbers", "complex", "io", "features", "planar", "tetrahedra", "placement", "audit")
CODE = (".h", ".cpp")
SOURCES = CODE + (".py", ".sh", ".ml", ".v")
SCRIPTS = ("run", ".ci/run")
MOST_LINES = 600
LICENCES = {"checkers/": "Apache-2.0", "proofs/coq/checker/": "Apache-2.0"}  # the rest is GPL-3.0-or-later
EITHER_LICENCE = re.compile(r"tests/checkers/")  # belongs to the checker or to the suite
NO_HEADER = re.compile(r"proofs/coq/(?!checker/)")  # LICENSE holds

failures = []


def fail(path, line, message):
    failures.append("%s:%d: %s" % (path, line, message))


def tracked_files():
    done = subprocess.run(["git", "-C", ROOT, "ls-files", "-z"], capture_output=True)
    if done.returncode == 0:
        names = done.stdout.decode().split("\0")
    else:
        names = [os.path.relpath(os.path.join(folder, name), ROOT) for folder, _, files in os.walk(ROOT) for name in files]
        names = [name for name in names if not name.startswith(("build/", "."))]
    return sorted(name for name in names if name and os.path.isfile(os.path.join(ROOT, name)))


def lines_of(path):
    with open(os.path.join(ROOT, path), encoding="utf-8") as file:
        return file.read().split("\n")


def includes(lines):
    for number, line in enumerate(lines, 1):
        match = re.match(r'\s*#\s*include\s*([<"])([^>"]+)[>"]', line)
        if match:
            yield number, match.group(1), match.group(2)


def check_checkers(path, lines):
    """The checker shares nothing with what makes certificates: it includes its own folder, the system, GMP, libcrypto and zstd."""
    allowed = re.compile(r"[a-z_0-9]+$|(gmp|gmpxx|zstd|zstd_errors|fcntl|unistd|signal|poll|errno|malloc)\.h$|(sys|openssl|linux)/[a-z_0-9]+\.h$")
    for number, bracket, name in includes(lines):
        if bracket == '"':
            if not os.path.isfile(os.path.join(ROOT, os.path.dirname(path), name)) or ".." in name:
                fail(path, number, "a checker includes something outside its folder: " + name)
        elif not allowed.match(name):
            fail(path, number, "a checker includes " + name)
    for number, line in enumerate(lines, 1):
        if re.search(r"(?<!static_)\bassert\s*\(", line) or re.search(r"\bNDEBUG\b|<cassert>|<assert.h>", line):
            fail(path, number, "a verdict must not rest on an assertion that vanishes in release")
        if re.search(r"\b(confidel::|CGAL)", line):
            fail(path, number, "a checker names the other side")


def check_core(path, lines):
    own = LAYERS.index(path.split("/")[1])
    for number, _, name in includes(lines):
        parts = name.split("/")
        if parts[0] in ("proofs", "campaigns", "apps", "checkers", "tests"):
            fail(path, number, "core includes " + name)
        if parts[0] == "core" and (parts[1] not in LAYERS or LAYERS.index(parts[1]) > own):
            fail(path, number, "%s includes a later layer: %s" % (LAYERS[own], name))


def check_others(path, lines):
    order = ("core", "proofs", "campaigns", "apps")
    own = path.split("/")[0]
    for number, _, name in includes(lines):
        first = name.split("/")[0]
        if first in ("checkers", "tests") or (first in order and order.index(first) > order.index(own)):
            fail(path, number, "%s includes %s" % (own, name))


def check_source(path, lines):
    head = "\n".join(lines[:4])
    expected = next((licence for folder, licence in LICENCES.items() if path.startswith(folder)), "GPL-3.0-or-later")
    match = re.search(r"SPDX-License-Identifier: (\S+)", head)
    if not match:
        if not NO_HEADER.match(path):
            fail(path, 1, "no SPDX header")
    elif match.group(1) != expected and not EITHER_LICENCE.match(path):
        fail(path, 1, "licence %s, expected %s" % (match.group(1), expected))
    if len(lines) - 1 > MOST_LINES:
        fail(path, MOST_LINES, "%d lines: too long to be read in one sitting" % (len(lines) - 1))
    for number, line in enumerate(lines, 1):
        if re.search(r"\b(TODO|FIXME|XXX|HACK)\b", line) and not path.startswith("tests/architecture/"):
            fail(path, number, "unfinished: " + line.strip())
    if path.endswith(".h") and "#pragma once" not in lines:
        fail(path, 1, "no #pragma once")


def check_suites(files):
    """tests/CMakeLists.txt finds suites by their lines: one that it does not find would never run."""
    homes = {}
    for path in files:
        if not (path.startswith("tests/") and path.endswith(".cpp")) or path.endswith(("_fuzz.cpp", "_driver.cpp")):  # the nightly scripts compile these
            continue
        if path.startswith("tests/checkers/"):  # programs of their own: the suite's tests do not link the checker
            continue
        found = 0
        for number, line in enumerate(lines_of(path), 1):
            if "BOOST_AUTO_TEST_SUITE(" not in line and "BOOST_FIXTURE_TEST_SUITE(" not in line:
                continue
            match = re.fullmatch(r"BOOST_AUTO_TEST_SUITE\(([a-z_0-9]+)\)", line)
            if not match:
                fail(path, number, "not a line that tests/CMakeLists.txt finds: " + line)
                continue
            found += 1
            if match.group(1) in homes:
                fail(path, number, "suite %s is in %s too" % (match.group(1), homes[match.group(1)]))
            homes[match.group(1)] = path
        if path.endswith("_test.cpp") and found == 0:
            fail(path, 1, "no suite")
        if not path.endswith("_test.cpp") and path != "tests/main.cpp":
            fail(path, 1, "not compiled: its name does not end in _test.cpp")


def self_test():
    """The rules can fail."""
    bad = [(check_checkers, "checkers/gmp/x.cpp", '#include "core/numbers/point.h"'), (check_checkers, "checkers/gmp/x.cpp", "#include <CGAL/enum.h>"),
           (check_checkers, "checkers/gmp/x.cpp", '#include "../../core/numbers/point.h"'), (check_checkers, "checkers/gmp/x.cpp", "  assert(x > 0);"),
           (check_core, "core/numbers/x.h", '#include "core/planar/frame.h"'), (check_core, "core/features/x.h", '#include "core/placement/graded.h"'),
           (check_core, "core/io/x.h", '#include "apps/command.h"'), (check_others, "proofs/certificate/x.h", '#include "apps/command.h"'),
           (check_source, "core/x.h", "// no licence"), (check_source, "core/x.cpp", "// SPDX-License-Identifier: GPL-3.0-or-later\n// TODO")]
    good = [(check_checkers, "checkers/gmp/x.cpp", "#include <gmp.h>\n#include <vector>\nstatic_assert(true);"),
            (check_core, "core/placement/x.h", '#include "core/features/features.h"\n#include "core/placement/graded.h"')]
    for rule, path, text in bad:
        before = len(failures)
        rule(path, text.split("\n"))
        if len(failures) == before:
            sys.exit("the rule does not see %r" % text)
        del failures[before:]
    for rule, path, text in good:
        rule(path, text.split("\n"))
    if failures:
        sys.exit("the rule sees what is not there: %s" % failures)


def main():
    self_test()
    files = tracked_files()
    sources = [path for path in files if path.endswith(SOURCES) or path in SCRIPTS]
    for path in sources:
        lines = lines_of(path)
        check_source(path, lines)
        if not path.endswith(CODE):
            continue
        if path.startswith("checkers/"):
            check_checkers(path, lines)
        elif path.startswith("core/"):
            check_core(path, lines)
        elif path.startswith(("proofs/", "campaigns/", "apps/")):
            check_others(path, lines)
    check_suites(files)
    print("\n".join(failures))
    print("%d files, %d sources, %d failures" % (len(files), len(sources), len(failures)))
    if len(sources) < 100:
        sys.exit("too few files: is this the repository?")
    sys.exit(1 if failures else 0)


main()
