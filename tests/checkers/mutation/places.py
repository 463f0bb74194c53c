# SPDX-License-Identifier: Apache-2.0
"""The places of checkers/gmp that mutate_checker.py changes, each in one way."""
import os
import re

HERE = os.path.dirname(os.path.abspath(__file__))
SOURCE = os.path.normpath(os.path.join(HERE, "..", "..", "..", "checkers", "gmp"))
COMPARISONS = {"<": "<=", "<=": "<", ">": ">=", ">=": ">", "==": "!=", "!=": "=="}
LEAVES = re.compile(r"\{?\s*(return|throw|fail|failAt|continue|break|die|endUndecided|memoryExhausted|\w+\.offer|offer|truncated)\b")
NUMBER = re.compile(r"(?<![\w.'])(0x[0-9a-fA-F_]+|\d[\d_]*)([uUlL]*)(?![\w.'])")


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


def has_or(condition):
    """Is it alternatives? Then what is put before it would be a part of the first one only."""
    depth = 0
    for place, c in enumerate(condition):
        depth += (c in "([{") - (c in ")]}")
        if depth == 0 and condition.startswith(" || ", place):
            return True
    return False


def early_exit(code, opening, stop):
    """(place, text to put there) that keeps an `if` from leaving; a text that opens a parenthesis has it closed at the end of the condition."""
    head = code[opening + 1:stop]
    last = opening + 1 + head.rfind(";") + 1
    if has_or(code[last:stop]):
        return last, "false && ("
    if ";" in head:
        return last, " false && "
    name = re.match(r"\s*(?:const )?auto\*? (\w+) = ", head)
    if name:  # if (const auto fault = ...)
        return stop, "; false && %s" % name.group(1)
    return opening + 1, "false && "


def mutations_of(text):
    """(place, length, replacement, kind) of every mutation of a file."""
    code = code_only(text)
    for match in re.finditer(r" (<=|>=|==|!=|<|>) ", code):
        yield match.start(1), len(match.group(1)), COMPARISONS[match.group(1)], "comparison"
    for match in re.finditer(r" (&&|\|\|) ", code):
        yield match.start(1), 2, "||" if match.group(1) == "&&" else "&&", "connective"
    for match in NUMBER.finditer(code):
        number = match.group(1).replace("_", "")
        line = code[code.rfind("\n", 0, match.start()) + 1:match.start()]
        if re.search(r"\bcase $", line):
            continue
        yield match.start(1), len(match.group(1)), str(int(number, 0) + 1), "constant"
    for match in re.finditer(r"(?<![\w.'])(\d+\.\d+(?:e-?\d+)?|\d+e-?\d+)(?![\w.'])", code):
        yield match.start(1), len(match.group(1)), "(%s + 1)" % match.group(1), "constant"
    for match in re.finditer(r"\b(true|false)\b", code):
        yield match.start(1), len(match.group(1)), "false" if match.group(1) == "true" else "true", "truth"
    for match in re.finditer(r"\bfor \(", code):
        stop = closing(code, match.end() - 1)
        parts = code[match.end():stop].split(";")
        if len(parts) == 3 and re.search(r" (<|<=) ", parts[1]):
            place = match.end() + len(parts[0]) + 1 + re.search(r" (<|<=) ", parts[1]).start()
            yield place, 0, " + 1", "loop"
    for match in re.finditer(r"\bif \(", code):
        stop = closing(code, match.end() - 1)
        if LEAVES.match(code[stop + 1:stop + 200].lstrip()):
            place, replacement = early_exit(code, match.end() - 1, stop)
            yield place, 0, replacement, "early"
    for match in re.finditer(r"(?<=[\w)\]]) ([+-]) (?=[\w(])", code):
        yield match.start(1), 1, "-" if match.group(1) == "+" else "+", "arithmetic"


class Mutant:
    def __init__(self, name, text, place, length, replacement, kind):
        start = text.rfind("\n", 0, place) + 1
        end = text.find("\n", place)
        self.file, self.kind, self.line = name, kind, text.count("\n", 0, place) + 1
        self.place, self.length, self.replacement, self.original = place, length, replacement, text
        # Where a parenthesis that the replacement opens is closed.
        self.end = closing(code_only(text), text.rindex("if (", 0, place) + 3) if replacement.endswith("(") else None
        indent = len(text[start:end]) - len(text[start:end].lstrip())
        self.key = "\t".join([name, text[start:end].strip(), str(place - start - indent), "%s -> %s" % (text[place:place + length], replacement)])

    @property
    def text(self):
        if self.end is not None:
            return self.original[:self.place] + self.replacement + self.original[self.place:self.end] + ")" + self.original[self.end:]
        return self.original[:self.place] + self.replacement + self.original[self.place + self.length:]


def all_mutants(source=SOURCE):
    result, seen = [], {}
    for name in sorted(os.listdir(source)):
        if name.endswith((".cpp", ".h")):
            text = open(os.path.join(source, name)).read()
            for mutation in mutations_of(text):
                mutant = Mutant(name, text, *mutation)
                # The same line twice in a file: the second one is told apart by a number.
                seen[mutant.key] = seen.get(mutant.key, 0) + 1
                if seen[mutant.key] > 1:
                    mutant.key += " #%d" % seen[mutant.key]
                result.append(mutant)
    return result


def copy(source, target, changed={}):
    """The checker's files, some of them changed, with its `main` called checkerMain, which returns."""
    os.makedirs(target, exist_ok=True)
    for name in os.listdir(source):
        if name.endswith((".cpp", ".h")):
            text = changed.get(name) or open(os.path.join(source, name)).read()
            with open(os.path.join(target, name), "w") as out:
                out.write(re.sub(r"^int main\(", "int checkerMain(", text, flags=re.M).replace("std::_Exit(code);", "return code;"))
