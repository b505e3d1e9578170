#!/usr/bin/env python3
"""csv_tables.py -- are these files CSV that any reader takes without options?

    csv_tables.py FILE ...            by Python's csv module
    csv_tables.py -pandas FILE ...    by pandas.read_csv(FILE)

The first line names the columns; every other line has as many fields, numbers except in the columns
of words below. No comments. Prints each fault; the exit status is 0 if there is none.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import csv
import sys

WORDS = {"wall", "name", "way", "cause", "effects"}


def is_number(text):
    try:
        float(text)
        return True
    except ValueError:
        return False


def by_csv(path):
    with open(path, newline="") as file:
        rows = list(csv.reader(file, strict=True))
    if len(rows) < 2:
        yield "no rows"
        return
    names = rows[0]
    if len(set(names)) < len(names) or any(is_number(name) or not name or name[0] == "#" for name in names):
        yield f"the first line does not name the columns: {','.join(names)[:80]}"
    for n, row in enumerate(rows[1:], 2):
        if len(row) != len(names):
            yield f"line {n}: {len(row)} fields, not {len(names)}"
        for name, value in zip(names, row):
            if name in WORDS and not value or name not in WORDS and not is_number(value):
                yield f"line {n}: {name} is '{value}'"


def by_pandas(path):
    import pandas
    table = pandas.read_csv(path)
    with open(path) as file:
        lines = sum(1 for _ in file)
    if len(table) != lines - 1 or not isinstance(table.index, pandas.RangeIndex):
        yield f"{len(table)} rows of {lines} lines"
    for name in table.columns:
        if (name in WORDS) == pandas.api.types.is_numeric_dtype(table[name]):
            yield f"{name} has the type {table[name].dtype}"


def main(arguments):
    read = by_pandas if arguments[:1] == ["-pandas"] else by_csv
    files = [a for a in arguments if a != "-pandas"]
    faults = 0
    for path in files:
        try:
            for n, fault in enumerate(read(path)):
                faults += 1
                if n < 3:
                    print(f"#   {path}: {fault}")
        except Exception as error:                       # of the reader, whichever it is
            faults += 1
            print(f"#   {path}: {type(error).__name__}: {error}")
    return 1 if faults or not files else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
