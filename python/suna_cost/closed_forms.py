"""closed_forms.py -- the head-on impact of two bodies.

  restitution e                      1 without damping, `restitution` of dry (attraction allowed);
                                     none for other damping laws
  kinetic energy after the impact    K - (1 - e^2) m* v^2/2
  largest overlap without damping    hertz  (15 m* v^2/(16 E* sqrt(R*)))^(2/5)
                                     hooke  v sqrt(m*/k)

  m*, R*, E*   reduced mass, radius, modulus                     [kg], [m], [Pa]
  v            approach speed                                    [m/s]
  k            stiffness of hooke, given in the scene            [N/m]

Limits: two particles, or one and a plane at rest, on one line, without spin, with contact forces
only; other scenes have no closed form here.

Source: Hertz 1882 as in Johnson, Contact Mechanics (1985), 11.4; for e of dry see
dem/laws/contact/restitution.h.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import math
import re

import numpy

# effects under which two bodies that part are free: contact laws, and films that only attract
LOSSLESS = {"hertz", "hooke"}
ONLY_CONTACT = LOSSLESS | {"dry", "viscous", "stokesDamping", "hookeHysteresis", "linear", "mindlin",
                           "mindlinIncremental", "rollingConstant", "rollingSpring",
                           "rollingViscous", "twistingSpring", "sjkr", "jkr"}


def vector(text):
    return numpy.array(re.findall(r"[-+0-9.eE]+", text), float)


def number(sim, path, default=None):
    text = sim.value(path)
    return default if text is None else float(text)


def plane(sim):
    """Normal of the only wall, if it is a plane at rest, else None."""
    walls = list(sim.walls)
    if len(walls) != 1:
        return None
    path = f"walls/{walls[0]}"
    moves = {"motion", "surfaceVelocity", "surfaceRotation"} & set(sim.names(path))
    if sim.value(path + "/type") != "plane" or moves:
        return None
    normal = vector(sim.value(path + "/normal"))
    return normal/numpy.linalg.norm(normal)


class Impact:
    """Two bodies, or one and a plane, in head-on impact."""

    def __init__(self, sim, normal, speed):
        order = numpy.argsort(sim.id)
        self.normal, self.speed = normal, speed
        self.mass, self.radius = sim.mass[order].copy(), sim.radius[order].copy()

    @staticmethod
    def rate(sim):
        """Velocity of the first body relative to the second, in the order of their ids."""
        v = sim.velocity[numpy.argsort(sim.id)]
        return v[0] - v[1] if len(v) > 1 else v[0].copy()

    def separation(self, sim):
        return self.rate(sim) @ self.normal

    @staticmethod
    def reduced(values):
        return values[0]*values[1]/values.sum() if len(values) == 2 else values[0]


def find_impact(sim):
    """The impact that a scene is, or None."""
    n = len(sim)
    if n > 2 or n < 1 or not set(sim.effects) <= ONLY_CONTACT or sim.spin.any():
        return None
    if n == 2:
        x = sim.position[numpy.argsort(sim.id)]
        normal = x[0] - x[1]
        if sim.walls or not normal.any():
            return None
        normal = normal/numpy.linalg.norm(normal)
    else:
        normal = plane(sim)
        if normal is None:
            return None
    rate = Impact.rate(sim)
    speed = -(rate @ normal)
    if speed <= 0 or rate @ rate - speed**2 > 1e-18*speed**2:
        return None
    return Impact(sim, normal, speed)


def restitution(sim):
    """Restitution of the scene's laws; None: no closed form."""
    losses = set(sim.names("effects")) - {"hertz", "hooke", "linear", "mindlin",
                                          "mindlinIncremental", "rollingConstant",
                                          "rollingSpring", "rollingViscous", "twistingSpring"}
    if not losses:
        return 1.0
    if losses != {"dry"} or sim.value("effects/dry/attraction") not in (None, "allowed"):
        return None
    return number(sim, "effects/dry/restitution")


def largest_overlap(sim, impact):
    """Largest overlap [m] of an elastic impact; None: no closed form."""
    m, r = impact.reduced(impact.mass), impact.reduced(impact.radius)
    effects = sim.names("effects")
    if "hertz" in effects:
        stiffness = number(sim, "effects/hertz/stiffness", 0.0)
        if stiffness > 0:
            modulus = 0.75*stiffness
        else:
            materials = sim.names("materials")
            if len(materials) != 1:
                return None
            nu = number(sim, f"materials/{materials[0]}/poissonsRatio", 0.3)
            modulus = 0.5*number(sim, f"materials/{materials[0]}/youngsModulus")/(1 - nu**2)
        return (15/16*m*impact.speed**2/(modulus*math.sqrt(r)))**0.4
    stiffness = number(sim, "effects/hooke/stiffness", 0.0) if "hooke" in effects else 0.0
    return impact.speed*math.sqrt(m/stiffness) if stiffness > 0 else None


def closed_forms(sim, impact):
    """Exact values by quantity."""
    if impact is None or "pairs" in sim.names():
        return {}
    e = restitution(sim)
    if not e:       # after e = 0 the time of separation is not known
        return {}
    m = impact.reduced(impact.mass)
    found = {"restitution": e,
             "kinetic": sim.totals["kinetic"] - 0.5*(1 - e**2)*m*impact.speed**2}
    overlap = largest_overlap(sim, impact) if e == 1 else None
    if overlap:
        found["overlap"] = 0.5*overlap/impact.radius.min()
    return found
