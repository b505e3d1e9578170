"""An overlap of half a radius is refused by name; at the largest accepted overlap no particle is
ejected.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import random
HARD = "large overlaps at the start"


def calm(c, what, run):
    if not c.runs_to_end(run):
        return
    frames = run.snapshots()
    c.below(what + ": largest speed, m/s", max(max(map(abs, p.v)) for f in frames
                                               for p in f.particles.values()), 10.0)
    energy = run.energy("kinetic", "elastic")
    # at steps of t_c/20 the energy of the leapfrog oscillates by 3e-4 in an impact
    # (docs/energy-balance.md)
    c.below(what + ": largest growth of kinetic and elastic energy over its start",
            max(b - a for a, b in zip(energy, energy[1:]))/max(energy[0], 1e-30), 1e-3)
    c.equal(what + ": spheres in the box", sum(all(0.0 < x < 0.03 for x in p.x)
                                               for p in frames[-1].particles.values()),
            len(frames[0].particles))


def check(c):
    c.places("pair", "x y z", [(0.01, 0.01, 0.01), (0.0115, 0.01, 0.01)])                # overlap R/2
    run = c.run("scene.dem", name="pair")
    c.holds("a pair with an overlap of R/2: refused, both named",
            run.status != 0 and "0 and 1" in run.err and "overlap" in run.err, run.err)
    draw = random.Random(4)
    c.places("crowd", "x y z", [tuple(draw.uniform(1e-3, 0.015) for _ in range(3)) for _ in range(1000)])
    run = c.run("scene.dem", name="crowd")
    c.holds("1000 at random positions: refused, two named",
            run.status != 0 and "overlap" in run.err and "particles" in run.err, run.err)
    most = 0.0499*2e-3
    c.places("most", "x y z", [(0.01, 0.01, 0.01), (0.012 - most, 0.01, 0.01)])
    calm(c, "a pair at the largest accepted overlap", c.run("scene.dem", name="most"))
    gap = 2e-3 - most
    c.places("block", "x y z", [(0.005 + gap*i, 0.005 + gap*j, 0.005 + gap*k) for i in range(10)
                        for j in range(10) for k in range(10)])
    calm(c, "1000 at the largest accepted overlap", c.run("scene.dem", name="block"))
    calm(c, "1000 placed by `random` at 0.54", c.run("dense.dem", name="dense"))
