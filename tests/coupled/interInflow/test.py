"""Water enters through the floor of a vessel, and grains are inserted in the air and in the water: the volume of water
grows by the inflow to round-off, alpha stays in [0, 1], and the grains raise the surface.

SPDX-License-Identifier: GPL-3.0-or-later
"""
from two_fluids import *

area, speed, end = 0.02*0.02, 0.02, 0.3
case = TwoFluids()
case.controls(end, 1e-3)
case.fluids(tolerance=1e-9, sub_cycles=2)
case.box((0.02, 0.02, 0.06), (6, 6, 18),
         {"walls": ("wall", "x- x+ y- y+"), "inlet": ("patch", "z-"), "top": ("patch", "z+")})
case.fields(("walls",), slip=True,
            more=(f"inlet {{ type fixedValue; value uniform (0 0 {speed}); }} "
                  "top { type pressureInletOutletVelocity; value uniform (0 0 0); }",
                  "inlet { type fixedFluxPressure; value uniform 0; } "
                  "top { type totalPressure; p0 uniform 0; value uniform 0; }",
                  "inlet { type fixedValue; value uniform 1; } "
                  "top { type inletOutlet; inletValue uniform 0; value uniform 0; }"))
case.alpha(lambda x: x[:, 2] < 0.03)
case.grains("grain { density 2500; youngsModulus 1e5; }", "hertz {} dry { restitution 0.5; } gidaspow {}",
            """above { type stream; rate 400; diameter 1.5e-3; min (0.003 0.003 0.05); max (0.017 0.017
            0.056); end 0.2; }
               below { type stream; rate 400; diameter 1.5e-3; min (0.003 0.003 0.015); max (0.017
               0.017 0.02); end 0.2; }""",
            "walls (inlet);")
case.run("demInterFoam")
claim_ran("runs", case, "demInterFoam")
low, high, volume = case.bounds().T
grown = volume - volume[0] - speed*area*1e-3*np.arange(len(volume))
claim("the water grows by the inflow (1e-12 of it)", largest(grown) < 1e-12*volume[0], largest(grown)/volume[0])
claim("alpha stays in [0, 1] (1e-12)", low.min() > -1e-12 and high.max() < 1e-12, low.min(), high.max())
e, z = case.interior("voidFraction"), case.centres()[:, 2]
grains = case.particles(case.times()[-1], "positions", "d")
solid = math.pi/6*np.sum(grains[:, 4]**3)
claim("grains have entered", len(grains) > 120, len(grains))
V = area*0.06/len(e)
under = V*np.sum(case.interior("alpha.water"))
lying = math.pi/6*np.sum(grains[grains[:, 3] < 0.035, 4]**3)
claim("the surface rises by the volume of water and grains (0.1 %)",
      close(under, volume[-1] + lying, 1e-3), under, volume[-1] + lying, solid)
claim("the weight of alpha stays the void fraction (1e-5)",
      difference(case.interior("transportedVoidFraction"), e) < 1e-5,
      difference(case.interior("transportedVoidFraction"), e))
claim("exchange closes", worst(case.log("demInterFoam"), "exchange error") < 1e-12)
finish()
