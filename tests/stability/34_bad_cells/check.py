"""Cells with a volume ratio of 1e6 and an aspect ratio of 1000: a fluid at rest stays at rest.

Tetrahedra, polyhedra, slivers and inclined cells: tests/coupled/cells.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import fluid
HARD = "tiny and thin cells"


def check(c):
    if not fluid.there():
        return c.skip("bad cells", "no demPimpleFoam")
    # 3 x 3 x 24 cells; the lowest are a millionth of the highest, and 1000 and more times as wide
    # as high
    case = fluid.Case(
        c, "graded", cells=(3, 3, 24), size=(0.011, 0.011, 0.0506), grading="1 1 1e6", step=1e-3, end=0.005,
        g=(0, 0, -9.81), nu=1e-6, patches={"walls": (fluid.ALL,) + fluid.WALL},
        scene="materials { m { density 1000; youngsModulus 1e6; } } effects { gidaspow { } pressureGradient { } } "
              "time { step 1e-4; } insert { all { type random; count 400; diameter 1e-3; min (0 0 0); "
              "max (0.011 0.011 0.03); } } coupling { rho 1000; }")
    if case.ends(c, "graded 1e6"):
        c.below("neutral particles: largest speed, m/s", fluid.largest(case.particles("0.005", "U")[:, 1:]), 1e-6)
        c.below("largest speed of the fluid, m/s", fluid.largest(case.field("0.005/U")), 1e-6)
        c.below("error of the solid volume", case.worst("volume error"), 1e-12)
        c.below("exchange error", case.worst("exchange error"), 1e-12)
