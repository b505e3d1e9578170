"""The elastic energy of bonds is lost when they break, and no force is above the strength.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import math
import os
HARD = "a thousand bonds break in one step"
AREA = math.pi*1e-6


def pairs(c, name, entries=None):
    os.makedirs(c.place(name))
    with open(os.path.join(c.place(name), "places"), "w") as file:
        file.write("x y z vx vy vz\n")
        for k in range(1000):
            x, y, z = 0.00625*(k % 10), 0.00625*(k//10 % 10), 0.00625*(k//100)
            for s in (-1, 1):
                # multiples of 2^-40 m: sums of positions are exact, so all pairs are equal to the
                # last bit
                file.write("%.17g %.17g %.17g %g 0 0\n" %
                           (round((x + 0.001*s)*2**40)/2**40, y, z, 0.6*s))
    return c.run("scene.dem", entries, name=name)


def sums(run):
    """Kinetic, elastic and lost energy, from the rows of energy.csv."""
    return [sum(v for k, v in r.items() if k.startswith(("kinetic", "elastic", "lost", "broken")))
            for r in run.table("energy.csv")]


def check(c):
    run = pairs(c, "pairs")
    if not c.runs_to_end(run):
        return
    broken = run.table("bonds.csv")
    c.equal("bonds that broke", len(broken), 1000)
    c.equal("steps in which bonds broke", len({row["time"] for row in broken}), 1)
    rows = run.table("energy.csv")
    all_of = sums(run)
    held = max(r["elastic_bondLinear"] for r in rows)
    c.below("change of kinetic, elastic and lost energy, over the elastic energy",
            max(abs(e - all_of[0]) for e in all_of)/held, 1e-3)
    force = max(abs(f) for s in run.snapshots() for p in s.particles.values()
                for f in p.columns["force"])
    c.below("largest force over strength times area", force/(1e6*AREA), 1.0)
    c.near("lost in a bond over (sigma A)^2/(2 k_n A)", sum(row["energy"]
        for row in broken)/1000/((1e6*AREA)**2/(2.0*5e11*AREA)), 1.0, 0.1)
    # about the automatic step: no step is shortened for an output before all bonds are broken
    run = pairs(c, "long_step", {"time/step": 5e-7, "time/end": 7e-6, "write/interval": 3.5e-6,
                                 "write/energy": 3.5e-6})
    if c.runs_to_end(run):
        c.equal("bonds that broke at the automatic step", len(run.table("bonds.csv")), 1000)
        rows, all_of = run.table("energy.csv"), sums(run)
        c.below("change of kinetic, elastic and lost energy at the automatic step, over the energy lost", max(abs(e - all_of[0]) for e in all_of)/rows[-1]["broken"], 1e-9)
