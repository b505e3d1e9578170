"""The surface of water rises by the volume of the particles that plunge into it: 2000 spheres of 4 mm raise it by 6.702
mm in a vessel of 0.1 x 0.1 m, with any step.

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
    case.controls(0.6, step)
    case.fluids(tolerance=1e-9, correctors=2, outer=1, sub_cycles=3)
    case.box((0.1, 0.1, 0.2), cells, walls)
    case.fields(walls)
    case.alpha(lambda x: x[:, 2] < 0.1)
    case.grains("grain { density 2500; youngsModulus 1e6; }", "hertz {} dry { restitution 0.3; } gidaspow {}",
                f"""grains {{ type lattice; diameter {d}; count {count}; spacing 1.2; jitter 0.5;
                              velocity (0 0 -0.3); min (0 0 0.115); max (0.1 0.1 0.2); }}""")
    claim_runs(f"step {step}: runs", case, "demInterFoam")
    low, high, volume = case.bounds().T
    # the kernel's tail of the lowest spheres lies in the water from the start
    whole, water = level(case, case.times()[-1])
    claim(f"step {step}: the surface rises by {rise*1e3:.3f} mm (1e-6 of it)",
          close(whole - volume[0]/area, rise, 1e-6), whole - volume[0]/area, rise)
    claim(f"step {step}: the volume of water is kept (1e-12)", np.ptp(volume) < 1e-12*volume[0],
          np.ptp(volume)/volume[0])
    claim(f"step {step}: so it is by the void fraction (1e-7)", close(water, volume[0]/area, 1e-7),
          water/(volume[0]/area) - 1)
    z = case.particles(case.times()[-1], "positions")[:, 3]
    claim(f"step {step}: all spheres lie in the water", len(z) == count and z.max() < 0.05, z.max())
    claim(f"step {step}: alpha stays in [0, 1] (1e-12)", low.min() > -1e-12 and high.max() < 1e-12, low.min(),
          high.max())


for step in (1e-3, 3e-3):
    plunge(step)
finish()
