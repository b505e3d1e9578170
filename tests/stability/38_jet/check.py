"""A jet of 50 m/s into a settled bed: no particle is lost, inflow equals outflow, the momentum
balance closes.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import fluid
HARD = "a jet into a bed"


def check(c):
    if not fluid.there():
        return c.skip("a jet", "no demPimpleFoam")
    end = 1.0 if c.long else 0.05
    n = 8
    jet = "fixedValue; value nonuniform List<vector> %d ( %s );" % (n*n, " ".join(
        "(0 0 %d)" % (50 if i in (3, 4) and j in (3, 4) else 0) for j in range(n) for i in range(n)))
    case = fluid.Case(
        c, "jet", cells=(n, n, 20), size=(0.04, 0.04, 0.1), step=2e-5, end=end, g=(0, 0, -9.81), nu=1.5e-5,
        patches={"floor": ("z-", "patch", jet, "fixedFluxPressure;"),
                 "top": ("z+", "patch", "zeroGradient;", "fixedValue; value uniform 0;"),
                 "sides": ("x- x+ y- y+", "wall", "slip;", "fixedFluxPressure;")},
        scene=fluid.BED + "insert { all { type lattice; count 2000; spacing 1; jitter 0; diameter 2e-3; min (0 0 0); "
              "max (0.04 0.04 0.02); } } materials { m { density 2500; youngsModulus 1e6; } } "
              "coupling { rho 1.2; walls ( floor top ); record { interval %g; budget yes; } }" % (end/50))
    case.edit("system/controlDict", writeControl="adjustable", adjustTimeStep="yes", maxCo=0.5, maxDeltaT=1e-4)
    if not case.ends(c, "jet"):
        return
    tables = "postProcessing/dem/0/"
    c.equal("particles at the end", len(case.field("%g/lagrangian/particles/id" % end)), 2000)
    c.holds("no particle lost", not (case/(tables + "lost.csv")).exists())
    last = {name: column[-1] for name, column in case.table(tables + "budget.csv").items()}
    flow_in, flow_out = last["flow:floor.volume"], last["flow:top.volume"]
    c.below("inflow less outflow of gas, over the inflow", abs(flow_in + flow_out)/flow_in, 1e-6)
    gains = [abs(v) for k, v in last.items() if k.endswith(".pz") and not k.startswith("rest")]
    c.below("residual of momentum along z, over the largest gain", abs(last["rest.pz"])/max(gains), 0.01)
    c.below("exchange error", case.worst("exchange error"), 1e-12)
