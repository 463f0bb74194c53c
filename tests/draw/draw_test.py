#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""draw_test.py BINARIES: confidel draw, from certificates to pictures that are read again."""
import base64
import json
import os
import re
import struct
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as ET

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "pipeline"))
from harness import EXAMPLES, ROOT, Programs, content, last_line  # noqa: E402

SVG = "{http://www.w3.org/2000/svg}"
ACCEPT = os.path.join(ROOT, "tests", "certificates", "accept")
SQUARE = "6 2 0 0\n1 0 0\n2 8 0\n3 8 6\n4 0 6\n5 2 3\n6 6 3\n5 0\n1 1 2\n2 2 3\n3 3 4\n4 4 1\n5 5 6\n0\n"


def layers_of(path):
    """Layer id -> the elements in it."""
    scene = next(g for g in ET.parse(path).getroot().iter(SVG + "g") if g.get("id") == "scene")
    return {layer.get("id"): list(layer) for layer in scene}


def records(path, word):
    return [line.split() for line in content(path).decode().split("\n") if line.startswith(word + " ")]


def test_svg(programs, folder):
    source, certificate, picture = (os.path.join(folder, name) for name in ("square.poly", "square.cert", "square.svg"))
    with open(source, "w") as file:
        file.write(SQUARE)
    programs.expect_verified("square", source, certificate, "--strategy", "graded")
    code, out, err = programs.run("draw", certificate, "-o", picture)
    programs.expect(code == 0 and err == "" and "s VERIFIED" in out, "draw: exit %d, %r, %r" % (code, out, err))
    layers = layers_of(picture)
    cells = records(certificate, "t")
    kinds = [cell[5] for cell in cells]
    programs.expect(len(layers["chew"]) == kinds.count("C"), "one object for each cell of the Chew region")
    programs.expect(len(layers["buffer"]) == len(kinds) - kinds.count("C") > 0, "one object for each cell of the buffer zones")
    programs.expect(len(layers["circumcircles"]) == len(cells), "one circumcircle for each cell")
    programs.expect(len(layers["points"]) == len(records(certificate, "q")), "one object for each Steiner point")
    programs.expect(len(layers["input"]) == 5 + 6, "segments and vertices")
    programs.expect(len(layers["circles"]) == 6, "a protecting circle at each vertex")
    programs.expect(not layers["violations"], "no violation in what is verified")
    for name, shapes in layers.items():
        for shape in shapes:
            title = shape.findtext(SVG + "title")
            programs.expect(bool(title) and re.search(r"\d", title), "%s: an object without a tooltip" % name)
            programs.expect(name == "points" or "relative power" in title, "%s: a tooltip without a slack: %r" % (name, title))
    text = content(picture)
    programs.expect(b"http" not in text.replace(b"http://www.w3.org/2000/svg", b""), "no address but the name of SVG")
    again = os.path.join(folder, "again.svg")
    programs.run("draw", certificate, "-o", again)
    programs.expect(content(again) == text, "the same bytes again")
    programs.run("draw", certificate, "-o", again, "--exact", "--layers", "input,chew", "--no-panel", "--window", "0", "0", "3", "3")
    part = layers_of(again)
    programs.expect(0 < len(part["chew"]) < len(layers["chew"]), "a window shows a part")
    programs.expect(b"rounded" not in content(again) and b"<script" not in content(again), "--exact rounds nothing; --no-panel has no script")
    code, _, err = programs.run("draw", certificate, "-o", again, "--max-elements", "150")
    programs.expect(code == 0 and "without tooltips" in err, "a cap is said: %r" % err)
    merged = layers_of(again)
    programs.expect(sum(map(len, merged.values())) <= 150 + 4 * len(merged), "the cap holds")
    os.remove(again)


