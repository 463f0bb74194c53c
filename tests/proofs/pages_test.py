#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""docs/lemmas.md and docs/proofs.md against proofs/coq: theorems exist in the files that the pages name, the table of axioms names every theorem,
lemmas.md has every lemma, its code, rules and files exist. No trusted file contains a statement without proof, and
the sizes in docs/trust-verified-checker.md are those of today. Needs no Coq."""
import glob
import os
import re
import sys

ROOT = os.path.normpath(os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", ".."))
COQ = os.path.join(ROOT, "proofs", "coq")
FOLDERS = ("lemmas", "theorem", "checker")
OPEN = "theorem/Remaining"
LEMMAS = ["L0a", "L0b"] + ["L%d" % n for n in range(1, 24)] + ["L18b", "LG"]
AXIOMS = {"sig_forall_dec", "sig_not_dec", "functional_extensionality_dep"}  # of Coq's Reals
STATEMENT = re.compile(r"^\s*(?:Local\s+)?(Theorem|Corollary|Lemma|Example|Definition|Record|Fixpoint|Inductive)\s+([\w']+)", re.M)
GAP = re.compile(r"\b(Admitted|admit|give_up|Aborted|Abort)\b|(?:^|\.)\s*(?:Local\s+|Global\s+)*(Axioms?|Parameters?|Conjectures?)\b")

failures = []


def read(*path):
    with open(os.path.join(ROOT, *path), encoding="utf-8") as file:
        return file.read()


def without_comments(text):
    """Coq's comments nest."""
    before = None
    while before != text:
        before, text = text, re.sub(r"\(\*(?:(?!\(\*|\*\)).)*\*\)", " ", text, flags=re.S)
    return text


def sources():
    """folder/File -> text without comments."""
    return {os.path.relpath(path, COQ)[:-2]: without_comments(read(path))
            for folder in FOLDERS for path in sorted(glob.glob(os.path.join(COQ, folder, "*.v")))}


def expect(good, message):
    if not good:
        failures.append(message)


def find(files, name):
    """A page's file name: with its folder, or in lemmas or theorem."""
    return [path for path in files if path == name or path in ("lemmas/" + name, "theorem/" + name)]


def references(cell):
    """(file, theorem) of `File: a, b; folder/Other: c. Words.`"""
    cell = re.sub(r"\([^)]*\)", "", cell)
    for file, names in re.findall(r"\b((?:[a-z]+/)?[A-Z]\w*): ([\w', ]+)", cell):
        for name in names.split(","):
            if name.strip():
                yield file, name.strip()


def check_references(page, cell, files, names):
    count = 0
    for file, name in references(cell):
        where = find(files, file)
        if len(where) != 1:
            expect(re.match(r"Converse$", file), "%s: no file %s" % (page, file))
            continue
        expect(name in names[where[0]], "%s: no %s in %s.v" % (page, name, where[0]))
        count += 1
    return count


def rows(text, columns):
    for line in text.split("\n"):
        cells = [cell.strip() for cell in line.strip().strip("|").split("|")]
        if line.startswith("|") and len(cells) == columns and set(cells) != {"---"}:
            yield cells


def check_lemmas(files, names):
    page = read("docs", "lemmas.md")
    table = [cells for cells in rows(page, 7) if cells[0] != "id"]
    expect(sorted(cells[0] for cells in table) == sorted(LEMMAS), "lemmas.md: not one row for each of %s" % " ".join(LEMMAS))
    core = "\n".join(read(path) for path in glob.glob(os.path.join(ROOT, "core", "*", "*.cpp")) + glob.glob(os.path.join(ROOT, "core", "*", "*.h")))
    rules = set(re.findall(r"^\| `([a-z]+)` \|", read("docs", "certificate-format.md"), re.M))
    count = 0
    for cells in table:
        expect(all(cells), "lemmas.md, %s: an empty cell" % cells[0])
        for word in re.findall(r"`([^`]+)`", cells[3]):
            if "/" not in word:
                for part in word.split("::"):
                    expect(re.search(r"\b%s\b" % part, core), "lemmas.md, %s: no %s in core/" % (cells[0], word))
        for word in re.findall(r"`([^`]+)`", cells[4]):
            expect(word in rules or word == "refutes", "lemmas.md, %s: no rule %s" % (cells[0], word))
        count += check_references("lemmas.md, " + cells[0], cells[5], files, names)
        for case in re.findall(r"placement_test: ([\w, ]+)", cells[6]):
            for name in case.split(", "):
                expect("BOOST_AUTO_TEST_CASE(%s)" % name in read("tests/core/placement/placement_test.cpp"), "lemmas.md, %s: no case %s" % (cells[0], name))
    claims = [cells for cells in rows(page, 5) if cells[0] != "claim"]
    listed = re.findall(r'^    \{"([HL][\w-]+)",', read("proofs", "lemmas", "table.cpp"), re.M)
    expect([cells[0] for cells in claims] == listed and len(listed) == 28, "lemmas.md: the table of claims is not that of proofs/lemmas/table.cpp")
    graded = set(re.findall(r'"([HL]\d*[\w-]*)"', read("core", "placement", "local_claims.cpp")))
    for cells in claims:
        for path, function in re.findall(r"`([\w/.]+)`: (\w+)", cells[2] + " " + cells[3]):
            expect(os.path.exists(os.path.join(ROOT, path)) and re.search(r"\b%s\(" % function, read(path)), "lemmas.md, claim %s: no %s in %s" % (cells[0], function, path))
        expect((cells[4] == "yes") == (cells[0] in graded), "lemmas.md, claim %s: what graded claims is otherwise" % cells[0])
    for cells in rows(page, 3):
        count += check_references("lemmas.md, implications", cells[2], files, names)
    for path in re.findall(r"`((?:core|tests|proofs)/[\w/.-]+)`", page):
        expect(os.path.exists(os.path.join(ROOT, path)), "lemmas.md: no " + path)
    for path in re.findall(r"`((?:accept|reject)/[\w.-]+)`", page):
        expect(os.path.exists(os.path.join(ROOT, "tests", "certificates", path)), "lemmas.md: no " + path)
    return count


