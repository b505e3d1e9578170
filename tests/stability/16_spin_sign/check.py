"""A sliding sphere starts to roll forward, and ends rolling: v = 5/7 of the start, w = v/R about y.

SPDX-License-Identifier: GPL-3.0-or-later
"""
HARD = "the sign of the friction torque"


def check(c):
    run = c.run("scene.dem")
    if not c.runs_to_end(run):
        return
    frames = run.snapshots()
    # m g mu R over 2/5 m R^2 makes 5/2 mu g/R = 7358 1/s2, until it rolls
    c.near("spin about y after 5 ms over 5/2 mu g t/R",
           frames[1][0].w[1]/(2.5*0.3*9.81*frames[1].time/1e-3), 1.0, 0.01)
    c.near("at the end: velocity over 5/7 of the first", frames[-1][0].v[0]/(5.0/7.0*0.1), 1.0,
           0.005)
    c.near("at the end: R w_y over v", 1e-3*frames[-1][0].w[1]/frames[-1][0].v[0], 1.0, 0.005)
    c.below("spin about other axes, 1/s", max(abs(f[0].w[a]) for f in frames for a in (0, 2)), 1e-9)
