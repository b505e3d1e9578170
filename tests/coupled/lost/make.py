"""A tank of gas.

SPDX-License-Identifier: GPL-3.0-or-later
"""


def make(case):
    case.controls(0.03, 0.001, 0.01, nu=1.5e-5)
    case.tank((0.02, 0.02, 0.04), (6, 5, 10))
