"""mixer.py -- a blade turns in a bed of two colours: torque, power and how far they are mixed.

The power of the blade is its torque times its speed, and the work of walls in the energy balance. Mixing
is Lacey's index: 0 unmixed, 1 as at random (P. M. C. Lacey, J. Appl. Chem. 4 (1954) 257).

SPDX-License-Identifier: GPL-3.0-or-later
"""
import numpy

import suna

RADIUS, D, OMEGA = 0.012, 1.5e-3, 12.0    # m, m, rad/s
SCENE = f"""
materials {{ grain {{ density 2500; youngsModulus 1e6; poissonsRatio 0.25; }} }}
effects {{ gravity {{ acceleration (0 0 -9.81); }}
          hertz {{}} dry {{ restitution 0.4; }} mindlin {{ friction 0.4; }} }}
walls {{ floor {{ type plane; point (0 0 0); normal (0 0 1); }}
        pot {{ type cylinder; point (0 0 0); axis (0 0 1); radius {RADIUS}; particles inside; }}
        blade {{ type triangles; corners ((-0.011 0 0.001) (0.011 0 0.001) (0.011 0 0.009)
                                          (-0.011 0 0.001) (0.011 0 0.009) (-0.011 0 0.009)); }} }}
insert {{ grains {{ type random; diameter {D}; count 600; min (-{RADIUS} -{RADIUS} 0); max ({RADIUS} {RADIUS} 0.03);
                   inside walls; seed 1; }} }}
"""
CELLS = 5    # along each axis


def lacey(sim, red):
    """Lacey's index over cells that hold at least 5 grains."""
    cell = ((sim.position + [RADIUS, RADIUS, 0])/(2*RADIUS/CELLS)).astype(int) @ [1, 100, 10000]
    coloured = numpy.isin(sim.id, red)
    number = numpy.array([(cell == k).sum() for k in numpy.unique(cell)])
    share = numpy.array([coloured[cell == k].mean() for k in numpy.unique(cell)])
    full, p = number >= 5, coloured.mean()
    variance = numpy.average((share[full] - p)**2, weights=number[full])
    return (p*(1 - p) - variance)/(p*(1 - p)*(1 - 1/number[full].mean()))


def main():
    sim = suna.Simulation(SCENE, energy=True)
    sim.advance(0.25)
    red = sim.id[sim.position[:, 0] > 0]
    sim.wall("blade").motion = {"type": "rotation", "origin": (0, 0, 0), "axis": (0, 0, 1), "omega": OMEGA,
                                "start": sim.time}
    turn = 2*numpy.pi/OMEGA
    for k in range(2):
        before = sim.energy["work_walls"]
        sim.reset_impulses()
        sim.advance(turn)
        torque = -sim.wall("blade").impulse[1][2]/turn
        power = (sim.energy["work_walls"] - before)/turn
        print(f"turn {k + 1}: torque {torque*1e6:.1f} uN m, power {torque*OMEGA*1e6:.1f} uW, work of walls "
              f"{power*1e6:.1f} uW, Lacey {lacey(sim, red):.2f}")
        assert abs(power/(torque*OMEGA) - 1) < 0.01
    assert lacey(sim, red) > 0.5


if __name__ == "__main__":
    main()
