"""Liquid between two plates, periodic along x and y.

SPDX-License-Identifier: GPL-3.0-or-later
"""


def make(case):
    case.controls(0.2, 0.002, 0.1, precision=17)
    case.box((0.012, 0.012, 0.024), (6, 6, 12), {
        "x0": ("cyclic; neighbourPatch x1", "x-"), "x1": ("cyclic; neighbourPatch x0", "x+"),
        "y0": ("cyclic; neighbourPatch y1", "y-"), "y1": ("cyclic; neighbourPatch y0", "y+"), "walls": ("wall", "z- z+")})
    sides = '"[xy][01]" { type cyclic; }'
    case.flow("(0 0 0)", sides + "walls { type noSlip; }", sides + "walls { type fixedFluxPressure; }")
    case.gravity()
