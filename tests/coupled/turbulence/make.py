"""A duct of gas, 20 cells high.

SPDX-License-Identifier: GPL-3.0-or-later
"""


def make(case):
    case.controls(0.2, 0.002, nu=1.5e-5, precision=17)
    case.duct((0.0044, 0.0044, 0.044), (2, 2, 20), 0.3, 0.3)
