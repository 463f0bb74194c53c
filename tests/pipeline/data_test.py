#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""data_test.py BINARIES: the real files of the shared folder's data/2d and 3d are VERIFIED by the lean strategy
with few points, those of data/bad are refused. The folder is
$CONFIDEL_SHARED, or `shared` beside the repository; without it nothing is tested, and it says so."""
import os
import sys
import tempfile
import time

from harness import ROOT, Programs, content

# Steiner points that the lean strategy may use at most, where that is known.
AT_MOST = {
    "attene-bracket.off": 40_000,
    "cgal-horizons.off": 400,
    "cgal-joint.off": 600,
    "cgal-pinion_small.off": 700,
    "cgal-tripod.off": 3,
    "gc-fan3.obj": 1,
}
NOTHING = ("cgal-corner_poly", "cgal-cross_quad", "cgal-cubes", "gc-triple_vierbein", "geode-fault", "manifold-Havocglass8", "slit-", "spike-", "wedge-")
# Small enough to be run again, with one thread.
RUN_TWICE = 400_000  # bytes of certificate

REFUSED = {
    "cgal-non_manifold_face_graph.off": "E-DUPLICATE-VERTEX",
    "gc-moebius.obj": "E-NONCOPLANAR",
    "manifold-openscad-nonmanifold-crash.obj": "E-DUPLICATE-VERTEX",
}


def main():
    programs = Programs(sys.argv[1])
    shared = os.environ.get("CONFIDEL_SHARED") or os.path.join(os.path.dirname(ROOT), "shared")
    data = os.path.join(shared, "data")
    if not os.path.isdir(os.path.join(data, "3d")):
        print("SKIPPED: no folder %s; set CONFIDEL_SHARED" % os.path.join(data, "3d"))
        sys.exit(77)
    with tempfile.TemporaryDirectory() as folder:
        out, again = os.path.join(folder, "a.cert"), os.path.join(folder, "b.cert")
        files = [(name, os.path.join(data, dimension, name)) for dimension in ("2d", "3d") for name in sorted(os.listdir(os.path.join(data, dimension)))]
        for name, path in files:
            begin = time.time()
            report = programs.expect_verified(name, path, out)
            if report is None:
                continue
            print("%-36s %7d points, %5.1f s" % (name, report["vertices"] + report["steiner_points"], time.time() - begin), flush=True)
            limit = 0 if name.startswith(NOTHING) else AT_MOST.get(name)
            if limit is not None:
                programs.expect(report["steiner_points"] <= limit, "%s: %d Steiner points, at most %d were expected" % (name, report["steiner_points"], limit))
            programs.expect(not report["lean"]["protected_by_graded"], name + ": protected by graded: " + report["lean"]["reason"])
            if os.path.getsize(out) <= RUN_TWICE:
                programs.expect_verified(name, path, again, "--threads", 1)
                programs.expect(content(out) == content(again), name + ": the bytes depend on the number of threads")
        for path in (out, again):
            if os.path.exists(path):
                os.unlink(path)
        for name, error in REFUSED.items():
            code, text, err = programs.run("conform", os.path.join(data, "bad", name), "-o", out)
            programs.expect(code == 2 and "error[%s]" % error in err, "%s: %d %s" % (name, code, err[:200]))
            programs.expect(os.listdir(folder) == [], name + ": something was written")
    programs.finish()


main()
