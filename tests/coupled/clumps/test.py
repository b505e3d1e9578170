"""Rigid bodies of several spheres (clumps) in a fluid.

- In a periodic box of liquid: the exchange closes, momentum and the volume of the unions are kept, in steps that change,
  with a restart and on two ranks; by function object in pisoFoam, too.
- The energy balance closes there, and in hot gas, where bodies collide, conduct, rub and break their bonds; the heat
  that they take is the heat that the gas loses, with a restart and on two ranks.
- A body of one sphere moves as the sphere.
- A lattice of heavy pairs of spheres in a duct: the pressure drop is n b U/e^2 of Hoelzer and Sommerfeld's law with the
  sphericities of two touching spheres, in flow along their axes and across them.
- Bodies that flow out of a duct leave as a whole, when their centre has passed the outlet.

SPDX-License-Identifier: GPL-3.0-or-later
"""
from case import *
from heat.balance import drift, heat, temperatures

pi = math.pi

# ---- a periodic box ----------------------------------------------------------------------------------

scene = """
materials { glass { density 2500; youngsModulus 1e5; poissonsRatio 0.3; } }
effects { hertz {} dry { restitution 0.9; } mindlin { friction 0.3; } hoelzerSommerfeld {} pressureGradient {}
          viscousTorque {} }
shapes { bent { spheres ((0 0 0 4e-4) (4.8e-4 0 0 3.2e-4) (4.8e-4 4e-4 0 2.4e-4)); } }
insert
{
    up   { type lattice; shape bent; count 120; seed 3; velocity (0.05 0 0.1); spin (50 0 0);
           min (0 0 0); max (0.012 0.012 0.006); }
    down { type lattice; shape bent; count 120; seed 4; velocity (0 -0.1 0); min (0 0 0.006); max (0.012 0.012 0.012); }
}
coupling { rho 1000; kernel diffusion; record { interval 0.005; energy yes; } }
"""
balance = "postProcessing/dem/*/energy.csv"


def box(name, scene):
    """The mesh of the momentum test with this scene."""
    case = Case(name, "momentum")
    case.edit("system/controlDict", endTime=0.03, writeInterval=0.015)
    case.dictionary("constant/demProperties", scene)
    return case


def exchanged(what, case, command="demPimpleFoam"):
    log = case.log(command)
    total, particles = case.vectors("sum", "momentum", command), case.vectors("particles", "momentum", command)
    size = np.linalg.norm(particles[0])
    claim(f"{what}: exchange closes", worst(log, "exchange error") < 1e-12)
    claim(f"{what}: volume is kept", worst(log, "volume error") < 1e-12)
    claim(f"{what}: bodies lose a third of their momentum to the liquid", np.linalg.norm(particles[-1]) < size*2/3)
    claim(f"{what}: total momentum is kept",
          len(total) > 20 and np.linalg.norm(total - total[0], axis=1).max() < 1e-12*size)


def end(case):
    return case.particles("0.03", "positions", "U"), case.field("0.03/U")


what = "240 bodies"
case = box("box", scene)
case.edit("system/controlDict", adjustTimeStep="yes", writeControl="adjustableRunTime", maxCo=0.3, maxParticleCo=0.04, maxDeltaT=0.001)
claim_runs(f"{what}: runs", case)
exchanged(what, case)
steps = case.numbers("^deltaT = (.*)")
claim(f"{what}: steps change", np.ptp(steps) > 0.05*steps.max(), np.ptp(steps)/steps.max())
V = 1.728e-6/216
solid = (V*(1 - case.field("0.03/voidFraction"))).sum()
mass = case.field("0.03/lagrangian/particles/mass").sum()
claim(f"{what}: the cells have the volume of the unions", close(solid, mass/2500, 1e-12))
spheres = 240*4/3*pi*(4e-4**3 + 3.2e-4**3 + 2.4e-4**3)
claim(f"{what}: which is less than the sum of the spheres", 0.6 < solid/spheres < 0.95, solid/spheres)
terms = {name: column[-1] for name, column in case.table(balance).items()}
claim(f"{what}: drag loses most of the energy, which is accounted for to round-off of all steps",
      terms["lost_hoelzerSommerfeld"] > 0.5*terms["total"] and abs(terms["residual"]) < 1e-11*terms["total"],
      terms["residual"])
