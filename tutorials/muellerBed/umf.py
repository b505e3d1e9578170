#!/usr/bin/env python3
"""umf.py -- static height, void fraction and minimum fluidisation velocity of a run of Allrun -ramp.

    umf.py [CASE]
    umf.py -store "WHAT RAN WHERE" LABEL=CASE ...     tables to stored/umf, side by side in results.md

Height    2 <z> of the beads at the first instant of the record, as for an even bed
Inside    void fraction from 6 to 20 mm, where neither plate nor surface counts
Fixed bed A U + B U^2, fitted to the pressure drop from a quarter to three quarters of the weight
Umf       where it reaches the weight of the beads
Interval  95 %, jackknife over ten blocks of time; the packing is one

Writes umf.csv into CASE: these numbers, and the pressure drop over the velocity.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import csv
import shutil
import sys
from pathlib import Path

import numpy

import averages
import frames
from compare import DEPTH, HERE, WIDTH
from store import put

INSIDE = 6e-3, 20e-3                                # m
GRAVITY = 9.81
# Mueller et al.; the void fraction follows from 9240 spheres of 1.2 mm in 30 mm
MEASURED = {"static height 2 <z>": "30", "void fraction over the height": "0.367",
            "minimum fluidisation velocity": "0.30"}


def packing(case):
    """Height [m], void fraction over it and inside, volume of the beads [m3], mean diameter by volume [m]."""
    position, _, diameter = frames.read_frame(*frames.list_frames(case)[0][1:], by_volume=True)
    volume = (numpy.pi/6*diameter**3).sum()
    height = 2*position[:, 2].mean()
    inside = averages.solid_volume(position, 0.5*diameter, numpy.array([0, WIDTH]), *INSIDE)[0]
    box = WIDTH*DEPTH*(INSIDE[1] - INSIDE[0])
    mean = (6/numpy.pi*volume*frames.spheres_each(case)/len(diameter))**(1/3)
    return height, 1 - volume/(WIDTH*DEPTH*height), 1 - inside/box, volume, mean


def ergun(e, d, air, nu, beads):
    """Velocity at which Ergun's drop over a height is the weight of the beads in it [m/s]."""
    viscous = 150*(1 - e)*air*nu/(e**3*d**2)
    inertial = 1.75*air/(e**3*d)
    weight = (beads - air)*GRAVITY
    return (numpy.sqrt(viscous**2 + 4*inertial*weight) - viscous)/(2*inertial)


def crossing(speed, drop, weight):
    """Velocity where the fitted A U + B U^2 reaches the weight."""
    b, a = numpy.linalg.lstsq(numpy.array([speed**2, speed]).T, drop, rcond=None)[0]
    return (numpy.sqrt(a*a + 4*b*weight) - a)/(2*b)


def store_tables(text, runs):
    """A column for each run beside the measured values."""
    (HERE/"stored"/"umf").mkdir(parents=True, exist_ok=True)
    columns = []
    for label, case in runs:
        if (HERE/"stored") not in Path(case).resolve().parents:
            shutil.copy(Path(case)/"umf.csv", HERE/"stored"/"umf"/f"{label}.csv")
        with open(HERE/"stored"/"umf"/f"{label}.csv", newline="") as file:
            columns.append({row["quantity"]: row for row in csv.DictReader(file) if row["unit"]})
    lines = [f"{text}:", "", "| | measured | " + " | ".join(label for label, _ in runs) + " |",
             "|---|---|" + "---|"*len(runs)]
    for name in columns[0]:
        if name.startswith(("largest", "pressure drop")):
            continue
        unit = columns[0][name]["unit"].replace("1", "")
        cells = [f"{float(column[name]['value']):.3g}" for column in columns]
        lines.append(f"| {name}{', ' if unit else ''}{unit} | {MEASURED.get(name, '')} | {' | '.join(cells)} |")
    put("packing", "\n".join(lines))


def main():
    if sys.argv[1:2] == ["-store"]:
        store_tables(sys.argv[2], [run.split("=", 1) for run in sys.argv[3:]])
        return
    case = Path(sys.argv[1]) if len(sys.argv) > 1 else HERE
    air = frames.entry(case/"constant/transportProperties", "rho")
    nu = frames.entry(case/"constant/transportProperties", "nu")
    beads = frames.entry(case/"constant/demProperties", "density")
    height, mean, inside, volume, diameter = packing(case)
    weight = volume*(beads - air)*GRAVITY/(WIDTH*DEPTH)

    time, plate, *_ = frames.read_columns(case, "platePressure", "surfaceFieldValue.dat")
    _, top, *_ = frames.read_columns(case, "topPressure", "surfaceFieldValue.dat")
    drop = air*(plate - top)
    first, last, rise = (frames.entry(case/"system/options", name) for name in ("first", "speed", "rise"))
    speed = numpy.interp(time, (0, rise), (first, last))
    above = numpy.flatnonzero(drop > 0.75*weight)
    if not len(above):
        sys.exit(f"umf: the pressure drop reaches {drop.max():.4g} Pa, not 3/4 of the beads' weight, {weight:.4g} Pa; "
                 "let the air become faster")
    fixed = numpy.flatnonzero(drop[:above[0]] > 0.25*weight)
    umf, interval = averages.jackknife(lambda chosen: crossing(speed[fixed][chosen], drop[fixed][chosen], weight),
                                       averages.cut_blocks(len(fixed), 10))
    lifted = speed > 1.2*umf

    rows = [("static height 2 <z>", height*1e3, 0, "mm"), ("void fraction over the height", mean, 0, "1"),
            ("void fraction inside", inside, 0, "1"), ("minimum fluidisation velocity", umf, interval, "m/s"),
            ("Ergun's law at the void fraction inside",
             ergun(inside, diameter, air, nu, beads), 0, "m/s"),
            ("largest pressure drop over the weight", drop.max()/weight, 0, "1"),
            ("pressure drop above 1.2 Umf over the weight", drop[lifted].mean()/weight if lifted.any() else numpy.nan,
             0, "1")]
    with open(case/"umf.csv", "w", newline="") as file:
        out = csv.writer(file)
        out.writerow(["quantity", "value", "ci95", "unit"])
        out.writerows([name, f"{value:.5g}", f"{half:.2g}", unit] for name, value, half, unit in rows)
        out.writerow([])
        out.writerow(["speed_m/s", "drop_Pa"])
        out.writerows([f"{u:.4f}", f"{p:.2f}"] for u, p in zip(speed[::10], drop[::10]))
    for name, value, half, unit in rows:
        print(f"{name:45s} {value:9.4f} +- {half:.4f} {unit}")


if __name__ == "__main__":
    main()