def test_violation(programs, folder):
    """A point moved into a circle: the picture shows it although the certificate is nothing worth."""
    text = content(os.path.join(ACCEPT, "dim2-thirds.cert")).decode()
    points = [line for line in text.split("\n") if line.startswith("v ")]
    low = [min(int(p.split()[1 + axis], 16) / int(p.split()[3], 16) for p in points) for axis in (0, 1)]
    high = [max(int(p.split()[1 + axis], 16) / int(p.split()[3], 16) for p in points) for axis in (0, 1)]
    inside = "v %x %x 3e8" % tuple(int(1000 * (0.45 * l + 0.55 * h)) for l, h in zip(low, high))
    count = len(points)
    text = text.replace("vertices %d\n" % count, "vertices %d\n" % (count + 1)).replace(points[-1] + "\n", points[-1] + "\n" + inside + "\n", 1)
    text = re.sub(r"\nend %d " % count, "\nend %d " % (count + 1), text)
    spoilt, picture = os.path.join(folder, "spoilt.cert"), os.path.join(folder, "spoilt.svg")
    shift = lambda match: match.group(0) if int(match.group(0)) < count else str(int(match.group(0)) + 1)  # noqa: E731
    lines = [" ".join(f if k in (0, 1, 5) else re.sub(r"\d+", shift, f) for k, f in enumerate(line.split())) if line.startswith("t ") else line for line in text.split("\n")]
    with open(spoilt, "w") as file:
        file.write("\n".join(lines))
    code, out, err = programs.run("draw", spoilt, "-o", picture)
    programs.expect(code == 0 and "s REJECTED" in out, "draw of a wrong certificate: exit %d, %r, %r" % (code, out, err))
    programs.expect(len(layers_of(picture)["violations"]) >= 2, "the violated circle and the point in it are shown")


