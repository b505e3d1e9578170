"""Four ranks have the results of one: without particles, with one, and with all on one rank.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import os
import sys
sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), ".."))
import fluid                                                 # noqa: E402
HARD = "ranks without particles"

PARTICLES = (("none", ""),
             ("one", "all { type list; diameter 1e-3; positions ((0.0251 0.0052 0.0051)); velocity (0.5 0 0); }"),
             ("all over one rank", "all { type lattice; diameter 1e-3; count 200; spacing 1.2; jitter 0.5; min (0 0 0); max (0.02 0.01 0.01); velocity (0.2 0 0); }"))


def box(c, name, particles):
    return fluid.Case(c, name, cells=(40, 4, 4), size=(0.1, 0.01, 0.01), step=1.6e-3, end=0.0064,
                      g=(0, 0, -9.81),
                      patches={"walls": (("x0", "x1", "y0", "y1", "z0", "z1"),) + fluid.WALL},
                      scene="materials { glass { density 2500; youngsModulus 1e6; } } effects { gravity { acceleration (0 0 -9.81); } hertz { } dry { restitution 0.9; } mindlin { friction 0.3; }\n"
                            "gidaspow { } pressureGradient { } } time { step 1e-5; } insert { %s } coupling { rho 1.2; }" % particles)


def check(c):
    if not fluid.there():
        return c.skip("ranks", "no demPimpleFoam")
    for what, particles in PARTICLES:
        one, four = box(c, what + " 1", particles), box(c, what + " 4", particles)
        if not one.run() or not four.run(ranks=4, split=(4, 1, 1)):
            c.holds(what + ": runs on one and four ranks", False,
                    one.log[-400:] + getattr(four, "log", "")[-400:])
            continue
        u, w = one.field("0.0064", "U"), four.field("0.0064", "U")
        if len(u) != len(w):
            u, w = (f*640 if len(f) == 1 else f for f in (u, w))
        c.below(what + ": largest difference of the fluid's velocity, m/s",
                max(abs(a - b) for p, q in zip(u, w) for a, b in zip(p, q)), 1e-5)
        if what != "none":
            a, b = one.particles("0.0064"), four.particles("0.0064")
            # linear solvers with a tolerance of 1e-11 sum in another order
            c.below(what + ": largest difference of positions and velocities of particles",
                max(abs(x - y) for k in a for p, q in zip(a[k], b[k]) for x, y in zip(p, q)), 1e-8)
