"""liggghts_particles.py -- particles that a script names one by one (create_atoms, read_data), and
tables of particles from data files and dumps.

A data file is that of atom_style granular or sphere: id, type, diameter, density, x, y, z. A dump
is that of `dump custom`, with the columns x y z (or xu, xs) and radius or diameter. Its last frame
counts.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import re

import numpy

COLUMNS = ("x", "y", "z", "diameter", "vx", "vy", "vz", "wx", "wy", "wz", "id")


class BadFile(Exception):
    """The sentence."""


class Particles:
    """Columns of numpy; ids from 1 as in LIGGGHTS; `groups`: name -> bools."""

    def __init__(self):
        self.id = numpy.empty(0, int)
        self.type = numpy.empty(0, int)
        self.x, self.v, self.w = (numpy.empty((0, 3)) for _ in range(3))
        self.diameter, self.density = numpy.empty(0), numpy.empty(0)
        self.temperature = numpy.empty(0)       # K; 0: that of fix heat/gran
        self.place = None

    def __len__(self):
        return len(self.id)

    def add(self, x, type, diameter, density, place, id=None, v=0.0, w=0.0):
        n, first = len(x), int(self.id.max()) + 1 if len(self) else 1
        self.id = numpy.append(self.id, numpy.arange(first, first + n) if id is None else id)
        for name, value, width in (("type", type, ()), ("diameter", diameter, ()),
                                   ("density", density, ()), ("x", x, (3,)), ("v", v, (3,)),
                                   ("w", w, (3,)), ("temperature", 0.0, ())):
            old = getattr(self, name)
            new = numpy.broadcast_to(numpy.asarray(value, old.dtype), (n, *width))
            setattr(self, name, numpy.concatenate([old, new]))
        self.place = self.place or place

    def keep(self, which):
        for name in ("id", "type", "x", "v", "w", "diameter", "density", "temperature"):
            setattr(self, name, getattr(self, name)[which])


def write_table(path, x, diameter, v, w, id, temperature=None):
    columns = numpy.column_stack([x, diameter, v, w])
    names = list(COLUMNS)
    if temperature is not None:
        columns = numpy.column_stack([columns, temperature])
        names.insert(-1, "temperature")
    with open(path, "w") as file:
        file.write(",".join(names) + "\n")
        for row, number in zip(columns, id):
            file.write(",".join(f"{value:.12g}" for value in row) + f",{int(number)}\n")


def is_data(path):
    """The first line of a data file is a comment; a count of atoms follows, then `Atoms`."""
    with open(path, errors="replace") as file:
        head = file.read(4000)
    return bool(re.search(r"^\s*\d+\s+atoms\b", head, re.M)) and "ITEM:" not in head


def read_data(path, units, place):
    """Particles, corners of the box or None."""
    with open(path, errors="replace") as file:
        lines = [line.split("#")[0].split() for line in file.read().splitlines()[1:]]
    box, found, section, speeds = numpy.full((3, 2), numpy.nan), Particles(), "", {}
    rows = []
    for words in lines:
        if not words:
            continue
        if len(words) == 4 and words[2:] in (["xlo", "xhi"], ["ylo", "yhi"], ["zlo", "zhi"]):
            box["xyz".index(words[2][0])] = [units.si("length", float(x)) for x in words[:2]]
        elif words[0].isalpha():
            section = words[0]
        elif section == "Atoms":
            rows.append(words)
        elif section == "Velocities":
            speeds[int(words[0])] = [float(x) for x in words[1:7]]
    try:
        table = numpy.array([row[:7] for row in rows], float).reshape(-1, 7)
    except ValueError:
        raise BadFile("section Atoms is not id type diameter density x y z, the form of atom_style "
                      "granular") from None
    if len(table) == 0:
        raise BadFile("no section Atoms with particles found")
    id = table[:, 0].astype(int)
    motion = numpy.array([(speeds.get(k, []) + [0.0]*6)[:6] for k in id])
    si = units.si
    found.add(table[:, 4:7]*si("length", 1.0), table[:, 1], table[:, 2]*si("length", 1.0),
              table[:, 3]*si("density", 1.0), place, id, motion[:, :3]*si("velocity", 1.0),
              motion[:, 3:]*si("spin", 1.0))
    return found, None if numpy.isnan(box).any() else box


def is_dump(path):
    with open(path, "rb") as file:
        return file.read(14) == b"ITEM: TIMESTEP"


def read_dump(path, units, place):
    """Particles of the last frame; the density is not in a dump: 0."""
    with open(path, errors="replace") as file:
        lines = file.read().splitlines()
    starts = [k for k, line in enumerate(lines) if line.startswith("ITEM: ATOMS")]
    if not starts:
        raise BadFile("no ITEM: ATOMS found")
    names = lines[starts[-1]].split()[2:]
    rows = [line.split() for line in lines[starts[-1] + 1:]]
    end = next((k for k, row in enumerate(rows) if row[:1] == ["ITEM:"]), len(rows))
    columns = {name: [row[k] for row in rows[:end]] for k, name in enumerate(names)}

    def get(*choices):
        name = next((c for c in choices if c in columns), None)
        return None if name is None else numpy.array(columns[name], float)
    x = [get(axis, axis + "u") for axis in "xyz"]
    radius, diameter = get("radius"), get("diameter")
    if any(column is None for column in x) or radius is None and diameter is None:
        raise BadFile(f"its columns are {' '.join(names)}; needed are x y z and radius or diameter")
    n, found = len(x[0]), Particles()
    zero = numpy.zeros(n)
    v = numpy.column_stack([zero if (c := get("v" + axis)) is None else c for axis in "xyz"])
    w = numpy.column_stack([zero if (c := get("omega" + axis)) is None else c for axis in "xyz"])
    length, id, kind = units.si("length", 1.0), get("id"), get("type")
    found.add(numpy.column_stack(x)*length, numpy.ones(n) if kind is None else kind,
              (diameter if radius is None else 2*radius)*length, 0.0, place,
              None if id is None else id.astype(int), v*units.si("velocity", 1.0),
              w*units.si("spin", 1.0))
    return found
