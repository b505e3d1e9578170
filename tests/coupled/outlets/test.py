"""Beads that cross an outlet and are deflected beyond it, within one step of the fluid, have left, although their
final velocity does not point to the patch.

In demPimpleFoam and by function object in simpleFoam, on one rank and on two; a long run has 10^6 beads, and
pimpleFoam. Beads sent aside at the inlet stay in the duct. Beads that roll off the ground where it ends with the mesh
have left, in cells of any size.

SPDX-License-Identifier: GPL-3.0-or-later
"""
from case import *

flows, lost = "postProcessing/dem/0/flows.csv", "postProcessing/dem/0/lost.csv"
rate, least = ("1e7", 1e6) if thorough else ("20000", 2500)


def left(case):
    """The number of beads that have left."""
    table = case.table(flows)
    return table["particles"][np.array(table["name"]) == "out"][-1]


def exits(solver):
    """More than the least number of beads have left, none is lost."""
    case = Case(solver)
    case.write("constant/rate", f"rate {rate};\n")
    steps = 100
    if thorough:
        # this many enter near the outlet; otherwise most of the work is their way to it
        case.sub("constant/demProperties", "youngsModulus 1e6", "youngsModulus 2e5")
        case.sub("constant/demProperties", "patch inlet;", "min (0.034 0.001 0.001); max (0.038 0.019 0.019);")
        steps = 55
    if solver != "demPimpleFoam":
        case.write("system/functionObject", function_object)
    if solver == "simpleFoam":
        case.sub("constant/demProperties", "rho 1;", "rho 1; interval 0.002;")
        case.sub("system/fvSchemes", "default Euler", "default steadyState")
        case.sub("system/fvSolution", "^PIMPLE",
                 "relaxationFactors { equations { U 0.7; } fields { p 0.3; } }\nSIMPLE")
    deltaT = 1 if solver == "simpleFoam" else 0.002
    case.edit("system/controlDict", deltaT=deltaT, endTime=f"{steps*deltaT:g}", writeInterval=f"{steps*deltaT:g}")
    case.run("blockMesh")
    case.run(solver)
    claim_ran(f"{solver}: runs", case, solver)
    claim(f"{solver}: more than {least:g} beads have left", left(case) > least, f"{left(case):g} have left")
    claim(f"{solver}: no bead is lost", not (case/lost).exists())
    return case


def on_two_ranks(case):
    case.remove("postProcessing")
    case.run("decomposePar")
    case.run("demPimpleFoam", ranks=2)


case = exits("demPimpleFoam")
alone = left(case)
on_two_ranks(case)
claim_ran("demPimpleFoam: runs on two ranks", case)
claim("demPimpleFoam: as many have left on two ranks", left(case) == alone)
exits("simpleFoam")
if thorough:
    exits("pimpleFoam")

# Beads sent aside by up to 4 m/s would fly 8 mm in the time in which they may have entered, through the sides of the
# duct.
case = Case("aside")
case.write("constant/rate", "rate 20000;\n")
case.sub("constant/demProperties", r"spread \(0.1 0 0\)", "spread (0.1 4 0)")
case.sub("constant/demProperties", "youngsModulus 1e6", "youngsModulus 1e7")
case.sub("constant/demProperties", "impactSpeed 3", "impactSpeed 5")
case.edit("system/controlDict", endTime=0.02)
case.run("blockMesh")
case.run("demPimpleFoam")
claim_ran("aside: runs", case)
entered = case.numbers("since the start ([0-9]*) particles entered, 0 left, 0 wait")
claim("aside: the 360 beads of the 18 ms before the last step have entered", entered[-1, 0] == 360)
claim("aside: no bead is lost", not (case/lost).exists())

# The duct is 25 times as large, a tenth of the way from a cell's center to the outlet 5 mm: at 0.2 m/s beads fall there
# by thirty radii. The lowest start on the ground, all 0.02 m before its end. A rank boundary runs along the ground's
# middle.
case = Case("ledge")
case.edit("system/blockMeshDict", scale=25)
case.edit("system/controlDict", endTime=0.3, deltaT=0.005)
case.write("constant/g", head("uniformDimensionedVectorField", "g") +
           "dimensions [0 1 -2 0 0 0 0]; value (0 -9.81 0);\n")
case.sub("constant/demProperties", r"^walls\n[\s\S]*?^}", "")
case.sub("constant/demProperties", "stokesDrag {}", "")
case.sub("constant/demProperties", "^insert.*", "insert { row { type lattice; diameter 2e-4; spacing 50; jitter 0; "
         "min (0.98 0 0.2); max (0.9803 2.1e-4 0.3); velocity (0.2 0 0); } }")
case.run("blockMesh")
case.run("demPimpleFoam")
claim_ran("ledge: runs", case)
claim("ledge: all beads have left", left(case) == 10)
claim("ledge: no bead is lost", not (case/lost).exists())
alone = case.read(flows)
on_two_ranks(case)
claim("ledge: the same on two ranks", case.read(flows) == alone)
finish()
