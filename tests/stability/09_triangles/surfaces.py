"""Flat surfaces of random triangles, in STL. SPDX-License-Identifier: GPL-3.0-or-later"""
import math
import random


def write(path, triangles):
    with open(path, "w") as file:
        file.write("solid surface\n")
        for corners in triangles:
            file.write("facet normal 0 0 0\nouter loop\n" +
                "".join("vertex %.17g %.17g %.17g\n" % tuple(x) for x in corners) +
                "endloop\nendfacet\n")
        file.write("endsolid\n")


def aspect(t):
    sides = [math.dist(t[k], t[k - 1]) for k in range(3)]
    u, v = [b - a for a, b in zip(t[0], t[1])], [b - a for a, b in zip(t[0], t[2])]
    area = 0.5*math.dist((0, 0, 0), (u[1]*v[2] - u[2]*v[1], u[2]*v[0] - u[0]*v[2],
                                     u[0]*v[1] - u[1]*v[0]))
    return max(sides)**2/(2.0*area) if area > 0.0 else math.inf


def flat(low, high, seed, most=400):
    """A rectangle in z = 0, triangle by triangle divided at random points into three, none above
    aspect 100."""
    draw = random.Random(seed)
    (a, b), (c, d) = low, high
    all_of = [((a, b, 0), (c, b, 0), (c, d, 0)), ((a, b, 0), (c, d, 0), (a, d, 0))]
    for _ in range(100000):
        if len(all_of) >= most:
            break
        k = draw.randrange(len(all_of))
        t = all_of[k]
        s, u = draw.random(), draw.random()
        s, u = (1.0 - s, 1.0 - u) if s + u > 1.0 else (s, u)
        p = tuple(x + s*(y - x) + u*(z - x) for x, y, z in zip(*t))
        parts = [(t[0], t[1], p), (t[1], t[2], p), (t[2], t[0], p)]
        if max(map(aspect, parts)) < 100.0 and min(math.dist(q[k], q[k - 1]) for q in parts
                for k in range(3)) > 2e-4:
            all_of[k:k + 1] = parts
    return all_of
