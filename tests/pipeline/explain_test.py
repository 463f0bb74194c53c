#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""explain_test.py BINARIES: every error code in the sources, every rule and reason of the checker, and every lemma is explained, and nothing else is."""
import json
import os
import re
import sys

from harness import ROOT, Programs

FOLDERS = ("apps", "core", "proofs/certificate", "checkers/gmp")


def sources():
    for folder in FOLDERS:
        for place, _, names in os.walk(os.path.join(ROOT, folder)):
            for name in sorted(names):
                if name.endswith((".cpp", ".h")) and name != "explanations.cpp":
                    with open(os.path.join(place, name), encoding="utf-8") as file:
                        yield name, file.read()


def lemmas():
    with open(os.path.join(ROOT, "docs/lemmas.md"), encoding="utf-8") as file:
        for line in file:
            match = re.match(r"\| (L[0-9]\w*|LG) \| (.*?) \| .*\|.*\|.*\|.*\|", line)
            if match:
                yield match.group(1), match.group(2).replace("**", "").replace("\\*", "*")


def main():
    programs = Programs(sys.argv[1])
    code, out, _ = programs.run("explain", "--json")
    known = {each["name"]: each for each in json.loads(out)["explanations"]}
    of_kind = lambda kind: {name for name, each in known.items() if each["kind"] == kind}

    used, text = set(), ""
    for _, content in sources():
        used |= set(re.findall(r'"(E-[A-Z][A-Z-]*[A-Z])"', content)) | set(re.findall(r"error\[(E-[A-Z-]+)\]", content))
        text += content
    programs.expect(len(used) > 20, "the grep of the sources finds too little: %s" % used)
    programs.expect(used == of_kind("error"), "codes without explanation: %s; explanations without code: %s" %
                    (sorted(used - of_kind("error")), sorted(of_kind("error") - used)))

    rules = set(re.findall(r'^const Rule [a-z]+\{"([a-z]+)", rule', text, re.M))
    programs.expect(rules == of_kind("rule") and len(rules) > 8, "rules of the checker: %s" % sorted(rules ^ of_kind("rule")))
    with open(os.path.join(ROOT, "docs/lemma-claims.md"), encoding="utf-8") as file:
        claims = set(re.findall(r"^\| (H-[a-z]+) \|", file.read(), re.M))
    programs.expect(claims == of_kind("claim"), "claims that are no lemmas: %s" % sorted(claims ^ of_kind("claim")))
    for reason in of_kind("reason"):
        programs.expect('"%s' % reason in text or " " + reason in text, "no program says " + reason)

    stated = dict(lemmas())
    programs.expect(len(stated) > 20 and set(stated) == of_kind("lemma"), "lemmas: %s" % sorted(set(stated) ^ of_kind("lemma")))
    for name in stated:
        programs.expect(name not in known or known[name]["meaning"] == stated[name], "%s is not what docs/lemmas.md says: apps/explanations.cpp" % name)

    for name, each in known.items():
        code, out, err = programs.run("explain", name)
        words = re.sub(r"\s+", " ", out)
        programs.expect(code == 0 and err == "" and each["meaning"] in words and each["advice"] in words, "explain %s: %d %r" % (name, code, out))
        programs.expect(max(map(len, out.split("\n"))) <= 110, "explain %s: a long line" % name)
        if each["kind"] in ("error", "reason"):
            programs.expect(each["advice"], "explain %s: what is one to do?" % name)
    programs.expect(programs.run("explain", "e-noncoplanar")[0] == 0, "explain ignores case")
    code, out, err = programs.run("explain", "E-NONSENSE")
    programs.expect(code == 2 and "error[E-USAGE]" in err, "explain E-NONSENSE: %d %r" % (code, err))
    programs.finish()


main()
