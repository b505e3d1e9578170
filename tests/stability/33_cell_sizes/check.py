"""The solid volume is exact on cells from five diameters to a fifth of a diameter, with a thousand
spheres in a cell and with one in ten cells; the drag of a sphere on finer cells differs little from
its drag on cells of 5 diameters.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import fluid
HARD = "particles larger than cells, and much smaller"


def stream(c, name, per):
    """Drag in its first 4 ms on a sphere too heavy to follow, on cells of d/per."""
    d = 2e-3
    n = round(0.01/(d/per))
    case = fluid.Case(
        c, name, cells=(2*n, n, n), size=(0.02, 0.01, 0.01), step=1e-3, end=0.004, U="(0.1 0 0)",
        patches={"inlet": ("x-", "patch", "fixedValue; value uniform (0.1 0 0);", "zeroGradient;"),
                 "outlet": ("x+", "patch", "zeroGradient;", "fixedValue; value uniform 0;")},
        scene="materials { heavy { density 1e12; youngsModulus 1e6; } } effects { schillerNaumann { } pressureGradient { } } "
              "time { step 1e-3; } insert { one { type list; diameter %g; positions ((0.0093 0.0052 0.0049)); } } "
              "coupling { rho 1.2; }" % d)
    if not case.ends(c, name):
        return None
    c.below("cells of %.3g diameters: error of the solid volume" % (1.0/per), case.worst("volume error"), 1e-12)
    return case.particles("0.004", "U")[0, 1]


def check(c):
    if not fluid.there():
        return c.skip("cell sizes", "no demPimpleFoam")
    coarse = stream(c, "d0.2", 0.2)
    for per in (1, 2, 5):
        fine = stream(c, "d%d" % per, per)
        if coarse and fine:
            c.below("cells of %.3g diameters: change of drag against cells of 5" % (1.0/per),
                    abs(fine/coarse - 1.0), 0.2)
    for what, count, d, high in (("1000 in a cell", 1000, 0.4e-3, 0.0079),
                                 ("one in ten cells", 100, 1e-3, 0.079)):
        case = fluid.Case(
            c, what, cells=(10, 10, 10), size=(0.08, 0.08, 0.08), step=1e-3, end=0.002,
            patches={"walls": (fluid.ALL,) + fluid.WALL},
            scene="materials { glass { density 2500; youngsModulus 1e6; } } effects { gidaspow { } pressureGradient { } } "
                  "time { step 1e-4; } insert { all { type random; count %d; diameter %g; min (0.0001 0.0001 0.0001); "
                  "max (%g %g %g); } } coupling { rho 1.2; }" % (count, d, high, high, high))
        if case.ends(c, what):
            c.below(what + ": error of the solid volume", case.worst("volume error"), 1e-12)
