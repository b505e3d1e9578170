"""Gas enters at 20 m/s at once, or within 50 ms: both runs stay bounded, the step adapts, and the
bed keeps its weight.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import fluid
HARD = "an inlet that opens in one step"


def bed(c, name, inlet):
    case = fluid.Case(
        c, name, cells=(5, 5, 24), size=(0.1, 0.1, 0.48), step=1e-4, end=0.4, g=(0, 0, -9.81), nu=1.5e-5,
        patches={"inlet": ("z-", "patch", inlet, "fixedFluxPressure;"),
                 "outlet": ("z+", "patch", "zeroGradient;", "fixedValue; value uniform 0;"),
                 "sides": ("x- x+ y- y+", "wall", "slip;", "fixedFluxPressure;")},
        functions='drop { type surfaceFieldValue; libs ("libfieldFunctionObjects.so"); regionType patch; name inlet; '
                  "operation areaAverage; fields (p); writeFields no; writeControl timeStep; log no; }",
        scene=fluid.BED + "insert { all { type lattice; count 300; spacing 1; jitter 0; diameter 1.5e-2; min (0 0 0); "
              "max (0.1 0.1 0.16); } } materials { m { density 20000; youngsModulus 2e7; } } "
              "coupling { rho 1.2; walls ( inlet outlet ); }")
    case.edit("system/controlDict", writeControl="adjustable", adjustTimeStep="yes", maxCo=0.5, maxDeltaT=1e-3)
    if not case.ends(c, name):
        return None
    c.below(name + ": largest final speed of a particle, m/s", fluid.largest(case.particles("0.4", "U")[:, 1:]), 5.0)
    steps = case.numbers(r"deltaT = (\S+)")
    c.holds(name + ": the step adapts, %.2g to %.2g s" % (steps.min(), steps.max()), steps.min() < 0.5*steps.max())
    c.below(name + ": largest Courant number after the first steps (limit 0.5)",
            case.numbers(r"^Courant Number .*max: (\S+)")[5:].max(), 1.0)
    rows = [tuple(map(float, line.split())) for line in case.read("postProcessing/drop/0/surfaceFieldValue.dat").splitlines()
            if not line.startswith("#")]
    late = [(t, p) for t, p in rows if t > 0.2]
    return 1.2*sum(p*(t - s) for (s, _), (t, p) in zip(late, late[1:]))/(late[-1][0] - late[0][0])


def check(c):
    if not fluid.there():
        return c.skip("an inlet that opens", "no demPimpleFoam")
    step = bed(c, "at once", "fixedValue; value uniform (0 0 20);")
    ramp = bed(c, "in 50 ms",
        "uniformFixedValue; uniformValue table ((0 (0 0 0)) (0.05 (0 0 20)) (10 (0 0 20))); value uniform (0 0 0);")
    if step and ramp:
        c.near("mean pressure drop at once over 50 ms' (%.0f Pa)" % ramp, step/ramp, 1.0,
               0.03)
