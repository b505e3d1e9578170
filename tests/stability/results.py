"""results.py -- a run of the program and its output files, read with the standard library only:
tables, pictures (dem/records/vtk.h) and snapshots (dem/records/snapshot_header.h).

SPDX-License-Identifier: GPL-3.0-or-later
"""
import csv
import glob
import os
import re
import struct
import subprocess


class Run:
    """status, out, err; snapshots, tables. Files are in `folder`/out or in the folder of the
    scene."""

    def __init__(self, folder, command, limit):
        self.folder = folder
        try:
            done = subprocess.run(command, cwd=folder, timeout=limit, stdin=subprocess.DEVNULL,
                                  capture_output=True, text=True)
            self.status, self.out, self.err = done.returncode, done.stdout, done.stderr
        except subprocess.TimeoutExpired:
            self.status, self.out, self.err = 124, "", "did not end within %g s" % limit
        with open(os.path.join(folder, "log.out"), "w") as log:
            log.write(" ".join(command) + "\n" + self.out + self.err)

    @property
    def hash(self):
        found = re.findall(r"^hash (\w+)$", self.out, re.M)
        return found[-1] if found else None

    @property
    def step(self):
        """The automatic or given time step [s]."""
        return float(re.search(r"^step (\S+) s", self.out, re.M).group(1))

    def path(self, name):
        found = glob.glob(os.path.join(self.folder, "**", name), recursive=True)
        return found[0] if found else os.path.join(self.folder, name)

    def snapshots(self):
        """All snapshots in order."""
        return [Snapshot(p) for p in sorted(glob.glob(os.path.join(self.folder, "**",
            "snapshot*.dem"), recursive=True))]

    def table(self, name):
        """A .csv file: a list of rows, each a dict by the column's name without its unit."""
        with open(self.path(name)) as file:
            lines = (line for line in file if not line.startswith("#"))      # line of effects
            return [{re.sub(r"\[.*", "", k): value(v) for k, v in row.items()}
                    for row in csv.DictReader(lines)]

    def energy(self, *terms):
        """The sum of these columns of energy.csv, by the beginning of their names, in each row."""
        return [sum(v for k, v in row.items() if k.startswith(terms)) for row in self.table("energy.csv")]

    def wall(self, name):
        return [row for row in self.table("walls.csv") if row["wall"] == name]


def value(text):
    try:
        return float(text)
    except ValueError:
        return text


class Particle:
    __slots__ = ("id", "x", "v", "w", "radius", "mass", "inertia", "material", "frozen", "columns")


class Snapshot:
    """time [s], steps, particles by id, rows: contact history as (low, high, {name: number})."""

    HEAD = struct.Struct("<8s2Q3Q4qd2q2d24q2q")
    FLOW, NAMES, NAME = 48 + 13*8, 128, 48

    def __init__(self, path):
        with open(path, "rb") as file:
            data = file.read()
        head = self.HEAD.unpack_from(data)
        n, rows, self.steps, self.time = head[6], head[7], head[8], head[10]
        at = self.HEAD.size + 24*self.FLOW
        materials, columns, memories = struct.unpack_from("<3q", data, at)
        at += 24
        names = []
        for k in range(self.NAMES):
            name, width = struct.unpack_from("<%dsq" % self.NAME, data, at + k*(self.NAME + 8))
            names.append((name.split(b"\0")[0].decode(), width))
        at += self.NAMES*(self.NAME + 8)
        self.columns = names[materials:materials + columns]
        memory = names[materials + columns:materials + columns + memories]
        size = 16 + sum(w for _, w in self.columns)
        self.particles = {}
        for k in range(n):
            p = self.particle(struct.unpack_from("<15d8s" + "%dd" % (size - 16), data,
                at + 8*size*k), data, at + 8*size*k)
            self.particles[p.id] = p
        at += 8*size*n
        width = sum(w for _, w in memory)
        self.rows = []
        for k in range(rows):
            low, high, _, _ = struct.unpack_from("<2q2I", data, at + k*(24 + 8*width))
            numbers = struct.unpack_from("<%dd" % width, data, at + k*(24 + 8*width) + 24)
            self.rows.append((low, high, dict(zip((m for m, _ in memory), numbers))))

    def particle(self, words, data, at):
        p = Particle()
        p.x, p.radius, p.v, p.w, p.mass = words[0:3], words[3], words[4:7], words[8:11], words[12]
        p.inertia = 1.0/words[11] if words[11] else float("inf")
        p.id, = struct.unpack_from("<q", data, at + 13*8)
        p.material, flags = struct.unpack_from("<2H", data, at + 14*8)
        p.frozen, p.columns = bool(flags & 1), {}
        k = 16
        for name, width in self.columns:
            p.columns[name] = words[k:k + width]
            k += width
        return p

    def __getitem__(self, number):
        return self.particles[number]

    def kinetic(self):
        """Translational and rotational kinetic energy [J]."""
        return sum(0.5*p.mass*dot(p.v, p.v) + (0.5*p.inertia*dot(p.w, p.w) if not p.frozen else 0.0)
                   for p in self.particles.values())

    def momentum(self):
        return [sum(p.mass*p.v[a] for p in self.particles.values()) for a in range(3)]

    def angular_momentum(self):
        total = [0.0, 0.0, 0.0]
        for p in self.particles.values():
            orbit = cross(p.x, p.v)
            for a in range(3):
                total[a] += p.mass*orbit[a] + (p.inertia*p.w[a] if not p.frozen else 0.0)
        return total

    def finite(self):
        return all(abs(c) < 1e300 for p in self.particles.values() for c in p.x + p.v + p.w)


def dot(a, b):
    return sum(x*y for x, y in zip(a, b))


def cross(a, b):
    return [a[1]*b[2] - a[2]*b[1], a[2]*b[0] - a[0]*b[2], a[0]*b[1] - a[1]*b[0]]


def norm(a):
    return dot(a, a)**0.5
