"""A dense suspension settles at the speed at which Wen and Yu's drag balances its weight, with fluid steps of 0.1 to
5 times the particles' relaxation time.

SPDX-License-Identifier: GPL-3.0-or-later
"""
from case import *


def speed(e):
    """Zero net flux, slip v/e; the drag force is e V (rho_p - rho) g (set II: the pressure gradient of the suspension's
    weight carries the rest). Fixed-point iteration."""
    d, mu, v = 1e-4, 1e-3, 1e-3
    for _ in range(200):
        Re = 1000*d*v/mu
        v = e**2*d**2*1500*9.81/(18*mu*e**-2.65*(1 + 0.15*Re**0.687))
    return v


# at e = 0.7: the reference solution of the same balance for these spheres
claim("the reference calculation gives the tabulated speed, 1.496 mm/s", close(speed(0.7), 1.496e-3, 1e-3))

for step in ("1e-3", "5e-5"):
    case = Case(f"step-{step}")
    case.edit("system/controlDict", deltaT=step, endTime=0.02, writeInterval=0.02)
    claim_runs(f"steps of {step} s: runs", case)
    # the middle third, which neither the clear fluid above nor the sediment below has reached
    e = case.field("0.02/voidFraction")[80:112].mean()
    z = case.field("0.02/lagrangian/particles/positions")[:, 2]
    middle = (z > 0.001) & (z < 0.0019)
    v = -case.field("0.02/lagrangian/particles/U")[middle, 2].mean()
    claim(f"steps of {step} s: speed in the middle (1 %)", close(v, speed(e), 0.01), v, speed(e))
    claim(f"steps of {step} s: exchange closes", worst(case.log(), "exchange error") < 1e-12)
    claim(f"steps of {step} s: volume of the particles is kept", worst(case.log(), "volume error") < 1e-12)
finish()
