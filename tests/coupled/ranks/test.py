"""A coupled run is the same on 1, 2 and 4 ranks, wherever cells and particles are.

Cases: a bed; a rank without cells, all particles over the cells of another; and particles at 50 m/s that cross four
ranks and 32 cells in one step of the fluid. One particle, none, and all over one of four ranks: stability/40.

SPDX-License-Identifier: GPL-3.0-or-later
"""
from case import *

contacts = "hertz {} dry { restitution 0.9; } mindlin { friction 0.3; } gidaspow {}"
gravity = "gravity { acceleration (0 0 -9.81); } "


def scene(name, effects, particles, steps, more=""):
    """A closed box of 100 x 10 x 10 mm of liquid, 40 x 4 x 4 cells, step 1.6 ms."""
    case = Case(name)
    case.controls(0.0016*steps, 0.0016, nu=1e-5)
    case.box((0.1, 0.01, 0.01), (40, 4, 4), {"walls": ("wall", "x- x+ y- y+ z- z+")})
    case.flow("(0 0 0)", "walls { type noSlip; }", "walls { type fixedFluxPressure; }")
    case.properties("glass { density 2500; youngsModulus 1e6; }", f"{effects} pressureGradient {{}}", particles, "rho 1.2;",
                    more)
    case.sub("system/fvSolution", "nOuterCorrectors 1", "nOuterCorrectors 3")
    return case


def result(case):
    """Particles, velocity and void fraction at the end; the time folder is removed."""
    end = case.times()[-1]
    particles = case.particles(end, "positions", "U")
    U, e = case.field(f"{end}/U", 640), case.field(f"{end}/voidFraction", 640)
    case.remove(end)
    return particles, U, e


def alone(what, case):
    claim_runs(f"{what}: runs alone", case)
    return result(case)


def blocks(layout):
    return f"method hierarchical; coeffs {{ n ({layout}); delta 0.001; order xyz; }}"


def decomposed(what, case, expected, n, method):
    """On n ranks it agrees with the run alone. Linear solvers of 1e-11 sum in another order, which collisions
    amplify."""
    case.dictionary("system/decomposeParDict", f"numberOfSubdomains {n}; {method}")
    case.remove("processor*")
    case.run("decomposePar")
    claim_runs(f"{what}: runs on {n}", case, ranks=n)
    case.run("reconstructPar", "-latestTime")
    particles, U, e = result(case)
    claim(f"{what}: {n} give the same positions and velocities (m, m/s)", difference(expected[0], particles) < 1e-8)
    claim(f"{what}: {n} give the fluid the same velocity (m/s)", difference(expected[1], U) < 1e-5)
    claim(f"{what}: {n} have the same void fraction", difference(expected[2], e) < 1e-9)
    claim(f"{what}: the exchange closes on {n}", worst(case.log(), "exchange error") < 1e-12)
    claim(f"{what}: volume is kept on {n}", worst(case.log(), "volume error") < 1e-12)


case = scene("bed", gravity + contacts, "bed { type lattice; diameter 1e-3; count 2000; spacing 1.1; jitter 0.5; "
             "min (0 0 0); max (0.1 0.01 0.01); velocity (0.5 0 0); }", 4)
one = alone("a bed", case)
decomposed("a bed", case, one, 2, blocks("2 1 1"))
decomposed("a bed", case, one, 4, blocks("2 1 2"))

# 80 mm a step: from the first of four ranks to the last, some diagonally through the cells of all others
case = scene("fast", contacts, "fast { type list; diameter 1e-3; velocity (50 0.5 0.25); "
             "positions ((5e-3 2e-3 2e-3) (1e-2 5e-3 4.5e-3) (1.5e-2 7e-3 6e-3)); }", 1, "time { step 8e-6; }")
one = alone("across four in a step", case)
claim("across four in a step: they have crossed", one[0][0, 1] > 0.08)
decomposed("across four in a step", case, one, 4, blocks("4 1 1"))

case = scene("corner", gravity + contacts, "few { type lattice; diameter 1e-3; count 200; spacing 1.2; jitter 0.5; "
             "min (0 0 0); max (0.02 0.01 0.01); }", 3)
one = alone("all over one", case)

# a rank that has no cell
owner = np.array([0, 1, 3])[np.digitize(np.arange(640) % 40, [12, 27])]
case.dictionary("constant/cellDecomposition", "640 (" + " ".join(map(str, owner)) + ")", "labelList")
decomposed("one without cells", case, one, 4, 'method manual; coeffs { dataFile "cellDecomposition"; }')
finish()
