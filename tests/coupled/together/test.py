"""Galilean invariance: fluid and particles with one common velocity keep it in any non-uniform void fraction.

- Random particles in a periodic box, on hexahedra and on tetrahedra.
- Neutral particles and liquid that leave a duct through an outlet, with several steps and on two ranks.
- A slurry that enters a duct with the flux of the mixture given, and leaves it.
- Particles that are removed inside the duct: fluid fills their volume.

SPDX-License-Identifier: GPL-3.0-or-later
"""
from case import *

box_velocity = np.array([0.06, -0.03, 0.1])
duct_velocity = np.array([0.4, 0, 0])
laws = "effects { hertz {} dry { restitution 0.9; } gidaspow {} pressureGradient {} }\n"


def vector(v):
    return f"({v[0]:g} {v[1]:g} {v[2]:g})"


def off(velocities, common):
    """The largest deviation from the common velocity, over its magnitude."""
    return np.linalg.norm(velocities - common, axis=1).max()/np.linalg.norm(common)


def momentum_box(name, scene, velocity, endTime):
    """The mesh of the momentum test with this scene and a uniform velocity of the liquid."""
    case = Case(name, "momentum")
    case.sub("system/fvSolution", "nOuterCorrectors 8", "nOuterCorrectors 1")
    case.edit("system/controlDict", endTime=endTime, writeInterval=endTime)
    case.sub("0/U", r"^internalField.*", f"internalField uniform {vector(velocity)};")
    case.dictionary("constant/demProperties", scene)
    return case


def continuity(what, case):
    claim(f"{what}: continuity holds", worst(case.log(), "continuity errors : sum local =") < 1e-10)


# ---- a periodic box ---------------------------------------------------------------------------------

scene = f"""materials {{ glass {{ density 2500; youngsModulus 1e5; }} }}
{laws}
insert {{ all {{ type random; diameter 8e-4; count 700; velocity {vector(box_velocity)};
                 min (0 0 0); max (0.012 0.012 0.009); }} }}
coupling {{ rho 1000; kernel diffusion; }}
"""
for mesh in ("hexahedra", "tetrahedra"):
    case = momentum_box(mesh, scene, box_velocity, 0.02)
    if mesh == "tetrahedra":
        case.sub("system/fvSolution", "nNonOrthogonalCorrectors 0", "nNonOrthogonalCorrectors 2")
        case.run("bash", "./tetrahedra")
    claim_runs(f"{mesh}: runs", case)
    claim(f"{mesh}: the void fraction is not uniform", np.ptp(case.field("0.02/voidFraction")) > 0.1)
    # linear solvers stop at 1e-11 of their source, 20 steps; without the voidage flux the deviation is 1e-2
    U, u = case.field("0.02/U"), case.particles("0.02", "U")[:, 1:]
    claim(f"{mesh}: the fluid keeps the common velocity", off(U, box_velocity) < 1e-6)
    claim(f"{mesh}: the particles keep the common velocity", off(u, box_velocity) < 1e-6)
    continuity(mesh, case)

# ---- inlets and outlets -----------------------------------------------------------------------------


def duct(name, step, scene, endTime, functions=""):
    """36 mm by 12 by 12, liquid and particles of its density with 0.4 m/s along x: run in steps of this length."""
    scene = "materials { glass { density 1000; youngsModulus 1e5; } }\n" + laws + scene
    case = momentum_box(name, scene, duct_velocity, endTime)
    mesh = "system/blockMeshDict"
    case.sub(mesh, r"\(0.012 ", "(0.036 ")
    case.sub(mesh, r"\(6 6 6\)", "(18 6 6)")
    case.sub(mesh, "x0 { type cyclic; neighbourPatch x1;", "inlet { type patch;")
    case.sub(mesh, "x1 { type cyclic; neighbourPatch x0;", "outlet { type patch;")
    fixed = f"type fixedValue; value uniform {vector(duct_velocity)};"
    for field, inlet, outlet in (("0/U", fixed, "type zeroGradient;"),
                                 ("0/p", "type zeroGradient;", "type fixedValue; value uniform 0;")):
        case.sub(field, r"boundaryField\n{", f"boundaryField\n{{\n    inlet {{ {inlet} }} outlet {{ {outlet} }}")
    case.edit("system/controlDict", deltaT=step)
    case.append("system/controlDict", functions)
    case.run("blockMesh")
    case.run("demPimpleFoam")
    return case


