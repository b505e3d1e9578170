"""liggghts_packing.py -- how many spheres insert/pack of LIGGGHTS places: random sequential
addition that ends after a number of trials.

LIGGGHTS inserts the largest spheres first. It draws a position in the region (with all_in at least
a radius from its surface), drops it where it overlaps with a sphere that is there, or lies nearer
to a face of the box than a radius, and gives up after `maxattempt` trials for each sphere asked
for, all spheres together. The number that it reaches depends on these settings and on the shape
(0.29 to 0.35 of the volume with 50 trials), so it is counted here in the same way, with other
random numbers.

More than MANY spheres are counted as MANY larger ones in the same region: the share of the volume
depends little on the size (0.5 % from 8000 to 1e6).

SPDX-License-Identifier: GPL-3.0-or-later
"""
import numpy
from scipy.spatial import cKDTree

MANY = 8000
BATCH = 4000            # positions that are drawn at once
SAFE = 0.2              # of the volume: no position is hard to find
DIRECTIONS = numpy.array([[x, y, z] for x in (-1, 0, 1) for y in (-1, 0, 1) for z in (-1, 0, 1)
                          if x or y or z], float)
DIRECTIONS /= numpy.linalg.norm(DIRECTIONS, axis=1)[:, None]


def count_placed(numbers, radii, region, all_in, tries, box):
    """Spheres placed of each size, largest first. `tries`: for each one; `box`: low and high
    corners that spheres stay in, or None."""
    larger = max(1.0, sum(numbers)/MANY)
    wanted = [round(n/larger) for n in numbers]
    left, found, placed = sum(wanted)*tries, [], _Placed()
    random = numpy.random.default_rng(1)
    for n, r in zip(wanted, numpy.array(radii)*larger**(1/3)):
        before = len(placed.radii)
        while left > 0 and len(placed.radii) - before < n:
            x = _positions(region, r, all_in, min(BATCH, left), random)
            if len(x) == 0:
                left = 0
                break
            good = numpy.ones(len(x), bool) if box is None else \
                ((x - r >= box[0]) & (x + r <= box[1])).all(axis=1)
            left -= placed.add(x, good, r, n + before)
        found.append(len(placed.radii) - before)
    return [min(n, round(many*larger)) for n, many in zip(numbers, found)]


def _positions(region, r, all_in, many, random):
    """Random ones of a sphere's centre; none if the region is too small for it."""
    low, high = region.bounds()
    if all_in:
        low, high = low + r, high - r
    found, drawn = [], 0
    if not (low < high).all():
        return numpy.empty((0, 3))
    while sum(map(len, found)) < many and drawn < 1000*many:
        x = random.uniform(low, high, (2*many, 3))
        x = x[region.contains(x)]
        if all_in and region.style != "block":
            for direction in DIRECTIONS:
                x = x[region.contains(x + r*direction)]
        found.append(x)
        drawn += 2*many
    return numpy.concatenate(found)[:many]


class _Placed:
    def __init__(self):
        self.x, self.radii = numpy.empty((0, 3)), numpy.empty(0)

    def add(self, x, good, r, limit):
        """Places what fits of x, one after the other, up to a number in all; returns the trials."""
        for size in set(self.radii.tolist()):
            away, _ = cKDTree(self.x[self.radii == size]).query(x)
            good &= away >= r + size
        rows = numpy.flatnonzero(good)
        near = {}
        for a, b in cKDTree(x[rows]).query_pairs(2*r) if len(rows) else ():
            near.setdefault(max(a, b), []).append(min(a, b))
        taken = numpy.zeros(len(rows), bool)
        most = limit - len(self.radii)
        for k in range(len(rows)):
            taken[k] = not any(taken[j] for j in near.get(k, ()))
            if taken[k] and taken[:k + 1].sum() == most:
                break
        self.x = numpy.concatenate([self.x, x[rows[taken]]])
        self.radii = numpy.append(self.radii, numpy.full(int(taken.sum()), r))
        return int(rows[k]) + 1 if len(rows) and taken.sum() == most else len(x)
