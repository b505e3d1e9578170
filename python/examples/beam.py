"""beam.py -- a cantilever of bonded beads bends under its weight: the deflection of its end against
the deflection of a beam, q L^4/(8 E I).

SPDX-License-Identifier: GPL-3.0-or-later
"""
import numpy

import suna

N, D, MODULUS, DENSITY = 20, 1e-3, 1e8, 2500
SCENE = f"""
materials {{ bead {{ density {DENSITY}; youngsModulus 1e7; poissonsRatio 0.25; }} }}
effects
{{
    gravity {{ acceleration (0 0 -9.81); }}
    hertz {{}}
    bondLinear {{ normalStiffness {MODULUS/D}; shearStiffness {MODULUS/D/2}; dampingRatio 0.2; makeDistance 1.01; }}
}}
"""


def main():
    sim = suna.Simulation(SCENE)
    x = D*numpy.arange(N + 1)
    sim.add_particles(numpy.stack([x, 0*x, 0*x], axis=1), D, "bead", frozen=x == 0)
    end = []
    for _ in range(400):
        sim.advance(2e-3)
        end.append(sim.position[numpy.argmax(sim.id), 2])
    # the beam swings about its deflection and comes to rest
    found = -numpy.mean(end[-50:])
    load = DENSITY*numpy.pi/6*D**3*9.81/D
    inertia = numpy.pi*D**4/64
    length = N*D
    beam = load*length**4/(8*MODULUS*inertia)
    # discrete weights at the beads and shear are of the order of 1/N
    print(f"deflection {1e6*found:.4g} um, beam {1e6*beam:.4g} um, spread at the end "
          f"{1e6*numpy.ptp(end[-50:]):.2g} um, {len(sim.bonds['id'])} bonds")
    assert len(sim.bonds["id"]) == N
    assert abs(found/beam - 1) < 3/N


if __name__ == "__main__":
    main()