leaves = """
insert { all { type random; diameter 8e-4; count 3400; velocity (0.4 0 0); min (0.01 0 0); max (0.036 0.012 0.012); } }
outlets { out { patch outlet; } }
coupling { rho 1000; kernel diffusion; }
"""
for step in (2.5e-4, 1e-3):
    what = f"leaves, steps of {step:g} s"
    case = duct(f"leaves.{step}", step, leaves, 0.05)
    claim_ran(f"{what}: runs", case)
    U = case.particles("0.05", "U")[:, 1:]
    claim(f"{what}: more than half of the particles have left", len(U) < 1700)
    claim(f"{what}: the liquid keeps the common velocity", off(case.field("0.05/U"), duct_velocity) < 1e-4)
    claim(f"{what}: so do the particles", off(U, duct_velocity) < 1e-4)

# on two ranks, one of them with the outlet
case.run("decomposePar")
case.remove("0.05")
claim_runs("leaves: runs on two ranks", case, ranks=2)
for rank in range(2):
    claim(f"leaves: the liquid of rank {rank} keeps the common velocity",
          off(case.field(f"processor{rank}/0.05/U"), duct_velocity) < 1e-4)

# A slurry: the mixture enters with 0.4 m/s, 25 % of it particles.
slurry = """
insert { feed { type stream; patch inlet; rate 53700; diameter 8e-4; velocity (0.4 0 0); } }
outlets { out { patch outlet; } }
coupling { rho 1000; kernel diffusion; mixtureFlux (inlet); }
"""
for step in (1e-3, 2.5e-4) if thorough else (1e-3,):
    what = f"slurry, steps of {step:g} s"
    case = duct(f"slurry.{step}", step, slurry, 0.12)
    claim_ran(f"{what}: runs", case)
    U = case.particles("0.12", "U")[:, 1:]
    claim(f"{what}: particles are everywhere", len(U) > 3500)
    claim(f"{what}: the liquid keeps the velocity of the mixture", off(case.field("0.12/U"), duct_velocity) < 1e-4)
    claim(f"{what}: so do the particles", off(U, duct_velocity) < 1e-4)
    # over rho u^2
    claim(f"{what}: the pressure is uniform", largest(case.field("0.12/p"))/0.16 < 1e-3)

# All particles are removed in the middle. Where they were, liquid is sucked in; behind, the liquid alone continues with
# its flux, 0.75 of the mixture's: mean over 60 ms, in which 3200 particles pass.
scene = slurry.replace("patch outlet;", "min (0.018 0 0); max (0.022 0.012 0.012);")
case = duct("trap", 1e-3, scene, 0.12, """
functions
{
    means
    {
        type fieldAverage; libs ("libfieldFunctionObjects.so"); timeStart 0.06; writeControl writeTime;
        fields ( U { mean on; prime2Mean off; base time; } );
    }
}
""")
claim_ran("trap: runs", case)
case.run("postProcess", "-func", "writeCellCentres", "-time", "0.12")
claim("trap: no particle is behind it", largest(case.particles("0.12", "positions")[:, 1]) <= 0.0225)
behind = case.field("0.12/C")[:, 0] > 0.03
claim("trap: behind it the liquid continues with its own flux",
      close(case.field("0.12/UMean")[behind, 0].mean(), 0.3, 0.01))
continuity("trap", case)
finish()