alone = end(case)
(case/"0.03").rename(case/"straight")
case.run("demPimpleFoam")
claim(f"{what}: continued from 0.015 s, the same bits", all(map(np.array_equal, alone, end(case))))
case.remove("0.*")
case.run("decomposePar")
claim_runs(f"{what}: runs on two ranks", case, ranks=2)
exchanged(f"{what} on two ranks", case)
case.run("reconstructPar", "-latestTime")
claim(f"{what}: two ranks, the same positions and velocities (m, m/s)", difference(alone[0], end(case)[0]) < 1e-8)

# ---- in hot gas --------------------------------------------------------------------------------------

# bodies that fly through each other and hit a chain of four, bonded from the second sphere to the next body's first
case = Case("hot", "heat")
case.periodic((0.012, 0.012, 0.012), (6, 6, 6))
case.edit("system/controlDict", endTime=0.02, writeInterval=0.01, deltaT=0.001)
case.sub("system/fvSchemes", r"div\(alphaPhi,U\)", "div(alphaPhi,T) Gauss upwind; div(alphaPhi,U)")
lattice = "type lattice; shape bent; count 90; min (0 0"
case.properties(
    "glass { density 2500; youngsModulus 1e5; poissonsRatio 0.3; heatCapacity 20; conductivity 1; }",
    "hertz {} dry { restitution 0.9; } mindlin { friction 0.3; } hoelzerSommerfeld {} pressureGradient {} viscousTorque {}"
    " bondLinear { normalStiffness 1e8; shearStiffness 5e7; normalStrength 5e3; make listed; makeDistance 1.05; }"
    " gunn {} conduction {} frictionHeat {}",
    f"up {{ {lattice} 0); max (0.012 0.012 0.005); seed 3; velocity (0.5 0 1); spin (50 0 0); temperature 400; }}"
    f" down {{ {lattice} 0.007); max (0.012 0.012 0.012); seed 4; velocity (0 -1 0); temperature 300; }}"
    " chain { type list; shape bent; orientation (1 0 0 0); temperature 350;"
    " positions ((2e-3 6e-3 6e-3) (3.21e-3 6e-3 6e-3) (4.42e-3 6e-3 6e-3) (5.63e-3 6e-3 6e-3)); }",
    "rho 1.25; record { interval 0.001; energy yes; }",
    re.search("shapes.*", scene)[0] + " bonds { pairs (541 543  544 546  547 549); }")
case.run("blockMesh")


def balanced(what):
    """Claims of a run to 0.02 s: exchange, heat and energy of gas and bodies."""
    fluid, particles, owed, _, received = heat(case)
    terms = {name: column[-1] for name, column in case.table(balance).items()}
    claim(f"{what}: exchange closes", worst(case.log(), "heat exchange error") < 1e-13)
    claim(f"{what}: heat is kept", drift(case) < 1e-13, drift(case))
    gain, rubbed = particles[-1] + owed[-1] - particles[0] - owed[0], received[-1] - received[0]
    claim(f"{what}: bodies gain the heat that the gas loses, and heat of friction",
          gain > 0.03 and abs(gain - (fluid[0] - fluid[-1]) - rubbed) < 1e-13*fluid[0], gain, rubbed)
    claim(f"{what}: their heat content is accounted for, to the digits of the table",
          abs(terms["heat_content"] - terms["heat_fluid"] - terms["heat_dissipated"]) < 1e-11*terms["heat_content"])
    # 1e-4 of the total, 3e-4 with spheres instead, and 1e-7 at steps of 1e-6 s
    claim(f"{what}: the energy balance closes", abs(terms["residual"]) < 3e-4*terms["total"], terms["residual"])
    return terms


claim_runs("in hot gas: runs", case)
terms = balanced("in hot gas")
for name in ("lost_dry", "lost_mindlin", "lost_hoelzerSommerfeld", "work_viscousTorque", "broken"):
    claim(f"in hot gas: {name} counts", abs(terms[name]) > 5e-4*terms["total"], terms[name])
claim("in hot gas: the log has the heat of friction of the energy balance",
      close(heat(case)[4, -1], terms["heat_dissipated"], 1e-11))
mass, T = case.field("0.02/lagrangian/particles/mass"), case.field("0.02/lagrangian/particles/temperature")
claim("in hot gas: the log has the heat of their masses and temperatures", close(heat(case)[1, -1], 20*(mass*T).sum(), 1e-13))
bodies = case.particles("0.02", "temperature")[:, 1].reshape(184, 3)
claim("in hot gas: a body has one temperature, and others have others",
      np.ptp(bodies, 1).max() == 0 and np.ptp(bodies) > 10)
