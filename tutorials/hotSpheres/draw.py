"""draw.py -- Nu over U beside the measured law; the bed, cut open, with the hot spheres coloured by
temperature.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import numpy

import evaluate
import render           # of muellerBed, in the path by results, like style
from style import COLOURS, OURS, OTHER, REFERENCE, below, plt, save

ZERO = 273.15
LOOKS = {"wakao": (OURS, "o"), "gunn": (OTHER, "s"), "ranzMarshall": (COLOURS[3], "^")}
HEAT = plt.get_cmap("autumn_r")


def draw_nusselt(case, found, lifting):
    sizes = sorted({ds for _, ds, _, _ in found})
    figure, places = plt.subplots(1, len(sizes), figsize=(8, 3.4))
    for axes, ds in zip(places, sizes):
        run = found[0][0]
        speed = numpy.linspace(0.4, 1.02*max(row[0].speed for row in found)/lifting, 200)
        axes.plot(speed, evaluate.measured(numpy.minimum(speed, 1)*lifting, ds, run.db, run.nu), "-",
                  color=REFERENCE, lw=1.5, label="measured, Collier et al. 2004")
        for law, (colour, mark) in LOOKS.items():
            rows = [row for row in found if row[1] == ds and row[0].law == law and row[0].plain]
            axes.errorbar([row[0].speed/lifting for row in rows], [row[2] for row in rows],
                          [row[3] or 0 for row in rows], fmt=mark, color=colour, ms=4.5, capsize=2, lw=1,
                          label=f"Suna, {law}")
        rows = [row for row in found if row[1] == ds and row[0].conducts]
        axes.plot([row[0].speed/lifting for row in rows], [row[2] for row in rows], "x", color="black",
                  ms=7, label="Suna, wakao and conduction")
        axes.axvline(1, color="0.7", lw=0.8, zorder=0)
        axes.set(xlabel="velocity over that of minimum fluidisation", ylabel="Nusselt number", ylim=(0, None),
                 title=f"hot spheres of {1e3*ds:g} mm")
    figure.tight_layout()
    below(figure, columns=3)
    save(figure, case/"nusselt.png")


def draw_bed(case, runs, height=0.16):
    """A bed at rest and a moving one at three instants, beads in front of the middle left out."""
    still = next(run for run in runs if run.law == "wakao" and not run.moves)
    moving = [run for run in runs if run.law == "wakao" and run.moves and run.plain]
    panels = [(still, len(still.time) - 1)]
    if moving:
        run = moving[len(moving)//2]
        panels += [(run, int(numpy.argmin(abs(run.time - time)))) for time in (1, 2.5, run.time[-1])]
    figure, places = plt.subplots(1, len(panels), squeeze=False, figsize=(1.9*len(panels) + 0.5, 4.4))
    for axes, (run, k) in zip(places.flat, panels):
        lines = render.box((0, 0, 0), (run.high[0], run.high[1], height))
        folder = run.folders[k]
        place = evaluate.column(folder/"positions")[:, :3]
        diameter = numpy.resize(evaluate.column(folder/"d")[:, 0], len(place))
        hot = evaluate.column(folder/"material")[:, 0] == 0
        share = (evaluate.column(folder/"temperature")[:, 0] - run.cold)/120
        paint = numpy.where(hot[:, None], HEAT(numpy.clip(share, 0, 1))[:, :3], (0.80, 0.86, 0.92))
        shown = (hot | (place[:, 1] > 0.5*run.high[1])) & (place[:, 2] < height)
        render.view(axes, lines, place[shown], 0.5*diameter[shown], paint[shown], pixels=420)
        axes.set_title(f"{run.speed:g} m/s, {run.time[k]:g} s", fontsize=8)
    bar = figure.colorbar(plt.cm.ScalarMappable(plt.Normalize(20, 140), HEAT), ax=places, shrink=0.6,
                          pad=0.01, aspect=25)
    bar.set_label("bronze [C]", fontsize=8)
    save(figure, case/"bed.png", dpi=140)
