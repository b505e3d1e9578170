"""A box of air at rest, open above, with a floor that moves.

SPDX-License-Identifier: GPL-3.0-or-later
"""


def make(case):
    # steps of 2^-10 s: times are sums without round-off
    case.controls(0.0390625, 0.0009765625, 0.01953125, precision=17)
    case.sub("system/fvSolution", r'"p\.\*"', '"(p|cellDisplacement).*"')
    case.sub("system/fvSolution", "1e-11", "1e-12")
    case.box((0.02, 0.02, 0.02), (5, 5, 5),
             {"floor": ("wall", "z-"), "sides": ("wall", "y- x+ y+ x-"), "top": ("patch", "z+")})
    case.flow("(0 0 0)", """floor { type movingWallVelocity; value uniform (0 0 0); }
    sides { type slip; } top { type pressureInletOutletVelocity; value uniform (0 0 0); }""",
              '"(floor|sides)" { type fixedFluxPressure; } top { type fixedValue; value uniform 0; }')
    case.dictionary("0/pointDisplacement", """dimensions [0 1 0 0 0 0 0];
internalField uniform (0 0 0);
boundaryField
{
    floor { type solidBodyMotionDisplacement; solidBodyMotionFunction linearMotion; velocity (0 0 0.05);
            value uniform (0 0 0); }
    sides { type slip; }
    top { type fixedValue; value uniform (0 0 0); }
}""", "pointVectorField")
