"""Positions along every wall face of a mesh, inside it.

A warped quadrilateral has two surfaces, one for each diagonal; both are used. Polygons of more corners are divided
around their mean.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import numpy as np


def read(surface):
    """The triangles of the polygons of a file by surfaceMeshExtract, normals outwards."""
    corners, triangles = [], []
    for words in (line.split() for line in open(surface)):
        if words[:1] == ["v"]:
            corners.append([float(word) for word in words[1:]])
        elif words[:1] == ["f"]:
            face = [corners[int(word) - 1] for word in words[1:]]
            if len(face) == 4:
                triangles += [[face[k - 1], face[k], face[k - 3]] for k in range(4)]
            else:
                mean = [sum(c)/len(face) for c in zip(*face)]
                triangles += [[face[k - 1], face[k], mean] for k in range(len(face))]
    triangles = np.array(triangles)
    area = np.linalg.norm(normals(triangles), axis=1)
    edge = np.linalg.norm(triangles - np.roll(triangles, 1, axis=1), axis=2).max(axis=1)
    return triangles[area > 1e-3*edge**2]


def normals(triangles):
    return np.cross(triangles[:, 1] - triangles[:, 0], triangles[:, 2] - triangles[:, 0])


def wall_points(triangles, depth):
    """Points at this depth [m] inside the triangles: the centroid of each, a point at a third of each edge, and one
    near each corner. Points that lie on a triangle nearby are left out."""
    normal = normals(triangles)
    normal /= np.linalg.norm(normal, axis=1)[:, None]
    weights = np.array([[1, 1, 1], [2, 1, 0.03], [0.03, 2, 1], [1, 0.03, 2], [18, 1, 1], [1, 18, 1], [1, 1, 18]])
    weights /= weights.sum(axis=1)[:, None]
    points = np.einsum("wc,tcx->twx", weights, triangles) - depth*normal[:, None, :]

    at_corner = {}
    for t, triangle in enumerate(triangles):
        for corner in triangle:
            at_corner.setdefault(corner.tobytes(), set()).add(t)
    chosen = []
    for t, triangle in enumerate(triangles):
        others = sorted(set().union(*(at_corner[corner.tobytes()] for corner in triangle)) - {t})
        away = points[t][:, None, :] - triangles[others, 0]
        height = np.einsum("wux,ux->wu", away, normal[others])
        chosen.append(points[t][(abs(height) > 0.5*depth).all(axis=1)])
    points = np.concatenate(chosen)
    first = np.unique(np.round(points/depth/10).astype(np.int64), axis=0, return_index=True)[1]
    return points[np.sort(first)]