T = temperatures(case, 0.02)
claim("in hot gas: temperatures stay between the first ones", T.min() > 299.999 and T.max() < 500.001, T.min(), T.max())
hash = snapshot_hash(case/"0.02/uniform/dem.snapshot")
(case/"0.02").rename(case/"straight")
case.remove("postProcessing")
case.edit("system/controlDict", startTime=0.01)
claim_runs("in hot gas: continues from 0.01 s", case)
claim("continued in hot gas: the snapshot, to the last bit", snapshot_hash(case/"0.02/uniform/dem.snapshot") == hash)
claim("continued in hot gas: temperatures of the gas, to the last bit", agrees(case/"0.02/T", case/"straight/T"))
balanced("continued in hot gas")

# until 0.006 s; later, bodies have touched earlier or later, by the rounding of the gas
case.remove("0.0*", "postProcessing")
case.edit("system/controlDict", startTime=0, endTime=0.006, writeInterval=0.006)
ends = []
for ranks in (1, 2):
    if ranks > 1:
        case.run("decomposePar", "-force")
        case.remove("0.006", "postProcessing")
    claim_runs(f"in hot gas on {ranks} rank(s): runs to 0.006 s", case, ranks=ranks)
    claim(f"in hot gas on {ranks} rank(s): heat is kept", worst(case.log(), "heat exchange error") < 1e-13)
    if ranks > 1:
        case.run("reconstructPar", "-latestTime")
    terms = {name: column[-1] for name, column in case.table(balance).items() if name != "residual"}
    ends.append((case.field("0.006/T"), case.particles("0.006", "temperature"), terms))
claim("in hot gas: two ranks, the same temperatures (K)",
      max(difference(ends[0][k], ends[1][k]) for k in (0, 1)) < 1e-7, difference(ends[0][0], ends[1][0]))
claim("in hot gas: two ranks, the same energies (1e-8 of the total) and heat",
      all(abs(ends[0][2][name] - value) < 1e-8*ends[1][2]["heat_fluid" if "heat_" in name else "total"]
          for name, value in ends[1][2].items() if name not in ("time", "since")),
      *(f"{name} {value} {ends[0][2][name]}" for name, value in ends[1][2].items()))

# ---- by function object ------------------------------------------------------------------------------

case = Case("pisoFoam", "solvers")
case.sub("system/fvSolution", "^relaxationFactors.*\n", "")
case.sub("system/fvSolution", "nCorrectors [^;]*", "nCorrectors 8")
case.edit("system/controlDict", endTime=0.03, writeInterval=0.03)
case.write("constant/particles", """
shapes { pair { spheres ((0 0 0 5e-4) (6e-4 0 0 4e-4)); } }
insert { thrown { type random; shape pair; count 150; seed 7; velocity (0.1 0 0); min (0 0 0.01); max (0.02 0.02 0.03); } }
coupling { rho 1000; }
""")
claim_runs("pisoFoam: runs", case, "pisoFoam")
total = case.vectors("sum", "momentum", "pisoFoam")[:, 0]
claim("pisoFoam: exchange closes", worst(case.log("pisoFoam"), "exchange error") < 1e-12)
claim("pisoFoam: momentum along the box is kept", len(total) > 10 and largest(total/total[0] - 1) < 1e-11)

# ---- a body of one sphere ----------------------------------------------------------------------------

ends = []
for what in ("diameter 8e-4;", "shape one;"):
    case = box(what.split()[0], scene.replace("(4.8e-4 0 0 3.2e-4) (4.8e-4 4e-4 0 2.4e-4)", "").replace("bent", "one")
               .replace("shape one;", what).replace("shapes { one { spheres ((0 0 0 4e-4) ); } }",
                                                    "" if "diameter" in what else
                                                    "shapes { one { spheres ((0 0 0 4e-4)); } }"))
    case.edit("system/controlDict", endTime=0.015)
    claim_runs(f"{what} runs", case)
    ends.append((case.particles("0.015", "positions", "U"), case.field("0.015/U"), case.table(balance)))
claim("a body of one sphere moves as the sphere (m, m/s)", difference(ends[0][0], ends[1][0]) < 1e-10)
claim("and so does the liquid", difference(ends[0][1], ends[1][1]) < 1e-10)
claim("and its energies are the sphere's", all(close(column[-1], ends[1][2][name][-1], 1e-9)
                                               for name, column in ends[0][2].items() if name != "residual"))

# ---- pressure drop -----------------------------------------------------------------------------------

