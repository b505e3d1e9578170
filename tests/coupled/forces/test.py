"""Fluid forces other than drag: pressure gradient, added mass, lift and viscous stress.

- Acceleration, vorticity and stress of a given flow reach the particles exactly.
- Light spheres rise and heavy ones settle with added mass as an independent integration predicts, one-way (1 %) and
  two-way (5 %).
- A swarm of bubbles stays bounded, continues after a restart with the same bits and is the same on two ranks.
- Packings of light spheres stay at rest with any step.
- With all forces the momentum of liquid and particles is conserved, in demPimpleFoam and by function object.

SPDX-License-Identifier: GPL-3.0-or-later
"""
from case import *


def claim_exchange(what, case, solver="demPimpleFoam"):
    claim(f"{what}: exchange closes", worst(case.log(solver), "exchange error") < 1e-12)


def run(case, what, solver="demPimpleFoam"):
    case.run("blockMesh")
    claim_runs(f"{what}: runs", case, solver)


# ---- a given flow ----------------------------------------------------------------------------------


def given(name, effects, flow, insert=None):
    """One step of 0.1 ms of a sphere of 1 mm and 2500 kg/m3 at (1.3 -2.1 0.4) mm, or of others, in the flow
    (U_x, U_y) = flow(x, y); returns the case."""
    case = Case(name, "forces/given")
    case.sub("constant/demProperties", "EFFECTS", effects)
    if insert:
        case.sub("constant/demProperties", "^insert.*", insert)
        case.sub("constant/demProperties", "linear", "particleCentre")
    x = np.arange(-0.009, 0.01, 0.002)
    rows = [" ".join(f"{u:.17g}" for u in flow(x[i], x[j])) for k in range(10) for j in range(10) for i in range(10)]
    case.write("0/U", head("volVectorField", "U") + "dimensions [0 1 -1 0 0 0 0];\n"
               "internalField nonuniform List<vector> 1000 (" + "\n".join(f"({row} 0)" for row in rows) + ");\n"
               "boundaryField { sides { type zeroGradient; } }\n")
    run(case, f"given, {name}", "scalarTransportFoam")
    return case


def after(case, field):
    """The spheres' field after the step."""
    return case.field(f"0.0001/lagrangian/particles/{field}")


# linear fields are sampled exactly, quadratic ones up to their curvature over a cell; the fields have 16 digits
U = after(given("acceleration", "virtualMass {}", lambda x, y: (5*x + 20*y, -5*y)), "U")[0]
# u.grad u = 25 (x, y); (2500 + 500) dv/dt = 500 of it
claim("given, acceleration: velocity due to added mass", close(U[0], 1e-4*25*0.0013/6, 1e-5))
claim("given, acceleration: velocity due to added mass, second axis", close(U[1], -1e-4*25*0.0021/6, 1e-5))

U = after(given("stress", "viscousStress {}", lambda x, y: (3000*y*y, 0)), "U")[0]
claim("given, stress: div tau is 2 mu k", close(U[0], 1e-4*1e-3*6000/2500, 1e-5))

case = given("shear", "saffmanMei {} viscousTorque { correction no; }", lambda x, y: (0.05 + 20*y, 0))
U, omega = after(case, "U")[0], after(case, "omega")[0]
# it lags by w = 0.05 - 0.042: Re_p = 8, k = 1e-3*20/(2*0.008) = 1.25; F = 1.615 rho d^2 sqrt(nu 20) J w towards the
# faster fluid; w changes by 1e-4 of itself
w, k = 0.008, 1.25
J = (1 - 0.3314*math.sqrt(k))*math.exp(-0.8) + 0.3314*math.sqrt(k)
claim("given, shear: lift towards the faster fluid, of the vorticity there",
      close(U[1], 1e-4*1.615*1000*1e-6*math.sqrt(1e-6*20)*J*w/(2500*math.pi*1e-9/6), 1e-3))
# towards -10 along z, I/(pi mu d^3) = 2500 d^2/(60 mu) = 1/24 s
claim("given, shear: torque towards half the vorticity", close(omega[2], -10*(1 - math.exp(-24e-4)), 1e-5))
claim("given, shear: no force along the slip", abs(U[0]) < 1e-8)

# two spheres in one cell, of 1 and 2 mm: their Sauter mean is 9/(1 + 4) mm = 1.8 mm
around, number, own = (
    after(given(f"sauter-{k}", f"beetstra {{ {mean}; }}", lambda x, y: (0.1, 0),
                "insert { two { type list; positions ((5e-4 5e-4 5e-4) (15e-4 15e-4 15e-4)); diameters (1e-3 2e-3); } }"
                ), "U") for k, mean in enumerate(("mean around", "meanDiameter 1.8e-3", "mean given")))
