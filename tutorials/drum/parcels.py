#!/usr/bin/env python3
"""parcels.py -- the drum with single beads and with parcels: slope, speed, mixing, cost, side by side.

    parcels.py [-to SECONDS] FOLDER ...     runs of parcels.dem, each with FOLDER.log beside it; a table

Slope   of the centre of mass about the axis, which is that of a plane surface; mean from 1 s on, with
        95 % of blocks of 0.25 s
Speed   sqrt(mean square of velocity), likewise
Mixing  Lacey's index M = (s0^2 - s^2)/(s0^2 - sr^2) of the beads that lie in the upper half at 0.25 s,
        in cells of 12 mm: s^2 the variance of their fraction c, weighted by the beads of the cells,
        s0^2 = c (1 - c) unmixed, sr^2 = s0^2/n at random with n particles a cell; 0 unmixed, 1 random
Cost    of the log: particles, steps, processor time; none of a run that has not ended

Source: Lacey, J. Appl. Chem. 4 (1954) 257.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import argparse
import csv
import re
from pathlib import Path

import numpy
from scipy.stats import t as student

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


def lacey(x, z, upper):
    _, cell, n = numpy.unique(numpy.floor(numpy.column_stack((x, z))/CELL), axis=0, return_inverse=True,
                              return_counts=True)
    fraction = numpy.bincount(cell.ravel(), weights=upper)/n
    c = upper.mean()
    unmixed = c*(1 - c)
    spread = (n*(fraction - c)**2).sum()/n.sum()
    at_random = unmixed*len(n)/n.sum()
    return (unmixed - spread)/(unmixed - at_random)


def blocks(times, values):
    """Mean and half of the 95 % interval, from blocks."""
    steady = times >= STEADY
    number = ((times[steady] - STEADY + 1e-9)/BLOCK).astype(int)
    means = [values[steady][number == k].mean() for k in range(int(number.max()) + 1)
             if (number == k).sum() > 1]
    half = student.ppf(0.975, len(means) - 1)*numpy.std(means, ddof=1)/len(means)**0.5
    return numpy.mean(means), half


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
            mixed[round(time, 2)] = lacey(x, z, upper)
    log = Path(f"{folder}.log").read_text()
    ended = re.search(r"processor ([\d.]+) s, (\d+) steps", log)
    processor, steps = ended.groups() if ended else ("nan", 0)
    times = numpy.array(times)
    return (len(upper), int(steps), float(processor), *blocks(times, numpy.array(slope)),
            *blocks(times, numpy.array(speed)), *(mixed.get(t, numpy.nan) for t in (1.5, 3.0, 4.5)))


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
