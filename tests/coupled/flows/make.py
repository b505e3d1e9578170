"""A duct along x, which liquid flows through.

SPDX-License-Identifier: GPL-3.0-or-later
"""


def make(case):
    case.controls(0.2, 0.001, 0.1, precision=17)
    case.box((0.04, 0.02, 0.02), (10, 5, 5),
             {"inlet": ("patch", "x-"), "outlet": ("patch", "x+"), "walls": ("wall", "y- y+ z- z+")})
    case.flow("(0.4 0 0)", """inlet { type fixedValue; value uniform (0.4 0 0); }
    outlet { type inletOutlet; inletValue uniform (0 0 0); value uniform (0.4 0 0); }
    walls { type slip; }""", '"(inlet|walls)" { type fixedFluxPressure; } outlet { type fixedValue; value uniform 0; }')
    case.gravity()
