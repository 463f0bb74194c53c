#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Mutants of the checker: is every comparison, loop bound, constant and early return of checkers/gmp held by a test?

    mutate_checker.py [--list] [--only REGEX] [--sample N] [--shard I/N] [--jobs 1] [--out FILE] [--folder FOLDER] [--separately]

Each mutant changes one place in one file (places.py): a comparison includes equality or no longer does, a loop stops one early, a number is one
more, true is false, `&&` becomes `||`, an `if` that leaves never does, a minus is a plus. It is run on the certificates of tests/certificates, on the
command lines of run_certificates.py, and on changed certificates, where it must answer as the original does (which agreement_test.py compares with
the verified checker); what the float filter and its test share, also on that test (tests/checkers/filter). A mutant that no test notices is a survivor.

Most mutants are compiled into one program, which is told which one to be (schemata.py); the others, and with --separately all, get a program each.

Survivors that cannot differ are listed in equivalent.tsv with the reason; the key is file, text of the line, place in it and
change, so that other lines may move. Exit code 1 if a survivor is not listed there, a listed one is caught, or there is no such place any more.
With --out, results are appended to FILE as lines of JSON; what was caught there, of the same text of the changed file, is not run again, nor what survived the same tests.
With --folder, what was compiled is kept there, for a round of the same mutants."""
import argparse
import concurrent.futures
import hashlib
import json
import os
import random
import re
import resource
import shutil
import subprocess
import sys
import tempfile
import threading

import places
import schemata

HERE = os.path.dirname(os.path.abspath(__file__))
SOURCE = places.SOURCE
CERTIFICATES = os.path.normpath(os.path.join(HERE, "..", "..", "certificates"))
EQUIVALENT = os.path.join(HERE, "equivalent.tsv")
FILTER_TEST = os.path.join(HERE, "..", "filter", "consistency.cpp")
FILTER_SOURCES = ("points.cpp", "sphere.cpp", "filter.cpp", "cluster.cpp", "index.cpp")  # as in tests/checkers/tests.cmake
sys.path[:0] = [os.path.join(HERE, "..", "verified")]
import mutants as certificate_mutants

# What lies outside of an array or a vector ends the program: a mutant that reads there is noticed as by the tests of the preset asan.
FLAGS = ["-std=gnu++20", "-w", "-fmax-errors=0", "-D_GLIBCXX_ASSERTIONS", "-fsanitize=bounds,shift,signed-integer-overflow,null,bool,enum", "-fsanitize-undefined-trap-on-error"]
LINKER = ["-Wl,-z,now", *(["-fuse-ld=gold"] if shutil.which("ld.gold") else [])]  # bound before forking, not in each child
LIBRARIES = ["-lgmpxx", "-lgmp", "-lzstd", "-lcrypto", "-lpthread"]
TIMEOUT = 600  # of waiting: others may keep the processor busy
SECONDS = 60  # of the processor, for each process
NOT_COMPILED, ENDLESS, NOT_STARTED = "does not compile", "does not end", "does not start"


def check(command):
    done = subprocess.run(command, capture_output=True, text=True, timeout=900)
    if done.returncode != 0:
        sys.exit(" ".join(command) + "\n" + done.stderr)


def digest_of(paths):
    digest = hashlib.sha256()
    for path in paths:
        with open(path, "rb") as file:
            digest.update(file.read())
    return digest.hexdigest()


def files_of(folder, endings):
    return sorted(os.path.join(folder, name) for name in os.listdir(folder) if name.endswith(endings))


class Build:
    """Programs of the driver and the checker's files, original and changed; what is needed is compiled when it is."""

    def __init__(self, folder):
        self.folder = folder
        # Of other sources nothing can be used.
        stamp, digest = os.path.join(folder, "digest"), digest_of(files_of(SOURCE, (".cpp", ".h")) + files_of(HERE, (".cpp", ".h")) + [FILTER_TEST, places.__file__, schemata.__file__]) + repr(FLAGS)
        if not os.path.exists(stamp) or open(stamp).read() != digest:
            if os.path.exists(folder) and os.listdir(folder) and not os.path.exists(stamp):
                sys.exit("%s is not empty and was not made by this script" % folder)
            shutil.rmtree(folder, ignore_errors=True)
            os.makedirs(os.path.join(folder, "system.h.gch"))
            with open(stamp, "w") as out:
                out.write(digest)
        self.names = sorted(name for name in os.listdir(SOURCE) if name.endswith(".cpp"))
        headers = {"<cstdlib>"}
        for name in files_of(SOURCE, (".cpp", ".h")) + [os.path.join(HERE, "mutant_driver.cpp"), FILTER_TEST]:
            headers.update(re.findall(r"^#include (<[^>]+>)", open(name).read(), re.M))
        system = "".join("#include %s\n" % header for header in sorted(headers)) + '#include "%s"\n' % os.path.join(HERE, "mutant.h")
        if not os.path.exists(os.path.join(folder, "system.h")):
            with open(os.path.join(folder, "system.h"), "w") as out:
                out.write(system)
        self.includes = {name: self.closure(name) for name in self.names}
        self.source = os.path.join(folder, "source")
        places.copy(SOURCE, self.source)
        self.filter_files = set(FILTER_SOURCES).union(*(self.includes[name] for name in FILTER_SOURCES))
        self.driver = self.compiled(HERE, "mutant_driver.cpp")
        with open(os.path.join(folder, "chooser.cpp"), "w") as out:  # which mutant is in force, in a program without the driver
            out.write('static const int chosen = mutant::active = std::getenv("CONFIDEL_MUTANT") ? std::atoi(std::getenv("CONFIDEL_MUTANT")) : -1;\n')

    def header(self, level):
        """Quickly compiled for a mutant alone, quicker when it runs for many: two precompiled headers, and the compiler takes the one that fits."""
        target = os.path.join(self.folder, "system.h.gch", "system" + level)
        if not os.path.exists(target):
            check(["g++", *FLAGS, level, "-x", "c++-header", os.path.join(self.folder, "system.h"), "-o", target + ".partial"])
            os.rename(target + ".partial", target)

    def compiled(self, source, name):
        target = os.path.join(self.folder, name + ".o")
        if not os.path.exists(target):
            self.header("-O0")
            check(self.compile_command(source, name, target + ".partial"))
            os.rename(target + ".partial", target)
        return target

    def originals(self, names):
        return {name: self.compiled(self.source, name) for name in names}

    def original(self):
        program = os.path.join(self.folder, "original")
        check(self.link_command(self.originals(self.names), program))
        return program

    def closure(self, name):
        found, waiting = set(), [name]
        while waiting:
            for header in re.findall(r'^#include "([^"]+)"', open(os.path.join(SOURCE, waiting.pop())).read(), re.M):
                if header not in found:
                    found.add(header)
                    waiting.append(header)
        return found

    def compile_command(self, source, name, target, level="-O0"):
        return ["g++", *FLAGS, level, "-I", self.folder, "-include", "system.h", "-iquote", source, "-c", os.path.join(source, name), "-o", target]

    def link_command(self, objects, program):
        return ["g++", *LINKER, self.driver, *objects.values(), *LIBRARIES, "-o", program]

    def together(self, mutants, jobs, say):
        """(program, positions in `mutants` of those inside, the filter's test or None)"""
        folder = os.path.join(self.folder, "together-" + hashlib.sha256("\n".join(mutant.key for mutant in mutants).encode()).hexdigest()[:16])
        program, done = os.path.join(folder, "program"), os.path.join(folder, "inside.json")
        if not os.path.exists(done):
            os.makedirs(folder, exist_ok=True)
            self.header("-O1")
            inside, objects = schemata.build(mutants, SOURCE, folder, lambda *arguments: self.compile_command(*arguments, "-O1"), jobs, say, self.includes)
            objects = {**self.originals(set(self.names) - set(objects)), **objects}
            check(self.link_command(objects, program))
            test = self.filter_test(folder, {mutants[number].file for number in inside}, objects)
            with open(done + ".partial", "w") as out:
                json.dump([sorted(inside), test], out)
            os.rename(done + ".partial", done)
        inside, test = json.load(open(done))
        return program, set(inside), test

    def filter_test(self, folder, changed, objects):
        """The program of the test checker.filter, with the sources in `folder`; None if nothing that it uses is among the changed files."""
        if not changed & self.filter_files:
            return None
        name = os.path.basename(FILTER_TEST)

        def compiled(folder):  # it includes "checkers/gmp/index.h"
            own, target = os.path.join(folder, "consistency"), os.path.join(folder, name + ".o")
            if not os.path.exists(target):
                os.makedirs(os.path.join(own, "checkers"), exist_ok=True)
                if not os.path.lexists(os.path.join(own, "checkers", "gmp")):
                    os.symlink(os.path.join(folder, "source") if os.path.exists(os.path.join(folder, "source")) else folder, os.path.join(own, "checkers", "gmp"))
                shutil.copy(FILTER_TEST, own)
                self.header("-O1")
                check(self.compile_command(own, name, target, "-O1"))
            return target

        test = compiled(folder if any(file.endswith(".h") for file in changed & self.filter_files) else self.folder)
        program = os.path.join(folder, "filter-test")
        check(["g++", *LINKER, test, self.compiled(self.folder, "chooser.cpp"), *(objects[name] for name in FILTER_SOURCES), *LIBRARIES, "-o", program])
        return program

    def alone(self, mutant, folder):
        """(The program, the filter's test or None); None if it does not compile."""
        source = os.path.join(folder, "source")
        places.copy(SOURCE, source, {mutant.file: mutant.text})
        objects = self.originals(self.names)
        for name in self.names:
            if name == mutant.file or mutant.file in self.includes[name]:
                objects[name] = os.path.join(folder, name + ".o")
                if subprocess.run(self.compile_command(source, name, objects[name]), capture_output=True).returncode != 0:
                    return None
        program = os.path.join(folder, "program")
        if subprocess.run(self.link_command(objects, program), capture_output=True).returncode != 0:
            return None
        return program, self.filter_test(folder, {mutant.file}, objects)


