"""A duct of gas, 18 cells high.

SPDX-License-Identifier: GPL-3.0-or-later
"""


def make(case):
    case.controls(0.02, 0.001, nu=1.5e-5)
    case.duct((0.011, 0.011, 0.0396), (5, 5, 18), 0.3, 0.3)
