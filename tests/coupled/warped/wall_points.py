#!/usr/bin/env python3
"""wall_points.py -- positions along every wall face of a mesh, inside it: rows x,y,z of a table for `insert`.

    wall_points.py SURFACE.obj DEPTH > points.csv

SURFACE is what surfaceMeshExtract writes of all patches: polygons, normals outwards. A warped quadrilateral has two surfaces, one for
each diagonal; both are used. Polygons of more corners are divided around their mean. Points lie DEPTH (m) inside the triangles: the
centroid of each, a point at a third of each edge, and one near each corner. Left out are points that lie on a triangle nearby.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import sys

import numpy as np


def normals(triangles):
    n = np.cross(triangles[:, 1] - triangles[:, 0], triangles[:, 2] - triangles[:, 0])
    return n/np.linalg.norm(n, axis=1)[:, None]


def read(file):
    """The triangles of the polygons."""
    corners, triangles = [], []
    for words in (line.split() for line in open(file)):
        if words[:1] == ['v']:
            corners.append([float(word) for word in words[1:]])
        elif words[:1] == ['f']:
            face = [corners[int(word) - 1] for word in words[1:]]
            if len(face) == 4:
                triangles += [[face[k - 1], face[k], face[k - 3]] for k in range(4)]
            else:
                mean = [sum(c)/len(face) for c in zip(*face)]
                triangles += [[face[k - 1], face[k], mean] for k in range(len(face))]
    return np.array(triangles)


def solid(triangles):
    n = np.cross(triangles[:, 1] - triangles[:, 0], triangles[:, 2] - triangles[:, 0])
    edge = np.linalg.norm(triangles - np.roll(triangles, 1, axis=1), axis=2).max(axis=1)
    return triangles[np.linalg.norm(n, axis=1) > 1e-3*edge**2]


depth = float(sys.argv[2])
triangles = solid(read(sys.argv[1]))
normal = normals(triangles)
weights = np.array([[1, 1, 1], [2, 1, 0.03], [0.03, 2, 1], [1, 0.03, 2], [18, 1, 1], [1, 18, 1], [1, 1, 18]], dtype=float)
weights /= weights.sum(axis=1)[:, None]
points = np.einsum('wc,tcx->twx', weights, triangles) - depth*normal[:, None, :]

at_corner = {}
for t, triangle in enumerate(triangles):
    for corner in triangle:
        at_corner.setdefault(corner.tobytes(), set()).add(t)
chosen = []
for t, triangle in enumerate(triangles):
    others = sorted(set().union(*(at_corner[corner.tobytes()] for corner in triangle)) - {t})
    away = points[t][:, None, :] - triangles[others, 0]
    height = np.einsum('wux,ux->wu', away, normal[others])
    chosen.append(points[t][(abs(height) > 0.5*depth).all(axis=1)])
points = np.concatenate(chosen)
keys = np.unique(np.round(points/depth/10).astype(np.int64), axis=0, return_index=True)[1]
print('x,y,z')
np.savetxt(sys.stdout, points[np.sort(keys)], fmt='%.17g', delimiter=',')
