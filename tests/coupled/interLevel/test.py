"""The surface of water rises by the volume of the particles that plunge into it: 2000 spheres of 4 mm raise it by 6.702 mm
in a vessel of 0.1 x 0.1 m, with any step.

SPDX-License-Identifier: GPL-3.0-or-later
"""
from two_fluids import *

count, d, area = 2000, 4e-3, 0.1*0.1
rise = count*math.pi/6*d**3/area
walls = {"walls": ("wall", "x- x+ y- y+ z- z+")}
cells = (10, 10, 20)


def level(case, time):
    """Height below which the water would be alone with the particles, from its volume and theirs under the surface."""
    alpha, e = (case.field(f"{time}/{name}") for name in ("alpha.water", "voidFraction"))
    V = area*0.2/np.prod(cells)
    return V*np.sum(alpha)/area, V*np.sum(alpha*e)/area


def plunge(step):
    case = TwoFluids(f"step-{step}")
    case.controls(0.3, step)
    case.fluids(tolerance=1e-9, correctors=2, outer=1, sub_cycles=3)
    case.box((0.1, 0.1, 0.2), cells, walls)
    case.fields(walls)
    case.alpha(lambda x: x[:, 2] < 0.1)
    # driven: a pack of spheres sinks through the surface at 0.3 m/s, and stops before the floor
    case.grains("grain { density 2500; youngsModulus 1e6; }", "hertz {} gidaspow {}",
                f"""grains {{ type lattice; diameter {d}; count {count}; spacing 1.2; jitter 0.5; driven yes;
                              velocity (0 0 -0.3); min (0 0 0.115); max (0.1 0.1 0.2); }}""")
    case.run("demInterFoam")
    claim_ran(f"step {step}: runs", case, "demInterFoam")
    whole, water = level(case, case.times()[-1])
    claim(f"step {step}: the surface has risen by {rise*1e3:.3f} mm (0.1 %)", close(whole - 0.1, rise, 1e-3), whole - 0.1, rise)
    claim(f"step {step}: the volume of water is kept (1e-10)", close(water, 0.1, 1e-10), water/0.1 - 1)
    low, high, volume = case.bounds().T
    claim(f"step {step}: alpha stays in [0, 1] (1e-10)", low.min() > -1e-10 and high.max() < 1e-10, low.min(), high.max())


for step in (1e-3, 3e-3):
    plunge(step)
finish()
