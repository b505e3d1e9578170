#!/usr/bin/env python3
"""evaluate.py -- slope of the beads and of the water in the drum, and balances.

    evaluate.py                writes result.csv and bed.png

Slope of the beads  where the solid fraction falls through 0.3, column by column; a straight line through the middle
                    half of the drum's width; means over blocks of 0.5 s from 1 s on, 95 % intervals from these blocks
Flowing layer       velocity of the beads along the slope within a quarter of the radius of the axis, by distance from
                    the surface: the depth at which it vanishes, and the shear rate, a straight line down to there
Slope of the water  a straight line through the height of the water in the middle half of the width, likewise
References
  half, full        the dry drum of this run
  dry               the drum of ../drum at the same Froude number, by the program dem
Bounds
  slope, dry        10 %: intervals of both, and flat sides instead of the round shell
  balances          identities, see ../shared/results.py

SPDX-License-Identifier: GPL-3.0-or-later
"""
import csv
import sys
from pathlib import Path

import numpy

HERE = Path(__file__).resolve().parent
sys.path.append(str(HERE.parent/"shared"))
import results                      # noqa: E402
from results import frames          # noqa: E402
import side                         # noqa: E402

D, RADIUS, DEPTH = 3e-3, 0.05, 0.012
EDGES = numpy.linspace(-0.051, 0.051, 35)
MIDDLE = (EDGES[:-1] + EDGES[1:])/2
BLOCKS = [(1 + 0.5*k, 1.5 + 0.5*k) for k in range(4)]
NAMES = ("dry", "half", "full", "viscous")


def solid_fraction(places):
    """Solid fraction in cells of a diameter, by centres, mean of instants."""
    count = sum(numpy.histogram2d(at[:, 0], at[:, 2], (EDGES, EDGES))[0] for at in places)
    return count/len(places)*numpy.pi/6*D**3/((EDGES[1] - EDGES[0])**2*DEPTH)


def surface(solid):
    """Points of the bed's surface in the middle half of the width [m]."""
    points = []
    for x, column in zip(MIDDLE, solid):
        high = numpy.flatnonzero(column > 0.3)
        if abs(x) < 0.5*RADIUS and len(high) and high[-1] + 1 < len(column):
            k = high[-1]
            share = (column[k] - 0.3)/(column[k] - column[k + 1])
            points.append((x, MIDDLE[k] + share*(EDGES[1] - EDGES[0])))
    return numpy.array(points)


def slope(points):
    """Slope of a line through points [degrees], positive down to the right."""
    return -numpy.degrees(numpy.arctan(numpy.polyfit(*points.T, 1)[0]))


def flowing_layer(places, velocities, line):
    """Depth [m] of the layer that flows down below the surface, points on a line, and its shear rate [1/s]."""
    places, velocities = numpy.concatenate(places), numpy.concatenate(velocities)
    fall, height = numpy.polyfit(*line.T, 1)
    along = numpy.array([1, 0, fall])/numpy.hypot(1, fall)
    here = abs(places @ along) < 0.25*RADIUS
    depth = (height + fall*places[here, 0] - places[here, 2])/numpy.hypot(1, fall)
    bins = numpy.arange(0, RADIUS, D/3)
    count, total = (numpy.histogram(depth, bins, weights=w)[0] for w in (None, velocities[here] @ along))
    filled = count > 20
    middle, speed = ((bins[1:] + bins[:-1])/2)[filled], total[filled]/count[filled]
    still = numpy.flatnonzero(speed < 0)[0]
    share = speed[still - 1]/(speed[still - 1] - speed[still])
    return (middle[still - 1] + share*(middle[still] - middle[still - 1]),
            -numpy.polyfit(middle[:still + 1], speed[:still + 1], 1)[0])


