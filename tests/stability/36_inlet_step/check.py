"""Gas enters at 20 m/s at once, or within 50 ms: both runs stay bounded, the step adapts, and the
bed keeps its weight.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import os
import sys
sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), ".."))
import fluid                                                 # noqa: E402
HARD = "an inlet that opens in one step"


def bed(c, name, inlet):
    case = fluid.Case(c, name, cells=(5, 5, 24), size=(0.1, 0.1, 0.48), step=1e-4, end=0.4, write=0.4,
                      g=(0, 0, -9.81), nu=1.5e-5,
                      patches={"inlet": (("z0",), "patch", inlet, "fixedFluxPressure;"),
                               "outlet": (("z1",), "patch", "zeroGradient;",
                                          "fixedValue; value uniform 0;"),
                               "sides": (("x0", "x1", "y0", "y1"), "wall", "slip;",
                                         "fixedFluxPressure;")},
                      control="adjustTimeStep yes; maxCo 0.5; maxDeltaT 1e-3;\nfunctions { drop { type surfaceFieldValue; libs (\"libfieldFunctionObjects.so\"); regionType patch; "
                              "name inlet; operation areaAverage; fields (p); writeFields no; writeControl timeStep; log no; } }",
                      scene="materials { m { density 20000; youngsModulus 2e7; } } effects { gravity { acceleration (0 0 -9.81); } hertz { impactSpeed 5; } dry { restitution 0.8; } mindlin { friction 0.3; }\n"
                            "gidaspow { } pressureGradient { } } insert { all { type lattice; count 300; spacing 1; jitter 0; diameter 1.5e-2; min (0 0 0); max (0.1 0.1 0.16); } }\n"
                            "coupling { rho 1.2; walls ( inlet outlet ); }")
    if not case.run():
        c.holds(name + ": runs", False, case.log)
        return None
    c.below(name + ": largest final speed of a particle, m/s",
            max(max(map(abs, v)) for _, v in case.particles("0.4").values()), 5.0)
    steps = case.numbers("deltaT =")
    c.holds(name + ": the step adapts, %.2g to %.2g s" % (min(steps), max(steps)),
            min(steps) < 0.5*max(steps))
    courant = case.numbers("max:")[10:]
    c.below(name + ": largest Courant number after the first steps (limit 0.5)",
            max(courant) if courant else float("nan"), 1.0)
    rows = []
    with open(os.path.join(case.folder, "postProcessing/drop/0/surfaceFieldValue.dat")) as file:
        rows = [tuple(map(float, line.split())) for line in file if not line.startswith("#")]
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
