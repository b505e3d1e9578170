"""A drop at rest without gravity, with surface tension.

- With frozen particles in a part of it no more fluid moves than without: surface tension and pressure have the same
  factor on each face.
- With free particles in a periodic box momentum closes to round-off, and particles do not feel the jump of the
  pressure.

SPDX-License-Identifier: GPL-3.0-or-later
"""
from two_fluids import *

L, n, R, sigma = 0.012, 12, 0.004, 0.02


def drop(name, insert, steps=20, more="", outer=1):
    case = TwoFluids(name)
    case.controls(steps*2e-4, 2e-4)
    case.fluids((1000, 1e-3), (500, 1e-3), sigma=sigma, gravity="(0 0 0)", tolerance=1e-13, outer=outer)
    case.box((L, L, L), (n, n, n), cyclic="xyz")
    case.fields(())
    case.alpha(lambda x: (R - np.linalg.norm(x - L/2, axis=1))/(L/n) + 0.5)
    case.grains("grain { density 2500; youngsModulus 1e5; }", "hertz {} stokesDrag {}", insert,
                "kernel linear; " + more,
                "time { step 1e-5; }")
    claim_runs(f"{name}: runs", case, "demInterFoam")
    return case


def grains(low, high, frozen):
    return (f"grains {{ type random; diameter 6e-4; count 800; seed 5; frozen {frozen};"
            f" min {vector(low)}; max {vector(high)}; }}")


# the particles lie in the upper half, across the drop
clear = drop("clear", grains((0, 0, 0), (L, L, L), "yes").replace("800", "1"), steps=150)
held = drop("held", grains((0, 0, L/2), (L, L, L), "yes"), steps=150)
speeds = [largest(case.interior("U")) for case in (clear, held)]
claim("held: the void fraction varies", np.ptp(held.interior("voidFraction")) > 0.15,
      np.ptp(held.interior("voidFraction")))
claim("held: no more fluid moves than without particles", speeds[1] < 1.2*speeds[0], *speeds)

# the same without particles in stock interFoam
here = clear.interior("U")
clear.for_stock()
clear.remove("0.0*")
claim_runs("clear: interFoam runs", clear, "interFoam")
stock = largest(clear.interior("U"))
means = [math.sqrt(np.mean(np.sum(U**2, axis=1))) for U in (here, clear.interior("U"))]
claim("clear: parasitic currents are not stronger than in interFoam (root mean square)", means[0] < means[1], *means)
claim("clear: the fastest is as in interFoam (10 %)", close(speeds[0], stock, 0.1), speeds[0], stock)

free = drop("free", grains((0, 0, L/2), (L, L, L), "no"), more="record { interval 2e-4; budget yes; }", outer=2)
table = free.table("postProcessing/dem/0/budget.csv")
scale = 1000*4/3*math.pi*R**3*2*sigma/R/500*0.004     # momentum of the drop by the jump alone
for axis in "xyz":
    rest, faces = (largest(table[f"{term}.p{axis}"]) for term in ("rest", "faces"))
    terms = max(largest(table[name]) for name in table if name.endswith(f".p{axis}"))
    claim(f"free: momentum closes, {axis} (1e-12 of its largest term)", rest < 1e-12*max(terms, scale), rest, terms)
    claim(f"free: nothing is lost between faces and cells, {axis}", faces < 1e-12*max(terms, scale), faces, terms)
acceleration = largest(free.particles(free.times()[-1], "U")[:, 1:])/0.004
jump = 2*sigma/R/(2*L/n)/2500                          # acceleration by the jump over two cells
# what is left is the error of the curvature
claim("free: particles do not feel the jump (20 % of it)", acceleration < 0.2*jump, acceleration/jump)
claim("free: exchange closes", worst(free.log("demInterFoam"), "exchange error") < 1e-12)
finish()