def bed(run):
    """Slope of the bed [degrees], depth [m] and shear rate [1/s] of the flowing layer of each block; none where the run
    is too short."""
    instants = frames.list_frames(run)
    blocks = []
    for low, high in BLOCKS:
        if instants[-1][0] > high - 1e-6:
            beads = [frames.read_frame(path, at) for time, path, at in instants if low < time <= high + 1e-9]
            places, velocities = zip(*(frame[:2] for frame in beads))
            line = surface(solid_fraction(places))
            blocks.append((slope(line), *flowing_layer(places, velocities, line)))
    return numpy.array(blocks).T


def water_surface(run, folder):
    """Height of the water over x in the middle half of the width [m]: columns of the central block of cells."""
    centres, alpha = results.field(run/"0/C"), results.field(folder/"alpha.water")[:, 0]
    points = []
    for low, high in zip(EDGES[:-1], EDGES[1:]):
        here = (centres[:, 0] > low) & (centres[:, 0] <= high)
        if max(abs(low), abs(high)) > 0.5*RADIUS:
            continue
        order = numpy.argsort(centres[here, 2])
        z, a = centres[here, 2][order], alpha[here][order]
        below = numpy.flatnonzero(a > 0.5)
        if len(below) and below[-1] + 1 < len(z):
            k = below[-1]
            points.append(((low + high)/2, z[k] + (a[k] - 0.5)/max(a[k] - a[k + 1], 1e-9)*(z[k + 1] - z[k])))
    return numpy.array(points)


def water(run):
    """Slopes [degrees] and mean heights [m] of the water's surface at the written times from 1 s on."""
    lines = [water_surface(run, folder) for folder in side.times(run) if float(folder.name) > 1]
    return ([results.mean_of_blocks([f(line) for line in lines], 4) for f in (slope, lambda line: line[:, 1].mean())]
            if lines else None)


def dry_drum():
    """Slope by the program dem [degrees]."""
    with open(HERE.parent/"drum/stored/result.csv", newline="") as file:
        return next(float(row["value"]) for row in csv.DictReader(file)
                    if row["quantity"] == "slope of the surface" and row["where"] == "100 mm Fr 0.01")


def draw(runs, beds):
    from matplotlib.patches import Circle
    from style import GREY, panels, save

    def wall(axis):
        turn = numpy.linspace(0, 2*numpy.pi, 200)
        axis.plot(50*numpy.cos(turn), 50*numpy.sin(turn), color=GREY, lw=1)
        axis.set(xlim=(-52, 52), ylim=(-52, 52))
        inside = Circle((0, 0), 50, transform=axis.transData)
        for part in axis.collections:
            part.set_clip_path(inside)

    figure, axes = panels(len(runs), height=3, width=2.6*len(runs), sharey=True)
    for axis, (name, run) in zip(axes, runs.items()):
        side.view(axis, run, side.times(run)[-1], D)
        wall(axis)
        axis.set_title(name + (f": {beds[name][0].mean():.1f}°" if len(beds[name]) else ""))
    axes[0].set_ylabel("z [mm]")
    save(figure, HERE/"bed.png")


def main():
    runs = {name: HERE/"runs"/name for name in NAMES if (HERE/"runs"/name).exists()}
    table = results.Table()
    beds = {name: bed(run) for name, run in runs.items()}
    for name, run in runs.items():
        if len(beds[name]):
            dry = name == "dry"
            for k, (quantity, unit, scale) in enumerate((("slope of the beads", "degrees", 1),
                                                         ("depth of the flowing layer", "mm", 1e3),
                                                         ("shear rate of the flowing layer", "1/s", 1))):
                if not dry or k == 0:
                    table.add(name, quantity, dry_drum() if dry else scale*beds["dry"][k].mean(),
                              *results.mean_of(scale*beds[name][k]), unit=unit, source="../drum" if dry else "dry",
                              allowed=0.1 if dry else None)
            line, height = water(run) if name == "half" else (None, None)
            if line:
                table.add(name, "slope of the water", 0, *line, unit="degrees")
                table.add(name, "height of the water", 0, 1e3*height[0], 1e3*height[1], unit="mm")
        results.balances(table, name, run)
    table.write(HERE)
    with results.pictures():
        draw(runs, beds)


if __name__ == "__main__":
    main()
