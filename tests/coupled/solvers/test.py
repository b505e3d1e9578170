"""Particles by function object in pisoFoam, pimpleFoam, simpleFoam, interFoam and buoyantPimpleFoam, in one small box.

Spheres move as closed forms predict with the density, viscosity and pressure of the solver, and the fluid receives the
opposite momentum.

SPDX-License-Identifier: GPL-3.0-or-later
"""
from case import *
from closures import speed
from solvers.box import apart, fallen, prepare, spheres_apart

control = "system/controlDict"

# ---- a sphere falls through a fluid at rest, one-way ------------------------------------------------

# 10 kg/m3 and 1e-4 Pa s; buoyantPimpleFoam has its own
falls = {"pisoFoam": ("rho 10;", 10, 1e-4), "simpleFoam": ("rho 10; interval 0.001;", 10, 1e-4),
         "buoyantPimpleFoam": ("", 1.15860, 1e-3)}
if thorough:
    falls["pimpleFoam"] = falls["pisoFoam"]
for solver, (entries, rho, mu) in falls.items():
    what = f"{solver}, a sphere falls"
    case = prepare(solver, f"""
insert {{ one {{ type list; diameter 1e-4; positions ( (0.0071 0.0083 0.037) ); }} }}
coupling {{ twoWay no; {entries} }}
""")
    claim_runs(f"{what}: runs", case, solver)
    claim(f"{what}: the plan counts in steps of 1 ms", "fluid step 0.001 s" in case.log(solver))
    # 0.5 %: of the drag in cells of finite size with steps of 1 ms
    unit = 1000 if solver == "simpleFoam" else 1
    for t in (0.05, 0.1, 0.2):
        claim(f"{what}: speed after {t} s", close(fallen(case, f"{t*unit:g}"), speed(t, rho, mu), 0.005))

# ---- two liquids at rest: 500 kg/m3 above 1000, both of nu 1e-6; the surface is at 0.02 m -----------

# A heavy sphere sinks through both, at the speed of each liquid's density and viscosity. One of 750 kg/m3 rises from
# below and rests where the density is its own: in the middle of the interface.
case = prepare("interFoam", """
materials { light { density 750; youngsModulus 1e6; } }
insert
{
    sinks { type list; material sphere; diameter 1e-4; positions ( (0.0071 0.0083 0.0291) ); }
    rises { type list; material light; diameter 5e-4; positions ( (0.0143 0.0117 0.0103) ); }
}
coupling { twoWay no; kernel linear; walls (); }
walls { walls { material sphere; } }
""", "layers")
case.edit(control, endTime=1, deltaT=0.002, writeInterval=0.1)
case.run("interFoam")
what = "interFoam, two liquids"
claim_ran(f"{what}: runs", case, "interFoam")
claim(f"{what}: speed in the upper", close(fallen(case, "0.1"), speed(0.1, 500, 5e-4), 0.005))
claim(f"{what}: speed in the lower", close(fallen(case, "1"), speed(1, 1000, 1e-3), 0.005))
claim(f"{what}: the sphere of the density between rests at the surface",
      close(case.particles("1", "positions")[1, 3], 0.02, 1e-4))

# Frozen spheres in both and in the surface, two-way: their weight does not act on the fluid, and nothing moves. (They
# are inserted after the first step, which solves for the pressure: p_rgh = 0 does not hold for layers at rest.)
case = prepare("interFoam", """
insert
{
    fixed { type random; count 100; seed 3; diameter 1e-3; frozen yes; min (0 0 0.01); max (0.02 0.02 0.03); }
}
""", "rest")
case.edit(control, endTime=0.05)
case.sub(control, "type *demCloud;", r"\g<0> timeStart 0.002;")
case.run("interFoam")
what = "interFoam, spheres in liquids at rest, two-way"
claim_ran(f"{what}: runs", case, "interFoam")
# round-off of the pressure, 1e-16 of 400 Pa over 4 mm and 1 kg/m3, for 0.05 s: below 1e-12
claim(f"{what}: all stays at rest", largest(case.field("0.05/U")) < 1e-10)

# ---- spheres that move along the periodic box, two-way: momentum along it is kept -------------------

thrown = """
insert
{
    thrown { type random; count 200; seed 7; diameter 1e-3; velocity (0.1 0 0); min (0 0 0.01); max (0.02 0.02 0.03); }
}
"""
# tolerances of the total and of a restart: round-off; buoyantPimpleFoam updates its density after the momentum
# equation, and has another one after a restart
throws = {"pimpleFoam": (1e-12, 1e-11), "interFoam": (1e-12, 1e-11), "buoyantPimpleFoam": (1e-7, 1e-5)}
if thorough:
    throws["pisoFoam"] = throws["pimpleFoam"]
