"""Heat exchange between particles and the fluid of stock solvers, by function object.

In buoyantPimpleFoam (enthalpy) and rhoPimpleFoam (internal energy), in a closed box, the fluid gets the heat that the
particles lose. With one outer iteration the solver's later change of its density adds heat, even without particles;
the balance counts it.

SPDX-License-Identifier: GPL-3.0-or-later
"""
from case import *
from heat.balance import gained, heat, hot
from solvers.box import prepare


def exchanges(case, solver):
    """The claims with four outer iterations, then with one."""
    case.sub("system/fvSolution", "nOuterCorrectors 1", "nOuterCorrectors 4")
    claim_runs(f"{solver}: runs", case, solver)
    claim(f"{solver}: exchange closes", worst(case.log(solver), "heat exchange error") < 1e-12)
    fluid, particles, received, left = gained(case, solver)
    claim(f"{solver}: the spheres cool by more than 1 K", left < 0.9975)
    claim(f"{solver}: the fluid gets the heat that they lose (0.1 %)", close(fluid, particles, 1e-3))
    four = heat(case, solver)

    case.remove("0.0*")
    case.sub("system/fvSolution", "nOuterCorrectors 4", "nOuterCorrectors 1")
    case.run(solver)
    fluid, particles, received, _ = gained(case, solver)
    once = f"{solver}, one outer iteration"
    claim(f"{once}: exchange closes", worst(case.log(solver), "heat exchange error") < 1e-12)
    # the solver's kinetic energy is 1e-6 of the heat
    claim(f"{once}: with the change of density the fluid gets the heat that they lose (1e-5)",
          close(fluid - received, particles, 1e-5))
    # no claim about the stock solver
    print(f"# {once}: without it the fluid gets this fraction more: {fluid/particles - 1:.3g}")
    return four


def refused(what, case, solver, sentence):
    claim(what, not case.run(solver) and case.found(sentence, solver))


exchanges(hot("buoyantPimpleFoam"), "buoyantPimpleFoam")
case = hot("rhoPimpleFoam")
unlisted = exchanges(case, "rhoPimpleFoam")

# a case's own list of sources must contain the heat source
case.sub("system/fvSolution", "nOuterCorrectors 1", "nOuterCorrectors 4")
case.remove("0.0*")
case.dictionary("constant/fvOptions", 'particles { type demMomentumSource; libs ("libdemCoupling.so"); }')
refused("rhoPimpleFoam: fvOptions of the case without the source of heat are refused", case, "rhoPimpleFoam",
        "type demEnergySource;")
case.append("constant/fvOptions", 'heat { type demEnergySource; libs ("libdemCoupling.so"); }\n')
case.run("rhoPimpleFoam")
claim("rhoPimpleFoam: with it they have the bits of the run without a list",
      difference(heat(case, "rhoPimpleFoam"), unlisted) == 0)

# Without particles: 50 W into the middle half of the box
case = prepare("buoyantPimpleFoam", "", "empty")
case.sub("system/fvSolution", "nOuterCorrectors 1", "nOuterCorrectors 4")
case.edit("system/controlDict", endTime=0.02)
case.sub("system/controlDict", r"^functions(.|\n)*", """
functions { heat { type volFieldValue; libs ("libfieldFunctionObjects.so"); writeFields no; log no; regionType all;
    operation weightedVolIntegrate; weightField rho; fields (h); writeControl timeStep; writeInterval 1;
    writePrecision 17; } }
""")
case.append("constant/thermophysicalProperties", "dpdt no;\n")
case.dictionary("system/topoSetDict", """
actions ( { name half; type cellZoneSet; action new; source boxToCell; box (-1 -1 0.01) (1 1 0.03); } );""")
case.dictionary("constant/fvOptions", """
hot { type scalarSemiImplicitSource; selectionMode cellZone; cellZone half; volumeMode absolute;
      injectionRateSuSp { h (50 0); } }
""")
case.run("topoSet")
case.run("buoyantPimpleFoam")
t, enthalpy = np.loadtxt(case/"postProcessing/heat/0/volFieldValue.dat").T
claim("without particles buoyantPimpleFoam keeps heat with four outer iterations (1e-5)",
      t.size > 9 and close(enthalpy[-1] - enthalpy[0], 50*(t[-1] - t[0]), 1e-5))

# the budget needs a void fraction, which the equations of a stock solver lack
case = prepare("buoyantPimpleFoam", """
insert { one { type list; diameter 1e-3; positions ( (0.01 0.01 0.02) ); } }
coupling { record { interval 0.001; budget yes; } }
""")
refused("buoyantPimpleFoam: the budget is refused with the solver that has it", case, "buoyantPimpleFoam",
        "record/budget is yes, but the equations of this solver have no void fraction; .* demPimpleFoam")

# a solver without a temperature
case = prepare("pimpleFoam", """
insert { hot { type random; count 10; seed 7; diameter 1e-3; temperature 400; min (0 0 0.01); max (0.02 0.02 0.03); } }
coupling { rho 1; }
""")
case.sub("constant/demProperties", "density 3000;", "density 3000; heatCapacity 50;")
case.sub("constant/demProperties", "wenYu {}", "wenYu {} ranzMarshall {}")
refused("pimpleFoam: the message says that it has no temperature", case, "pimpleFoam", "no thermophysical model")
finish()
