"""frames.py -- read the results of a run: the record of the beads, pressures, forces on walls.

particles.bin holds a block for each instant: time [s] (double), number n (int64), then n times id,
position [m], velocity [m/s], diameter [m]; surfaceFieldValue.dat is columns of text, walls.csv a
table. Each lies in a folder named after the time at which the run started or continued; a later
start replaces what an earlier one wrote for the same times.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import csv
import re
from pathlib import Path

import numpy

BEAD = numpy.dtype([("id", "i4"), ("position", "f4", 3), ("velocity", "f4", 3), ("diameter", "f4")])
HEAD = numpy.dtype([("time", "f8"), ("count", "i8")])


def starts(case, name, file):
    """The file of each start with the time up to which it counts."""
    paths = sorted(Path(case).glob(f"postProcessing/{name}/*/{file}"),
                   key=lambda path: float(path.parent.name))
    ends = [float(path.parent.name)*(1 + 1e-9) for path in paths[1:]] + [numpy.inf]
    return list(zip(paths, ends))


def list_frames(case):
    """Time [s], file and place in it of each instant, in order of time."""
    listed = []
    for path, end in starts(case, "dem", "particles.bin"):
        size, at = path.stat().st_size, 0
        with open(path, "rb") as file:
            while at + HEAD.itemsize <= size:
                file.seek(at)
                head = numpy.fromfile(file, HEAD, 1)[0]
                after = at + HEAD.itemsize + int(head["count"])*BEAD.itemsize
                # truncated, or repeated by a later start
                if after > size or head["time"] > end:
                    break
                listed.append((float(head["time"]), path, at))
                at = after
    return listed


# Spheres of a seed overlap: diameters times this have its volume, (0.6^3/(0.53446^3 + 2*0.45429^3))^(1/3)
SEED = 0.8595


def spheres_each(case):
    """3 for seeds, 1 for spheres."""
    options = Path(case)/"system"/"options"
    return 3 if options.exists() and "seeds yes" in options.read_text() else 1


def read_frame(path, at, by_volume=False):
    """Positions [m], velocities [m/s] and diameters [m] of all beads, or of the spheres of seeds; by_volume: diameters
    that add up to the volume of the seeds."""
    with open(path, "rb") as file:
        file.seek(at)
        count = numpy.fromfile(file, HEAD, 1)[0]["count"]
        beads = numpy.fromfile(file, BEAD, count)
    if by_volume and spheres_each(Path(path).parents[3]) > 1:
        beads["diameter"] *= SEED
    return tuple(beads[name].astype(float) for name in ("position", "velocity", "diameter"))


def read_columns(case, name, file):
    """Columns of text over time, the first of them."""
    rows = [row for path, end in starts(case, name, file) for row in numpy.loadtxt(path, ndmin=2)
            if row[0] <= end]
    return numpy.array(rows).T


def read_table(case, name, file):
    """Rows of a table with a header, by its names."""
    rows = []
    for path, end in starts(case, name, file):
        with open(path, newline="") as text:
            # the effects that act
            lines = (line for line in text if not line.startswith("#"))
            rows += [row for row in csv.DictReader(lines) if float(row["time[s]"]) <= end]
    return rows


def entry(path, keyword):
    """A number of an OpenFOAM dictionary, by its keyword."""
    found = re.search(rf"^\s*{keyword}\s+([-+0-9.eE]+);", Path(path).read_text(), re.MULTILINE)
    if not found:
        raise ValueError(f"{path}: no number {keyword}")
    return float(found.group(1))


def plate_speed(case, time):
    """The plate's superficial velocity at these times [m/s], from its table in 0/U."""
    path = Path(case)/"0/U"
    points = re.findall(r"\(([\d.]+) \(0 0 ([\d.]+|\$speed)\)\)", re.search(r"table (.*);", path.read_text())[1])
    return numpy.interp(time, [float(t) for t, _ in points],
                        [entry(path, "speed") if u == "$speed" else float(u) for _, u in points])