def arrays_of(path):
    result = {}
    for array in ET.parse(path).getroot().iter("DataArray"):
        data = base64.b64decode(array.text)
        kind = {"Float64": "d", "Int64": "q", "UInt8": "B"}[array.get("type")]
        size = struct.unpack_from("<Q", data)[0]
        result[array.get("Name")] = struct.unpack("<%d%s" % (size // struct.calcsize(kind), kind), data[8:])
        if size != len(data) - 8:
            raise ValueError("the length of an array")
    return result


def meshio_python():
    for python in (sys.executable, "/usr/bin/python3"):
        if os.path.exists(python) and subprocess.run([python, "-c", "import meshio"], capture_output=True).returncode == 0:
            return python
    return None


def test_vtu(programs, folder):
    certificate, grid = os.path.join(folder, "w3.cert"), os.path.join(folder, "w3.vtu")
    programs.expect_verified("w3", os.path.join(EXAMPLES, "w3.smesh"), certificate)
    programs.expect(programs.run("draw", certificate, "-o", grid)[0] == 0, "draw .vtu")
    arrays, cells = arrays_of(grid), records(certificate, "t")
    programs.expect(arrays["connectivity"] == tuple(int(v) for cell in cells for v in cell[2:5]), "the corners of the cells")
    programs.expect(arrays["offsets"] == tuple(range(3, 3 * len(cells) + 1, 3)) and set(arrays["types"]) == {5}, "triangles")
    programs.expect(arrays["facet"] == tuple(int(cell[1]) for cell in cells), "the facets")
    report = json.loads(programs.run(certificate, "--json", program=programs.checker)[1])["smallest-relative-power"]
    programs.expect("%.6g" % min(arrays["slack"]) == "%.6g" % report["value"], "the smallest slack is the checker's: %r, %r" % (min(arrays["slack"]), report))
    tightest = arrays["slack"].index(min(arrays["slack"]))
    programs.expect((arrays["line"][tightest], arrays["nearest-off-plane"][tightest]) == (report["cell-line"], report["point"]), "and at the same place")
    corner, repaired = os.path.join(folder, "corner.cert"), os.path.join(folder, "corner.vtu")
    programs.expect_verified("corner", os.path.join(EXAMPLES, "corner-45.poly"), corner, "--strategy", "repaired")
    programs.run("draw", corner, "-o", repaired)
    by_cell = arrays_of(repaired)
    claims = {claim["id"]: claim for claim in json.loads(programs.run(corner, "--json", program=programs.checker)[1])["claims"]}
    lemmas = [name[6:] for name in by_cell if name.startswith("slack-")]
    programs.expect({"L1", "L2", "L3", "L4"} <= set(lemmas) <= set(claims), "the slacks of claimed lemmas are there: %s" % lemmas)
    for lemma in lemmas:
        smallest = min(value for value in by_cell["slack-" + lemma] if value == value)
        programs.expect("%.6g" % smallest == "%.6g" % claims[lemma]["slack"], "%s: the smallest slack of a cell is %r, the checker's %r" % (lemma, smallest, claims[lemma]["slack"]))
    hanging = os.path.join(folder, "hanging.vtu")
    programs.run("draw", os.path.join(ACCEPT, "worked-example.cert"), "-o", hanging)
    programs.expect(arrays_of(hanging)["types"] == (5, 5, 5, 3, 3), "subsegments are lines")
    python = meshio_python()
    if python is None:
        print("skipped: meshio is not there (Debian: python3-meshio)")
        return
    script = "import meshio,sys; m=meshio.read(sys.argv[1]); print(len(m.points), [(c.type,len(c.data)) for c in m.cells], sorted(m.cell_data), m.cell_data['slack'][0].shape)"
    done = subprocess.run([python, "-c", script, hanging], capture_output=True, text=True)
    programs.expect(done.returncode == 0 and "7 [('triangle', 3), ('line', 2)]" in done.stdout and "(3,)" in done.stdout, "meshio reads it: %r %r" % (done.stdout, done.stderr[-300:]))


def test_errors(programs, folder):
    cut, picture = os.path.join(folder, "cut.cert"), os.path.join(folder, "cut.svg")
    with open(cut, "wb") as file:
        file.write(content(os.path.join(ACCEPT, "dim2-thirds.cert"))[:200])
    code, _, err = programs.run("draw", cut, "-o", picture)
    programs.expect(code == 2 and re.match(re.escape(cut) + r":\d+:\d+: error\[E-TRUNCATED\]: ", err), "a cut certificate: %d %r" % (code, err))
    programs.expect(not os.path.exists(picture), "nothing is written then")
    good = os.path.join(ACCEPT, "worked-example.cert")
    for output, words in ((picture, "dimension 3"), (os.path.join(folder, "x.png"), "suffixes")):
        code, _, err = programs.run("draw", good, "-o", output)
        programs.expect(code == 2 and words in err and not os.path.exists(output), "%s: %d %r" % (output, code, err))
    code, _, err = programs.run("draw", os.path.join(folder, "none.cert"), "-o", picture)
    programs.expect(code == 4 and "E-FILE" in err, "no such file: %d %r" % (code, err))
    code, _, err = programs.run("draw", os.path.join(ACCEPT, "dim2-thirds.cert"), "-o", os.path.join(folder, "no", "such.svg"))
    programs.expect(code == 4, "no such folder: %d %r" % (code, err))
    code, _, err = programs.run("draw", good, "-o", picture, "--window", "1", "1", "0", "0")
    programs.expect(code == 2 and "E-USAGE" in err, "an empty window: %d %r" % (code, err))
    for name in sorted(os.listdir(ACCEPT)):  # small and odd ones: nothing crashes
        for suffix in ("svg", "html", "vtu"):
            output = os.path.join(folder, "odd." + suffix)
            code, out, err = programs.run("draw", os.path.join(ACCEPT, name), "-o", output, "--no-check")
            planar = suffix != "svg" or "dimension 3" in err
            programs.expect(code == 0 or (code == 2 and planar), "%s as %s: %d %r" % (name, suffix, code, err))
    programs.expect(last_line(out).endswith(".vtu"), "the last line names the picture")


def test_figures(programs, folder):
    """docs/figures/make.sh makes every picture that the pages show."""
    figures = os.path.join(ROOT, "docs", "figures")
    made = os.path.join(folder, "figures")
    done = subprocess.run(["bash", os.path.join(figures, "make.sh"), os.path.dirname(programs.confidel), made], capture_output=True, text=True,
                          env=dict(os.environ, CONFIDEL_NO_SCREENSHOT="1"))
    if not programs.expect(done.returncode == 0, "make.sh: %r" % done.stderr[-500:]):
        return
    shown = {name for page in ("README.md", "../drawing.md") for name in re.findall(r"\]\((?:figures/)?([\w-]+\.svg)\)", content(os.path.join(figures, page)).decode())}
    programs.expect(shown == set(os.listdir(made)) and len(shown) >= 9, "pages show %s, made are %s" % (sorted(shown), sorted(os.listdir(made))))
    for name in sorted(shown):
        programs.expect(os.path.exists(os.path.join(figures, name)), name + " is not in docs/figures")
        programs.expect(any(layers_of(os.path.join(made, name)).values()), name + " is empty")


def main():
    programs = Programs(sys.argv[1])
    with tempfile.TemporaryDirectory() as folder:
        for test in (test_svg, test_violation, test_vtu, test_errors, test_figures):
            test(programs, folder)
    programs.finish()


main()
