"""mesh_surfaces.py -- distances of walls of triangles from the patches of a mesh.

    samples(triangles, spacing)             points inside the triangles, none on their edges
    distance(points, triangles, spacing)    of each point to the nearest triangle
    triangles_of(faces)                     of polygons, around their centre

The nearest triangle is found among those whose centre is nearest (NEAR), so triangles are first cut
into pieces of one size (`refined`).

SPDX-License-Identifier: GPL-3.0-or-later
"""
import numpy
from scipy.spatial import cKDTree

NEAR = 12
PIECES = 200000         # of all triangles together, at most


def triangles_of(faces):
    """Of polygons: n x 3 x 3."""
    found = []
    for face in faces:
        centre, n = face.mean(axis=0), len(face)
        found += [(centre, face[i], face[(i + 1) % n]) for i in range(n)] if n > 3 else [face]
    return numpy.array(found, float).reshape(-1, 3, 3)


def refined(triangles, spacing):
    """Cut into four until no edge is longer than the spacing, or PIECES are reached."""
    x = numpy.asarray(triangles, float)
    while True:
        edges = numpy.linalg.norm(x - numpy.roll(x, 1, axis=1), axis=2).max(axis=1, initial=0.0)
        long = edges > spacing
        if not long.any() or len(x) + 3*long.sum() > PIECES:
            return x
        a, b, c = numpy.moveaxis(x[long], 1, 0)
        ab, bc, ca = (a + b)/2, (b + c)/2, (c + a)/2
        four = ((a, ab, ca), (ab, b, bc), (ca, bc, c), (ab, bc, ca))
        cut = [numpy.stack(corners, axis=1) for corners in four]
        x = numpy.concatenate([x[~long], *cut])


def samples(triangles, spacing):
    return refined(triangles, spacing).mean(axis=1)


def distance(points, triangles, spacing):
    pieces = refined(triangles, spacing)
    near = cKDTree(pieces.mean(axis=1)).query(points, min(NEAR, len(pieces)))[1]
    return numpy.min([to_triangle(points, pieces[column])
                      for column in near.reshape(len(points), -1).T], axis=0)


def to_triangle(p, t):
    """Distance of each point to its own triangle."""
    a, b, c = t[:, 0], t[:, 1], t[:, 2]
    normal = numpy.cross(b - a, c - a)
    size = numpy.linalg.norm(normal, axis=1)
    inside = size > 0
    for u, v in ((a, b), (b, c), (c, a)):
        inside &= (numpy.cross(v - u, p - u)*normal).sum(axis=1) >= 0
    best = numpy.minimum.reduce([to_edge(p, u, v) for u, v in ((a, b), (b, c), (c, a))])
    above = numpy.abs(((p - a)*normal).sum(axis=1))/numpy.where(size > 0, size, 1.0)
    return numpy.where(inside, above, best)


def to_edge(p, u, v):
    along = v - u
    square = (along**2).sum(axis=1)
    s = ((p - u)*along).sum(axis=1)/numpy.where(square > 0, square, 1.0)
    return numpy.linalg.norm(p - u - numpy.clip(s, 0, 1)[:, None]*along, axis=1)
