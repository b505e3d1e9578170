"""Particles follow a moving mesh, in demPimpleFoam and in pimpleFoam.

- A floor that rises (mesh deformed by displacementLaplacian), and a box that moves as a whole. Cells that shrink are no
  change of the void fraction.
- A shear layer stays in space while the mesh moves through it.
- Two ranks agree with one; a restart agrees with the uninterrupted run, also with ownWake and lawWidth.

SPDX-License-Identifier: GPL-3.0-or-later
"""
from case import *


def make(name, solver):
    case = Case(f"{name}-{solver}")
    if solver == "pimpleFoam":
        case.append("system/controlDict", 'functions { particles { type demCloud; libs ("libdemCoupling.so"); } }\n')
    return case


def all_close(values, value, share):
    return len(values) > 0 and np.all(abs(values - value) <= share*value)


# ---- a floor that rises at 0.05 m/s under 16 grains in air -----------------------------------------

END = "0.0390625"


def piston(solver):
    case = make("piston", solver)
    name = f"piston, {solver}"
    claim_runs(f"{name}: runs", case, solver)
    grains = case.particles(END, "positions")[:, 1:]
    U = case.field(f"{END}/lagrangian/particles/U")
    # the floor starts with an impact, bounces at restitution 0.3 last 5 ms; the flow around them changes as they settle
    claim(f"{name}: all grains have its velocity", all_close(U[:, 2], 0.05, 1e-3))
    # 1.953 mm up; the overlap, 0.5 um, is a thousandth of the radius
    claim(f"{name}: all grains are at its height", all_close(grains[:, 2], 0.002453125, 1e-3))
    # 16 m g = 16 * 1.309 mg * g, less the lift by air: 0.04 %; the last of the means
    walls = case.table("postProcessing/dem/0/walls.csv")
    load = dict(zip(walls["wall"], walls["fz"]))["floor"]
    claim(f"{name}: it carries their weight", close(load, -2.05462e-04, 2e-3))
    claim(f"{name}: exchange closes", worst(case.log(solver), "exchange error") < 1e-12)
    claim(f"{name}: volume of the particles is kept", worst(case.log(solver), "volume error") < 1e-12)
    if solver == "demPimpleFoam":
        claim(f"{name}: volume of the fluid is kept",
              worst(case.log(), "continuity errors : sum local =") < 1e-12)
        # cells shrink by 2.4e-3 in a step, and with them the fluid; the particles' share stays below 2 %
        claim(f"{name}: shrinking cells are no change of the void fraction",
              worst(case.log(), "change of void fraction") < 5e-4, worst(case.log(), "change of void fraction"))
        claim(f"{name}: air leaves with the velocity of the floor",
              all_close(case.field(f"{END}/U")[-25:, 2], 0.05, 2e-3))

    # floor and mesh are at their positions, contacts and springs keep their partners
    (case/END).rename(case/"straight")
    case.edit("system/controlDict", startFrom="latestTime")
    case.run(solver)
    claim(f"{name}: restart loads the snapshot", case.found("particles from", solver))
    # the solver of the mesh motion restarts with another round-off, 1e-16 of the displacement
    claim(f"{name}: a restart gives the same positions (m)",
          lambda: difference(grains, case.particles(END, "positions")[:, 1:]) < 1e-13)
    claim(f"{name}: a restart gives the same velocities (m/s)",
          lambda: difference(U, case.field(f"{END}/lagrangian/particles/U")) < 1e-12)
    case.edit("system/controlDict", startFrom="startTime")
    return case, grains


piston("pimpleFoam")
case, grains = piston("demPimpleFoam")
case.remove(END)
case.run("decomposePar")
claim_runs("piston, two ranks: runs", case, ranks=2)
case.run("reconstructPar", "-latestTime")
# linear solvers sum in another order: 1e-12 of pressure and mesh motion
claim("piston, two ranks: the same positions (m)",
      lambda: difference(grains, case.particles(END, "positions")[:, 1:]) < 1e-10)

# ---- grains that fall towards the floor, their own wakes taken out of the fluid that they see, or with
# ---- the void fraction of the drag law over a narrower width ----------------------------------------

for what, entries in (("own wakes", "kernel linear; ownWake yes;"), ("lawWidth", "kernel diffusion; lawWidth 1;")):
    case = make(what.replace(" ", "-"), "demPimpleFoam")
    case.sub("constant/demProperties", r"min \(0.002 0.002 -5e-7\); max \(0.018 0.018 0.002\)",
             "min (0.002 0.002 0.01); max (0.018 0.018 0.0125)")
    case.sub("constant/demProperties", "coupling { rho 1;", f"coupling {{ rho 1; {entries}")
    claim_runs(f"{what}: runs", case)
    grains, U = case.particles(END, "positions")[:, 1:], case.field(f"{END}/lagrangian/particles/U")
    claim(f"{what}: grains fall and floor rises", np.all(U[:, 2] < -0.1))
    (case/END).rename(case/"straight")
    case.edit("system/controlDict", startFrom="latestTime")
    case.run("demPimpleFoam")
    # the weights of the first step are those of the mesh before it moves on
    claim(f"{what}: a restart gives the same velocities (m/s)",
          lambda: difference(U, case.field(f"{END}/lagrangian/particles/U")) < 1e-12)
    case.remove("0.0[0-9]*")
    case.edit("system/controlDict", startFrom="startTime")
    case.run("decomposePar")
    case.run("demPimpleFoam", ranks=2)
    case.run("reconstructPar", "-latestTime")
    claim(f"{what}, two ranks: the same positions (m)",
          lambda: difference(grains, case.particles(END, "positions")[:, 1:]) < 1e-10)

