"""hopper.py -- a bin with a slot empties: grains that have left over time, and the rate beside
Beverloo's law for a slot.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import numpy

import suna

D, DEPTH, HALF, SLOT = 3e-3, 12e-3, 40e-3, 24e-3
SCENE = f"""
materials {{ grain {{ density 2500; youngsModulus 2e6; poissonsRatio 0.25; }} }}
domain {{ y (0 {DEPTH}); periodic (y); }}
effects
{{
    gravity {{ acceleration (0 0 -9.81); }}
    hertz {{}} dry {{ restitution 0.8; }} mindlin {{ friction 0.4; }}
}}
walls
{{
    left {{ type plane; point ({-HALF} 0 0); normal (1 0 0); }}
    right {{ type plane; point ({HALF} 0 0); normal (-1 0 0); }}
    lid {{ type plane; point (0 0 0); normal (0 0 1); }}
}}
insert {{ grains {{ type random; diameter {D}; count 2400; min ({-HALF} 0 0); max ({HALF} {DEPTH} 0.13); seed 1; }} }}
"""


def floor(side):
    """A plate beside the slot, through the periodic faces, as two triangles."""
    x0, x1 = side*0.5*SLOT, side*1.5*HALF
    a, b, c, d = (x0, -DEPTH, 0), (x1, -DEPTH, 0), (x1, 2*DEPTH, 0), (x0, 2*DEPTH, 0)
    return [[a, b, c], [a, c, d]]


def main():
    filled = suna.Simulation(SCENE)
    filled.advance(0.4)
    filled.save("bin.dem")
    opened = SCENE.replace("lid {", "unused {").replace(
        "unused { type plane; point (0 0 0); normal (0 0 1); }", "") + \
        "outlets { below { point (0 0 -0.02); normal (0 0 -1); } }"
    sim = suna.Simulation(opened, start="bin.dem")
    for name, side in (("floorLeft", -1), ("floorRight", 1)):
        sim.add_wall(name, "grain", floor(side))
    left = []
    for _ in range(30):
        sim.advance(0.02)
        left.append(sim.flows[0]["particles"])
    rate = (left[24] - left[9])/0.3
    # mass per area of the slot: Beverloo with C = 1.03, k = 1.4, for grains that fill 0.6
    beverloo = 1.03*0.6/(numpy.pi/6*D**3)*DEPTH*9.81**0.5*(SLOT - 1.4*D)**1.5
    print(f"{left[-1]} of {len(filled)} grains have left; {rate:.0f} a second, Beverloo "
          f"{beverloo:.0f}")
    assert abs(rate/beverloo - 1) < 0.3


if __name__ == "__main__":
    main()
