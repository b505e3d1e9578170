"""oblique.py -- a ball that slides through an oblique impact: the tangential impulse is friction
times the normal one, and friction turns the ball by 5/2 of it.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import numpy

import suna

MU, E, R = 0.1, 0.9, 0.005
SCENE = f"""
materials {{ glass {{ density 2500; youngsModulus 1e8; poissonsRatio 0.25; }} }}
effects {{ hertz {{}} dry {{ restitution {E}; }} mindlin {{ friction {MU}; }} }}
walls {{ floor {{ type plane; material glass; point (0 0 0); normal (0 0 1); }} }}
"""


def main():
    for degrees in (45, 60, 75):
        angle = numpy.radians(degrees)
        before = numpy.array([numpy.sin(angle), 0, -numpy.cos(angle)])
        with suna.Simulation(SCENE) as sim:
            sim.add_particles([0, 0, 1.01*R], diameter=2*R, material="glass", velocity=before)
            sim.advance(2e-3)
            after, spin = sim.velocity[0].copy(), sim.spin[0].copy()
        lost = before[0] - after[0]             # tangential impulse over mass
        expected = MU*(after[2] - before[2])
        print(f"{degrees} degrees: e {-after[2]/before[2]:.4f}, tangential {lost:.5f} m/s, "
              f"friction times normal {expected:.5f} m/s, spin {spin[1]:.3f} 1/s")
        assert abs(-after[2]/before[2] - E) < 5e-3
        # the dashpot pulls at the end of the contact, and friction acts then, too
        assert abs(lost/expected - 1) < 5e-3
        # the lever is R less the overlap
        assert abs(spin[1]*R/(2.5*lost) - 1) < 0.02


if __name__ == "__main__":
    main()
