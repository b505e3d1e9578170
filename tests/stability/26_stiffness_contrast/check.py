"""The end hangs at the position of springs in series, and stays there.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import math
HARD = "a step for stiff bonds, a motion of soft ones"
WEIGHT, AREA = 2500.0*4.18879020478639e-9*9.81, math.pi*1e-6


def check(c):
    run = c.run("scene.dem")
    if not c.runs_to_end(run):
        return
    # bond k (0 at the ceiling) carries 8 - k spheres; those between soft ones are 5, 6 and 7
    wanted = sum((8 - k)*WEIGHT/((5e7 if k > 4 else 5e11)*AREA) for k in range(8))
    half, last = run.snapshots()[1:3]
    c.above("steps", last.steps, 1e6)
    c.near("sag of the end over the sag of springs in series", (-0.015 - last[7].x[2])/wanted, 1.0,
           1e-3)
    c.below("drift in the second half, over the sag", abs(last[7].x[2] - half[7].x[2])/wanted, 1e-9)
