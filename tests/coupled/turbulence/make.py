"""A duct of gas, 20 cells high.

SPDX-License-Identifier: GPL-3.0-or-later
"""


def make(case):
    case.controls(0.2, 0.002, nu=1.5e-5, precision=17)
    case.sub("system/fvSolution", r'"U\.\*"', '"(U|k|epsilon|omega|R|sigma|nuTilda).*"')
    case.append("system/fvSchemes", "wallDist { method meshWave; }\n")
    case.duct((0.0044, 0.0044, 0.044), (2, 2, 20), 0.3, 0.3)