claim("given: the mean diameter around belongs to the position", np.array_equal(around, number))
claim("given: without it the drag differs", not np.array_equal(around, own))

# ---- spheres of 2 mm in water ----------------------------------------------------------------------


def sphere(density, two_way, early, late):
    """Speeds upwards after 0.05 s and 0.2 s."""
    what = f"density {density}, two-way {two_way}"
    case = Case(f"density-{density}-{two_way}", "settling")
    for entry, new in (("density 3000; youngsModulus 1e6", f"density {density}; youngsModulus 1e5"),
                       ("twoWay  *yes", f"twoWay {two_way}"), ("rho  *10;", "rho 1000;"),
                       ("wenYu", "schillerNaumann {} virtualMass"), ("diameter 1e-4", "diameter 2e-3"),
                       ("0.0457", "0.02")):
        case.sub("constant/demProperties", entry, new)
    case.edit("constant/transportProperties", nu=1e-6)
    run(case, what)
    share = 0.05 if two_way == "yes" else 0.01
    for time, speed in ((0.05, early), (0.2, late)):
        claim(f"{what}: speed after {time} s", close(case.field(f"{time}/lagrangian/particles/U")[0, 2], speed, share))
    if two_way == "yes":
        claim_exchange(f"density {density}", case)


# an independent integration of the equation of motion: 2 mm in water, let go at rest
for density, early, late in ((1.2, 0.20807078, 0.20822954), (500, 0.1244566, 0.1355485),
                             (990, 0.002969382, 0.0079304843), (1010, -0.0029346839, -0.0078825615)):
    if thorough or density in (1.2, 1010):
        sphere(density, "no", early, late)
        sphere(density, "yes", early, late)

# ---- bubbles, three tenths of the volume -----------------------------------------------------------

case = Case("swarm", "forces/swarm")
run(case, "swarm")
# a single bubble rises with 0.19 m/s; a diverging exchange doubles in each step
claim("swarm: bubbles stay bounded", largest(case.field("0.1/lagrangian/particles/U")) < 0.2)
claim("swarm: they come to rest", largest(case.field("0.2/lagrangian/particles/U")) < 0.1)
claim("swarm: the liquid stays bounded", largest(case.field("0.1/U")) < 0.1)
claim_exchange("swarm", case)
claim("swarm: volume is kept", worst(case.log(), "volume error") < 1e-12)
claim("swarm: the log names the forces",
      case.found("tenneti pressureGradient viscousStress virtualMass saffmanMei magnus viscousTorque"))
(case/"0.2").rename(case/"straight")
case.edit("system/controlDict", startTime=0.1)
case.run("demPimpleFoam")
claim("swarm: continues with the same bits: U", agrees(case/"0.2/U", case/"straight/U"))
claim("swarm: continues with the same bits: particles",
      agrees(case/"0.2/lagrangian/particles/U", case/"straight/lagrangian/particles/U"))
claim("swarm: continues with the same bits: snapshot",
      snapshot_hash(case/"0.2/uniform/dem.snapshot") == snapshot_hash(case/"straight/uniform/dem.snapshot"))

case.edit("system/controlDict", startTime=0, endTime=0.02, writeInterval=0.02)
case.run("demPimpleFoam")
alone = case.field("0.02/U")
case.remove("0.02")
case.run("decomposePar")
case.run("demPimpleFoam", ranks=2)
case.run("reconstructPar", "-latestTime")
claim_exchange("swarm, two ranks", case)
# the fluid's linear solver, 1e-11, and sums in another order
claim("swarm: the same on two ranks", difference(alone, case.field("0.02/U")) < 1e-6)

# ---- packings --------------------------------------------------------------------------------------

