"""coupled.py -- the cases with a fluid, 30 to 37, in DPMFoam (icoUncoupledKinematicParcelFoam for
one-way coupling).

Scenes and criteria come from ../NN_name/check.py; each case notes its differences.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import math

from dpm import Dpm

WALL = ("wall", "noSlip;", "fixedFluxPressure; phi phi.air; value uniform 0;")
SLIP = ("wall", "slip;", "fixedFluxPressure; phi phi.air; value uniform 0;")


def ended(c, case, what):
    good = case.run()
    if not good:
        c.row(what + ": runs to its end", "no", False, case.complaint())
    return good


def small_stokes(c):
    """Particles with a very short response time; two-way, 2 g of particles in 1 g of fluid."""
    flow = (1.0, 0.5, -0.25)
    for ratio, step in ((1e3, 1e-5), (1e5, 1e-3)):
        for scheme in ("Euler", "analytical"):
            case = Dpm(c.place("uniform%g%s" % (ratio, scheme)),
                solver="icoUncoupledKinematicParcelFoam", coupled="false", integration=scheme,
                cells=(4, 4, 4), size=(0.4, 0.4, 0.4),
                       step=step, end=100*step, write=10*step, rho=1.0, nu=138.888888889,
                       U="uniform (%g %g %g)" % flow,
                       patches={"sides": (("x0", "x1", "y0", "y1", "z0", "z1"), "patch",
                                          "zeroGradient;", "zeroGradient;")},
                       forces="sphereDrag;", particles=dict(d=1e-4, rho=2500.0,
                           at=[(0.1, 0.1, 0.2), (0.11, 0.1, 0.2), (0.1, 0.11, 0.2)]))
            if ended(c, case, "uniform"):
                off = max(math.dist(v, flow) for k in range(1, 11)
                          for v in case.speeds("%g" % (10*k*step)))
                c.below("uniform, step %.0e times the response, %s: |v - u|, m/s" % (ratio, scheme),
                        off, 1e-6)
    for source in ("semiImplicit", "explicit"):
        for ratio in (0.01, 1, 10):
            exchange(c, ratio, source)


def exchange(c, ratio, source):
    """A hundredth of the speed of ../30_small_stokes, as its drag has a power of the Reynolds
    number; also 40 outer iterations.
Both of its schemes of momentum transfer."""
    nu, fast = ratio*2e-6/(3.0*math.pi*1e-3*1e-3), 0.01
    case = Dpm(c.place("exchange%g%s" % (ratio, source)), source=source, cells=(2, 2, 2),
        size=(0.1, 0.1, 0.1), step=1e-3, end=0.02, write=1e-3, rho=1.0, nu=nu, outer=40,
        forces="sphereDrag;",
               particles=dict(d=1e-3, rho=2e-6/(math.pi/6*1e-9), U=(fast, 0, 0),
                   at=[tuple(0.005 + 0.01*i for i in (k % 10, k//10 % 10, k//100))
                       for k in range(1000)]))
    what = "two-way, %s, step %g times the response: " % (source, ratio)
    if not ended(c, case, what):
        return
    sums, speeds = [], []
    for k in range(1, 21):
        time = "%g" % (1e-3*k)
        fluid = [r[0] for r in case.field(time, "U.air")]
        fluid = fluid if len(fluid) == 8 else fluid*8
        grains = [v[0] for v in case.speeds(time)]
        sums.append(sum(a*u for a, u in zip(case.fraction(time), fluid))*1e-3/8 + sum(grains)*2e-6)
        speeds.append(sum(grains)/len(grains)/fast)
    c.below(what + "change of momentum, relative", max(abs(s/(2e-3*fast) - 1.0) for s in sums),
            1e-8)
    c.holds(what + "particles stay between rest and start", all(-1e-3 <= v <= 1.0 for v in speeds),
            "%.3f %.3f %.3f ... of the first speed" % tuple(speeds[:3]))
    c.near(what + "velocity after 20 steps over the first", speeds[-1],
           2.0/3.0 + math.exp(-60.0*ratio)/3.0, 0.01)


def light(c):
    """A sphere of 2 mm in water, with added mass; Putnam's drag is within 1 % of Schiller and
    Naumann's there."""
    for density, rise in ((1.2, 0.20823), (500.0, 0.13555), (990.0, 0.010018), (1010.0, -0.010018)):
        case = Dpm(c.place("%g" % density), solver="icoUncoupledKinematicParcelFoam",
            coupled="false", cells=(2, 2, 20), size=(0.1, 0.1, 2.0), step=1e-3, end=4, write=0.1,
            rho=1000.0,
                   nu=1e-6, g=(0, 0, -9.81), patches={"sides": (("x0", "x1", "y0", "y1", "z0",
                       "z1"), "patch", "zeroGradient;", "zeroGradient;")},
                   forces="sphereDrag; gravity; virtualMass { Cvm 0.5; U U; }",
                   particles=dict(d=2e-3, rho=density, at=[(0.04, 0.04,
                       1.0 - 0.9*math.copysign(1, rise))]))
        if ended(c, case, "density ratio %g" % (density/1000)):
            v = [case.speeds("%g" % (0.1*k))[0][2] for k in range(1, 41)]
            c.near("density ratio %g: speed upwards at last, m/s" % (density/1000), v[-1], rise,
                   0.05*abs(rise))
            c.below("... largest on the way, over it", max(x/rise for x in v), 1.05)


