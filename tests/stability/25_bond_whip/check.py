"""The energy of a whip is the work of its base; with damping it decays.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import math
HARD = "large rotations of many bonds in a row"
BONDS = 50


def whip(c, name, entries):
    c.places(name, "x y z", [(1e-3 + 2e-3*k, 0, 0) for k in range(BONDS)])
    return c.run("scene.dem", entries, name=name)


def shaft(c, name, omega):
    c.places(name, "x y z wx wy wz", [(1e-3 + 2e-3*k, 0, 0, omega, 0, 0) for k in range(20)])
    return c.run("shaft.dem", {"walls/base/motion/omega": omega}, name=name)


def shafts(c):
    """A round shaft bends equally in all directions: one that rotates about its length at 20 1/s
    oscillates as one that does not.

The spins of its spheres, with an inertia of 2/5 m R^2, rotate the plane of oscillation slightly. If
bending moments did not rotate with the shaft, the torque of the plate would wind it up.
"""
    still, turns = shaft(c, "still", 0.0), shaft(c, "turns", 2.0*math.pi*20.0)
    if c.runs_to_end(still) and c.runs_to_end(turns):
        ends = [(a[19].x, b[19].x) for a, b in zip(still.snapshots(), turns.snapshots())]
        sag = max(abs(a[2]) for a, _ in ends)
        c.above("displacement of the shaft's end, m", sag, 0.015)
        c.below("rotating: deviation from the shaft without rotation, relative",
                max(math.dist(a, b) for a, b in ends)/sag, 0.02)
        rows = turns.table("energy.csv")
        c.below("energy residual, over the largest bond energy",
            max(abs(r["residual"]) for r in rows)/max(r["elastic_bondLinear"] for r in rows), 1e-3)


def check(c):
    # long form: the reference chain, a hundred times as stiff, for 2 s; at ten times the frequency
    # it rotates as far. The output
# interval is no fraction of the period
    stiff = {"effects/bondLinear/normalStiffness": 5e11, "effects/bondLinear/shearStiffness": 2e11,
             "time/end": 2.0, "walls/base/motion/frequency": 50,
             "write/interval": 0.0073, "write/energy": 0.0073} if c.long else {}
    run = whip(c, "free", stiff)
    if c.runs_to_end(run):
        rows = run.table("energy.csv")
        put = [abs(r["work_walls"]) for r in rows]
        c.above("largest displacement of the end across, m",
                max(abs(f[BONDS - 1].x[2] - f[0].x[2]) for f in run.snapshots()), 0.02)
        c.below("error of the energy over the largest work of the base",
                max(abs(held - r["work_walls"]) for held, r in zip(run.energy("kinetic", "elastic", "broken", "lost"), rows))
                /max(put), 1e-3)
    end = stiff.get("time/end", 0.4)
    run = whip(c, "damped", dict(stiff, **{"effects/bondLinear/dampingRatio": 0.05,
                                           "walls/base/motion/end": end/2}))
    if c.runs_to_end(run):
        inner = [energy for energy, r in zip(run.energy("kinetic", "elastic"), run.table("energy.csv"))
                 if r["time"] > end/2 + 1e-9]
        c.below("damped, base at rest: largest growth of the energy, relative",
                max(b - a for a, b in zip(inner, inner[1:]))/max(inner), 1e-6)
    shafts(c)
