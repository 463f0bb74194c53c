#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Relative links of README.md and docs/*.md point at files of the repository, and their fragments at headings."""
import glob
import os
import re
import sys

ROOT = os.path.normpath(os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", ".."))


def without_code(text):
    text = re.sub(r"^```.*?^```", "", text, flags=re.M | re.S)
    return re.sub(r"`[^`\n]*`", "", text)


def anchors(path):
    """As GitHub makes them: lower case, punctuation gone, blanks to hyphens."""
    headings = re.findall(r"^#+ +(.+?) *$", open(path).read(), re.M)
    return {re.sub(r"[^\w\- ]", "", heading.lower()).replace(" ", "-") for heading in headings}


def main():
    failures, links = [], 0
    for page in [os.path.join(ROOT, "README.md")] + sorted(glob.glob(os.path.join(ROOT, "docs", "*.md"))):
        for target in re.findall(r"\]\(([^)\s]+)\)", without_code(open(page).read())):
            if re.match(r"[a-z]+:", target):
                continue
            links += 1
            path, _, fragment = target.partition("#")
            full = os.path.normpath(os.path.join(os.path.dirname(page), path)) if path else page
            if not os.path.exists(full) or not full.startswith(ROOT):
                failures.append("%s: no file %s" % (os.path.relpath(page, ROOT), target))
            elif fragment and fragment not in anchors(full):
                failures.append("%s: no heading %s" % (os.path.relpath(page, ROOT), target))
    for failure in failures:
        print("FAILED " + failure)
    print("%d links, %d broken" % (links, len(failures)))
    return 1 if failures or not links else 0


if __name__ == "__main__":
    sys.exit(main())
