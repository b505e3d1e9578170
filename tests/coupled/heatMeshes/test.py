"""Heat exchange between fluid and particles on wedges and moving meshes, in demPimpleFoam and stock solvers.

- Wedge: the fluid of 5 degrees and the particles all around are two lumped capacities of the whole pipe. With moving
  particles energy is conserved to rounding, and two ranks have the temperatures of one.
- A mesh that moves through fluid and particles, in a closed box at rest and with a box that moves as a whole: a
  uniform temperature stays uniform, energy is conserved to rounding, two lumped capacities behave as at rest.
- Both in a stock solver: the fluid gets the heat that hot spheres lose.
- A floor that rises pushes heat out of an open top.

SPDX-License-Identifier: GPL-3.0-or-later
"""
from case import *
from heat.balance import *
from wedge.pipe import Pipe, rings_of_spheres

control, scene = "system/controlDict", "constant/demProperties"
glass = "glass { density 2500; youngsModulus 1e5; heatCapacity 20; }"
moving = "hertz {} dry { restitution 0.9; } gidaspow {} gunn {} pressureGradient {}"
ends = "bottom { type cyclic; } top { type cyclic; }"
closed = ("wall { type slip; } " + ends, "wall { type fixedFluxPressure; } " + ends)    # of U and p
libs = 'libs ("libdemCoupling.so");'


def gas(case, tolerance="1e-11"):
    """Heat capacity and conductivity of the gas, and the schemes and linear solver of T."""
    case.edit("constant/transportProperties", Cp=1000, kappa=0.025)
    for old, new in ((r'"U\.\*"', '"(U|T).*"'), (tolerance, "1e-16"), ("relTol 0;", "relTol 0; maxIter 100;")):
        case.sub("system/fvSolution", old, new)
    case.sub("system/fvSchemes", r"div\(alphaPhi,U\)", "div(alphaPhi,T) Gauss upwind; div(alphaPhi,U)")


def group(name, z, velocity, T):
    """150 spheres in a cylinder of 6 mm between two heights."""
    return f"""{name} {{ type random; diameter 8e-4; count 150; {velocity} temperature {T};
    cylinder {{ from (0 0 {z[0]}); to (0 0 {z[1]}); radius 0.006; }} }}
"""


def conserves(name, case):
    """The claims on each run."""
    claim_ran(f"{name}: runs", case)
    claim(f"{name}: exchange closes", worst(case.log(), "heat exchange error") < 1e-13)
    claim(f"{name}: energy is conserved, with the received heat", drift(case) < 1e-12, drift(case))


def between(what, case, time):
    T = temperatures(case, time)
    claim(what, T.min() > 299.9999 and T.max() < 500.0001, T.min(), T.max())


# ---- wedge, at rest --------------------------------------------------------------------------------

# Five rings of 3, 9, 15, 21, 27 spheres of 1 mm, in proportion to the volumes of the rings of cells, in 4 layers: with
# `kernel divided` the same solid fraction in each cell, so gas and spheres have one temperature each.
h = 1.6e-3
pipe = math.pi*(5*h)**2*4*h, 300                      # volume [m3] and number of spheres
case = Pipe("wedge", 5*h, 4*h, (5, 4), "cyclic")
case.controls(0.04, 0.0005, nu=1.5e-5)
case.flow("(0 0 0)", *closed)
case.initial("T", "0 0 0 1 0 0 0", 500, "wall { type zeroGradient; } " + ends)
gas(case)
case.properties(glass, "hertz {} wenYu {} ranzMarshall {} pressureGradient {}",
                f"cold {{ type list; diameter 1e-3; temperature 300; positions ({rings_of_spheres(h, 4)}); }}",
                "rho 1.25; kernel divided;")
claim_runs("wedge, at rest: runs", case)
claim("wedge, at rest: two lumped capacities of the whole pipe (0.5 % of the first difference)",
      relaxation(case, *pipe) < 0.005)
claim("wedge, at rest: exchange closes", worst(case.log(), "heat exchange error") < 1e-13)
claim("wedge, at rest: energy is kept", drift(case) < 1e-13)
case.edit(control, endTime=4, deltaT=0.02, writeInterval=4)
case.run("demPimpleFoam")
claim("wedge, at rest: gas and spheres end at the mixed temperature of the whole pipe (1e-9)",
      largest(temperatures(case, 4)/capacities(*pipe)[2] - 1) < 1e-9)

# ---- wedge, in motion ------------------------------------------------------------------------------

case = Pipe("wedge-motion", 6e-3, 0.012, (6, 6), "cyclic")
case.controls(0.02, 0.001, 0.005, nu=1.5e-5)
case.flow("(0 0 0)", *closed)
case.initial("T", "0 0 0 1 0 0 0", 500, "wall { type fixedValue; value uniform 500; } " + ends)
gas(case)
case.properties(glass, moving, group("up", (0, 0.006), "seed 2; velocity (0.5 0.1 1);", 400)
                + group("down", (0.006, 0.012), "seed 3; velocity (-0.1 -0.5 -1);", 300), "rho 1.25;")
