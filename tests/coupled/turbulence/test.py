"""Models of turbulence and of non-Newtonian stress use the volume-averaged flow.

- A quantity that is only convected (k of a model without sources) stays uniform through a fixed bed, behind it, and
  among particles that the flow takes along.
- Turbulence decays over the residence time of the fluid in a bed, not in an empty duct.
- The whole stress of a model acts on the fluid: shear waves in a Maxwell fluid, Reynolds stresses, Smagorinsky's
  viscosity. A uniform isotropic Reynolds stress moves nothing.
- Particles disperse as Tchen derived, in demPimpleFoam and pimpleFoam; the mean flow loses the turbulent energy that
  they produce.
- With -postProcess wallShearStress and yPlus are those of the run. Unsupported models are refused.

SPDX-License-Identifier: GPL-3.0-or-later
"""
from case import *

control, scene = "system/controlDict", "constant/demProperties"
free, slip, calculated = "type zeroGradient;", "type slip;", "type calculated; value uniform 0;"
kinetic, dissipation, viscosity = "0 2 -2 0 0 0 0", "0 2 -3 0 0 0 0", "0 2 -1 0 0 0 0"
without_sources = "Cmu 1e-20; C1 1e-20; C2 1e-20;"
z = (np.arange(40) + 0.5)*0.044/40                    # height of the cells of a box [m]
rest, no_stress = (0, 0, 0), (0, 0, 0, 0, 0, 0)


def entry(value):
    """A number, or the components of a vector or tensor, as OpenFOAM reads them."""
    return vector(value) if np.ndim(value) else f"{value:.17g}"


def fixed(value):
    return f"type fixedValue; value uniform {entry(value)};"


def field(case, name, dimensions, inside, inlet=None, outlet=free, sides=free):
    """Write 0/NAME with a uniform value, or one for each layer of a box, for all meshes of this test."""
    kind = {(): "Scalar", (3,): "Vector", (6,): "SymmTensor"}[np.shape(inside)[-1:]]
    if np.ndim(inside) == 2:
        values = f"nonuniform List<{kind[0].lower()}{kind[1:]}> 40 (" + " ".join(map(entry, inside)) + ")"
    else:
        values = f"uniform {entry(inside)}"
    case.dictionary(f"0/{name}", f"""dimensions [{dimensions}];
internalField {values};
boundaryField
{{
    "(inlet|floor)" {{ {inlet or fixed(inside)} }}
    sides {{ {sides} }}
    "(outlet|top)" {{ {outlet} }}
    "(west|east|south|north)" {{ type cyclic; }}
}}""", f"vol{kind}Field")


def eddies(case, k=None, epsilon=None, inlet=None):
    """Write nut, and k and epsilon if they are given."""
    for name, dimensions, value in (("k", kinetic, k), ("epsilon", dissipation, epsilon)):
        if value is not None:
            field(case, name, dimensions, value, inlet)
    field(case, "nut", viscosity, 0, calculated, calculated, calculated)


def velocity(case, inside, inlet=slip, outlet=slip, sides=slip):
    field(case, "U", "0 1 -1 0 0 0 0", inside, inlet, outlet, sides)


def turbulence(case, kind, model="", coefficients="", more="turbulence on;"):
    """Write constant/turbulenceProperties; kind is laminar, RAS or LES."""
    of_kind = f"{kind} {{ {kind}Model {model}; {more} {model}Coeffs {{ {coefficients} }} }}" if model else ""
    case.dictionary("constant/turbulenceProperties", f"simulationType {kind};\n{of_kind}")


def times(case, end, step=0.002):
    case.edit(control, endTime=end, writeInterval=end, deltaT=step)


# ---- convection only -------------------------------------------------------------------------------


def through(name, case):
    """k stays 1 in the bed of this case."""
    claim_runs(f"{name}: runs", case)
    claim(f"{name}: k without sources is uniform through a bed and behind it (1e-6)",
          largest(case.field("0.2/k") - 1) < 1e-6)


