"""Liquid between two plates, periodic along x and y.

SPDX-License-Identifier: GPL-3.0-or-later
"""


def make(case):
    case.controls(0.2, 0.002, 0.1, precision=17)
    case.box((0.012, 0.012, 0.024), (6, 6, 12), {"walls": ("wall", "z- z+")}, cyclic="xy")
    case.flow("(0 0 0)", "walls { type noSlip; }", "walls { type fixedFluxPressure; }")
    case.gravity()
