"""report.py -- tables of a study on the terminal, cost.csv, and the picture.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import csv
import math
from pathlib import Path

from . import refinement
from .best_buy import best_buy

WIDTH = 15      # characters of a column

COLUMNS = ("series level base size step[s] processor[s] spread runs quantity unit mean scatter "
           "reference reference_unsure kind scale error error_unsure order order_unsure worst "
           "front").split()


def time_text(seconds):
    for unit, size in (("h", 3600), ("min", 60)):
        if seconds >= 2*size:
            return f"{seconds/size:.3g} {unit}"
    return f"{seconds:.3g} s"


def error_text(series, level, quantity):
    error, unsure = level.error.get(quantity, math.nan), level.uncertainty.get(quantity, 0)
    if not level.runs:
        return "fails"
    if not math.isfinite(error):
        return "-"
    if series.analysis[quantity].kind == refinement.STATISTICS and unsure > 0:
        return f"{100*error:.2g} +-{100*unsure:.2g} %"
    below = error < unsure
    return f"{'<' if below else ''}{100*(unsure if below else error):.2g} %"


def print_series(study, series):
    width = max([7] + [len(level.name) + (k == series.base)
                       for k, level in enumerate(series.levels)])
    head = "" if series.paired and series.base > 1 else "level"
    print(f"{series.parameter}: {series.description}")
    print(f"    {head:<{width}}    {'step':<12} {'processor':<11} {'times':>6}"
          + "".join(f" {quantity:>{WIDTH}}" for quantity in series.analysis))
    for k, level in enumerate(series.levels):
        times = series.times(level)
        print(f"    {level.name:<{width}}{'*' if k == series.base else ' '} "
              f"{'o' if level.pareto else ' '} {f'{level.step:.4g} s':<12} "
              f"{time_text(level.seconds) if level.runs else '-':<11} "
              f"{f'{times:.3g}' if math.isfinite(times) else '-':>6}"
              + "".join(f" {error_text(series, level, quantity):>{WIDTH}}"
                        for quantity in series.analysis))
        if not level.runs:
            print(" "*16 + level.failed)
    for quantity, found in series.analysis.items():
        if series.paired:
            break
        unit = study.units[quantity]
        text = f"    {quantity:<12} {found.reference:.6g}{'' if unit == '1' else ' ' + unit}, " \
            + found.kind
        if found.kind != refinement.CLOSED:
            text += f", unsure by {100*found.uncertainty/study.scale[quantity]:.2g} %"
        if math.isfinite(found.order):
            text += f", observed order {found.order:.3g} +- {found.order_uncertainty:.1g}"
        print(text)


def rows(study):
    """The rows of cost.csv."""
    for series in study.series:
        for k, level in enumerate(series.levels):
            for quantity, found in series.analysis.items():
                part = next((part for part in found.levels if part.size == level.size), None)
                if not level.runs or part is None or quantity not in level.error:
                    continue
                yield [series.parameter, level.name, int(k == series.base), f"{level.size:.9g}",
                       f"{level.step:.9g}", f"{level.seconds:.6g}", f"{level.spread:.4g}",
                       len(level.runs), quantity, study.units[quantity], f"{part.mean:.12g}",
                       f"{part.scatter:.6g}", f"{found.reference:.12g}",
                       f"{found.uncertainty:.6g}", "compared" if series.paired else found.kind,
                       f"{study.scale[quantity]:.9g}", f"{level.error[quantity]:.6g}",
                       f"{level.uncertainty[quantity]:.6g}", f"{found.order:.4g}",
                       f"{found.order_uncertainty:.4g}", int(level.worst == quantity),
                       int(level.pareto)]


def write_table(study, path):
    with open(path, "w", newline="") as file:
        out = csv.writer(file, lineterminator="\n")
        out.writerow(COLUMNS)
        out.writerows(rows(study))


def report(study):
    """Print the tables and the best buy; write the folder."""
    print(study.title)
    print(f"* the {study.noun} as it is; o no other level is both cheaper and better; times: "
          "processor time over the time of *; heights in mean diameters")
    for series in study.series:
        print_series(study, series)
    print("best buy: " + best_buy(study))
    folder = Path(study.folder)
    write_table(study, folder/"cost.csv")
    print(f"table: {study.folder}/cost.csv")
    try:
        from .plot import plot
    except ImportError:
        print("no picture: it needs matplotlib (Debian: python3-matplotlib)")
        return
    plot(folder/"cost.csv")
    print("picture: cost.png, cost.svg in the same folder")
