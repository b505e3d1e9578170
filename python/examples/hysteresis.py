"""hysteresis.py -- the loop of force over overlap of a yielding contact, in a head-on impact:
hysteresis.png. The area of the loop is the energy that the impact has lost.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import sys

import numpy

import suna

SCENE = """
materials { clay { density 2000; youngsModulus 1e7; poissonsRatio 0.3; } }
effects { hookeHysteresis { stiffness 1e4; unloading 4; plasticDepth 0.1; } }
"""


def main(picture="hysteresis.png"):
    sim = suna.Simulation(SCENE)
    d, v = 0.01, 0.5
    sim.add_particles([[0, 0, 0], [1.0001*d, 0, 0]], diameter=d, material="clay",
                      velocity=[[v, 0, 0], [-v, 0, 0]])
    kinetic = sim.totals["kinetic"]
    overlap, force = [], []
    for _ in range(4000):
        sim.advance(0.2*sim.step[0])
        x = sim.position[:, 0]
        overlap.append(d - abs(x[1] - x[0]))
        force.append(abs(sim.force[0, 0]))
    lost = kinetic - sim.totals["kinetic"]
    area = numpy.trapz(force, overlap)
    print(f"lost {lost:.6g} J, area of the loop {area:.6g} J")
    assert lost > 0.1*kinetic and abs(area/lost - 1) < 2e-3
    try:
        import matplotlib
        matplotlib.use("Agg")
        import matplotlib.pyplot as plt
    except ImportError:
        return
    plt.plot(1e6*numpy.array(overlap), force, color="#d55e00")
    plt.xlabel("overlap [um]")
    plt.ylabel("force [N]")
    plt.savefig(picture, dpi=100)


if __name__ == "__main__":
    main(*sys.argv[1:])
