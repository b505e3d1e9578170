"""A run of demInterFoam that continues from a written time has the bits of the uninterrupted run on
the same ranks; two ranks agree with one to the tolerance of the linear solvers.

A bed of free grains with gravity collapses with the water in which it lies.
Surface tension acts on the grains at its surface.

SPDX-License-Identifier: GPL-3.0-or-later
"""
from two_fluids import *

walls = {"walls": ("wall", "x- x+ y- y+ z- z+")}
case = TwoFluids()
case.controls(0.012, 5e-4, write=0.004, precision=17)
case.fluids(sigma=0.07, tolerance=1e-13, correctors=2, sub_cycles=2)
case.box((0.06, 0.02, 0.04), (18, 6, 12), walls)
case.fields(walls)
case.alpha(lambda x: (x[:, 0] < 0.02)*(x[:, 2] < 0.03))
case.grains("grain { density 1500; youngsModulus 1e6; }",
            "hertz {} dry { restitution 0.5; } mindlin { friction 0.3; } "
            "gidaspow {} virtualMass {} capillaryForce { contactAngle 60; }",
            "grains { type random; diameter 2e-3; count 500; seed 3; min (0 0 0); max (0.02 0.02 0.025); }")


def different(straight, now, snapshot=True):
    """Files of two time folders that differ."""
    names = {"U", "alpha.water", *(path.name for path in (case/straight).iterdir() if path.is_file())}
    found = [name for name in names if not agrees(case/straight/name, case/now/name)]
    if not np.array_equal(case.particles(straight, "positions", "U", "omega"),
                          case.particles(now, "positions", "U", "omega")):
        found.append("particles")
    if snapshot and snapshot_hash(case/straight/"uniform/dem.snapshot") != snapshot_hash(case/now/"uniform/dem.snapshot"):
        found.append("snapshot")
    return found


def again(start, ranks=1):
    case.edit("system/controlDict", startTime=start)
    case.run("demInterFoam", ranks=ranks)
    case.edit("system/controlDict", startTime=0)


claim_runs("runs", case, "demInterFoam")
claim("the fluid moves", largest(case.field("0.012/U")) > 0.05, largest(case.field("0.012/U")))
claim_runs("-postProcess -func wallShearStress: runs, with a time 0 that has no p", case,
           "demInterFoam", "-postProcess", "-func", "wallShearStress")
claim("-postProcess -func wallShearStress: has the model",
      lambda: largest(case.boundary("0.012/wallShearStress", "walls")) > 0)
case.remove("*/wallShearStress")
(case/"0.012").rename(case/"straight")
again(0.004)
found = different("straight", "0.012")
claim("continues from 0.004 with the bits of the uninterrupted run", not found, *found)

case.sub("system/decomposeParDict", "2 1 1", "1 2 1")
case.run("decomposePar")
claim_runs("two ranks: runs", case, "demInterFoam", ranks=2)
for rank in range(2):
    (case/f"processor{rank}/0.012").rename(case/f"straight.{rank}")
again(0.004, ranks=2)
for rank in range(2):
    found = different(f"straight.{rank}", f"processor{rank}/0.012", snapshot=rank == 0)
    claim(f"two ranks: rank {rank} continues with the bits of the uninterrupted run", not found, *found)
(case/"0.012").rename(case/"one")
case.run("reconstructPar", "-latestTime")
for name, limit in (("U", 1e-8), ("alpha.water", 1e-9), ("voidFraction", 1e-9)):
    gap = difference(case.field(f"one/{name}"), case.field(f"0.012/{name}"))
    claim(f"two ranks give the same {name} ({limit})", gap < limit, gap)
gap = difference(case.particles("one", "positions"), case.particles("0.012", "positions"))
claim("two ranks give the same positions (1e-10 m)", gap < 1e-10, gap)
finish()
