# SPDX-License-Identifier: Apache-2.0
"""Many mutants in one program: each place is rewritten so that it behaves as written, or as its mutant when that one is in force (mutant.h).
Places where this cannot be compiled (constant expressions, mostly) are left as they are: their mutants need a program each."""
import concurrent.futures
import os
import re
import subprocess

import places

OPERATORS = {"<": 0, "<=": 1, ">": 2, ">=": 3, "==": 4, "!=": 5, "+": 6, "-": 7}
NUMBER = re.compile(r"[\d.][\w.']*?(?:(?<=[eE])[+-]\d+)?(?![\w.'])")
SUFFIX, PREFIX, WITHIN = range(3)
ARRAY = re.compile(r"^\s*(?:(?:const|constexpr|static|mutable) )*(?!return |throw |else |delete )[\w:<>]+ \w+\[")  # an array's size is a constant expression


GLOBAL = re.compile(r"^[\w:<>]+ \w+(?: = |\{)[^()]*;")  # is set before the program knows which mutant is in force


def region(code, place):
    """The whole expression around a connective: up to a bracket, a separator, an assignment or `return`."""
    depth, start = 0, place
    while start > 0:
        c = code[start - 1]
        if c in ")]}":
            depth += 1
        elif c in "([{":
            if depth == 0:
                break
            depth -= 1
        elif depth == 0:
            if c in ";,?" or (c == ":" and code[start - 2] != ":" and code[start] != ":"):
                break
            if c == "=" and code[start - 2] not in "=<>!" and code[start] != "=":
                break
            if re.search(r"\breturn$", code[max(0, start - 7):start]):
                break
        start -= 1
    depth, end = 0, place
    while end < len(code):
        c = code[end]
        if c in "([{":
            depth += 1
        elif c in ")]}":
            if depth == 0:
                break
            depth -= 1
        elif depth == 0 and (c in ";,?" or (c == ":" and code[end - 1] != ":" and code[end + 1] != ":")):
            break
        end += 1
    return start, end


def instrumented(text, mutants):
    """`mutants`: (number, Mutant) of this file. Every line stays on its line."""
    code, edits, regions = places.code_only(text), [], {}
    for number, mutant in mutants:
        place = mutant.place
        if mutant.kind in ("comparison", "arithmetic"):
            operator = text[place:place + mutant.length]
            edits.append((place, WITHIN, mutant.length, "%s mutant::Place<%d>{%d} %s" % (operator, OPERATORS[operator], number, operator)))
        elif mutant.kind == "constant":
            whole = NUMBER.match(text, place).group(0)
            edits.append((place, WITHIN, len(whole), "(%s + mutant::on(%d))" % (whole, number)))
        elif mutant.kind == "truth":
            edits.append((place, WITHIN, mutant.length, "(%s != bool(mutant::on(%d)))" % (text[place:place + mutant.length], number)))
        elif mutant.kind == "loop":
            edits.append((place, WITHIN, 0, " + mutant::on(%d)" % number))
        elif mutant.kind == "early":
            edits.append((place, WITHIN, 0, mutant.replacement.replace("false", "!mutant::on(%d)" % number)))
            if mutant.end is not None:
                edits.append((mutant.end, WITHIN, 0, ")"))
        elif mutant.kind == "connective":
            regions.setdefault(region(code, place), []).append((number, mutant))
    for (start, end), inside in regions.items():
        if "//" in text[start:end]:
            continue
        others = ["mutant::on(%d) ? bool(%s) : " % (number, re.sub(r"\s+", " ", text[start:mutant.place] + mutant.replacement + text[mutant.place + mutant.length:end]))
                  for number, mutant in inside]
        edits.append((start, PREFIX, 0, " (" + "".join(others) + "bool("))
        edits.append((end, SUFFIX, 0, "))"))
    result, last = [], 0
    for place, _, length, replacement in sorted(edits, key=lambda edit: edit[:2]):
        result += [text[last:place], replacement]
        last = place + length
    return "".join(result) + text[last:]


def faulty_lines(errors, folder):
    """The lines of rewritten files that the compiler complains about; for an error inside of mutant.h, those that lead there."""
    found, leading, pattern = set(), [], re.compile(re.escape(folder) + r"/([^/:]+):(\d+):")
    for line in errors.split("\n"):
        at = pattern.match(line)
        if ": error: " in line or ": fatal error: " in line:
            if at:
                found.add((at.group(1), int(at.group(2))))
            else:
                found.update(leading)
            leading = []
        elif at and "required from" in line:
            leading.append((at.group(1), int(at.group(2))))
    return found


def build(mutants, source, folder, compile_command, jobs, say, includes):
    """Writes rewritten files to `folder` and compiles them there: (the numbers of the mutants inside, the objects), but for files in which and in whose
    headers (`includes`) nothing changes."""
    files = sorted(name for name in os.listdir(source) if name.endswith((".cpp", ".h")))
    inside = {number for number, mutant in enumerate(mutants)
              if not (mutant.kind == "constant" and mutant.original[mutant.place - 1] == "[" and ARRAY.match(mutant.key.split("\t")[1]))
              and not GLOBAL.match(mutant.original.split("\n")[mutant.line - 1])}
    lines = {}
    for number, mutant in enumerate(mutants):
        lines.setdefault((mutant.file, mutant.line), set()).add(number)
    touched = {mutant.file for mutant in mutants}
    objects = {name: os.path.join(folder, name + ".o") for name in files if name.endswith(".cpp") and touched & {name, *includes[name]}}

    def compile_all(names, *options):
        """(name, errors) of those that cannot be compiled"""
        def compile_one(name):
            done = subprocess.run([*compile_command(folder, name, objects[name]), *options], capture_output=True, text=True)
            return name, done.stderr if done.returncode != 0 else ""

        with concurrent.futures.ThreadPoolExecutor(jobs) as pool:
            return [(name, errors) for name, errors in pool.map(compile_one, names) if errors]

    pending = sorted(objects)
    while pending:
        places.copy(source, folder, {name: instrumented(open(os.path.join(source, name)).read(), [(number, mutants[number]) for number in sorted(inside) if mutants[number].file == name])
                                     for name in files})
        failed = compile_all(pending, "-fsyntax-only")
        without = set()
        for name, errors in failed:
            for line in faulty_lines(errors, folder):
                without |= lines.get(line, set()) & inside
        if failed and not without:
            raise RuntimeError("%s cannot be compiled with its mutants:\n%s" % failed[0])
        pending = [name for name, _ in failed]
        inside -= without
    say("%d of %d mutants go into one program; compiling it" % (len(inside), len(mutants)))
    failed = compile_all(sorted(objects))
    if failed:
        raise RuntimeError("%s cannot be compiled with its mutants:\n%s" % failed[0])
    return inside, objects
