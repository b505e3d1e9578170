"""beside.py -- compare runs: rms of each profile, the pressure, and whether profiles differ by more
than their intervals.

    beside.py CASE ...      the table of these runs; the first is the reference

Two profiles differ in a box if their difference exceeds its 95 % interval, the root of the sum of
the squares of both. By chance 5 % of the boxes differ; neighbours are not independent.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import csv
import sys
from pathlib import Path

PROFILES = [("voidFraction", 16.4, "void 16.4"), ("voidFraction", 31.2, "void 31.2"),
            ("velocity", 15.0, "v 15"),
            ("velocity", 25.0, "v 25"), ("velocity", 35.0, "v 35")]


class Run:
    """Results of compare.py in a folder."""

    def __init__(self, label, folder):
        self.label = label
        with open(folder/"result.csv", newline="") as file:
            self.rows = {(row["quantity"], float(row["height_mm"])): row
                         for row in csv.DictReader(file)}
        with open(folder/"profiles.csv", newline="") as file:
            self.boxes = {(row["quantity"], row["height_mm"], row["x_mm"]): (float(row["value"]),
                float(row["ci95"]))
                          for row in csv.DictReader(file)}

    def entry(self, quantity, height=0.0, digits=3, interval=True):
        row = self.rows.get((quantity, height))
        if row is None:
            return ""
        text = f"{float(row['rms']):.{digits}f}"
        return f"{text} ± {float(row['ci95']):.{digits}f}" if interval else text


def differ(run, other):
    """Number of boxes with values that differ by more than their interval, and of all common
    boxes."""
    both = [(run.boxes[key], other.boxes[key]) for key in run.boxes if key in other.boxes]
    return sum(abs(a - b) > (ia**2 + ib**2)**0.5 for (a, ia), (b, ib) in both), len(both)


def table(runs, text):
    against = [differ(run, runs[0]) for run in runs]
    boxes = max(of for _, of in against)
    lines = [f"{text}:", "",
             f"| | {' | '.join(short for *_, short in PROFILES)} | boxes of {boxes} that differ "
             "| deviation of the pressure, Pa | processor, s |",
             "|---" * (len(PROFILES) + 4) + "|"]
    for run, (count, _) in zip(runs, against):
        cells = [run.label, *(run.entry(quantity, height) for quantity, height, _ in PROFILES),
                 "" if run is runs[0] else str(count), run.entry("pressureDeviation", digits=1),
                 run.entry("processorTime", digits=0, interval=False)]
        lines.append(f"| {' | '.join(cells)} |")
    return "\n".join(lines)


if __name__ == "__main__":
    print(table([Run(Path(case).name, Path(case)) for case in sys.argv[1:]], "Runs side by side"))