for solver, (drift, restart) in throws.items():
    density = "rho 1000;" if solver in ("pisoFoam", "pimpleFoam") else ""
    case = prepare(solver, thrown + f"coupling {{ {density} }}", f"momentum-{solver}")
    case.sub("system/fvSolution", "nCorrectors [^;]*", "nCorrectors 8")
    case.sub("system/fvSolution", "nOuterCorrectors [^;]*", "nOuterCorrectors 4")
    if solver == "buoyantPimpleFoam":
        case.sub("constant/thermophysicalProperties", "mu 1e-3", "mu 0.05")
        case.sub("constant/thermophysicalProperties", "28.9;", "28900;")
    else:
        # interFoam: the same viscosity in Pa s for both liquids, else the transposed part of the stress acts at walls
        # of type slip
        for old, new in (("nu +1e-05", "nu 5e-5"), ("water(.*)nu 1e-06", r"water\1nu 5e-5"),
                         ("oil(.*)nu 1e-06", r"oil\1nu 1e-4")):
            case.sub("constant/transportProperties", old, new)
    case.edit(control, endTime=0.06, writeInterval=0.03)
    case.run(solver)
    what = f"{solver}, moving spheres"
    claim_ran(f"{what}: runs", case, solver)
    claim(f"{what}: exchange closes", worst(case.log(solver), "exchange error") < 1e-12)
    particles, total = (case.vectors(word, "momentum", solver)[:, 0] for word in ("particles", "sum"))
    claim(f"{what}: they lose more than half of their momentum", particles[-1] < particles[0]/2)
    claim(f"{what}: total momentum is kept", len(total) > 30 and largest(total/total[0] - 1) < drift)
    (case/"0.06").rename(case/"straight")
    case.run(solver)
    claim(f"{what}: continued from 0.03 s, the spheres move as without a stop",
          spheres_apart(case, "straight", "0.06") < restart)

# Two ranks: the linear solvers sum in another order
case = prepare("interFoam", thrown, "ranks")
case.edit(control, endTime=0.02)
case.run("interFoam")
alone = case.vectors("particles", "momentum", "interFoam")[-1, 0]
case.run("decomposePar")
claim_runs("interFoam, two ranks: runs", case, "interFoam", ranks=2)
claim("interFoam, two ranks: exchange closes", worst(case.log("interFoam"), "exchange error") < 1e-12)
claim("interFoam, two ranks: the spheres move as on one",
      close(case.vectors("particles", "momentum", "interFoam")[-1, 0], alone, 1e-9))

# ---- simpleFoam, two-way: a duct with one frozen sphere in the middle of each cell ------------------

# 0.5 m/s of 1000 kg/m3 and 5e-5 m2/s from left to right. Drag on a sphere by Wen and Yu, f = 3 pi mu d u e^-2.65
# (1 + 0.15 Re^0.687), in each cell of volume V = (4 mm)^3; with the pressure's force on the sphere, f = e V dp/dx.
case = prepare("simpleFoam", """
insert
{
    fixed { type lattice; count 250; diameter 1e-3; frozen yes; spacing 4; jitter 0;
            min (0 0 0); max (0.020001 0.020001 0.040001); }
}
coupling { rho 1000; interval 1e-4; relaxation 0.2; }
""", "duct")
case.sub("constant/demProperties", r"periodic \(x\);", "")
case.sub("system/blockMeshDict", "type cyclic; neighbourPatch [a-z]*;", "type patch;")
case.edit("constant/transportProperties", nu=5e-5)
cyclic = r'"\(left\|right\)" { type cyclic; }'
case.sub("0/U", cyclic, "left { type fixedValue; value uniform (0.5 0 0); } right { type zeroGradient; }")
case.sub("0/U", "^internalField.*", "internalField uniform (0.5 0 0);")
case.sub("0/p", cyclic, "left { type fixedFluxExtrapolatedPressure; } right { type fixedValue; value uniform 0; }")
case.run("blockMesh")
claim_runs("simpleFoam, duct: runs", case, "simpleFoam")
V, d, rho, nu, u = 0.004**3, 1e-3, 1000, 5e-5, 0.5
e = 1 - math.pi/6*d**3/V
f = 3*math.pi*rho*nu*d*u*e**-2.65*(1 + 0.15*(e*d*u/nu)**0.687)
# the first cells are 4.5 cells before the outlet
claim("simpleFoam, duct: the pressure drop balances the drag",
      close(case.field("200/p")[0], 4.5*0.004*f/(e*V)/rho, 1e-4))
forces = case.numbers(r"force of the particles \((\S+) .* on the fluid \((\S+) ", "simpleFoam")
claim("simpleFoam, duct: at first the fluid gets a fraction of the force", forces[0, 1]/forces[0, 0] < 0.25)
claim("simpleFoam, duct: in the end the fluid gets the whole force of the particles",
      close(forces[-1, 1], forces[-1, 0], 1e-6))
(case/"200").rename(case/"straight")
case.remove("150")
case.run("simpleFoam")
claim("simpleFoam, duct: a restart from iteration 100 agrees with the uninterrupted run",
      apart(case.field("straight/particleForce"), case.field("200/particleForce")) < 1e-12)
finish()
