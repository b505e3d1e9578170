"""Gravity along cyclic patches: water, air and grains between two plates without friction are a chute without end.
They slide down it by the component of gravity along it, all momentum is the weight in air times time, and no fluid is
lost.

SPDX-License-Identifier: GPL-3.0-or-later
"""
from two_fluids import *

down, upright, end = 1.7, -9.66, 0.05
length, across, height, surface, count, d, density = 0.06, 0.006, 0.06, 0.03, 64, 1e-3, 2500
places = [(x, y, z) for x in 0.00375 + 0.0075*np.arange(8) for y in (0.0015, 0.0045)
          for z in (0.006, 0.01, 0.014, 0.018)]


def chute(name, ranks=1, insert=f"grains {{ type list; diameter {d}; positions ({' '.join(map(vector, places))}); }}"):
    case = TwoFluids(name)
    case.controls(end, 5e-4)
    case.fluids(gravity=f"({down} 0 {upright})", tolerance=1e-13, outer=2)
    case.box((length, across, height), (20, 2, 20), {"plates": ("wall", "y- y+ z- z+")}, cyclic="x")
    case.fields(("plates",), slip=True)
    case.alpha(lambda x: x[:, 2] < surface)
    case.grains(f"grain {{ density {density}; youngsModulus 1e6; }}", "hertz {} dry { restitution 0.5; } "
                "schillerNaumann {} virtualMass {}", insert, "record { interval 5e-4; budget yes; }",
                "walls { plates { material grain; } }")
    if ranks > 1:    # the cyclic patches go to processor patches
        case.dictionary("system/decomposeParDict", "numberOfSubdomains 2; method simple; "
                        "simpleCoeffs { n (2 1 1); delta 1e-3; }")
        case.run("decomposePar")
    claim_runs(f"{name}: runs", case, "demInterFoam", ranks=ranks)
    return case


def keeps(name, case):
    claim(f"{name}: no water is lost (1e-12)", case.kept() < 1e-12, case.kept())
    table = case.table("postProcessing/dem/0/budget.csv")
    terms = max(largest(table[term]) for term in table if term.endswith(".px"))
    claim(f"{name}: momentum along the chute closes (1e-10 of the largest term)",
          largest(table["rest.px"]) < 1e-10*terms, largest(table["rest.px"]), terms)
    return table


one = "stone { type list; diameter 1e-3; positions ((0.03 0.003 0.05)); }"
case = chute("fluids", insert=one)
keeps("fluids", case)
# the stone is in the air: the water below it slides as if alone
water = case.centres()[:, 2] < 0.015
U = case.interior("U")[water]
slide = (1 - AIR[0]/WATER[0])*down*end
claim("fluids: the water slides with (1 - density of air/water) g t (1e-5)", largest(U[:, 0]/slide - 1) < 1e-5,
      U[:, 0].min(), U[:, 0].max(), slide)
tables = []
for ranks in (1, 2):
    name = f"grains on {ranks} rank{'s'*(ranks > 1)}"
    case = chute(name.replace(" ", "_"), ranks)
    table = keeps(name, case)
    grains = len(places)*math.pi/6*d**3
    fluids = 0.5*length*across*height*(WATER[0] + AIR[0]) - grains*WATER[0]
    weight = (fluids + grains*density - AIR[0]*length*across*height)*down*end
    moved = case.vectors("sum", "momentum", "demInterFoam")[-1, 0]
    claim(f"{name}: momentum is weight times time (1e-6)", close(moved, weight, 1e-6), moved, weight)
    tables.append(table)
speeds = tables[0]["particles.px"][-1], tables[1]["particles.px"][-1]
claim("both numbers of ranks agree (1e-8)", close(*speeds, 1e-8), *speeds)

# p_rgh of interFoam cannot hold this gravity
case.for_stock()
case.remove("0.*", "processor*", "postProcessing")
case.sub("constant/demProperties", "budget yes;", "")
case.append("system/controlDict", function_object)
run = case.run("interFoam")
claim("interFoam with the function object: refused", run.status not in (0, 124) and
      "constant/g has the part (1.7 0 0) m/s2 along cyclic patches" in " ".join(run.log.split()), run.log[-1500:])
finish()
