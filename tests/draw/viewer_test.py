#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""viewer_test.py BINARIES: the HTML pictures in a real headless Chromium. Skipped where there is none."""
import json
import os
import sys
import tempfile

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path[:0] = [HERE, os.path.join(HERE, "..", "pipeline")]
import browser  # noqa: E402
from harness import EXAMPLES, ROOT, Programs  # noqa: E402

ACCEPT = os.path.join(ROOT, "tests", "certificates", "accept")
# How many pixels differ from the corner's, how many differ from the picture before, and how many are strongly orange.
LOOK = """(() => { const p = confidel.pixels(); let drawn = 0, changed = 0; const before = window.before;
for (let i = 0; i < p.length; i += 4) { if (p[i] !== p[0] || p[i + 1] !== p[1] || p[i + 2] !== p[2]) ++drawn;
if (before && (p[i] !== before[i] || p[i + 1] !== before[i + 1] || p[i + 2] !== before[i + 2])) ++changed; }
window.before = p; return [drawn, changed]; })()"""
SET = "(() => { const e = document.getElementById('%s'); e.value = '%s'; e.dispatchEvent(new Event('%s')); })()"


def look_at(page, programs, path, dark):
    name = os.path.basename(path) + (" in dark" if dark else "")
    page.colours(dark)
    page.open(path)
    drawn, _ = page.run(LOOK)
    programs.expect(drawn > 20000, "%s: only %d pixels drawn" % (name, drawn))

    def changes(what, at_least):
        _, changed = page.run(LOOK)
        programs.expect(changed >= at_least, "%s: %s changes only %d pixels" % (name, what, changed))

    changed = page.run(LOOK)[1]
    programs.expect(changed == 0, "%s: the same picture twice differs in %d pixels" % (name, changed))
    page.run(SET % ("tightest", "300", "input"))
    shown, count = int(page.run("document.getElementById('shown').textContent")), page.run("confidel.cellCount")
    programs.expect(0 < shown < count, "%s: the slider shows %d of %d" % (name, shown, count))
    changes("the slider", 2000)
    page.run(SET % ("tightest", "1000", "input"))
    changes("the slider back", 2000)
    for colour in ("slack", "stage", "facet", "kind"):
        page.run(SET % ("colour", colour, "change"))
        changes("colour by " + colour, 2000)
    page.run(SET % ("axis", "view", "change"))
    changes("the cutting plane", 500)
    page.run(SET % ("cut", "0.3", "input"))
    changes("moving it", 100)
    page.run(SET % ("axis", "", "change"))
    page.run(LOOK)
    for layer in ("balls", "rows", "chew", "points", "segments", "cells", "cells"):
        page.run("document.getElementById('layer-%s').click()" % layer)
        changes("layer " + layer, 20)

    # Choosing with the mouse, where a cell is seen.
    spot = page.run("""(() => { const c = document.getElementById('view'); for (let y = 20; y < c.clientHeight; y += 7) for (let x = 20; x < c.clientWidth; x += 7)
      if (confidel.cellAt(x, y) >= 0) return [x, y, confidel.cellAt(x, y)]; return null; })()""")
    if programs.expect(spot is not None, name + ": no cell under any place"):
        page.click(spot[0], spot[1])
        programs.expect(page.run("confidel.state.picked") == spot[2], "%s: a click chooses the cell under it" % name)
        text = page.run("document.getElementById('picked').innerText")
        programs.expect("cell %d" % spot[2] in text and "radius" in text, "%s: what is said of it: %r" % (name, text[:200]))
        changes("choosing", 50)

    # And with keys alone: n chooses by slack, Escape clears, arrows turn.
    page.run("document.getElementById('view').focus()")
    page.key("Escape")
    programs.expect(page.run("confidel.state.picked") == -1, name + ": Escape clears")
    page.key("n")
    programs.expect(page.run("confidel.state.picked") == page.run("confidel.order[0]"), name + ": n chooses the tightest")
    page.key("n")
    programs.expect(page.run("confidel.state.picked") == page.run("confidel.order[1]"), name + ": n goes on")
    page.run(LOOK)
    page.key("ArrowLeft")
    changes("turning", 1000)
    page.key("g")
    changes("going to the cell", 1000)
    page.key("f")
    tabs = page.run("""[...document.querySelectorAll('canvas,input,select,button,summary')].filter((e) => e.offsetParent && !e.disabled && e.tabIndex < 0).length""")
    programs.expect(tabs == 0, "%s: %s controls that the keyboard does not reach" % (name, tabs))
    programs.expect(page.errors == [], "%s: errors in the page: %s" % (name, page.errors))
    outside = [address for address in page.requests if not address.startswith(("file:///", "data:"))]
    programs.expect(outside == [] and len([a for a in page.requests if a.startswith("file:")]) <= 1, "%s: requests: %s" % (name, page.requests))
    page.requests.clear()


