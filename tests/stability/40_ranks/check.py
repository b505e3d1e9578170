"""Four ranks have the results of one: without particles, with one, and with all on one rank.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import fluid
HARD = "ranks without particles"

PARTICLES = (("none", ""),
             ("one", "all { type list; diameter 1e-3; positions ((0.0251 0.0052 0.0051)); velocity (0.5 0 0); }"),
             ("all over one rank", "all { type lattice; diameter 1e-3; count 200; spacing 1.2; jitter 0.5; min (0 0 0); max (0.02 0.01 0.01); velocity (0.2 0 0); }"))


def box(c, name, particles):
    return fluid.Case(
        c, name, cells=(40, 4, 4), size=(0.1, 0.01, 0.01), step=1.6e-3, end=0.0064, g=(0, 0, -9.81),
        patches={"walls": (fluid.ALL,) + fluid.WALL},
        scene="materials { glass { density 2500; youngsModulus 1e6; } } effects { gravity { acceleration (0 0 -9.81); } "
              "hertz { } dry { restitution 0.9; } mindlin { friction 0.3; } gidaspow { } pressureGradient { } } "
              "time { step 1e-5; } insert { %s } coupling { rho 1.2; }" % particles)


def check(c):
    if not fluid.there():
        return c.skip("ranks", "no demPimpleFoam")
    for what, particles in PARTICLES:
        one, four = box(c, what + " 1", particles), box(c, what + " 4", particles)
        if not one.ends(c, what + ", one rank") or not four.ends(c, what + ", four ranks", split=(4, 1, 1)):
            continue
        c.below(what + ": largest difference of the fluid's velocity, m/s",
                fluid.coupled.difference(one.field("0.0064/U", 640), four.field("0.0064/U", 640)), 1e-5)
        if what != "none":
            # linear solvers with a tolerance of 1e-11 sum in another order
            c.below(what + ": largest difference of positions and velocities of particles",
                    fluid.coupled.difference(*(case.particles("0.0064", "positions", "U") for case in (one, four))), 1e-8)
