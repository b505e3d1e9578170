"""A coupled run is the same on 1, 2 and 4 ranks, wherever cells and particles are.

Cases: a bed; all particles over the cells of one rank (the other three ranks own particles, but their cells contain
none); one particle; none; a rank without cells; and particles at 50 m/s that cross four ranks and 32 cells in one step
of the fluid.

SPDX-License-Identifier: GPL-3.0-or-later
"""
from case import *

contacts = "hertz {} dry { restitution 0.9; } mindlin { friction 0.3; } gidaspow {}"
gravity = "gravity { acceleration (0 0 -9.81); } "


def scene(name, effects, particles, steps, more=""):
    """A closed box of 100 x 10 x 10 mm of liquid, 40 x 4 x 4 cells, step 1.6 ms."""
    case = Case(name)
    case.write("system/blockMeshDict", head("dictionary", "blockMeshDict") + """
scale 1;
vertices ((0 0 0) (0.1 0 0) (0.1 0.01 0) (0 0.01 0) (0 0 0.01) (0.1 0 0.01) (0.1 0.01 0.01) (0 0.01 0.01));
blocks (hex (0 1 2 3 4 5 6 7) (40 4 4) simpleGrading (1 1 1)); edges ();
boundary ( walls { type wall; faces ((0 1 5 4) (1 2 6 5) (2 3 7 6) (3 0 4 7) (0 3 2 1) (4 5 6 7)); } );
""")
    case.write("system/controlDict", head("dictionary", "controlDict") + f"""
application demPimpleFoam; startFrom startTime; startTime 0; stopAt endTime; endTime {0.0016*steps:g}; deltaT 0.0016;
writeControl timeStep; writeInterval {steps}; writePrecision 16; timeFormat general; runTimeModifiable no;
""")
    case.edit("constant/transportProperties", nu=1e-5)
    case.write("constant/demProperties", head("dictionary", "demProperties") + f"""
materials {{ glass {{ density 2500; youngsModulus 1e6; }} }}
effects {{ {effects} pressureGradient {{}} }} insert {{ {particles} }} {more} coupling {{ rho 1.2; }}
""")
    case.write("0/U", head("volVectorField", "U") + """
dimensions [0 1 -1 0 0 0 0]; internalField uniform (0 0 0); boundaryField { walls { type noSlip; } }
""")
    case.write("0/p", head("volScalarField", "p") + """
dimensions [0 2 -2 0 0 0 0]; internalField uniform 0; boundaryField { walls { type fixedFluxPressure; } }
""")
    case.sub("system/fvSolution", "nOuterCorrectors 1", "nOuterCorrectors 3")
    case.run("blockMesh")
    return case


def result(case):
    """Particles, if there are any, velocity and void fraction at the end; the time folder is removed."""
    end = case.times()[-1]
    ids = case/end/"lagrangian/particles/id"
    some = ids.exists() and case.field(ids).size
    particles = case.particles(end, "positions", "U") if some else None
    U, e = case.field(f"{end}/U", 640), case.field(f"{end}/voidFraction", 640)
    case.remove(end)
    return particles, U, e


def alone(what, case):
    case.run("demPimpleFoam")
    claim_ran(f"{what}: runs alone", case)
    return result(case)


def blocks(layout):
    return f"method hierarchical; coeffs {{ n ({layout}); delta 0.001; order xyz; }}"


def decomposed(what, case, expected, n, method):
    """On n ranks it agrees with the run alone. Linear solvers of 1e-11 sum in another order, which collisions
    amplify."""
    case.write("system/decomposeParDict",
               head("dictionary", "decomposeParDict") + f"numberOfSubdomains {n}; {method}\n")
    case.remove("processor*")
    case.run("decomposePar")
    case.run("demPimpleFoam", ranks=n)
    claim_ran(f"{what}: runs on {n}", case)
    case.run("reconstructPar", "-latestTime")
    particles, U, e = result(case)
    if expected[0] is not None:
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
decomposed("all over one", case, one, 4, blocks("4 1 1"))

# the same with a rank that has no cell
owner = np.array([0, 1, 3])[np.digitize(np.arange(640) % 40, [12, 27])]
case.write("constant/cellDecomposition", head("labelList", "cellDecomposition") +
           "640 (" + " ".join(map(str, owner)) + ")\n")
decomposed("one without cells", case, one, 4, 'method manual; coeffs { dataFile "cellDecomposition"; }')

case = scene("one", gravity + contacts, "one { type list; diameter 1e-3; positions ((0.051 5e-3 5e-3)); }", 3)
one = alone("one particle", case)
decomposed("one particle", case, one, 4, blocks("4 1 1"))

case = scene("none", contacts, "", 2, "time { step 1e-5; }")
one = alone("none", case)
decomposed("none", case, one, 4, blocks("4 1 1"))
finish()
