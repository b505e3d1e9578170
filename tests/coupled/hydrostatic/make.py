"""A box of 20 mm with walls and an open top, of liquid at rest.

SPDX-License-Identifier: GPL-3.0-or-later
"""


def make(case):
    case.controls(0.05, 0.001)
    case.tank((0.02, 0.02, 0.02), (5, 5, 5))
