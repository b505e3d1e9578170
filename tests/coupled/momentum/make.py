"""A periodic box of liquid at rest, with eight outer iterations in a step.

SPDX-License-Identifier: GPL-3.0-or-later
"""


def make(case):
    case.controls(0.04, 0.001)
    case.periodic((0.012, 0.012, 0.012), (6, 6, 6))
    case.sub("system/fvSolution", "nOuterCorrectors 1", "nOuterCorrectors 8")