case = Case("kEpsilon")
eddies(case, 1, 1e-9)
turbulence(case, "RAS", "kEpsilon", without_sources)
through("kEpsilon", case)

# The same particles, light and free: the void fraction changes while the flow takes them along
case = Case("moving")
case.sub(scene, "frozen yes", "frozen no")
case.sub(scene, "density 2500", "density 20")
eddies(case, 1, 1e-9)
turbulence(case, "RAS", "kEpsilon", without_sources)
times(case, 0.02, 0.0005)
claim_runs("moving bed: runs", case)
claim("moving bed: the particles are taken along by more than a diameter",
      case.field("0.02/lagrangian/particles/U")[:, 2].mean()*0.01 > 1e-3)
claim("moving bed: k without sources stays uniform (1e-6)", largest(case.field("0.02/k") - 1) < 1e-6)

# The same bits after a restart, with the model's own coefficients
turbulence(case, "RAS", "kEpsilon")
eddies(case, 1, 100)
case.edit(control, writeInterval=0.01)
case.remove("0.02")
case.run("demPimpleFoam")
(case/"0.02").rename(case/"whole")
case.edit(control, startFrom="latestTime")
case.run("demPimpleFoam")
for name in ("k", "epsilon", "nut", "U"):
    claim(f"moving bed: a restart has the same {name}", agrees(case/"whole"/name, case/"0.02"/name))

# A mesh that moves: the piston of ../moving. Function objects find the model
case = Case("piston", "moving")
for name, dimensions, value in (("k", kinetic, 1), ("epsilon", dissipation, 1e-9)):
    field(case, name, dimensions, value, free, f"type inletOutlet; inletValue uniform {value}; value uniform {value};")
eddies(case)
turbulence(case, "RAS", "kEpsilon", without_sources)
case.sub("system/fvSolution", r'"U\.\*"', '"(U|k|epsilon).*"')
case.append(control, """
functions
{
    stress { type wallShearStress; libs ("libfieldFunctionObjects.so"); }
    wall { type yPlus; libs ("libfieldFunctionObjects.so"); writeControl writeTime; }
    load { type forces; libs ("libforces.so"); patches (floor); rho rhoInf; rhoInf 1.2; CofR (0 0 0); }
}
""")
claim_runs("moving mesh, with function objects: runs", case)
claim("moving mesh: k without sources stays uniform (1e-6)", largest(case.field("0.0390625/k") - 1) < 1e-6)
claim("moving mesh: wallShearStress and forces have the model",
      case.read("postProcessing/load/0/force.dat") and case.read("postProcessing/stress/0/wallShearStress.dat"))

written = {name: case.boundary(f"0.0390625/{name}", "floor") for name in ("wallShearStress", "yPlus")}
case.remove("0.0390625/wallShearStress", "0.0390625/yPlus")
for name in written:
    case.run("demPimpleFoam", "-postProcess", "-func", name, "-latestTime")
    claim(f"-postProcess -func {name}: as in the run (1e-6)",
          lambda: difference(case.boundary(f"0.0390625/{name}", "floor"), written[name]) < 1e-6*largest(written[name]))

case = Case("kOmegaSST")
eddies(case, 1)
field(case, "omega", "0 0 -1 0 0 0 0", 1e9)
turbulence(case, "RAS", "kOmegaSST", "betaStar 1e-18; beta1 1e-18; beta2 1e-18;")
through("kOmegaSST", case)

case = Case("kEqn")
eddies(case, 1)
filtered = "turbulence on; delta cubeRootVol; cubeRootVolCoeffs { deltaCoeff 1; }"
# v2112 and later read Ce from LES, not from kEqnCoeffs
turbulence(case, "LES", "kEqn", "Ck 1e-18; Ce 1e-18;", filtered + " Ce 1e-18;")
through("kEqn", case)

# ---- decay of grid turbulence ----------------------------------------------------------------------