def limited():
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
    resource.setrlimit(resource.RLIMIT_CPU, (SECONDS, SECONDS + 1))
    resource.setrlimit(resource.RLIMIT_AS, (2 << 30, 2 << 30))


class Judge:
    def __init__(self, original, folder, changed):
        self.cases = os.path.join(folder, "cases.tsv")
        # A copy: a file that changes while mutants run would be noticed by each of them.
        self.certificates = os.path.join(folder, "certificates")
        shutil.rmtree(self.certificates, ignore_errors=True)
        shutil.copytree(CERTIFICATES, self.certificates)
        entries = []
        with open(os.path.join(self.certificates, "MANIFEST.tsv")) as file:
            for line in file:
                if not line.startswith("#"):
                    path, code, expected, _ = line.rstrip("\n").split("\t")
                    entries.append((os.path.join(self.certificates, path), code, expected))
        produced = os.path.join(self.certificates, "produced")
        entries += [(os.path.join(produced, name), "0", "s VERIFIED") for name in sorted(os.listdir(produced))]
        entries.sort(key=lambda entry: os.path.getsize(entry[0]))
        lines = ["%s\t%s\t%s\t--threads\t1\n" % (code, expected, path) for path, code, expected in entries]
        # The original's report, which run_certificates.py compares with REPORTS.tsv.
        lines += ["%s\t%s\t%s\t--json\t--threads\t3\n" % (code, self.report(original, path), path) for path, code, expected in entries if code in "01"]
        # The whole message, of which run_certificates.py compares the column and the text.
        lines += ["%s\t%s\t%s\t--json\n" % (code, self.message(original, path), path) for path, code, expected in entries if code == "2"]
        # Without the float filter, as run_certificates.py does.
        lines += ["%s\t%s\t%s\t--exact\t--threads\t1\n" % (code, expected, path) for path, code, expected in entries if code != "2"]
        parents, rnd = certificate_mutants.parents(), random.Random(7)
        for number in range(changed):
            path = os.path.join(folder, "changed-%d.cert" % number)
            with open(path, "w") as out:
                out.write(certificate_mutants.mutate(rnd.choice(parents), rnd))
            lines.append("%s\t%s\t%s\t--threads\t2\n" % (*self.answer(original, path), path))
        with open(self.cases, "w") as out:
            out.writelines(lines)

    @staticmethod
    def run(program, *arguments):
        return subprocess.run([program, *arguments], capture_output=True, text=True, timeout=TIMEOUT, env=dict(os.environ, CONFIDEL_MUTANT="-1"))

    @staticmethod
    def report(program, path):
        return re.search(r'"rules":.*,"claims":.*(?=,"seconds")', Judge.run(program, path, "--json").stdout).group(0)

    @staticmethod
    def message(program, path):
        return Judge.run(program, path, "--json").stderr.split("\n")[0].removeprefix(path)

    @staticmethod
    def answer(program, path):
        done = Judge.run(program, path, "--threads", "2")
        if done.returncode == 2:
            match = re.search(r":(\d+):(\d+): error\[(E-[A-Z]+)\]", done.stderr)
            return 2, "%s %s" % (match.group(3), match.group(1))
        return done.returncode, done.stdout.rstrip("\n").split("\n")[-1]

    def on_certificates(self, program, numbers):
        """(number, the test that notices or None), one after the other"""
        with subprocess.Popen([program, self.cases], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True) as process:
            for number in numbers:
                print(number, file=process.stdin, flush=True)
                answer = process.stdout.readline()
                if not answer.startswith("%d\t" % number):
                    raise RuntimeError("the driver ended at mutant %d: %r" % (number, answer))
                yield number, os.path.relpath(answer.rstrip("\n").split("\t")[1], self.certificates) if "/" in answer else answer.rstrip("\n").split("\t")[1] or None

    @staticmethod
    def of_command_lines(mutant):
        return mutant.file.split(".")[0] in ("input", "limits", "main", "report")

    @staticmethod
    def of_trees(mutant):
        return mutant.file.split(".")[0] in ("index", "empty", "cluster", "group", "rules")

    @staticmethod
    def on_command_lines(program, number, frames, many):
        # What cuts frames of zstd starts a thousand processes, and sixty thousand points take long where everything is asked whether it is changed.
        options = [*([] if frames else ["--no-frames"]), *([] if many else ["--no-many"])]
        return Judge.on_script([sys.executable, "-B", os.path.join(HERE, "..", "run_certificates.py"), program, "--command-line", "--until-failure", *options],
                               number, "run_certificates.py --command-line")

    @staticmethod
    def on_filter(program, number, mutant):
        # Few cases notice most, and all that is no matter of rounding.
        numeric = mutant is not None and mutant.file.split(".")[0] in ("filter", "points", "sphere")
        return program and (Judge.on_script([program, "300"], number, "checker.filter") or (Judge.on_script([program], number, "checker.filter") if numeric else None))

    @staticmethod
    def on_script(command, number, name):
        try:
            done = subprocess.run(command, capture_output=True, timeout=TIMEOUT, env=dict(os.environ, CONFIDEL_MUTANT=str(number)), preexec_fn=limited)
            return name if done.returncode != 0 else None
        except subprocess.TimeoutExpired:
            return ENDLESS


