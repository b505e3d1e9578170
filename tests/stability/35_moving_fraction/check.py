"""A sphere half as wide as a cell crosses faces: the jump of pressure between steps decreases with
the step.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import fluid
HARD = "a void fraction that jumps from cell to cell"


def jump(c, kernel, step):
    case = fluid.Case(
        c, "%s %g" % (kernel.replace(";", ""), step), cells=(8, 4, 4), size=(0.016, 0.008, 0.008), step=step, end=0.04,
        write=step, nu=1e-6,
        patches={"ends": ("x- x+", "patch", "zeroGradient;", "fixedValue; value uniform 0;"),
                 "sides": ("y- y+ z- z+", "wall", "slip;", "fixedFluxPressure;")},
        scene="materials { tungsten { density 1e9; youngsModulus 1e9; } } effects { gidaspow { } pressureGradient { } } "
              "time { step %g; } insert { one { type list; diameter 1e-3; velocity (0.1 0 0); "
              "positions ((0.0061 0.0041 0.0039)); } } coupling { rho 1000; kernel %s; }" % (step, kernel))
    if not case.ends(c, kernel):
        return None
    # without the first 10 ms, the transient of the start
    p = [case.field(f"{time}/p") for time in case.times() if float(time) > 0.01 - 0.5*step]
    return max(fluid.largest(now - before) for before, now in zip(p, p[1:]))


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
