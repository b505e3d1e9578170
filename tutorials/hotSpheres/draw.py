"""draw.py -- Nu over U beside the measured law; the bed, cut open, with the hot spheres coloured by
temperature.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import re

import numpy

import evaluate
import render           # of muellerBed, in the path by results, like style
from style import COLOURS, GREY, OTHER, OURS, POINTS, REFERENCE, below, panels, plt, save

ZERO = 273.15
LOOKS = {"wakao": (OURS, "o", "Suna, wakao"), "gunn": (OTHER, "s", "Suna, gunn"),
         "ranzMarshall": (COLOURS[3], "^", "Suna, ranzMarshall"),
         "wakao, conduction": ("black", "x", "Suna, wakao and conduction")}
HEAT = plt.get_cmap("autumn_r")


def draw_nusselt(case, rows):
    """Rows of the table "Nu of 2 mm at 0.50 Umf"; their reference is the measured law."""
    found = {}
    for row in rows:
        named = re.fullmatch(r"Nu of (\S+) mm at (\S+) Umf", row["quantity"])
        if named and row["part"] in LOOKS:
            found.setdefault(float(named[1]), {}).setdefault(row["part"], []).append(
                [float(named[2]), *(float(row[name] or 0) for name in ("ours", "ci95", "reference"))])
    figure, places = panels(len(found), 9)
    for axes, (size, parts) in zip(places, sorted(found.items())):
        # the law, 2 + c U^0.62, from the largest value; above Umf it is constant
        speed, top = numpy.linspace(0.4, 2.05, 200), max(row[3] for row in parts["wakao"])
        axes.plot(speed, 2 + (top - 2)*numpy.minimum(speed, 1)**0.62, color=REFERENCE, label="measured, Collier et al. 2004")
        for part, own in parts.items():
            colour, mark, label = LOOKS[part]
            at, value, half, _ = numpy.array(own).T
            axes.errorbar(at, value, half, marker=mark, color=colour, label=label, **POINTS)
        axes.axvline(1, color=GREY, lw=0.8, zorder=0)
        axes.set(xlabel="superficial velocity over minimum fluidisation", ylabel="Nusselt number", ylim=(0, None),
                 title=f"hot spheres of {size:g} mm")
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
