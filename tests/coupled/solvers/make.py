"""The fields of several solvers in a box, periodic along x.

SPDX-License-Identifier: GPL-3.0-or-later
"""


def make(case):
    case.controls(0.2, 0.001, 0.05, """
    particles
    {
        type            demCloud;
        libs            ("libdemCoupling.so");
        writeControl    writeTime;
    }
""", precision=17)
    case.edit("system/controlDict", startFrom="latestTime", adjustTimeStep="no", maxCo=1, maxAlphaCo=1)
    case.box((0.02, 0.02, 0.04), (5, 5, 10),
             {"left": ("cyclic; neighbourPatch right", "x-"), "right": ("cyclic; neighbourPatch left", "x+"),
              "walls": ("wall", "y- y+ z- z+")})
    for name, dimensions, value, walls in (
            ("T", "0 0 0 1 0 0 0", 300, "zeroGradient"), ("U", "0 1 -1 0 0 0 0", "(0 0 0)", "slip"),
            ("alpha.water", "0 0 0 0 0 0 0", 0, "zeroGradient"), ("p", "0 2 -2 0 0 0 0", 0, "zeroGradient"),
            ("p_rgh", "1 -1 -2 0 0 0 0", 0, "fixedFluxPressure; value uniform 0")):
        case.initial(name, dimensions, value, f'"(left|right)" {{ type cyclic; }} walls {{ type {walls}; }}')
    case.gravity()
