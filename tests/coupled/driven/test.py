"""A periodic flow driven by meanVelocityForce: particles feel its pressure gradient, too.

- Through a fixed bed the gradient is Gidaspow's, and the particles carry all of it.
  Its budget has all of the driving force among the sources.
- In a laminar channel a sphere that feels the pressure gradient but not the viscous stress moves faster than the
  fluid by d^2 g/(18 nu); a sphere that feels both moves with the fluid.
- A restart continues with the same bits; free spheres to round-off, as meanVelocityForce writes a sum.
- A device that is not there is not used, and the log says so.

SPDX-License-Identifier: GPL-3.0-or-later
"""
from case import *
from closures import gidaspow_gradient, lattice_void


def drive(case, velocity):
    """Keep this mean velocity by an fvOption."""
    case.dictionary("constant/fvOptions", f"""
drive {{ type meanVelocityForce; selectionMode all; fields (U); Ubar {velocity}; }}
""")


def driving_gradient(case, solver="demPimpleFoam"):
    """The last driving gradient over density [m/s2]."""
    return float(case.found("^Pressure gradient source: .* pressure gradient = (.*)", solver)[1])


# ---- a fixed bed: void fraction 0.6066 everywhere, superficial velocity 0.3 m/s --------------------

case = Case("bed", "fixedBed")
case.box((0.011, 0.011, 0.022), (5, 5, 10), {"inlet": ("cyclic; neighbourPatch outlet", "z-"),
         "sides": ("wall", "y- x+ y+ x-"), "outlet": ("cyclic; neighbourPatch inlet", "z+")})
ends = '"(inlet|outlet)" { type cyclic; }'
case.flow("(0 0 0.494560)", ends + "sides { type slip; }", ends + "sides { type zeroGradient; }")
case.edit("system/controlDict", endTime=0.1, writeInterval=0.05, writePrecision=17)
case.sub("constant/demProperties", "kernel  diffusion;", r"\g<0> record { interval 0.001; budget yes; }")
drive(case, "(0 0 0.494560)")
claim_runs("bed: runs", case)
claim("bed: the driving gradient is the closure's (0.1 %)",
      close(1.2*driving_gradient(case), gidaspow_gradient(lattice_void), 0.001))
claim("bed: exchange closes", worst(case.log(), "exchange error") < 1e-12)
# on fluid and particles together, in 0.1 s
terms = {name: column[-1] for name, column in case.table("postProcessing/dem/0/budget.csv").items()
         if name.endswith(".pz")}
claim("bed: the driving force is among the sources of the budget, nothing is lost between faces and cells",
      abs(terms["faces.pz"]) < 1e-12*abs(terms["sources.pz"]) > 0, terms)
(case/"0.1").rename(case/"straight")
case.edit("system/controlDict", startFrom="latestTime")
case.run("demPimpleFoam")
claim("bed: a restart has the same bits", lambda: agrees(case/"straight/U", case/"0.1/U"))

# ---- a channel between plates 12 mm apart ----------------------------------------------------------


def channel(solver, stress):
    case = Case(f"channel.{solver}.{stress}")
    what = f"channel, {solver}, viscous stress {'yes' if stress else 'no'}"
    sides = '"z.*" { type symmetryPlane; }'
    case.controls(1, 0.005, write=0.5, nu=1e-4, precision=17)
    case.box((0.006, 0.012, 0.001), (6, 12, 1), {"plates": ("wall", "y- y+"), "z0": ("symmetryPlane", "z-"),
                                                 "z1": ("symmetryPlane", "z+")}, cyclic="x")
    case.flow("(0.05 0 0)", "plates { type noSlip; }" + sides, "plates { type zeroGradient; }" + sides)
    drive(case, "(0.05 0 0)")
    case.properties("neutral { density 1000; youngsModulus 1e6; }", "hertz {} dry { restitution 0.9; } stokesDrag {} "
                    "pressureGradient {} " + "viscousStress {}"*stress,
                    "line { type list; diameter 8e-4; velocity (0.05 0 0); "
                    "positions ((0.001 0.0005 0.0005) (0.001 0.0025 0.0005) (0.001 0.0055 0.0005)); }",
                    "rho 1000; twoWay no; kernel particleCentre; walls (plates);", "device toaster;")
    if solver == "pimpleFoam":
        case.append("system/controlDict", function_object)
    claim_runs(f"{what}: runs", case, solver)
    claim(f"{what}: the log says that no device makes the steps",
          case.found("^Suna: device: the CPU makes all steps, not device toaster: ", solver))
    # nu 1e-4 m2/s, mean velocity 0.05 m/s: 12 nu U/h^2, less the error of 12 cells across (1 %)
    g = driving_gradient(case, solver)
    claim(f"{what}: the gradient is Poiseuille's (2 %)", close(g, 12*1e-4*0.05/0.012**2, 0.02))
    # each sphere is in the middle of its cell, in the rows 0, 2 and 5 of 6 x 12 cells of 1 mm
    fluid = case.field("1/U").reshape(12, 6, 3)[[0, 2, 5], 5, 0]
    slip = case.particles("1", "U")[:, 1] - fluid
    ahead = 8e-4**2*g/(18*1e-4)
    claim(f"{what}: the slip has the closed form (1 % of d^2 g/(18 nu))",
          difference(slip, np.full(3, 0 if stress else ahead)) < 0.01*ahead)
    straight = case.particles("1", "positions", "U")
    case.remove("1")
    case.edit("system/controlDict", startFrom="latestTime")
    claim_runs(f"{what}: restarts", case, solver)
    log = case.log(solver)
    claim(f"{what}: it has started at 0.5 s", "Time = 0.505\n" in log and "Time = 0.5\n" not in log)
    # meanVelocityForce adds in another order after a restart. A gradient that misses in one step moves them 7e-7 m
    claim(f"{what}: the spheres are where they were, with their velocities (1e-14 m, m/s)",
          lambda: difference(case.particles("1", "positions", "U"), straight) < 1e-14)


for solver in ("demPimpleFoam", "pimpleFoam"):
    for stress in (False, True):
        if thorough or stress == (solver == "pimpleFoam"):
            channel(solver, stress)
finish()
