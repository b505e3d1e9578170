"""Particles follow a fluid that they answer to at once, without overshoot, and give it their momentum and no more. SPDX-License-Identifier: GPL-3.0-or-later"""
import math
import os
import sys
sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), ".."))
import fluid                                                 # noqa: E402
HARD = "steps a thousand and more times the time of response"
FLOW = (1.0, 0.5, -0.25)
# reference tables D9: a particle of 2e-3 kg at 1 m/s in a parcel of 1e-3 kg at rest, velocities after a step of so many times of response
EXACT = {0.01: (0.99014851, 0.019702978), 1: (0.68326236, 0.63347529), 1000: (0.66666667, 0.66666667)}


def off(frame):
    return max(math.dist(p.v, FLOW) for p in frame.particles.values())


def check(c):
    for ratio, step in ((1e3, 1e-5), (1e5, 1e-3)):
        run = c.run("scene.dem", {"time/step": step, "time/end": 100*step, "write/interval": 10*step}, name="uniform%g" % ratio)
        if c.runs_to_end(run):
            c.below("uniform, step %.0e times the response: |v - u|, m/s" % ratio, max(off(f) for f in run.snapshots()[1:]), 1e-6)
    if not fluid.there():
        return c.skip("sheared flow, two-way exchange", "no demPimpleFoam")
    shear(c)
    for ratio, (particle, parcel) in EXACT.items():
        exchange(c, ratio, particle, parcel)


def shear(c):
    """u = y/s, given; a fluid step of 1e5 responses."""
    n, side = 10, 0.02
    cells = "nonuniform List<vector> %d ( %s )" % (n**3, " ".join("(%.17g 0 0)" % (side*(j + 0.5)/n) for k in range(n) for j in range(n) for i in range(n)))
    case = fluid.Case(c, "shear", cells=(n, n, n), size=(side, side, side), step=1e-3, end=0.01, write=1e-3, U=cells, nu=138.888888889,
                      patches={"sides": (("x0", "x1", "y0", "y1", "z0", "z1"), "patch", "zeroGradient;", "zeroGradient;")},
                      control='functions { particles { type demCloud; libs ("libdemCoupling.so"); } }',
                      scene="materials { glass { density 2500; youngsModulus 1e6; } } effects { stokesDrag { } } time { step 1e-5; }\n"
                            "insert { some { type list; diameter 1e-4; positions ((0.005 0.0131 0.01) (0.01 0.0075 0.009)); } } coupling { rho 1; twoWay no; kernel linear; }")
    case.file("volScalarField", "0/T", "dimensions [0 0 0 1 0 0 0]; internalField uniform 0; boundaryField { sides { type zeroGradient; } }")
    case.edit("system/fvSchemes", "div(alphaPhi,U)", "div(phi,T) Gauss upwind; div(alphaPhi,U)")
    case.edit("system/fvSolution", '"p.*"', 'T { solver PBiCGStab; preconditioner DILU; tolerance 1e-6; relTol 0; }\n    "p.*"')
    case.edit("constant/transportProperties", "transportModel", "DT 0; transportModel")
    if not case.run("scalarTransportFoam"):
        return c.holds("shear: runs", False, case.log)
    worst = 0.0
    for k in range(1, 11):
        for x, v in case.particles("%g" % (1e-3*k)).values():
            worst = max(worst, math.dist(v, (x[1], 0.0, 0.0)))
    c.below("shear of 1/s, fluid step 1e5 times the response: |v - u|, m/s", worst, 1e-6)


def exchange(c, ratio, particle, parcel):
    """One particle in a periodic box that moves as one parcel: so thick that its cells have one velocity."""
    density = 2e-3/(math.pi/6*1e-9)
    nu = ratio*1e-3**2*density/18.0/1e-3
    case = fluid.Case(c, "exchange%g" % ratio, cells=(2, 2, 2), size=(0.1, 0.1, 0.1), step=1e-3, end=0.02, write=1e-3, nu=nu,
                      scene="materials { m { density %.17g; youngsModulus 1e6; } } effects { stokesDrag { } } time { step 1e-3; }\n"
                            "insert { one { type list; diameter 1e-3; positions ((0.05 0.05 0.05)); velocity (1 0 0); } } coupling { rho 1; }" % density)
    if not case.run():
        return c.holds("exchange: runs", False, case.log)
    what = "two-way, step %g times the response: " % ratio
    seen = []
    for k in range(1, 21):
        (x, v), = case.particles("%g" % (1e-3*k)).values()
        u = case.field("%g" % (1e-3*k), "U")
        seen.append((v[0], sum(r[0] for r in u)/len(u)))
    c.near(what + "sum of momentum at last, kg m/s", 2e-3*seen[-1][0] + 1e-3*seen[-1][1], 2e-3, 1e-3*2e-3)
    c.holds(what + "between start and balance all the time (%.4f after a step; exact %.4f)" % (seen[0][0], particle),
            all(2.0/3.0 - 0.01 <= v <= 1.0 for v, _ in seen), str(seen[:4]))
