#!/usr/bin/env python3
"""results.py -- functions shared by the validating tutorials: rows of a table, intervals, cost,
storing.

    results.py CASE "COMMAND"      keep result.csv and the pictures of CASE in CASE/stored; put
                                   command, date, kind of machine, commit and processor time into
                                   results.md, and fill its tables
    results.py CASE                fill the tables of results.md from CASE/stored/result.csv

results.md says which rows each of its tables shows:

    <!-- rows PATTERN -->  ...  <!-- end -->

PATTERN is a regular expression for "part: quantity". Without groups each row is a line with part,
quantity, reference and result. With groups the table shows differences: the group `column` names
the column of a row, the other groups its line.

A row has part, quantity, reference, ours, interval (half the width at 95 %, none if a run has no
chance), allowed (largest relative difference, none if the row is only reported) and the source of
the reference.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import contextlib
import csv
import datetime
import re
import shutil
import subprocess
import sys
from pathlib import Path

import numpy

# readers of records, and Student's t: muellerBed has them
sys.path.append(str(Path(__file__).resolve().parent.parent/"muellerBed"))
import averages     # noqa: E402
import frames       # noqa: E402

COLUMNS = ["part", "quantity", "reference", "ours", "ci95", "unit", "difference", "allowed",
           "verdict", "source"]


# ---- intervals -----------------------------------------------------------------------------------

def mean_of(values):
    """Mean of independent values (repeated packings, blocks) and half of its 95 % interval."""
    values = numpy.asarray(values, float)
    if len(values) < 2:
        return values.mean(), None
    return values.mean(), averages.student(len(values) - 1)*values.std(ddof=1)/len(values)**0.5


def mean_of_blocks(values, count):
    """Mean of a series and its interval from this many blocks of equal length."""
    blocks = numpy.array_split(numpy.asarray(values, float), count)
    return numpy.mean(values), mean_of([block.mean() for block in blocks])[1]


# ---- runs ----------------------------------------------------------------------------------------

def record(run):
    """Times, positions and velocities [instant, particle, axis] of a run's record; particles in
    order of their ids."""
    instants = []
    for time, path, at in frames.list_frames(run):
        with open(path, "rb") as file:
            file.seek(at)
            count = numpy.fromfile(file, frames.HEAD, 1)[0]["count"]
            instants.append((time, numpy.sort(numpy.fromfile(file, frames.BEAD, count),
                                              order="id")))
    if not instants:
        sys.exit(f"evaluate: no record of particles in {run}")
    return (numpy.array([time for time, _ in instants]),
            numpy.array([beads["position"] for _, beads in instants], float),
            numpy.array([beads["velocity"] for _, beads in instants], float))


def field(path):
    """The internal field of an ASCII file, or the list of a file without one (positions); one row an entry, a single
    row if it is uniform."""
    text = path.read_text()
    uniform = re.search(r"internalField\s+uniform ([^;]*);", text)
    if uniform:
        return numpy.array([re.sub("[()]", " ", uniform[1]).split()], float)
    text = text[text.find("internalField"):] if "internalField" in text else text[text.index("}") + 1:]
    found = re.search(r"(\d+)\s*\((.*?)\n\)", text, re.S)
    numbers = numpy.array(re.sub("[()]", " ", found[2]).split(), float)
    return numbers.reshape(int(found[1]), -1 if numbers.size else 3)


def solver_log(run):
    """The text of the solver's log; empty before it has run."""
    return "".join(log.read_text(errors="replace") for log in Path(run).glob("log.dem*Foam"))


def ended(run):
    return "\nEnd" in solver_log(run)


def worst(run, key):
    """Largest number after `key` in the solver's log."""
    return max((float(value) for value in re.findall(rf"{key} ([-+0-9.eE]+)", solver_log(run))),
               default=numpy.nan)


