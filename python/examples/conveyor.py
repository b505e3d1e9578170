"""conveyor.py -- a sphere set down on a belt slides until it rolls: it then moves with 2/7 of the belt's
speed, after the time 2 V/(7 mu g). Then it is taken off and the belt turned round.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import numpy

import suna

SPEED, FRICTION, G, D = 0.5, 0.3, 9.81, 1e-3    # m/s, 1, m/s2, m
BELT = "walls { belt { type plane; point (0 0 0); normal (0 0 1); surfaceVelocity (%g 0 0); } }" % SPEED
SCENE = f"""
materials {{ glass {{ density 2500; youngsModulus 1e8; poissonsRatio 0.25; }} }}
effects {{ gravity {{ acceleration (0 0 -{G}); }} hertz {{}} dry {{ restitution 0.1; }} mindlin {{ friction {FRICTION}; }} }}
""" + BELT


def main():
    sim = suna.Simulation(SCENE)
    sim.add_particles([0, 0, 0.5*D], D, "glass")
    slides = 2*SPEED/(7*FRICTION*G)

    def rolls(s):
        return numpy.hypot(*(s.velocity[0] + numpy.cross(s.spin[0], [0, 0, -0.5*D]) - [SPEED, 0, 0])[:2]) < 1e-3*SPEED

    sim.advance(3*slides, until=rolls, every=20)
    print(f"slides for {sim.time:.4f} s (2 V/(7 mu g): {slides:.4f}); rolls with {sim.velocity[0, 0]:.4f} m/s "
          f"(2/7 V: {2/7*SPEED:.4f})")
    assert abs(sim.time/slides - 1) < 0.03 and abs(sim.velocity[0, 0]/(2/7*SPEED) - 1) < 0.01
    sim.change({"walls/belt/surfaceVelocity": (-SPEED, 0, 0)})
    sim.set(sim.id, position=[0, 0, 0.5*D], velocity=0, spin=0)
    sim.advance(2*slides)
    assert abs(sim.velocity[0, 0]/(-2/7*SPEED) - 1) < 0.01


if __name__ == "__main__":
    main()
