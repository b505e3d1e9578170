#!/usr/bin/env python3
"""parcels.py -- the drum with single beads and with parcels: slope, speed, mixing, cost.

    parcels.py [-to SECONDS] FOLDER ...     runs of parcels.dem, each with FOLDER.log beside it; a table

Slope   of the center of mass about the axis, as of a plane surface; mean from 1 s on, with 95 % of
        blocks of 0.25 s
Speed   sqrt(mean square of velocity), likewise
Mixing  Lacey's index of the beads in the upper half at 0.25 s, in cells of 12 mm (mixing.py)
Cost    from the log: particles, steps, processor time; none if the run has not ended

SPDX-License-Identifier: GPL-3.0-or-later
"""
import argparse
import csv
import re
import sys
from pathlib import Path

import numpy

sys.path.append(str(Path(__file__).resolve().parent.parent/"muellerBed"))
from mixing import blocks, lacey, processor_time        # noqa: E402

REST, STEADY, BLOCK, CELL = 0.25, 1.0, 0.25, 0.012


def read(path):
    """time, and id, x, z, speed of each particle, sorted by id."""
    with open(path) as file:
        rows = list(csv.reader(file))
    at = {name.split("[")[0]: k for k, name in enumerate(rows[0])}
    table = numpy.array([[float(row[at[name]]) for name in ("time", "id", "x", "z", "vx", "vy", "vz")]
                         for row in rows[1:]])
    table = table[table[:, 1].argsort()]
    return table[0, 0], table[:, 2], table[:, 3], numpy.sqrt((table[:, 4:]**2).sum(axis=1))


def row(folder, end):
    times, slope, speed, mixed, upper = [], [], [], {}, None
    for path in sorted(Path(folder).glob("particles_*.csv")):
        time, x, z, v = read(path)
        if time > end + 1e-9:
            break
        if upper is None and time >= REST - 1e-9:
            upper = (z > numpy.median(z)).astype(float)
        times.append(time)
        slope.append(numpy.degrees(numpy.arctan2(abs(x.mean()), -z.mean())))
        speed.append((v**2).mean()**0.5)
        if upper is not None:
            mixed[round(time, 2)] = lacey(numpy.column_stack((x, z)), upper, CELL)
    log = Path(f"{folder}.log").read_text()
    steps = re.search(r"^profile: .* (\d+) steps$", log, re.MULTILINE)
    times = numpy.array(times)
    return (len(upper), steps[1] if steps else "not ended", processor_time(log),
            *blocks(times, numpy.array(slope), STEADY, BLOCK),
            *blocks(times, numpy.array(speed), STEADY, BLOCK), *(mixed.get(t, numpy.nan) for t in (1.5, 3.0, 4.5)))


def main():
    options = argparse.ArgumentParser()
    options.add_argument("-to", type=float, default=numpy.inf)
    options.add_argument("folder", nargs="+")
    given = options.parse_args()
    print("| run | particles | steps | processor [s] | slope [deg] | speed [mm/s] | M at 1.5 s | 3 s | 4.5 s |")
    print("|---|---|---|---|---|---|---|---|---|")
    for folder in given.folder:
        n, steps, processor, a, da, v, dv, *m = row(folder, given.to)
        print(f"| {Path(folder).name} | {n} | {steps} | {processor:.0f} | {a:.1f} ± {da:.1f} "
              f"| {1e3*v:.1f} ± {1e3*dv:.1f} | {m[0]:.2f} | {m[1]:.2f} | {m[2]:.2f} |")


if __name__ == "__main__":
    main()
