"""With added mass light spheres reach their terminal velocity without overshoot; a swarm of bubbles
stays bounded.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import math
import fluid
HARD = "added mass 400 times the particle mass"
RISE = ((1.2, 0.20823), (500.0, 0.13555), (990.0, 0.010018), (1010.0, -0.010018))


def speeds_up(density, end):
    """m/s after `end` s from rest in water: (m + rho V/2) dv/dt = (rho - rho_p) V g - drag of
    Schiller and Naumann, by Runge-Kutta steps of 10 us."""
    volume, d, mu, rho = 4.18879020478639e-9, 2e-3, 1e-3, 1000.0

    def rate(v):
        drag = 3.0*math.pi*mu*d*v*(1.0 + 0.15*(rho*d*abs(v)/mu)**0.687)
        return ((rho - density)*volume*9.81 - drag)/((density + 0.5*rho)*volume)

    v, h = 0.0, 1e-5
    for _ in range(round(end/h)):
        a = rate(v)
        b = rate(v + 0.5*h*a)
        e = rate(v + 0.5*h*b)
        v += h/6.0*(a + 2.0*b + 2.0*e + rate(v + h*e))
    return v


def check(c):
    for density, speed in RISE:
        early = c.run("scene.dem", {"materials/bubble/density": density, "time/end": 0.01,
            "time/step": 1e-4, "write/interval": 0.01}, name="early%g" % density)
        if c.runs_to_end(early):
            wanted = speeds_up(density, 0.01)
            c.near("density ratio %g: speed after 10 ms, m/s" % (density/1000),
                   early.snapshots()[-1][0].v[2], wanted, 0.02*abs(wanted))
        run = c.run("scene.dem", {"materials/bubble/density": density}, name="%g" % density)
        if c.runs_to_end(run):
            v = [f[0].v[2] for f in run.snapshots()]
            c.near("density ratio %g: final upward speed, m/s" % (density/1000), v[-1], speed,
                   0.05*abs(speed))
            c.below("... largest speed before, over it", max(x/speed for x in v), 1.05)
    if not fluid.there():
        return c.skip("swarm of bubbles", "no demPimpleFoam")
    # the swarm of tests/coupled/forces, three tenths of the volume
    case = fluid.Folder(c, "swarm", "forces/swarm")
    end = "5" if c.long else "0.1"
    case.edit("system/controlDict", endTime=end)
    if case.ends(c, "swarm"):
        # a single bubble rises with 0.19 m/s; a diverging exchange doubles in each step
        c.below("swarm at 0.3: largest speed of a bubble, m/s", fluid.largest(case.particles(end, "U")[:, 1:]), 0.2)
        c.below("swarm: exchange error", case.worst("exchange error"), 1e-12)