def packing(c):
    """1000 spheres of 1 mm with their centres in one cell of 8 mm: 1.02 of it; so heavy that they
    stay."""
    at = [tuple(0.0084 + 0.8e-3*i for i in (k % 10, k//10 % 10, k//100)) for k in range(1000)]
    case = Dpm(c.place("run"), cells=(4, 3, 3), size=(0.032, 0.024, 0.024), step=1e-3, end=0.005,
               rho=1000.0, nu=1e-5, particles=dict(d=1e-3, rho=1e12, at=at),
               forces="ErgunWenYuDrag { alphac alpha.air; } pressureGradient { U U.air; }",
               patches={"ends": (("x0", "x1"), "patch", "fixedValue; value uniform (0.01 0 0);",
                   "fixedValue; value uniform 0;"), "sides": (("y0", "y1", "z0", "z1"),) + SLIP})
    if not ended(c, case, "run"):
        return
    e = case.fraction("0.005")
    solid, wanted = sum(1.0 - x for x in e)*512e-9, 1000*math.pi/6.0*1e-9
    c.below("error of the solid volume, relative", abs(solid/wanted - 1.0), 1e-12)
    c.holds("least void fraction at or above its stated minimum, 0.01", min(e) >= 0.01 - 1e-12,
            "%.4g" % min(e))
    c.below("largest pressure, m2/s2", max(abs(r[0]) for r in case.field("0.005", "p")), 100.0)
    c.holds("reported, with the number of cells", "alpha" in case.log and "clip" in case.log.lower(),
            "no word of it in the log")


def cell_sizes(c):
    """Drag in the first 20 ms on a sphere too heavy to follow, on cells from five diameters to a
    fifth of a diameter."""
    d, found = 2e-3, {}
    for per in (0.2, 1, 2, 5):
        n = round(0.01/(d/per))
        case = Dpm(c.place("d%g" % per), cells=(2*n, n, n), size=(0.02, 0.01, 0.01), step=1e-3,
            end=0.02, rho=1.2, nu=1e-5, U="uniform (0.1 0 0)",
            forces="sphereDrag; pressureGradient { U U.air; }",
                   particles=dict(d=d, rho=1e12, at=[(0.0093, 0.0052, 0.0049)]),
                   patches={"inlet": (("x0",), "patch", "fixedValue; value uniform (0.1 0 0);",
                       "zeroGradient;"), "outlet": (("x1",), "patch", "zeroGradient;",
                           "fixedValue; value uniform 0;"),
                            "sides": (("y0", "y1", "z0", "z1"),) + SLIP})
        what = "cells of %.3g diameters" % (1.0/per)
        if ended(c, case, what):
            found[per] = case.speeds("0.02")[0][0]
            solid = sum(1.0 - x for x in case.fraction("0.02"))*2e-6/(2*n**3)
            c.below(what + ": error of the solid volume, relative",
                    abs(solid/(math.pi/6.0*d**3) - 1.0), 1e-12)
    for per in (1, 2, 5):
        if per in found and 0.2 in found:
            c.below("cells of %.3g diameters: change of drag against cells of 5" % (1.0/per),
                    abs(found[per]/found[0.2] - 1.0), 0.2)


def moving(c):
    """A sphere half as wide as a cell crosses faces."""
    jumps = []
    for step in (2e-3, 1e-3, 5e-4):
        case = Dpm(c.place("%g" % step), cells=(8, 4, 4), size=(0.016, 0.008, 0.008), step=step,
                   end=0.04, write=step, rho=1000.0, nu=1e-6,
                   forces="ErgunWenYuDrag { alphac alpha.air; } pressureGradient { U U.air; }",
                   particles=dict(d=1e-3, rho=1e9, U=(0.1, 0, 0), at=[(0.0061, 0.0041, 0.0039)]),
                   patches={"ends": (("x0", "x1"), "patch", "zeroGradient;",
                       "fixedValue; value uniform 0;"), "sides": (("y0", "y1", "z0", "z1"),) +
                       SLIP})
        if not ended(c, case, "step %g" % step):
            return
        rows = [[r[0] for r in case.field("%.9g" % (k*step), "p")]
                for k in range(round(0.01/step), round(0.04/step) + 1)]
        jumps.append(max(abs(a - b) for now, before in zip(rows[1:], rows)
                         for a, b in zip(now, before)))
    c.below("largest jump of pressure from step to step, halving the step: ratio",
            jumps[1]/jumps[0], 1.0, "%.3g, %.3g, %.3g m2/s2" % tuple(jumps))
    c.below("halving again", jumps[2]/jumps[1], 1.0)


def interval(c):
    """A settling sphere; steps of the fluid of 10, 100 and 1000 times 50 us. Without contacts its
    particles have the fluid's step."""
    found, log = {}, ""
    for n in (10, 100, 1000):
        case = Dpm(c.place("every%d" % n), cells=(4, 4, 4), size=(0.04, 0.04, 0.04), step=n*5e-5,
                   end=0.1, g=(0, 0, -9.81), rho=10.0, nu=1e-5, integration="analytical",
                   forces="WenYuDrag { alphac alpha.air; } gravity; pressureGradient { U U.air; }",
                   particles=dict(d=1e-4, rho=3000.0, at=[(0.0193, 0.0207, 0.0305)]),
                   patches={"walls": (("x0", "x1", "y0", "y1", "z0"),) + WALL,
                            "top": (("z1",), "patch",
                                "pressureInletOutletVelocity; phi phi.air; value uniform (0 0 0);",
                                "fixedValue; value uniform 0;")})
        if ended(c, case, "every %d" % n):
            found[n], log = case.speeds("0.1")[0][2], case.log
    if len(found) == 3:
        c.below("settling speed, every 100 steps against every 10", abs(found[100]/found[10] - 1.0),
                0.01)
        c.below("every 1000: speed against that", abs(found[1000]/found[10] - 1.0), 0.1)
        c.holds("every 1000 steps, three times the response time: reported",
                "response" in log or "relaxation" in log.lower(), "no word of it in the log")
