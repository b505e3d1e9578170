#!/usr/bin/env python3
"""history.py -- height of the first bounce with and without history forces, from the measured restitution.

    history.py

Integrates the flight of a sphere that leaves the plate at e times the speed of the impact, under weight, drag
(Schiller and Naumann) and added mass, as Suna does, and with the history force of Mei and Adrian (J. Fluid Mech. 237
(1992) 323)

    F = -6 pi mu a sum over the past of K(age, speed then) dv
    K = ((pi nu age/a2)^1/4 + (pi/2 |v|3 age2/(a nu f3))^1/2)^-2,    f = 0.75 + 0.105 Re

with the reversal at the plate, (1 + e) times the speed of the impact, as the first dv. Before it the flow is steady.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import numpy
from analyse import SETS

DENSITY, GRAVITY = 7800, 9.81
# St: measured e and its interval (stored/result.csv), height [mm]
MEASURED = {27: (0.4781, 0.033, 1.97), 152: (0.8463, 0.052, 7.47)}


def highest(d, rho, mu, impact, e, history, steps=4000, end=0.08):
    """Largest height [mm] of the sphere's lowest point."""
    a, nu, dt = d/2, mu/rho, end/steps
    mass, displaced = DENSITY*numpy.pi/6*d**3, rho*numpy.pi/6*d**3
    stokes = 6*numpy.pi*mu*a

    def kernel(age, v):
        f = 0.75 + 0.105*2*a*abs(v)/nu
        return ((numpy.pi*nu*age/a**2)**0.25 + numpy.sqrt(numpy.pi/2*abs(v)**3*age**2/(a*nu*f**3)))**-2

    v, dv, z = numpy.empty(steps + 1), numpy.empty(steps), 0.0
    v[0] = e*impact
    # of the change within the step: the mean of the integral of a/sqrt(pi nu age)
    own = 4/3*stokes*a*numpy.sqrt(dt/(numpy.pi*nu)) if history else 0.0
    for k in range(steps):
        drag = stokes*(1 + 0.15*(2*a*abs(v[k])/nu)**0.687)*v[k]
        past = 0.0
        if history:
            # within the first step the mean of age^-1/2 is that of a quarter of the step
            past = stokes*((1 + e)*impact*kernel((k + 0.5 if k else 0.25)*dt, v[0])
                           + numpy.dot(dv[:k], kernel(numpy.arange(k, 0, -1)*dt, v[:k])))
        dv[k] = -dt*((mass - displaced)*GRAVITY + drag + past)/(mass + displaced/2 + own)
        v[k + 1] = v[k] + dv[k]
        if v[k + 1] < 0:
            return 1e3*z
        z += dt*(v[k] + v[k + 1])/2
    raise SystemExit("history.py: the sphere still rises at the end")


for St, (e, interval, measured) in MEASURED.items():
    for history in False, True:
        heights = [highest(*SETS[St], e + side*interval, history) for side in (-1, 0, 1)]
        print(f"St {St}: measured {measured} mm, {'with' if history else 'without'} history"
              f" {heights[1]:.2f} mm, {heights[0]:.2f} to {heights[2]:.2f} within the interval of e")
