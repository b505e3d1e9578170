"""dem_case.py -- functions shared by the cases of the program dem: files, intervals, result.csv,
the table in results.md.

Intervals are 95 % by Student's t, of independent runs (seeds) or of blocks of time of one run; each
case says which. A row of result.csv has quantity, where, reference, value, ci95 and unit; the
reference is empty if there is none.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import csv
import re
import shutil
import sys
from pathlib import Path

import numpy

# intervals, style and spheres of pictures: muellerBed leads to them
sys.path.append(str(Path(__file__).resolve().parent/"muellerBed"))
import render                                           # noqa: E402, F401
from averages import student                            # noqa: E402
from style import GREY, MEASURED, OTHER, OURS, POINTS, REFERENCE, below, panels, plain_ticks, plt, \
    save, shades           # noqa: E402, F401

KINDS = {"Float64": "<f8", "Float32": "<f4", "Int64": "<i8"}


# ---- files of dem --------------------------------------------------------------------------------

def read_vtp(path):
    """The columns of a picture of particles by name; "points" are the positions."""
    raw = Path(path).read_bytes()
    split = raw.index(b"<AppendedData")
    start = raw.index(b"_", split) + 1
    columns = {}
    for kind, name, width, offset in re.findall(r'type="(\w+)" Name="(\w+)"(?: NumberOfComponents="(\d+)")? format="appended" '
                                                r'offset="(\d+)"', raw[:split].decode()):
        at = start + int(offset)
        size = int.from_bytes(raw[at:at + 8], "little")
        values = numpy.frombuffer(raw[at + 8:at + 8 + size],
                                  KINDS[kind]).astype(float if "Float" in kind else int)
        columns[name] = values.reshape(-1, int(width)) if width and int(width) > 1 else values
    return columns


def pictures(folder):
    """Times [s] and files of all pictures of a run."""
    text = (Path(folder)/"particles.pvd").read_text()
    return [(float(time), Path(folder)/name)
            for time, name in re.findall(r'timestep="([^"]+)".*?file="([^"]+)"', text)]


def panel(title, path):
    """The particles of a picture file, for render."""
    at = read_vtp(path)
    return render.Panel(title, at["points"], at["velocity"], at["diameter"])


def read_table(path):
    """A table with a header: columns by name without the unit; columns that are not numbers stay
    text."""
    with open(path, newline="") as file:
        rows = list(csv.reader(line for line in file if not line.startswith("#")))
    columns = {}
    for name, *values in zip(*rows):
        try:
            columns[name.split("[")[0]] = numpy.array(values, float)
        except ValueError:
            columns[name.split("[")[0]] = numpy.array(values)
    return columns


# ---- intervals -----------------------------------------------------------------------------------

def interval(values):
    """Mean of independent values and half the width of its 95 % interval; a single value has
    none."""
    values = numpy.asarray(values, float)
    n = len(values)
    return values.mean(), (student(n - 1)*values.std(ddof=1)/numpy.sqrt(n) if n > 1 else numpy.nan)


def blocks(values, number):
    """The same from means over blocks of a series in time."""
    return interval([block.mean() for block in numpy.array_split(numpy.asarray(values, float),
        number)])


# ---- results -------------------------------------------------------------------------------------

class Result:
    """Rows of result.csv and of the table in results.md."""

    def __init__(self):
        self.rows = []

    def add(self, quantity, where, reference, value, ci95, unit):
        self.rows.append((quantity, where, reference, value, ci95, unit))

    def write(self, path="result.csv"):
        def text(x):
            return x if isinstance(x, str) else "" if x is None or numpy.isnan(x) else f"{x:.5g}"
        with open(path, "w", newline="") as file:
            out = csv.writer(file, lineterminator="\n")
            out.writerow(["quantity", "where", "reference", "value", "ci95", "unit"])
            out.writerows([text(x) for x in row] for row in self.rows)
        width = max(len(str(row[0])) + len(str(row[1])) for row in self.rows) + 1
        for quantity, where, *numbers, unit in self.rows:
            reference, value, ci95 = map(text, numbers)
            print(f"{quantity + ' ' + where:{width}s} {value:>9s}{' +- ' + ci95 if ci95 else '':12s}  "
                  f"{'reference ' + reference if reference else '':24s} {unit}")


def number_text(cell, digits=4):
    return f"{float(f'{float(cell):.{digits}g}'):g}" if cell else ""


def value_text(row):
    return number_text(row["value"]) + (f" ± {number_text(row['ci95'], 2)}" if row["ci95"] else "")


def line_table(rows):
    """A line for each row."""
    lines = ["| | | reference | Suna |", "|---|---|---|---|"]
    before = None
    for row in rows:
        unit = "" if row["unit"] == "1" else " " + row["unit"]
        lines.append(f"| {row['quantity'] if row['quantity'] != before else ''} | {row['where']} "
                     f"| {number_text(row['reference'])} | {value_text(row)}{unit} |")
        before = row["quantity"]
    return "\n".join(lines)


def cross_table(rows):
    """Quantities of the same places, quantities across if they are fewer; references in parentheses."""
    cells = {}
    for row in rows:
        quantity = row["quantity"] + ("" if row["unit"] == "1" else f" [{row['unit']}]")
        reference = f" ({number_text(row['reference'])})" if float(row["reference"] or 0) else ""
        cells[row["where"], quantity] = value_text(row) + reference
    places, quantities = (list(dict.fromkeys(names)) for names in zip(*cells))
    if len(quantities) >= len(places):
        places, quantities = quantities, places
        cells = {(quantity, where): text for (where, quantity), text in cells.items()}
    head = "Suna (reference)" if any("(" in text for text in cells.values()) else ""
    return "\n".join([f"| {head} | {' | '.join(quantities)} |", "|---"*(1 + len(quantities)) + "|",
                      *(f"| {place} | {' | '.join(cells[place, quantity] for quantity in quantities)} |"
                        for place in places)])


def table(path, pattern=".*"):
    """The rows of a result.csv whose "quantity: where" matches, as tables of results.md: one for quantities that
    share three places or more, a line each for the other rows."""
    with open(path, newline="") as file:
        rows = [row for row in csv.DictReader(file) if re.fullmatch(pattern, f"{row['quantity']}: {row['where']}")]
    places = {}
    for row in rows:
        places.setdefault(row["quantity"], []).append(row["where"])
    shared = {}
    for quantity, names in places.items():
        shared.setdefault(tuple(names), []).append(quantity)
    crossed = [quantities for names, quantities in shared.items() if len(names) > 2 and len(quantities) > 1]
    tables = [cross_table([row for row in rows if row["quantity"] in quantities]) for quantities in crossed]
    rest = [row for row in rows if not any(row["quantity"] in quantities for quantities in crossed)]
    return "\n\n".join(tables + ([line_table(rest)] if rest else []))


def store(text, *files, name="table", result="result.csv"):
    """Keep files of this run in stored/, its result.csv under the name `result`, and put its table into results.md
    where <!-- name --> or <!-- name: PATTERN OF ROWS --> is, under a line with the run and the machine."""
    Path("stored").mkdir(exist_ok=True)
    shutil.copy("result.csv", Path("stored", result))
    for file in files:
        shutil.copy(file, "stored")
    page = Path("results.md")
    content = page.read_text()
    found = re.search(rf"(<!-- {name}(?:: (.*?))? -->\n).*?(?=<!-- end -->)", content, re.DOTALL)
    if not found:
        print(f"results.md has no <!-- {name} -->: the table is not stored there")
        return
    new = f"{found[1]}{text}:\n\n{table('result.csv', found[2] or '.*')}\n"
    page.write_text(content[:found.start()] + new + content[found.end():])
