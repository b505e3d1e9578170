#!/usr/bin/env python3
"""peer.py -- the shear cell and the mixer in LIGGGHTS, from the same initial positions: ../stored/liggghts.csv.

Run by ../Allrun -peer, after the scenes. A deck NAME.in prints means every millisecond or hundredth of a second;
columns: step, then the variables of its fix ave/time.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import csv
import re
import subprocess
import sys
import time
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent.parent))
import numpy
from dem_case import blocks


def write_grains(table, path):
    with open(table, newline="") as file:
        rows = list(csv.DictReader(file))
    path.write_text("".join(f"create_atoms 1 single {row['x[m]']} {row['y[m]']} {row['z[m]']} units box\n"
                            f"set atom {k} diameter {row['diameter[m]']} density 2500\n"
                            for k, row in enumerate(rows, 1)))


def write_stl(path, corners):
    facets = zip(*[iter(corners)]*3)
    path.write_text("solid wall\n" + "".join(
        "facet normal 0 0 0\nouter loop\n" + "".join(f"vertex {corner}\n" for corner in facet) + "endloop\nendfacet\n"
        for facet in facets) + "endsolid wall\n")


def walls_of(scene):
    """Corners of the walls of triangles of a scene, as text."""
    return {name: re.findall(r"\(([^()]+)\)", corners) for name, corners in
            re.findall(r"(\w+)\s*\{ type triangles; corners \(((?:\s*\([^()]*\))*)\)", scene.read_text())}


def run(name, meshes):
    """The rows that a deck prints."""
    folder = HERE.parent/"runs"/f"liggghts-{name}"
    folder.mkdir(parents=True, exist_ok=True)
    write_grains(HERE.parent/"runs"/name/"particles_000000.csv", folder/"grains.in")
    for mesh, corners in meshes.items():
        write_stl(folder/f"{mesh}.stl", corners)
    subprocess.run(["liggghts", "-in", str(HERE/f"{name}.in"), "-log", "none"], cwd=folder, check=True,
                   stdout=open(folder/"log", "w"))
    return numpy.loadtxt(folder/"means").T


def plate(z):
    """The shear cell's floor or lid."""
    a, b, c, d = (f"{x} {y} {z}" for x, y in ((-0.003, 0), (0.03, 0), (0.03, 0.005), (-0.003, 0.005)))
    return [a, b, c, a, c, d]


def shear_cell():
    walls = walls_of(HERE.parent/"shearCell.dem")
    step, shear, normal, _ = run("shearCell", {
        "floor": plate(0), "lid": plate(0.0135), "lower": walls["lowerLeft"] + walls["lowerRight"],
        "upper": walls["upperLeft"] + walls["upperRight"]})
    steady = step*7e-6 > 0.083
    return blocks(-shear[steady]/normal[steady], 5)


def mixer():
    step, torque = run("mixer", {"blade": walls_of(HERE.parent/"mixer.dem")["blade"]})
    steady = step*5e-5 > 1.0
    return blocks(-1e3*torque[steady], 5)


def main():
    rows = [(name, *test()) for name, test in (("shearCell", shear_cell), ("mixer", mixer))]
    with open(HERE.parent/"stored"/"liggghts.csv", "w", newline="") as file:
        file.write(f"# LIGGGHTS 3.8.0, {time.strftime('%d %B %Y')}: ./Allrun -peer\n")
        out = csv.writer(file, lineterminator="\n")
        out.writerow(["scene", "mean", "ci95"])
        out.writerows((name, f"{mean:.5g}", f"{ci95:.2g}") for name, mean, ci95 in rows)


if __name__ == "__main__":
    main()
