"""A jet of 50 m/s into a settled bed: no particle is lost, inflow equals outflow, the momentum
balance closes.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import os
import sys
sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), ".."))
import fluid                                                 # noqa: E402
HARD = "a jet into a bed"


def check(c):
    if not fluid.there():
        return c.skip("a jet", "no demPimpleFoam")
    end = 1.0 if c.long else 0.05
    n = 8
    jet = "fixedValue; value nonuniform List<vector> %d ( %s );" % (n*n,
        " ".join("(0 0 %d)" % (50 if i in (3, 4) and j in (3, 4) else 0) for j in range(n)
                 for i in range(n)))
    case = fluid.Case(c, "jet", cells=(n, n, 20), size=(0.04, 0.04, 0.1), step=2e-5, end=end,
                      write=end, g=(0, 0, -9.81), nu=1.5e-5,
                      patches={"floor": (("z0",), "patch", jet, "fixedFluxPressure;"),
                               "top": (("z1",), "patch", "zeroGradient;",
                                       "fixedValue; value uniform 0;"),
                               "sides": (("x0", "x1", "y0", "y1"), "wall", "slip;",
                                         "fixedFluxPressure;")},
                      control="adjustTimeStep yes; maxCo 0.5; maxDeltaT 1e-4;",
                      scene="materials { m { density 2500; youngsModulus 1e6; } } effects { gravity { acceleration (0 0 -9.81); } hertz { impactSpeed 5; } dry { restitution 0.8; } mindlin { friction 0.3; }\n"
                            "gidaspow { } pressureGradient { } } insert { all { type lattice; count 2000; spacing 1; jitter 0; diameter 2e-3; min (0 0 0); max (0.04 0.04 0.02); } }\n"
                            "coupling { rho 1.2; walls ( floor top ); record { interval %g; budget yes; } }" % (end/50))
    if not case.run():
        return c.holds("runs", False, case.log)
    c.equal("particles at the end", len(case.particles("%g" % end)), 2000)
    c.holds("no particle lost", not os.path.exists(os.path.join(case.folder,
        "postProcessing/dem/0/lost.csv")))
    last = case.table("budget.csv")[-1]
    flow_in, flow_out = last["flow:floor.volume"], last["flow:top.volume"]
    c.below("inflow less outflow of gas, over the inflow", abs(flow_in + flow_out)/flow_in, 1e-6)
    for axis in "pz",:
        gains = [abs(v) for k, v in last.items() if k.endswith("." + axis)
                 and not k.startswith("rest")]
        c.below("residual of momentum along z, over the largest gain",
                abs(last["rest." + axis])/max(gains), 0.01)
    c.below("exchange error", case.worst("exchange error"), 1e-12)
