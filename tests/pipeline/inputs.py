# SPDX-License-Identifier: GPL-3.0-or-later
"""The inputs of the pipeline's tests: examples/, and families that are generated here, with the numbers of points of
docs' table (the graded strategy's prototype, vertices included) where it has one."""
import math
import os

HEIGHT = math.sqrt(0.75)

# File in examples/ -> points expected (None: no figure to compare with).
EXAMPLES = {
    "w2.smesh": None,
    "w3.smesh": 3705,
    "w3-prime.smesh": None,
    "g3.smesh": 156,
    "cube.off": 80,
    "cube-triangles.off": 116,
    "tetrahedron.off": 40,
    "fan.off": 59,
    "fan-skew.off": 59,
    "wedge-30.off": None,
    "triangle-20.off": None,
    "hanging-edge.obj": None,
    "facet-parts.poly": None,
    "corner-45.poly": None,
    "courtyard.poly": None,
    "star-1.poly": None,
    "well.poly": None,
    "flagpole.obj": None,
    "house.poly": None,
}

# Degrees, abscissa of the second triangle's apex (0.5: the mirror image of the first) -> points expected.
WEDGES = {
    (5, 0.5): 26,
    (40, 0.3): 26,
    (20, 0.3): 95,
    (10, 0.3): 262,
    (5, 0.3): 892,
    (2.5, 0.3): 3161,
    (1, 0.3): None,
}

ALLOWANCE = 1.3  # points against the table


def off(vertices, faces):
    lines = ["OFF", "%d %d 0" % (len(vertices), len(faces))]
    lines += [" ".join(repr(float(x)) for x in vertex) for vertex in vertices]
    lines += [" ".join(map(str, [len(face), *face])) for face in faces]
    return "\n".join(lines) + "\n"


def wedge(degrees, abscissa):
    """Two triangles that share an edge."""
    angle = math.radians(degrees)
    apex = (abscissa, HEIGHT * math.cos(angle), HEIGHT * math.sin(angle))
    return off([(0, 0, 0), (1, 0, 0), (0.5, HEIGHT, 0), apex], [(0, 1, 2), (0, 1, 3)])


def close_hanging_edge(height):
    """.obj: a triangle, and an edge in no facet that hovers over it."""
    vertices = [(0, 0, 0), (6, 0, 0), (0, 6, 0), (1, 1, height), (3, 2, 1.5 * height)]
    return "".join("v %r %r %r\n" % tuple(map(float, v)) for v in vertices) + "f 1 2 3\nl 4 5\n"


def two_coplanar_squares():
    """Neighbours in one plane, and one more square across their common edge."""
    vertices = [(0, 0, 0), (1, 0, 0), (2, 0, 0), (2, 1, 0), (1, 1, 0), (0, 1, 0), (1, 0, 1), (1, 1, 1)]
    return off(vertices, [(0, 1, 4, 5), (1, 2, 3, 4), (1, 4, 7, 6)])


def write_all(folder, examples):
    """Writes or names every input; returns (name, path, expected points or None)."""
    inputs = [(name, os.path.join(examples, name), expected) for name, expected in EXAMPLES.items()]

    def add(name, text, expected=None):
        path = os.path.join(folder, name)
        with open(path, "w") as file:
            file.write(text)
        inputs.append((name, path, expected))

    for (degrees, abscissa), expected in WEDGES.items():
        add("wedge-%g-%g.off" % (degrees, abscissa), wedge(degrees, abscissa), expected)
    for exponent in (1, 4, 8):
        add("hanging-%d.obj" % exponent, close_hanging_edge(2.0 ** -exponent))
    add("two-squares.off", two_coplanar_squares())
    return inputs
