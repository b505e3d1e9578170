"""bounce.py -- a ball that bounces: each rebound reaches e^2 of the height before.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import numpy

import suna

E = 0.8         # restitution
SCENE = {
    "materials": {"glass": {"density": 2500, "youngsModulus": 1e8, "poissonsRatio": 0.25}},
    "effects": {"hertz": {}, "dry": {"restitution": E},
                "gravity": {"acceleration": (0, 0, -9.81)}},
    "walls": {"floor": {"type": "plane", "material": "glass", "point": (0, 0, 0),
                        "normal": (0, 0, 1)}},
}


def main():
    sim = suna.Simulation(SCENE)
    sim.add_particles([0, 0, 0.105], diameter=0.01, material="glass")
    height, tops = [], []
    for _ in range(500):
        sim.advance(1e-3)
        height.append(sim.position[0, 2] - 0.005)
        if len(height) > 2 and height[-2] > max(height[-3], height[-1]):
            # the top of the parabola through three points
            a, b, c = height[-3:]
            tops.append(b + (a - c)**2/(8*(2*b - a - c)))
    ratio = tops[1]/tops[0]
    print(f"tops {numpy.round(tops, 6)} m; ratio {ratio:.4f}, e^2 = {E**2:.4f}")
    assert abs(tops[0]/0.1 - E**2) < 5e-3 and abs(ratio - E**2) < 5e-3


if __name__ == "__main__":
    main()
