#!/usr/bin/env python3
"""evaluate.py -- rate of the grains through the slot, and balances.

    evaluate.py [-animate]     writes result.csv, mass.png and hopper.png; with -animate hopper.webp

References
  Beverloo      W = C rho_b sqrt(g) b (w - k d)^1.5 for a slot w wide and b deep, C = 1.03, k = 1.4 (Nedderman, Statics
                and Kinematics of Granular Materials, 1992); rho_b of the settled grains in the bin
Rates are fits to the mass between a fifth and three fifths of the grains. Bounds:
  dry           20 %: hopper walls at 53 degrees instead of a flat bottom
  water         alpha outside of [0, 1]; 1e-9
  volume        of water and air, what the flows through the patches and the grains leave unexplained; 1e-9 of the
                volume that has left
  exchange      1e-12, an identity

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
from results import frames          # noqa: E402
import side                         # noqa: E402

D, RHO = 2.5e-3, 2500
SLOT, BIN, DEPTH, CONE, TOP = 0.02, 0.08, 0.02, 0.04, 0.16   # m; CONE is the height of the sloping walls


def grains(run):
    return int(re.search(r"count (\d+);", (run/"constant/demProperties").read_text())[1])


def left(run):
    """Times of the record and mass of the grains that have left [s, kg]."""
    listed = [(time, len(frames.read_frame(path, at)[0])) for time, path, at in frames.list_frames(run)]
    time, count = numpy.array(listed).T
    return time, (grains(run) - count)*RHO*math.pi/6*D**3


def rate(run):
    """Rate [kg/s] and half of its 95 % interval, from four parts of the steady time; None if it is too short."""
    time, mass = left(run)
    whole = grains(run)*RHO*math.pi/6*D**3
    steady = (mass > 0.2*whole) & (mass < 0.6*whole)
    if steady.sum() < 12 or mass[-1] < 0.6*whole:
        return None
    parts = zip(numpy.array_split(time[steady], 4), numpy.array_split(mass[steady], 4))
    return results.mean_of([numpy.polyfit(t, m, 1)[0] for t, m in parts])


def bulk_density(run):
    """Of the settled grains above the sloping walls, without the uppermost two diameters [kg/m3]."""
    places = frames.read_frame(*frames.list_frames(run)[0][1:])[0]
    top = numpy.quantile(places[:, 2], 0.98) - 2*D
    inside = (places[:, 2] > CONE) & (places[:, 2] < top)
    return inside.sum()*RHO*math.pi/6*D**3/((top - CONE)*BIN*DEPTH)


def balances(table, run):
    results.balances(table, run.name, run)
    last = frames.read_table(run, "dem", "budget.csv")[-1]
    table.add(run.name, "volume that no flow explains over volume that left", 0,
              abs(float(last["rest.volume[m3]"])/float(last["flow:outlet.volume[m3]"])), allowed=1e-9, source="identity")


def walls(axis):
    from style import GREY

    axis.plot([-10, -40, -40], [0, 40, 160], color=GREY, lw=1)
    axis.plot([10, 40, 40], [0, 40, 160], color=GREY, lw=1)
    axis.set(xlim=(-42, 42), ylim=(-2, 130))


def draw(runs):
    from style import GREY, OTHER, OURS, below, panels, save

    folders = [path for path in side.times(runs["slurry"]) if round(float(path.name)/0.01) in (5, 10, 20, 30, 40)]
    side.series(HERE/"hopper.png", runs["slurry"], folders, D, 3.2, walls, width=2.2*len(folders))
    figure, (axis,) = panels(1)
    for (name, run), colour in zip(runs.items(), (OURS, OTHER)):
        time, mass = left(run)
        axis.plot(time, 1e3*mass, color=colour, label=name)
    if "dry" in runs:
        time, mass = left(runs["dry"])
        axis.plot(time, 1e3*numpy.minimum(beverloo(runs["dry"])*time, mass[-1]), color=GREY, lw=1, label="Beverloo's law")
    axis.set(xlabel="time [s]", ylabel="grains that have left [g]")
    below(figure, columns=3)
    save(figure, HERE/"mass.png")


def beverloo(run):
    return 1.03*bulk_density(run)*math.sqrt(9.81)*DEPTH*(SLOT - 1.4*D)**1.5


def main():
    runs = {name: HERE/"runs"/name for name in ("slurry", "dry") if (HERE/"runs"/name).exists()}
    table, rates = results.Table(), {name: rate(run) for name, run in runs.items()}
    for name, run in runs.items():
        if rates[name]:
            law = beverloo(run)
            table.add(name, "rate of the grains", law, *rates[name], unit="kg/s", source="Beverloo",
                      allowed=0.2 if name == "dry" else None)
        balances(table, run)
    table.write(HERE)
    if all(rates.values()) and len(runs) > 1:
        print("Grains leave with %.3f kg/s, with water %.3f kg/s; Beverloo's law for dry grains: %.3f kg/s"
              % (rates["dry"][0], rates["slurry"][0], beverloo(runs["dry"])))
    with results.pictures():
        draw(runs)
        if "-animate" in sys.argv:
            side.animate(HERE/"hopper.webp", runs["slurry"], D, 0.1, walls, size=(2.6, 3.4))


if __name__ == "__main__":
    main()
