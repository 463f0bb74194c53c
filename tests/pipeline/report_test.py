#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""report_test.py BINARIES: the page of a campaign: well-formed, without scripts and addresses, with the records' numbers; damaged records are refused."""
import json
import os
import re
import sys
import tempfile
from html.parser import HTMLParser

from harness import EXAMPLES, Programs

VOID = {"meta", "br"}


class Page(HTMLParser):
    def __init__(self):
        super().__init__()
        self.open, self.rows, self.attributes, self.faults = [], [], [], []

    def handle_starttag(self, tag, attributes):
        self.attributes += [(tag, name, value) for name, value in attributes]
        if tag not in VOID:
            self.open.append(tag)
        if tag == "tr":
            self.rows.append([])
        if tag == "td":
            self.rows[-1].append("")

    def handle_startendtag(self, tag, attributes):
        self.attributes += [(tag, name, value) for name, value in attributes]

    def handle_endtag(self, tag):
        if not self.open or self.open.pop() != tag:
            self.faults.append(tag)

    def handle_data(self, data):
        if self.open and self.open[-1] == "td":
            self.rows[-1][-1] += data


def main():
    programs = Programs(sys.argv[1])
    with tempfile.TemporaryDirectory() as folder:
        out = os.path.join(folder, "report.html")
        code, text, _ = programs.run("report", os.path.join(EXAMPLES, "campaign"), "-o", out, "--json")
        report = json.loads(text)
        programs.expect(code == 0 and report["runs"] == 24 and report["unexpected"] == 0, "the example: %s" % report)
        runs = os.path.join(folder, "runs")
        os.mkdir(runs)
        record = {"seed": 1, "family": "a<b>&\"", "strategy": "lean", "outcome": "verified", "verdict": "s VERIFIED", "steiner_points": 10, "smallest_angle": 2.5,
                  "slacks": {"power": {"slack": 0.125, "object": "cell <1>"}}, "expected": True, "seconds": 0.5}
        bad = dict(record, seed=2, outcome="rejected", verdict="s REJECTED tiling 7 <script>alert(1)</script>", expected=False, smallest_angle=0.001, steiner_points=70000,
                   slacks={"power": {"slack": 0.0625, "object": "cell 2"}})
        with open(os.path.join(runs, "block-00000001-00000002.jsonl"), "w") as file:
            file.write(json.dumps(record) + "\n" + json.dumps(bad) + "\n" + json.dumps({"block": [1, 2], "sha256": ""}) + "\n")
        code, _, err = programs.run("report", runs, "-o", out)
        page = Page()
        with open(out, encoding="utf-8") as file:
            html = file.read()
        page.feed(html)
        programs.expect(code == 0 and page.open == [] and page.faults == [], "the page is not well-formed: %s %s" % (page.open, page.faults))
        programs.expect("<script" not in html and not any(name in ("src", "href") for _, name, _ in page.attributes), "the page has scripts or addresses")
        rows = {tuple(row[:2]): row for row in page.rows if len(row) > 2}
        programs.expect(any(row[:1] == ["a<b>&\" 2"] and "<script>" in row[3] for row in page.rows), "the unexpected run is shown as it is: %s" % page.rows[:4])
        programs.expect(rows[("power", "lean")][2:] == ["0.0625", "a<b>&\" 2", "cell 2"], "the smallest slack: %s" % rows[("power", "lean")])
        programs.expect(rows[("all", "lean")][2:6] == ["2", "1", "1", "1"], "counts: %s" % rows[("all", "lean")])
        programs.expect(len(re.findall(r"<title>.*degrees, ", html)) == 2, "every run is a dot")
        programs.run("report", runs, "-o", out + "2")
        with open(out + "2", encoding="utf-8") as file:
            programs.expect(file.read() == html, "the same records give another page")
        with open(os.path.join(runs, "block-00000003-00000003.jsonl"), "w") as file:
            file.write(json.dumps(record)[:50])
        code, _, err = programs.run("report", runs, "-o", out + "3")
        programs.expect(code == 2 and re.search(r"block-00000003-00000003.jsonl:1:1: error\[E-SYNTAX\]", err) and not os.path.exists(out + "3"), "a cut record: %d %r" % (code, err))
        for empty in (folder, os.path.join(folder, "nowhere")):
            programs.expect(programs.run("report", empty, "-o", out + "4")[0] == 4, "a folder without records")
    programs.finish()


main()
