"""A sphere falling from rest in liquid follows m dv/dt = (m - rho V) g - 3 pi mu d F(Re) v with
F = 1 + 0.15 Re^0.687 (Schiller and Naumann 1933), one-way and two-way. The case is CFDEMcoupling's settling test.

SPDX-License-Identifier: GPL-3.0-or-later
"""
from case import *
from closures import speed

claim("the reference calculation gives the tabulated final speed, 0.137337 m/s", close(speed(0.2), 0.137337, 2e-5))

# two-way the sphere drags its cells along: 1 % with cells of 100 diameters
for way, share in (("no", 0.005), ("yes", 0.01)):
    case = Case(f"twoWay-{way}")
    case.sub("constant/demProperties", "twoWay +yes", f"twoWay {way}")
    case.run("blockMesh")
    claim_runs(f"two-way {way}: runs", case)
    for t in (0.05, 0.1, 0.2):
        fallen = -case.field(f"{t}/lagrangian/particles/U")[0, 2]
        claim(f"two-way {way}: speed after {t} s (share {share})", close(fallen, speed(t), share), fallen)
finish()
