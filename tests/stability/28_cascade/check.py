"""The elastic energy of bonds is lost when they break, and no force is above the strength.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import math
HARD = "a thousand bonds break in one step"
AREA = math.pi*1e-6


def pairs(c, name, entries=None):
    # multiples of 2^-40 m: sums of positions are exact, so all pairs are equal to the last bit
    c.places(name, "x y z vx vy vz", [
        (round((0.00625*(k % 10) + 0.001*s)*2**40)/2**40, 0.00625*(k//10 % 10), 0.00625*(k//100), 0.6*s, 0, 0)
        for k in range(1000) for s in (-1, 1)])
    return c.run("scene.dem", entries, name=name)


def sums(run):
    return run.energy("kinetic", "elastic", "lost", "broken")


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
