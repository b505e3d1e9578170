"""A run continued from any written time has the bits of the uninterrupted run on the same decomposition.

- Compared: fluid, particles, carried-over impulses, bonds and springs, fields and means, tables.
- With cyclic patches, processor patches and a moving wall.
- From several start times, with fixed and adjusted steps, independent of the times of output.
- In demPimpleFoam on one rank and two, by function object in pimpleFoam and, with its running mean, in steady
  simpleFoam.
- A restart lists the entries of coupling that differ from those of its snapshot.
- On another number of ranks the particles are the same to the last bit, and the run to the solver's tolerance.

SPDX-License-Identifier: GPL-3.0-or-later
"""
from case import *

box = "postProcessing/dem/{}/box.csv"
means = """
functions
{
    means
    {
        type            fieldAverage;
        libs            ("libfieldFunctionObjects.so");
        writeControl    writeTime;
        fields          ( U.particles { mean on; prime2Mean on; base time; } U { mean on; prime2Mean off; base time; } );
    }
}
"""


def claim_same(what, straight, now, snapshot=True):
    """All files of a time folder have the same bytes, and so have the particles, in any order, and the snapshot."""
    names = {"U", *(path.name for path in (case/straight).iterdir() if path.is_file())}
    different = [name for name in names if not agrees(case/straight/name, case/now/name)]
    fields = "positions", "U", "omega", "contactForce", "d"
    if not np.array_equal(case.particles(straight, *fields), case.particles(now, *fields)):
        different.append("particles")
    if snapshot and not same_snapshot(straight, now):
        different.append("the snapshot's fingerprint")
    claim(what, not different, "different: " + ", ".join(different))


def same_snapshot(a, b):
    return snapshot_hash(case/a/"uniform/dem.snapshot") == snapshot_hash(case/b/"uniform/dem.snapshot")


def control(**entries):
    case.edit("system/controlDict", **entries)


def again(solver, start, ranks=1):
    """Run from this time."""
    control(startTime=start)
    case.run(solver, ranks=ranks)
    control(startTime=0)


def move(folder, to):
    """Move the times 0.0... of a folder."""
    (case/to).mkdir()
    for time in case.times(folder):
        (case/folder/time).rename(case/to/time)


def rows(start):
    """The rows of the table of forces on walls after 0.0065 s; the first mean of a run misses the impulse of half a
    DEM step."""
    return [row for row in case.read(f"postProcessing/dem/{start}/walls.csv").splitlines()[1:]
            if float(row.split(",")[0]) > 0.0065]


# ---- one rank --------------------------------------------------------------------------------------

for solver in ("pimpleFoam", "demPimpleFoam"):
    case = Case(solver)
    case.append("system/controlDict", function_object*(solver == "pimpleFoam") + means)
    claim_runs(f"{solver}: runs", case, solver)
    (case/"0.012").rename(case/"straight")
    again(solver, 0.004)
    claim_same(f"{solver}: continues from 0.004 with the bits of the uninterrupted run", "straight", "0.012")
    claim(f"{solver}: means in the box, to the last digit",
          case.read(box.format(0)) == case.read(box.format(0.004)))
    claim(f"{solver}: the table of forces on walls, from its second mean on",
          len(rows(0)) == 6 and rows(0) == rows(0.004))
case.run("foamToVTK", "-latestTime")
claim("foamToVTK reads the particles", any("NumberOfPoints='403'" in picture.read_text(errors="replace")
                                           for picture in case.path.glob("VTK/lagrangian/**/*.vtp")))

control(startTime=0.004)
listed = lambda: re.findall("restart: (.*)", case.run("demPimpleFoam", "-plan").log)
claim("a restart of the same case lists no difference", listed() == [])
case.sub("constant/demProperties", "rho 1000;", "rho 900; kernel linear;")
claim("a restart lists entries of coupling that have changed, and no others",
      lambda: listed() == ["coupling/kernel linear is new: it applies from now on",
                           "coupling/rho was 1000, now 900: it applies from now on"])
case.sub("constant/demProperties", "rho 900; kernel linear;", "rho 1000;")
control(startTime=0)

# ---- two ranks, and from two to one ----------------------------------------------------------------

case.run("decomposePar")
claim_runs("two ranks: runs", case, ranks=2)
for rank in range(2):
    (case/f"processor{rank}/0.012").rename(case/f"straight.{rank}")
again("demPimpleFoam", 0.004, ranks=2)
for rank in range(2):
    # the snapshot of all ranks is in the folder of rank 0
    claim_same(f"two ranks: rank {rank} continues from 0.004 with the bits of the uninterrupted run",
               f"straight.{rank}", f"processor{rank}/0.012", snapshot=rank == 0)
claim("two ranks: means in the box, to the last digit", case.read(box.format(0)) == case.read(box.format(0.004)))

