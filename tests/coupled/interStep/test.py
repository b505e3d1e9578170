"""The adjusted time step of demInterFoam.

- With surface tension at rest: the longest that resolves capillary waves, sqrt((rho1 + rho2) h^3/(4 pi sigma)).
- In a uniform flow through the interface: the fluid that leaves a cell in a sub-cycle, with the compression, 1.25 u T/h,
  is half of the fluid in it.

SPDX-License-Identifier: GPL-3.0-or-later
"""
from two_fluids import *

h, sigma, u = 1e-3, 0.07, 0.1
material, laws = "grain { density 2500; youngsModulus 1e5; }", "stokesDrag {}"


def adjusted(case, insert):
    """The last steps and what limits them."""
    case.edit("system/controlDict", adjustTimeStep="yes", maxDeltaT=1, maxCo=10, maxParticleCo=100)
    case.grains(material, laws, insert, "kernel linear;", "time { step 1e-5; }")
    case.run("demInterFoam")
    return case.numbers("^deltaT = (.*)$", "demInterFoam")[-1, 0], case.found("time step limited by (.*)", "demInterFoam")[1]


frozen = "grain {{ type list; diameter 1e-5; frozen yes; positions (({0} {0} {0})); }}".format(h/2)

case = TwoFluids("tension")
case.controls(0.02, 1e-4)
case.fluids(sigma=sigma, tolerance=1e-12)
case.box((4*h, 4*h, 8*h), (4, 4, 8), {"walls": ("wall", "x- x+ y- y+ z- z+")})
case.fields(("walls",))
case.alpha(lambda x: x[:, 2] < 4*h)
step, limit = adjusted(case, frozen)
claim_ran("tension: runs", case, "demInterFoam")
theory = math.sqrt((WATER[0] + AIR[0])*h**3/(4*math.pi*sigma))
claim(f"tension: the step is {theory*1e3:.4f} ms (the last one ends at the end time)",
      close(step, theory, 0.06) and step <= theory*(1 + 1e-9), step, theory)
claim("tension: the log names maxCapillaryCo", limit.startswith("maxCapillaryCo"), limit)

# Two ranks have every other cell, so none has two neighbors
case.dictionary("constant/cellRanks", "128 (" + " ".join(
    str((i + j + k) % 2) for k in range(8) for j in range(4) for i in range(4)) + ")", "labelList")
case.dictionary("system/decomposeParDict", 'numberOfSubdomains 2; method manual; coeffs { dataFile "cellRanks"; }')
case.run("decomposePar")
claim_runs("tension, two ranks without faces inside: runs", case, "demInterFoam", ranks=2)
claim("tension, two ranks: the same steps",
      lambda: close(case.numbers("^deltaT = (.*)$", "demInterFoam")[-1, 0], step, 1e-9))

case = TwoFluids("flow")
case.controls(0.05, 1e-4)
case.fluids((1000, 1e-9), (1000, 1e-9), gravity="(0 0 0)", tolerance=1e-12, sub_cycles=2)
case.box((16*h, 2*h, 2*h), (16, 2, 2), {"walls": ("wall", "y- y+ z- z+")}, cyclic="x")
case.fields(("walls",), slip=True)
case.sub("0/U", r"uniform \(0 0 0\)", f"uniform ({u} 0 0)")
case.alpha(lambda x: abs(x[:, 0] - 8*h) < 4*h)
step, limit = adjusted(case, frozen)
claim_ran("flow: runs", case, "demInterFoam")
theory = 2*0.5*h/u/1.25
claim(f"flow: the step is {theory*1e3:.2f} ms", close(step, theory, 0.06) and step <= theory*(1 + 1e-6), step, theory)
claim("flow: the log names maxAlphaCo", limit.startswith("maxAlphaCo"), limit)
finish()
