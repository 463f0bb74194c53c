#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""screenshot.py PAGE PICTURE: a page of confidel draw as Chromium shows it, with the tightest cell chosen."""
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "tests", "draw"))
from browser import Browser  # noqa: E402

with Browser(1100, 700) as page:
    page.open(sys.argv[1])
    page.run("confidel.goTo(confidel.order[0]); confidel.camera.distance *= 2.5; confidel.setTightest(1200); confidel.pixels().length")
    page.screenshot(sys.argv[2])