def read_equivalent():
    """key -> reason"""
    result = {}
    if os.path.exists(EQUIVALENT):
        for line in open(EQUIVALENT):
            if line.strip() and not line.startswith("#"):
                *key, reason = line.rstrip("\n").split("\t")
                result["\t".join(key)] = reason
    return result


def stale(equivalent):
    """Keys of which there is no place any more."""
    return sorted(set(equivalent) - {mutant.key for mutant in places.all_mutants()})


def chosen(options):
    mutants = [mutant for mutant in places.all_mutants() if re.search(options.only, mutant.key)]
    if options.shard:
        part, parts = map(int, options.shard.split("/"))
        mutants = mutants[part::parts]
    if options.sample:
        mutants = random.Random(options.seed).sample(mutants, min(options.sample, len(mutants)))
    return mutants


class Round:
    def __init__(self, options, mutants):
        self.options, self.results, self.lock = options, {}, threading.Lock()
        self.equivalent = read_equivalent()
        # Of the file alone: a round of an hour is worth keeping when another file changes. A fresh FILE is a round of one state.
        self.digests = {name: digest_of([os.path.join(SOURCE, name)]) for name in {mutant.file for mutant in mutants}}
        keys = {mutant.key: mutant.file for mutant in mutants}
        tests = [os.path.join(CERTIFICATES, "MANIFEST.tsv"), os.path.join(CERTIFICATES, "REPORTS.tsv"), os.path.join(HERE, "..", "run_certificates.py"), FILTER_TEST]
        self.tests = "%s %d" % (digest_of(tests), options.changed)
        if options.out and os.path.exists(options.out):
            for line in open(options.out):
                record = json.loads(line)
                if record["key"] in keys and record["source"] == self.digests[keys[record["key"]]] and (record["caught_by"] is not None or record.get("tests") == self.tests):
                    self.results[record["key"]] = record["caught_by"]
        self.chosen = mutants

    def record(self, mutant, by):
        with self.lock:
            self.results[mutant.key] = by
            if self.options.out:
                with open(self.options.out, "a") as out:
                    out.write(json.dumps({"key": mutant.key, "kind": mutant.kind, "line": mutant.line, "caught_by": by, "source": self.digests[mutant.file], "tests": self.tests}) + "\n")
            if by is None and mutant.key not in self.equivalent:
                print("SURVIVES %s:%d %s\t%s" % (mutant.file, mutant.line, mutant.kind, mutant.key), flush=True)

    @staticmethod
    def first(judge, program):
        """The certificate that notices the mutant of a program of its own, which may end the driver too: a memory limit of one byte does."""
        try:
            return next(judge.on_certificates(program, [-1]))[1]
        except RuntimeError:
            return NOT_STARTED

    def say(self, text):
        print(text, file=sys.stderr, flush=True)

    def all(self, folder):
        build = Build(folder)
        left = [mutant for mutant in self.chosen if mutant.key not in self.results]
        if left and not self.options.separately and len(self.chosen) > 20:
            left = self.together(build, folder)
        self.say("%d mutants get a program each" % len(left))
        if not left:
            return
        judge = self.judge(folder, build.original(), build.filter_test(folder, {mutant.file for mutant in left if mutant.file.endswith(".cpp")}, build.originals(build.names)))
        with concurrent.futures.ThreadPoolExecutor(self.options.jobs) as pool:
            list(pool.map(lambda mutant: self.alone(build, judge, folder, mutant), left))

    def judge(self, folder, program, filter_test=None):
        judge = Judge(program, folder, self.options.changed)
        own = next(judge.on_certificates(program, [-1]))[1] or judge.on_command_lines(program, -1, True, True) or judge.on_filter(filter_test, -1, None)
        if own:
            sys.exit("with no mutant in force, the program fails: " + own)
        return judge

    def together(self, build, folder):
        """Returns those that need a program each."""
        program, inside, filter_test = build.together(self.chosen, self.options.jobs, self.say)
        judge = self.judge(folder, program, filter_test)

        def judge_some(numbers):
            left = []
            for number in numbers:  # first what is most likely to notice
                by = judge.of_command_lines(self.chosen[number]) and judge.on_command_lines(program, number, False, False)
                if by:
                    self.record(self.chosen[number], by)
                else:
                    left.append(number)
            for number, by in judge.on_certificates(program, left):
                mutant = self.chosen[number]
                self.record(mutant, by or (judge.on_filter(filter_test, number, mutant) if mutant.file in build.filter_files else None)
                            or judge.on_command_lines(program, number, judge.of_command_lines(mutant), judge.of_trees(mutant)))

        waiting, jobs = [number for number in sorted(inside) if self.chosen[number].key not in self.results], self.options.jobs
        with concurrent.futures.ThreadPoolExecutor(jobs) as pool:
            list(pool.map(judge_some, [waiting[i * len(waiting) // jobs:(i + 1) * len(waiting) // jobs] for i in range(jobs)]))
        return [mutant for number, mutant in enumerate(self.chosen) if number not in inside and mutant.key not in self.results]

    def alone(self, build, judge, folder, mutant):
        with tempfile.TemporaryDirectory(dir=folder) as own:
            programs = build.alone(mutant, own)
            if programs is None:
                by = NOT_COMPILED
            else:
                by = self.first(judge, programs[0]) or judge.on_filter(programs[1], -1, mutant) or judge.on_command_lines(programs[0], -1, judge.of_command_lines(mutant), judge.of_trees(mutant))
        self.record(mutant, by)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--list", action="store_true")
    parser.add_argument("--only", default="", help="of file, line and change, separated by tabs")
    parser.add_argument("--sample", type=int, default=0)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--shard", default="")
    parser.add_argument("--jobs", type=int, default=1)
    parser.add_argument("--changed", type=int, default=400, help="changed certificates per mutant")
    parser.add_argument("--out", default="")
    parser.add_argument("--folder", default="")
    parser.add_argument("--separately", action="store_true", help="a program for each mutant: hours")
    options = parser.parse_args()
    mutants = chosen(options)
    gone = stale(read_equivalent())
    for key in gone:
        print("STALE in equivalent.tsv: " + key)
    if options.list:
        for mutant in mutants:
            print("%s:%d\t%s\t%s" % (mutant.file, mutant.line, mutant.kind, mutant.key))
        print("%d mutants" % len(mutants))
        return 1 if gone else 0
    work = Round(options, mutants)
    if options.folder:
        work.all(os.path.abspath(options.folder))
    else:
        with tempfile.TemporaryDirectory() as folder:
            work.all(folder)
    results, equivalent = work.results, work.equivalent
    survivors = [mutant for mutant in mutants if results[mutant.key] is None]
    unexplained = [mutant for mutant in survivors if mutant.key not in equivalent]
    wrong = [mutant for mutant in mutants if mutant.key in equivalent and results[mutant.key] is not None]
    for mutant in wrong:
        print("LISTED AS EQUIVALENT, BUT CAUGHT (%s): %s" % (results[mutant.key], mutant.key))
    compiled = [mutant for mutant in mutants if results[mutant.key] != NOT_COMPILED]
    print("%d mutants, %d do not compile, %d caught, %d equivalent, %d survive" % (
        len(mutants), len(mutants) - len(compiled), len(compiled) - len(survivors), len(survivors) - len(unexplained), len(unexplained)))
    return 1 if unexplained or wrong or gone else 0


if __name__ == "__main__":
    sys.exit(main())