def balances(table, part, run):
    """Rows of demInterFoam: volume of water with what has left, alpha in [0, 1], the exchange."""
    number = r"([-+0-9.eE]+)"
    alpha = numpy.array(re.findall(rf"alpha.water between {number} and 1 \+ {number}, volume {number} m3, "
                                   rf"left {number} m3", solver_log(run)), float)
    if alpha[:, 2].any():
        table.add(part, "volume of water, relative change", 0,
                  numpy.ptp(alpha[:, 2] + alpha[:, 3])/alpha[:, 2].max(), allowed=1e-9, source="identity")
    table.add(part, "alpha outside of [0, 1]", 0, max(-alpha[:, 0].min(), alpha[:, 1].max()),
              allowed=1e-9, source="identity")
    table.add(part, "exchange of momentum, largest relative error", 0, worst(run, "exchange error"),
              allowed=1e-12, source="identity")


def processor_time(case):
    """Seconds of all runs of a case."""
    total = 0
    for log in Path(case).rglob("log.dem*Foam"):
        times = re.findall(r"ExecutionTime = ([0-9.]+) s", log.read_text(errors="replace"))
        total += float(times[-1]) if times else 0
    return total


# ---- a table -------------------------------------------------------------------------------------

class Table:
    def __init__(self):
        self.rows = []

    def add(self, part, quantity, reference, ours, interval=None, unit="", allowed=None, source=""):
        """allowed None: only reported. For a reference of 0 `allowed` is the absolute bound."""
        reference, ours = float(reference), float(ours)
        difference = ours/reference - 1 if reference else ours
        verdict = "told" if allowed is None else "inside" if abs(difference) <= allowed else "outside"
        self.rows.append(dict(part=part, quantity=quantity, reference=f"{reference:.6g}",
                              ours=f"{ours:.6g}",
                              ci95="" if interval is None else f"{interval:.2g}", unit=unit,
                              difference=f"{difference:.3g}",
                              allowed="" if allowed is None else f"{allowed:g}",
                              verdict=verdict, source=source))

    def write(self, case):
        with open(Path(case)/"result.csv", "w", newline="") as file:
            out = csv.DictWriter(file, COLUMNS)
            out.writeheader()
            out.writerows(self.rows)
        print(markdown(self.rows))
        outside = [row for row in self.rows if row["verdict"] == "outside"]
        print(f"\n{len(self.rows)} rows, {len(outside)} outside what is allowed; "
              f"{processor_time(case):.0f} s of processor")


def relative(row):
    return float(row["reference"]) != 0


def interval_text(half):
    return f" ± {half:.2g}" if half else ""


def bold(text, row):
    return f"**{text}**" if row["verdict"] == "outside" else text


def markdown(rows):
    """A line for each row."""
    lines = ["| | quantity | reference | Suna | difference | allowed |", "|---|---|---|---|---|---|"]
    before = None
    for row in rows:
        unit = f" {row['unit']}" if row["unit"] else ""
        difference = f"{percent(row)} %" if relative(row) else ""
        allowed = f"{bound(row)} %" if row["allowed"] and relative(row) else bound(row)
        ours = bold(f"{float(row['ours']):.5g}", row) + interval_text(float(row["ci95"] or 0))
        lines.append(f"| {row['part'] if row['part'] != before else ''} | {row['quantity']} "
                     f"| {float(row['reference']):.5g}{unit} | {ours} | {difference} | {allowed} |")
        before = row["part"]
    return "\n".join(lines)


def percent(row):
    value = 100*float(row["difference"])
    digits = 2 if abs(value) < 10 else 1 if abs(value) < 100 else 0
    return f"{round(value, digits) + 0.0:+.{digits}f}"


def bound(row):
    """The allowed difference, in % of the reference if there is one."""
    return f"{(100 if relative(row) else 1)*float(row['allowed']):.3g}" if row["allowed"] else ""


def difference_of(row):
    """Difference with its interval, in % of the reference; the value itself for a reference of 0."""
    if not relative(row):
        return bold(f"{float(row['ours']):.3g}", row)
    half = 100*float(row["ci95"] or 0)/abs(float(row["reference"]))
    return bold(percent(row), row) + interval_text(half)


