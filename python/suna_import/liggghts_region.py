"""liggghts_region.py -- regions of LIGGGHTS: shapes for insertion, points inside, volume.

The scene inserts in boxes, cylinders and spheres. The others (cone, prism, union, intersect,
tetrahedra) need only `contains`: a packing in one of them is placed by the importer
(liggghts_insertion.py).

SPDX-License-Identifier: GPL-3.0-or-later
"""
import math

import numpy

from .scene_text import text, vector

AXES = {"x": 0, "y": 1, "z": 2}
SAMPLES = 200000        # of the volume of a shape without a formula


class Region:
    """`numbers`: of the style, in SI; `parts`: of union and intersect; `corners`: n x 4 x 3 of
    tetrahedra."""

    def __init__(self, style, numbers, place, axis=None, parts=(), corners=None, outside=False):
        self.style, self.place, self.axis = style, place, axis
        self.numbers = tuple(float(x) for x in numbers)
        self.parts, self.corners, self.outside = parts, corners, outside

    # ---- a cylinder or cone: the two other axes, as in LIGGGHTS --------------------------------

    def _round(self):
        a = AXES[self.axis]
        b, c = ((1, 2), (0, 2), (0, 1))[a]
        return a, b, c

    def bounds(self):
        """Corners of the box around it; for `side out`, all space."""
        n = self.numbers
        if self.outside:
            return numpy.full(3, -math.inf), numpy.full(3, math.inf)
        if self.style == "block":
            return numpy.array(n[0::2]), numpy.array(n[1::2])
        if self.style == "prism":
            low, high = numpy.array(n[0:6:2]), numpy.array(n[1:6:2])
            for k, (to, _) in enumerate(((0, 1), (0, 2), (1, 2))):
                low[to] += min(0.0, n[6 + k])
                high[to] += max(0.0, n[6 + k])
            return low, high
        if self.style == "sphere":
            centre = numpy.array(n[:3])
            return centre - n[3], centre + n[3]
        if self.style in ("cylinder", "cone"):
            a, b, c = self._round()
            radius = n[2] if self.style == "cylinder" else max(n[2], n[3])
            low, high = numpy.empty(3), numpy.empty(3)
            low[[a, b, c]] = n[-2], n[0] - radius, n[1] - radius
            high[[a, b, c]] = n[-1], n[0] + radius, n[1] + radius
            return low, high
        if self.style == "mesh/tet":
            return self.corners.min(axis=(0, 1)), self.corners.max(axis=(0, 1))
        if self.style == "plane":
            return numpy.full(3, -math.inf), numpy.full(3, math.inf)
        lows, highs = zip(*(part.bounds() for part in self.parts))
        low, high = (numpy.min, numpy.max) if self.style == "union" else (numpy.max, numpy.min)
        return low(lows, axis=0), high(highs, axis=0)

    def contains(self, points):
        """One bool for each of the points, n x 3."""
        inside = self._inside(numpy.asarray(points, float))
        return ~inside if self.outside else inside

    def _inside(self, x):
        n = self.numbers
        if self.style == "block":
            return ((x >= n[0::2]) & (x <= n[1::2])).all(axis=1)
        if self.style == "prism":
            z = x[:, 2] - n[4]
            y = x[:, 1] - n[2] - n[8]*z/(n[5] - n[4])
            w = x[:, 0] - n[0] - n[7]*z/(n[5] - n[4]) - n[6]*y/(n[3] - n[2])
            return (z >= 0) & (z <= n[5] - n[4]) & (y >= 0) & (y <= n[3] - n[2]) & (w >= 0) & \
                (w <= n[1] - n[0])
        if self.style == "sphere":
            return ((x - n[:3])**2).sum(axis=1) <= n[3]**2
        if self.style in ("cylinder", "cone"):
            a, b, c = self._round()
            along, low, high = x[:, a], n[-2], n[-1]
            if self.style == "cylinder":
                radius = n[2]
            else:
                radius = n[2] + (n[3] - n[2])*(along - low)/(high - low)
            away = numpy.hypot(x[:, b] - n[0], x[:, c] - n[1])
            return (along >= low) & (along <= high) & (away <= radius)
        if self.style == "plane":
            return (x - n[:3]) @ numpy.array(n[3:]) >= 0
        if self.style == "mesh/tet":
            found = numpy.zeros(len(x), bool)
            for corner in self.corners:
                edges = (corner[1:] - corner[0]).T
                if abs(numpy.linalg.det(edges)) > 0:
                    s = numpy.linalg.solve(edges, (x - corner[0]).T)
                    found |= (s >= 0).all(axis=0) & (s.sum(axis=0) <= 1)
            return found
        each = [part.contains(x) for part in self.parts]
        return numpy.any(each, axis=0) if self.style == "union" else numpy.all(each, axis=0)

    def samples(self, box):
        """Points in it, n x 3, inside this box, if there is one; corners are a hair inside."""
        low, high = self.bounds()
        if box is not None:
            low, high = numpy.maximum(low, numpy.transpose(box)[0]), numpy.minimum(high, numpy.transpose(box)[1])
        if not numpy.isfinite([low, high]).all() or (low > high).any():
            return numpy.empty((0, 3))
        within = numpy.random.default_rng(1).uniform(1e-6, 1 - 1e-6, (5000, 3))
        corners = numpy.stack(numpy.meshgrid(*[[1e-6, 1 - 1e-6]]*3), -1).reshape(-1, 3)
        x = low + (high - low)*numpy.concatenate([within, corners])
        return x[self.contains(x)]

    def is_shape(self):
        """The scene has this shape."""
        return self.style in ("block", "cylinder", "sphere") and not self.outside and \
            numpy.isfinite(self.bounds()).all()

    def volume(self):
        n = self.numbers
        if self.is_shape():
            return {"block": lambda: math.prod(b - a for a, b in zip(n[0::2], n[1::2])),
                    "cylinder": lambda: math.pi*n[2]**2*(n[4] - n[3]),
                    "sphere": lambda: 4/3*math.pi*n[3]**3}[self.style]()
        low, high = self.bounds()
        points = numpy.random.default_rng(1).uniform(low, high, (SAMPLES, 3))
        return float(numpy.prod(high - low)*self.contains(points).mean())

    def extent(self, direction):
        """Length along the direction."""
        low, high = self.bounds()
        return float(numpy.abs(direction) @ (high - low))

    def entries(self, margin=0.0, limits=None):
        """Of a group or stream; the shape grown by a margin [m], within limits (low, high)."""
        n = self.numbers
        least, most = ([-math.inf]*3, [math.inf]*3) if limits is None else limits
        if self.style == "block":
            low, high = self.bounds()
            low, high = numpy.maximum(low - margin, least), numpy.minimum(high + margin, most)
            return f"min {vector(low)}; max {vector(high)};"
        if self.style == "sphere":
            return f"sphere {{ centre {vector(n[:3])}; radius {text(n[3] + margin)}; }}"
        a, b, c = self._round()
        ends = numpy.empty((2, 3))
        ends[:, b], ends[:, c] = n[0], n[1]
        ends[:, a] = max(n[3] - margin, least[a]), min(n[4] + margin, most[a])
        return (f"cylinder {{ from {vector(ends[0])}; to {vector(ends[1])}; "
                f"radius {text(n[2] + margin)}; }}")

    def thickness(self):
        """Of the largest sphere that fits, the diameter."""
        n = self.numbers
        low, high = self.bounds()
        return 2*n[3] if self.style == "sphere" else float((high - low).min())
