#!/usr/bin/env python3
"""results.py -- functions shared by the validating tutorials: rows of a table, intervals, cost,
storing.

    results.py CASE "COMMAND"      keep result.csv and the pictures of CASE in CASE/stored; put the
                                   table into results.md, with date, kind of machine, commit,
                                   command and processor time

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


def ended(run):
    log = Path(run)/"log.demPimpleFoam"
    return log.exists() and "\nEnd" in log.read_text(errors="replace")


def worst(run, key):
    """Largest number after `key` in the solver's log."""
    text = (Path(run)/"log.demPimpleFoam").read_text(errors="replace")
    return max((float(value) for value in re.findall(rf"{key} ([-+0-9.eE]+)", text)),
               default=numpy.nan)


def processor_time(case):
    """Seconds of all runs of a case."""
    total = 0
    for log in Path(case).rglob("log.demPimpleFoam"):
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


def markdown(rows):
    lines = ["| | quantity | reference | ours | ± 95 % | difference | allowed |",
             "|---|---|---|---|---|---|---|"]
    before = None
    for row in rows:
        unit = f" {row['unit']}" if row["unit"] else ""
        relative = float(row["reference"]) != 0
        difference = f"{100*float(row['difference']):+.2f} %" if relative else ""
        allowed = f"{100*float(row['allowed']):g} %" if row["allowed"] and relative else row["allowed"]
        mark = "**" if row["verdict"] == "outside" else ""
        lines.append(f"| {row['part'] if row['part'] != before else ''} | {row['quantity']} | {row['reference']}{unit} "
                     f"| {mark}{row['ours']}{mark} | {row['ci95']} | {difference} | {allowed} |")
        before = row["part"]
    return "\n".join(lines)


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
    return f"one core of an {' '.join(model.split()[:2])}"


def store(case, command):
    case = Path(case).resolve()
    kept = case/"stored"
    kept.mkdir(exist_ok=True)
    for file in [case/"result.csv", *case.glob("*.png")]:
        shutil.copy(file, kept/file.name)
    with open(case/"result.csv", newline="") as file:
        rows = list(csv.DictReader(file))
    commit = subprocess.run(["git", "rev-parse", "--short", "HEAD"], cwd=case, capture_output=True,
                            text=True).stdout.strip()
    today = datetime.date.today()
    head = (f"`{command}`, {today.day} {today:%B %Y}, {kind_of_machine()} that other programs used too, commit {commit}, "
            f"{processor_time(case):.0f} s of processor:\n\n")
    page = case/"results.md"
    page.write_text(re.sub(r"(<!-- table -->\n).*?(<!-- end -->)",
                             lambda m: m.group(1) + head + markdown(rows) + "\n" + m.group(2),
                             page.read_text(), flags=re.DOTALL))


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    store(*sys.argv[1:])
