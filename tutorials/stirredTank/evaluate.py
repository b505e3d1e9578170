#!/usr/bin/env python3
"""evaluate.py -- grains that have left the floor as the blades turn faster, and balances.

    evaluate.py [-animate]     writes result.csv, lifted.csv, lifted.png and tank.png; with -animate tank.webp

Reference
  Zwietering    N = S nu^0.1 (g (rho_p - rho)/rho)^0.45 X^0.13 d^0.2 D^-0.85, speed at which no grain rests on the floor
                (Chem. Eng. Sci. 8 (1958) 244), with X the mass of grains over water in per cent; S = 6, in the middle of
                his values for paddles and turbines
Grains count as lifted a diameter above the floor. How many are lifted at Zwietering's speed is only told: S depends on the
blades and their height, and the speed grows during the run. Bounds:
  water         change of its volume, alpha outside of [0, 1]; 1e-9: identities, 10 digits of the log
  exchange      1e-12, an identity

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

RUN = HERE/"runs/tank"
D, COUNT, DENSITY = 2e-3, 1000, 1050
RADIUS, SHAFT, TIP, BLADES, LEVEL = 0.04, 0.005, 0.0186, (0.0105, 0.021), 0.042     # m


def speeds():
    """Times and revolutions per second there, corners of the table; None if the speed is constant."""
    table = re.search(r"omega +table \((.*)\);", (RUN/"constant/dynamicMeshDict").read_text())
    if table is None:
        return None
    times, omega = numpy.array([pair.split() for pair in re.findall(r"\(([^()]+)\)", table[1])], float).T
    return times, omega/2/math.pi


def zwietering():
    water = 1000*math.pi*(RADIUS**2 - SHAFT**2)*LEVEL
    X = 100*COUNT*DENSITY*math.pi/6*D**3/water
    return 6*1e-6**0.1*(9.81*(DENSITY - 1000)/1000)**0.45*X**0.13*D**0.2*(2*TIP)**-0.85


def lifted():
    """Times and fraction of the grains that are a diameter above the floor."""
    rows = [(float(path.name), (side.grains(path)[:, 2] > 1.5*D).mean()) for path in side.times(RUN)]
    return numpy.array(rows).T


def view(axis, folder):
    """Grains from the side, and the mean surface at each radius."""
    from matplotlib.collections import PatchCollection
    from matplotlib.patches import Circle, Rectangle
    from style import GREY, OURS, REFERENCE

    centres = 1e3*results.field(RUN/"0/C")
    r, z = numpy.round(numpy.hypot(centres[:, 0], centres[:, 1]), 0), numpy.round(centres[:, 2], 2)
    alpha = results.field(folder/"alpha.water")[:, 0]
    rows = numpy.unique(z)
    radii = numpy.unique(r)
    level = [numpy.sum([alpha[(r == at) & (z == row)].mean() for row in rows])*(rows[1] - rows[0]) for at in radii]
    x = numpy.concatenate((-radii[::-1], radii))
    axis.fill_between(x, 0*x, level[::-1] + level, color=REFERENCE, alpha=0.25, lw=0)
    for low, width, bottom, height in ((-SHAFT, 2*SHAFT, 0, 0.07), (-TIP, 2*TIP, BLADES[0], BLADES[1] - BLADES[0])):
        axis.add_patch(Rectangle((1e3*low, 1e3*bottom), 1e3*width, 1e3*height, color=GREY, alpha=0.4, lw=0))
    places = 1e3*side.grains(folder)
    axis.add_collection(PatchCollection([Circle((x, z), 500*D) for x, _, z in places[numpy.argsort(-places[:, 1])]],
                                        facecolor=OURS, edgecolor="white", linewidth=0.2))
    axis.set(xlim=(-41, 41), ylim=(0, 65), aspect="equal", xlabel="x [mm]", title=f"{float(folder.name):g} s")
    axis.grid(False)


def draw(times, fraction):
    from style import GREY, OURS, below, image, panels, plt, save

    folders = side.times(RUN)
    shown = [folders[k] for k in numpy.linspace(0, len(folders) - 1, 5).round().astype(int)]
    figure, axes = panels(len(shown), height=2.3, sharey=True, width=2.4*len(shown))
    for axis, folder in zip(axes, shown):
        view(axis, folder)
    axes[0].set_ylabel("z [mm]")
    save(figure, HERE/"tank.png")
    if speeds():
        figure, (axis,) = panels(1)
        axis.plot(numpy.interp(times, *speeds()), fraction, color=OURS, label="grains above the floor")
        axis.axvline(zwietering(), color=GREY, lw=1, label="just suspended, Zwietering")
        axis.set(xlabel="revolutions per second", ylabel="fraction of the grains", ylim=(0, 1))
        below(figure, columns=2)
        save(figure, HERE/"lifted.png")
    if "-animate" in sys.argv:
        images = []
        for folder in folders:
            figure, axis = plt.subplots(figsize=(4, 3.2), layout="constrained")
            view(axis, folder)
            images.append(image(figure, dpi=90, bbox_inches=None).convert("RGB"))
            plt.close(figure)
        images[0].save(HERE/"tank.webp", save_all=True, append_images=images[1:], duration=150, loop=0, quality=45, method=6)


def main():
    table = results.Table()
    results.balances(table, "balances", RUN)
    times, fraction = lifted()
    with open(HERE/"lifted.csv", "w", newline="") as file:
        out = csv.writer(file)
        out.writerow(["time[s]", "lifted[1]"])
        out.writerows(zip(times, fraction))
    if speeds():
        table.add("grains", "fraction above the floor at Zwietering's speed", 1,
                  numpy.interp(zwietering(), numpy.interp(times, *speeds()), fraction), source="Zwietering 1958")
    table.write(HERE)
    with results.pictures():
        draw(times, fraction)


if __name__ == "__main__":
    main()
