"""A sphere coupled every 1, 10, 100 and 1000 of its steps settles at one speed; an interval above
its response time is reported.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import fluid
HARD = "few exchanges for many steps"


def settle(c, n):
    step = 5e-5                                              # the response time is 16.7 ms
    case = fluid.Case(
        c, "every%d" % n, cells=(4, 4, 4), size=(0.04, 0.04, 0.04), step=n*step, end=0.1, g=(0, 0, -9.81),
        patches={"walls": ("x- x+ y- y+ z-",) + fluid.WALL,
                 "top": ("z+", "patch", "pressureInletOutletVelocity; value uniform (0 0 0);",
                         "fixedValue; value uniform 0;")},
        scene="materials { m { density 3000; youngsModulus 1e6; } } effects { gravity { acceleration (0 0 -9.81); } "
              "wenYu { } pressureGradient { } } time { step %g; } insert { one { type list; diameter 1e-4; "
              "positions ((0.0193 0.0207 0.0305)); } } coupling { rho 10; }" % step)
    return (case.particles("0.1", "U")[0, 3], case.log()) if case.ends(c, "every %d" % n) else (None, "")


def check(c):
    if not fluid.there():
        return c.skip("coupling intervals", "no demPimpleFoam")
    one, _ = settle(c, 1) if c.long else (None, "")
    ten, _ = settle(c, 10)
    hundred, quiet = settle(c, 100)
    thousand, log = settle(c, 1000)
    base = one or ten
    if base and hundred and thousand:
        c.below("settling speed, every 100 steps against every %d" % (1 if one else 10),
                abs(hundred/base - 1.0), 0.01)
        c.holds("every 1000 steps, three times the response time: reported", "maxRelaxation" in log,
                log[-300:])
        c.holds("every 100: not reported", "(maxRelaxation)" not in quiet, "reported")
        c.below("every 1000: speed against that", abs(thousand/base - 1.0), 0.1)
