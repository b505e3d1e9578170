"""calibrate.py -- which resistance to rolling gives a heap its measured slope? scipy looks for it.

A slope scatters by degrees from heap to heap, so it is a mean over some, and the search ends within
that.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import numpy
from scipy.optimize import brentq

import heap
import suna

MEASURED = 20.0     # degrees
SEEDS = (1, 2)


def mean_slope(friction):
    found = []
    for seed in SEEDS:
        with suna.Simulation(heap.SCENE, {"effects/rollingSpring/friction": friction,
                                          "insert/grains/seed": seed}) as sim:
            sim.advance(0.4)
            found.append(heap.slope(sim))
    print(f"resistance to rolling {friction:.3f}: {numpy.mean(found):.1f} degrees")
    return numpy.mean(found)


def main():
    friction = brentq(lambda f: mean_slope(f) - MEASURED, 0.005, 0.3, xtol=0.03)
    print(f"{MEASURED} degrees: resistance to rolling {friction:.2f}")
    assert abs(mean_slope(friction) - MEASURED) < 4


if __name__ == "__main__":
    main()
