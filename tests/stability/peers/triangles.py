"""
triangles.py -- the cases with surface files as walls, 09 and 10, in the codes that have such walls;
as grains.py.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import os
import sys

from grains import D, G, MASS, R, rest
from scene import Scene

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "09_triangles"))
import surfaces                                              # noqa: E402


def floor(triangles, friction, end, x=(0.0, 0.0), v=(0.0, 0.0, 0.0), mesh=""):
    s = Scene(step=2e-6, end=end, every=1e-3, friction=friction, gravity=(0, 0, -G),
              box=((-0.06, -0.03, -0.005), (0.16, 0.03, 0.02)), more={"liggghts mesh": mesh})
    s.grain(D, (*x, R - rest()), v=v)
    s.triangles = [tuple(tuple(map(float, p)) for p in t) for t in triangles]
    return s


def flat(c):
    """A sphere slides over 400 random triangles in one plane."""
    made = surfaces.flat((-0.05, -0.02), (0.15, 0.02), 9)
    for friction, end in ((0.0, 0.06), (0.3, 0.12)):
        run = c.run(floor(made, friction, end, (-0.03, 0.0003), (1.0, 0.0, 0.0)), "mu%g" % friction)
        if not run:
            continue
        grain = [f.grains[0] for f in run.frames]
        if friction:
            slip = grain[-1].w[1]/(grain[30].w[1]/run.frames[30].time)
            c.near("mu 0.3: time of slip over 2 u/(7 mu g)", slip/(2.0/(7.0*0.3*G)), 1.0, 0.005)
        else:
            c.below("mu 0: force on the wall less m g, over it",
                    max(abs(g.f[2])/(MASS*G) for g in grain), 1e-6)
            c.below("mu 0: largest vertical velocity, m/s", max(abs(g.v[2]) for g in grain), 1e-6)
            c.below("mu 0: velocity lost along the way, m/s", abs(grain[-1].v[0] - 1.0), 1e-6)


P, Q, S, T, M = (-0.01, -0.01, 0), (0.01, -0.01, 0), (0.01, 0.01, 0), (-0.01, 0.01, 0), (0, 0, 0)
FLOOR = [(P, Q, S), (P, S, T)]
FAULTS = [("sound", FLOOR), ("a triangle without area on the spot",
    FLOOR + [(P, M, S), (M, M, M), (P, P, S)]), ("each triangle twice", FLOOR + FLOOR),
          ("each once more, its normal flipped", FLOOR + [(P, S, Q), (P, T, S)]),
          ("normals of neighbours opposed", [(P, Q, S), (P, T, S)]),
          ("a T-junction under the sphere", [(P, Q, S), (P, M, T), (M, S, T)])]


def faults(c):
    """A sphere rests on a floor from a surface file with faults: refused or reported, and no force
    counted twice."""
    for what, triangles in FAULTS:
        worst, how = 0.0, ""
        for spot in ((0.0, 0.0), (0.0004, 0.0001)):
            run = c.start(floor(triangles, 0.3, 0.02, spot),
                          what.replace(" ", "_").replace(",", "") + "%g" % spot[0])
            if run.status and len(run.frames) < 2:
                how = "refused: " + run.complaint()
                continue
            if not c.ended(run):
                worst = float("nan")
                continue
            worst = max(worst, max(abs(f.grains[0].f[2])/(MASS*G) for f in run.frames))
        c.below(what + ": refused, or force less m g, over it", worst, 1e-6, how)
