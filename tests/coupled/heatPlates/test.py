"""Heat between two plates in demPimpleFoam: turbulent conduction, natural convection.

- A sine wave of temperature between plates of 300 K decays by conduction, by k_t = rho Cp nu_t/Prt of a given nu_t,
  and by spheres of 300 K, at the rate of the discrete equations (1e-7).
- Between a cold and a warm plate the conduction of budget.csv matches the linear profile (1e-9).
- Between a warm and a cold vertical plate the fluid has the cubic profile of velocity (1e-6).

SPDX-License-Identifier: GPL-3.0-or-later
"""
from case import *
from heat.balance import drift, heat

n = 8                                                 # cells of 2 mm from plate to plate, in x
scene, transport = "constant/demProperties", "constant/transportProperties"
e = 1 - math.pi/6*1e-9/8e-9                           # void fraction with one sphere in each cell
x = (np.arange(n) + 0.5)/n                            # from plate to plate
positions = " ".join(f"({0.016*a:.17g} {b} {c})" for a in x for b in (1e-3, 3e-3) for c in (1e-3, 3e-3))


def field(case, name, dimensions, inside, plates, kind="volScalarField"):
    """Write a field, periodic in y and z; `inside` is its value or one for each cell of a row from plate to plate."""
    if isinstance(inside, np.ndarray):
        inside = f"nonuniform List<scalar> {4*n} (" + " ".join(f"{value:.17g}" for value in np.tile(inside, 4)) + ")"
    else:
        inside = f"uniform {inside}"
    case.dictionary(f"0/{name}", f"dimensions [{dimensions}]; internalField {inside};\n"
                    f'boundaryField {{ "(y|z).*" {{ type cyclic; }} {plates} }}', kind)


def plates(name, T, at_plates, insert, end, step):
    """The case of heat/ between plates."""
    case = Case(name, "heat")
    case.box((0.016, 0.004, 0.004), (n, 2, 2),
             {"cold": ("wall", "x-"), "warm": ("wall", "x+")}, cyclic="yz")
    field(case, "U", "0 1 -1 0 0 0 0", "(0 0 0)", '"(cold|warm)" { type noSlip; }', "volVectorField")
    field(case, "p", "0 2 -2 0 0 0 0", 0, '"(cold|warm)" { type fixedFluxPressure; }')
    field(case, "T", "0 0 0 1 0 0 0", T, at_plates)
    case.sub(scene, r"^insert(.|\n)*?^}", f"insert {{ bed {{ type list; diameter 1e-3; frozen yes; {insert} }} }}")
    case.edit("system/controlDict", endTime=end, deltaT=step, writeInterval=end)
    return case


def refused(what, case, sentence):
    claim(what, not case.run("demPimpleFoam") and case.found(sentence))


# ---- turbulent conduction --------------------------------------------------------------------------

# One sphere of 1 mm in the middle of each cell: with `kernel divided` all its exchange is there. Its capacity is so
# large that it stays at 300 K (1e-6 K).
case = plates("conduction", 300 + 100*np.sin(math.pi*x), '"(cold|warm)" { type fixedValue; value uniform 300; }',
              f"temperature 300; positions ({positions});", 0.04, 0.001)
for name, dimensions, value in (("k", "0 2 -2", 0.01), ("epsilon", "0 2 -3", 0.1)):
    field(case, name, f"{dimensions} 0 0 0 0", value, f'"(cold|warm)" {{ type fixedValue; value uniform {value}; }}')
field(case, "nut", "0 2 -1 0 0 0 0", 0, '"(cold|warm)" { type calculated; value uniform 0; }')
case.sub(scene, "heatCapacity 20", "heatCapacity 1e9")
case.sub(scene, "kernel diffusion", "kernel divided")


def first_cell(nut, Prt):
    """Temperature of the first cell at 0.04 s, less 300 K; 40 implicit steps, Nu = 2."""
    a, s, h = 0.025/1250 + nut/Prt, math.sin(math.pi/(2*n)), 2e-3
    return 100*s*(1 + 1e-3*(a*4*s*s/h**2 + 2*math.pi*1e-3*0.025/(e*h**3*1250)))**-40


