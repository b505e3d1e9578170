#!/usr/bin/env python3
"""evaluate.py -- fronts and pore pressures of two columns that collapse in a liquid.

    evaluate.py                writes result.csv, fronts.png and collapse.png

Reference: Rondon, Pouliquen and Aussillous, Phys. Fluids 23 (2011) 073301: loose, 60 x 48 mm, packed to 0.55, and
dense, 60 x 42 mm, 0.60; points as digitised in the tutorials of sedFoam, whose units, cm and Pa, are inferred.
front           foremost place where the grains are higher than one parcel
pressure        at the bottom, 20 mm from the wall, beyond the hydrostatic one
Bounds:
  sign          of the pore pressure at all times: loose grains, which compact, press the liquid out (+), dense ones,
                which dilate, suck it in (-)
  exchange      1e-12, an identity
Fronts and sizes of pressures are only reported: a parcel stands for 64 beads, so a sheared layer, some ten diameters
thick, is four times as thick as in the experiment.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import math
import re
import sys
from pathlib import Path

import numpy

HERE = Path(__file__).resolve().parent
sys.path.append(str(HERE.parent/"shared"))
import results                      # noqa: E402

RHO, DEPTH = 1010, 0.0045           # kg/m3, m
LENGTH, MIDDLE = 0.28, (0.008, 0.045)      # m, of the tank; the part of the column away from wall and gate
FRONTS = {"loose": [(0.085, 0.0692), (0.64, 0.1627), (1.31, 0.1972)], "dense": []}     # s, m
PRESSURES = {"loose": [(2, 144)], "dense": [(1.1, -126)]}  # s, Pa; the loose run ends before, only the sign counts


def diameter(run):
    ratio = int(re.search(r"ratio (\d+);", (run/"constant/demProperties").read_text())[1])
    return 2.25e-4*ratio


def packing(run):
    """Solid fraction of the first instant in the middle of the column, and its height [m]."""
    _, places, _ = results.record(run)
    d, at = diameter(run), places[0]
    top = numpy.quantile(at[:, 2], 0.98) + d/2
    inside = (at[:, 2] > 0.25*top) & (at[:, 2] < 0.75*top) & (at[:, 0] > MIDDLE[0]) & (at[:, 0] < MIDDLE[1])
    return inside.sum()*math.pi/6*d**3/(0.5*top*(MIDDLE[1] - MIDDLE[0])*DEPTH), top


def fronts(run):
    """Times and fronts [s, m]."""
    times, places, _ = results.record(run)
    d, found = diameter(run), []
    edges = numpy.arange(0, LENGTH + 2*d, 2*d)
    for at in places:
        count, _ = numpy.histogram(at[:, 0], edges)
        # as if packed to 0.55, in both columns
        height = count*math.pi/6*d**3/0.55/(2*d*DEPTH)
        found.append(edges[numpy.nonzero(height > d)[0].max() + 1])
    return times, numpy.array(found)


def pressures(run):
    """Times and pressures [s, Pa]."""
    rows = numpy.loadtxt(run/"postProcessing/pressure/0/p", comments="#", ndmin=2)
    return rows[:, 0], RHO*rows[:, 1]


def draw(runs):
    from style import OTHER, OURS, REFERENCE, below, panels, save

    figure, axes = panels(2)
    for (name, run), colour in zip(runs.items(), (OURS, OTHER)):
        for axis, (time, values), points in zip(axes, (fronts(run), pressures(run)), (FRONTS, PRESSURES)):
            scale = 1e3 if axis is axes[0] else 1
            axis.plot(time, scale*values, color=colour, label=f"Suna, {name}")
            for at, value in points[name]:
                axis.plot(at, scale*value, "o" if name == "loose" else "s", color=REFERENCE, mfc="none", ls="",
                          label=f"measured, {name}, Rondon et al. 2011")
    axes[0].set(xlabel="time [s]", ylabel="front [mm]")
    axes[1].set(xlabel="time [s]", ylabel="pore pressure [Pa]")
    below(figure)
    save(figure, HERE/"fronts.png")


def draw_side(runs):
    """Both columns at the start and at two later times; x and z in mm."""
    from style import OURS, panels, save

    figure, axes = panels(3*len(runs), width=10, height=1.9, across=3, sharex=True, sharey=True)
    for row, (name, run) in enumerate(runs.items()):
        times, places, _ = results.record(run)
        for axis, k in zip(axes[3*row:], (0, len(times)//3, len(times) - 1)):
            axis.plot(*(1e3*places[k][:, [0, 2]]).T, ".", color=OURS, ms=1)
            axis.set(title=f"{name}, {times[k]:.2g} s", xlim=(0, 100), ylim=(0, 55), aspect="equal")
            axis.grid(False)
        axes[3*row].set_ylabel("z [mm]")
    for axis in axes[-3:]:
        axis.set_xlabel("x [mm]")
    save(figure, HERE/"collapse.png")


def main():
    runs = {name: HERE/"runs"/name for name in ("loose", "dense") if (HERE/"runs"/name).exists()}
    table = results.Table()
    for name, run in runs.items():
        fraction, height = packing(run)
        loose = name == "loose"
        table.add(name, "solid fraction of the column", 0.55 if loose else 0.60, fraction, source="Rondon 2011")
        table.add(name, "height of the column", 0.048 if loose else 0.042, height, unit="m", source="Rondon 2011")
        for what, (time, values), points in (("front", fronts(run), FRONTS),
                                             ("pore pressure", pressures(run), PRESSURES)):
            for at, value in points[name]:
                if time[-1] >= at:
                    table.add(name, f"{what} at {at:g} s", value, numpy.interp(at, time, values),
                              unit="m" if what == "front" else "Pa", source="Rondon 2011")
        time, values = pressures(run)
        table.add(name, "time with the measured sign of the pore pressure over all", 1,
                  numpy.mean(values*PRESSURES[name][0][1] > 0), allowed=0, source="Rondon 2011")
        print(f"{name}: pore pressure from {values.min():.4g} to {values.max():.4g} Pa until {time[-1]:.4g} s")
        table.add(name, "exchange of momentum, largest relative error", 0, results.worst(run, "exchange error"),
                  allowed=1e-12, source="identity")
    table.write(HERE)
    with results.pictures():
        draw(runs)
        draw_side(runs)


if __name__ == "__main__":
    main()
