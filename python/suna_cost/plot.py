"""plot.py -- a cost.csv as cost.png and cost.svg: error over processor time, Pareto front, observed order.
`dem plot` (suna_plot.table) passes such tables on.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import csv
import math
from pathlib import Path

from suna.command import Refused, read_options
from suna_plot.style import log_ticks, plt, save

# of Okabe and Ito, and greys
COLOURS = {"kinetic": "#d55e00", "rotation": "#e69f00", "height": "#0072b2", "overlap": "#56b4e9", "force": "#009e73",
           "contacts": "#cc79a7", "restitution": "#000000", "level": "#999999", "void": "#555555", "drop": "#8c510a"}
TITLES = {"friction": "law of friction, against the scene's",
          "effects": "without each effect, against the whole scene", "step": "time step",
          "stiffness": "stiffness, against hard spheres",
          "interval": "interval of exchange", "width": "width of the kernel, against none",
          "kernel": "kernels, against the case's", "mesh": "cells"}

ROUND_OFF = 1e-12                                   # smaller changes are not plotted


def number(row, name):
    return float(row[name])


def colour_of(name):
    return COLOURS.get(name, "#777777")


def draw_quantity(axes, rows):
    """Plot the errors of one quantity of a series, from coarse to fine, with uncertainty."""
    rows = [r for r in rows if number(r, "error") > ROUND_OFF]
    if not rows:
        return
    name, order = rows[0]["quantity"], number(rows[0], "order")
    time, error, bars = [number(r, "processor[s]") for r in rows], *errors(rows)
    axes.errorbar(time, error, yerr=bars, color=colour_of(name), lw=1.2, elinewidth=0.7, capsize=2, marker="o", ms=4,
                  label=name + (f", order {order:.2g}" if math.isfinite(order) else ""))
    for r, t, e in zip(rows, time, error):
        if r["base"] == "1":
            axes.plot(t, e, "o", ms=9, mfc="none", color=colour_of(name))


def errors(rows):
    """Errors and their intervals in per cent; an interval does not reach 0, which has no logarithm."""
    error, unsure = ([100*number(r, name) for r in rows] for name in ("error", "error_unsure"))
    return error, [[min(u, 0.9*e) for e, u in zip(error, unsure)], unsure]


def draw_compared(axes, rows):
    """Plot the changes by choices that have no order, such as laws: a column for each choice."""
    names = list(dict.fromkeys(r["level"] for r in rows))
    quantities = list(dict.fromkeys(r["quantity"] for r in rows))
    for k, quantity in enumerate(quantities):
        own = [r for r in rows if r["quantity"] == quantity and number(r, "error") > ROUND_OFF]
        if own:
            error, bars = errors(own)
            at = [names.index(r["level"]) + 0.5*((k + 0.5)/len(quantities) - 0.5) for r in own]
            axes.errorbar(at, error, yerr=bars, color=colour_of(quantity), ls="", elinewidth=0.7, capsize=2, marker="o",
                          ms=5, label=quantity)
    time = {r["level"]: number(r, "processor[s]") for r in rows}
    base = {r["level"] for r in rows if r["base"] == "1"}
    axes.set_xticks(range(len(names)), [f"{name}{' (reference)'*(name in base)}\n{time[name]:.3g} s" for name in names])
    axes.set_xlim(-0.5, len(names) - 0.5)


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
    figure, panels = plt.subplots(1, len(names), figsize=(5*len(names), 4.2), squeeze=False)
    for axes, series in zip(panels[0], names):
        own = [r for r in rows if r["series"] == series]
        drawn = any(number(r, "error") > ROUND_OFF for r in own)
        if own[0]["kind"] == "compared":
            draw_compared(axes, own)
            axes.set(ylabel="change [%]", xlabel="choice, processor time of a run")
        else:
            draw_front(axes, own)
            for quantity in dict.fromkeys(r["quantity"] for r in own):
                draw_quantity(axes, [r for r in own if r["quantity"] == quantity])
            axes.set(xscale="log", ylabel="error [%]", xlabel="processor time of a run [s]; circle: the scene as it is")
            log_ticks(axes.xaxis)
        axes.set_yscale("log" if drawn else "linear")
        axes.set_title(TITLES.get(series, series))
        if drawn:
            axes.legend(loc="upper center", bbox_to_anchor=(0.5, -0.26), ncols=2)
    figure.tight_layout()
    figure.savefig(path.with_suffix(".svg"), metadata={"Date": None})
    save(figure, path.with_suffix(".png"))


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
