#!/usr/bin/env python3
"""evaluate.py -- volumes, exchange and the fronts of water and grains.

    evaluate.py [-animate]     writes result.csv, fronts.csv and dam.png; with -animate dam.webp; with the runs dry and
                               clear fronts.png

Bounds and their reasons:
  water     change of its volume, relative; 1e-9: identities, 10 digits of the log
  alpha     outside of [0, 1]; 1e-9
  exchange  1e-12, an identity
The fronts, the foremost grain and the foremost water at the floor, are only reported: no measured
numbers of this case are published as a table. A front of a dry dam of height h cannot be faster than
2 sqrt(g h) (Ritter 1892); that is a bound.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import csv
import math
import re
import sys
from pathlib import Path

import numpy

HERE = Path(__file__).resolve().parent
sys.path.append(str(HERE.parent/"shared"))
import results                      # noqa: E402
import side                         # noqa: E402

RUN = HERE/"runs/dam"
BESIDE = [path for path in (HERE/"runs/dry", HERE/"runs/clear") if path.exists()]
WIDTH, HEIGHT, TANK = 0.05, 0.1, 0.2             # m, of the column; length of the tank


def cells():
    """Number of cells along x, y and z."""
    return [int(n) for n in re.search(r"^cells\s+\((\d+) (\d+) (\d+)\)",
                                      (RUN/"system/blockMeshDict").read_text(), re.M).groups()]


def diameter():
    """Of the grains [m]."""
    return float(re.search(r"diameter (\S+);", (RUN/"constant/demProperties").read_text())[1])


def water(path):
    """Fraction of water of each cell: z, y, x."""
    values = results.field(path/"alpha.water").ravel()       # one value if it is uniform
    return values.reshape(cells()[::-1]) if values.size > 1 else numpy.full(cells()[::-1], values[0])


def fronts(run):
    """Time, foremost grain and foremost water on the floor [s, m, m]; not a number where the run has none."""
    rows = []
    for path in side.times(run):
        grains = side.grains(path)
        floor = water(path)[0].mean(axis=0)
        wet = numpy.nonzero(floor > 0.5)[0]
        rows.append((float(path.name), grains[:, 0].max() if len(grains) else numpy.nan,
                     (wet.max() + 1)*TANK/cells()[0] if len(wet) else numpy.nan))
    return numpy.array(rows)


def write(places):
    """fronts.csv: of each run those of its fronts that it has."""
    columns = {"time[s]": places[RUN][:, 0]}
    for run, rows in places.items():
        for k, name in ((1, "grains"), (2, "water")):
            if not numpy.isnan(rows[:, k]).any():
                columns[name + (f" {run.name}" if run != RUN else "") + "[m]"] = rows[:, k]
    with open(HERE/"fronts.csv", "w", newline="") as file:
        out = csv.writer(file)
        out.writerow(columns)
        out.writerows([f"{x:.5g}" for x in row] for row in zip(*columns.values()))


def draw_fronts(places):
    from style import OTHER, OURS, below, panels, save

    figure, (axis,) = panels(1)
    for run, k, colour, dashes, label in ((RUN, 2, OTHER, "-", "water, with grains"),
                                          (HERE/"runs/clear", 2, OTHER, "--", "water alone"),
                                          (RUN, 1, OURS, "-", "grains, in water"),
                                          (HERE/"runs/dry", 1, OURS, "--", "grains alone")):
        if run in places:
            axis.plot(*places[run][:, [0, k]].T, dashes, color=colour, label=label)
    axis.set(xlabel="time [s]", ylabel="foremost on the floor [m]", ylim=(WIDTH, 1.03*TANK))
    below(figure, columns=2)
    save(figure, HERE/"fronts.png")


def limits(axis):
    axis.set(xlim=(0, 1e3*TANK), ylim=(0, 200))


def draw():
    """From the side, at six times."""
    shown = [path for path in side.times(RUN) if round(float(path.name)/0.01) in (5, 10, 20, 30, 40, 50)]
    side.series(HERE/"dam.png", RUN, shown, diameter(), 2.9, limits, width=2.1*len(shown))


def main():
    table = results.Table()
    results.balances(table, "balances", RUN)
    places = {run: fronts(run) for run in (RUN, *BESIDE)}
    write(places)
    moving = places[RUN][places[RUN][:, 2] < 0.9*TANK]
    if len(moving):
        time, grains, water = moving[-1]
        limit = 2*math.sqrt(9.81*HEIGHT)
        # between 0 and 1
        table.add("fronts", "mean speed of the water over Ritter's limit", 0.5, (water - WIDTH)/time/limit,
                  allowed=1, source="Ritter 1892")
        table.add("fronts", "grains behind the water", 0, water - grains, unit="m")
    table.write(HERE)
    with results.pictures():
        draw()
        if BESIDE:
            draw_fronts(places)
        if "-animate" in sys.argv:
            side.animate(HERE/"dam.webp", RUN, diameter(), 0.08, limits)


if __name__ == "__main__":
    main()