case.run("demPimpleFoam")
conserves("wedge, in motion", case)
fluid, _, _, total, received = heat(case)
claim("wedge, in motion: the wall's heat is more than 0.1 % of the energy", received[-1]/total[0] > 1e-3)
between("wedge, in motion: temperatures stay between the first ones", case, 0.02)
claim("wedge, in motion: the fluid has cooled by more than 50 K", fluid[-1]/fluid[0] < 0.9)
one = case.field("0.005/T")
case.remove("0.0*")
case.edit(control, endTime=0.005)
case.run("decomposePar")
claim_runs("wedge, in motion: two ranks run", case, ranks=2)
case.run("reconstructPar", "-time", "0.005")
claim("wedge, in motion: two ranks have the temperatures of one (K)",
      one.size == 36 and difference(case.field("0.005/T"), one) < 1e-7)

# ---- wedge, open -----------------------------------------------------------------------------------

# Hot spheres fly out of the top, with gas that enters at the bottom; the log sums over the whole circle
case = Pipe("wedge-open", 6e-3, 0.012, (6, 6))
case.controls(0.02, 0.0005, nu=1.5e-5)
case.flow("(0 0 0.5)", """wall { type slip; } bottom { type fixedValue; value uniform (0 0 0.5); }
    top { type inletOutlet; inletValue uniform (0 0 0); value uniform (0 0 0.5); }""",
          '"(wall|bottom)" { type fixedFluxPressure; } top { type fixedValue; value uniform 0; }')
case.initial("T", "0 0 0 1 0 0 0", 500, """wall { type fixedValue; value uniform 600; }
    bottom { type fixedValue; value uniform 500; }
    top { type inletOutlet; inletValue uniform 500; value uniform 500; }""")
gas(case)
case.properties(glass, moving, group("up", (0, 0.011), "seed 2; velocity (0 0 0.8);", 400), "rho 1.25;",
                "walls { bottom {} } outlets { out { patch top; } }")
case.run("demPimpleFoam")
conserves("wedge, open", case)
claim("wedge, open: more than half of the 150 spheres leave",
      float(case.found(r"^Suna: (\d+) particles, .* DEM steps")[1]) < 75)
*_, total, received = heat(case)
claim("wedge, open: spheres have taken more than a third of it", 1 + received[-1]/total[0] < 0.67)

# ---- stock solvers ---------------------------------------------------------------------------------


def stock(name, case, solver):
    """The fluid gets the heat that hot spheres lose, with the heat of the density's change."""
    claim_runs(f"{name}: runs", case, solver)
    claim(f"{name}: exchange closes", worst(case.log(solver), "heat exchange error") < 1e-12)
    fluid, particles, received, left = gained(case, solver)
    claim(f"{name}: the spheres cool by more than 1 K", left < 0.9975)
    claim(f"{name}: the fluid gets the heat that they lose (1e-5)", close(fluid - received, particles, 1e-5))


case = Pipe("wedge-stock", 6e-3, 0.012, (6, 6), "cyclic")
case.controls(0.02, 0.001, functions=f"particles {{ type demCloud; {libs} }}", nu=1e-5)
for name in ("system/fvSchemes", "system/fvSolution", "constant/thermophysicalProperties"):
    case.copy(f"solvers/{name}", name)
case.append("constant/thermophysicalProperties", "dpdt no;\n")
case.sub("system/fvSolution", "^relaxationFactors.*", "")
case.sub("system/fvSolution", "pRefValue [^;]*", "pRefValue 1e5")
case.gravity("(0 0 0)")
case.initial("U", "0 1 -1 0 0 0 0", "(0 0 0)", closed[0])
case.initial("p", "1 -1 -2 0 0 0 0", 1e5, "wall { type calculated; value uniform 1e5; } " + ends)
case.initial("p_rgh", "1 -1 -2 0 0 0 0", 1e5, "wall { type fixedFluxPressure; value uniform 1e5; } " + ends)
case.initial("T", "0 0 0 1 0 0 0", 300, "wall { type zeroGradient; } " + ends)
case.properties(glass, "hertz {} wenYu {} ranzMarshall {} pressureGradient {}",
                group("hot", (0, 0.006), "seed 2;", 400), "")
stock("wedge, buoyantPimpleFoam", case, "buoyantPimpleFoam")
# with the spheres' heat; rho h = Cp p M/R
fluid, particles, owed, _, received = heat(case, "buoyantPimpleFoam")[:, 0]
claim("wedge, buoyantPimpleFoam: heat is the whole pipe's (1e-5)",
      close(fluid + particles + owed - received,
            1000*28.9/8314.47*1e5*math.pi*0.006**2*0.012 + 150*2500*math.pi/6*8e-4**3*20*400, 1e-5))

