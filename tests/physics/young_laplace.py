#!/usr/bin/env python3
"""young_laplace.py -- liquid bridge between two equal spheres by the Young-Laplace equation: force.

    dphi/ds = p - cos(phi)/r        p = pressure in the liquid, over the surface tension [1/m]

The meridian r(s), z(s) of the surface starts at the contact line on the sphere, at the filling
angle b, with the given contact angle, and must be normal to the plane of symmetry, which gives p.
The volume gives b. The force is that at the neck, 2 pi r - pi p r^2. Lengths are in radii, forces
over 2 pi R surface tension. Weight of the liquid is neglected.

    python3 young_laplace.py > liquid_bridge_young_laplace.csv        minutes

SPDX-License-Identifier: GPL-3.0-or-later
"""
import numpy as np
from scipy.integrate import solve_ivp
from scipy.optimize import brentq


def meridian(b, p, gap, angle):
    """Slope at the plane of symmetry, neck radius, volume of half of the bridge; or None."""
    def derivative(_, y):
        r, _, phi, _ = y
        return [-np.sin(phi), -np.cos(phi), p - np.cos(phi)/r, np.pi*r*r*np.cos(phi)]

    def neck(_, y):
        return y[2]

    def far(_, y):
        return y[1] + 1.0

    neck.terminal = far.terminal = True
    start = [np.sin(b), 0.5*gap + 1.0 - np.cos(b), 0.5*np.pi - b - angle, 0.0]
    path = solve_ivp(derivative, [0.0, 5.0], start, events=[neck, far], rtol=1e-10, atol=1e-12)
    return path.y[:, -1] if len(path.t_events[0]) else None


def height(b, p, gap, angle):
    """Height of the neck over the plane of symmetry; 1 where there is no neck."""
    end = meridian(b, p, gap, angle)
    return 1.0 if end is None else end[1]


def bridge(b, gap, angle):
    """Volume and force of the bridge with this filling angle; or None."""
    pressures = np.concatenate([-np.logspace(3.5, -2, 60), [0.0], np.logspace(-2, 0.5, 20)])
    last = None
    for p in pressures:
        now = height(b, p, gap, angle)
        if last and last[1]*now < 0.0:
            p = brentq(lambda p: height(b, p, gap, angle), last[0], p, xtol=1e-11)
            if abs(height(b, p, gap, angle)) < 1e-6:
                r, _, _, half = meridian(b, p, gap, angle)
                cap = np.pi*(1.0 - np.cos(b))**2*(2.0 + np.cos(b))/3.0
                return 2.0*half - 2.0*cap, r - 0.5*p*r*r
            now = height(b, p, gap, angle)
        last = (p, now)
    return None


def force(gap, volume, angle):
    """Force of the stable bridge of this volume; or None."""
    last = None
    for b in np.radians(np.concatenate([np.arange(2, 12, 1.5), np.arange(12, 70, 4)])):
        found = bridge(b, gap, angle)
        if found and last and (last[1] - volume)*(found[0] - volume) < 0.0:
            b = brentq(lambda b: bridge(b, gap, angle)[0] - volume, last[0], b, xtol=1e-9)
            return bridge(b, gap, angle)[1]
        last = (b, found[0]) if found else last
    return None


print("# two equal spheres, by young_laplace.py; gap over (1 + angle/2) volume^(1/3)")
print("angle[degree],volume[R^3],gap[1],force[2 pi R g]")
for degrees in (0, 20, 40):
    for volume in (1e-4, 1e-3, 1e-2, 5e-2):
        for fraction in (0.01, 0.1, 0.3, 0.6):
            angle = np.radians(degrees)
            found = force(fraction*(1.0 + 0.5*angle)*volume**(1.0/3.0), volume, angle)
            if found is not None:
                print("%g,%g,%g,%.5f" % (degrees, volume, fraction, found), flush=True)
