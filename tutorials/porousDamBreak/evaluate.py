#!/usr/bin/env python3
"""evaluate.py -- levels of the water beside the measured ones, and volumes.

    evaluate.py                writes result.csv and levels.png

References
  level     Lin, PhD thesis, Cornell University 1998, case of crushed rock (also Liu, Lin, Chang and Sakakiyama,
            J. Waterw. Port Coastal Ocean Eng. 125 (1999) 322): measured/lin1998.csv, points of olaFlow's tutorial
            CR35_dambreak
The level is the height of all water in a column of cells. Levels are only reported: nothing is fitted to the rock.
Bounds:
  water     change of its volume, relative; 1e-9: identities, 10 digits of the log
  alpha     outside of [0, 1]; 1e-9
  exchange  1e-12, an identity

SPDX-License-Identifier: GPL-3.0-or-later
"""
import csv
import re
import sys
from pathlib import Path

import numpy

HERE = Path(__file__).resolve().parent
sys.path.append(str(HERE.parent/"shared"))
import results                      # noqa: E402
import side                         # noqa: E402

TANK, TOP, BLOCK = 0.89, 0.4375, (0.30, 0.59)   # m, length and height of the tank; the block along x
NAMES = {"block": "block", "cells": "cells twice as large", "kernel": "kernel of 3 diameters",
         "angular": "spheres of 12 mm"}     # runs
PLACES = [0.0, 0.45, 0.89]                      # m, where levels are compared one by one


def measured():
    """{time: positions and levels} [s, m, m]."""
    with open(HERE/"measured/lin1998.csv", newline="") as file:
        rows = numpy.array(list(csv.reader(file))[2:], float)
    return {time: rows[rows[:, 0] == time, 1:] for time in numpy.unique(rows[:, 0])}


def levels(run, time):
    """Positions of the columns of cells and heights of water in them [m], or None before the run is there."""
    paths = [path for path in side.times(run) if abs(float(path.name) - time) < 1e-6]
    if not paths:
        return None
    nx, nz = map(int, re.search(r"^cells\s+\((\d+) 1 (\d+)\)", (run/"system/blockMeshDict").read_text(),
                                re.M).groups())
    alpha = results.field(paths[0]/"alpha.water").reshape(nz, nx)
    return (numpy.arange(nx) + 0.5)*TANK/nx, alpha.sum(axis=0)*TOP/nz


def draw(runs):
    from style import GREY, MEASURED, OTHER, OURS, below, panels, save

    times = [time for time in measured() if any(levels(run, time) for run in runs.values())]
    figure, axes = panels(len(times), width=10, height=2.6, across=3, sharey=True)
    for axis, time in zip(axes, times):
        axis.axvspan(*(1e3*x for x in BLOCK), color=GREY, alpha=0.15, lw=0, label="block of rock")
        axis.plot(*(1e3*measured()[time]).T, label="measured, Lin 1998", **MEASURED)
        for (name, run), colour, style in zip(runs.items(), (OURS, OTHER, GREY, OURS), ("-", "--", "-.", ":")):
            line = levels(run, time)
            if line:
                axis.plot(*(1e3*values for values in line), style, color=colour,
                          label="Suna" if name == "block" else f"Suna, {name}")
        axis.set(title=f"{time:g} s", xlabel="x [mm]", xlim=(0, 1e3*TANK), ylim=(0, 380))
    for axis in axes[::3]:
        axis.set_ylabel("level [mm]")
    below(figure, axes[0], columns=5)
    save(figure, HERE/"levels.png")


def main():
    runs = {name: HERE/"runs"/folder for folder, name in NAMES.items() if (HERE/"runs"/folder).exists()}
    table = results.Table()
    for name, run in runs.items():
        squares = []
        for time, points in measured().items():
            line = levels(run, time)
            if not line:
                continue
            ours = numpy.interp(points[:, 0], *line)
            squares.append((ours - points[:, 1])**2)
            table.add(name, f"rms difference of the levels at {time:g} s", 0, numpy.mean(squares[-1])**0.5, unit="m",
                      source="Lin 1998")
            for x in PLACES:
                at = numpy.argmin(abs(points[:, 0] - x))
                table.add(name, f"level at {x:g} m, {time:g} s", points[at, 1], ours[at], unit="m", source="Lin 1998")
        table.add(name, "rms difference of all levels", 0, numpy.mean(numpy.concatenate(squares))**0.5, unit="m",
                  source="Lin 1998")
        results.balances(table, name, run)
    table.write(HERE)
    print("Levels: rms difference from the measured ones " + ", ".join(
        f"{1e3*float(row['ours']):.1f} mm ({row['part']})" for row in table.rows
        if row["quantity"] == "rms difference of all levels"))
    with results.pictures():
        draw(runs)


if __name__ == "__main__":
    main()
