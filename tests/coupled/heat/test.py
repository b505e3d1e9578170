"""Heat exchange between fluid and particles in demPimpleFoam.

- Gas and spheres at rest approach each other as two lumped capacities do, with an error of first order in the step;
  at steps of 0.1 to 100 relaxation times of a sphere they end at the mixed temperature.
- Spheres fly through each other: the energy of fluid, particles and owed heat is conserved to rounding, no
  temperature leaves the initial range, and a uniform temperature stays uniform.
- Two ranks have the temperatures of one; a restarted run has the bits of the uninterrupted one.
- A sphere held in a stream cools by the law; so does a parcel of 27 such grains.
- Parcels at rest have the temperatures of their grains; moving parcels of two ratios conserve energy.
- Hot gas over cold gas stays at rest in a bed; a warm layer below rises.
- Relaxation of T in the last iteration is refused.
- Messages name what a scene needs and the case lacks.

SPDX-License-Identifier: GPL-3.0-or-later
"""
from case import *
from heat.balance import *

control, scene, transport = "system/controlDict", "constant/demProperties", "constant/transportProperties"
box = 8e-3**3, 64                                     # its volume [m3], and number of spheres


def mixes(what, case, c, cf):
    """After 200 steps of 1 ms all temperatures are the mixed one, and energy is kept."""
    case.edit(control, deltaT=0.001, endTime=0.2, writeInterval=0.2)
    case.sub(scene, "heatCapacity [^;]*", f"heatCapacity {c:.17g}")
    case.edit(transport, Cp=f"{cf:.17g}")
    case.run("demPimpleFoam")
    mixed = capacities(*box, c, cf)[2]
    T = temperatures(case, 0.2)
    claim(what, difference(T, np.full(T.size, mixed)) < 1e-9*mixed and drift(case) < 1e-12, mixed, T.min(), T.max())


def conserves(name, case, end):
    """Claims of spheres that fly through hot gas."""
    claim_ran(f"{name}: runs", case)
    claim(f"{name}: exchange closes", worst(case.log(), "heat exchange error") < 1e-13)
    claim(f"{name}: energy is kept", drift(case) < 1e-12, drift(case))
    T, fluid = temperatures(case, end), heat(case)[0]
    claim(f"{name}: temperatures stay between the first ones", T.min() > 299.9999 and T.max() < 500.0001)
    claim(f"{name}: the fluid has cooled by more than 50 K", fluid[-1]/fluid[0] < 0.9)


# ---- at rest ---------------------------------------------------------------------------------------

case = Case("rest")
claim_runs("at rest: runs", case)
coarse = relaxation(case, *box)
claim("at rest: two lumped capacities (0.5 %)", coarse < 0.005, coarse)
claim("at rest: exchange closes", worst(case.log(), "heat exchange error") < 1e-13)
claim("at rest: energy is kept", drift(case) < 1e-13)
case.edit(control, deltaT=0.00025)
case.run("demPimpleFoam")
claim("at rest: half the step, half the error (10 %)", close(coarse/relaxation(case, *box), 2, 0.1))

# steps over a sphere's relaxation time, heat capacity of the particles over the fluid's
for steps, ratio in ((0.1, 100), (1, 1), (10, 1000), (100, 100)) if thorough else ((0.1, 100), (100, 100)):
    c = 0.12/steps
    Cp, Cf, _ = capacities(*box, c, 1)
    mixes(f"at rest: steps of {steps} tau at {ratio} times the fluid's capacity end at the mixed temperature",
          case, c, Cp/Cf/ratio)

# ---- in motion -------------------------------------------------------------------------------------

case = Case("motion")
case.edit(control, writeInterval=0.005)
crossing(case, "diameter 8e-4; count 500; temperature 400;", "diameter 8e-4; count 500; temperature 300;")
case.run("demPimpleFoam")
conserves("in motion", case, 0.02)

one = case.field("0.005/T")
case.remove("0.0*")
case.edit(control, endTime=0.005)
case.run("decomposePar")
claim_runs("two ranks: runs", case, ranks=2)
case.run("reconstructPar", "-time", "0.005")
claim("two ranks: the fluid has the temperatures of one (K)",
      one.size == 216 and difference(case.field("0.005/T"), one) < 1e-7)