# ---- a closed box that moves as a whole, by 2.5 cells, with liquid and grains of its density -------

VELOCITY = "(0.2 0 0.1)"


def off(U):
    """The largest departure from the box's velocity [m/s]."""
    return np.linalg.norm(U - [0.2, 0, 0.1], axis=1).max()


def box(solver):
    case = make("box", solver)
    case.dictionary("constant/dynamicMeshDict", f"""dynamicFvMesh dynamicMotionSolverFvMesh;
motionSolver solidBody;
solidBodyMotionFunction linearMotion;
velocity {VELOCITY};""")
    case.sub("system/blockMeshDict", r"top \{ type patch;", "top { type wall;")
    walls, U, p = '"(floor|sides|top)"', "", ""
    if solver == "pimpleFoam":                        # its adjustPhi refuses a box without any flux: the lid is open
        walls, U, p = '"(floor|sides)"', "top { type zeroGradient; }", "top { type fixedValue; value uniform 0; }"
    case.flow(VELOCITY, f"{walls} {{ type movingWallVelocity; value uniform {VELOCITY}; }} {U}",
              f"{walls} {{ type fixedFluxPressure; }} {p}")
    case.remove("0/pointDisplacement")
    # at random positions: drag vanishes without slip, also where the void fraction is not uniform
    case.properties("neutral { density 1000; youngsModulus 1e5; }", """gravity { acceleration (0 0 -9.81); }
    hertz {} dry { restitution 0.9; } gidaspow {} pressureGradient {}""", f"""grains {{ type random; diameter 1e-3;
    count 800; velocity {VELOCITY}; min (0 0 0); max (0.02 0.02 0.02); }}""", "rho 1000;")
    case.edit("system/controlDict", endTime=0.048828125, writeInterval=0.009765625)
    case.run("blockMesh")
    case.run(solver)
    return case


for solver in ("demPimpleFoam", "pimpleFoam"):
    case = box(solver)
    name, end = f"moving box, {solver}", case/"0.048828125"
    claim_ran(f"{name}: runs", case, solver)
    claim(f"{name}: grains have its velocity (m/s)", off(case.field(end/"lagrangian/particles/U")) < 1e-8)
    claim(f"{name}: the liquid has its velocity (m/s)", off(case.field(end/"U", 1)) < 1e-8)
    # positions have an error of 1e-17 m a step, a cell is 4 mm wide
    claim(f"{name}: the void fraction does not change",
          difference(case.field("0.009765625/voidFraction"), case.field(end/"voidFraction")) < 1e-11)
    claim(f"{name}: volume of the particles is kept", worst(case.log(solver), "volume error") < 1e-12)
    total = case.vectors("sum", "momentum", solver)
    change = np.linalg.norm(total - total[0], axis=1).max()/np.linalg.norm(total[0])
    claim(f"{name}: total momentum is kept", len(total) > 30 and change < 1e-8)

    # points are a function of time, so all bits are: from the second of five written times
    straight = end.rename(case/"straight")
    case.edit("system/controlDict", startTime=0.01953125)
    case.run(solver)
    claim(f"{name}: a restart has the bits of the uninterrupted run, particles",
          lambda: snapshot_hash(straight/"uniform/dem.snapshot") == snapshot_hash(end/"uniform/dem.snapshot"))
    for field in ("U", "p", "phi", "Uf", "voidFraction"):
        claim(f"{name}: a restart has the bits of the uninterrupted run, {field}",
              lambda: agrees(straight/field, end/field))

case.edit("system/controlDict", startTime=0)
case.append("constant/demProperties", "walls { floor { material neutral; wear { coefficient 1e-4; hardness 1e9; } } }")
claim_refused("moving box: wear of a patch is refused", case, "wear is summed on patches at rest only", "pimpleFoam")

# ---- a mesh that moves through a shear layer at rest ------------------------------------------------
# Fluid at x < 0.05 m moves along y. The mesh moves 0.01 m along x, and the layer stays where it is in space.

case = make("shear", "demPimpleFoam")
case.dictionary("constant/dynamicMeshDict", """dynamicFvMesh dynamicMotionSolverFvMesh;
motionSolver solidBody;
solidBodyMotionFunction linearMotion;
velocity (0.2 0 0);""")
case.box((0.1, 0.0025, 0.0025), (40, 1, 1),
         {"ends": ("patch", "x- x+"), "front": ("cyclic; neighbourPatch back", "y-"),
          "back": ("cyclic; neighbourPatch front", "y+"), "sides": ("patch", "z- z+")})
case.flow("(0 0 0)", "ends { type zeroGradient; } sides { type slip; } \"front|back\" { type cyclic; }",
          "ends { type fixedValue; value uniform 0; } sides { type fixedFluxPressure; } "
          "\"front|back\" { type cyclic; }")
case.sub("0/U", r"uniform \(0 0 0\);", f"nonuniform List<vector> 40({'(0 0.1 0) '*20}{'(0 0 0) '*20});")
case.remove("0/pointDisplacement")
case.properties("glass { density 2500; youngsModulus 1e6; }", "hertz {} gidaspow {} pressureGradient {}",
                "grain { type list; diameter 1e-5; positions ((0.09 0.00125 0.00125)); }", "rho 1;")
case.edit("system/controlDict", endTime=0.05, deltaT=0.001, writeInterval=0.05)
claim_runs("shear layer: runs", case)
# one of 40 cells of 2.5 mm, full of the layer's velocity, is 2.5 mm of it; viscosity spreads it evenly.
# 1e-5 m is a thousandth of the way of the mesh
place = (case.field("0.05/U")[:, 1]/0.1).sum()*0.0025
claim("shear layer: it stays in space (m)", abs(place - 0.04) < 1e-5, place)
finish()
