"""Water enters through the floor of a vessel, and grains are inserted in the air and in the water: the volume of water
grows by the inflow to round-off, alpha stays in [0, 1], and the grains raise the surface.

Particles in the passage of an inlet displace the same volume in any order in memory: same bits with other skins.

Through an open patch the other fluid enters a column of one fluid that is drawn out at the other end: cells at
the open patch have the velocity of the drain.

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
claim_runs("runs", case, "demInterFoam")
low, high, volume = case.bounds().T
grown = volume - volume[0] - speed*area*1e-3*np.arange(len(volume))
claim("the water grows by the inflow (1e-12 of it)", largest(grown) < 1e-12*volume[0], largest(grown)/volume[0])
claim("the log tells what came in (1e-12)", case.kept() < 1e-12, case.kept())
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

for name, drain, entry, inside, velocity, moves in (("air enters water", "z-", "z+", 1, -0.05, False),
                                                    ("water enters air", "z+", "z-", 0, 0.05, False),
                                                    ("water enters air that moves", "z+", "z-", 0, 0.05, True)):
    case = TwoFluids(name.replace(" ", "-"))
    case.controls(0.1, 1e-3, write=0.02)
    case.fluids(tolerance=1e-10)
    case.box((0.005, 0.005, 0.06), (1, 1, 12),
             {"sides": ("wall", "x- x+ y- y+"), "drain": ("patch", drain), "entry": ("patch", entry)})
    case.fields(("sides",), slip=True,
                more=(f"drain {{ type fixedValue; value uniform (0 0 {velocity}); }} "
                      "entry { type pressureInletOutletVelocity; value uniform (0 0 0); }",
                      "drain { type fixedFluxPressure; value uniform 0; } "
                      "entry { type totalPressure; p0 uniform 0; value uniform 0; }",
                      "drain { type zeroGradient; } "
                      f"entry {{ type inletOutlet; inletValue uniform {1 - inside}; value uniform {inside}; }}"))
    if moves:
        case.sub("0/U", r"internalField\s+uniform \(0 0 0\)", f"internalField uniform (0 0 {velocity})")
    case.alpha(lambda x: np.full(len(x), inside))
    case.grains("grain { density 2500; youngsModulus 1e6; }", "gidaspow {}",
                "grain { type list; diameter 1e-5; frozen yes; positions ((0.0025 0.0025 0.03)); }",
                more="time { step 1e-3; }")
    claim_runs(f"{name}: runs", case, "demInterFoam")
    # nothing flows in step 1 of the phases, and in step 2 alpha of the patch still is as without a flux
    entered = np.sum(abs(case.interior("alpha.water") - inside))*0.005
    claim(f"{name}: 4.9 mm have entered in 98 steps (1e-6)", close(entered, 0.05*0.098, 1e-6), entered)
    # from rest, a cell at the drain gets less of the jerk at the start: its patch has no force
    near = moves | (abs(case.centres()[:, 2] - (0.06 if entry == "z+" else 0)) < 0.03)
    U = np.array([case.field(f"{time}/U")[near, 2] for time in case.times()])
    bound = 1e-5 if moves else 1e-3
    claim(f"{name}: {'all cells' if moves else 'the cells of that half'} move at {velocity} m/s ({bound:g})",
          difference(U, np.full_like(U, velocity)) < bound*abs(velocity), *U)
    low, high, volume = case.bounds().T
    claim(f"{name}: the log tells what came and left (1e-12)", case.kept() < 1e-12, case.kept())
    claim(f"{name}: alpha stays in [0, 1] (1e-12)", low.min() > -1e-12 and high.max() < 1e-12, low.min(), high.max())

# ---- the order of particles in memory, which follows from neighbor lists ---------------------------------

fields = {}
for skins in ("", "neighbours { outerSkin 0.15; innerSkin 0.03; }"):
    case = TwoFluids("skins-other" if skins else "skins")
    case.controls(0.03, 1e-3, precision=17)
    case.fluids(correctors=2, outer=2)
    case.box((0.12, 0.02, 0.06), (24, 4, 12),
             {"inlet": ("patch", "x-"), "outlet": ("patch", "x+"), "floor": ("wall", "z-"), "top": ("patch", "z+"),
              "front": ("cyclic; neighbourPatch back", "y-"), "back": ("cyclic; neighbourPatch front", "y+")})
    sides = "front { type cyclic; } back { type cyclic; } "
    case.fields(("floor",),
                more=(sides + "inlet { type fixedValue; value uniform (0.1 0 0); } "
                      "outlet { type inletOutlet; inletValue uniform (0 0 0); value uniform (0 0 0); } "
                      "top { type pressureInletOutletVelocity; value uniform (0 0 0); }",
                      sides + "inlet { type fixedFluxPressure; value uniform 0; } outlet { type zeroGradient; } "
                      "top { type totalPressure; p0 uniform 0; value uniform 0; }",
                      sides + "inlet { type fixedValue; value uniform 1; } "
                      '"(outlet|top)" { type inletOutlet; inletValue uniform 0; value uniform 0; }'))
    case.alpha(lambda x: x[:, 2] < 0.03)
    case.grains("grain { density 1500; youngsModulus 1e5; }",
                "hertz {} dry { restitution 0.5; } mindlin { friction 0.3; } gidaspow {} virtualMass {}",
                """feed { type stream; patch inlet; rate 600; diameter 1.5e-3; velocity fluid; }
                   rain { type stream; rate 300; diameter 1.5e-3; min (0.03 0 0.05); max (0.05 0.02 0.056); }
                   bed { type random; count 250; diameter 1.5e-3; min (0.04 0 0); max (0.1 0.02 0.02); }""",
                more="outlets { out { patch outlet; } back { patch inlet; } up { patch top; } } " + skins)
    claim_runs(f"streams with {skins or 'skins by default'}: runs", case, "demInterFoam")
    claim("with two outer iterations, too (1e-12)", case.kept() < 1e-12, case.kept())
    for name in ("U", "p_rgh", "transportedVoidFraction"):
        if skins:
            claim(f"{name}: the same bits with other skins", np.array_equal(fields[name], case.interior(name)))
        fields[name] = case.interior(name)
finish()
