"""plots.py -- profiles with the measured points, the pressure over time, and pictures of the bed.

    plots.py stored measured            stored/profiles.png from the tables there and the measured points

SPDX-License-Identifier: GPL-3.0-or-later
"""
import csv
import sys
from pathlib import Path
from types import SimpleNamespace

import numpy

import frames
import render
from style import OURS, REFERENCE as MEASURED, below, plt, save

COLUMN = (0.044, 0.010, 0.085)                      # m, what is shown of it


def draw_profiles(case, profiles, centres):
    rows = 1 if len(profiles) == 2 else 2                   # void fraction above, velocity below
    figure, panels = plt.subplots(rows, 3, figsize=(11, 3.1*rows), squeeze=False)
    places = [*panels[0, :2], *panels[1:].flat]
    for axes, p in zip(places, profiles):
        axes.fill_between(1e3*centres, p.profile - p.interval, p.profile + p.interval, color=OURS,
                          alpha=0.22, lw=0)
        axes.plot(1e3*centres, p.profile, color=OURS, lw=1.8)
        axes.plot(1e3*p.measured[0], p.measured[1], "o", ms=4, mfc="none", color=MEASURED)
        name = "void fraction" if p.quantity == "voidFraction" else "vertical velocity [m/s]"
        axes.set(xlabel="distance from the left wall [mm]", ylabel=name, xlim=(0, 44))
        axes.set_title(f"{p.height:g} mm above the plate", fontsize=9.5)
        axes.set_title(f"rms {p.rms:.3f}", loc="right", fontsize=8.5, color="0.35")
    for axes in panels[0, :2]:
        axes.set_ylim(0.3, 0.9)
    legend = panels[0, 2]
    legend.axis("off")
    legend.plot([], [], "o", ms=4, mfc="none", color=MEASURED,
                label="measured, Mueller et al. 2008/2009")
    legend.plot([], [], color=OURS, lw=1.8, label="Suna, mean over beads")
    legend.fill_between([], [], [], color=OURS, alpha=0.22, lw=0, label="its 95 % interval")
    legend.legend(loc="center left", frameon=False, fontsize=10)
    figure.tight_layout()
    save(figure, case/"profiles.png")


def draw_pressure(case, balance):
    time, drop = balance.time, balance.drop
    figure, axes = plt.subplots(figsize=(9, 3))
    axes.plot(time, drop, color=OURS, lw=0.7)
    axes.axhline(balance.weight, color=MEASURED, lw=1.2,
                 label=f"weight of the beads {balance.weight:.1f} Pa")
    axes.axhline(balance.mean, color=OURS, lw=1.2, ls="--",
                 label=f"mean {balance.mean:.1f} $\\pm$ {balance.interval:.1f} Pa")
    low, high = numpy.percentile(drop, [0.5, 99.5])
    axes.set(xlabel="time [s]", ylabel="pressure drop [Pa]", xlim=(time[0], time[-1]),
             ylim=(min(0, 1.1*low), 1.15*max(high, balance.weight)))
    below(figure)
    save(figure, case/"pressure.png")


def panels_of(instants):
    return [render.Panel(f"{time:.2f} s", *frames.read_frame(*place)) for time, *place in instants]


def draw_bed(case, instants, size=COLUMN, speed=0.4):
    """The bed at some instants, beads coloured by their vertical velocity, up to `speed` [m/s], in a
    column of glass of this size [m]."""
    render.draw(case/"bed.png", panels_of(instants), render.box((0, 0, 0), size), "vertical", speed)


def draw_motion(case, instants, speed=0.4):
    """The same as an animation, ten times slower than the bed."""
    seconds = 10*(instants[-1][0] - instants[0][0])/max(len(instants) - 1, 1)
    render.animate(case/"bed.webp", panels_of(instants), render.box((0, 0, 0), COLUMN), "vertical",
                   speed, seconds)


def draw_all(case, profiles, centres, balance):
    """Instants for the picture: from the second half, a few frames apart."""
    draw_profiles(case, profiles, centres)
    draw_pressure(case, balance)
    listed = frames.list_frames(case)
    chosen = sorted({max(0, len(listed) - 1 - back) for back in (12, 8, 4, 0)})
    draw_bed(case, [listed[k] for k in chosen])
    draw_motion(case, listed[-24:])


def read_tables(folder, measured):
    """Profiles of a run from its profiles.csv and result.csv, with the measured points; and the centres of
    their boxes [m]."""
    with open(folder/"result.csv", newline="") as file:
        rms = {(row["quantity"], row["height_mm"]): float(row["rms"]) for row in csv.DictReader(file)}
    found = {}
    with open(folder/"profiles.csv", newline="") as file:
        for row in csv.DictReader(file):
            found.setdefault((row["quantity"], row["height_mm"]), []).append(
                [1e-3*float(row["x_mm"]), float(row["value"]), float(row["ci95"])])
    profiles = []
    for (quantity, height), rows in found.items():
        centres, profile, interval = numpy.array(rows).T
        points = numpy.loadtxt(measured/f"{quantity}_{float(height):g}mm.csv", delimiter=",", skiprows=2).T
        profiles.append(SimpleNamespace(quantity=quantity, height=float(height), rms=rms[quantity, height],
                                        profile=profile, interval=interval, measured=points))
    return profiles, centres


if __name__ == "__main__":
    draw_profiles(Path(sys.argv[1]), *read_tables(*map(Path, sys.argv[1:3])))