# Light spheres that displace the liquid rise to the ceiling and rest there. Pressure gradient and Du/Dt reach them a
# step late: without under-relaxation the packing alternates between the steps with up to 0.9 m/s, the more the shorter
# the step. One that rises has left 0.02 m/s behind it after these times.
# density, solid fraction, time step, end, virtual mass
packings = [(1.2, 0.3, 5e-4, 0.25, True), (1.2, 0.5, 5e-4, 0.2, True)]
if thorough:
    packings = [(1.2, 0.3, 2e-3, 0.25, True), (1.2, 0.3, 5e-4, 0.25, True), (1.2, 0.3, 1e-4, 0.25, True),
                (1.2, 0.5, 2e-3, 0.2, True), (1.2, 0.5, 5e-4, 0.2, True), (1.2, 0.5, 1e-4, 0.2, True),
                (100, 0.3, 5e-4, 0.3, True), (100, 0.5, 5e-4, 0.25, True), (100, 0.5, 1e-4, 0.25, False),
                (500, 0.3, 5e-4, 0.25, True), (500, 0.3, 1e-4, 0.25, True), (500, 0.5, 5e-4, 0.3, False),
                (500, 0.5, 1e-4, 0.3, False), (500, 0.5, 1e-4, 0.3, True), (990, 0.5, 2e-3, 0.2, True),
                (990, 0.5, 5e-4, 0.2, True), (990, 0.5, 1e-4, 0.2, False)]
for density, solid, step, end, mass in packings:
    what = f"packing of {density} kg/m3, {solid}, steps of {step:g} s" + ("" if mass else ", no added mass")
    case = Case("packing", "forces/swarm")
    case.sub("constant/demProperties", "density 1.2", f"density {density}")
    case.sub("constant/demProperties", "solidFraction 0.3", f"solidFraction {solid}")
    if not mass:
        case.sub("constant/demProperties", ".*virtualMass.*", "")
    case.edit("system/controlDict", deltaT=step, endTime=end, writeInterval=end)
    run(case, what)
    U = case.field(f"{end}/lagrangian/particles/U")
    claim(f"{what}: it rests", math.sqrt((U**2).sum(1).mean()) < 0.03)
    claim_exchange(what, case)


# ---- a dense fixed bed -----------------------------------------------------------------------------

# Liquid decelerates among fixed spheres, and their added mass (Zuber) increases its inertia:
# (e + s C) du/dt = -s 18 nu/d^2 u, s = 0.55, C = (1 + 2 s)/(2 e). An acceleration of the step before alone would
# diverge.

case = Case("bed", "momentum")
case.dictionary("constant/demProperties", """
materials { glass { density 2500; youngsModulus 1e5; } }
effects { hertz {} stokesDrag {} pressureGradient {} virtualMass { swarm zuber; } }
domain { min (0 0 0); max (0.012 0.012 0.012); periodic (x y z); }
insert { all { type random; diameter 8e-4; solidFraction 0.55; min (0 0 0); max (0.012 0.012 0.012); frozen yes; } }
coupling { rho 1000; }
""")
case.edit("0/U", internalField="uniform (0.01 0 0)")
case.edit("system/controlDict", endTime=0.02, deltaT=5e-4, writeInterval=0.02)
run(case, "bed")
fluid = case.vectors("fluid", "momentum")[:, 0]
s, nu, d = 0.55, 1e-6, 8e-4
e = 1 - s
# the bed is not uniform, and the first step has no acceleration: 3 %
claim("bed: the deceleration of the liquid includes the added mass",
      close(fluid[-1]/fluid[0], math.exp(-s*18*nu/d**2/(e + s*(1 + 2*s)/(2*e))*0.0195), 0.03))
claim_exchange("bed", case)

# ---- momentum --------------------------------------------------------------------------------------

for solver in ("demPimpleFoam", "pimpleFoam"):
    what = f"momentum, {solver}"
    case = Case(f"momentum-{solver}", "momentum")
    case.sub("constant/demProperties", "gidaspow", "tenneti {} viscousStress {} virtualMass { swarm felderhof; } "
             "saffmanMei {} magnus {} viscousTorque")
    case.sub("constant/demProperties", r"velocity \(", "spin (200 -100 300); velocity (")
    case.edit("system/controlDict", endTime=0.01, writeInterval=0.01)
    if solver == "pimpleFoam":
        case.append("system/controlDict", function_object)
    run(case, what, solver)
    claim_exchange(what, case, solver)
    total = case.vectors("sum", "momentum", solver)
    # the linear solver's tolerance
    claim(f"{what}: total momentum is kept", len(total) > 8 and
          np.linalg.norm(total - total[0], axis=1).max() < 1e-8*np.linalg.norm(total[0]))
    if solver == "demPimpleFoam":                     # those were 8 outer correctors; with one it is 1.2e-4
        case.sub("system/fvSolution", "nOuterCorrectors 8", "nOuterCorrectors 2")
        case.run(solver)
        total = case.vectors("sum", "momentum", solver)
        claim(f"{what}: total momentum is kept by two outer correctors (1e-6)", len(total) > 8 and
              np.linalg.norm(total - total[0], axis=1).max() < 1e-6*np.linalg.norm(total[0]))
finish()
