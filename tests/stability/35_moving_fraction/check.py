"""A sphere half as wide as a cell crosses faces: the jump of pressure between steps decreases with
the step.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import os
import sys
sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), ".."))
import fluid                                                 # noqa: E402
HARD = "a void fraction that jumps from cell to cell"


def jump(c, kernel, step):
    case = fluid.Case(c, "%s %g" % (kernel.replace(";", ""), step), cells=(8, 4, 4),
                      size=(0.016, 0.008, 0.008), step=step, end=0.04, write=step, nu=1e-6,
                      patches={"ends": (("x0", "x1"), "patch", "zeroGradient;",
                                        "fixedValue; value uniform 0;"),
                               "sides": (("y0", "y1", "z0", "z1"), "wall", "slip;",
                                         "fixedFluxPressure;")},
                      scene="materials { tungsten { density 1e9; youngsModulus 1e9; } } effects { gidaspow { } pressureGradient { } } time { step %g; }\n"
                            "insert { one { type list; diameter 1e-3; velocity (0.1 0 0); positions ((0.0061 0.0041 0.0039)); } } coupling { rho 1000; kernel %s; }" % (step, kernel))
    if not case.run():
        c.holds("runs", False, case.log)
        return None
    before, most = None, 0.0
    # without the first 10 ms, the transient of the start
    for k in range(round(0.01/step), round(0.04/step) + 1):
        now = [r[0] for r in case.field("%.9g" % (k*step), "p")]
        most = max(most, max(abs(a - b) for a, b in zip(now, before)) if before else 0.0)
        before = now
    return most


def check(c):
    if not fluid.there():
        return c.skip("a sphere across faces", "no demPimpleFoam")
    for kernel in ("gaussian", "diffusion; base divided", "diffusion"):
        jumps = [jump(c, kernel, step) for step in (2e-3, 1e-3, 5e-4)]
        if all(jumps) and kernel != "diffusion":
            c.below(kernel + ": largest jump of pressure from step to step, halving the step: ratio", jumps[1]/jumps[0], 1.0)
            c.below(kernel + ": halving again", jumps[2]/jumps[1], 1.0)
        elif all(jumps):
            # linear weights have a kink, at which a jump remains: it must not grow by 1.3, and must
            # decrease over both
            c.below(kernel + ": halving the step, ratio", max(jumps[1]/jumps[0], jumps[2]/jumps[1]),
                    1.3)
            c.below(kernel + ": halving it twice", jumps[2]/jumps[0], 1.0)
