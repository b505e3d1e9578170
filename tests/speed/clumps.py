#!/usr/bin/env python3
"""clumps.py -- clumps of three spheres at rest between walls, in Suna and in LAMMPS (fix rigid/small).

    clumps.py DEM [--runs 5] [--steps 1000]

Both start from Suna's settled bed of clumps.dem with the same step; they take turns on one core. Prints million
sphere-steps per second of processor time: the time of the process less the time of a short run. Suna continues with
the history of its contacts, LAMMPS begins without. Laws are those of settled20k (README.md). The spheres of a clump
overlap: in LAMMPS they get less density, so that the clump has its mass; its inertia differs.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import argparse
import csv
import glob
import os
import resource
import statistics
import subprocess
import sys

from peers import PEERS
from scenes import BEDS, HERE

FOLDER = os.path.join(BEDS, "clumps")
STEP, WIDTH, HEIGHT = 3e-6, 0.025, 0.05             # s, m: of clumps.dem
UNION = 0.6**3/(0.53446**3 + 2*0.45429**3)          # volume of the union over the sum of the spheres'
SKINS = (0.04e-3, 0.08e-3, 0.15e-3)                 # m


def spent(command):
    """Processor time [s] of a command in the folder of the bed."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    result = subprocess.run(command, cwd=FOLDER, capture_output=True, text=True)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    if result.returncode:
        sys.exit(f"clumps: {' '.join(command)} failed: {(result.stderr or result.stdout)[-400:]}")
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def scene(name):
    return os.path.join(HERE, name + ".dem")


def suna(dem, steps):
    """Time of so many steps after the settled state."""
    with open(os.path.join(FOLDER, "end"), encoding="ascii") as text:
        end = float(text.read())
    return spent([dem, "run", "-set", "time/end", repr(end + (steps + 0.001)*STEP), scene("restClumps")])


def spheres():
    """Rows of the last table of the spheres, by id."""
    path = sorted(glob.glob(os.path.join(FOLDER, "rest", "particles_*.csv")))[-1]
    with open(path, newline="", encoding="ascii") as text:
        rows = list(csv.DictReader(text))
    return sorted(rows, key=lambda row: int(row["id"]))


def settle(dem):
    """Settle once; keep the time of the settled state."""
    if os.path.exists(os.path.join(FOLDER, "end")):
        return
    os.makedirs(FOLDER, exist_ok=True)
    spent([dem, "run", scene("settleClumps")])
    # a run to an end in the past names the time of the snapshot
    said = subprocess.run([dem, "run", "-set", "time/end", "1e-9", scene("restClumps")], cwd=FOLDER,
                          capture_output=True, text=True).stderr
    with open(os.path.join(FOLDER, "end"), "w", encoding="ascii") as out:
        out.write(said.split("the time of the snapshot, ")[1].split(" s,")[0])


def write_deck(rows):
    """The data file of LAMMPS."""
    with open(os.path.join(FOLDER, "data.txt"), "w", encoding="ascii") as out:
        out.write(f"clumps\n\n{len(rows)} atoms\n1 atom types\n\n-0.001 {WIDTH + 0.001} xlo xhi\n"
                  f"-0.001 {WIDTH + 0.001} ylo yhi\n-0.001 {HEIGHT + 0.001} zlo zhi\n\nAtoms\n\n")
        out.writelines(f"{int(r['id']) + 1} 1 {r['diameter[m]']} {2500*UNION!r} {r['x[m]']} {r['y[m]']} {r['z[m]']}\n"
                       for r in rows)
        out.write("\nMolecules\n\n")
        out.writelines(f"{int(r['id']) + 1} {int(r['id'])//3 + 1}\n" for r in rows)


def lammps(skin, steps):
    """Time of so many steps, with lists."""
    law = PEERS["lammps"].law({})
    numbers = law[0].split("history ")[1]
    lines = ["units si", "atom_style sphere", "atom_modify map array", "boundary f f f", "newton off",
             "comm_modify vel yes", "fix bodies all property/atom mol ghost yes",
             "read_data data.txt fix bodies NULL Molecules", f"neighbor {skin} bin",
             "neigh_modify delay 0 exclude molecule/intra all", *law[:3]]
    lines += [f"fix {axis} all wall/gran hertz/history {numbers} {axis}plane 0 {top}"
              for axis, top in (("x", WIDTH), ("y", WIDTH), ("z", HEIGHT))]
    lines += ["fix go all rigid/small molecule", f"timestep {STEP}", "variable height equal xcm(all,z)",
              "thermo_style custom step v_height", f"thermo {max(steps, 1)}", f"run {steps}",
              'print "height ${height}"']
    with open(os.path.join(FOLDER, "in.txt"), "w", encoding="ascii") as out:
        out.write("\n".join(lines) + "\n")
    return spent(["lmp", "-in", "in.txt", "-log", "log.lammps"])


def height():
    """Mean height [m] of the spheres in LAMMPS at the end."""
    with open(os.path.join(FOLDER, "log.lammps"), encoding="ascii") as text:
        return float([line for line in text if line.startswith("height")][-1].split()[1])


def mean_height(rows):
    mass = [float(r["diameter[m]"])**3 for r in rows]
    return sum(m*float(r["z[m]"]) for m, r in zip(mass, rows))/sum(mass)


def main():
    p = argparse.ArgumentParser(description=__doc__.split("\n\n", maxsplit=1)[0])
    p.add_argument("dem")
    p.add_argument("--runs", type=int, default=5)
    p.add_argument("--steps", type=int, default=1000)
    a = p.parse_args()
    settle(a.dem)
    suna(a.dem, 1)
    rows = spheres()
    write_deck(rows)
    skin = min(SKINS, key=lambda s: lammps(s, a.steps//3))
    ours, theirs = [], []
    for _ in range(a.runs):
        work = 1e-6*len(rows)*a.steps
        ours.append(work/(suna(a.dem, a.steps) - suna(a.dem, 1)))
        theirs.append(work/(lammps(skin, a.steps) - lammps(skin, 0)))
    ratio = [u/v for u, v in zip(ours, theirs)]
    suna(a.dem, a.steps)
    lammps(skin, a.steps)
    print(f"clumps N={len(rows)} steps={a.steps} suna {statistics.median(ours):.2f} Mps/s lammps {statistics.median(theirs):.2f} Mps/s"
          f" (skin {1e3*skin:g} mm) ratio {statistics.median(ratio):.2f} (min {min(ratio):.2f} max {max(ratio):.2f})"
          f" mean height {1e3*mean_height(spheres()):.5g} {1e3*height():.5g} mm")


if __name__ == "__main__":
    main()