case.remove("0.0*")
case.sub(scene, "temperature [34]00", "temperature 500")
case.run("demPimpleFoam")
claim("in motion: a uniform temperature stays uniform", largest(temperatures(case, 0.005)/500 - 1) < 1e-12)

# ---- restart ---------------------------------------------------------------------------------------

case = Case("restart", "restart")
case.edit(transport, nu=1.5e-5, Cp=1000, kappa=0.025)
case.initial("T", "0 0 0 1 0 0 0", 500,
             '"(left|right|front|back)" { type cyclic; } walls { type fixedValue; value uniform 400; }')
case.sub(scene, "youngsModulus 1e6;", "youngsModulus 1e6; heatCapacity 20;")
case.sub(scene, "gidaspow {}", "gidaspow {} gunn {}")
case.sub("system/fvSolution", r'"U\.\*"', '"(U|T).*"')
claim_runs("restart: runs", case)
(case/"0.012").rename(case/"straight")
case.edit(control, startTime=0.008)
case.run("demPimpleFoam")
claim("restart: temperature of the fluid, to the last bit", agrees(case/"straight/T", case/"0.012/T"))
claim("restart: temperatures of the particles, to the last bit",
      agrees(*(case/time/"lagrangian/particles/temperature" for time in ("straight", "0.012"))))
claim("restart: the snapshot, to the last bit",
      snapshot_hash(case/"straight/uniform/dem.snapshot") == snapshot_hash(case/"0.012/uniform/dem.snapshot"))

# ---- one sphere, or one parcel, in a stream --------------------------------------------------------

case = Case("stream")
case.periodic((0.04, 0.04, 0.04), (2, 2, 2))
case.sub("0/U", r"uniform \(0 0 0\)", "uniform (2 0 0)")
case.properties("glass { density 2500; youngsModulus 1e5; heatCapacity 20; }",
                "hertz {} schillerNaumann {} pressureGradient {} ranzMarshall {}",
                "one { type list; diameter 1e-3; temperature 300; frozen yes; positions ((0.01 0.01 0.01)); }",
                "rho 1.25; twoWay no;")
case.run("demPimpleFoam")
# Ranz and Marshall: Re = 1e-3*2/1.5e-5, Pr = 1.25*1.5e-5*1000/0.025
Nu = 2 + 0.6*math.sqrt(1e-3*2/1.5e-5)*0.75**(1/3)
grain = 500 - 200*math.exp(-0.04*math.pi*1e-3*0.025*Nu/(2500*math.pi/6*1e-9*20))
temperature = "0.04/lagrangian/particles/temperature"
claim("stream: a sphere tends to its temperature by the law (1e-9)", close(case.field(temperature)[0], grain, 1e-9))

# the parcel has the grain's diameter in the scene, its Reynolds and Nusselt number, and 27 times its heat
case.sub(scene, "^effects", "parcels { ratio 3; }\neffects")
case.remove("0.0*")
case.run("demPimpleFoam")
claim("parcels: one in a stream tends to its temperature as its grains do (1e-9)",
      close(case.field(temperature)[0], grain, 1e-9))
claim("parcels: it is 3 grains wide", close(case.field("0.04/lagrangian/particles/d")[0], 3e-3, 1e-12))

# ---- parcels ---------------------------------------------------------------------------------------

# 64 grains, or 8 parcels of them, one in each cell, at rest in a gas at rest; Nu of Gunn at Re = 0
case = Case("parcels")
case.sub(scene, "ranzMarshall", "gunn")
case.run("demPimpleFoam")
e = 1 - 64*math.pi/6*1e-9/8e-3**3
Nu = 7 - 10*e + 5*e*e
claim("parcels: grains are two lumped capacities (0.5 %)", relaxation(case, *box, Nu) < 0.005)
grains, gas = case.field(temperature), heat(case)[0, -1]
case.sub(scene, "^effects", "parcels { ratio 2; }\neffects")
case.sub(scene, "count 64", "count 8")
case.remove("0.0*")
case.run("demPimpleFoam")
parcels = case.field(temperature)
claim_ran("parcels: runs", case)
claim("parcels: so are parcels (0.5 %)", relaxation(case, *box, Nu) < 0.005)
claim("parcels: 8 for 64 grains", (grains.size, parcels.size) == (64, 8))
claim("parcels: they have the temperature of grains", largest(np.append(grains, parcels)/parcels[0] - 1) < 1e-13)
claim("parcels: their gas has the same heat as with grains", close(heat(case)[0, -1], gas, 1e-13))
claim("parcels: energy is kept", drift(case) < 1e-13)
mixes("parcels: steps of 10 relaxation times end at the mixed temperature (1e-9)", case, 0.012, 1)

