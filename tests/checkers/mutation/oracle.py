# SPDX-License-Identifier: Apache-2.0
"""Certificates read and judged once more, slowly: docs/certificate-format.md section 5 in rational numbers, by brute force. For texts that
a checker has accepted: spelling and order are not looked at."""
from fractions import Fraction as Q
from itertools import product


def read(text):
    lines = [line.split(" ") for line in text.split("\n")]
    c = {"vertices": [], "segments": [], "facets": [], "points": [], "cells": [], "rows": [], "hanging": []}
    place = 0

    def number(word):
        return int(word, 16)

    def point(words):
        *x, w = map(number, words)
        return tuple(Q(v, w) for v in x) + ((Q(0),) if len(x) == 2 else ())

    facet, section = None, None
    while place < len(lines):
        words = lines[place]
        place += 1
        if words[0] == "v":
            c["vertices"].append(point(words[1:]))
        elif words[0] == "s":
            c["segments"].append((int(words[1]), int(words[2])))
        elif words[0] == "f":
            facet = {"corners": tuple(map(int, words[1:])), "b": [], "c": [], "p": []}
            c["facets"].append(facet)
        elif words[0] in ("b", "c", "p") and facet is not None and words[1].isdigit():
            section = words[0]
            for _ in range(int(words[1])):
                facet[section].append(tuple(map(int, lines[place])))
                place += 1
        elif words[0] == "q":
            c["points"].append((words[1], int(words[2]), point(words[3:])))
        elif words[0] == "t":
            offset = [w for w in words if "/" in w]
            value = Q(number(offset[0].split("/")[0]), number(offset[0].split("/")[1])) if offset else Q(0)
            box = int(words[6]) if words[5] == "R" else None
            c["cells"].append((int(words[1]), tuple(map(int, words[2:5])), box, value))
        elif words[0] == "h":
            c["hanging"].append(tuple(map(int, words[1:])))
        elif words[0] == "r":
            count = int(words[2])
            c["rows"].append((int(words[1]), tuple(words[3:]), [int(lines[place + i][0]) for i in range(count)]))
            place += count
    return c


def sub(a, b):
    return tuple(x - y for x, y in zip(a, b))


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def fault(text):
    """What is wrong with the certificate, or None."""
    c = read(text)
    at = c["vertices"] + [p for _, _, p in c["points"]]
    n = len(c["vertices"])
    if len(set(at)) != len(at):
        return "distinct"
    on_segment = [set(s) for s in c["segments"]]
    for i, (kind, carrier, p) in enumerate(c["points"]):
        if kind in ("projection", "edge"):
            a, b = (at[v] for v in c["segments"][carrier])
            if any(cross(sub(b, a), sub(p, a))) or not 0 < dot(sub(p, a), sub(b, a)) < dot(sub(b, a), sub(b, a)):
                return "carrier"
            on_segment[carrier].add(n + i)

    def chain(a, b):
        """The points of the segment between its vertices a and b, in order, both included."""
        s = c["segments"].index((min(a, b), max(a, b)))
        return sorted(on_segment[s], key=lambda x: dot(sub(at[x], at[a]), sub(at[b], at[a])))

    for number, facet in enumerate(c["facets"]):
        found = facet_fault(c, number, facet, at, n, chain)
        if found:
            return found
    facet_edges = {(min(a, b), max(a, b)) for f in c["facets"] for a, b in f["b"] + f["c"]}
    wanted = []
    for s, (a, b) in enumerate(c["segments"]):
        if (a, b) not in facet_edges:
            ordered = chain(a, b)
            wanted += [(s, x, y) for x, y in zip(ordered, ordered[1:])]
    if wanted != c["hanging"]:
        return "hanging"
    for _, a, b in wanted:
        if any(dot(sub(p, at[a]), sub(p, at[b])) <= 0 for x, p in enumerate(at) if x not in (a, b)):
            return "hanging"
    return rows_fault(c, at, n, chain)


