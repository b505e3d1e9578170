#!/usr/bin/env python3
"""store.py -- keep a run's results in stored/ and put its table into README.md.

    store.py CASE "10 s, 2 cores of ..., DATE" [NAME]

CASE is a folder in which compare.py has written; the text says what ran where. Without NAME it is the run of the table
at the top; with NAME (fine, stiff, slow) it goes to stored/NAME and into the table of that name.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import csv
import re
import shutil
import sys
from pathlib import Path

from compare import HERE, experiment

FILES = ["result.csv", "profiles.csv", "profiles.png", "pressure.png", "bed.png"]
SHORT = ["result.csv", "profiles.csv", "profiles.png"]          # of a run with a name


def table(rows, text, against):
    others = {(quantity, height): pair for quantity, height, _, *pair in against.rows}
    lines = [f"{text}:", "", f"| | height | rms | 95 % of rms | spread of the measured points | {' | '.join(against.others)} |",
             "|---|---|---|---|---|---|---|"]
    last = []
    for row in rows:
        key = row["quantity"], float(row["height_mm"])
        if key in others:
            unit = "" if row["unit"] == "1" else " " + row["unit"]
            name = "void fraction" if key[0] == "voidFraction" else "vertical velocity"
            lines.append(f"| {name} | {key[1]:g} mm | **{float(row['rms']):.3f}**{unit} | ± {float(row['ci95']):.3f} "
                         f"| {float(row['spread']):.3f} | {others[key][0]:.3f} | {others[key][1]:.3f} |")
        elif key[0] == "pressureDrop":
            last.append(f"Pressure drop {float(row['rms']):.1f} ± {float(row['ci95']):.1f} Pa; the beads weigh "
                        f"{float(row['spread']):.1f} Pa.")
        elif key[0] == "wallTime":
            last.append(f"Wall time {float(row['rms']):.0f} s.")
    return "\n".join(lines + ["", " ".join(last)])


def main():
    if len(sys.argv) not in (3, 4):
        sys.exit(__doc__)
    case, name = Path(sys.argv[1]), "".join(sys.argv[3:])
    (HERE/"stored"/name).mkdir(parents=True, exist_ok=True)
    for file in SHORT if name else FILES:
        shutil.copy(case/file, HERE/"stored"/name/file)
    with open(case/"result.csv", newline="") as file:
        new = table(csv.DictReader(file), sys.argv[2], experiment(case))
    readme = HERE/"README.md"
    head = f"<!-- table {name}".rstrip() + " -->\n"
    text = readme.read_text()
    if head not in text:
        sys.exit(f"store: README.md has no line {head}")
    readme.write_text(re.sub(rf"({head}).*?(<!-- end -->)", lambda m: m.group(1) + new + "\n" + m.group(2), text,
                             flags=re.DOTALL))


if __name__ == "__main__":
    main()
