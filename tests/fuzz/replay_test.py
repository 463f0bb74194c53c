#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""What fuzzing has found worth keeping, fed to the ordinary programs: every answer is an answer. replay_test.py BIN"""
import glob
import hashlib
import os
import resource
import subprocess
import sys
import tempfile

HERE = os.path.dirname(os.path.abspath(__file__))
MEMORY = 1 << 30
TIMEOUT = 20


def limited():
    resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))


def run(*command):
    return subprocess.run(command, capture_output=True, timeout=TIMEOUT, preexec_fn=limited)


def with_digest(data):
    line = data.rfind(b"\nend ")
    field = data.rfind(b" ")
    if line < 0 or field <= line + 4:
        return None
    return data[:field + 1] + hashlib.sha256(data[:line + 1]).hexdigest().encode() + b"\n"


def absurd():
    """(suffix, bytes): files that announce far more than they hold."""
    many = b"2000000000"
    yield "poly", many + b" 3 0 0\n1 0 0 0\n"
    yield "poly", b"3 2 0 0\n1 0 0\n2 1 0\n3 0 1\n" + many + b" 0\n1 1 2\n"
    yield "smesh", b"1 3 0 0\n1 0 0 0\n" + many + b" 0\n2000000000 1"
    yield "off", b"OFF\n" + many + b" " + many + b" 0\n0 0 0\n"
    yield "ply", b"ply\nformat ascii 1.0\nelement vertex " + many + b"\nproperty float x\nproperty float y\nproperty float z\nend_header\n0 0 0\n"
    yield "ply", b"ply\nformat binary_little_endian 1.0\nelement vertex 1\nproperty float x\nproperty float y\nproperty float z\nelement face 1\nproperty list uint int vertex_index\nend_header\n" + b"\0" * 12 + b"\xff\xff\xff\x7f"
    yield "mesh", b"MeshVersionFormatted 1\nDimension 3\nVertices " + many + b"\n0 0 0 0\n"
    yield "edg", many + b"\n0 0 1 1\n"
    yield "stl", b"\0" * 80 + b"\xff\xff\xff\x7f" + b"\0" * 50
    yield "cert", b"confidel-certificate 1\nplc 1\ndim 3\nvertices 2147483647\nv 0 0 0 1\n"
    yield "cert", b"confidel-certificate 1\nplc 1\ndim 3\nvertices 1\nv " + b"f" * 1000000 + b" 0 0 1\n"


def main():
    folder = os.path.abspath(sys.argv[1])
    failures, count = [], 0
    with tempfile.TemporaryDirectory() as work:
        cases = [(os.path.basename(os.path.dirname(path)), path, open(path, "rb").read()) for path in sorted(glob.glob(os.path.join(HERE, "corpus", "*", "*")))]
        cases += [(suffix, "absurd %d" % number, data) for number, (suffix, data) in enumerate(absurd())]
        for kind, name, data in cases:
            certificate = kind in ("checker", "cert")
            texts = [data] + ([with_digest(data)] if certificate and with_digest(data) else [])
            for text in texts:
                path = os.path.join(work, "case." + ("cert" if certificate else kind))
                with open(path, "wb") as out:
                    out.write(text)
                count += 1
                try:
                    done = run(os.path.join(folder, "confidel-check"), path, "--threads", "1") if certificate else run(os.path.join(folder, "confidel"), "info", path)
                except subprocess.TimeoutExpired:
                    failures.append("%s %s: no answer in %d s" % (kind, name, TIMEOUT))
                    continue
                allowed = (0, 2, 3, 5) if certificate else (0, 2, 4)
                if name.startswith("absurd"):
                    allowed = (2, 3)
                if done.returncode not in allowed or (done.returncode == 2 and b": error[E-" not in done.stderr):
                    failures.append("%s %s: exit %d: %s" % (kind, name, done.returncode, done.stderr[-300:]))
    for failure in failures:
        print("FAILED " + failure)
    print("%d inputs, %d failures" % (count, len(failures)))
    return 1 if failures or count < 11 else 0


if __name__ == "__main__":
    sys.exit(main())
