# SPDX-License-Identifier: Apache-2.0
"""Cases for mutants of the reader (mutation/mutate_checker.py): the last characters, digits and bytes that are allowed, and the first that are not."""

from fractions import Fraction as Q

LONGEST = 1048576  # bytes of a line
BLOCK = 131072


def runs(m, parts, window=None):
    """A zstd frame of texts and of (byte, how many); the window is 2^(10 + window) bytes, or the content's size."""
    blocks = []
    for part in parts:
        if isinstance(part, str):
            blocks += [(0, len(part[i:i + 1000]), part[i:i + 1000].encode()) for i in range(0, len(part), 1000)]
        else:
            byte, size = part
            blocks += [(1, min(BLOCK, size - i), byte) for i in range(0, size, BLOCK)]
    size = sum(len(part) if isinstance(part, str) else part[1] for part in parts)
    return m.zstd_frame(blocks, content_size=size) if window is None else m.zstd_frame(blocks, window=window << 3)


def write_text(m):
    worked = m.worked()
    worked.notes = ["fuzzy- ~ !", "a-z z~"]
    m.accept("notes-last-characters", worked, "notes with the last of the letters and of the printable characters")
    text = m.worked().text()
    m.decline("ten", text.replace("confidel-certificate 1", "confidel-certificate 10"), "newer-version", "version 10")
    m.decline("points", text.replace("points 2", "points 2147483644"), "too-large", "more than 2^31 points, vertices included")
    m.malformed("points-most", text.replace("points 2", "points 2147483643"), "E-COUNT", "cells 3", "2^31 points are announced, vertices included")
    syntax = "E-SYNTAX"
    for name, old, new, reason in [
            ("note-delete", "n strategy by hand", "n strategy by hand\x7f", "a byte 0x7f in a note"),
            ("kind-delete", "q edge 3 1 1 7 1", "q edge\x7f 3 1 1 7 1", "a byte 0x7f in a word"),
            ("kind-control", "t 0 0 1 5 C", "t 0 0 1 5 C\x1f", "a byte 0x1f in a word"),
            ("kind-missing", "t 0 0 1 5 C", "t 0 0 1 5 ", "a cell with a space and no kind"),
            ("index-joined", "s 0 1", "s 0x1", "a letter behind an index"),
            ("keyword-joined", "v 4 0 0 1", "v4 0 0 1", "no space behind the keyword")]:
        m.malformed(name, text.replace(old + "\n", new + "\n", 1), syntax, new, reason)
    for name, cut, code, reason in [("truncated-tab", "v 4 0\t0", syntax, "the last line has no LF, and a tab"), ("truncated-empty-line", "\n", syntax, "the text ends with an empty line"),
                                    ("truncated-empty-lines", "\n\n", syntax, "the text ends with two empty lines")]:
        start = text.index("v 4 0 0 1")
        m.malformed(name, text[:start] + cut, code, text[:start].count("\n") + 1, reason)
    write_long(m)


def write_long(m):
    """Lines and integers that are as long as may be, and one longer."""
    single = m.Certificate(3, [(Q(16 ** 65535, 16 ** 65535 + 1), 0, 0)], [], [])
    head, tail = single.text().split("1%s 0 0 1%s1" % (65535 * "0", 65534 * "0"))
    m.accept("digits-most-zstd", runs(m, [head + "1", (b"0", 65535), " 0 0 1", (b"0", 65534), "1" + tail]), "integers of 65536 digits")

    # The reader takes 2^14 bytes at first, then twice as many each time, up to 2^18: so the line begins that many bytes in that its end is where a piece ends, too.
    c = m.Certificate(3, [(1, 2, 3)], [], [])
    place = 2 ** 14 * 15
    before = "\n".join(c.lines()[:c.lines().index("notes 0")] + ["notes 2", "n padding "])
    c.notes = ["padding " + "x" * (place - len(before) - 1), "long " + "y" * (LONGEST - 7)]
    text = c.text()
    start = text.index("n long ")
    assert start == place and text.index("\n", start) == start + LONGEST
    rest = text[start + LONGEST:]
    m.accept("line-longest-zstd", runs(m, [text[:len(before)], (b"x", place - len(before) - 1), "\nn long ", (b"y", LONGEST - 7), rest]), "a line of 1048576 bytes")
    head = text[:len(before)] + "x\nn long "
    m.decline("line-one-more", runs(m, [head, (b"y", LONGEST - 6), "\n"]), "too-large", "a line of 1048577 bytes")
    m.decline("line-endless", runs(m, [head, (b"y", 400 * BLOCK), "\n"], window=7), "too-large", "a line of 50 MB")
    line = head.count("\n") + 1
    m.malformed("line-long-tab", runs(m, [head, (b"y", LONGEST - 8), "\t", (b"y", 1), "\n"]), "E-SYNTAX", line, "a line of 1048577 bytes, the last but one a tab")
    m.decline("line-long-tab-behind", runs(m, [head, (b"y", LONGEST - 7), "\t\n"]), "too-large", "a line of 1048577 bytes, the last one a tab")
