"""The loop of friction over displacement has the height and area of Coulomb friction.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import math
HARD = "friction that reverses, slips, sticks and reverses again"
MU, DEPTH = 0.3, 1e-5
FORCE = 4.0/3.0*1e7/(2.0*0.91)*1e-3**0.5*DEPTH**1.5
# Mindlin, 8 G* sqrt(R d)
STIFFNESS = 8.0*1e7/(4.0*1.7*1.3)*(1e-3*DEPTH)**0.5


def check(c):
    slip, cycle = MU*FORCE/STIFFNESS, 0.01
    swing = 5.0*slip
    run = c.run("scene.dem", {"walls/plate/motion/amplitude": (swing, 0, 0)})
    if not c.runs_to_end(run):
        return
    rows = run.wall("plate")
    c.below("largest |F_t|/(mu F_n) - 1", max(math.hypot(r["fx_now"],
        r["fy_now"])/(MU*abs(r["fz_now"])) - 1.0 for r in rows), 1e-9)
    loop = [(swing*math.sin(2.0*math.pi*r["time"]/cycle), -r["fx_now"]) for r in rows
            if r["time"] > 2.0*cycle - 1e-9]
    area = sum(0.5*(f + g)*(y - x) for (x, f), (y, g) in zip(loop, loop[1:]))
    wanted = 4.0*MU*FORCE*(swing - slip)
    c.near("area of the loop over 4 mu F_n (A - mu F_n/k_t)", area/wanted, 1.0, 0.01)
