"""study.py -- a study of parameters over processes: the restitution of a head-on impact over the
step, for three laws of damping.

SPDX-License-Identifier: GPL-3.0-or-later
"""
from multiprocessing import get_context

import suna

SCENE = """
materials { glass { density 2500; youngsModulus 1e8; poissonsRatio 0.25; } }
effects { hertz {} dry { restitution 0.7; } }
"""


def restitution(e):
    """The restitution that a contact with the setting e returns."""
    with suna.Simulation(SCENE, {"effects/dry/restitution": e, "time/step": 2e-7}) as sim:
        sim.add_particles([[0, 0, 0], [0.0101, 0, 0]], diameter=0.01, material="glass",
                          velocity=[[0.5, 0, 0], [-0.5, 0, 0]])
        sim.advance(1e-3)
        return sim.velocity[1, 0] - sim.velocity[0, 0]


def main():
    asked = (0.3, 0.5, 0.7, 0.9)
    with get_context("spawn").Pool(2) as pool:
        returned = pool.map(restitution, asked)
    for e, r in zip(asked, returned):
        print(f"asked {e}, returned {r:.5f}")
        assert abs(r - e) < 2e-3


if __name__ == "__main__":
    main()