# dk/dt = -epsilon, de/dt = -C2 epsilon^2/k: k = (1 + (C2 - 1) epsilon0 t)^(-1/(C2 - 1)) of k0 = 1, at the time
# t = integral of e/0.3 dz since the inlet
case = Case("decay")
case.duct((0.0044, 0.0044, 0.044), (2, 2, 80), 0.3, 0.3)
case.sub(scene, "kernel .*", "kernel diffusion;")
eddies(case, 1, 10)
turbulence(case, "RAS", "kEpsilon", "Cmu 1e-20; C1 1e-20; C2 1.92;")
claim_runs("decay: runs", case)
e, k = (case.field(f"0.2/{name}")[::4] for name in ("voidFraction", "k"))
residence = e*0.044/80/0.3
t = np.cumsum(residence) - residence/2
off = largest(k/(1 + 0.92*10*t)**(-1/0.92) - 1)
claim("decay: k falls over the residence time in the bed (1 %)", k.size == 80 and off < 0.01, off)

# ---- stress in a box of fixed particles without drag -----------------------------------------------


def box(name, ends="wall"):
    """A box between z = 0 and 0.044, periodic in x and y, with a lattice of particles. A model sets the Reynolds stress
    of ends that are walls."""
    case = Case(name)
    case.box((0.0022, 0.0022, 0.044), (1, 1, 40),
             {"inlet": (ends, "z-"), "outlet": (ends, "z+"),
              "west": ("cyclic; neighbourPatch east", "x-"), "east": ("cyclic; neighbourPatch west", "x+"),
              "south": ("cyclic; neighbourPatch north", "y-"), "north": ("cyclic; neighbourPatch south", "y+")})
    case.sub(scene, r"count 256(.|\n)*?max \(.*?\)",
             "count 160; spacing 1.1; jitter 0; frozen yes; min (0 0 0); max (0.0022 0.0022 0.044)")
    case.sub(scene, " gidaspow {}", "")
    field(case, "p", kinetic, 0, "type fixedFluxPressure;", "type fixedFluxPressure;")
    return case


# Shear wave U = cos(pi z/L): lambda s'' + s' + nuM (pi/L)^2 s = 0 with s(0) = 1, s'(0) = 0 for the Maxwell fluid,
# s' + nu (pi/L)^2 s = 0 for the Newtonian one. lambda 0.02 s, nuM k^2 = 100/s.
def wave(case):
    """The amplitude of a shear wave after 0.04 s."""
    velocity(case, np.outer(np.cos(math.pi*z/0.044), (1, 0, 0)))
    times(case, 0.04, 0.0001)
    case.run("demPimpleFoam")
    return case.field("0.04/U")[0, 0]/math.cos(math.pi*z[0]/0.044)


case = box("Maxwell")
case.edit("constant/transportProperties", nu=1e-9)
field(case, "sigma", kinetic, no_stress, fixed(no_stress), fixed(no_stress))
turbulence(case, "laminar", "Maxwell", "nuM 0.0196157; lambda 0.02;")
amplitude = wave(case)
claim_ran("Maxwell: runs", case)
claim("Maxwell: the void fraction is below 0.65", case.field("0.04/voidFraction")[0] < 0.65)
w = math.sqrt(100/0.02 - 1/(4*0.02**2))
exact = math.exp(-0.04/0.04)*(math.cos(w*0.04) + math.sin(w*0.04)/(2*0.02*w))
claim(f"Maxwell: a shear wave swings back, {exact:.6g} of its amplitude (0.01)", abs(amplitude - exact) < 0.01,
      amplitude)

case = box("Stokes")
case.edit("constant/transportProperties", nu=0.00196157)
turbulence(case, "laminar")
amplitude = wave(case)
claim("Newtonian: a shear wave decays by exp(-nu k^2 t) (1 %)", close(amplitude, math.exp(-10*0.04), 0.01), amplitude)

