"""Particles with a very short response time follow the fluid without overshoot, and exchange
momentum exactly.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import math
import re
import fluid
HARD = "steps of a thousand and more response times"
FLOW = (1.0, 0.5, -0.25)
TIMES = (0.01, 1, 10)                                      # step over response time


def off(frame):
    return max(math.dist(p.v, FLOW) for p in frame.particles.values())


def check(c):
    for ratio, step in ((1e3, 1e-5), (1e5, 1e-3)):
        run = c.run("scene.dem", {"time/step": step, "time/end": 100*step,
                                  "write/interval": 10*step}, name="uniform%g" % ratio)
        if c.runs_to_end(run):
            c.below("uniform, step %.0e times the response: |v - u|, m/s" % ratio,
                    max(off(f) for f in run.snapshots()[1:]), 1e-6)
    if not fluid.there():
        return c.skip("sheared flow, two-way exchange", "no demPimpleFoam")
    shear(c)
    for ratio in TIMES:
        exchange(c, ratio)


def shear(c):
    """Given velocity u = y/s; a fluid step of 1e5 response times."""
    n, side = 10, 0.02
    case = fluid.Case(
        c, "shear", cells=(n, n, n), size=(side, side, side), step=1e-3, end=0.01, write=1e-3, nu=138.888888889,
        patches={"sides": (fluid.ALL, "patch", "zeroGradient;", "zeroGradient;")},
        functions='particles { type demCloud; libs ("libdemCoupling.so"); }',
        scene="materials { glass { density 2500; youngsModulus 1e6; } } effects { stokesDrag { } } "
              "time { step 1e-5; } insert { some { type list; diameter 1e-4; "
              "positions ((0.005 0.0131 0.01) (0.01 0.0075 0.009)); } } coupling { rho 1; twoWay no; kernel linear; }")
    cells = " ".join("(%.17g 0 0)" % (side*(j + 0.5)/n) for k in range(n) for j in range(n) for i in range(n))
    case.sub("0/U", "uniform [^;]*", f"nonuniform List<vector> {n**3} ({cells})", 1)
    case.initial("T", "0 0 0 1 0 0 0", 0, "sides { type zeroGradient; }")
    case.sub("system/fvSchemes", re.escape("div(alphaPhi,U)"), "div(phi,T) Gauss upwind; div(alphaPhi,U)")
    case.sub("system/fvSolution", '"p.*"',
             'T { solver PBiCGStab; preconditioner DILU; tolerance 1e-6; relTol 0; }\n    "p.*"', 1)
    case.edit("constant/transportProperties", DT=0)
    if case.ends(c, "shear", "scalarTransportFoam"):
        rows = [row for time in case.times() for row in case.particles(time, "positions", "U")]
        c.below("shear of 1/s, fluid step 1e5 times the response time: |v - u|, m/s",
                max(math.dist(row[4:7], (row[2], 0.0, 0.0)) for row in rows), 1e-6)


def exchange(c, ratio):
    """Particles of 2 g in all at 1 m/s, uniform in 1 g of fluid at rest, in a periodic box: v = 2/3
    + 1/3 exp(-3 t/tau) m/s."""
    places = " ".join("(%.9g %.9g %.9g)" % tuple(0.005 + 0.01*i for i in (k % 10, k//10 % 10, k//100))
                      for k in range(1000))
    case = fluid.Case(
        c, "exchange%g" % ratio, cells=(2, 2, 2), size=(0.1, 0.1, 0.1), step=1e-3, end=0.02, write=1e-3,
        nu=ratio*2e-6/(3.0*math.pi*1e-3*1e-3),
        scene="materials { m { density %.17g; youngsModulus 1e6; } } effects { stokesDrag { } pressureGradient { } } "
              "time { step 1e-3; } insert { all { type list; diameter 1e-3; velocity (1 0 0); positions (%s); } } "
              "coupling { rho 1; }" % (2e-6/(math.pi/6*1e-9), places))
    case.sub("system/fvSolution", "nOuterCorrectors 1", "nOuterCorrectors 40")
    if not case.ends(c, "exchange"):
        return
    what = "two-way, step %g times the response time: " % ratio
    # linear solver of 1e-11
    c.below(what + "change of momentum, relative", fluid.largest(case.numbers(r"sum \((\S+) ")/2e-3 - 1.0), 1e-8)
    fast = [case.particles(time, "U")[:, 1].mean() for time in case.times()]
    c.holds(what + "velocities stay between 0 and the initial one (%.3f %.3f %.3f ...)" %
            tuple(fast[:3]), all(-1e-3 <= v <= 1.0 for v in fast), str(fast))
    c.near(what + "velocity after 20 steps, m/s", fast[-1], 2.0/3.0 + math.exp(-3.0*20*ratio)/3.0,
           0.01)
