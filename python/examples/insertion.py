"""insertion.py -- particles from numpy: a hexagonal layer with diameters of one's own, and a wall of
triangles.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import numpy

import suna

SCENE = """
materials { glass { density 2500; youngsModulus 1e7; poissonsRatio 0.25; } }
effects { gravity { acceleration (0 0 -9.81); } hertz {} dry { restitution 0.5; } mindlin { friction 0.5; } }
"""


def main():
    random = numpy.random.default_rng(1)
    k, j = numpy.meshgrid(numpy.arange(12), numpy.arange(10))
    d = random.uniform(0.8e-3, 1e-3, k.size)
    place = numpy.stack([(k + 0.5*(j % 2)).ravel()*1.05e-3, j.ravel()*0.92e-3,
                         numpy.full(k.size, 1e-3)], axis=1)
    a, b, c, e = (-0.01, -0.01, 0), (0.03, -0.01, 0), (0.03, 0.03, 0), (-0.01, 0.03, 0)

    sim = suna.Simulation(SCENE)
    sim.add_wall("plate", "glass", [[a, b, c], [a, c, e]])
    sim.add_particles(place, d, "glass", velocity=random.normal(0, 0.01, place.shape))
    sim.advance(0.3)
    force, _ = sim.walls["plate"].load
    weight = 9.81*sim.mass.sum()
    print(f"{sim}\nforce on the plate {force[2]:.6g} N, weight {-weight:.6g} N")
    assert abs(force[2]/-weight - 1) < 0.02
    assert abs(sim.position[:, 2] - sim.radius).max() < 0.01*d.max()
    assert numpy.isclose(sim.mass.sum(), (2500*numpy.pi/6*d**3).sum(), rtol=1e-14)


if __name__ == "__main__":
    main()