def by_lemma(page, programs, certificate, lemma):
    """Colouring by a lemma makes its slack the order of the slider and of the keys."""
    before = page.run("confidel.order[0]")
    page.run(SET % ("colour", lemma, "change"))
    page.run("confidel.pick(-1); document.getElementById('view').focus()")
    page.key("n")
    text = page.run("document.getElementById('picked').innerText")
    place = json.loads(programs.run("lemma", "check", lemma, certificate, "--json")[1])["lemmas"][0]
    programs.expect("line %d of the certificate" % place["line"] in text and "number 1 by slack of " + lemma in text, "%s: n chooses %r, not line %d" % (lemma, text[:120], place["line"]))
    page.run("confidel.setTightest(1)")
    spot = page.run("""(() => { const c = document.getElementById('view'), seen = new Set(); for (let y = 0; y < c.clientHeight; y += 3) for (let x = 0; x < c.clientWidth; x += 3)
      seen.add(confidel.cellAt(x, y)); seen.delete(-1); return [...seen]; })()""")
    programs.expect(spot in ([], [page.run("confidel.order[0]")]), "%s: the slider at one shows %s" % (lemma, spot))
    page.run(SET % ("colour", "kind", "change"))
    programs.expect(page.run("confidel.order[0]") == before, lemma + ": another colour gives the order back")


def contrast(page):
    """The smallest ratio of luminances of text and ground in the panel (WCAG)."""
    return page.run("""(() => { const lum = (c) => { const v = c.match(/[\\d.]+/g).slice(0, 3).map((x) => { x /= 255; return x <= 0.04045 ? x / 12.92 : ((x + 0.055) / 1.055) ** 2.4; });
      return 0.2126 * v[0] + 0.7152 * v[1] + 0.0722 * v[2]; };
      const ground = lum(getComputedStyle(document.body).backgroundColor);
      return Math.min(...[...document.querySelectorAll('aside h1, aside p, aside label, aside td')].map((e) => { const l = lum(getComputedStyle(e).color); return (Math.max(l, ground) + 0.05) / (Math.min(l, ground) + 0.05); })); })()""")


def main():
    if browser.find() is None:
        print("skipped: there is no Chromium (Debian: apt-get install chromium)")
        sys.exit(77)
    programs = Programs(sys.argv[1])
    with tempfile.TemporaryDirectory() as folder, browser.Browser() as page:
        certificate, picture = os.path.join(folder, "fan.cert"), os.path.join(folder, "fan.html")
        programs.expect_verified("fan", os.path.join(EXAMPLES, "fan.off"), certificate, "--strategy", "graded")
        programs.expect(programs.run("draw", certificate, "-o", picture)[0] == 0, "draw .html")
        for dark in (False, True):
            look_at(page, programs, picture, dark)
            ratio = contrast(page)
            programs.expect(ratio >= 4.5, "contrast of text is only %.2f%s" % (ratio, " in dark" if dark else ""))
        for lemma in ("L5", "L7"):
            by_lemma(page, programs, certificate, lemma)
        programs.expect("s VERIFIED" in page.run("document.getElementById('verdict').textContent"), "the verdict is shown")
        programs.expect(page.run("document.querySelectorAll('#table tr').length") > 10, "the rules are listed")
        for name in sorted(os.listdir(ACCEPT))[::3]:  # odd ones: coplanar, hanging only, with offsets and the like
            programs.run("draw", os.path.join(ACCEPT, name), "-o", picture, "--no-check")
            page.open(picture)
            page.run("confidel.pick(confidel.cellCount - 1); confidel.pixels().length")
            programs.expect(page.errors == [], "%s: %s" % (name, page.errors))
        # Colours by the slack of a claimed lemma.
        programs.expect_verified("corner", os.path.join(EXAMPLES, "corner-45.poly"), certificate, "--strategy", "repaired")
        programs.run("draw", certificate, "-o", picture)
        page.open(picture)
        page.run(LOOK)
        page.run(SET % ("colour", "L1", "change"))
        _, changed = page.run(LOOK)
        programs.expect(changed > 200 and page.run("document.querySelectorAll('#legend span').length") > 3, "colour by the slack of L1: %d pixels" % changed)
        page.run("confidel.pick(%d)" % page.run("lemmas.get('L1').cells[0]"))
        programs.expect("slack of L1" in page.run("document.getElementById('picked').innerText"), "the slack of L1 is said")
        # The SVG's switches: a hidden layer appears, by mouse and by key.
        drawing = os.path.join(folder, "plane.svg")
        programs.run("draw", os.path.join(ACCEPT, "rows-boxes-dim2.cert"), "-o", drawing)
        page.open(drawing)
        state = "getComputedStyle(document.getElementById('triangulation')).display"
        programs.expect(page.run(state) != "none", "the triangulation is shown")
        page.run("document.querySelector('[data-layer=triangulation]').dispatchEvent(new MouseEvent('click'))")
        programs.expect(page.run(state) == "none", "a click hides the layer")
        page.run("document.querySelector('[data-layer=triangulation]').focus()")
        page.key("Enter")
        programs.expect(page.run(state) != "none", "a key shows it again")
        programs.expect(page.errors == [], "the SVG: %s" % page.errors)
    programs.finish()


main()
