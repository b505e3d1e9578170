"""Closed forms that several tests compare with.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import numpy as np


def gidaspow_gradient(void):
    """Pressure gradient [Pa/m] of a bed of spheres of 1 mm at this void fraction, in air at a superficial velocity of
    0.3 m/s: Ergun (1952), Wen and Yu (1966), and the blend of Huilin and Gidaspow (2003)."""
    s, d, mu, rho, w = 1 - void, 1e-3, 1.8e-5, 1.2, 0.3/void
    Re = rho*0.3*d/mu
    ergun = 150*s*s*mu/(void*d*d) + 1.75*s*rho*w/d
    wen_yu = 18/Re*(1 + 0.15*Re**0.687)*rho*w*void*s/d*void**-2.65
    blend = np.arctan(262.5*(0.2 - s))/np.pi + 0.5
    return (blend*wen_yu + (1 - blend)*ergun)*w/void


def speed(t, rho=10, mu=1e-4, d=1e-4, density=3000):
    """Speed of a sphere that falls from rest, m dv/dt = (m - rho V) g - 3 pi mu d (1 + 0.15 Re^0.687) v (Schiller and
    Naumann 1933), by midpoint steps of 10 us; accurate to 1e-6."""
    def acceleration(v):
        return 9.81*(1 - rho/density) - 18*mu/(density*d*d)*v*(1 + 0.15*(rho*d*v/mu)**0.687)

    v, h = 0.0, 1e-5
    for _ in range(round(t/h)):
        v += h*acceleration(v + h/2*acceleration(v))
    return v


# void fraction of the lattice of fixedBed, 1.1 d from sphere to sphere
lattice_void = 1 - np.pi/6/1.1**3
