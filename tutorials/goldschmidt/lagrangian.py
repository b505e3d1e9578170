#!/usr/bin/env python3
"""lagrangian.py -- read the particles in a time folder of OpenFOAM's clouds or of Suna, ascii or
binary, and write an initial state for either code.

    lagrangian.py FOLDER suna        positions and velocities, as entries of demProperties, on standard output
    lagrangian.py FOLDER dpm         the same as a table of kinematicLookupTableInjection

SPDX-License-Identifier: GPL-3.0-or-later
"""
import re
import sys
from pathlib import Path

import numpy

DIAMETER, DENSITY = 0.0025, 2526.0
WIDTH = {"vectorField": 3, "vectorFieldField": 3, "scalarField": 1}


def split(path):
    """Header and body of a file, and whether the body is binary."""
    raw = Path(path).read_bytes()
    head = raw[:raw.index(b"}") + 1].decode(errors="replace")
    body = raw[raw.index(b"}") + 1:]
    for line in (b"// * *", b"// * * *"):
        if body.lstrip().startswith(line):
            body = body.lstrip().split(b"\n", 1)[1]
    return head, body, re.search(r"format\s+binary", head) is not None


def begin(body):
    """Number of entries and the offset behind the list's opening bracket."""
    found = re.match(rb"\s*(\d+)\s*([({])", body)
    return int(found[1]), found.end(), found[2] == b"{"


def read_field(path):
    """A list of vectors or scalars, n x 3 or n."""
    head, body, binary = split(path)
    width = WIDTH[re.search(r"class\s+(\w+);", head)[1]]
    n, at, uniform = begin(body)
    if binary and not uniform:
        values = numpy.frombuffer(body, "<f8", n*width, at)
    else:
        numbers = numpy.array(re.findall(rb"[-+0-9.eE]+",
                                         body[at:body.rindex(b"}" if uniform else b")")]), float)
        values = numpy.tile(numbers, n) if uniform else numbers
    return values.reshape(n, 3) if width == 3 else values


def read_positions(path):
    """n x 3 [m]; each entry has its cell, too."""
    _, body, binary = split(path)
    n, at, _ = begin(body)
    if not binary:
        numbers = re.findall(rb"\(([^()]+)\)\s*-?\d+", body[at:])
        return numpy.array([row.split() for row in numbers], float)
    # "(" 3 doubles, 1 label ")" and a line's end
    entry = numpy.dtype([("open", "S1"), ("x", "<f8", 3), ("cell", "<i4"), ("close", "S1"),
                         ("end", "S1")])
    while body[at:at + 1] != b"(":
        at += 1
    rows = numpy.frombuffer(body, entry, n, at)
    if not (rows["open"] == b"(").all() or not (rows["close"] == b")").all():
        sys.exit(f"{path}: not n entries of a vector and a label of 32 bits")
    return rows["x"]


def cloud(folder):
    """The folder of a time with the particles."""
    found = sorted(Path(folder).glob("lagrangian/*/positions"))
    if len(found) != 1:
        sys.exit(f"{folder}: {len(found)} clouds under lagrangian/, one is wanted")
    return found[0].parent


def read_state(folder):
    """Positions [m] and velocities [m/s]."""
    place = cloud(folder)
    return read_positions(place/"positions"), read_field(place/"U")


def vectors(values):
    return "\n".join("(%.17g %.17g %.17g)" % tuple(row) for row in values)


def main():
    x, v = read_state(sys.argv[1])
    if sys.argv[2] == "suna":
        print(f"positions\n(\n{vectors(x)}\n);\nvelocities\n(\n{vectors(v)}\n);")
    else:
        print("FoamFile { version 2.0; format ascii; class dictionary; object start; }\n(")
        for place, speed in zip(vectors(x).split("\n"), vectors(v).split("\n")):
            print(f"{place} {speed} {DIAMETER} {DENSITY:g} 1")
        print(")")


if __name__ == "__main__":
    main()