# Reynolds stresses that change along z, Rxz = 2 z: dU/dt = -2 m/s2 all over
for model in ("LRR", "SSG"):
    case = box(model, "patch")
    velocity(case, rest)
    R = np.tile([1.0, 0, 0, 1, 0, 1], (40, 1))
    R[:, 2] = 2*z
    field(case, "R", kinetic, R, fixed((1, 0, 0, 1, 0, 1)), fixed((1, 0, 0.088, 1, 0, 1)))
    eddies(case, epsilon=1e-9, inlet=free)
    times(case, 0.04)
    case.sub(scene, "rho .*", "rho 1.2; record { interval 0.002; budget yes; }")
    turbulence(case, "RAS", model, "Cmu 1e-20; Cs 1e-20; Ceps 1e-20; wallReflection no;")
    claim_runs(f"{model}: runs", case)
    claim(f"{model}: the fluid is accelerated by the Reynolds stress, -dRxz/dz (1e-5)",
          largest(case.field("0.04/U")[:, 0] + 0.08) < 8e-7)
    budget = case.table("postProcessing/dem/0/budget.csv")
    claim(f"{model}: the budget of momentum closes with the stress on the patches (1e-12)",
          abs(budget["rest.px"][-1]/budget["fluid.px"][-1]) < 1e-12)

# Isotropic ones act within the pressure, also where the void fraction changes
case = Case("isotropic")
velocity(case, rest, fixed(rest), free)
field(case, "R", kinetic, (1, 0, 0, 1, 0, 1))
eddies(case, epsilon=1e-9)
turbulence(case, "RAS", "LRR", "Cmu 1e-20; Cs 1e-20; Ceps 1e-20;")
times(case, 0.002)
claim_runs("isotropic stress: runs", case)
claim("isotropic stress: moves no fluid at the surfaces of a bed", largest(case.field("0.002/U")) < 1e-9)

# Uniform shear 50/s: nut = Ck Delta sqrt(k), k = Ck/Ce (Delta 50/s)^2; the same at the walls, so the shear stays
# uniform
case = box("Smagorinsky")
velocity(case, np.outer(50*z, (1, 0, 0)), fixed(rest), fixed((2.2, 0, 0)))
field(case, "nut", viscosity, 0, free)
turbulence(case, "LES", "Smagorinsky", "Ck 0.094; Ce 1.048;", filtered)
times(case, 0.002)
claim_runs("Smagorinsky: runs", case)
width = (0.0022*0.0022*0.0011)**(1/3)
claim("Smagorinsky: viscosity in uniform shear (1e-6)",
      largest(case.field("0.002/nut") - 0.094*width*math.sqrt(0.094/1.048)*width*50) < 1e-10)

# ---- turbulent dispersion of particles -------------------------------------------------------------


# Light, free particles in k = 1.5, epsilon = 2.25: U = 1 m/s, T = 0.1 s. Relaxation time tau = T: variance of their
# velocity U^2 T/(T + tau) = 0.5. Four standard deviations of 3*343 numbers: 18 %.
def disperses(solver, two_way):
    """Run them for 0.8 s in a box of 8 m."""
    case = Case(f"dispersion-{solver}-{two_way}")
    case.box((8, 8, 8), (4, 4, 4),
             {"inlet": ("patch", "z-"), "sides": ("patch", "y- x+ y+ x-"), "outlet": ("patch", "z+")})
    case.properties("bead { density 1000; youngsModulus 1e6; }",
                    "stokesDrag {} pressureGradient {} turbulentDispersion { crossing no; }",
                    "beads { type lattice; material bead; diameter 1e-3; count 343; spacing 300; jitter 0; "
                    "min (3 3 3); max (5.1 5.1 5.1); }", f"rho 1; twoWay {two_way};", "time { step 5e-3; }")
    case.edit("constant/transportProperties", nu=5.55556e-4)
    velocity(case, rest)
    field(case, "p", kinetic, 0, free, fixed(0))
    eddies(case, 1.5, 2.25, free)
    turbulence(case, "RAS", "kEpsilon", without_sources, "turbulence off;")
    case.edit(control, deltaT=0.02, endTime=0.8, writeInterval=0.4)
    if solver != "demPimpleFoam":
        case.append(control, 'functions { particles { type demCloud; libs ("libdemCoupling.so"); } }\n')
    claim_runs(f"dispersion, {solver}, two-way {two_way}: runs", case, solver)
    return case


