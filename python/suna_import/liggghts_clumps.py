"""liggghts_clumps.py -- fix particletemplate/multisphere of LIGGGHTS as a shape of the scene, and the groups of
these clumps.

    fix NAME all particletemplate/multisphere SEED atom_type 1 density constant 2500 nspheres 3 ntry 100000
        spheres file nut.txt scale 1e-3 type 1

or `spheres x y z r x y z r ...`. Both codes take mass and inertia of the union of the spheres: LIGGGHTS samples it
with `ntry` points, Suna computes it. Both place the centre of mass and keep the axes of the list.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import math

import numpy

from .liggghts_insertion import Base, Template
from .scene_text import as_name, vector

POINTS = 60             # along the longest side, to find the volume of a union


class Clump(Template):
    """`spheres`: rows of x y z r [m]; `shape`: its name in the scene."""

    def __init__(self, type, density, spheres, shape, place):
        super().__init__(type, density, "constant", (0.0,), place, shape)
        self.spheres = spheres
        at = numpy.linspace(0, 1, POINTS, endpoint=False) + 0.5/POINTS
        low = (spheres[:, :3] - spheres[:, 3:]).min(axis=0)
        size = (spheres[:, :3] + spheres[:, 3:]).max(axis=0) - low
        points = low + size*numpy.stack(numpy.meshgrid(at, at, at, indexing="ij"), axis=-1).reshape(-1, 3)
        inside = numpy.zeros(len(points), bool)
        for *centre, radius in spheres:
            inside |= ((points - centre)**2).sum(axis=1) < radius**2
        centre = points[inside].mean(axis=0)
        self.bound = max(math.dist(sphere[:3], centre) + sphere[3] for sphere in spheres)
        self.radius = ((inside.mean()*size.prod()*3/(4*math.pi))**(1/3),)      # of its volume

    def range(self):
        return self.bound, self.bound

    def entry(self):
        return "spheres (" + " ".join(vector(sphere) for sphere in self.spheres) + ");"


def template(t, name, group, words):
    base, number, spheres = Base(t), None, None
    for key, rest in base.others(words[1:]):
        if key == "nspheres":
            number = t.whole(rest.pop(0), 1, 256)
        elif key == "spheres":
            if number is None:
                t.refuse("must come after nspheres", "spheres")
            spheres, rest[:] = read_spheres(t, rest, number)
        elif key in ("ntry", "type", "volume_limit"):
            rest.pop(0)
        else:
            t.refuse("the importer does not know this word; it takes mass and inertia of the spheres' union",
                     f"particletemplate/multisphere {key}")
    if spheres is None:
        t.refuse("spheres are missing")
    if not (spheres[:, 3] > 0).all():
        t.refuse("a radius is not above 0", "spheres")
    t.templates[name] = Clump(base.type, base.density, spheres, t.names.free("shapes", as_name(name)), t.command.place)
    t.translated("shapes")


def read_spheres(t, rest, number):
    """Rows x y z r [m], and the words left."""
    if rest[0] != "file":
        words, rest = rest[:4*number], rest[4*number:]
        rows, scale = [t.numbers(words, "length")], 1.0
    else:
        path, rest, scale = t.file(rest[1]), rest[2:], 1.0
        if rest[:1] == ["scale"]:
            scale, rest = t.positive(rest[1], "number"), rest[2:]
        lines = [line.split("#")[0].split() for line in path.read_text(errors="replace").splitlines()]
        rows = [t.numbers(line, "length") for line in lines if line]
    values = numpy.array([value for row in rows for value in row], float)
    if len(values) != 4*number or any(len(row) % 4 for row in rows):
        t.refuse(f"{len(values)} numbers are not x y z r of {number} spheres", "spheres")
    return scale*values.reshape(number, 4), rest
