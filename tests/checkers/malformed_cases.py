# SPDX-License-Identifier: Apache-2.0
"""Texts that are no certificate: one change each to the worked example."""


def write_malformed(m):
    text = m.worked().text()
    lines = text.split("\n")[:-1]
    last = lines[-1]

    def change(name, code, old, new, reason, occurrence=1):
        """Replaces a line; the error is expected on the new line. The digest is not corrected: these errors come first."""
        place = [i for i, line in enumerate(lines) if line == old][occurrence - 1]
        m.malformed(name, "\n".join(lines[:place] + [new] + lines[place + 1:]) + "\n", code, place + 1, reason)

    def drop(name, code, old, reason, occurrence=1):
        place = [i for i, line in enumerate(lines) if line == old][occurrence - 1]
        m.malformed(name, "\n".join(lines[:place] + lines[place + 1:]) + "\n", code, place + 1, reason)

    def insert(name, code, before, new, reason, occurrence=1):
        place = [i for i, line in enumerate(lines) if line == before][occurrence - 1]
        m.malformed(name, "\n".join(lines[:place] + [new] + lines[place:]) + "\n", code, place + 1, reason)

    syntax = "E-SYNTAX"
    # 1.1
    change("carriage-return", syntax, "v 4 0 0 1", "v 4 0 0 1\r", "CR before LF")
    m.malformed("carriage-returns", text.replace("\n", "\r\n"), syntax, 1, "CR LF throughout")
    change("tab", syntax, "v 4 0 0 1", "v 4\t0 0 1", "a tab")
    change("note-tab", syntax, "n strategy by hand", "n strategy by\thand", "a tab in a note")
    change("note-not-ascii", syntax, "n strategy by hand", "n strategy by h\xe4nd", "a byte above 0x7e in a note")
    change("null-byte", syntax, "v 4 0 0 1", "v 4 0 0 1\0", "a null byte")
    insert("empty-line", syntax, "segments 4", "", "an empty line")
    insert("comment", syntax, "segments 4", "# four of them", "a comment")
    m.malformed("no-final-line-feed", text[:-1], "E-TRUNCATED", last, "the last line has no LF")
    m.malformed("trailing-line", text + "n more\n", "E-TRAILING", len(lines) + 1, "text after the last record")
    m.malformed("trailing-line-feed", text + "\n", "E-TRAILING", len(lines) + 1, "an empty line after the last record")
    m.malformed("trailing-byte", text + "x", "E-TRAILING", len(lines) + 1, "a byte after the last record")
    m.malformed("byte-order-mark", b"\xef\xbb\xbf" + text.encode(), syntax, 1, "a byte order mark")
    # 1.2
    change("double-space", syntax, "v 4 0 0 1", "v 4  0 0 1", "two spaces")
    change("trailing-space", syntax, "v 4 0 0 1", "v 4 0 0 1 ", "a space at the end of a line")
    change("leading-space", syntax, "v 4 0 0 1", " v 4 0 0 1", "a space at the beginning of a line")
    change("trailing-space-header", syntax, "vertices 5", "vertices 5 ", "a space at the end of a header")
    change("trailing-space-word", syntax, "end", "end ", "a space after a lone word")
    change("note-double-space", syntax, "n strategy by hand", "n strategy by  hand", "two spaces in a note")
    change("note-trailing-space", syntax, "n strategy by hand", "n strategy by hand ", "a space at the end of a note")
    # 1.3
    change("count-leading-zero", syntax, "vertices 5", "vertices 05", "a leading zero in a count")
    change("index-leading-zero", syntax, "s 0 1", "s 00 1", "a leading zero in an index")
    change("index-sign", syntax, "s 0 1", "s +0 1", "a sign before an index")
    change("index-negative", syntax, "s 0 1", "s -1 1", "a negative index")
    change("index-hexadecimal", syntax, "s 3 4", "s 3 a", "a hexadecimal index")
    change("count-missing", syntax, "vertices 5", "vertices", "a header without its count")
    # 1.4
    change("upper-case", syntax, "v 4 0 0 1", "v A 0 0 1", "an upper-case digit")
    change("prefix", syntax, "v 4 0 0 1", "v 0x4 0 0 1", "a prefix 0x")
    change("leading-zero", syntax, "v 4 0 0 1", "v 04 0 0 1", "a leading zero")
    change("negative-leading-zero", syntax, "v 4 0 0 1", "v -04 0 0 1", "a leading zero after the sign")
    change("negative-zero", syntax, "v 4 0 0 1", "v 4 -0 0 1", "-0")
    change("lone-sign", syntax, "v 4 0 0 1", "v 4 - 0 1", "a sign without digits")
    change("plus", syntax, "v 4 0 0 1", "v +4 0 0 1", "a plus sign")
    change("decimal-point", syntax, "v 4 0 0 1", "v 4.0 0 0 1", "a decimal point")
    # 1.5
    cell = "t 0 2 0 5 C -1/64"
    change("offset-not-lowest", "E-VALUE", cell, "t 0 2 0 5 C -2/c8", "an offset not in lowest terms")
    change("offset-zero", "E-VALUE", cell, "t 0 2 0 5 C 0/1", "an offset of zero")
    change("offset-zero-denominator", "E-VALUE", cell, "t 0 2 0 5 C 1/0", "a denominator of zero")
    change("offset-negative-denominator", "E-VALUE", cell, "t 0 2 0 5 C 1/-64", "a negative denominator")
    change("offset-integer", syntax, cell, "t 0 2 0 5 C 1", "an offset without a denominator")
    change("offset-two-slashes", syntax, cell, "t 0 2 0 5 C 1/2/3", "an offset with two slashes")
    change("offset-half", syntax, cell, "t 0 2 0 5 C 1/", "an offset without digits after the slash")
    change("offset-twice", syntax, cell, "t 0 2 0 5 C -1/64 -1/64", "two offsets")
    planar = m.square(dim=2)
    flat = m.edited(planar, "t 0 0 1 2 C", "t 0 0 1 2 C 1/2")
    m.malformed("offset-dim2", flat, "E-VALUE", "t 0 0 1 2 C 1/2", "an offset in dimension 2")
    # 1.6
    change("weight-zero", "E-VALUE", "v 4 0 0 1", "v 4 0 0 0", "W is zero")
    change("weight-zero-prime", "E-VALUE", "v 4 0 0 1", "v 1 0 0 0", "W is zero and there is no common divisor")
    change("weight-negative", "E-VALUE", "v 4 0 0 1", "v -4 0 0 -1", "W is negative")
    change("common-divisor-two", "E-VALUE", "v 4 0 0 1", "v 8 0 0 2", "a common divisor of two")
    change("common-divisor-three", "E-VALUE", "v 4 0 0 1", "v c 0 0 3", "a common divisor of three")
    change("common-divisor-of-zero", "E-VALUE", "v 0 0 0 1", "v 0 0 0 5", "the origin with W = 5")
    change("point-common-divisor", "E-VALUE", "q edge 3 1 1 7 1", "q edge 3 6 6 2a 6", "a Steiner point with a common divisor")
    change("coordinate-missing", syntax, "v 4 0 0 1", "v 4 0 1", "a coordinate is missing")
    change("coordinate-too-many", syntax, "v 4 0 0 1", "v 4 0 0 0 1", "a coordinate too many")
    m.malformed("dim2-four-integers", m.edited(planar, "v 1 0 1", "v 1 0 0 1"), syntax, "v 1 0 0 1", "four integers in dimension 2")
    # 1.8
    whole = m.zstd_raw(text)
    m.malformed("zstd-magic-only", whole[:4], "E-ZSTD", 1, "a zstd frame of four bytes")
    m.malformed("zstd-truncated-header", whole[:7], "E-ZSTD", 1, "a zstd frame cut in its header")
    m.malformed("zstd-content-size", whole[:5] + (len(text) + 1).to_bytes(4, "little") + whole[9:], "E-ZSTD", len(lines) + 1, "a zstd frame that announces another size")
    m.malformed("zstd-reserved-block", m.zstd_frame([(3, 5, b"abcde")], content_size=5), "E-ZSTD", 1, "a zstd block of the reserved kind")
    m.malformed("zstd-two-frames", whole + whole, "E-ZSTD", len(lines) + 1, "two zstd frames")
    m.malformed("zstd-trailing-byte", whole + b"\n", "E-ZSTD", len(lines) + 1, "a byte after the zstd frame")
    m.malformed("zstd-empty", m.zstd_frame([(0, 0, b"")], content_size=0), "E-TRUNCATED", 1, "a zstd frame of nothing")
    m.malformed("zstd-trailing-text", m.zstd_raw(text + "n more\n"), "E-TRAILING", len(lines) + 1, "text after the end in a zstd frame")
    m.malformed("zstd-truncated-text", m.zstd_raw(text[:200]), "E-TRUNCATED", text[:200].count("\n") + 1, "text that ends early in a sound zstd frame")
    # 1.9
    change("forward-vertex", "E-RANGE", "s 3 4", "s 3 5", "a segment with a vertex that does not exist")
    change("facet-vertex", "E-RANGE", "f 0 1 2", "f 0 1 5", "a facet with a vertex that does not exist")
    change("boundary-vertex", "E-RANGE", "1 2", "1 5", "a boundary edge with a vertex that does not exist")
    change("carrier-segment", "E-RANGE", "q edge 3 1 1 7 1", "q edge 4 1 1 7 1", "a segment that does not exist")
    change("carrier-facet", "E-RANGE", "q interior 0 1 1 0 1", "q interior 1 1 1 0 1", "a facet that does not exist")
    change("cell-facet", "E-RANGE", "t 0 0 1 5 C", "t 1 0 1 5 C", "a cell in a facet that does not exist")
    change("cell-point", "E-RANGE", "t 0 0 1 5 C", "t 0 0 1 7 C", "a cell with a point that does not exist")
    change("hanging-segment", "E-RANGE", "h 3 3 6", "h 4 3 6", "a subsegment of a segment that does not exist")
    change("hanging-point", "E-RANGE", "h 3 3 6", "h 3 3 7", "a subsegment with a point that does not exist")
    # 2
    change("version-zero", syntax, m.FIRST_LINE, "confidel-certificate 0", "version 0")
    change("version-zero-one", syntax, m.FIRST_LINE, "confidel-certificate 01", "version 01")
    change("version-word", syntax, m.FIRST_LINE, "confidel-certificate one", "a version that is no number")
    change("another-format", syntax, m.FIRST_LINE, "ply", "another format")
    change("complex-version", syntax, "plc 1", "plc 2", "a newer complex in a certificate of version 1")
    change("dimension-four", "E-VALUE", "dim 3", "dim 4", "dimension 4")
    change("dimension-one", "E-VALUE", "dim 3", "dim 1", "dimension 1")
    change("vertices-more", "E-COUNT", "segments 4", "v 9 9 9 1", "more vertices than announced")
    m.malformed("vertices-fewer", text.replace("vertices 5", "vertices 6"), "E-COUNT", "segments 4", "fewer vertices than announced")
    m.malformed("segments-fewer", text.replace("segments 4", "segments 5"), "E-COUNT", "facets 1", "fewer segments than announced")
    m.malformed("segments-more", text.replace("segments 4", "segments 3"), "E-COUNT", "s 3 4", "more segments than announced")
    m.malformed("facets-fewer", text.replace("facets 1", "facets 2"), "E-COUNT", "end", "fewer facets than announced")
    m.malformed("facets-more", text.replace("facets 1", "facets 0"), "E-COUNT", "f 0 1 2", "more facets than announced")
    m.malformed("boundary-fewer", text.replace("b 3", "b 4"), "E-COUNT", "c 0", "fewer boundary edges than announced")
    insert("boundary-more", "E-COUNT", "c 0", "3 0", "more boundary edges than announced")
    m.malformed("boundary-two", text.replace("b 3", "b 2"), "E-VALUE", "b 2", "two boundary edges")
    m.malformed("constraints-fewer", text.replace("c 0", "c 1"), "E-COUNT", "p 0", "fewer inner constraints than announced")
    insert("constraints-more", "E-COUNT", "p 0", "0 1", "more inner constraints than announced")
    m.malformed("isolated-fewer", text.replace("p 0", "p 1"), "E-COUNT", "end", "fewer isolated vertices than announced")
    folded = m.folded().text().split("\n")
    second = [i for i, line in enumerate(folded) if line.startswith("f ")][1]
    m.malformed("isolated-more-inside", "\n".join(folded[:second] + ["3"] + folded[second:]), "E-COUNT", second + 1, "more isolated vertices of the first facet than announced")
    insert("isolated-more", "E-COUNT", "end", "3", "more isolated vertices than announced")
    change("segment-descending", "E-ORDER", "s 0 1", "s 1 0", "a segment with its vertices in the wrong order")
    change("segment-point", "E-ORDER", "s 0 1", "s 0 0", "a segment from a vertex to itself")
    change("segments-unsorted", "E-ORDER", "s 0 2", "s 0 1", "a segment twice")
    change("segments-swapped", "E-ORDER", "s 1 2", "s 0 1", "segments that are not sorted")
    change("boundary-unsorted", "E-ORDER", "1 2", "0 1", "a boundary edge twice")
    inner = m.planar(m.SLIT, [0, 1, 2, 3], inner=[(4, 5)])
    m.malformed("constraint-descending", m.edited(inner, "4 5", "5 4"), "E-ORDER", "5 4", "an inner constraint with its vertices in the wrong order")
    m.malformed("constraint-point", m.edited(inner, "4 5", "4 4"), "E-ORDER", "4 4", "an inner constraint from a vertex to itself")
    m.malformed("constraint-twice", m.edited(inner, "c 1", ["c 2", "4 5"]), "E-ORDER", ("4 5", 2), "an inner constraint twice")
    single = m.planar(m.SLIT, [0, 1, 2, 3], isolated=[4, 5])
    m.malformed("isolated-unsorted", m.edited(single, "5", "4"), "E-ORDER", ("4", 2), "isolated vertices that are not sorted")
    two = m.square(dim=2)
    m.malformed("dim2-two-facets", m.edited(two, "facets 1", "facets 2"), "E-VALUE", "facets 2", "two facets in dimension 2")
    change("end-missing", syntax, "end", "claims 1", "the complex does not end")
    # 3
    m.malformed("claims-fewer", text.replace("claims 1", "claims 2"), "E-COUNT", "notes 1", "fewer claims than announced")
    change("claims-none", "E-VALUE", "claims 1", "claims 0", "no claims")
    change("claim-unknown", syntax, "claim conforms", "claim L24 1", "an unknown claim")
    change("claim-missing", "E-COUNT", "claim conforms", "notes 1", "no claim")
    change("note-key", syntax, "n strategy by hand", "n Strategy by hand", "an upper-case key")
    change("note-without-text", syntax, "n strategy by hand", "n strategy", "a note without text")
    m.malformed("notes-fewer", text.replace("notes 1", "notes 2"), "E-COUNT", "parameters 0", "fewer notes than announced")
    m.malformed("notes-more", text.replace("notes 1", "notes 0"), "E-COUNT", "n strategy by hand", "more notes than announced")
    change("parameters", syntax, "parameters 0", "parameters 1", "parameters without a claim that has any")
    change("point-kind", syntax, "q edge 3 1 1 7 1", "q corner 3 1 1 7 1", "an unknown kind of point")
    m.malformed("points-fewer", text.replace("points 2", "points 3"), "E-COUNT", "cells 3", "fewer points than announced")
    m.malformed("points-more", text.replace("points 2", "points 1"), "E-COUNT", "q edge 3 1 1 7 1", "more points than announced")
    change("cell-kind", syntax, "t 0 0 1 5 C", "t 0 0 1 5 D", "an unknown kind of cell")
    change("cell-short", syntax, "t 0 0 1 5 C", "t 0 0 1 5", "a cell without a kind")
    change("cell-box-without-kind", syntax, "t 0 0 1 5 C", "t 0 0 1 5 C 0", "a box number at a cell that is no half of a rectangle")
    change("cell-without-box", syntax, "t 0 0 1 5 C", "t 0 0 1 5 R", "half of a rectangle without a box number")
    change("cell-offset-for-box", syntax, "t 0 0 1 5 C", "t 0 0 1 5 R 1/2", "half of a rectangle with an offset and no box number")
    change("box-first", "E-ORDER", "t 0 0 1 5 C", "t 0 0 1 5 R 1", "the first box is not 0")
    m.malformed("box-once", text.replace("t 0 0 1 5 C", "t 0 0 1 5 R 0"), "E-ORDER", "t 0 1 2 5 C", "a box number on one line only")
    m.malformed("box-once-at-end", text.replace(cell, "t 0 2 0 5 R 0"), "E-ORDER", "rows 0", "a box number on the last line only")
    thrice = text.replace("t 0 0 1 5 C", "t 0 0 1 5 R 0").replace("t 0 1 2 5 C", "t 0 1 2 5 R 0").replace(cell, "t 0 2 0 5 R 0")
    m.malformed("box-thrice", thrice, "E-ORDER", "t 0 2 0 5 R 0", "a box number on three lines")
    m.malformed("cells-fewer", text.replace("cells 3", "cells 4"), "E-COUNT", "rows 0", "fewer cells than announced")
    m.malformed("cells-more", text.replace("cells 3", "cells 2"), "E-COUNT", cell, "more cells than announced")
    rows = m.rows_and_boxes()
    m.malformed("row-side", m.edited(rows, "r 0 3 0 +", "r 0 3 0 *"), syntax, "r 0 3 0 *", "a side that is neither + nor -")
    m.malformed("row-half", m.edited(rows, "r 0 3 0 +", "r 0 3 0"), syntax, "r 0 3 0", "a facet without a side")
    m.malformed("row-one", m.edited(rows, "r 0 3", "r 0 1"), "E-VALUE", "r 0 1", "a row of one point")
    m.malformed("row-point", m.edited(rows, "7", "10"), "E-RANGE", "10", "a row with a point that does not exist")
    m.malformed("row-facet", m.edited(rows, "r 0 3 0 +", "r 0 3 1 +"), "E-RANGE", "r 0 3 1 +", "a row of a facet that does not exist")
    m.malformed("row-segment", m.edited(rows, "r 0 3", "r 4 3"), "E-RANGE", "r 4 3", "a row of a segment that does not exist")
    m.malformed("row-points-fewer", m.edited(rows, "r 0 3", "r 0 4"), "E-COUNT", "r 0 3 0 +", "a row with fewer points than announced")
    m.malformed("row-points-more", m.edited(rows, "r 0 3", "r 0 2"), "E-COUNT", "6", "a row with more points than announced")
    m.malformed("rows-fewer", m.edited(rows, "rows 2", "rows 3"), "E-COUNT", "hanging 0", "fewer rows than announced")
    m.malformed("rows-more", m.edited(rows, "rows 2", "rows 1"), "E-COUNT", "r 0 3 0 +", "more rows than announced")
    rows.rows.reverse()
    m.malformed("rows-unsorted", rows.text(), "E-ORDER", "r 0 3", "a protector before the row of its segment")
    rows.rows = [rows.rows[1], rows.rows[1]]
    m.malformed("rows-twice", rows.text(), "E-ORDER", ("r 0 3", 2), "a row twice")
    rows.rows = [rows.rows[0], ("0 3 0 -", [7, 8, 9]), ("0 3 0 +", [7, 8, 9])]
    m.malformed("rows-sides", rows.text(), "E-ORDER", "r 0 3 0 +", "side - before side +")
    m.malformed("hanging-fewer", text.replace("hanging 2", "hanging 3"), "E-COUNT", "evidence 0", "fewer subsegments than announced")
    m.malformed("hanging-more", text.replace("hanging 2", "hanging 1"), "E-COUNT", "h 3 6 4", "more subsegments than announced")
    change("hanging-unsorted", "E-ORDER", "h 3 6 4", "h 2 6 4", "subsegments of decreasing segments")
    change("evidence", syntax, "evidence 0", "evidence 1", "evidence without a claim that has any")
    fields = last.split(" ")
    for position, name in enumerate(["vertices", "segments", "facets", "points", "cells", "rows", "hanging"], 1):
        other = fields[:position] + [str(int(fields[position]) + 1)] + fields[position + 1:]
        change("end-" + name, "E-COUNT", last, " ".join(other), "the count of %s at the end differs" % name)
    change("digest-upper-case", syntax, last, last[:-64] + last[-64:].upper(), "a digest in upper case")
    change("digest-short", syntax, last, last[:-1], "a digest of 63 digits")
    change("digest-missing", syntax, last, last[:-65], "no digest")
    change("digest-twice", syntax, last, last + " " + last[-64:], "two digests")
    # truncation
    m.malformed("empty", "", "E-TRUNCATED", 1, "an empty file")
    for name, size in [("first-word", 5), ("first-line", len(m.FIRST_LINE) + 1), ("vertices", text.index("v 0 4")), ("within-integer", text.index("v 0 4") + 3),
                       ("facet", text.index("1 2\n2 0")), ("points", text.index("q edge")), ("cells", text.index("t 0 1 2")), ("within-cell", text.index("t 0 1 2") + 6),
                       ("hanging", text.index("h 3 6 4")), ("end", text.index(last)), ("within-digest", len(text) - 20)]:
        m.malformed("truncated-" + name, text[:size], "E-TRUNCATED", text[:size].count("\n") + 1, "cut after %d bytes" % size)
    m.malformed("huge-count", text.replace("vertices 5", "vertices 2147483647"), "E-COUNT", "segments 4", "a count that would need 100 GB if it were believed")
    m.malformed("huge-cells", text.replace("cells 3", "cells 2147483647"), "E-COUNT", "rows 0", "the same for cells")


