#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Mutants of the checker: is every comparison, loop bound, constant and early return of checkers/gmp held by a test?

    mutate_checker.py [--list] [--only REGEX] [--sample N] [--shard I/N] [--jobs 1] [--out FILE]

Each mutant changes one place in one file: a comparison includes equality or no longer does, a loop stops one early, a number is one
more, `&&` becomes `||`, an `if` that leaves never does, a minus is a plus. It is compiled (against a precompiled header, without optimization)
and run on the certificates of tests/certificates, then on run_certificates.py, then on changed certificates, where it must
answer as the original does (which agreement_test.py compares with the verified checker). A mutant that no test notices is a survivor.

Survivors that cannot differ are listed in equivalent.tsv with the reason; the key is file, text of the line, place in it and
change, so that other lines may move. Exit code 1 if a survivor is not listed there, or a listed one is caught.
With --out, results are appended to FILE as lines of JSON and mutants that are there already are not run again."""
import argparse
import concurrent.futures
import hashlib
import json
import os
import random
import re
import shutil
import subprocess
import sys
import tempfile
import threading

HERE = os.path.dirname(os.path.abspath(__file__))
ROOT = os.path.normpath(os.path.join(HERE, "..", "..", ".."))
SOURCE = os.path.join(ROOT, "checkers", "gmp")
CERTIFICATES = os.path.join(ROOT, "tests", "certificates")
EQUIVALENT = os.path.join(HERE, "equivalent.tsv")
sys.path[:0] = [os.path.join(HERE, "..", "verified")]
import mutants as certificate_mutants

FLAGS = ["-std=gnu++20", "-O0", "-w"]
LIBRARIES = ["-lgmp", "-lzstd", "-lcrypto", "-lpthread"]
COMPARISONS = {"<": "<=", "<=": "<", ">": ">=", ">=": ">", "==": "!=", "!=": "=="}
TIMEOUT = 20


def code_only(text):
    """The text with comments, strings, characters and preprocessor lines blanked out, places unchanged."""
    pattern = re.compile(r'//[^\n]*|/\*.*?\*/|"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])*\'|^[ \t]*#[^\n]*', re.S | re.M)
    digit_separator = re.compile(r"(?<=\d)'(?=\d)")
    text = digit_separator.sub("_", text)
    return pattern.sub(lambda match: re.sub(r"[^\n]", " ", match.group(0)), text)


def closing(text, opening):
    """The place of the parenthesis that closes the one at `opening`."""
    depth = 0
    for place in range(opening, len(text)):
        depth += {"(": 1, ")": -1}.get(text[place], 0)
        if depth == 0:
            return place
    raise ValueError("unbalanced")


def mutations_of(text):
    """(place, length, replacement, kind) of every mutation of a file."""
    code = code_only(text)
    for match in re.finditer(r" (<=|>=|==|!=|<|>) ", code):
        yield match.start(1), len(match.group(1)), COMPARISONS[match.group(1)], "comparison"
    for match in re.finditer(r" (&&|\|\|) ", code):
        yield match.start(1), 2, "||" if match.group(1) == "&&" else "&&", "connective"
    for match in re.finditer(r"(?<![\w.'])(\d[\d_]*)(?![\w.'x])", code):
        number = match.group(1)
        line = code[code.rfind("\n", 0, match.start()) + 1:match.start()]
        if re.search(r"\bcase $", line) or "_" in number:
            continue
        yield match.start(1), len(number), str(int(number) + 1), "constant"
    for match in re.finditer(r"\bfor \(", code):
        stop = closing(code, match.end() - 1)
        parts = code[match.end():stop].split(";")
        if len(parts) == 3 and re.search(r" (<|<=) ", parts[1]):
            place = match.end() + len(parts[0]) + 1 + re.search(r" (<|<=) ", parts[1]).start()
            yield place, 0, " + 1", "loop"
    for match in re.finditer(r"\b(if|while) \(", code):
        stop = closing(code, match.end() - 1)
        after = code[stop + 1:stop + 200].lstrip()
        if match.group(1) == "if" and re.match(r"\{?\s*(return|throw|fail|continue|break|die|\w+\.offer|offer|truncated)\b", after):
            if ";" in code[match.end():stop] or re.search(r"\bauto\b", code[match.end():stop]):
                condition = match.end() + code[match.end():stop].rfind(";") + 1
                if condition == match.end():  # if (const auto x = ...): nothing to put in front
                    continue
                yield condition, 0, " false && ", "early"
            else:
                yield match.end(), 0, "false && ", "early"
    for match in re.finditer(r"(?<=[\w)\]]) ([+-]) (?=[\w(])", code):
        yield match.start(1), 1, "-" if match.group(1) == "+" else "+", "arithmetic"


class Mutant:
    def __init__(self, name, text, place, length, replacement, kind):
        start = text.rfind("\n", 0, place) + 1
        end = text.find("\n", place)
        self.file, self.kind, self.line = name, kind, text.count("\n", 0, place) + 1
        self.text = text[:place] + replacement + text[place + length:]
        self.key = "\t".join([name, text[start:end].strip(), str(place - start - (len(text[start:end]) - len(text[start:end].lstrip()))),
                              "%s -> %s" % (text[place:place + length], replacement)])


def all_mutants():
    result, seen = [], {}
    for name in sorted(os.listdir(SOURCE)):
        if name.endswith((".cpp", ".h")):
            text = open(os.path.join(SOURCE, name)).read()
            for mutation in mutations_of(text):
                mutant = Mutant(name, text, *mutation)
                # The same line twice in a file: the second one is told apart by a number.
                seen[mutant.key] = seen.get(mutant.key, 0) + 1
                if seen[mutant.key] > 1:
                    mutant.key += " #%d" % seen[mutant.key]
                result.append(mutant)
    return result


def run(command, **options):
    return subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, timeout=options.pop("timeout", TIMEOUT), **options)


class Build:
    """The original's objects, and which of them include what."""

    def __init__(self, folder):
        self.folder = folder
        self.names = sorted(name for name in os.listdir(SOURCE) if name.endswith(".cpp"))
        headers = set()
        for name in os.listdir(SOURCE):
            if name.endswith((".cpp", ".h")):
                headers.update(re.findall(r"^#include (<[^>]+>)", open(os.path.join(SOURCE, name)).read(), re.M))
        with open(os.path.join(folder, "system.h"), "w") as out:
            out.write("".join("#include %s\n" % header for header in sorted(headers)))
        self.check(["g++", *FLAGS, "-x", "c++-header", os.path.join(folder, "system.h"), "-o", os.path.join(folder, "system.h.gch")])
        self.includes = {name: self.closure(name) for name in self.names}
        self.objects = {}
        for name in self.names:
            self.objects[name] = os.path.join(folder, name + ".o")
            self.check(self.compile_command(SOURCE, name, self.objects[name]))
        self.original = os.path.join(folder, "original")
        self.check(["g++", *self.objects.values(), *LIBRARIES, "-o", self.original])

    def closure(self, name):
        found, waiting = set(), [name]
        while waiting:
            for header in re.findall(r'^#include "([^"]+)"', open(os.path.join(SOURCE, waiting.pop())).read(), re.M):
                if header not in found:
                    found.add(header)
                    waiting.append(header)
        return found

    def compile_command(self, source, name, target):
        return ["g++", *FLAGS, "-I", self.folder, "-include", "system.h", "-iquote", source, "-c", os.path.join(source, name), "-o", target]

    @staticmethod
    def check(command):
        done = run(command, timeout=600)
        if done.returncode != 0:
            sys.exit(" ".join(command) + "\n" + done.stderr.decode())

    def mutant(self, mutant, folder):
        """The program, or None if it does not compile."""
        source = os.path.join(folder, "source")
        shutil.copytree(SOURCE, source)
        with open(os.path.join(source, mutant.file), "w") as out:
            out.write(mutant.text)
        objects = dict(self.objects)
        for name in self.names:
            if name == mutant.file or mutant.file in self.includes[name]:
                objects[name] = os.path.join(folder, name + ".o")
                if run(self.compile_command(source, name, objects[name]), timeout=600).returncode != 0:
                    return None
        program = os.path.join(folder, "confidel-check")
        if run(["g++", *objects.values(), *LIBRARIES, "-o", program], timeout=600).returncode != 0:
            return None
        return program


