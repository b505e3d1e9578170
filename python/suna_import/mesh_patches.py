"""mesh_patches.py -- patches of a case's mesh with the corners of their faces.

    patches = read_patches(folder, report)      {"inlet": Patch("inlet", "patch", [n x 3, ...])}

From constant/polyMesh where it is there (without corners if it is binary), else from blockMeshDict
(in system, or as in old cases in constant/polyMesh), whose faces have the corners of the blocks and
the points of arcs. Walls of other codes are compared with them: the same wall must not act twice.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import re
from typing import NamedTuple

import numpy

from .foam_dictionary import Dictionary
from .foam_reader import existing, file_text, read_dictionary
from .report import Place

# of constraint types, on which particles need neither wall nor outlet
COUPLED = ("cyclic", "cyclicAMI", "cyclicACMI", "cyclicSlip", "processor")


class Patch(NamedTuple):
    name: str
    type: str
    faces: list

    @property
    def points(self):
        return numpy.concatenate(self.faces) if self.faces else numpy.empty((0, 3))


def block_mesh_dict(folder):
    for place in ("system", "constant/polyMesh"):
        if existing(folder/place/"blockMeshDict"):
            return f"{place}/blockMeshDict"
    return None


def read_patches(folder, report):
    """None: there is no mesh yet, and no blockMeshDict."""
    if existing(folder/"constant/polyMesh/boundary"):
        return from_poly_mesh(folder, report)
    name = block_mesh_dict(folder)
    if name is None:
        return None
    return from_block_mesh(read_dictionary(folder/name, name, report))


# ---- blockMeshDict -------------------------------------------------------------------------------

def from_block_mesh(d):
    scale = d.number("scale", 1.0)*d.number("convertToMeters", 1.0)
    vertices = scale*numpy.array([d.numbers("vertices", v, 3, "vector")
                                  for v in d.list("vertices") if isinstance(v, list)])
    arcs = {}
    edges = d.list("edges", [])
    for i, word in enumerate(edges):
        if word == "arc" and len(edges) > i + 3 and isinstance(edges[i + 3], list):
            ends = d.indices("edges", edges[i + 1:i + 3], len(vertices))
            arcs[frozenset(ends)] = \
                scale*numpy.array(d.numbers("edges", edges[i + 3], 3, "vector"))

    def corners(face):
        face = d.indices("vertices", face, len(vertices))
        if len(face) < 3:
            d.report.refuse(d.place, "faces", "a face has three points or more")
        points = [vertices[i] for i in face]
        for i, j in zip(face, [*face[1:], face[0]]):
            if frozenset((i, j)) in arcs:
                points.append(arcs[frozenset((i, j))])
        return numpy.array(points)

    patches = {}
    if "patches" in d:              # TYPE NAME ( faces )
        tokens = d.list("patches")
        for kind, name, faces in zip(tokens[::3], tokens[1::3], tokens[2::3]):
            if not isinstance(faces, list):
                d.report.refuse(d.where("patches"), "patches", "are not TYPE NAME ( faces ) each")
            patches[str(name)] = Patch(str(name), str(kind), [corners(face) for face in faces])
    tokens = d.list("boundary", [])
    for name, inner in zip(tokens, tokens[1:]):
        if isinstance(inner, Dictionary):
            patches[str(name)] = Patch(str(name), inner.word("type"),
                                       [corners(face) for face in inner.list("faces", [])])
    listed = sum(len(patch.faces) for patch in patches.values())
    rest = outer_faces(d, corners, patches) if listed else []
    default = d.sub("defaultPatch")
    if rest:
        name = default.word("name", "defaultFaces")
        patches[name] = Patch(name, default.word("type", "empty"), rest)
    return patches


SIDES = ((0, 4, 7, 3), (1, 2, 6, 5), (0, 1, 5, 4), (3, 7, 6, 2), (0, 3, 2, 1), (4, 5, 6, 7))


def outer_faces(d, corners, patches):
    """Faces of blocks that belong to one block and to no patch."""
    seen = {}
    blocks = d.list("blocks")
    for i, word in enumerate(blocks):
        if word == "hex":
            block = d.numbers("blocks", blocks[i + 1] if len(blocks) > i + 1 else [], 8, "block")
            for side in SIDES:
                face = tuple(block[k] for k in side)
                key = frozenset(face)
                seen[key] = None if key in seen else face
    points = {tuple(sorted(map(tuple, numpy.round(face[:4], 12)))) for patch in patches.values()
              for face in patch.faces}
    rest = [corners(face) for face in seen.values() if face is not None and len(set(face)) > 2]
    return [face for face in rest
            if tuple(sorted(map(tuple, numpy.round(face[:4], 12)))) not in points]


# ---- constant/polyMesh ---------------------------------------------------------------------------

def body(path):
    """Text of a list, without header and count; None: binary."""
    text = file_text(existing(path))
    if re.search(r"format\s+binary", text[:2000]):
        return None
    text = re.sub(r"//[^\n]*|/\*.*?\*/", "", text, flags=re.S)
    return re.sub(r"^.*?FoamFile\s*\{.*?\}\s*\d*\s*\(", "", text, count=1, flags=re.S)


def from_poly_mesh(folder, report):
    try:
        return poly_mesh(folder)
    except (ValueError, KeyError, IndexError) as error:
        report.refuse(Place("constant/polyMesh/boundary"), "mesh", "points, faces and boundary do "
                      f"not fit together ({error}); write the mesh anew")


def poly_mesh(folder):
    mesh = folder/"constant/polyMesh"
    points = faces = None
    if existing(mesh/"points") and existing(mesh/"faces"):
        points, faces = body(mesh/"points"), body(mesh/"faces")
    if points is not None and faces is not None:
        points = numpy.array(re.findall(r"[-+.\deE]+", points), float).reshape(-1, 3)
        faces = [[int(x) for x in face.split()]
                 for face in re.findall(r"\d+\s*\(([^()]*)\)", faces)]
    patches = {}
    boundary = file_text(existing(mesh/"boundary"))
    for name, inner in re.findall(r"([\w.:-]+)\s*\{([^}]*)\}", boundary):
        value = dict(re.findall(r"(\w+)\s+([\w.]+)\s*;", inner))
        if "startFace" in value:
            start, n = int(value["startFace"]), int(value["nFaces"])
            corners = [points[face] for face in faces[start:start + n]] if faces is not None and \
                points is not None else []
            patches[name] = Patch(name, value["type"], corners)
    return patches


# ---- comparing -----------------------------------------------------------------------------------

def size(patches):
    points = numpy.concatenate([patch.points for patch in patches.values()])
    return numpy.linalg.norm(points.max(axis=0) - points.min(axis=0))


def on_plane(patches, point, normal, tolerance):
    """{name: the patch lies in the plane with all its faces} of patches with a face in it."""
    found = {}
    for patch in patches.values():
        flat = [bool((abs((face - point) @ normal) < tolerance).all()) for face in patch.faces]
        if any(flat):
            found[patch.name] = all(flat)
    return found


def range_along(patches, point, normal):
    """Least and largest distance of the corners from the plane, on the side of the normal."""
    distances = [(patch.points - point) @ normal for patch in patches.values() if patch.faces]
    return min(x.min() for x in distances), max(x.max() for x in distances)


def farthest_from(patches, point, axis):
    """Largest distance of the corners from the axis."""
    return max(numpy.linalg.norm(numpy.cross(patch.points - point, axis), axis=1).max()
               for patch in patches.values() if patch.faces)
