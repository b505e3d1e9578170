"""Particles in stock interFoam do not feel the jump of the pressure across the curved surface of a drop at rest: fluid
and particles together would gain momentum from nothing.

SPDX-License-Identifier: GPL-3.0-or-later
"""
from two_fluids import *

L, n, R, sigma, step = 0.012, 12, 0.004, 0.02, 2e-4
case = TwoFluids()
case.controls(10*step, step, functions=re.sub(r"^functions \{(.*)\}\n$", r"\1", function_object))
case.fluids((1000, 1e-3), (500, 1e-3), sigma=sigma, gravity="(0 0 0)", tolerance=1e-13)
case.box((L, L, L), (n, n, n), {"walls": ("wall", "x- x+ y- y+ z- z+")})
case.fields(("walls",))
case.alpha(lambda x: (R - np.linalg.norm(x - L/2, axis=1))/(L/n) + 0.5)
case.for_stock()
# a few small ones on the drop's surface, at rest
directions = np.array([(1, 0, 0), (0, 1, 0), (0, 0, 1), (-1, 0, 0), (0, -1, 0), (0.6, 0.8, 0)])
case.grains("grain { density 2500; youngsModulus 1e5; }", "hertz {}",
            f"""grains {{ type list; diameter 1e-4; positions (
                {" ".join(vector(L/2 + R*direction) for direction in directions)}); }}""", "kernel linear;",
            "time { step 2e-6; }")
claim_runs("runs", case, "interFoam")
p = case.field(f"{case.times()[-1]}/p_rgh")
claim("the drop has the pressure of its surface tension (20 %: the curvature of this mesh)",
      close(np.ptp(p), 2*sigma/R, 0.2), np.ptp(p), 2*sigma/R)
acceleration = largest(case.particles(case.times()[-1], "U")[:, 1:])/(10*step)
jump = 2*sigma/R/(2*L/n)/2500                          # by the jump over two cells
# what is left is the error of the curvature; the jump alone gives 0.77 on this mesh
claim("particles at the surface do not feel the jump (20 % of it)", acceleration < 0.2*jump, acceleration/jump)
finish()
