"""table.py -- `dem plot TABLE`: columns of a table over its first one, a panel for each unit.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import csv
import itertools
from pathlib import Path

from suna.command import Refused, read_options, unknown

from .style import COLOURS, panels, save

HELP = """Usage: dem plot [-x COLUMN] [-y COLUMN,...] [-file PICTURE] TABLE ...

Draws tables: energy.csv, walls.csv, flows.csv, budget.csv, averages, and the cost.csv of dem cost and
demCost. Columns of one unit share a panel, up to 12 lines; a column of words, such as the name of a wall,
makes a line for each word. Several tables with the same columns are drawn together, for comparison.

    -x COLUMN        default: the first column
    -y COLUMN,...    default: all columns of numbers that change
    -file PICTURE    .png, .svg or .pdf; default: TABLE with the ending .png

A cost.csv takes no options: its errors over processor time become cost.png and cost.svg beside it.
"""

MOST = 12           # lines in a panel: more cannot be told apart


def read(path):
    """Columns by name: lists of numbers, or of words."""
    try:
        with open(path, newline="", encoding="utf-8-sig") as file:
            rows = [row for row in csv.reader(line for line in file if not line.startswith("#")) if row]
    except (OSError, UnicodeDecodeError, csv.Error) as error:
        raise Refused(f"{path}: {getattr(error, 'strerror', None) or 'no table'}") from None
    if len(rows) < 2 or any(len(row) != len(rows[0]) for row in rows):
        raise Refused(f"{path} is no table: it needs a line of names and lines with as many values")
    columns = {}
    for name, *values in zip(*rows):
        try:
            columns[name] = [float(value or "nan") for value in values]
        except ValueError:
            columns[name] = values
    return columns


def unit(name):
    return name.partition("[")[2].rstrip("]")


def find(columns, word, path):
    """The column of this name, with or without its unit."""
    for name in columns:
        if word in (name, name.split("[")[0].strip()):
            return name
    raise unknown(f"column of {path}", word, [name.split("[")[0].strip() for name in columns])


def numeric(columns):
    return [name for name, values in columns.items() if isinstance(values[0], float)]


def series(columns, across):
    """Label and rows of each line: one for each combination of words."""
    words = [values for values in columns.values() if isinstance(values[0], str)]
    keys = list(zip(*words)) or [()]*len(columns[across])
    for key in dict.fromkeys(keys):
        yield " ".join(key), [k for k, own in enumerate(keys) if own == key]


def lines(path, columns, across, chosen, several):
    """Unit, column, label, x and y of each line of a table."""
    for name in chosen:
        for label, rows in series(columns, across):
            where = str(Path(path).parent) if several else ""
            column = name.split("[")[0].strip()
            text = ", ".join(filter(None, (column, label, where)))
            yield unit(name), column, text, [columns[across][k] for k in rows], [columns[name][k] for k in rows]


def split(found):
    """Unit, column and lines of each panel: of a unit, or of each column where a unit has too many lines."""
    for own, drawn in found.items():
        columns = dict.fromkeys(line[0] for line in drawn) if len(drawn) > MOST else [None]
        for column in columns:
            yield own, column, [line for name, *line in drawn if column in (None, name)]


def draw(tables, x, y, file):
    found = {}
    for path, columns in tables.items():
        if not numeric(columns):
            raise Refused(f"{path} has no column of numbers")
        across = find(columns, x, path) if x else numeric(columns)[0]
        chosen = [find(columns, word, path) for word in y.split(",")] if y else [
            name for name in numeric(columns) if name != across and len(set(columns[name])) > 1]
        for name in (across, *chosen):
            if name not in numeric(columns):
                raise Refused(f"{path}: column {name} has words, not numbers")
        for own, *line in lines(path, columns, across, chosen, len(tables) > 1):
            found.setdefault(own, []).append(line)
    if not found:
        raise Refused("no column of numbers changes; name some by -y")
    pictures = list(split(found))
    figure, places = panels(len(pictures), None, 3.6, across=3)
    for axes, (own, column, drawn) in zip(places, pictures):
        if len(drawn) > MOST:
            raise Refused(f"column {column} has {len(drawn)} lines, more than the {MOST} that can be told apart; choose "
                          "other columns by -y, or draw some of the lines in Python (suna.read_table)")
        looks = itertools.product(("-", "--"), COLOURS)
        for (label, at, values), (dashes, colour) in zip(drawn, looks):
            axes.plot(at, values, dashes, color=colour, label=label)
        axes.set(xlabel=across.replace("[", " [") if "[" in across else across,
                 ylabel=f"[{own}]" if len(drawn) > 1 and own and not column
                 else (column or drawn[0][0]) + (f" [{own}]" if own else ""))
        axes.ticklabel_format(scilimits=(-2, 4))
        if len(drawn) > 1:
            axes.legend(loc="upper center", bbox_to_anchor=(0.5, -0.2), ncols=2)
    if file.endswith(".png"):
        save(figure, file)
    else:
        figure.savefig(file)


def main(arguments):
    given, paths = read_options(arguments, "dem plot", ("-x", "-y", "-file"))
    if not paths:
        raise Refused("give a table; see dem plot -help")
    tables = {path: read(path) for path in paths}
    if {"series", "quantity", "error"} <= set(tables[paths[0]]):
        from suna_cost.plot import main as draw_cost
        return draw_cost(arguments)
    file = given.get("-file") or str(Path(paths[0]).with_suffix(".png"))
    if Path(file).suffix not in (".png", ".svg", ".pdf"):
        raise Refused(f"-file {file}: the ending is .png, .svg or .pdf")
    draw(tables, given.get("-x"), given.get("-y"), file)
    print(file)
    return None
