"""liggghts_mesh.py -- triangles and tetrahedra of mesh files: STL (text and binary) and VTK
(legacy, text).

read_triangles, write_stl: n x 3 x 3 corners. Text STL is written with 17 digits, so corners keep
double precision. `rotated` turns points about an axis through an origin.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import struct

import numpy

TRIANGLE, QUAD, TETRAHEDRON = 5, 9, 10      # cell types of VTK


class BadMesh(Exception):
    """The sentence."""


def read_triangles(path):
    with open(path, "rb") as file:
        data = file.read()
    if str(path).lower().endswith(".vtk"):
        points, cells = read_vtk(data)
        triangles = [points[c[:3]] for c in cells if len(c) == 3] + \
            [points[[c[0], c[k], c[k + 1]]] for c in cells if len(c) == 4 for k in (1, 2)]
        found = numpy.array(triangles)
    elif len(data) >= 84 and 84 + 50*struct.unpack("<I", data[80:84])[0] == len(data):
        rows = numpy.frombuffer(data, numpy.dtype(
            [("n", "<f4", 3), ("corners", "<f4", (3, 3)), ("rest", "u2")]), offset=84)
        found = rows["corners"].astype(float)
    else:
        words = data.decode(errors="replace").split()
        at = numpy.array([k for k, word in enumerate(words) if word.lower() == "vertex"], int)
        try:
            found = numpy.array([[float(x) for x in words[k + 1:k + 4]]
                                for k in at]).reshape(-1, 3, 3)
        except ValueError:
            raise BadMesh(
                "its corners are not three numbers each, three of them in a triangle") from None
    if len(found) == 0:
        raise BadMesh("no triangles found")
    return found


def read_vtk(data):
    """Points, and the point numbers of each cell or polygon."""
    words = data.decode(errors="replace").split()
    upper = [word.upper() for word in words]
    if "ASCII" not in upper[:40] or "POINTS" not in upper:
        raise BadMesh("only VTK files of the legacy text format with POINTS are read")
    k = upper.index("POINTS")
    n = int(words[k + 1])
    points = numpy.array(words[k + 3:k + 3 + 3*n], float).reshape(n, 3)
    name = "CELLS" if "CELLS" in upper else "POLYGONS"
    if name not in upper:
        raise BadMesh("neither CELLS nor POLYGONS found")
    k = upper.index(name)
    many, cells, at = int(words[k + 1]), [], k + 3
    for _ in range(many):
        size = int(words[at])
        cells.append([int(word) for word in words[at + 1:at + 1 + size]])
        at += 1 + size
    return points, cells


def read_tetrahedra(path):
    with open(path, "rb") as file:
        points, cells = read_vtk(file.read())
    found = numpy.array([points[c] for c in cells if len(c) == 4])
    if len(found) == 0:
        raise BadMesh("no tetrahedra found")
    return found


def write_stl(path, triangles):
    with open(path, "w") as file:
        file.write("solid wall\n")
        for a, b, c in triangles:
            file.write("facet normal 0 0 0\nouter loop\n")
            for corner in (a, b, c):
                file.write("vertex " + " ".join(repr(float(x)) for x in corner) + "\n")
            file.write("endloop\nendfacet\n")
        file.write("endsolid wall\n")


def rotated(points, origin, axis, angle):
    """By an angle [rad], right-handed."""
    k = numpy.asarray(axis, float)/numpy.linalg.norm(axis)
    x = points - origin
    return origin + x*numpy.cos(angle) + numpy.cross(k, x)*numpy.sin(angle) + \
        (x @ k)[..., None]*k*(1 - numpy.cos(angle))
