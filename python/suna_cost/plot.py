"""plot.py -- `dem plot FOLDER/cost.csv`: error over processor time, Pareto front, observed order.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import csv
import math
from pathlib import Path

import matplotlib
matplotlib.use("Agg")
import matplotlib.pyplot as plt         # noqa: E402

from suna.command import Refused, read_options      # noqa: E402

HELP = """Usage: dem plot FOLDER/cost.csv

Draws a study of accuracy against cost: errors over processor time, as cost.png and cost.svg beside
the table. dem cost and demCost call it at their end; this draws a stored table again.
"""

# of Okabe and Ito, which colour-blind readers tell apart, and two greys
COLOURS = {"kinetic": "#d55e00", "rotation": "#e69f00", "height": "#0072b2", "overlap": "#56b4e9", "force": "#009e73",
           "contacts": "#cc79a7", "restitution": "#000000", "level": "#999999", "void": "#555555", "drop": "#f0e442"}
TITLES = {"friction": "law of friction, against the scene's",
          "effects": "without each effect, against the whole scene", "step": "time step",
          "stiffness": "stiffness, against hard spheres",
          "interval": "interval of exchange", "width": "width of the kernel, against none",
          "kernel": "kernels, against the case's", "mesh": "cells"}

ROUND_OFF = 1e-12                                   # smaller changes are not plotted

plt.rcParams.update({"font.size": 9, "axes.spines.top": False, "axes.spines.right": False, "axes.grid": True, "grid.alpha": 0.25,
                     "savefig.dpi": 160, "savefig.bbox": "tight", "svg.hashsalt": "suna"})


def number(row, name):
    return float(row[name])


def draw_quantity(axes, rows):
    """Plot the errors of one quantity of a series, from coarse to fine, with uncertainty."""
    rows = [r for r in rows if number(r, "error") > ROUND_OFF]
    if not rows:
        return
    name, order = rows[0]["quantity"], number(rows[0], "order")
    label = name + (f", order {order:.2g}" if math.isfinite(order) else "") + f" ({rows[0]['kind']})"
    time, error = [number(r, "processor[s]") for r in rows], [100*number(r, "error") for r in rows]
    uncertainty = [100*number(r, "error_unsure") for r in rows]
    low = [min(u, 0.9*e) for e, u in zip(error, uncertainty)]
    compared = rows[0]["kind"] == "compared"
    axes.errorbar(time, error, yerr=[low, uncertainty], color=COLOURS.get(name, "#777777"),
                  ls="" if compared else "-", lw=1.2, elinewidth=0.7, capsize=2, marker="o",
                  ms=4, label=label)
    for r, t, e in zip(rows, time, error):
        if compared:
            axes.annotate(r["level"], (t, e), xytext=(5, 3), textcoords="offset points",
                          fontsize=6.5,
                          color=COLOURS.get(name, "#777777"))
        if r["base"] == "1":
            axes.plot(t, e, "o", ms=9, mfc="none", color=COLOURS.get(name, "#777777"))


def draw_front(axes, rows):
    """Plot the Pareto front: errors of the worst quantity of the levels that are not dominated."""
    points = sorted((number(r, "processor[s]"), 100*number(r, "error")) for r in rows if r["front"] == "1" and r["worst"] == "1"
                    and number(r, "error") > 0)
    if points:
        axes.step(*zip(*points), where="post", color="0.6", lw=5, alpha=0.35, zorder=0, label="Pareto front of the worst")


def plot(path):
    path = Path(path)
    with path.open() as file:
        rows = list(csv.DictReader(file))
    names = list(dict.fromkeys(r["series"] for r in rows))
    figure, panels = plt.subplots(1, len(names), figsize=(5.2*len(names), 4.4), squeeze=False)
    for axes, series in zip(panels[0], names):
        own = [r for r in rows if r["series"] == series]
        draw_front(axes, own)
        for quantity in dict.fromkeys(r["quantity"] for r in own):
            draw_quantity(axes, [r for r in own if r["quantity"] == quantity])
        drawn, compared = any(number(r, "error") > ROUND_OFF for r in own), own[0]["kind"] == "compared"
        axes.set(xscale="linear" if compared else "log", yscale="log" if drawn else "linear", ylabel="change [%]" if compared else "error [%]",
                 xlabel="processor time of a run [s]" + ("" if compared else "; circle: the scene as it is"))
        if compared:
            axes.set_xlim(0, 1.2*max(number(r, "processor[s]") for r in own))
            axes.ticklabel_format(axis="x", scilimits=(-2, 3))
        axes.set_title(TITLES.get(series, series), loc="left", fontsize=9.5)
        if drawn:
            axes.legend(fontsize=7, frameon=False, loc="upper center", bbox_to_anchor=(0.5, -0.13), ncols=2)
    figure.tight_layout()
    for ending in ("png", "svg"):
        figure.savefig(path.with_suffix("." + ending), metadata={"Date": None} if ending == "svg" else None)


def main(arguments):
    tables = read_options(arguments, "dem plot", ())[1]
    if len(tables) != 1:
        raise Refused("give one table; see dem plot -help")
    try:
        plot(tables[0])
    except OSError as error:
        raise Refused(f"{tables[0]}: {error.strerror}") from None
    except (KeyError, ValueError, csv.Error, UnicodeDecodeError):
        raise Refused(f"{tables[0]} is no table of dem cost or demCost; give their cost.csv") from None
