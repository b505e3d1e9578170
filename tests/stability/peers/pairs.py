"""
pairs.py -- the cases of periodic boxes and lists, 18 and 20, and of the law with hysteresis, 22 and
23; as grains.py.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import random

from grains import D
from scene import Scene, size


def wrap(c):
    """A sphere crosses all faces of a narrow periodic box; 27 that touch each other and their
    images, one of them displaced."""
    low, high = (0.0, 0.0, 0.0), (0.012, 0.013, 0.011)
    s = Scene(step=1e-5, end=1.3, every=0.13, periodic="xyz", box=(low, high))
    s.grain(D, (0.002, 0.002, 0.002), v=(10, -11, 9))
    run = c.run(s, "one")
    if run:
        c.below("1000 passages: change of a velocity, relative",
                max(abs(a - b)/abs(a) for a, b in zip((10, -11, 9), run.last.grains[0].v)), 1e-12)
    side = 0.00594/3
    one = 4.0/3.0*1e7/(4.0*0.91)*(0.5e-3)**0.5*(D - side)**1.5
    # YADE's bounds are wider than its spheres by default, here by half the box: once with the
    # default, once without margin
    tight = {"yade": {"verlet": 0.0}}
    for what, off, more in [("27 in a lattice", 0.0, {}),
            ("one out of its place", 2e-5, {})] + [("27, verletDist 0", 0.0, tight),
                ("one out, verletDist 0", 2e-5, tight)]*(c.peer == "yade"):
        s = Scene(step=1e-6, end=1e-3, every=1e-3, restitution=1.0, periodic="xyz",
                  box=(low, (0.00594, 0.00594, 0.00594)), more=more)
        for k in range(27):
            s.grain(D, [side*(i + 0.25) + off*(k == 0 and a == 0)
                        for a, i in enumerate((k % 3, k//3 % 3, k//9))])
        run = c.run(s, "lattice%g%s" % (off, "tight" if more else ""))
        if run and not off:
            c.below(what + ": largest force on one over a contact's",
                    max(size(g.f) for g in run.last.grains.values())/one, 1e-10)
            c.below(what + ": largest speed, m/s", max(size(g.v) for g in run.last.grains.values()),
                    1e-9)
        elif run:
            most = max(size(g.v) for g in run.last.grains.values())
            c.above(what + ": largest speed, m/s", most, 1e-6)
            c.below(what + ": sum of momentum over the largest",
                max(abs(sum(g.v[a] for g in run.last.grains.values())) for a in range(3))/most,
                1e-10)


def escape(c):
    """One of a thousand is a hundred times as fast as the others: spheres that overlap have a
    force, others have none."""
    side, draw, places = 0.034, random.Random(20), [(0.017, 0.017, 0.0175)]
    while len(places) < 1000:
        x = [draw.uniform(0.0, side) for _ in range(3)]
        if all(sum((a - b - side*round((a - b)/side))**2 for a, b in zip(x, y)) > 1.0001*D*D
               for y in places):
            places.append(x)
    s = Scene(step=1.2e-6, end=0.012, every=1.2e-4, young=1e8, restitution=0.95, impact=20.0,
              periodic="xyz", box=((0.0, 0.0, 0.0), (side, side, side)))
    for k, x in enumerate(places):
        s.grain(D, x, v=(13, 11, 7) if k == 0 else (0.1, -0.1, 0.1))
    run = c.run(s)
    if not run:
        return
    bare = missed = met = 0
    for f in run.frames[1:]:
        # YADE's forces are those at the start of its last step
        places = {k: [a - s.step*b for a, b in zip(g.x, g.v)] if c.peer == "yade" else g.x
                  for k, g in f.grains.items()}
        touch, near = touching(places, {k: g.v for k, g in f.grains.items()}, side)
        met += len(touch)
        bare += sum(k not in touch and size(g.f) > 0.0 for k, g in f.grains.items())
        # in separation a law may have no force before the overlap is zero
        missed += sum(size(f.grains[k].f) == 0.0 for k in near)
    c.above("spheres that touch, of all looks", met, 50)
    c.below("with a force and no overlap", bare, 0)
    c.below("pressed into another and no force", missed, 0)


def touching(places, speeds, side):
    """Spheres that overlap others, also through faces, cell by cell; and the ones among them that
    approach an overlapping sphere."""
    n, cells, met, nearing = 16, {}, set(), set()
    for k, x in places.items():
        cells.setdefault(tuple(int(a/side*n) % n for a in x), []).append(k)
    around = [(i, j, k) for i in (-1, 0, 1) for j in (-1, 0, 1) for k in (-1, 0, 1)]
    for at, here in cells.items():
        for step in around:
            for q in cells.get(tuple((a + b) % n for a, b in zip(at, step)), ()):
                for p in here:
                    way = [b - a - side*round((b - a)/side) for a, b in zip(places[p], places[q])]
                    if p < q and sum(w*w for w in way) < D*D:
                        met.update((p, q))
                        if sum(w*(b - a) for w, a, b in zip(way, speeds[p], speeds[q])) < 0.0:
                            nearing.update((p, q))
    return met, nearing


def sticking(c):
    """A pair with an adhesion of a hundred times its stiffness comes together and stays, 10^5 steps.

Relative speed 0.6 m/s: at the 0.1 m/s of ../22_strong_sticking the rebound exceeds the adhesion in
every code.
"""
    s = Scene(step=1e-6, end=0.1, every=1e-3, law="hysteresis", restitution=1.0,
              spring=dict(stiffness=1000.0, unloading=5.0, adhesion=100.0, depth=0.05),
              box=((-0.05, -0.05, -0.05), (0.05, 0.05, 0.05)))
    s.grain(D, (-1.001e-3, 0, 0), v=(0.4, 0.05, -0.02))
    s.grain(D, (1.001e-3, 2e-4, 0), v=(-0.2, 0.05, -0.02))
    run = c.run(s)
    if not run:
        return
    start = run.frames[0].kinetic(s)
    c.below("largest kinetic energy over the first", max(f.kinetic(s) for f in run.frames)/start,
            1.001)
    c.below("change of momentum, relative", max(abs(sum(f.grains[k].v[a] for k in (0, 1)) - p)/0.2
        for f in run.frames[1:] for a, p in enumerate((0.2, 0.1, -0.04))), 1e-10)
    c.below("centres apart at last, diameters", size([a - b
        for a, b in zip(run.last.grains[0].x, run.last.grains[1].x)])/D, 1.0)


def elastic(c):
    """The hysteretic law without hysteresis: 16 spheres hit a plane, each at a different phase of
    the step."""
    for what, unloading, depth in (("k_m = k, phi = 0", 1, 0), ("k_m = k, phi = 0.05", 1, 0.05),
                                   ("k_m = 5 k, phi = 0", 5, 0)):
        s = Scene(step=8e-7, end=1e-3, every=1e-3, law="hysteresis", restitution=1.0,
                  spring=dict(stiffness=1000.0, unloading=unloading, adhesion=0.0, depth=depth),
                  box=((-0.05, -0.01, -0.01), (0.2, 0.01, 0.02)))
        for k in range(16):
            s.grain(D, (0.01*k, 0, 1.05e-3 + 8e-7*k/16.0), v=(0, 0, -1))
        s.plane("z", 0.0, 1)
        run = c.run(s, "%s%g" % (unloading, depth))
        if run:
            c.near(what + ": restitution, mean of 16 phases",
                   sum(g.v[2] for g in run.last.grains.values())/16, 1.0, 1e-4)