def manifest():
    cases = []
    with open(os.path.join(CERTIFICATES, "MANIFEST.tsv")) as file:
        for line in file:
            if not line.startswith("#"):
                path, code, expected, _ = line.rstrip("\n").split("\t")
                cases.append((os.path.join(CERTIFICATES, path), int(code), expected))
    # Small ones first: most mutants are caught at once.
    return sorted(cases, key=lambda case: os.path.getsize(case[0]))


def answer(program, path, *options):
    done = run([program, path, *options])
    if done.returncode == 2:
        match = re.search(r":(\d+):(\d+): error\[(E-[A-Z]+)\]", done.stderr.decode("latin-1"))
        return 2, (match.group(3) if match.group(3) == "E-ZSTD" else "%s %s" % (match.group(3), match.group(1))) if match else "no error line"
    return done.returncode, done.stdout.decode("latin-1").rstrip("\n").split("\n")[-1]


class Judge:
    def __init__(self, build, folder, changed):
        self.cases = manifest()
        self.changed = []
        parents, rnd = certificate_mutants.parents(), random.Random(7)
        for number in range(changed):
            path = os.path.join(folder, "changed-%d.cert" % number)
            with open(path, "w") as out:
                out.write(certificate_mutants.mutate(rnd.choice(parents), rnd))
            self.changed.append((path, *answer(build.original, path)))

    def caught_by(self, program):
        """The name of the test that notices, or None."""
        try:
            for path, code, expected in self.cases:
                if answer(program, path, "--threads", "1") != (code, expected):
                    return os.path.relpath(path, CERTIFICATES)
            if run([sys.executable, "-B", os.path.join(HERE, "..", "run_certificates.py"), program, "--no-mutations"], timeout=600).returncode != 0:
                return "run_certificates.py"
            for path, code, expected in self.changed:
                if answer(program, path, "--threads", "2") != (code, expected):
                    return "changed certificates"
        except subprocess.TimeoutExpired:
            return "does not end"
        return None


