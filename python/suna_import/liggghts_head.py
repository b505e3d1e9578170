"""liggghts_head.py -- the head of a script of LIGGGHTS: units, style, box, regions, step, contact
law.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import math
import re

import numpy

from .liggghts_contact import read_model, tell
from .liggghts_mesh import BadMesh, read_tetrahedra
from .liggghts_region import AXES, Region
from .liggghts_words import BadWords
from .units import BASE, Units

ATOM_STYLES = ("granular", "sphere")


class Head:
    """Commands of a Translation (liggghts.py)."""

    def do_units(self, words):
        if words[0] not in BASE:
            self.refuse(f"Suna has SI units; known here: {', '.join(BASE)}", f"units {words[0]}")
        self.units = Units(words[0])
        self.properties.length = self.units.si("length", 1.0)
        self.translated("" if words[0] == "si" else "converted to SI")

    def do_atom_style(self, words):
        style = words[0].split("/omp")[0]
        if style == "hybrid":
            style = next((word for word in words[1:] if word not in ATOM_STYLES), "granular")
        if style not in ATOM_STYLES:
            self.refuse("Suna has spheres without further properties; known: granular, sphere",
                        f"atom_style {style}")
        self.translated("spheres")

    def do_dimension(self, words):
        self.flat = self.planar = words[0] == "2"
        self.translated("domain/flat" if self.flat else "")

    def do_boundary(self, words):
        for word in words[:3]:
            if not re.fullmatch("[pfsm]{1,2}", word):
                raise BadWords(f'"{word}" is none of p, f, s, m')
            if len({letter.replace("s", "m") for letter in word}) > 1:
                self.refuse("the two sides of this axis differ, but a domain of Suna limits both or none; write "
                            f"{word[0]} or {word[1]}", f"boundary {word}")
        self.boundary = words[:3]
        self.translated("domain")

    def do_create_box(self, words):
        region = self.find(self.regions, words[1], "region")
        self.box = numpy.column_stack(region.bounds())
        self.translated("domain")

    def do_thermo_modify(self, words):
        if "lost" in words:
            self.lost = words[words.after("lost")]
        self.harmless("domain/leaving" if "lost" in words else "")

    def do_timestep(self, words):
        self.step = self.positive(words[0], "time")
        self.translated("time/step")

    def do_pair_style(self, words):
        style = words[0].replace("/omp", "")
        if style != "gran" or words.get(1) != "model":
            self.refuse("known is gran model NORMAL tangential FRICTION ...",
                        f"pair_style {words[0]} {words.get(1)}")
        model, rest = read_model(words[2:], self.command.place, "pair_style", self.report)
        if rest:
            self.refuse("the importer does not know this word", f"pair_style {rest[0]}")
        tell(model, self.report)
        self.model = model
        self.translated("effects")

    # ---- regions ---------------------------------------------------------------------------------

    def do_region(self, words):
        name, style, rest = words[0], words[1], words[2:]
        outside, unit = False, "lattice"
        while len(rest) > 2 and rest[-2] in ("units", "side", "volume_limit"):
            unit = rest[-1] if rest[-2] == "units" else unit
            outside |= rest[-2:] == ["side", "out"]
            rest = rest[:-2]
        if unit == "lattice" and self.lattice is not None:
            self.refuse("lengths in units of the lattice are not read; write units box with "
                        "lengths", f"region {style}")
        made = self._region(style, rest, outside)
        self.regions[name] = made
        self.translated(f"{style}, where it is used")

    def _region(self, style, rest, outside):
        place = self.command.place
        if style in ("block", "prism"):
            low = -math.inf if self.box is None else None
            values = []
            for k, word in enumerate(rest[:6 if style == "block" else 9]):
                if word in ("INF", "EDGE"):
                    values.append((low if k % 2 == 0 else math.inf) if self.box is None
                                  else self.box[k//2][k % 2])
                else:
                    values.append(self.number(word, "length"))
            return Region(style, values, place, outside=outside)
        if style == "sphere":
            return Region(style, self.numbers(rest[:4], "length"), place, outside=outside)
        if style in ("cylinder", "cone"):
            values = []
            for k, word in enumerate(rest[1:6 if style == "cylinder" else 7]):
                end = k >= (3 if style == "cylinder" else 4)
                if end and word in ("INF", "EDGE"):
                    high = k == (4 if style == "cylinder" else 5)
                    values.append((math.inf if high else -math.inf) if self.box is None
                                  else self.box[AXES[rest[0]]][int(high)])
                else:
                    values.append(self.number(word, "length"))
            return Region(style, values, place, axis=rest[0], outside=outside)
        if style == "plane":
            return Region(style, self.numbers(rest[:6], "length"), place, outside=outside)
        if style in ("union", "intersect"):
            names = rest[1:1 + self.whole(rest[0], 1, 1000)]
            parts = [self.find(self.regions, name, "region") for name in names]
            return Region(style, (), place, parts=parts, outside=outside)
        if style == "mesh/tet":
            return Region(style, (), place, corners=self._tetrahedra(rest), outside=outside)
        self.refuse(
            "the importer knows block, sphere, cylinder, cone, prism, plane, union, intersect, "
            "mesh/tet", f"region {style}")

    def _tetrahedra(self, rest):
        name = rest[rest.after("file")]
        try:
            x = read_tetrahedra(self.file(name))*self.units.si("length", 1.0)
        except BadMesh as error:
            self.refuse(f"{name}: {error}", "region mesh/tet")
        x = x*self.positive(rest[rest.after("scale")])
        if "move" in rest:
            at = rest.after("move")
            x = x + numpy.array(self.numbers(rest[at:at + 3], "length"))
        if "rotate" in rest:
            at = rest.after("rotate")
            if any(self.numbers(rest[at:at + 3])):
                self.refuse("a rotation of mesh/tet is not read; rotate the file", "rotate")
        return x
