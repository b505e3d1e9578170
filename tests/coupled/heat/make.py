"""A periodic box of hot gas at rest.

SPDX-License-Identifier: GPL-3.0-or-later
"""


def make(case):
    case.controls(0.04, 0.0005, 0.02, precision=17)
    case.sub("system/fvSolution", '("p.*)1e-11; relTol 0;', r"\g<1>1e-14; relTol 0; maxIter 100;")
    case.sub("system/fvSolution", r'"U\.\*"(.*)1e-11; relTol 0;', r'"(U|T).*"\g<1>1e-16; relTol 0; maxIter 50;')
    case.periodic((0.008, 0.008, 0.008), (2, 2, 2))
    case.initial("T", "0 0 0 1 0 0 0", 500)
    case.edit("constant/transportProperties", nu=1.5e-5, Cp=1000, kappa=0.025)