def facet_fault(c, number, facet, at, n, chain):
    i, j, k = (at[v] for v in facet["corners"])
    normal = cross(sub(j, i), sub(k, i))
    if not any(normal):
        return "complex"
    inside = {v for e in facet["b"] + facet["c"] + facet["p"] for v in e}
    if any(dot(normal, sub(at[v], i)) for v in inside):
        return "complex"
    own = set(inside)
    for a, b in facet["b"] + facet["c"]:
        own.update(chain(a, b))
    carried = {n + x for x, (kind, carrier, _) in enumerate(c["points"]) if kind not in ("projection", "edge") and carrier == number}
    own |= carried
    if any(dot(normal, sub(at[v], i)) for v in carried):
        return "carrier"
    cells = [(corners, box, offset) for f, corners, box, offset in c["cells"] if f == number]
    if not cells or not carried <= {v for corners, _, _ in cells for v in corners}:
        return "tiling" if not cells else "carrier"
    edges = []
    for corners, box, offset in cells:
        if not set(corners) <= own or dot(normal, cross(sub(at[corners[1]], at[corners[0]]), sub(at[corners[2]], at[corners[0]]))) <= 0:
            return "cell"
        edges += [(corners[x], corners[(x + 1) % 3]) for x in range(3)]
    if len(set(edges)) != len(edges):
        return "tiling"
    left = sorted(e for e in edges if (e[1], e[0]) not in edges)
    boundary = []
    for a, b in facet["b"]:
        ordered = chain(a, b)
        boundary += list(zip(ordered, ordered[1:]))
    if left != sorted(boundary):
        return "tiling"
    constraints = set()
    for a, b in facet["c"] + facet["b"]:
        ordered = chain(a, b)
        constraints |= {frozenset(e) for e in zip(ordered, ordered[1:])}
    if not {frozenset(e) for a, b in facet["c"] for e in zip(chain(a, b), chain(a, b)[1:])} <= {frozenset(e) for e in edges}:
        return "tiling"
    if not {v for (v,) in facet["p"]} <= {v for e in edges for v in e}:
        return "tiling"
    for corners, box, offset in cells:
        a, b, d = (at[v] for v in corners)
        u, w = sub(b, a), sub(d, a)
        uu, ww, uw = dot(u, u), dot(w, w), dot(u, w)
        det = 2 * (uu * ww - uw * uw)
        s, t = Q(ww * (uu - uw)) / det, Q(uu * (ww - uw)) / det
        centre = tuple(a[x] + s * u[x] + t * w[x] + offset * normal[x] for x in range(3))
        radius = dot(sub(a, centre), sub(a, centre))
        for x, p in enumerate(at):
            power, height = dot(sub(p, centre), sub(p, centre)) - radius, dot(normal, sub(p, i))
            if power < 0 or (power == 0 and height != 0):
                return "emptiness"
            if power == 0 and x not in corners:
                for y in range(3):
                    e, f = corners[y], corners[(y + 1) % 3]
                    if any({e, f} <= set(chain(*ends)) for ends in facet["b"] + facet["c"]) and dot(normal, cross(sub(at[f], at[e]), sub(p, at[e]))) < 0:
                        return "tie"
    boxes = {}
    for corners, box, _ in cells:
        if box is not None:
            boxes.setdefault(box, []).append(corners)
    for pair in boxes.values():
        if len(pair) != 2:
            return "box"
        shared = [(x, y) for x, y in product(range(3), repeat=2) if pair[0][x] == pair[1][(y + 1) % 3] and pair[0][(x + 1) % 3] == pair[1][y]]
        if len(shared) != 1 or len(set(pair[0]) & set(pair[1])) != 2:
            return "box"
        x, y = shared[0]
        p1, p3, p0, p2 = pair[0][x], pair[0][(x + 1) % 3], pair[0][(x + 2) % 3], pair[1][(y + 2) % 3]
        if sub(at[p1], at[p0]) != sub(at[p2], at[p3]) or dot(sub(at[p1], at[p0]), sub(at[p3], at[p0])) != 0:
            return "box"
    return None


def rows_fault(c, at, n, chain):
    own = {}
    for segment, rest, members in c["rows"]:
        a, b = c["segments"][segment]
        if not rest:
            if members != chain(a, b)[1:-1]:
                return "rows"
            own[segment] = members
            continue
        if segment not in own or len(members) != len(own[segment]):
            return "rows"
        number, side = int(rest[0]), rest[1]
        facet = c["facets"][number]
        i, j, k = (at[v] for v in facet["corners"])
        normal = cross(sub(j, i), sub(k, i))
        if any(q < n or c["points"][q - n][0] != "offset" or c["points"][q - n][1] != number for q in members):
            return "rows"
        offsets = {sub(at[q], at[x]) for q, x in zip(members, own[segment])}
        if len(offsets) != 1:
            return "rows"
        o, = offsets
        along = sub(at[b], at[a])
        left = dot(normal, cross(along, o))
        if not any(o) or dot(o, along) != 0 or left == 0 or (left > 0) != (side == "+"):
            return "rows"
        allowed = {"+", "-"} if (a, b) in facet["c"] else ({"+"} if (a, b) in facet["b"] else set()) | ({"-"} if (b, a) in facet["b"] else set())
        if side not in allowed:
            return "rows"
    return None
