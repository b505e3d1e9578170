"""A sphere sinks from a fluid into a heavier, thinner one, each wider than the kernel: in both it reaches the velocity
of Stokes with the density and viscosity of that fluid.

SPDX-License-Identifier: GPL-3.0-or-later
"""
from two_fluids import *

d, rho_p, g = 0.5e-3, 2500, 9.81
light, heavy = (900, 0.1), (1200, 0.5)


def settling_velocity(rho, mu):
    """Of a single sphere with Stokes' drag, 3 pi mu d v."""
    return (rho_p - rho)*g*d**2/18/mu


walls = {"walls": ("wall", "x- x+ y- y+ z- z+")}
case = TwoFluids()
case.controls(20, 0.02, write=0.5)
case.fluids(heavy, light, tolerance=1e-10, correctors=2)
case.box((0.02, 0.02, 0.06), (10, 10, 30), walls)
case.fields(walls)
case.alpha(lambda x: x[:, 2] < 0.03)
# one-way: a single sphere without the flow that it makes, which the box would change
case.grains("ball { density 2500; youngsModulus 1e6; }", "hertz {} stokesDrag {}",
            f"ball {{ type list; diameter {d}; positions ((0.01 0.01 0.037)); }}",
            "twoWay no;")
case.run("demInterFoam")
claim_ran("runs", case, "demInterFoam")
times = case.times()
z, w = (np.array([case.field(f"{time}/lagrangian/particles/{name}")[0, 2] for time in times])
        for name in ("positions", "U"))
above, below = (z > 0.0345) & (z < 0.0365), z < 0.026
for name, where, fluid in (("light", above, light), ("heavy", below, heavy)):
    v = settling_velocity(*fluid)
    claim(f"in the {name} fluid: the velocity is {v*1e3:.4g} mm/s (0.1 %)",
          where.any() and np.all(abs(-w[where]/v - 1) < 1e-3), -w[where], v)
finish()
