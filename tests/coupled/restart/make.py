"""A box of liquid between two plates, periodic along x and y.

SPDX-License-Identifier: GPL-3.0-or-later
"""


def make(case):
    case.controls(0.012, 0.001, 0.004, precision=17)
    case.box((0.016, 0.012, 0.016), (4, 3, 4), {
        "left": ("cyclic; neighbourPatch right", "x-"), "right": ("cyclic; neighbourPatch left", "x+"),
        "front": ("cyclic; neighbourPatch back", "y-"), "back": ("cyclic; neighbourPatch front", "y+"),
        "walls": ("wall", "z- z+")})
    sides = '"(left|right|front|back)" { type cyclic; }'
    case.flow("(0.05 0 0)", sides + "walls { type noSlip; }", sides + "walls { type zeroGradient; }")
