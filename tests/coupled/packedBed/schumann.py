#!/usr/bin/env python3
"""schumann.py -- breakthrough of a temperature front in a packed bed, after Schumann.

    schumann.py u e d rho Cp kappa nu density capacity t < "z T" of the gas, one line a cell

Plug flow of the superficial velocity u, no conduction along the bed: with q = h a and the profile
f = (T - T0)/(T_in - T0),

    e rho Cp df/dt + u rho Cp df/dx = q (g - f)       gas
    (1 - e) density capacity dg/dt = q (f - g)        spheres

    f = 1 - exp(-y) int_0^x' exp(-z) I0(2 sqrt(y z)) dz
    x' = q x/(u rho Cp),   y = q (t - e x/u)/((1 - e) density capacity)

q = 6 (1 - e) kappa Nu/d^2, Nu = 2 + 1.1 Re^0.6 Pr^(1/3) of Wakao and Kaguei (1982).
Source: Schumann, J. Franklin Inst. 208 (1929) 405.

Prints the root mean square and the largest difference of f in the cells behind the inlet, and the
largest x'.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import sys

import numpy as np
from scipy.integrate import quad
from scipy.special import ive


def gas(x, y):
    """f; I0 is scaled by its exponential"""
    if y <= 0:
        return 0.0
    value, _ = quad(lambda z: np.exp(-(np.sqrt(y) - np.sqrt(z))**2)*ive(0, 2*np.sqrt(y*z)), 0, x,
                    limit=500, points=[min(x, y)] if 0 < y < x else None)
    return 1 - value


def main():
    u, e, d, rho, Cp, kappa, nu, density, capacity, time = map(float, sys.argv[1:])
    z, T = np.loadtxt(sys.stdin).T
    Nu = 2 + 1.1*(u*d/nu)**0.6*(rho*nu*Cp/kappa)**(1/3)
    q = 6*(1 - e)*kappa*Nu/d**2
    x = q*z/(u*rho*Cp)
    y = q*(time - e*z/u)/((1 - e)*density*capacity)
    f = np.array([gas(*at) for at in zip(x, y)])
    error = (T - 300)/100 - f
    print(np.sqrt(np.mean(error**2)), np.abs(error).max(), x.max())


main()