# the particles with all their bits, the run to the tolerance of linear solvers (1e-11) and the order of sums
case.remove("0.0*")
case.run("reconstructPar", "-time", "0.004")
claim("from two ranks to one: the snapshot has the same fingerprint", same_snapshot("0.004", "processor0/0.004"))
again("demPimpleFoam", 0.004)
claim_ran("from two ranks to one: runs", case)
one = case.particles("0.012", "positions")
two = np.vstack([case.particles(f"processor{rank}/0.012", "positions") for rank in range(2)])
claim("from two ranks to one: the same positions (m)",
      len(one) == 403 and difference(one, two[two[:, 0].argsort()]) < 1e-9)

# ---- any time --------------------------------------------------------------------------------------

# before and after particles have crossed the cyclic patches
case = Case("every")
control(deltaT=8e-4, writeInterval=8e-4, endTime=0.016)
claim_runs("any time: runs", case)
move(".", "all")
for steps in (2, 3, 5, 7, 8, 9, 10, 11) if thorough else (2, 7, 11):
    start, end = f"{steps*8e-4:g}", f"{(steps + 8)*8e-4:g}"
    case.remove("0.0*")
    case.copy(case/"all"/start, start)
    control(startTime=start, endTime=end)
    case.run("demPimpleFoam")
    claim_same(f"any time: from step {steps}, 8 steps with the bits of the uninterrupted run", f"all/{end}", end)
# 0.2 m/s make 2 mm, the period is 16 mm
moved = case.particles("all/0.016", "positions") - case.particles("all/0.0064", "positions")
claim("any time: particles cross the cyclic patches", (abs(moved[:, 1]) > 0.008).sum() > 10)

# ---- adjustable steps ------------------------------------------------------------------------------


def steps():
    return [line for line in case.log().splitlines() if re.search("deltaT = |^Time = |step limited", line)]


# the limit of the step is saved: the steps are the same to the last digit, and so is the run
case = Case("adjust")
case.append("system/controlDict", means)
control(writeControl="adjustableRunTime", adjustTimeStep="yes", maxCo=0.3, maxDeltaT=1e-3, deltaT=2e-4)
claim_runs("adjustTimeStep: runs", case)
(case/"0.012").rename(case/"straight")
straight = steps()[steps().index("Time = 0.004") + 1:]
again("demPimpleFoam", 0.004)
claim("adjustTimeStep: continues from 0.004 with the steps of the uninterrupted run, to the last digit",
      steps() == straight)
claim("adjustTimeStep: the steps have several lengths", len({step for step in straight if "deltaT" in step}) > 3)
claim_same("adjustTimeStep: continues from 0.004 with the bits of the uninterrupted run", "straight", "0.012")

# ---- times of output -------------------------------------------------------------------------------

# where lists are rebuilt, and so particles wrapped, depends on the times of output; beyond the cyclic patches, which
# both ranks share, a particle has the cells and weights of one that is wrapped
case = Case("often")
control(deltaT=0.001, writeInterval=0.001, endTime=0.018)
case.run("decomposePar")
claim_runs("two ranks, output in each step: runs", case, ranks=2)
for rank in range(2):
    move(f"processor{rank}", f"often.{rank}")
control(writeInterval=0.018)
case.run("demPimpleFoam", ranks=2)
for rank in range(2):
    claim(f"two ranks, output at the end only: rank {rank} has the bits of the run with more of it",
          all(agrees(case/f"often.{rank}/0.018"/field, case/f"processor{rank}/0.018"/field)
              for field in ("U", "phi", "p")))
claim("two ranks, output at the end only: the particles, too", same_snapshot("often.0/0.018", "processor0/0.018"))

# ---- a steady solver -------------------------------------------------------------------------------

case = Case("simpleFoam", "solvers")
case.write("constant/particles", """
insert
{
    thrown { type random; count 50; seed 7; diameter 1e-3; velocity (0.1 0 0); min (0 0 0.01); max (0.02 0.02 0.03); }
    feed { type stream; rate 2000; diameter 1e-3; min (0.002 0.002 0.033); max (0.018 0.018 0.039); }
}
coupling { rho 10; interval 0.0005; }
""")
case.sub("system/fvSchemes", "Euler", "steadyState")
control(deltaT=1, endTime=30, writeInterval=10, startFrom="startTime")
claim_runs("simpleFoam: runs", case, "simpleFoam")
# 10 iterations of 0.5 ms a row: 10 particles, one more or less
table = case.table("postProcessing/dem/0/flows.csv")
feed = np.array(table["name"]) == "feed"
claim("simpleFoam: times of flows.csv are the particles' times, s", list(table["time"][feed]) == [0.005, 0.01, 0.015])
claim("simpleFoam: rates are in 1/s", close(table["rate"][feed][-1], 2000, 0.11))
(case/"30").rename(case/"straight")
again("simpleFoam", 10)
claim_same("simpleFoam: continues from iteration 10 with the bits of the uninterrupted run, the running mean included",
           "straight", "30")
claim("simpleFoam: the running mean is written", (case/"straight/particleForce").stat().st_size > 0)
finish()
