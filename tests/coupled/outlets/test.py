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


def duct(name, insert, end, step, size=0.04, young=1e6, fastest=3, drag="stokesDrag {}", interval="", functions="",
         more="walls { roof { type plane; point (0.041 0 0); normal (-1 1 0); material glass; } }"):
    """Beads in a duct along x, of this length [m], with an outlet at its end and a deflector beyond it."""
    case = Case(name)
    case.controls(end, step, functions=functions, precision=17)
    case.box((size, size/2, size/2), (10, 5, 5),
             {"inlet": ("patch", "x-"), "outlet": ("patch", "x+"), "walls": ("wall", "y- y+ z- z+")})
    case.flow("(0.4 0 0)", "inlet { type fixedValue; value uniform (0.4 0 0); } walls { type slip; } "
              "outlet { type inletOutlet; inletValue uniform (0 0 0); value uniform (0.4 0 0); }",
              '"(inlet|walls)" { type fixedFluxPressure; } outlet { type fixedValue; value uniform 0; }')
    case.properties(f"glass {{ density 2500; youngsModulus {young}; }}",
                    f"hertz {{ impactSpeed {fastest}; }} dry {{ restitution 0.9; }} mindlin {{ friction 0.3; }} {drag}",
                    insert, f"rho 1; twoWay no; {interval}", "outlets { out { patch outlet; } } " + more)
    return case


def feed(rate, aside=0, where="patch inlet;"):
    return f"feed {{ type stream; {where} rate {rate}; diameter 2e-4; velocity (2 0 0); spread (0.1 {aside} 0); }}"


def exits(solver):
    """More than the least number of beads have left, none is lost."""
    # a long run has beads that enter near the outlet; otherwise most of the work is their way to it
    where, young, steps = ("min (0.034 0.001 0.001); max (0.038 0.019 0.019);", 2e5, 55) if thorough else (
        "patch inlet;", 1e6, 100)
    steady = solver == "simpleFoam"
    step = 1 if steady else 0.002
    case = duct(solver, feed(rate, where=where), f"{steps*step:g}", step, young=young, interval="interval 0.002;"*steady,
                functions='particles { type demCloud; libs ("libdemCoupling.so"); }'*(solver != "demPimpleFoam"))
    if steady:
        case.sub("system/fvSchemes", "default Euler", "default steadyState")
        case.sub("system/fvSolution", "^PIMPLE",
                 "relaxationFactors { equations { U 0.7; } fields { p 0.3; } }\nSIMPLE")
    claim_runs(f"{solver}: runs", case, solver)
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
case = duct("aside", feed(20000, aside=4), 0.02, 0.002, young=1e7, fastest=5)
claim_runs("aside: runs", case)
entered = case.numbers("since the start ([0-9]*) particles entered, 0 left, 0 wait")
claim("aside: the 360 beads of the 18 ms before the last step have entered", entered[-1, 0] == 360)
claim("aside: no bead is lost", not (case/lost).exists())

# The duct is 25 times as large, a tenth of the way from a cell's center to the outlet 5 mm: at 0.2 m/s beads fall there
# by thirty radii. The lowest start on the ground, all 0.02 m before its end. A rank boundary runs along the ground's
# middle.
case = duct("ledge", "row { type lattice; diameter 2e-4; spacing 50; jitter 0; min (0.98 0 0.2); "
            "max (0.9803 2.1e-4 0.3); velocity (0.2 0 0); }", 0.3, 0.005, size=1, drag="", more="")
case.gravity("(0 -9.81 0)")
claim_runs("ledge: runs", case)
claim("ledge: all beads have left", left(case) == 10)
claim("ledge: no bead is lost", not (case/lost).exists())
alone = case.read(flows)
on_two_ranks(case)
claim("ledge: the same on two ranks", case.read(flows) == alone)
case.sub("constant/demProperties", "patch outlet;", "patch (outlet inlet);")
claim_refused("an outlet with two patches", case, "outlets/out: patch needs one name; make an entry for each patch",
              "demPimpleFoam")
finish()
