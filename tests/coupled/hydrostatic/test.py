"""Particles as dense as the fluid, at random positions in a vessel at rest, stay at rest: weight, buoyancy and the
fluid's own weight cancel to round-off.

SPDX-License-Identifier: GPL-3.0-or-later
"""
from case import *

case = Case()
case.run("blockMesh")
case.run("demPimpleFoam")
claim_ran("runs", case)
# 1e-8 m/s: the bound of the reference case; round-off of g T is below 1e-17
claim("no particle moves", largest(case.field("0.05/lagrangian/particles/U")) < 1e-8)
claim("no fluid moves", largest(case.field("0.05/U")) < 1e-8)
claim("volume of the particles is kept", worst(case.log(), "volume error") < 1e-12)
finish()
