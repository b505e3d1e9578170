"""A duct with walls, which water flows through at a slant.

SPDX-License-Identifier: GPL-3.0-or-later
"""


def make(case):
    case.controls(0.02, 0.001)
    case.box((0.011, 0.011, 0.022), (5, 5, 10),
             {"inlet": ("patch", "z-"), "sides": ("wall", "y- x+ y+ x-"), "outlet": ("patch", "z+")})
    case.flow("(0.01 0 0.03)", """inlet { type fixedValue; value uniform (0.01 0 0.03); }
    sides { type noSlip; }
    outlet { type zeroGradient; }""", """inlet { type fixedFluxPressure; }
    sides { type fixedFluxPressure; }
    outlet { type fixedValue; value uniform 0; }""")
    case.gravity()
