"""A column of water, open above.

SPDX-License-Identifier: GPL-3.0-or-later
"""


def column(case, size, cells):
    case.box(size, cells, {"sides": ("wall", "y- x+ y+ x-"), "bottom": ("wall", "z-"), "top": ("patch", "z+")})


def make(case):
    case.controls(0.04, 0.001)
    column(case, (0.000963, 0.000963, 0.00289), (4, 4, 12))
    case.flow("(0 0 0)", """sides { type slip; }
    bottom { type noSlip; }
    top { type pressureInletOutletVelocity; value uniform (0 0 0); }""",
              '"(sides|bottom)" { type fixedFluxPressure; } top { type fixedValue; value uniform 0; }')
    case.gravity()