# of two ratios and sizes, through each other and through gas that blows
case = Case("parcels-motion")
crossing(case, "diameter 4e-4; count 500; temperature 400;",
         "diameter 3e-4; parcelRatio 3; count 300; temperature 300;", "parcels { ratio 2; }")
case.sub("0/U", r"uniform \(0 0 0\)", "uniform (1 0 0)")
case.run("demPimpleFoam")
conserves("parcels in motion", case, 0.02)

# ---- buoyancy --------------------------------------------------------------------------------------

case = Case("buoyancy")
case.box((8e-3, 8e-3, 8e-3), (4, 1, 8), {"walls": ("wall", "x- x+ y- y+ z- z+")})
for field, wall in (("U", "noSlip"), ("p", "fixedFluxPressure"), ("T", "zeroGradient")):
    case.sub(f"0/{field}", "type cyclic", f"type {wall}")
case.append(transport, "beta 2e-3; TRef 300;\n")
for old, new in (("effects {", "effects { gravity { acceleration (0 0 -9.81); }"),
                 ("temperature 300", "frozen yes; temperature 300"), (r"max \(.*\)", "max (0.008 0.008 0.004)"),
                 ("count 64", "count 32"), ("heatCapacity 20", "heatCapacity 1e6")):
    case.sub(scene, old, new)
case.edit(control, endTime=0.01, writeInterval=0.01)
cells = np.arange(32)                                 # layer by layer, four cells in each


def gas_of(hot):
    """Run with gas of 500 K in the hot cells and 300 K in the others."""
    case.sub("0/T", r"^internalField[^;]*;", "internalField nonuniform List<scalar> 32 ("
             + " ".join("500" if cell else "300" for cell in hot) + ");")
    case.remove("0.0*")
    case.run("demPimpleFoam")


gas_of(cells >= 16)
claim("buoyancy: hot gas over cold gas in a bed rests (m/s)", largest(case.field("0.01/U")) < 1e-6)
# over the density, without the hydrostatic part of TRef: 1 mm of beta (T - TRef) g between two layers
p, T = case.field("0.01/p"), case.field("0.01/T")
claim("buoyancy: its pressure is the hydrostatic one (0.1 %)",
      close(p[28] - p[24], 2e-3*((T[28] + T[24])/2 - 300)*9.81*1e-3, 1e-3))
gas_of(cells % 4 < 2)
claim("buoyancy: beside cold gas the hot gas rises", case.field("0.01/U")[20, 2] > 1e-3)

# ---- bad input -------------------------------------------------------------------------------------

case = Case("wrong")


def refused(what, sentence):
    claim(f"bad input: {what}", not case.run("demPimpleFoam") and case.found(sentence), case.log()[-1000:])


(case/"0/T").rename(case/"away")
refused("no field T", "transfer heat .* there is no field 0/T; give it")
(case/"away").rename(case/"0/T")
case.sub("system/fvSchemes", "^ddtSchemes.*", "ddtSchemes { default Euler; ddt(voidFraction,T) backward; }")
refused("a scheme of two steps for T",
        r"ddt\(voidFraction,T\) in ddtSchemes of system/fvSchemes is backward; .* needs Euler")
case.sub("system/fvSchemes", "backward", "Euler")
solution = case.read("system/fvSolution")
case.write("system/fvSolution", solution + 'relaxationFactors { equations { "T.*" 0.7; } }\n')
refused("relaxation of T in the last iteration", "relax the last iteration of T by 0.7, .* give TFinal 1 in equations")
case.write("system/fvSolution", solution)
case.sub(transport, "^Cp.*", "")
refused("no heat capacity", "add Cp to constant/transportProperties")
case.edit(transport, Cp=0)
refused("a heat capacity of zero", "is 0; it must be positive")
case.edit(transport, Cp=1000, beta=1e-3)
refused("beta without TRef", "add TRef to constant")
finish()
