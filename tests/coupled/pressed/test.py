"""A lid that the scene's stages let go presses a bed in a gas, which does not feel the lid.

- Without friction the floor carries the weight of the grains, less the buoyancy, and the lid, which still sinks through
  its damper.
- The stage begins at the end of a fluid step; the log has it, and that the gas does not feel the lid.
- A run continued from the midst of the impact has the bits of the whole one, on one rank and on two.
- A patch of the mesh cannot be moved by force.

SPDX-License-Identifier: GPL-3.0-or-later
"""
from case import *

MASS, DAMPING, g = 2e-3, 0.2, 9.81


def same(straight, now):
    """The names of files of a time folder that differ, and of the particles and the snapshot."""
    names = [path.name for path in (case/straight).iterdir() if path.is_file()]
    different = [name for name in names if not agrees(case/straight/name, case/now/name)]
    snapshots = [snapshot_hash(case/folder/"uniform/dem.snapshot") for folder in (straight, now)]
    return different + ["snapshot"]*(snapshots[0] != snapshots[1])


def continued(what, folder, ranks):
    """Run from 0.03 again; compare with the first run."""
    (case/f"{folder}0.08").rename(case/f"{folder}straight")
    case.edit("system/controlDict", startTime=0.03)
    case.run("demPimpleFoam", ranks=ranks)
    case.edit("system/controlDict", startTime=0)
    claim_ran(f"{what}: continues", case)
    different = same(f"{folder}straight", f"{folder}0.08")
    claim(f"{what}: with the same bits", not different, "different: " + ", ".join(different))


def balance(what, folder):
    """The last mean of the forces on floor and lid, whose mass, damper and weight take the rest."""
    walls = case.table("postProcessing/dem/0/walls.csv")
    floor, lid = ([n for n, wall in enumerate(walls["wall"]) if wall == name][-2:] for name in ("walls", "lid"))
    time, moved, speed = (np.diff(np.array(walls[name], dtype=float)[lid])[0] for name in ("time", "moved", "speed"))
    force = MASS*(g + speed/time) + DAMPING*moved/time
    n = len(case.field(f"{folder}0.08/lagrangian/particles/d"))
    if folder:
        n += len(case.field("processor1/0.08/lagrangian/particles/d"))
    grains = n*math.pi/6*1e-9*(2500 - 1.2)*g
    claim(f"{what}: the bed carries the lid", close(walls["fz"][lid[-1]], force, 0.001),
          f"{walls['fz'][lid[-1]]} N, {force} N")
    claim(f"{what}: the floor carries lid and grains", close(-walls["fz"][floor[-1]] - force, grains, 0.005),
          f"{-walls['fz'][floor[-1]]} N, {force + grains} N")


case = Case("pressed", "hydrostatic")
case.edit("system/controlDict", endTime=0.08, writeInterval=0.01, writePrecision=17)
case.edit("system/decomposeParDict", numberOfSubdomains=2)
case.properties("glass { density 2500; youngsModulus 1e6; }",
                "gravity { acceleration (0 0 -9.81); } hertz {} dry { restitution 0.2; } gidaspow {} pressureGradient {}",
                """grains { type lattice; material glass; diameter 1e-3; count 600; min (0 0 0);
    max (0.02 0.02 0.0028); }""",
                "rho 1.2; record { interval 0.005; } kernel diffusion; width 3;", """stages { fill { duration 0.0205; } press {} }
walls
{
    lid { type triangles; corners ((-0.001 -0.001 0.0032) (0.021 -0.001 0.0032) (0.021 0.021 0.0032)
                                   (-0.001 -0.001 0.0032) (0.021 0.021 0.0032) (-0.001 0.021 0.0032));
          motion { type free; axes (z); mass 2e-3; weight yes; damping 0.2; start press; } }
}""")
case.remove("constant/g")
claim_runs("runs", case)
log = case.log()
claim("the log has the stage, which begins with a fluid step", re.search(r"Suna: stage press begins at 0\.0210*\d* s: its time is over", log),
      *re.findall("Suna: stage.*", log))
claim("and that the gas does not feel the lid", log.count("wall lid is moved by force; the fluid does not feel it") == 1)
balance("one rank", "")
continued("one rank", "", 1)

case.remove("postProcessing")
case.run("decomposePar")
claim_runs("runs on two ranks", case, ranks=2)
balance("two ranks", "processor0/")
continued("two ranks", "processor0/", 2)

case.sub("constant/demProperties", "weight yes; ", "")
claim_refused("without buoyancy, a weight is refused that the scene does not name", case, "weight no", "demPimpleFoam")
case.sub("constant/demProperties", "walls\n{", "walls\n{\n    walls { material glass; motion { type free; mass 1; } }")
claim_refused("a patch moved by force is refused", case, "motion", "demPimpleFoam")
finish()
