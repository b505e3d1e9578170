"""One sphere that falls obliquely from rest through liquid at Re 1 reaches the speed of its law once its own wake is
taken out of the fluid's velocity (ownWake); without, it is too fast.

SPDX-License-Identifier: GPL-3.0-or-later
"""
from case import *

d, speed = 1e-3, 0.01                                 # m, m/s: terminal speed of the law
direction = np.array((1, 0.37, 0.21))/np.linalg.norm((1, 0.37, 0.21))


def factor(Re):
    """Schiller and Naumann (1933), over Stokes's drag."""
    return 1 + 0.15*Re**0.687


def fall(name, kernel, cell, Re, own="yes", side=20, travel=6, density=2650, start=0.0, law="schillerNaumann", step=None,
         behind=None, more="", run=True):
    """The case, after it has run: cells of `cell` diameters in a box of `side`, the law's Re, the way of the law's
    speed and the speed at the start over it; step: as a part of the time that the law's speed needs for a cell; a
    second sphere so many diameters behind the first."""
    case = Case(name, source="shared")
    nu = speed*d/Re
    g = 18*nu*1000/(d**2*(density - 1000))*factor(Re)*speed
    T = (step or 0.25)*min(cell, 2)*d/speed
    n = round(side/cell)
    length = n*cell*d
    case.flow("(0 0 0)", "walls { type slip; }", "walls { type fixedFluxPressure; }")
    case.gravity(vector(g*direction))
    case.controls(T*round(travel*d/speed/T), T, nu=nu)
    case.box((length,)*3, (n,)*3, {"walls": ("wall", "x- x+ y- y+ z- z+")})
    middle = length/2 - direction*(0.5*travel*d) + 0.23*cell*d*np.array((1, -0.5, 0.3))
    positions = [middle] if behind is None else [middle, middle - behind*d*direction]
    case.properties(f"sphere {{ density {density}; youngsModulus 1e5; }}", f"hertz {{}} {law} {{}} pressureGradient {{}}",
                    f"sphere {{ type list; diameter {d}; positions ({' '.join(map(vector, positions))}); velocity {vector(start*speed*direction)}; }}",
                    f"rho 1000; kernel {kernel}; ownWake {own};" + more)
    if run:
        case.run("demPimpleFoam")
    return case


def speeds(case, density=2650):
    """Speed along the direction over the law's, after each step."""
    return case.vectors("particles", "momentum") @ direction/(density*np.pi*d**3/6*speed)


for kernel, cell in (("linear", 2), ("diffusion; width 1.5", 1)):
    mean = {}
    for own in ("no", "yes"):
        case = fall(f"{own}-{cell}", kernel, cell, 1, own)
        name = f"{kernel}, cells of {cell} d, ownWake {own}"
        claim_ran(f"{name}: runs", case)
        v = speeds(case)
        mean[own] = v[len(v)//2:].mean()
        claim(f"{name}: exchange closes", worst(case.log(), "exchange error") < 1e-12)
    claim(f"{kernel}, cells of {cell} d: the law's speed (2 %)", close(mean["yes"], 1, 0.02), mean["yes"])
    claim(f"{kernel}, cells of {cell} d: more than 10 % too fast without", mean["no"] > 1.1, mean["no"])
finish()
