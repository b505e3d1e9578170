#!/usr/bin/env python3
"""draw.py -- the pictures of docs/choosing.md and kernels.md, from stored tables of the repository.

    python3 docs/pictures/draw.py [FOLDER]        writes choosing-*.png there, else beside this file

Nothing is computed here: tests/cost/studies/stored, tests/coupled/noise and
tutorials/muellerBed/stored hold the numbers, their dates and how to make them again.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import csv
import pathlib
import sys

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parent.parent
sys.path.insert(0, str(ROOT/"python"))
from suna_plot.style import COLOURS, GREY, MARKS, panels, plain_ticks, save as write     # noqa: E402

STUDIES = ROOT/"tests/cost/studies/stored"
BED = ROOT/"tutorials/muellerBed/stored"


def rows(path):
    with open(path, newline="") as file:
        return list(csv.DictReader(line for line in file if not line.startswith("#")))


def series(study, name, quantity):
    """[(level, processor time [s], error [%]), ...] of a stored cost study"""
    return [(float(r["level"]), float(r["processor[s]"]), 100*float(r["error"]))
            for r in rows(STUDIES/study/"cost.csv")
            if r["series"] == name and r["quantity"] == quantity]


def line(axes, number, points, label):
    x, y = zip(*points)
    axes.plot(x, y, color=COLOURS[number], marker=MARKS[number], label=label)


def save(figure, name):
    folder = pathlib.Path(sys.argv[1]) if len(sys.argv) > 1 else HERE
    write(figure, folder/("choosing-%s.png" % name))


def logarithmic(axes, x, y, ticks):
    axes.set(xscale="log", yscale="log", xlabel=x, ylabel=y)
    plain_ticks(axes.xaxis, [t for t, _ in ticks])
    axes.set_xticks([t for t, _ in ticks], [text for _, text in ticks])


def legend(axes, columns=2, drop=-0.2):
    axes.legend(loc="upper center", bbox_to_anchor=(0.5, drop), ncols=columns)


def step():
    figure, (left, right) = panels(2, 9)
    for k, (study, quantity, label) in enumerate([
            ("damped", "kinetic", "damped impact: energy"),
            ("oblique", "rotation", "oblique impact: rotation"),
            ("elastic", "kinetic", "elastic impact: energy"),
            ("bed", "rotation", "bed: rotation"), ("bed", "kinetic", "bed: energy")]):
        line(left, k, [(n, e) for n, _, e in series(study, "step", quantity)], label)
    logarithmic(left, "DEM step over the automatic one", "error [%]",
                [(2.0**k, "%g" % 2.0**k) for k in range(-3, 2)])
    for k, (quantity, label) in enumerate([("kinetic", "kinetic energy"), ("force", "force on the plate"),
                                           ("overlap", "overlap"), ("drop", "pressure drop")]):
        line(right, k, [(0.4*n, e) for n, _, e in series("mueller", "interval", quantity)], label)
    logarithmic(right, "fluid step [ms]", "error [%]", [(t, "%g" % t) for t in (0.1, 0.2, 0.4, 0.8)])
    left.set_title("DEM step")
    right.set_title("fluid step: a bed that begins to move")
    legend(left)
    legend(right)
    save(figure, "step")


def stiffness():
    figure, (left, right) = panels(2, 9)
    for k, (quantity, label) in enumerate([("height", "height, % of a diameter"),
                                           ("drop", "pressure drop"),
                                           ("void", "smallest void fraction")]):
        line(left, k, [(10*n, e) for n, _, e in series("mueller", "stiffness", quantity)], label)
    ticks = [(10*n, "%.2g" % (10*n)) for n in (0.0625, 0.25, 1, 4)]
    logarithmic(left, "Young's modulus [MPa]", "error against hard beads [%]", ticks)
    base = [s for n, s, _ in series("mueller", "stiffness", "height") if n == 1][0]
    line(right, 0, [(10*n, s/base) for n, s, _ in series("mueller", "stiffness", "height")],
         "bed: fluid and particles")
    base = [s for n, s, _ in series("oblique", "stiffness", "kinetic") if n == 1][0]
    line(right, 1, [(10*n, s/base) for n, s, _ in series("oblique", "stiffness", "kinetic")
                    if n <= 4], "particles alone")
    logarithmic(right, "Young's modulus [MPa]", "processor time over that at 10 MPa", ticks)
    plain_ticks(right.yaxis, [0.4, 0.5, 0.7, 1, 1.5])
    legend(left)
    legend(right, 1)
    save(figure, "stiffness")


def cells():
    figure, (left, right) = panels(2, 9)
    for k, (quantity, label) in enumerate([("drop", "pressure drop"),
                                           ("force", "force on the plate")]):
        line(left, k, [(2.25/n, e) for n, _, e in series("mueller", "mesh", quantity)], label)
    logarithmic(left, "cell size over particle diameter (kernel linear)", "error [%]",
                [(2.25/n, "%.2g" % (2.25/n)) for n in (0.5, 0.71, 1, 1.41)])
    plain_ticks(left.yaxis, [5, 10, 20])
    noise = rows(ROOT/"tests/coupled/noise/stored.csv")
    kernels = ["gaussian", "diffusion", "linear", "divided", "particleCentre"]
    for k, (scene, label) in enumerate([("sphere, step 2.5 ms", "cells of one size"),
                                        ("sphere, cells 1 : 2", "cells 1 : 2"),
                                        ("sphere, cells 1 : 8", "cells 1 : 8")]):
        value = {r["kernel"]: 100*float(r["noise [1]"]) for r in noise if r["quantity"] == scene}
        right.plot([value[n] for n in kernels], range(len(kernels)), color=COLOURS[k], marker=MARKS[k], ms=7,
                   ls="", label=label)
    right.set_yticks(range(len(kernels)), kernels)
    right.set(xscale="log", ylim=(-0.5, len(kernels) - 0.5), xlabel="noise of the pressure of a towed sphere [%]")
    legend(left)
    legend(right, 3)
    save(figure, "cells")


def widths():
    figure, (left, right) = panels(2, 9, sharey=True)
    table = {r["quantity"]: r for r in rows(ROOT/"tests/coupled/noise/widths.csv")}
    kernels = [name for name in next(iter(table.values())) if name != "quantity"][::-1]
    for axes, quantities in (
            (left, (("bed of 15 d, cells of 2 d: drop missing", "drop of a bed of 15 d, cells of 2 d"),
                    ("bed of 15 d, cells of 1 d: drop missing", "cells of 1 d"),
                    ("one sphere, cells of 2 d, Re 0.1, ownWake no: speed too large", "one sphere, Re 0.1, cells of 2 d"),
                    ("one sphere, cells of 2 d, Re 0.1, ownWake yes: speed too large", "with ownWake"))),
            (right, (("towed sphere, cells of 2 d: noise in time", "towed sphere, in time"),
                     ("packed bed, cells of 2 d: solid fraction, neighboring cells", "packed bed: solid fraction"),
                     ("packed bed, cells of 2 d: pressure gradient, neighboring cells", "pressure gradient"),
                     ("packed bed, cells of 2 d: velocity, neighboring cells", "velocity")))):
        for k, (quantity, label) in enumerate(quantities):
            axes.plot([100*abs(float(table[quantity][n])) for n in kernels], range(len(kernels)), color=COLOURS[k],
                      marker=MARKS[k], ms=7, ls="", label=label)
        axes.set(xscale="log", ylim=(-0.5, len(kernels) - 0.5))
        plain_ticks(axes.xaxis, [0.5, 1, 2, 5, 10, 20])
        legend(axes)
    left.set_yticks(range(len(kernels)), kernels)
    left.set(xlabel="error [%]", ylabel="kernel, or width [d] of diffusion")
    right.set_xlabel("noise, cells of 2 d [%]")
    save(figure, "widths")


def drag():
    laws = ["gidaspow", "wenYu", "beetstra", "kochHill", "diFelice"]
    figure, (left, right) = panels(2, 9.5, width_ratios=[2, 1])
    for k, law in enumerate(laws):
        table = rows(BED/"softDrag"/law/"result.csv")
        profiles = [r for r in table if r["quantity"] in ("voidFraction", "velocity")]
        left.errorbar([n + 0.14*(k - 2) for n in range(len(profiles))],
                      [float(r["rms"])/float(r["spread"]) for r in profiles],
                      yerr=[float(r["ci95"])/float(r["spread"]) for r in profiles],
                      color=COLOURS[k], marker=MARKS[k], ls="", capsize=2, label=law)
        deviation = [r for r in table if r["quantity"] == "pressureDeviation"][0]
        right.errorbar([float(deviation["rms"])], [k], xerr=[float(deviation["ci95"])],
                       color=COLOURS[k], marker=MARKS[k], capsize=2)
    left.axhline(1.0, color=GREY, lw=0.8)
    left.set_ylim(0)
    left.set_xticks(range(len(profiles)), ["%s\n%g mm" % (
        {"voidFraction": "void fraction"}.get(r["quantity"], "velocity"), float(r["height_mm"])) for r in profiles])
    left.set_ylabel("difference from the measurement\nover a flat profile's")
    legend(left, 5)
    right.set_yticks(range(len(laws)), laws)
    right.invert_yaxis()
    right.set_xlabel("standard deviation of\nthe pressure drop [Pa]")
    save(figure, "drag")


step()
stiffness()
cells()
widths()
drag()