# ---- the mesh moves --------------------------------------------------------------------------------


def motion(case, entries):
    """The mesh moves as a solid body, or the points of a zone of it."""
    case.dictionary("constant/dynamicMeshDict",
                    f"dynamicFvMesh dynamicMotionSolverFvMesh; motionSolver solidBody; {entries}")


def swing(case, box, amplitude):
    """The cells in this box swing."""
    motion(case, "cellZone inner; solidBodyMotionFunction oscillatingLinearMotion; "
           f"amplitude ({amplitude}); omega 400;")
    case.dictionary("system/topoSetDict",
                    f"actions ( {{ name inner; type cellZoneSet; action new; source boxToCell; box {box}; }} );")
    case.run("topoSet")


# A box that moves as a whole, by two cells: contents at rest in it relax as in a box at rest
case = Case("box", "heat")
# 2^-11 s: times are sums without round-off, so a restart has the same points
case.edit(control, endTime=0.0390625, deltaT=0.00048828125, writeInterval=0.01953125, timePrecision=12)
motion(case, "solidBodyMotionFunction linearMotion; velocity (0.2 0 0.1);")
for name, old, new in (
        ("0/U", r"uniform \(0 0 0\)", "uniform (0.2 0 0.1)"),
        ("0/U", "type cyclic;", "type movingWallVelocity; value uniform (0.2 0 0.1);"),
        ("0/p", "type cyclic", "type fixedFluxPressure"), ("0/T", "type cyclic", "type zeroGradient"),
        (scene, "temperature 300", "velocity (0.2 0 0.1); temperature 300")):
    case.sub(name, old, new)
case.box((8e-3, 8e-3, 8e-3), (2, 2, 2), {"walls": ("wall", "x- x+ y- y+ z- z+")})
case.run("demPimpleFoam")
conserves("moving box", case)
claim("moving box: two lumped capacities (0.5 % of the first difference)",
      relaxation(case, 8e-3**3, 64, t=0.0390625) < 0.005)
(case/"0.0390625").rename(case/"straight")
case.edit(control, startTime=0.01953125)
case.run("demPimpleFoam")
for what, name in (("fluid", "T"), ("particles", "lagrangian/particles/temperature")):
    claim(f"moving box: a restart has the bits of the uninterrupted run, {what}",
          agrees(case/"straight"/name, case/"0.0390625"/name))

# A floor that rises at 0.05 m/s, with hot grains, below an open top: what leaves is received, negative
case = Case("piston", "moving")
case.initial("T", "0 0 0 1 0 0 0", 300, '"(floor|sides)" { type zeroGradient; } '
             "top { type inletOutlet; inletValue uniform 300; value uniform 300; }")
gas(case, "1e-12")
case.sub("system/fvSolution", "nOuterCorrectors 1", "nOuterCorrectors 3")
for old, new in (("youngsModulus 1e6;", "youngsModulus 1e6; heatCapacity 20;"), ("gidaspow {}", "gidaspow {} gunn {}"),
                 ("count 16;", "count 16; temperature 400;")):
    case.sub(scene, old, new)
case.run("demPimpleFoam")
conserves("piston", case)
# gas of 300 K leaves through 4 cm2; it is warm at the floor only
claim("piston: the heat that leaves matches the volume pushed out (0.1 %)",
      close(heat(case)[-1, -1], -1000*0.02**2*0.05*0.0390625*300, 1e-3))

# Inner cells of a periodic box swing by 0.3 of a cell, through fluid and through spheres that fly
for first in (300, 500):
    name = f"moving cells, spheres of {first} K"
    case = Case(f"inner-{first}", "heat")
    spheres = f"diameter 8e-4; count 500; temperature {first};"
    crossing(case, spheres, spheres)
    swing(case, "(0.0039 0.0039 0.0039) (0.0081 0.0081 0.0081)", "6e-4 4e-4 0")
    case.run("demPimpleFoam")
    conserves(name, case)
    claim(f"{name}: points have moved", case.read("0.02/polyMesh/points"))
    if first == 300:
        between(f"{name}: temperatures stay between the first ones", case, 0.02)
    else:
        claim(f"{name}: in fluid of 500 K the temperature stays uniform",
              largest(temperatures(case, 0.02)/500 - 1) < 1e-12)

# Inner cells swing by a quarter of a cell in rhoPimpleFoam
case = hot("rhoPimpleFoam")
swing(case, "(0.0079 0.0079 0.0079) (0.0121 0.0121 0.0241)", "1e-3 5e-4 0")
stock("moving cells, rhoPimpleFoam", case, "rhoPimpleFoam")
claim("moving cells, rhoPimpleFoam: points have moved", case.read("0.02/polyMesh/points"))
finish()
