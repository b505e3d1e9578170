"""A thousand crossings of periodic faces change nothing, and images act as particles do.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import math
HARD = "contacts and bonds through faces, a box of minimal width"
BOX = (0.012, 0.013, 0.011)


def check(c):
    run = c.run("scene.dem")
    if c.runs_to_end(run):
        first, last = run.snapshots()[0], run.snapshots()[-1]
        c.above("crossings of each face, at least", min(abs(v)*last.time/w
            for v, w in zip(first[0].v, BOX)), 1000)
        c.below("change of a velocity, relative", max(abs(a - b)/abs(a) for k in range(3)
            for a, b in zip(first[k].v, last[k].v)), 1e-12)
        way = [b - a - w*round((b - a)/w) for a, b, w in zip(last[1].x, last[2].x, BOX)]
        # positions are multiples of a unit of the box
        c.near("length of the bond, m", math.hypot(*way), 2e-3, 1e-12*2e-3 + 2e-16)
        # 130000 steps of three particles: on 4 ranks nearly all of it is messages, so by default a
        # tenth of them
        end = {} if c.thorough else {"time/end": 0.13}
        c.equal("on 4 ranks, fingerprint", c.run("scene.dem", end, ranks=4).hash,
                c.run("scene.dem", end).hash)
    side = 0.00594/3
    run = lattice(c, "even", side)
    if c.runs_to_end(run):
        last = run.snapshots()[-1]
        one = 4.0/3.0*1e7/(4.0*0.91)*(0.5e-3)**0.5*(2e-3 - side)**1.5             # N, a contact
        c.below("27 in a lattice: largest force on one over a contact's",
                max(abs(f) for p in last.particles.values() for f in p.columns["force"])/one, 1e-10)
        c.below("... speed, m/s", max(abs(v) for p in last.particles.values() for v in p.v), 1e-9)
    run = lattice(c, "uneven", side, 0)
    if c.runs_to_end(run):
        last = run.snapshots()[-1]
        most = max(abs(v) for p in last.particles.values() for v in p.v)
        c.holds("one displaced: the others move", most > 1e-6, "%g m/s" % most)
        c.below("... sum of momentum over the largest", max(map(abs,
            last.momentum()))/(last[0].mass*most), 1e-10)
        for axis in (1, 2):
            other = lattice(c, "uneven%d" % axis, side, axis)
            if c.runs_to_end(other):
                swap = other.snapshots()[-1]
                c.below("... the same along axis %d, over the largest speed" % axis,
                        max(abs(p.v[0] - swap[mirror(k, axis)].v[axis])
                            for k, p in last.particles.items())/most, 1e-9)


def lattice(c, name, side, axis=None):
    """27 positions; the first is displaced by 20 um along an axis."""
    points = [[side*(i + 0.25) for i in (k % 3, k//3 % 3, k//9)] for k in range(27)]
    if axis is not None:
        points[0][axis] += 2e-5
    c.places(name, "x y z", points)
    return c.run("lattice.dem", name=name)


def mirror(k, axis):
    """Index in the lattice with x and the axis exchanged."""
    at = [k % 3, k//3 % 3, k//9]
    at[0], at[axis] = at[axis], at[0]
    return at[0] + 3*at[1] + 9*at[2]
