"""liggghts_particles.py -- particles that a script names one by one (create_atoms, read_data), and
tables of particles from data files and dumps.

A data file has atom_style granular or sphere: id, type, diameter, density, x, y, z. A dump
is made by `dump custom`, with the columns x y z (or xu) and radius or diameter. Its last frame
counts.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import re

import numpy

from .liggghts_words import MOST, NUMBER
from .scene_text import text, vector

GRANULAR = ("id", "type", "diameter", "density", "x", "y", "z")     # a row of section Atoms
NUMBERS = (*GRANULAR, "xu", "yu", "zu", "vx", "vy", "vz", "omegax", "omegay", "omegaz", "radius")
LIST = 20               # particles that are written in the scene; more go to a table
LARGEST = 1e100         # of a number, in any unit
COLUMNS = ("x", "y", "z", "diameter", "vx", "vy", "vz", "wx", "wy", "wz", "id")


class BadFile(Exception):
    """The sentence, and its line; 0: the file as a whole."""

    def __init__(self, sentence, line=0):
        super().__init__(sentence)
        self.line = line


class Particles:
    """Columns of numpy; ids from 1 as in LIGGGHTS; `groups`: name -> bools."""

    def __init__(self):
        self.id = numpy.empty(0, int)
        self.type = numpy.empty(0, int)
        self.x, self.v, self.w = (numpy.empty((0, 3)) for _ in range(3))
        self.diameter, self.density = numpy.empty(0), numpy.empty(0)
        self.temperature = numpy.empty(0)       # K; 0: as in fix heat/gran
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


def write_table(path, x, diameter, v, w, id, temperature=None):
    columns = numpy.column_stack([x, diameter, v, w])
    names = list(COLUMNS)
    if temperature is not None:
        columns = numpy.column_stack([columns, temperature])
        names.insert(-1, "temperature")
    with open(path, "w", newline="\r\n") as file:
        file.write(",".join(names) + "\n")
        for row, number in zip(columns, id):
            file.write(",".join(f"{value:.12g}" for value in row) + f",{int(number)}\n")


def single_particles(material, path, name, x, diameter, v, w, id, temperature=None):
    """Entries of a group in the scene: a list, or of many a table in this file, which the scene calls
    `name`."""
    if len(x) > LIST:
        write_table(path, x, diameter, v, w, id, temperature)
        return f'type table; material {material}; file "{name}";'
    columns = [("positions", map(vector, x)), ("diameters", map(text, diameter)), ("ids", map(str, id))]
    if v.any():
        columns.append(("velocities", map(vector, v)))
    if w.any():
        columns.append(("spins", map(vector, w)))
    if temperature is not None:
        columns.append(("temperatures", map(text, temperature)))
    return f"type list; material {material}; " + " ".join(
        f"{name} ({' '.join(values)});" for name, values in columns)


def is_data(path):
    """The first line of a data file is a comment; a count of atoms follows, then `Atoms`."""
    with open(path, errors="replace") as file:
        head = file.read(4000)
    return bool(re.search(r"^\s*\d+\s+atoms\b", head, re.M)) and "ITEM:" not in head


def table(rows, lines, names):
    """Columns by name; the words of each row become finite numbers, `id` and `type` whole ones."""
    for row, line in zip(rows, lines):
        if len(row) < len(names):
            raise BadFile(f"{len(row)} words where {' '.join(names)} are expected", line)
    found = {name: column([row[k] for row in rows], lines, name) for k, name in enumerate(names)
             if name in NUMBERS}
    own = numpy.zeros(len(rows), bool)
    own[numpy.unique(found.get("id", range(len(rows))), return_index=True)[1]] = True
    if not own.all():
        k = int(numpy.argmin(own))
        raise BadFile(f"two particles have id {found['id'][k]}", lines[k])
    return found


def column(words, lines, name):
    try:
        found = numpy.array(words, float)
    except ValueError:
        found = numpy.array([float(word) if NUMBER.fullmatch(word) else numpy.nan
                             for word in words])
    if name not in ("id", "type"):
        good = abs(found) <= LARGEST
    else:
        good = (found == numpy.floor(found)) & (found >= 1) & (found <= MOST)
    if not good.all():
        k = int(numpy.argmin(good))
        raise BadFile(f'"{words[k]}" is no {name}', lines[k])
    return found.astype(int) if name in ("id", "type") else found


def whole_number(word, line):
    return int(column([word.strip()], [line], "type")[0]) if word.strip() != "0" else 0


def complete(found, told, what, line):
    if told is not None and found != told:
        raise BadFile(f"{what} has {found} particles, and the head of the file says {told}; is the file cut off?", line)


def require(good, what, lines):
    if not good.all():
        raise BadFile(f"{what} is not above 0", lines[int(numpy.argmin(good))])


def read_data(path, units, place):
    """Particles, corners of the box or None."""
    with open(path, errors="replace") as file:
        text = file.read().splitlines()
    box, found, section, speeds = numpy.full((3, 2), numpy.nan), Particles(), "", {}
    rows, lines, told = [], [], None
    for line, words in enumerate((row.split("#")[0].split() for row in text), 1):
        if line == 1 or not words:
            continue
        if len(words) == 4 and words[2:] in (["xlo", "xhi"], ["ylo", "yhi"], ["zlo", "zhi"]):
            box["xyz".index(words[2][0])] = units.si("length", 1.0)*column(words[:2], [line]*2,
                                                                           "coordinate")
        elif words[0].isalpha():
            section = words[0]
        elif words[1:] == ["atoms"] and not section:
            told = whole_number(words[0], line)
        elif section == "Atoms":
            rows.append(words)
            lines.append(line)
        elif section == "Velocities":
            speeds[words[0]] = column((words[1:] + ["0"]*6)[:6], [line]*6, "velocity")
    if not rows:
        raise BadFile("no section Atoms with particles found", len(text))
    complete(len(rows), told, "section Atoms", len(text))
    if speeds:
        complete(len(speeds), told, "section Velocities", len(text))
    given = table(rows, lines, GRANULAR)
    motion = numpy.array([speeds.get(row[0], numpy.zeros(6)) for row in rows])
    si = units.si
    require(given["density"] > 0, "the density", lines)
    require(given["diameter"] > 0, "the diameter", lines)
    found.add(numpy.column_stack([given[axis] for axis in "xyz"])*si("length", 1.0), given["type"],
              given["diameter"]*si("length", 1.0), given["density"]*si("density", 1.0), place,
              given["id"], motion[:, :3]*si("velocity", 1.0), motion[:, 3:]*si("spin", 1.0))
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
        raise BadFile("no ITEM: ATOMS found", len(lines))
    first = starts[-1] + 1
    names = lines[starts[-1]].split()[2:]
    end = next((k for k, line in enumerate(lines[first:], first)
                if line.startswith("ITEM:") or not line.strip()), len(lines))
    told = next((k for k in range(first - 1, -1, -1) if lines[k].startswith("ITEM: NUMBER OF ATOMS")), None)
    complete(end - first, None if told is None else whole_number(lines[told + 1], told + 2), "the last frame", end)
    if end == first:
        raise BadFile("the last frame has no particle", first)
    at = range(first + 1, end + 1)
    columns = table([line.split() for line in lines[first:end]], at, names)

    def get(*choices):
        return next((columns[c] for c in choices if c in columns), None)
    x = [get(axis, axis + "u") for axis in "xyz"]
    radius, diameter = get("radius"), get("diameter")
    if any(column is None for column in x) or radius is None and diameter is None:
        raise BadFile(f"its columns are {' '.join(names)}; needed are x y z and radius or diameter",
                      first)
    n, found = len(x[0]), Particles()
    zero = numpy.zeros(n)
    v = numpy.column_stack([zero if (c := get("v" + axis)) is None else c for axis in "xyz"])
    w = numpy.column_stack([zero if (c := get("omega" + axis)) is None else c for axis in "xyz"])
    size = diameter if radius is None else 2*radius
    require(size > 0, "the size", at)
    length, id, kind = units.si("length", 1.0), get("id"), get("type")
    found.add(numpy.column_stack(x)*length, numpy.ones(n) if kind is None else kind,
              size*length, 0.0, place, id, v*units.si("velocity", 1.0), w*units.si("spin", 1.0))
    return found