R, U, rho, nu, width = 4e-4, 1.0, 1.2, 1.5e-5, 1.6e-3
d = 2*R*2**(1/3)
e = 1 - 8/3*pi*R**3/width**3
phi, disc, half = 2**(2/3)/2, pi/4*d**2, 4*pi*R**2


def drop(A, A_l):
    """Pressure gradient by Hoelzer and Sommerfeld's law at these projected areas, with Di Felice's power [Pa/m]."""
    Re = U*d/nu
    Cd = (8/Re/math.sqrt(disc/(half - A_l)) + 16/Re/math.sqrt(phi) + 3/math.sqrt(Re)/phi**0.75
          + 0.42*10**(0.4*(-math.log10(phi))**0.2)*A/disc)
    chi = 3.7 - 0.65*math.exp(-0.5*(1.5 - math.log10(Re))**2)
    return 0.5*rho*U**2*Cd*disc/width**3*e**(-1 - chi)


for name, turn, areas in (("along", "0.70710678118654752 0 0.70710678118654752 0", (pi*R**2, 2*pi*R**2)),
                          ("across", "1 0 0 0", (2*pi*R**2, R**2*(1.5*pi + 2/pi)))):
    case = Case(name)
    case.controls(0.02, 1e-3, nu=nu)
    case.duct((3*width, 3*width, 16*width), (3, 3, 16), U, U)
    case.properties("heavy { density 1e9; youngsModulus 1e5; }", "hertz {} hoelzerSommerfeld {} pressureGradient {}",
                    f"bed {{ type lattice; shape pair; count 144; spacing 1; jitter 0; orientation ({turn});"
                    f" min (0 0 0); max ({3.00001*width} {3.00001*width} {16.00001*width}); }}", f"rho {rho};",
                    f"shapes {{ pair {{ spheres ((-{R} 0 0 {R}) ({R} 0 0 {R})); }} }}")
    claim_runs(f"flow {name}: runs", case)
    p = rho*case.field("0.02/p").reshape(16, 9).mean(1)
    found = (p[4] - p[12])/(8*width)
    # the table of areas, 3e-3; upwind cells
    claim(f"flow {name}: {found:.4g} Pa/m", close(found, drop(*areas), 5e-3), drop(*areas))

# ---- an outlet ---------------------------------------------------------------------------------------


def outflow(what):
    """Claim that bodies have left whole, and that none is beyond by more than a step; the spheres at the end."""
    table = case.table("postProcessing/dem/0/flows.csv")
    here = case.particles("0.04", "mass", "positions")
    body, mass, left = here[:, 0].astype(int)//3, here[:, 1], table["particles"][-1]
    claim(f"{what}: {left:g} of 300 bodies have left, and the others are whole",
          100 < left < 290 and len(here) == 3*(300 - left) and set(np.bincount(body)) <= {0, 3}, len(here))
    bodies = np.unique(body)
    each = np.bincount(body, mass)[bodies]
    claim(f"{what}: mass that left and mass that is there add up",
          close(mass.sum() + table["mass"][-1], 300*each[0], 1e-8))
    z = np.bincount(body, mass*here[:, -1])[bodies]/each
    claim(f"{what}: spheres are beyond the outlet, centres by less than a step",
          z.max() < 0.0244 and here[:, -1].max() > 0.024, (z.max(), here[:, -1].max()))
    return here


case = Case("outlet")
case.controls(0.04, 1e-3, nu=1e-6)
case.duct((0.012, 0.012, 0.024), (6, 6, 12), 0.4, 0.4)
case.properties("light { density 1000; youngsModulus 1e5; }", "hertz {} stokesDrag {} pressureGradient {}",
                "all { type random; shape bent; count 300; seed 3; velocity (0 0 0.4); spin (0 90 0);"
                " min (0 0 0); max (0.012 0.012 0.024); }", "rho 1000; kernel diffusion;",
                re.search("shapes.*", scene)[0] + " outlets { out { patch outlet; } }")
claim_runs("outlet: runs", case)
exchange, volume = (worst(case.log(), f"{word} error") for word in ("exchange", "volume"))
claim("outlet: exchange closes", exchange < 1e-12, exchange)
claim("outlet: volume is kept", volume < 1e-12, volume)
alone = outflow("outlet")
case.remove("0.0*")
case.run("decomposePar")
claim_runs("outlet: runs on two ranks", case, ranks=2)
case.run("reconstructPar", "-latestTime")
again = outflow("outlet, two ranks")
claim("outlet: the same spheres are left on two ranks", np.array_equal(alone[:, 0], again[:, 0]))
finish()
