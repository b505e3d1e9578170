"""The small box of the tests of several solvers.

SPDX-License-Identifier: GPL-3.0-or-later
"""
from case import *


def prepare(solver, particles, name=None):
    """The box, as this solver wants it; `particles` are the entries of the scene besides materials and effects."""
    case = Case(name or solver, "solvers")
    case.write("constant/particles", particles)
    if solver == "simpleFoam":
        case.sub("system/fvSchemes", "Euler", "steadyState")
        case.edit("system/controlDict", deltaT=1, endTime=200, writeInterval=50)
    else:
        case.sub("system/fvSolution", "^relaxationFactors.*\n", "")
    if solver == "buoyantPimpleFoam":
        case.sub("0/p", r"\[0 2 -2", "[1 -1 -2")
        for field in ("0/p", "0/p_rgh"):
            case.sub(field, "^internalField .*", "internalField uniform 1e5;")
        case.sub("system/fvSolution", "pRefValue [^;]*", "pRefValue 1e5")
    if solver == "interFoam":
        case.run("setFields")
    return case


def apart(a, b):
    """The largest difference over the largest magnitude."""
    return difference(a, b)/largest(a)


def spheres_apart(case, a, b):
    """The same of the velocities of ten spheres or more at two times."""
    a, b = (case.particles(time, "U")[:, 1:] for time in (a, b))
    if len(a) < 10:
        raise ValueError(f"{len(a)} spheres are too few")
    return apart(a, b)


def fallen(case, time, sphere=0):
    """The downward speed of this sphere."""
    return -case.particles(time, "U")[sphere, 3]
