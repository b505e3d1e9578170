"""A rigid rotation causes no shear, and keeps angular momentum and energy.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import math
HARD = "slip and rotation of bonds in a rigid rotation"
TURNS = 10


def check(c):
    for n in (2, 3, 21):
        # revolutions per second; fewer for the chain, which would oscillate
        name, rate = "%d" % n, 25.0 if n > 3 else 50.0
        omega = 2.0*math.pi*rate
        for folder in (name, name + "_calm"):
            c.places(folder, "x y z vx vy vz wx wy wz", [
                (x, 0, 0, 0, omega*x, 0, 0, 0, omega) for x in (2e-3*(k - 0.5*(n - 1)) for k in range(n))])
        # the centrifugal elongation at the start is damped until the rotation is rigid
        calm = c.run("scene.dem", {"effects/bondLinear/dampingRatio": 0.5, "time/end": 0.01,
            "write/interval": 0.01, "write/energy": 0.01}, name=name + "_calm")
        run = c.run("scene.dem", {"time/end": 0.01 + TURNS/rate},
                    restart=calm.path("snapshot_000001.dem"), name=name)
        if not c.runs_to_end(run):
            continue
        frames = [f for f in run.snapshots() if f.time > 0.011]
        what = {2: "pair", 3: "triple", 21: "chain of 20 bonds"}[n]
        slip = max(math.sqrt(sum(memory[k]**2 for k in memory if "slip" in k or "shear" in k))
                   for f in frames for _, _, memory in f.rows)
        c.below(what + ": largest |F_t|/(k_t A L)", slip/2e-3, 1e-9)
        l = [f.angular_momentum()[2] for f in frames]
        c.below(what + ": change of L_z, relative", max(abs(x/l[0] - 1.0) for x in l), 1e-10)
        energy = run.energy("kinetic", "elastic")
        c.below(what + ": change of energy, relative", max(abs(e/energy[0] - 1.0) for e in energy),
                1e-6)