def cross(cells):
    """Differences of the rows by (line, column). If a line has cells with unlike bounds, each cell of the
    table has its own in parentheses."""
    names, columns = (list(dict.fromkeys(names)) for names in zip(*cells))
    lines = {name: {column: cells[name, column] for column in columns if (name, column) in cells} for name in names}
    alike = all(len({bound(row) for row in line.values()}) == 1 for line in lines.values())
    bounded = any(row["allowed"] for row in cells.values())
    last = ["allowed"] if bounded and alike else []
    unit = ", %" if all(map(relative, cells.values())) else ""
    head = ["difference" + unit + (" (allowed)" if bounded and not alike else ""), *columns, *last]

    def cell(row):
        return difference_of(row) + (f" ({bound(row)})" if row["allowed"] and not alike else "")

    out = []
    for name, line in lines.items():
        first = next(iter(line.values()))
        out.append([name if unit or not relative(first) else name + ", %",
                    *(cell(line[column]) if column in line else "" for column in columns),
                    *([bound(first)] if last else [])])
    return "\n".join([f"| {' | '.join(head)} |", "|---"*len(head) + "|", *(f"| {' | '.join(line)} |" for line in out)])


def select(rows, pattern):
    """The table of the rows that match."""
    pattern = re.compile(pattern)
    matches = [(pattern.fullmatch(f"{row['part']}: {row['quantity']}"), row) for row in rows]
    matches = [(found, row) for found, row in matches if found]
    if not matches:
        sys.exit(f"results: no row matches {pattern.pattern}")
    if not pattern.groups:
        return markdown([row for _, row in matches])
    column = pattern.groupindex["column"]
    cells = {}
    for found, row in matches:
        line = ", ".join(text for k, text in enumerate(found.groups(), 1) if k != column)
        if (line, found["column"]) in cells:
            sys.exit(f"results: two rows match {pattern.pattern} as {line}, {found['column']}")
        cells[line, found["column"]] = row
    return cross(cells)


# ---- storing -------------------------------------------------------------------------------------

@contextlib.contextmanager
def pictures():
    """`with results.pictures():` around what needs matplotlib: without it a sentence, no error."""
    try:
        yield
    except ImportError as reason:
        print(f"{Path(sys.argv[0]).stem}: no pictures ({reason})")


def kind_of_machine():
    try:
        text = Path("/proc/cpuinfo").read_text()
        model = re.search(r"model name\s*: (.*)", text).group(1)
    except (OSError, AttributeError):
        return "a machine of unknown kind"
    return f"one core of a shared {' '.join(model.split()[:2])}"


def store(case, command):
    case = Path(case).resolve()
    kept = case/"stored"
    kept.mkdir(exist_ok=True)
    for file in [case/"result.csv", *case.glob("*.png")]:
        shutil.copy(file, kept/file.name)
    commit = subprocess.run(["git", "rev-parse", "--short", "HEAD"], cwd=case, capture_output=True,
                            text=True).stdout.strip()
    today = datetime.date.today()
    put(case/"results.md", "run",
        lambda _: f"`{command}`, {today.day} {today:%B %Y}, {kind_of_machine()}, commit {commit}, "
                  f"{processor_time(case):.0f} s of processor.")
    fill(case)


def fill(case):
    """The tables of results.md, from the stored rows."""
    with open(Path(case)/"stored/result.csv", newline="") as file:
        rows = list(csv.DictReader(file))
    put(Path(case)/"results.md", "rows (.*?)", lambda found: select(rows, found[2]))


def put(page, name, text):
    """Replace the text behind each <!-- name -->."""
    page.write_text(re.sub(f"(<!-- {name} -->\n).*?(<!-- end -->)",
                           lambda found: f"{found[1]}{text(found)}\n<!-- end -->", page.read_text(), flags=re.DOTALL))


if __name__ == "__main__":
    if len(sys.argv) == 2:
        fill(sys.argv[1])
    elif len(sys.argv) == 3:
        store(*sys.argv[1:])
    else:
        sys.exit(__doc__)