def write_malformed_claims(m, base, everything):
    """One change each to a certificate with claims; base: an Assembly, everything: the parameters of all claims."""
    def case(name, code, line, reason, change, claims=("L1", "L8"), parameters=everything):
        c = base.certificate(m, claims, parameters)
        change(c)
        m.malformed("claims-" + name, c.text(), code, line, reason)

    def put(part, place, line):
        return lambda c: getattr(c, part).__setitem__(place, line)

    def more(part, *lines):
        return lambda c: getattr(c, part).extend(lines)
    # the records of claims
    l1, l8 = base.certificate(m, ["L1", "L8"]).claims[1:]
    case("order", "E-ORDER", l1, "claims out of order", lambda c: c.claims.__setitem__(slice(1, 3), [l8, l1]))
    case("twice", "E-ORDER", (l8, 2), "a claim twice", more("claims", l8))
    case("conforms-twice", "E-ORDER", ("claim conforms", 2), "`conforms` twice", more("claims", "claim conforms"))
    case("conforms-missing", "E-ORDER", l1, "claims without `conforms`", lambda c: c.claims.pop(0))
    case("refutes", "E-ORDER", "refutes L9", "a refutation after `conforms`", more("claims", "refutes L9"))
    case("unknown", "E-SYNTAX", "claim L0a 1", "a lemma without a claim", more("claims", "claim L0a 1"))
    case("case", "E-SYNTAX", "claim l9 1", "a lemma in lower case", more("claims", "claim l9 1"))
    case("without-count", "E-SYNTAX", "claim L9", "a claim without its count", more("claims", "claim L9"))
    case("field", "E-SYNTAX", "claim L9 8 8", "a claim with a field too many", more("claims", "claim L9 8 8"))
    case("count-zero", "E-SYNTAX", "claim L9 08", "a count with a leading zero", more("claims", "claim L9 08"))
    text = base.certificate(m, ["L1", "L8"], everything).text()
    m.malformed("claims-more", text.replace("claims 3", "claims 2"), "E-COUNT", l8, "more claims than announced")
    m.malformed("claims-less", text.replace("claims 3", "claims 4"), "E-COUNT", "notes 0", "fewer claims than announced")
    # the parameters
    names = [line.split()[0] for line in everything]
    h, factor = names.index("h"), names.index("angle")
    for name, line in (("zero", "h 0/1"), ("negative", "h -1/3"), ("terms", "h 2/6"), ("denominator", "h 1/0")):
        case("h-" + name, "E-VALUE", line, "a spacing of " + line[2:], put("parameters", h, line))
    for name, line in (("integer", "h 1"), ("missing", "h"), ("more", "h 1/3 1"), ("decimal", "h 0.3")):
        case("h-" + name, "E-SYNTAX", line, "no rational", put("parameters", h, line))
    for name, line in (("zero", "angle 0 1/2"), ("large", "angle 65 1/2"), ("one", "angle 2 1/1"), ("beyond", "angle 2 3/2"), ("right", "angle 2 0/1"), ("obtuse", "angle 2 -1/2")):
        case("angle-" + name, "E-VALUE", line, "an angle out of range", put("parameters", factor, line))
    case("beta-zero", "E-VALUE", "beta 0", "a factor of zero", put("parameters", names.index("beta"), "beta 0"))
    case("chord-rational", "E-SYNTAX", "chord 1/2", "a factor that is no index", put("parameters", names.index("chord"), "chord 1/2"))
    case("parameter-unknown", "E-SYNTAX", "delta 1/2", "an unknown parameter", put("parameters", 0, "delta 1/2"))
    case("parameter-order", "E-ORDER", everything[0], "parameters out of order", lambda c: c.parameters.__setitem__(slice(0, 2), everything[1::-1]))
    case("parameter-twice", "E-ORDER", ("r 1/1", 2), "a parameter twice", lambda c: c.parameters.insert(0, "r 1/1"))
    case("r-max-twice", "E-ORDER", (everything[-1], 2), "a parameter twice", more("parameters", everything[-1]))
    case("beta-offset", "E-ORDER", "offset 1", "beta and offset", lambda c: c.parameters.insert(names.index("beta") + 1, "offset 1"))
    case("ball-global", "E-ORDER", "ball 0 1/1", "a ball besides r", more("parameters", "ball 0 1/1"))
    case("row-global", "E-ORDER", "row 0 1/1 1/2 1/2 1/2 1/2", "a row besides r", more("parameters", "row 0 1/1 1/2 1/2 1/2 1/2"))
    m.malformed("claims-parameters-less", text.replace("parameters %d" % len(everything), "parameters %d" % (len(everything) + 1)), "E-COUNT", "points 45", "fewer parameters than announced")
    m.malformed("claims-parameters-more", text.replace("parameters %d" % len(everything), "parameters %d" % (len(everything) - 1)), "E-COUNT", everything[-1], "more parameters than announced")

    def local(name, code, lines, reason):
        case("local-" + name, code, lines[-1], reason, lambda c: None, parameters=lines)
    local("vertex", "E-RANGE", ["ball 4 1/1"], "a ball of a vertex that does not exist")
    local("order", "E-ORDER", ["ball 1 1/1", "ball 0 1/1"], "balls out of order")
    local("zero", "E-VALUE", ["ball 1 0/1"], "a ball of radius zero")
    local("segment", "E-RANGE", ["row 4 1/1 1/2 1/2 1/2 1/2"], "a row of a segment that does not exist")
    local("row-order", "E-ORDER", ["row 1 1/2 1/2 1/2 1/2 1/2", "row 1 1/1 1/2 1/2 1/2 1/2"], "a row twice")
    local("row-ball", "E-ORDER", ["row 1 1/1 1/2 1/2 1/2 1/2", "ball 1 1/1"], "a ball after a row")
    local("row-one", "E-VALUE", ["row 1 1/1 1/2 1/2 1/1 1/2"], "a cosine of one")
    local("row-short", "E-SYNTAX", ["row 1 1/1 1/2 1/2 1/2"], "a row without its last cosine")
    local("row-long", "E-SYNTAX", ["row 1 1/1 1/2 1/2 1/2 1/2 1/2"], "a row with a cosine too many")
    # the evidence
    evidence = base.certificate(m, ["L8"]).evidence
    case("evidence-unclaimed", "E-SYNTAX", evidence[0], "evidence for a claim that is not made", lambda c: c.evidence.append(evidence[0]), claims=("L1",))
    case("evidence-refutation", "E-SYNTAX", "x 0 1 1/2", "evidence of a refutation", put("evidence", 0, "x 0 1 1/2"))
    words = evidence[0].split()
    for place, name in ((1, "facet"), (2, "point"), (5, "inserted")):
        line = " ".join(words[:place] + ["77"] + words[place + 1:])
        case("evidence-" + name, "E-RANGE", line, "evidence with a number that does not exist", put("evidence", 0, line))
    for line, name in ((" ".join(words[:5]), "short"), (evidence[0] + " 1", "long")):
        case("evidence-" + name, "E-SYNTAX", line, "evidence with another number of fields", put("evidence", 0, line))
    m.malformed("claims-evidence-less", text.replace("evidence %d" % len(evidence), "evidence %d" % (len(evidence) + 1)), "E-COUNT", text.split("\n")[-2], "less evidence than announced")
    m.malformed("claims-evidence-more", text.replace("evidence %d" % len(evidence), "evidence %d" % (len(evidence) - 1)), "E-COUNT", evidence[-1], "more evidence than announced")
