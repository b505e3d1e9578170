"""Grains that sink steadily in a closed tank of water and air: the pressure on the floor less the pressure on the lid carries
the weight of water, air and grains.

SPDX-License-Identifier: GPL-3.0-or-later
"""
from two_fluids import *

g, across, height, surface, count, d = 9.81, 0.02, 0.1, 0.08, 384, 1e-3
case = TwoFluids()
case.controls(0.25, 1e-3, write=0.025)
case.fluids(tolerance=1e-9, correctors=2)
case.box((across, across, height), (4, 4, 20),
         {"walls": ("wall", "x- x+ y- y+"), "floor": ("wall", "z-"), "lid": ("wall", "z+")})
case.fields(("walls", "floor", "lid"), slip=True)
case.alpha(lambda x: x[:, 2] < surface)
# four in each cell of six layers, so that they sink side by side
places = [(x, y, z) for z in 0.042 + 0.005*np.arange(6) for x in 0.00125 + 0.0025*np.arange(8) for y in 0.00125 + 0.0025*np.arange(8)]
case.grains("grain { density 2500; youngsModulus 1e5; }", "hertz {} dry { restitution 0.5; } schillerNaumann {}",
            f"grains {{ type list; diameter {d}; positions ({' '.join(map(vector, places))}); }}")
claim_runs("runs", case, "demInterFoam")
times = [time for time in case.times() if float(time) > 0.12]
v, lowest = ([f(case.particles(time, name)[:, 3]) for time in times] for f, name in ((np.mean, "U"), (np.min, "positions")))
claim("the grains sink steadily, in the water", np.ptp(v) < 0.02*abs(np.mean(v)) and min(lowest) > 3*d, v, lowest)
excess = []
for time in times:
    alpha, e = case.field(f"{time}/alpha.water"), case.field(f"{time}/voidFraction")
    fluids = np.mean(e*(WATER[0]*alpha + AIR[0]*(1 - alpha)))*height*g
    excess.append(case.boundary(f"{time}/p", "floor").mean() - case.boundary(f"{time}/p", "lid").mean() - fluids)
weight = len(places)*math.pi/6*d**3*2500*g/across**2
claim(f"the floor carries their weight, {weight:.2f} Pa (1 %)", np.all(abs(np.array(excess)/weight - 1) < 0.01),
      *excess)
finish()
