"""A sphere, or two in line, falls obliquely through liquid in a box of 20 diameters, at the terminal speed of Schiller and
Naumann's law (1933) for a given Reynolds number.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import numpy as np

from case import vector

d, speed = 1e-3, 0.01                                 # m, m/s: terminal speed of the law
direction = np.array((1, 0.37, 0.21))/np.linalg.norm((1, 0.37, 0.21))


def factor(Re):
    """Drag over Stokes's drag."""
    return 1 + 0.15*Re**0.687


def prepare(case, coupling, cell, Re, travel=6.0, step=0.25, density=2650, start=0.0, behind=None):
    """Entries of coupling; size of the cells [d]; travel at the law's speed, and at that speed in a step [d]; speed at
    the start over the law's; a second sphere so far behind [d]."""
    nu = speed*d/Re
    g = 18*nu*1000/(d**2*(density - 1000))*factor(Re)*speed
    T = step*d/speed
    n = round(20/cell)
    length = n*cell*d
    case.flow("(0 0 0)", "walls { type slip; }", "walls { type fixedFluxPressure; }")
    case.gravity(vector(g*direction))
    case.controls(T*round(travel/step), T, nu=nu)
    case.box((length,)*3, (n,)*3, {"walls": ("wall", "x- x+ y- y+ z- z+")})
    middle = length/2 - direction*(0.5*travel*d) + 0.23*cell*d*np.array((1, -0.5, 0.3))
    positions = [middle] if behind is None else [middle, middle - behind*d*direction]
    case.properties(f"sphere {{ density {density}; youngsModulus 1e5; }}",
                    "hertz {} schillerNaumann {} pressureGradient {}",
                    f"sphere {{ type list; diameter {d}; positions ({' '.join(map(vector, positions))}); "
                    f"velocity {vector(start*speed*direction)}; }}",
                    f"rho 1000; {coupling}")


def speeds(case, density=2650):
    """Speed along the direction over the law's, after each step; of a pair the sum."""
    return case.vectors("particles", "momentum") @ direction/(density*np.pi*d**3/6*speed)


def mean(case):
    """Over the second half of the travel."""
    v = speeds(case)
    return v[len(v)//2:].mean()
