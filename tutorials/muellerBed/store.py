#!/usr/bin/env python3
"""store.py -- copy the results of a run to stored/ and write its table into results.md.

    store.py CASE "10 s, 2 cores of ..., DATE" [NAME]

CASE is a folder in which compare.py has written; the text says what ran where. Without NAME it is
the run of the table at the top; with NAME (fine, stiff, slow) it goes to stored/NAME, and into the
table of that name if results.md has one.

    store.py -beside "WHAT RAN WHERE" NAME LABEL=CASE ...

Runs side by side, a row each, in the table of that name; their result.csv and profiles.csv go to
stored/NAME/LABEL. The first is the reference. A CASE may be a folder in stored/.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import csv
import re
import shutil
import sys
from pathlib import Path

import beside

from compare import HERE, experiment

FILES = ["result.csv", "profiles.csv", "profiles.png", "pressure.png", "bed.png"]
SHORT = ["result.csv", "profiles.csv"]          # of a run with a name; profiles.png if results.md shows it


def table(rows, text, against):
    others = {(quantity, height): pair for quantity, height, _, *pair in against.rows}
    lines = [f"{text}:", "", f"| | height | rms | spread of the measured points | {' | '.join(against.others)} |",
             "|---|---|---|---|---|---|"]
    last = []
    for row in rows:
        key = row["quantity"], float(row["height_mm"])
        if key in others:
            unit = "" if row["unit"] == "1" else " " + row["unit"]
            name = "void fraction" if key[0] == "voidFraction" else "vertical velocity"
            lines.append(f"| {name} | {key[1]:g} mm | **{float(row['rms']):.3f}** ± {float(row['ci95']):.3f}{unit} "
                         f"| {float(row['spread']):.3f} | {others[key][0]:.3f} | {others[key][1]:.3f} |")
        elif key[0] == "pressureDrop":
            last.append(f"Pressure drop {float(row['rms']):.1f} ± {float(row['ci95']):.1f} Pa; the beads weigh "
                        f"{float(row['spread']):.1f} Pa.")
        elif key[0] == "pressureDeviation":
            last.append(f"Its standard deviation is {float(row['rms']):.1f} ± {float(row['ci95']):.1f} Pa;")
        elif key[0] == "pressureCrossings":
            last.append(f"it crosses its mean upwards {float(row['rms']):.2f} ± {float(row['ci95']):.2f} times a second,")
        elif key[0] == "pressureDominant":
            last.append(f"its spectrum is largest at {float(row['rms']):.2f} ± {float(row['ci95']):.2f} Hz.")
        elif key[0] == "processorTime":
            last.append(f"{float(row['rms']):.0f} s of processor.")
    return "\n".join(lines + ["", *last])


def main():
    if len(sys.argv) > 4 and sys.argv[1] == "-beside":
        text, name, *runs = sys.argv[2:]
        put(name, beside.table([beside.Run(label, keep(Path(case), HERE/"stored"/name/label))
                                for label, case in (run.split("=", 1) for run in runs)], text))
        return
    if len(sys.argv) not in (3, 4):
        sys.exit(__doc__)
    case, name = Path(sys.argv[1]), "".join(sys.argv[3:])
    (HERE/"stored"/name).mkdir(parents=True, exist_ok=True)
    shown = ["profiles.png"] if f"stored/{name}/profiles.png" in (HERE/"results.md").read_text() else []
    for file in SHORT + shown if name else FILES:
        shutil.copy(case/file, HERE/"stored"/name/file)
    with open(case/"result.csv", newline="") as file:
        put(name, table(csv.DictReader(file), sys.argv[2], experiment(case)))


def keep(case, folder):
    """Copy the tables of a run, unless they are stored already; returns their folder."""
    if HERE/"stored" in (case.resolve(), *case.resolve().parents):
        return case
    folder.mkdir(parents=True, exist_ok=True)
    for file in ("result.csv", "profiles.csv"):
        shutil.copy(case/file, folder/file)
    return folder


def put(name, new):
    """Write a table into results.md at its marker."""
    page = HERE/"results.md"
    head = f"<!-- table {name}".rstrip() + " -->\n"
    text = page.read_text()
    if head not in text:
        print(f"store: results.md has no line {head.strip()}; its table:\n\n{new}")
        return
    page.write_text(re.sub(rf"({head}).*?(<!-- end -->)",
                             lambda m: m.group(1) + new + "\n" + m.group(2), text,
                             flags=re.DOTALL))


if __name__ == "__main__":
    main()
