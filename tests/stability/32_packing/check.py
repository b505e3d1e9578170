"""A cell with more solid than its volume keeps the solid volume exactly, has a bounded void
fraction and pressure, and is reported.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import fluid
HARD = "more solid than the volume of a cell"


def check(c):
    if not fluid.there():
        return c.skip("a cell too full", "no demPimpleFoam")
    places = " ".join("(%.9g %.9g %.9g)" % tuple(0.0084 + 0.8e-3*i
        for i in (k % 10, k//10 % 10, k//100)) for k in range(1000))
    for kernel in ("particleCentre", "diffusion"):
        # 1000 spheres of 1 mm with their centres in one cell of 8 mm: 1.02 of it. No contact law,
        # so that overlaps are possible
        case = fluid.Case(
            c, kernel, cells=(4, 3, 3), size=(0.032, 0.024, 0.024), step=1e-3, end=0.005,
            patches={"ends": ("x- x+", "patch", "fixedValue; value uniform (0.01 0 0);", "fixedValue; value uniform 0;"),
                     "sides": ("y- y+ z- z+", "wall", "slip;", "fixedFluxPressure;")},
            scene="materials { glass { density 2500; youngsModulus 1e6; } } effects { gidaspow { } pressureGradient { } } "
                  "time { step 1e-4; } insert { all { type list; frozen yes; diameter 1e-3; positions (%s); } } "
                  "coupling { rho 1000; kernel %s; }" % (places, kernel))
        if not case.ends(c, kernel):
            continue
        c.below(kernel + ": error of the solid volume, relative", case.worst("volume error"), 1e-12)
        c.above(kernel + ": smallest void fraction (minVoidFraction is 0.2)",
                case.field("0.005/voidFraction").min(), 0.2 - 1e-3)
        # Ergun's at 0.2: 60
        c.below(kernel + ": largest pressure, m2/s2", fluid.largest(case.field("0.005/p")), 100.0)
        if kernel == "particleCentre":
            c.holds(kernel + ": reported with the number of cells", "below 0.2 in" in case.log(), case.log())
