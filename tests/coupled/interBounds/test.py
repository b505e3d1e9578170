"""A swarm of heavy spheres falls from air into water for 1000 steps: alpha stays in [0, 1] and both volumes are kept to
round-off, although the pressure is solved to a tolerance; momentum and the exchange close, and energy does not grow.

SPDX-License-Identifier: GPL-3.0-or-later
"""
from two_fluids import *

walls = {"walls": ("wall", "x- x+ y- y+ z- z+")}
case = TwoFluids()
case.controls(0.2, 2e-4)
case.fluids(tolerance=1e-6, correctors=2, sub_cycles=2)
case.sub("system/fvSolution", "solvers\n{", """\\g<0>
    voidageFluxPotential { solver PCG; preconditioner DIC; tolerance 1e-3; relTol 0; }""")
case.box((0.05, 0.05, 0.1), (10, 10, 20), walls)
case.fields(walls, slip=True)
case.alpha(lambda x: x[:, 2] < 0.052)
case.grains("grain { density 2500; youngsModulus 1e6; }", "hertz {} dry { restitution 0.5; } gidaspow {} gravity {}",
            """grains { type random; diameter 3e-3; count 800; seed 3; velocity (0 0 -0.3);
                        min (0 0 0.06); max (0.05 0.05 0.099); }""", "record { interval 0.01; budget yes; }")
claim_runs("runs", case, "demInterFoam")
low, high, volume = case.bounds().T
claim("1000 steps", len(low) == 1000)
claim("alpha does not fall below 0 (1e-13)", low.min() > -1e-13, low.min())
claim("alpha does not rise above 1 (1e-13)", high.max() < 1e-13, high.max())
claim("the volume of water is kept (1e-13)", np.ptp(volume) < 1e-13*volume[0], np.ptp(volume)/volume[0])
log = case.log("demInterFoam")
claim("the flux of all volume needs a correction at the start only, with slip walls too",
      log.count("Solving for totalFluxPotential") == 1, log.count("Solving for totalFluxPotential"))
residuals = case.numbers(r"Solving for voidageFluxPotential.* Final residual = ([^,]+),", "demInterFoam")
claim("the voidage flux has a tolerance of its own, 1e-3", len(residuals) == 1000
      and 1e-6 < residuals.max() < 1e-3, len(residuals), residuals.min(), residuals.max())
e = case.interior("voidFraction")
claim("the weight of alpha stays the void fraction (the tolerance of the pressure)",
      difference(case.interior("transportedVoidFraction"),
                 e) < 1e-5, difference(case.interior("transportedVoidFraction"), e))
claim("the swarm is dense", e.min() < 0.8, e.min())
claim("exchange closes", worst(case.log("demInterFoam"), "exchange error") < 1e-12)
table = case.table("postProcessing/dem/0/budget.csv")
for axis in "xyz":
    terms = {name: largest(column) for name, column in table.items() if name.endswith(f".p{axis}")}
    for term, what in (("rest", "momentum closes"), ("faces", "nothing is lost between faces and cells")):
        claim(f"{what}, {axis} (1e-12 of the largest term)", terms[f"{term}.p{axis}"] < 1e-12*max(terms.values()),
              terms[f"{term}.p{axis}"], max(terms.values()))
total = sum(table[f"{name}.energy"] for name in ("fluid", "particles", "height", "fluidHeight"))
lost = total[0] - total
claim("kinetic and potential energy of fluids and particles together do not grow (1 % of the loss)",
      np.diff(lost).min() > -0.01*lost[-1], np.diff(lost).min(), lost[-1])
claim("volume of the particles is kept", worst(case.log("demInterFoam"), "volume error") < 1e-12)
finish()