beads = "0.8/lagrangian/particles/U"
for solver in ("demPimpleFoam", "pimpleFoam"):
    case = disperses(solver, "no")
    u2 = (case.field(beads)**2).mean()
    claim(f"dispersion, {solver}: variance of the particles' velocity, {u2:.6g}, is Tchen's (18 %)",
          close(u2, 0.5, 0.18))

case = disperses("demPimpleFoam", "yes")
claim("dispersion, momentum: the exchange closes", worst(case.log(), "exchange error") < 1e-12)
(case/"0.8").rename(case/"whole")
case.edit(control, startFrom="latestTime")
case.run("demPimpleFoam")
claim("dispersion: a restart has the same velocities", agrees(case/beads, case/beads.replace("0.8", "whole")))

# ---- turbulence made by particles ------------------------------------------------------------------

# Fluid slows down among fixed particles: e (U^2/2 + k) is constant, epsilon ~ k^C with C = 1.8. The sources are
# explicit in steps of 1/60 of the time in which k doubles.
case = box("source")
case.sub(scene, "pressureGradient", "stokesDrag {} pressureGradient")
case.edit("constant/transportProperties", nu=1.8e-5)
velocity(case, (1, 0, 0))
eddies(case, 0.1, 1e-6, free)
turbulence(case, "RAS", "kEpsilon", without_sources)
case.dictionary("constant/fvOptions", 'particles { type demTurbulenceSource; libs ("libdemCoupling.so"); }')
times(case, 0.004, 1e-5)
claim_runs("source: runs", case)
U, k, epsilon = case.field("0.004/U")[:, 0].mean(), case.field("0.004/k").mean(), case.field("0.004/epsilon").mean()
claim(f"source: drag slows the fluid down, to {U:.6g} m/s", U < 0.7)
claim("source: the turbulence gains what the mean flow loses (1 %)", close(k - 0.1, 0.5*(1 - U*U), 0.01))
claim("source: epsilon/epsilon0 is (k/k0)^1.8 (2 %)", close(epsilon, 1e-6*(k/0.1)**1.8, 0.02))


# ---- refusals --------------------------------------------------------------------------------------


def refused(what, case, words):
    """The run ends with an error that contains these words."""
    run = case.run("demPimpleFoam")
    claim(what, not run and re.search(words, " ".join(run.log.split())), run.log[-1000:])


turbulence(case, "laminar")
refused("source: refused without an equation of k", case, "has no equation of k")

case = box("refused")
velocity(case, rest)
turbulence(case, "RAS", "ShihQuadraticKE")
refused("refused: a model without a form for varying void fraction, with those there are", case,
        "ShihQuadraticKE of constant/turbulenceProperties has no form .*there are .*LRR")
turbulence(case, "mixingLength")
refused("refused: an unknown type", case, "mixingLength; there are laminar, RAS and LES")
case.sub(scene, "effects {", "effects { turbulentDispersion {}")
turbulence(case, "laminar")
refused("refused: turbulent dispersion in a laminar flow", case,
        "turbulentDispersion needs the turbulent kinetic energy")
case.sub(scene, " turbulentDispersion {}", " viscousStress {}")
turbulence(case, "laminar", "Maxwell", "nuM 1e-3; lambda 1e-3;")
field(case, "sigma", kinetic, no_stress, free)
refused("refused: particles that feel a stress that no viscosity describes", case,
        "viscousStress knows the stress of a viscosity only")
finish()
