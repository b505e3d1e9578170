#!/usr/bin/env python3
"""form.py -- checks the form of the pages of docs/ and of the tutorials. Prints TAP.

The first sentence says what the reader can do after it ("After this page you ..."). Within two
screens (60 lines) there is code, a formula or a picture. No line is longer than 120 characters,
except in code, tables and pictures. docs/README.md links every page. The page of a tutorial opens with
a small picture, is about one screen long, and says what to expect and what to change. The column
Suna of the table of docs/results.md has numbers of the stored results of the case.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import csv
import glob
import os
import re
import sys

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
sys.path.append(os.path.join(ROOT, "tests"))
from tap import claim, finish        # noqa: E402

SCREENS = 60
PICTURE = 450000      # bytes


def faults(name, text, index):
    """Sentences about what a page lacks."""
    lines, found, fenced = text.split("\n"), [], False
    if not re.match(r"# .+\n\nAfter this page you ", text):
        found.append("the first sentence does not begin with After this page you")
    if not any(re.match(r"```|    \S|!\[", line) for line in lines[:SCREENS]):
        found.append("no code, formula or picture in the first %d lines" % SCREENS)
    for number, line in enumerate(lines, 1):
        if line.startswith("```"):
            fenced = not fenced
        elif len(line) > 120 and not fenced and not re.match(r"\||    |<!--|!\[", line):
            found.append("line %d has %d characters" % (number, len(line)))
    if name != "README.md" and "(%s" % name not in index:
        found.append("docs/README.md does not link it")
    return found


def tutorial_faults(path):
    """Sentences about what the page of a tutorial lacks."""
    text, found = open(path, encoding="utf-8").read(), []
    picture = re.match(r"# .+\n\n!\[[^\]]+\]\(([^)]+)\)", text)
    file = picture and os.path.join(os.path.dirname(path), picture.group(1))
    if not picture:
        found.append("it does not open with a picture")
    elif not os.path.exists(file) or os.path.getsize(file) > PICTURE:
        found.append("%s is missing, or larger than %d bytes" % (file, PICTURE))
    if text.count("\n") > SCREENS:
        found.append("it has more than %d lines" % SCREENS)
    for heading in ("## What you should see", "## What to change next"):
        if heading not in text:
            found.append("it has no heading " + heading)
    return found


def validation(text):
    """Rows of the table of docs/results.md with a number that no stored result of the case has."""
    table = text.split("<!-- numbers of stored results -->")[1].split("<!-- end")[0]
    found, stored = [], []
    for row in table.strip().split("\n")[2:]:
        cells = [cell.strip() for cell in row.strip("|").split("|")]
        case = re.match(r"\[(\w+)\]", cells[0])
        if case:
            stored = []
            folder = os.path.join(ROOT, "tutorials", case.group(1), "stored")
            for path in glob.glob(os.path.join(folder, "result*.csv")):
                with open(path, newline="") as file:
                    stored += [cell for line in csv.reader(file) for cell in line]
        value = cells[3].strip("*")
        digits = len(value.partition(".")[2])
        for cell in stored:
            try:
                if any("%.*f" % (digits, scale*float(cell) + shift) == value
                       for scale in (1, 1000) for shift in (-1e-9, 1e-9)):
                    break
            except ValueError:
                pass
        else:
            found.append("no stored result rounds to the number of: " + row)
    return found


def main():
    pages = sorted(glob.glob(os.path.join(ROOT, "docs", "*.md")))
    index = open(os.path.join(ROOT, "docs", "README.md"), encoding="utf-8").read()
    cases = sorted(set(glob.glob(os.path.join(ROOT, "tutorials", "*", "README.md"))) -
                   {os.path.join(ROOT, "tutorials", "shared", "README.md")})
    for page in pages + cases:
        name = os.path.relpath(page, ROOT)
        if page in pages:
            found = faults(os.path.basename(page), open(page, encoding="utf-8").read(), index)
        else:
            found = tutorial_faults(page)
        claim(name + " has the form of a page", not found, found)
    found = validation(open(os.path.join(ROOT, "docs", "results.md"), encoding="utf-8").read())
    claim("the table of docs/results.md has the numbers of the stored results", not found, found)
    finish()


if __name__ == "__main__":
    main()
