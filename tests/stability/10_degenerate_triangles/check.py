"""Degenerate and repeated triangles are reported and never count twice.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import os
import re
import sys
sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "09_triangles"))
import surfaces                                              # noqa: E402
HARD = "a surface file with faults"
G = 9.81
MASS = 2500.0*4.18879020478639e-9
REST = (MASS*G/(4.0/3.0*1e7/(2.0*0.91)*1e-3**0.5))**(2.0/3.0)
A, B, C, D, M = (-0.01, -0.01, 0), (0.01, -0.01, 0), (0.01, 0.01, 0), (-0.01, 0.01, 0), (0, 0, 0)
FLOOR = [(A, B, C), (A, C, D)]
FAULTS = [("a triangle without area at the contact", FLOOR + [(A, M, C), (M, M, M), (A, A, C)],
           True),
          ("each triangle twice", FLOOR + FLOOR, True),
          ("each triangle twice, once flipped", FLOOR + [(A, C, B), (A, D, C)], True),
          ("neighbors with opposed normals", [(A, B, C), (A, D, C)], False),
          ("a T-junction under the sphere", [(A, B, C), (A, M, D), (M, C, D)], False)]


def check(c):
    for what, triangles, reported in FAULTS:
        name = what.split(",")[0].replace(" ", "_")
        os.makedirs(c.place(name), exist_ok=True)
        surfaces.write(os.path.join(c.place(name), "floor.stl"), triangles)
        for spot, (x, y) in (("", (0.0, 0.0)), (", aside", (0.0004, 0.0001))):
            run = c.run("scene.dem", {"insert/ball/positions": "((%g %g %.17g))" %
                                      (x, y, 1e-3 - REST)}, name=name)
            if c.runs_to_end(run):
                c.below(what + spot + ": force less m g, over it",
                        max(abs(-row["fz"]/(MASS*G) - 1.0) for row in run.wall("floor")), 1e-6)
        if reported:
            c.holds(what + ": reported at the start",
                re.search(r"left out ([1-9]\d* without area|0 without area, [1-9]\d* given before)",
                          run.out + run.err), run.out)
