"""A temperature front passes a bed of frozen spheres according to Schumann's closed form.

Plug flow of the superficial velocity u, no conduction along the bed: with q = h a and the profile
f = (T - T0)/(T_in - T0),

    e rho Cp df/dt + u rho Cp df/dx = q (g - f)       gas
    (1 - e) density capacity dg/dt = q (f - g)        spheres

    f = 1 - exp(-y) int_0^x' exp(-z) I0(2 sqrt(y z)) dz
    x' = q x/(u rho Cp),   y = q (t - e x/u)/((1 - e) density capacity)

q = 6 (1 - e) kappa Nu/d^2, Nu = 2 + 1.1 Re^0.6 Pr^(1/3) of Wakao and Kaguei (1982).
Source: Schumann, J. Franklin Inst. 208 (1929) 405.

SPDX-License-Identifier: GPL-3.0-or-later
"""
from scipy.integrate import quad
from scipy.special import ive

from case import *

u, e, d, rho, Cp, kappa, nu, density, capacity = 1, 0.7791, 1e-3, 1.25, 1000, 0.025, 1.5e-5, 2500, 10
Nu = 2 + 1.1*(u*d/nu)**0.6*(rho*nu*Cp/kappa)**(1/3)
q = 6*(1 - e)*kappa*Nu/d**2
z = (np.arange(60) + 0.5)*0.08/60                     # centers of the cells [m]
x = q*z/(u*rho*Cp)


def profile(x, y):
    """f of the gas; I0 is scaled by its exponential."""
    if y <= 0:
        return 0.0
    value, _ = quad(lambda z: np.exp(-(np.sqrt(y) - np.sqrt(z))**2)*ive(0, 2*np.sqrt(y*z)), 0, x,
                    limit=500, points=[min(x, y)] if y < x else None)
    return 1 - value


case = Case()
case.edit("system/controlDict", endTime=0.6)
case.run("blockMesh")
claim_runs("runs", case)
claim("exchange closes", worst(case.log(), "heat exchange error") < 1e-12)
for t in (0.2, 0.4, 0.6):
    y = q*(t - e*z/u)/((1 - e)*density*capacity)
    error = (case.field(f"{t}/T") - 300)/100 - [profile(*at) for at in zip(x, y)]
    rms = np.sqrt(np.mean(error**2))
    claim(f"at {t} s the gas differs from Schumann's by 0.01 (rms) of the front", rms < 0.01, rms)
    claim(f"at {t} s by at most 0.02", largest(error) < 0.02, largest(error))
claim("the bed is 30 transfer lengths deep", x.max() > 30)
finish()
