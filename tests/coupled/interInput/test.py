"""Wrong input of demInterFoam ends the run before its first step, with a sentence that names the cure.

SPDX-License-Identifier: GPL-3.0-or-later
"""
from two_fluids import *

walls = {"walls": ("wall", "x- x+ y- y+ z- z+")}
transport, solution, scene = "constant/transportProperties", "system/fvSolution", "constant/demProperties"

case = TwoFluids()
case.controls(0.002, 1e-3)
case.fluids(sigma=0.07)
case.box((0.01, 0.01, 0.02), (3, 3, 6), walls)
case.fields(walls)
case.alpha(lambda x: x[:, 2] < 0.01)
case.grains("grain { density 2500; youngsModulus 1e6; }", "hertz {} gidaspow {}",
            "grains { type random; diameter 1e-3; count 20; min (0 0 0); max (0.01 0.01 0.02); }")


def refused(what, name, changes, words):
    """With these changes of a file, (expression, replacement)."""
    good = case.read(name)
    for pattern, to in changes:
        case.sub(name, pattern, to)
    claim_refused(what, case, words, "demInterFoam", limit=60)
    case.write(name, good)


refused("no phases", transport, [("^phases .*", "")], "phases is missing")
refused("one phase", transport, [("^phases .*", "phases (water);")], "phases ... two different names")
refused("the name of a phase is wrong", transport, [("^phases .*", "phases (water oil);")],
        "names oil, but there is no dictionary oil")
refused("no density", transport, [("rho 1000;", "")], "rho is missing in ... water")
refused("a density of 0", transport, [("rho 1000;", "rho 0;")], "rho of water ... is 0 kg/m3; it must be positive")
refused("no model of the viscosity", transport, [("^water .* transportModel Newtonian;", "water {")],
        "transportModel is missing in ... water")
refused("no surface tension", transport, [("^sigma .*", "")], "sigma is missing")
refused("alpha below 0", "0/alpha.water", [("^1$", "-0.2")],
        "alpha.water of 0 lies between -0.2 and 0; ... from 0 to 1")
refused("alpha of a patch above 1", "0/alpha.water", [("type zeroGradient", "type fixedValue; value uniform 1.5")],
        "alpha.water of 0 on patch walls lies between 1.5 and 1.5; ... from 0 to 1")
refused("alpha that enters below 0", "0/alpha.water",
        [("type zeroGradient", "type inletOutlet; inletValue uniform -1; value uniform 0")],
        "on patch walls lies between -1 and -1; ... from 0 to 1")
refused("a surface tension below 0", transport, [("^sigma .*", "sigma -1;")], "sigma ... is -1 N/m; it must be positive")
refused("an interface Courant number below 0", "system/controlDict", [("^deltaT", "maxAlphaCo -1;\\ndeltaT")],
        "maxAlphaCo is -1; it must be positive")
refused("the mixture's flux", scene, [("coupling {", "coupling { mixtureFlux ();")],
        "mixtureFlux ... only demPimpleFoam has it")
refused("no settings of alpha", solution, [('"alpha.*', "")], "no entry alpha.water in solvers")
refused("no compression", solution, [("cAlpha 1;", "")], "cAlpha is missing")
refused("implicit MULES", solution, [("cAlpha 1;", "cAlpha 1; MULESCorr yes;")], "explicit MULES only")
refused("no sub-cycles", solution, [("nAlphaSubCycles 1", "nAlphaSubCycles 0")], "nAlphaSubCycles is 0")
refused("a scheme of two steps", "system/fvSchemes", [("default Euler", "default backward")],
        "demInterFoam needs Euler")
refused("relaxation of the last iteration", solution, [(r"\Z", 'relaxationFactors { equations { "U.*" 0.9; } }\n')],
        "relax the last iteration of U by 0.9 ... give UFinal 1 in equations")
refused("another set of equations", scene, [("coupling {", "coupling { equations I;")], "the set II only")
refused("a density of the fluid in the coupling", scene, [("coupling {", "coupling { rho 1000;")],
        "rho ... transportProperties")
refused("heat", scene, [("gidaspow", "wakao {} gidaspow"), ("density 2500;", "density 2500; heatCapacity 800;")],
        "transfer heat, but demInterFoam has no temperature")

case.dictionary("constant/fvOptions", "drive { type meanVelocityForce; selectionMode all; fields (U); Ubar (1 0 0); }")
claim_refused("a force that drives the mean velocity", case, "drive of type meanVelocityForce ... tilt constant/g",
              "demInterFoam")
case.dictionary("constant/fvOptions", """sway { type tabulatedAccelerationSource;
timeDataFileName "constant/acceleration"; }""")
case.write("constant/acceleration", "2((0 ((0 0 0) (0 0 0) (0 0 0))) (1 ((0 0 0) (0 0 0) (0 0 0))))")
claim_refused("an acceleration that particles do not feel", case, "sway of type tabulatedAccelerationSource ... "
              "move the mesh", "demInterFoam")
case.dictionary("constant/fvOptions", "weight { type buoyancyForce; selectionMode all; fields (U); }")
claim_refused("a second gravity", case, "weight of type buoyancyForce ... gravity would act twice", "demInterFoam")
case.remove("constant/fvOptions")
case.copy(case/"0/alpha.water", "kept")
case.remove("0/alpha.water")
claim_refused("no alpha", case, "0/alpha.water is missing: give the volume fraction of water", "demInterFoam")
case.copy(case/"kept", "0/alpha.water")
case.copy(case/transport, "properties")
case.remove(transport)
claim_refused("no properties", case, "transportProperties is missing", "demInterFoam")
case.copy(case/"properties", transport)

claim_runs("-plan ends", case, "demInterFoam", "-plan")
claim("-plan reports the steps and writes nothing", "Time step" in case.log("demInterFoam") and not case.times(),
      *case.log("demInterFoam").splitlines()[-30:])
claim("-plan says in which fluid it judges",
      re.search("^Two fluids\n.* judged in the fluid around the particles now", case.log("demInterFoam"), re.M))
claim_runs("the case runs without these faults", case, "demInterFoam")
finish()