for name, simulation, nut, Prt, entry in (("laminar", "laminar", 0, 1, ""),
                                          ("turbulent", "RAS", 9e-5, 0.85, ""),       # Cmu k^2/epsilon = 0.09*1e-4/0.1
                                          ("turbulent, Prt", "RAS", 9e-5, 0.5, "Prt 0.5;")):
    case.dictionary("constant/turbulenceProperties",
                    f"simulationType {simulation}; RAS {{ RASModel kEpsilon; turbulence off; }}")
    case.append(transport, entry)
    claim_runs(f"conduction, {name}: runs", case)
    claim(f"conduction, {name}: a sine wave decays at its rate (1e-7)",
          close(case.field("0.04/T")[0] - 300, first_cell(nut, Prt), 1e-7))

case.sub(scene, "heatCapacity 1e9", "heatCapacity 20")
case.run("demPimpleFoam")
fluid, *_, received = heat(case)
claim("conduction: energy is conserved, with glass spheres and the heat of the plates", drift(case) < 1e-12)
claim("conduction: that is more than 1 % of the fluid's", -received[-1]/fluid[0] > 0.01)
case.sub(transport, "Prt 0.5", "Prt 0")
refused("conduction: a turbulent Prandtl number of zero is refused", case,
        "Prt, the turbulent Prandtl number of the fluid, is 0")

# ---- conduction through the plates -----------------------------------------------------------------

# The linear profile of fluid and spheres is steady. A plate has the void fraction of its cell.
spheres = " ".join(f"{T:.17g}" for T in np.repeat(290 + 20*x, 4))
between = "cold { type fixedValue; value uniform 290; } warm { type fixedValue; value uniform 310; }"
case = plates("linear", 290 + 20*x, between, f"positions ({positions}); temperatures ({spheres});", 0.04, 0.001)
case.sub(scene, "kernel diffusion;", "kernel divided; record { interval 1e-3; budget yes; }")
case.edit(transport, kappa=1.25, Prt=0.85)
claim_runs("linear profile: runs", case)
budget = {name: column[-1] for name, column in case.table("postProcessing/dem/0/budget.csv").items()}
conducted = e*1.25*20/0.016*0.004**2*(budget["time"] - budget["since"])
for plate, sign in (("cold", -1), ("warm", 1)):
    claim(f"linear profile: conduction through the {plate} plate is e kappa dT/w A t (1e-9)",
          close(budget[f"conduction:{plate}.heat"], sign*conducted, 1e-9))
    claim(f"linear profile: nothing flows through the {plate} plate", budget[f"flow:{plate}.heat"] == 0)

# ---- natural convection ----------------------------------------------------------------------------

case = plates("convection", 300, between, "temperature 300; positions ((0.003 0.001 0.001));", 1, 0.01)
case.edit(transport, nu=1e-3, kappa=1.25, beta=2e-3, TRef=300)
case.sub(scene, "kernel diffusion", "twoWay no")
case.sub(scene, "effects {", "effects { gravity { acceleration (0 0 -9.81); }")
claim_runs("convection: runs", case)
# nu u'' = - beta g (T - TRef), y from -1/2 to 1/2 over the width w: u = G (y/4 - y^3)/6, G = beta g dT w^2/nu. Central
# differences are exact for it but at the plates, where half a cell d = 1/(2 n) adds G d^2 y/2
y, G, U = x - 0.5, 2e-3*9.81*20*0.016**2/1e-3, case.field("1/U")[:n]
u = G*((y/4 - y**3)/6 + (0.5/n)**2*y/2)
claim("convection: the cubic profile of velocity, with its sign (1e-6 of the largest)",
      difference(U[:, 2], u) < 1e-6*u.max(), difference(U[:, 2], u)/u.max())
claim("convection: no flow across it (m/s)", np.linalg.norm(U[:, :2], axis=1).max() < 1e-9)
claim("convection: the temperature is linear (K)", difference(case.field("1/T"), np.tile(290 + 20*x, 4)) < 1e-9)
finish()
