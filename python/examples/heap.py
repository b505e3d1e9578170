"""heap.py -- grains fall on a plate and over its edges; what stays is a heap, drawn from the side:
heap.png.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import sys

import numpy

import suna

D, EDGE = 2e-3, 0.03        # m, of grains; half the length of the plate
SCENE = f"""
materials {{ grain {{ density 2500; youngsModulus 2e6; poissonsRatio 0.25; }} }}
domain {{ y (0 0.01); periodic (y); }}
effects
{{
    gravity {{ acceleration (0 0 -9.81); }}
    hertz {{}} dry {{ restitution 0.3; }} mindlin {{ friction 0.5; }} rollingSpring {{ friction 0.05; }}
}}
walls {{ plate {{ type triangles; corners (({-EDGE} -0.01 0) ({EDGE} -0.01 0) ({EDGE} 0.02 0)
                                           ({-EDGE} -0.01 0) ({EDGE} 0.02 0) ({-EDGE} 0.02 0)); }} }}
insert {{ grains {{ type random; diameter {D}; count 1400; min (-0.032 0 0); max (0.032 0.01 0.042); seed 1; }} }}
outlets {{ below {{ point (0 0 -0.01); normal (0 0 -1); }} }}
"""


def slope(sim):
    """Mean slope of both sides of the heap [degrees], from its height over the plate."""
    x, z = sim.position[:, 0], sim.position[:, 2]
    edges = numpy.linspace(-EDGE, EDGE, 16)
    middle = 0.5*(edges[1:] + edges[:-1])
    number = numpy.histogram(x[z > 0], edges)[0]
    height = number*numpy.pi/6*D**3/(0.57*0.01*(edges[1] - edges[0]))
    side = abs(middle) < EDGE - 2*D
    return numpy.degrees(numpy.arctan(-numpy.polyfit(abs(middle[side]), height[side], 1)[0]))


def main(picture="heap.png"):
    sim = suna.Simulation(SCENE)
    sim.advance(0.6)
    print(f"{sim}: slope {slope(sim):.1f} degrees")
    assert 10 < slope(sim) < 40
    lying = sim.position[:, 2] > 0
    weight, load = 9.81*sim.mass[lying].sum(), sim.walls["plate"].load[0][2]
    assert abs(abs(load)/weight - 1) < 0.05
    try:
        import matplotlib
        matplotlib.use("Agg")
    except ImportError:
        return
    axes = sim.plot(colour=sim.position[:, 2])
    axes.figure.savefig(picture, dpi=100)


if __name__ == "__main__":
    main(*sys.argv[1:])