def read_equivalent():
    """key -> reason"""
    result = {}
    if os.path.exists(EQUIVALENT):
        for line in open(EQUIVALENT):
            if line.strip() and not line.startswith("#"):
                *key, reason = line.rstrip("\n").split("\t")
                result["\t".join(key)] = reason
    return result


def chosen(options):
    mutants = [mutant for mutant in all_mutants() if re.search(options.only, mutant.key)]
    if options.shard:
        part, parts = map(int, options.shard.split("/"))
        mutants = mutants[part::parts]
    if options.sample:
        mutants = random.Random(options.seed).sample(mutants, min(options.sample, len(mutants)))
    return mutants


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--list", action="store_true")
    parser.add_argument("--only", default="", help="of file, line and change, separated by tabs")
    parser.add_argument("--sample", type=int, default=0)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--shard", default="")
    parser.add_argument("--jobs", type=int, default=1)
    parser.add_argument("--changed", type=int, default=150, help="changed certificates per mutant")
    parser.add_argument("--out", default="")
    options = parser.parse_args()
    mutants = chosen(options)
    if options.list:
        for mutant in mutants:
            print("%s:%d\t%s\t%s" % (mutant.file, mutant.line, mutant.kind, mutant.key))
        print("%d mutants" % len(mutants))
        return 0
    equivalent, results, lock = read_equivalent(), {}, threading.Lock()
    digest = hashlib.sha256("".join(open(os.path.join(SOURCE, name)).read() for name in sorted(os.listdir(SOURCE)) if name.endswith((".cpp", ".h"))).encode()).hexdigest()
    if options.out and os.path.exists(options.out):
        for line in open(options.out):
            record = json.loads(line)
            if record["source"] == digest or record["caught_by"] == "does not compile":
                results[record["key"]] = record["caught_by"]
    with tempfile.TemporaryDirectory() as folder:
        build = Build(folder)
        judge = Judge(build, folder, options.changed)
        if judge.caught_by(build.original):
            sys.exit("the original fails: " + judge.caught_by(build.original))

        def judge_one(mutant):
            with tempfile.TemporaryDirectory(dir=folder) as own:
                program = build.mutant(mutant, own)
                by = "does not compile" if program is None else judge.caught_by(program)
            with lock:
                results[mutant.key] = by
                if options.out:
                    with open(options.out, "a") as out:
                        out.write(json.dumps({"key": mutant.key, "kind": mutant.kind, "line": mutant.line, "caught_by": by, "source": digest}) + "\n")
                if by is None and mutant.key not in equivalent:
                    print("SURVIVES %s:%d %s\t%s" % (mutant.file, mutant.line, mutant.kind, mutant.key), flush=True)

        with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
            list(pool.map(judge_one, [mutant for mutant in mutants if mutant.key not in results]))
    survivors = [mutant for mutant in mutants if results[mutant.key] is None]
    unexplained = [mutant for mutant in survivors if mutant.key not in equivalent]
    wrong = [mutant for mutant in mutants if mutant.key in equivalent and results[mutant.key] is not None]
    for mutant in wrong:
        print("LISTED AS EQUIVALENT, BUT CAUGHT (%s): %s" % (results[mutant.key], mutant.key))
    compiled = [mutant for mutant in mutants if results[mutant.key] != "does not compile"]
    print("%d mutants, %d do not compile, %d caught, %d equivalent, %d survive" % (
        len(mutants), len(mutants) - len(compiled), len(compiled) - len(survivors), len(survivors) - len(unexplained), len(unexplained)))
    return 1 if unexplained or wrong else 0


if __name__ == "__main__":
    sys.exit(main())