def check_proofs(files, names):
    page = read("docs", "proofs.md")
    before, _, rest = page.partition("<!-- assumptions begin -->")
    table, _, after = rest.partition("<!-- assumptions end -->")
    count = sum(check_references("proofs.md", cells[2], files, names) for cells in rows(before, 3))
    everything = set().union(*names.values()) | AXIOMS
    prose = "\n".join(line for line in (before + after).split("\n") if not line.startswith("|"))
    prose = re.sub(r"^```.*?^```", "", prose, flags=re.M | re.S)
    for name in re.findall(r"(?<![\w./*{^])[A-Za-z]\w*_\w+\b(?!\.\w)", prose):
        count += 1
        expect(name in everything or name == "m_B" or re.match(r"m_\d+$", name), "proofs.md: no %s" % name)
    listed = {}
    for cells in rows(table, 3):
        if cells[0] != "file":
            listed.setdefault(cells[0][:-2], []).extend(cells[1].split(", "))
    for path in files:
        theorems = [name for kind, name in re.findall(r"^(Theorem|Corollary) ([\w']+)", files[path], re.M)]
        if path != OPEN and theorems:
            expect(listed.get(path) == theorems, "proofs.md: the table of axioms does not have %s.v as it is: run proofs/coq/check.sh" % path)
    expect(set(listed) <= set(files), "proofs.md: the table of axioms has a file that does not exist")
    return count


def check_gaps(files):
    for path, text in files.items():
        if path == OPEN:
            continue
        for match in GAP.finditer(re.sub(r'"(?:[^"]|"")*"', '""', text)):
            expect(False, "proofs/coq/%s.v: %s" % (path, match.group(1) or match.group(2)))
        expect(not re.search(r"Require.*\bRemaining\b", text), "proofs/coq/%s.v uses the open goals" % path)


def check_sizes():
    """The lines that trust-verified-checker.md counts, to within a tenth."""
    page = read("docs", "trust-verified-checker.md")
    def lines(*paths):
        return sum(read(path).count("\n") for path in paths)
    proofs, ours = "proofs/coq/checker/", "checkers/verified/"
    definitions = [proofs + "Space.v", proofs + "Statement.v"]
    rest = [os.path.relpath(path, ROOT) for path in glob.glob(os.path.join(COQ, "checker", "*.v"))]
    rest = [path for path in rest if path not in definitions + [proofs + "Check.v"]]
    for shown, count in ((r"`Space.v`, `Statement.v` \| (\d+) \|", lines(*definitions)), (r"\((\d+) lines together", lines(*definitions)),
                         (r"`Extract.v` \| (\d+) \|", lines(ours + "Extract.v")), (r"`main.ml` \| (\d+) \|", lines(ours + "main.ml")),
                         (r"`reader.ml`, `sha256.ml` \| (\d+) \|", lines(ours + "reader.ml", ours + "sha256.ml")),
                         (r"`Check.v`, (\d+) lines", lines(proofs + "Check.v")), (r"proofs: (\d+) lines", lines(*rest))):
        match = re.search(shown, page)
        expect(match and abs(int(match.group(1)) - count) <= count / 10, "trust-verified-checker.md: %s is %d today" % (shown, count))


def self_test(files, names):
    """The checks can fail."""
    def failing(action):
        before = len(failures)
        action()
        seen = len(failures) > before
        del failures[before:]
        return seen
    for text in ("Proof. Admitted.", "Axiom a : True.", "Qed.\n  Parameter b : nat.", "intros; admit."):
        assert failing(lambda: check_gaps({"lemmas/X": text})), text
    assert not failing(lambda: check_gaps({"lemmas/X": without_comments("(* Admitted (* Axiom *) *) Parameterless.")}))
    for cell in ("Pencil: no_such_theorem", "NoSuchFile: pencil", "checker/Pencil: pencil"):
        assert failing(lambda: check_references("self-test", cell, files, names)), cell


def main():
    files = sources()
    names = {path: {name for _, name in STATEMENT.findall(text)} for path, text in files.items()}
    self_test(files, names)
    check_gaps(files)
    check_sizes()
    counts = check_lemmas(files, names), check_proofs(files, names)
    for failure in failures:
        print("FAILED " + failure)
    print("%d Coq files; lemmas.md names %d theorems, proofs.md %d; %d failures" % (len(files), *counts, len(failures)))
    sys.exit(1 if failures or min(counts) < 50 else 0)


main()
