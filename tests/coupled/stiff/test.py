"""Beds of mass loading 1000 stay at rest although a fluid step is 1 to 100 times the particles' relaxation time.

- Frozen particles, and particles held by their weight against a flow of half the minimum fluidisation speed.

SPDX-License-Identifier: GPL-3.0-or-later
"""
from case import *

solid = math.pi/6                                     # a cubic stack
void = 1 - solid

for frozen in ("yes", "no"):
    for ratio in (1, 10, 100) if thorough else (1, 100):
        # tau = rho_p d^2/(18 mu G), G = 150 s/e/18 (Ergun's viscous part), gives mu for T = 1 ms; and
        # s (rho_p - rho) g = 150 mu s^2 U/(e^3 d^2)
        mu = ratio*1000*1e-6/(150*solid/void*1e-3)
        speed = 0.5*solid*999*9.81*void**3*1e-6/(150*mu*solid**2)
        for width in (0, 3):
            name = f"frozen {frozen}, T/tau {ratio}, kernel {width} d"
            case = Case()
            case.controls(0.06, 0.001, nu=mu)
            case.duct((0.01, 0.01, 0.014), (5, 5, 7), speed)
            case.gravity()
            case.properties("heavy { density 1000; youngsModulus 1e5; poissonsRatio 0.3; }",
                            "hertz {} dry { restitution 0.5; } gidaspow {} pressureGradient {}",
                            f"bed {{ type lattice; diameter 1e-3; count 500; spacing 1; jitter 0; frozen {frozen}; "
                            "min (0 0 0); max (0.01 0.01 0.014); }",
                            f"rho 1; kernel diffusion; width {width}; walls (inlet);")
            claim_runs(f"{name}: runs", case)
            # the inlet velocity over the bed's void fraction; three times that would be an oscillation
            claim(f"{name}: the fluid does not oscillate", lambda: largest(case.field("0.06/U")) < 3*speed/void)
            # remaining speeds of a held bed after 60 ms of settling by some micrometres; weight alone would give
            # 0.6 m/s
            claim(f"{name}: the particles do not oscillate",
                  lambda: largest(case.field("0.06/lagrangian/particles/U")) < 1e-3)
            claim(f"{name}: exchange closes", worst(case.log(), "exchange error") < 1e-12)
finish()
