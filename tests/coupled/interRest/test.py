"""Water and air in layers at rest stay at rest with particles across their surface, frozen and in a settled bed,
whatever the void fraction: velocities of round-off, the pressure gradient in each cell is rho g.

A bed of free grains that settled dry comes to rest in a viscous liquid: the liquid lifts its grains, they find their
places, and nothing stirs the bed.

SPDX-License-Identifier: GPL-3.0-or-later
"""
from two_fluids import *

g, size, cells = 9.81, (0.06, 0.06, 0.12), (8, 8, 18)
walls = {"walls": ("wall", "x- x+ y- y+ z- z+")}


def vessel(name, surface):
    """A vessel that is filled up to here, which is in the middle of a row of cells."""
    case = TwoFluids(name)
    case.controls(0.02, 1e-3, precision=17)
    case.fluids(tolerance=1e-13)
    case.box(size, cells, walls)
    case.fields(walls)
    h = size[2]/cells[2]
    case.alpha(lambda x: (surface - x[:, 2])/h + 0.5)
    return case


def claims(name, case):
    claim_runs(f"{name}: runs", case, "demInterFoam")
    void, alpha, gradP = case.interior("voidFraction"), case.interior("alpha.water"), case.interior("gradP")
    rho = WATER[0]*alpha + AIR[0]*(1 - alpha)
    claim(f"{name}: the void fraction varies across the surface", np.ptp(void[(alpha > 0.1) & (alpha < 0.9)]) > 0.03,
          np.ptp(void[(alpha > 0.1) & (alpha < 0.9)]))
    claim(f"{name}: no fluid moves (1e-9 m/s)", largest(case.interior("U")) < 1e-9, largest(case.interior("U")))
    error = difference(gradP, rho[:, None]*np.array([0, 0, -g]))/(WATER[0]*g)
    claim(f"{name}: the pressure gradient is rho g in each cell (1e-10 of the water's)", error < 1e-10, error)
    p, z = case.interior("p"), case.centres()[:, 2]
    h = size[2]/cells[2]
    error = np.mean(p[z < h]) - np.mean(p[abs(z - 1.5*h) < 0.1*h]) - WATER[0]*g*h
    claim(f"{name}: the pressure on the floor rises by the weight of the water alone (1e-9)",
          abs(error) < 1e-9*WATER[0]*g*h, error)
    low, high, volume = case.bounds().T
    claim(f"{name}: alpha stays in [0, 1] (1e-13)", low.min() > -1e-13 and high.max() < 1e-13, low.min(), high.max())
    claim(f"{name}: the volume of water is kept (1e-13)", np.ptp(volume) < 1e-13*volume[0], np.ptp(volume)/volume[0])
    claim(f"{name}: exchange closes", worst(case.log("demInterFoam"), "exchange error") < 1e-12)


case = vessel("frozen", 0.0612)
case.grains("grain { density 2500; youngsModulus 1e6; }", "hertz {} gidaspow {}",
            """grains { type random; diameter 5e-3; count 1200; seed 3; frozen yes;
                        min (0 0 0.02); max (0.06 0.06 0.1); }""", "kernel linear;")
claims("frozen", case)

case = vessel("settled", 0.0312)
case.grains("grain { density 2500; youngsModulus 1e6; }", "hertz {} dry { restitution 0.3; } gidaspow {}",
            "grains { type random; diameter 7e-3; count 350; seed 2; min (0 0 0); max (0.06 0.06 0.11); }")
case.append("constant/demProperties", 'start { snapshot "settled.dem"; }\n')
case.run("demInterFoam", "-settle", log="log.settle")
case.sub("constant/demProperties", "^start .*", 'start { snapshot "settled.dem"; frozen yes; }\ntime { step 1e-3; }')
claims("settled", case)

case.sub("constant/demProperties", "frozen yes; }\ntime .*", "}")
case.sub("constant/demProperties", "gidaspow", "mindlin { friction 0.3; } gidaspow")
case.fluids((1000, 0.3), (1, 1e-2), tolerance=1e-13)
case.controls(0.3, 1e-3, write=0.1, precision=17)
claim_runs("free: runs", case, "demInterFoam")
times = case.times()[-3:]
grains = [math.sqrt(np.mean(np.sum(case.particles(time, "U")[:, 1:]**2, axis=1))) for time in times]
fluids = [largest(case.field(f"{time}/U")) for time in times]
claim("free: the grains rest (1e-6 m/s, root mean square)", grains[-1] < 1e-6, *grains)
# what is left is the levelling of the surface
claim("free: the fluids come to rest (1e-4 m/s and falling)",
      fluids[-1] < 1e-4 and fluids[0] > fluids[1] > fluids[2], *fluids)
finish()
