"""A bed at the onset of bubbling: two ranks agree with one, a restart agrees with the uninterrupted run, and
OpenFOAM's tools read the particles.

SPDX-License-Identifier: GPL-3.0-or-later
"""
from case import *


def positions():
    return case.particles("0.02", "positions")


case = Case()
case.run("blockMesh")
case.run("decomposePar")
case.run("demPimpleFoam")
claim_ran("runs alone", case)
alone, U, e = positions(), case.field("0.02/U"), case.field("0.02/voidFraction")
claim("all particles are written", len(alone) == 2400)
claim("the particles move", largest(case.field("0.02/lagrangian/particles/U")) > 0.05)
claim("exchange closes", worst(case.log(), "exchange error") < 1e-12)
claim("volume of the particles is kept", worst(case.log(), "volume error") < 1e-12)
case.run("foamToVTK", "-latestTime")
pictures = [path.read_text(errors="replace") for path in case.path.glob("VTK/lagrangian/**/*.vtp")]
claim("foamToVTK reads the particles", any("NumberOfPoints='2400'" in picture for picture in pictures))

# ---- a restart from half time ----------------------------------------------------------------------

case.remove("0.02")
case.edit("system/controlDict", startFrom="latestTime")
case.run("demPimpleFoam")
claim("restart loads the snapshot", case.found("particles from"))
# fields pass through 16 decimal digits and linear solvers of 1e-11
claim("restart agrees with the uninterrupted run", difference(alone, positions()) < 1e-9)

# ---- two ranks -------------------------------------------------------------------------------------

case.edit("system/controlDict", startFrom="startTime")
case.run("demPimpleFoam", ranks=2)
claim_ran("runs on two ranks", case)
case.remove("0.02")
case.run("reconstructPar", "-latestTime")
# the pressure solver sums in another order: 1e-11 of its residual, which collisions amplify
claim("two ranks give the same positions (m)", difference(alone, positions()) < 1e-8)
claim("two ranks give the same velocity (m/s)", difference(U, case.field("0.02/U")) < 1e-5)
claim("two ranks give the same void fraction", difference(e, case.field("0.02/voidFraction")) < 1e-6)
claim("exchange closes on two ranks", worst(case.log(), "exchange error") < 1e-12)

case.remove("processor*/0.02")
case.edit("system/controlDict", startFrom="latestTime")
case.run("demPimpleFoam", ranks=2)
claim("restart on two ranks loads the snapshot", case.found("particles from"))
claim_ran("restart on two ranks runs", case)
finish()
