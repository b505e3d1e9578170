"""liggghts_atoms.py -- particles that a script of LIGGGHTS names one by one: create_atoms,
read_data, groups, and values that the script sets.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import math

import numpy

from .liggghts_heat import set_particles
from .liggghts_particles import BadFile, read_data
from .liggghts_words import MOST

SET = {"diameter": "length", "density": "density", "vx": "velocity", "vy": "velocity",
       "vz": "velocity", "omegax": "spin", "omegay": "spin", "omegaz": "spin", "x": "length",
       "y": "length", "z": "length"}

MOST_POINTS = 5e6       # of a lattice


class Atoms:
    """Commands of a Translation (liggghts.py)."""

    def do_lattice(self, words):
        if words[0] not in ("sc", "sq", "fcc", "bcc", "none"):
            self.refuse("known: sc, sq, fcc, bcc", f"lattice {words[0]}")
        if len(words) > 2:
            self.refuse("orient, origin, spacing are not read; write positions",
                        f"lattice {words[2]}")
        self.lattice = None if words[0] == "none" else (words[0], self.positive(words[1], "length"))
        self.translated("create_atoms")

    def do_create_atoms(self, words):
        kind = self.atom_type(words[0])
        if self.time > 0:
            self.refuse("particles that come after a run: write a fix insert/pack, or give the scene a group with `at`")
        if words[1] == "single":
            x = numpy.array([self.numbers(words[2:5], "length")])
            if self.lattice and "box" not in words:
                x = x*self.lattice[1]
        elif words[1] in ("box", "region"):
            x = self._lattice_points(words)
        else:
            self.refuse("known: single, box, region; fix insert/pack places at random",
                        f"create_atoms {words[1]}")
        self.particles.add(x, kind, self.units.si("length", 1.0), self.units.si("density", 1.0),
                           self.command.place)
        self.translated("insert: list or table")

    def _lattice_points(self, words):
        if self.lattice is None:
            self.lacks("lattice", "lattice")
        if self.box is None:
            self.lacks("create_box", "create_box")
        style, a = self.lattice
        region = self.find(self.regions, words[2], "region") if words[1] == "region" else None
        box = numpy.array(self.box)
        low, high = box.T if region is None else region.bounds()
        basis = {"sc": [(0, 0, 0)], "sq": [(0, 0, 0)], "bcc": [(0, 0, 0), (.5, .5, .5)],
                 "fcc": [(0, 0, 0), (.5, .5, 0), (.5, 0, .5), (0, .5, .5)]}[style]
        low, high = numpy.maximum(low, box[:, 0]), numpy.minimum(high, box[:, 1])
        count = len(basis)*numpy.prod((high - low)/a + 2)
        if not count < MOST_POINTS:
            self.refuse(f"a lattice of {a:g} m has {count:.3g} positions here; the limit is "
                        f"{MOST_POINTS:g}", f"create_atoms {words[1]}")
        axes = [numpy.arange(math.floor(lo/a) - 1, math.ceil(hi/a) + 1)
                for lo, hi in zip(low, high)]
        cells = numpy.stack(numpy.meshgrid(*axes, indexing="ij"), -1).reshape(-1, 3)
        x = numpy.concatenate([(cells + numpy.array(b))*a for b in basis])
        x = x[((x >= box[:, 0]) & (x < box[:, 1])).all(axis=1)]
        return x if region is None else x[region.contains(x)]

    def do_read_data(self, words):
        try:
            found, box = read_data(self.file(words[0]), self.units, self.command.place)
        except BadFile as error:
            self.refuse(f"{words[0]}:{error.line}: {error}")
        self.particles = found
        self.box = box if box is not None else self.box
        self.translated(f"{len(found)} particles: a table")

    def do_group(self, words):
        name, style = words[0], words[1]
        p, placed = self.particles, [i for i in self.placed() if i.group != name]
        known, before = not placed, numpy.isin(self.particles.id, self.groups.get(name, ()))
        if style == "id":
            chosen, asked = numpy.zeros(len(p), bool), 0
            for word in words[2:]:
                numbers = [self.whole(number, 1) for number in word.split(":")]
                low, high, stride = [*numbers, *[numbers[0], 1][len(numbers) - 1:]][:3]
                chosen |= (p.id >= low) & (p.id <= high) & ((p.id - low) % stride == 0)
                asked = max(asked, high)
            known = asked <= max(p.id, default=0)
        elif style == "type":
            kinds = [self.atom_type(word) for word in words[2:]]
            chosen = numpy.isin(p.type, kinds)
            known = not any(t.type in kinds for i in placed for t in i.distribution.templates)
        elif style == "region":
            chosen = self.find(self.regions, words[2], "region").contains(p.x)
        elif style == "empty":
            chosen, known = numpy.zeros(len(p), bool), True
        elif style in ("union", "intersect", "subtract"):
            known = not self.unknown & set(words[2:]) and "all" not in words[2:]
            chosen = self.chosen(words[2]) | (before if style == "subtract" else False)
            for other in map(self.chosen, words[3:]):
                chosen = chosen | other if style == "union" else \
                    chosen & other if style == "intersect" else chosen & ~other
        else:
            self.refuse("known: id, type, region, union, intersect, subtract, empty",
                        f"group {style}")
        self.groups[name] = p.id[chosen if style == "subtract" else chosen | before]    # it adds to a group of this name
        if placed and not known:
            self.unknown.add(name)
        self.translated("particles that are there")

    def chosen(self, group):
        if group == "all":
            return numpy.ones(len(self.particles), bool)
        return numpy.isin(self.particles.id, self.find(self.groups, group, "group"))

    def do_set(self, words):
        chosen, rest = self._chosen_by(words[0], words[1]), words[2:]
        while rest:
            key = rest.pop(0)
            if key == "type":
                if self.moved() or self.placed():
                    self.refuse("the type of particles that a run has moved cannot be changed", "set type")
                self.particles.type[chosen] = self.atom_type(rest.pop(0))
            elif key in SET:
                self._set(chosen, key, self.number(rest.pop(0), SET[key]))
            elif key.startswith("property/"):
                name, word, rest = rest[0], rest[1], rest[2:]
                if self.heat is None or not set_particles(self, chosen, name, word):
                    self.harmless(f"{name} is read by no law that was translated", f"set {key}")
            else:
                self.refuse(f"known: {', '.join(SET)}, type", f"set {key}")
        self.translated("insert")

    def _chosen_by(self, style, name):
        """Of `set STYLE NAME`: which of the particles, as bools."""
        p = self.particles
        if style == "group":
            return self.chosen(name)
        if style == "region":
            return self.find(self.regions, name, "region").contains(p.x)
        if style not in ("atom", "type"):
            self.refuse("known: group, atom, type, region", f"set {style}")
        low, star, high = name.partition("*")
        low = self.whole(low or "1")
        high = self.whole(high) if high else MOST if star else low
        of = p.id if style == "atom" else p.type
        return (of >= low) & (of <= high)

    def moved(self):
        """Particles are there that a run has moved."""
        return self.time > 0 and len(self.particles) > 0

    def placed(self):
        """Insertions that a run has begun."""
        return [i for i in self.insertions if i.start < self.time]

    def inserted(self):
        """Particles of fix insert/... are there, which only a run knows."""
        return self.restarted is not None or any(i.start <= self.time for i in self.insertions)

    def _set(self, chosen, key, value):
        p = self.particles
        if self.moved():
            self.refuse(f"{key} of particles that a run has moved cannot be changed; begin another script with them,"
                        " from a data file (read_data)", f"set {key}")
        if self.inserted() and not self._same(key, value):
            self.refuse(f"{key} of particles that fix insert/... has placed cannot be changed; "
                        "write it in their template", f"set {key}")
        if key in ("diameter", "density"):
            getattr(p, key)[chosen] = value
        else:
            column = p.w if key.startswith("omega") else p.v if key.startswith("v") else p.x
            column[chosen, "xyz".index(key[-1])] = value

    def _same(self, key, value):
        """The inserted particles have this value anyway."""
        templates = [t for i in self.insertions for t in i.distribution.templates]
        if key == "density":
            return all(abs(t.density/value - 1) < 1e-9 for t in templates)
        return key == "diameter" and all(
            t.style == "constant" and abs(2*t.radius[0]/value - 1) < 1e-9 for t in templates)

    def do_velocity(self, words):
        chosen, p = self.chosen(words[0]), self.particles
        self.no_more(words[5:])
        if self.moved():
            self.refuse("velocities of particles that a run has moved cannot be set; begin another script with them,"
                        " from a data file (read_data)")
        if words[1] == "set":
            for k, word in enumerate(words[2:5]):
                if word != "NULL":
                    p.v[chosen, k] = self.number(word, "velocity")
        elif words[1] == "angular":
            p.w[chosen] = self.numbers(words[2:5], "spin")
        else:
            self.refuse("known: set", f"velocity {words[1]}")
        if any(i.start <= self.time for i in self.insertions):
            self.refuse("velocities of particles that fix insert/... has placed cannot be set; "
                        "write vel constant in the fix")
        self.translated("insert")
