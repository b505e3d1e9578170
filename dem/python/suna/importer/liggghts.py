"""liggghts.py -- an input script of LIGGGHTS, command by command, as the state of a simulation at each `run`.

`Translation(path, report).read()` executes the script: each command changes the state, each `run` adds
a Stage with a copy of it. liggghts_fixes.py has the fixes, liggghts_scene.py makes scenes of the stages.

A command is translated, approximated, without effect on the answer, or refused: none is left out in
silence. Refusals are collected, so all faults of a script are told at once.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import copy
import math
from dataclasses import dataclass, field
from pathlib import Path

import numpy

from .liggghts_contact import Properties, read_model, tell
from .liggghts_expression import Dynamic
from .liggghts_mesh import BadMesh, read_tetrahedra, rotated
from .liggghts_particles import BadFile, Particles, read_data
from .liggghts_region import AXES, Region
from .liggghts_script import Script
from .report import CannotTranslate, Place
from .units import BASE, Units
from . import liggghts_fixes

HARMLESS = {
    "echo": "",
    "log": "",
    "print": "",
    "shell": "",
    "info": "",
    "package": "",
    "suffix": "",
    "timer": "",
    "newton": "both partners compute a pair",
    "communicate": "ghosts carry what is needed",
    "comm_modify": "",
    "comm_style": "",
    "processors": "-np of mpirun decides",
    "partition": "",
    "partitioner_style": "",
    "balance": "",
    "modify_timing": "",
    "thermo_log": "",
    "neighbor": "lists tune themselves",
    "neigh_modify": "lists tune themselves",
    "atom_modify": "",
    "thermo": "a line every ten seconds; write/energy",
    "thermo_style": "write/energy, averages",
    "compute": "output",
    "uncompute": "output",
    "compute_modify": "",
    "dump_modify": "",
    "fix_modify": "",
    "soft_particles": "maxOverlap is a setting of the scene",
    "reset_timestep": "time goes on",
    "pair_coeff": "",
    "mass": "mass follows from size and density",
    "undump": "",
    "special_bonds": "",
    "write_dump": "output",
    "hardware": "",
    "timers": "",
    "variable": ""}
LACKING = {
    "displace_atoms": "write the positions",
    "delete_atoms": "outlets take particles away during a run, and "
    "a group is placed where it is wanted",
    "minimize": "the packing is made without overlap",
    "coarsegraining": "it is parcels { ratio NUMBER; } in the scene (docs/parcels.md), with the sizes of the grains",
    "bond_style": "bonds of this package are not translated; see bondLinear in docs/effects.md",
    "bond_coeff": "bonds of this package are not translated; see bondLinear in docs/effects.md",
    "kspace_style": "Suna has no long-range forces",
    "rerun": "",
    "read_dump": "import the dump by itself"}
ATOM_STYLES = ("granular", "sphere")


@dataclass
class Wall:
    """A fix wall/gran: one primitive or some meshes."""
    name: str
    model: object
    place: object
    type: int = 0
    primitive: str = ""
    numbers: tuple = ()
    meshes: tuple = ()
    velocity: tuple = ()            # shear: of the surface
    rotation: float = 0.0           # shear of a cylinder about its axis


@dataclass
class Motion:
    kind: str                       # linear, rotate, wiggle
    values: tuple                   # SI
    start: float
    place: object
    end: float = math.inf
    name: str = ""                  # of the fix


@dataclass
class Mesh:
    name: str
    path: Path
    triangles: object
    type: int
    place: object
    scale: float = 1.0
    transformed: bool = False       # beyond `scale`
    velocity: tuple = ()
    spin: tuple = ()                # origin, axis, omega
    motions: list = field(default_factory=list)

    def at(self, time):
        """Corners at a time, and whether any motion has moved them."""
        x, moved = self.triangles, False
        for m in self.motions:
            t = min(time, m.end) - m.start
            if t <= 0:
                continue
            moved = True
            if m.kind == "linear":
                x = x + numpy.array(m.values)*t
            elif m.kind == "rotate":
                x = rotated(x, numpy.array(m.values[:3]), m.values[3:6], m.values[6]*t)
            else:
                x = x + numpy.array(m.values[:3])*math.sin(2*math.pi*m.values[3]*t)
        return x, moved


def key(state):
    """What a scene cannot change while it runs."""
    gravity = None if state["gravity"] is None else tuple(state["gravity"][0])
    return (state["model"] and state["model"].key(), state["properties"].key(), gravity,
            tuple((name, wall.place) for name, wall in state["walls"].items()),
            tuple(state["outlets"]), tuple(state["boundary"]), tuple(state["frozen"]),
            tuple(state["integrated"]), tuple(state["forces"]), tuple(state["driven"]),
            state["flat"])


@dataclass
class Stage:
    """Between the beginning and the end of one `run`."""
    start: float
    end: float
    step: float
    steps: int
    state: dict
    place: object
    fresh: bool                     # no stage before belongs to it


class Translation:
    def __init__(self, path, report, variables=(), seen=()):
        self.path, self.report, self.given, self.seen = Path(path), report, variables, seen
        self.stages, self.restarts, self.before = [], [], None
        self.clear()

    def clear(self):
        self.units, self.time, self.steps, self.step = Units(), 0.0, 0, None
        self.boundary, self.box, self.flat = ["m", "m", "m"], None, False
        self.lost = "error"
        self.properties, self.model, self.gravity = Properties(), None, None
        self.regions, self.templates, self.distributions = {}, {}, {}
        self.meshes, self.walls, self.insertions, self.fixes = {}, {}, [], {}
        self.particles, self.groups, self.integrated, self.frozen = Particles(), {}, [], []
        self.forces, self.outlets, self.interval, self.wall_interval = {}, {}, None, None
        self.fluid, self.lattice, self.fresh, self.restarted = None, None, True, None
        self.driven = {}

    # ---- the script ------------------------------------------------------------------------------

    def read(self):
        self.script = Script(self.path, self.report, self.keyword, self.given)
        for command in self.script:
            self.command = command
            try:
                self.execute(command)
            except CannotTranslate:
                pass
            except Dynamic as error:
                self.try_refuse(
                    f"{error} is known only in a run of LIGGGHTS; write its value instead")
            except (IndexError, KeyError, ValueError) as error:
                self.try_refuse(f"the words after it are not those of LIGGGHTS ({error})")
        if not self.stages:
            place = Place(str(self.path.name), self.script.place.line if self.script.place else 0)
            try:
                self.report.refuse(place, "run", "the script runs no step that can be translated")
            except CannotTranslate:
                pass
        return self

    def execute(self, command):
        method = getattr(self, "do_" + command.name, None)
        if method is not None:
            method(command.words)
        elif command.name in HARMLESS:
            self.harmless(HARMLESS[command.name])
        else:
            self.refuse(LACKING.get(command.name, "the importer does not know this command"))

    def word(self):
        c = self.command
        if c.name == "fix":
            return f"fix {c.words[2]}" + \
                (f" {c.words[3]}" if c.words[2].startswith("property") else "")
        return c.name

    def translated(self, text):
        self.report.translated(self.command.place, self.word(), text)

    def approximated(self, text, word=None):
        self.report.approximated(self.command.place, word or self.word(), text)

    def harmless(self, text="", word=None):
        self.report.harmless(self.command.place, word or self.word(), text)

    def refuse(self, text, word=None):
        self.report.refuse(self.command.place, word or self.word(), text)

    def try_refuse(self, text):
        try:
            self.refuse(text)
        except CannotTranslate:
            pass

    def keyword(self, name):
        """Thermo keywords that the script alone decides."""
        if name == "step":
            return float(self.steps)
        if name == "dt" and self.step:
            return self.step/self.units.si("time", 1.0)
        if name == "time":
            return self.time/self.units.si("time", 1.0)
        raise Dynamic(name)

    def number(self, word, kind="number"):
        value = self.script.number(word[2:]) if word.startswith("v_") else float(word)
        return self.units.si(kind, value)

    def numbers(self, words, kind="number"):
        return tuple(self.number(word, kind) for word in words)

    # ---- head of a script ------------------------------------------------------------------------

    def do_units(self, words):
        if words[0] not in BASE:
            self.refuse(f"Suna has SI units; known here: {', '.join(BASE)}", f"units {words[0]}")
        self.units = Units(words[0])
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
        self.flat = words[0] == "2"
        self.translated("domain/flat" if self.flat else "")

    def do_boundary(self, words):
        self.boundary = list(words)
        self.translated("domain")

    def do_region(self, words):
        name, style, rest = words[0], words[1], list(words[2:])
        outside = False
        while len(rest) > 2 and rest[-2] in ("units", "side", "volume_limit"):
            if rest[-2] == "units" and rest[-1] == "lattice" and self.lattice is None:
                self.refuse("units lattice without a lattice")
            outside |= rest[-2:] == ["side", "out"]
            rest = rest[:-2]
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
            parts = [self.find(self.regions, name, "region") for name in rest[1:1 + int(rest[0])]]
            return Region(style, (), place, parts=parts, outside=outside)
        if style == "mesh/tet":
            return Region(style, (), place, corners=self._tetrahedra(rest), outside=outside)
        self.refuse(
            "the importer knows block, sphere, cylinder, cone, prism, plane, union, intersect, "
            "mesh/tet", f"region {style}")

    def _tetrahedra(self, rest):
        given = dict(zip(("file",), (rest[rest.index("file") + 1],)))
        try:
            x = read_tetrahedra(self.file(given["file"]))*self.units.si("length", 1.0)
        except BadMesh as error:
            self.refuse(f"{given['file']}: {error}", "region mesh/tet")
        x = x*self.number(rest[rest.index("scale") + 1])
        if "move" in rest:
            at = rest.index("move")
            x = x + numpy.array(self.numbers(rest[at + 1:at + 4], "length"))
        if "rotate" in rest:
            at = rest.index("rotate")
            if any(self.numbers(rest[at + 1:at + 4])):
                self.refuse("a rotation of mesh/tet is not read; rotate the file", "rotate")
        return x

    def find(self, of, name, what):
        if name not in of:
            self.refuse(f"there is no {what} {name} before this line")
        return of[name]

    def file(self, name):
        """A file that the script reads, relative to its folder or to where dem import runs."""
        for folder in (self.script.path.parent, self.path.parent, Path(".")):
            if (folder/name).is_file():
                return folder/name
        self.refuse(f"there is no file {name}; give it, relative to the script's folder")

    def do_create_box(self, words):
        region = self.find(self.regions, words[1], "region")
        self.box = numpy.column_stack(region.bounds())
        self.translated("domain")

    def do_thermo_modify(self, words):
        if "lost" in words:
            self.lost = words[words.index("lost") + 1]
        self.harmless("domain/leaving" if "lost" in words else "")

    def do_timestep(self, words):
        self.step = self.number(words[0], "time")
        self.translated("time/step")

    def do_pair_style(self, words):
        style = words[0].replace("/omp", "")
        if style != "gran" or words[1] != "model":
            self.refuse("known is gran model NORMAL tangential FRICTION ...",
                        f"pair_style {' '.join(words[:2])}")
        model, rest = read_model(words[2:], self.command.place, "pair_style", self.report)
        if rest:
            self.refuse("the importer does not know this word", f"pair_style {rest[0]}")
        tell(model, self.report)
        self.model = model
        self.translated("effects")

    # ---- particles one by one --------------------------------------------------------------------

    def do_lattice(self, words):
        if words[0] not in ("sc", "sq", "fcc", "bcc", "none"):
            self.refuse("known: sc, sq, fcc, bcc", f"lattice {words[0]}")
        if len(words) > 2:
            self.refuse("orient, origin, spacing are not read; write positions",
                        f"lattice {words[2]}")
        self.lattice = None if words[0] == "none" else (words[0], self.number(words[1], "length"))
        self.translated("create_atoms")

    def do_create_atoms(self, words):
        kind = int(words[0])
        if words[1] == "single":
            x = numpy.array([self.numbers(words[2:5], "length")])
            if "units" not in words and self.lattice:
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
            self.refuse("there is no lattice before this line")
        style, a = self.lattice
        region = self.find(self.regions, words[2], "region") if words[1] == "region" else None
        low, high = (numpy.array(self.box)[:, k]
                     for k in (0, 1)) if region is None else region.bounds()
        basis = {"sc": [(0, 0, 0)], "sq": [(0, 0, 0)], "bcc": [(0, 0, 0), (.5, .5, .5)],
                 "fcc": [(0, 0, 0), (.5, .5, 0), (.5, 0, .5), (0, .5, .5)]}[style]
        axes = [numpy.arange(math.floor(lo/a) - 1, math.ceil(hi/a) + 1)
                for lo, hi in zip(low, high)]
        cells = numpy.stack(numpy.meshgrid(*axes, indexing="ij"), -1).reshape(-1, 3)
        x = numpy.concatenate([(cells + numpy.array(b))*a for b in basis])
        box = numpy.array(self.box)
        x = x[((x >= box[:, 0]) & (x < box[:, 1])).all(axis=1)]
        return x if region is None else x[region.contains(x)]

    def do_read_data(self, words):
        try:
            found, box = read_data(self.file(words[0]), self.units, self.command.place)
        except BadFile as error:
            self.refuse(f"{words[0]}: {error}")
        self.particles = found
        self.box = box if box is not None else self.box
        self.translated(f"{len(found)} particles: a table")

    def do_read_restart(self, words):
        name = words[0].split("/")[-1]
        for script in sorted(self.path.parent.iterdir()):
            if script.is_file() and script.resolve() not in self.seen and \
                    script.resolve() != self.path.resolve() and writes_restart(script, name):
                report = type(self.report)()
                self.before = type(self)(script, report, self.given,
                                         (*self.seen, self.path.resolve())).read()
                self.report.rows += [row for row in report.rows if row not in self.report.rows]
                self.take_over(self.before)
                self.translated(
                    f"the particles at the end of {script.name}, which writes this file")
                return
        self.refuse(
    "restart files of LIGGGHTS cannot be read, and no script in the folder writes this one: put "
    "the script that does beside it, or read_data a data file",
     f"read_restart {words[0]}")

    def take_over(self, other):
        """Continue from the end of another script: particles, box, time."""
        for name in ("box", "time", "steps", "particles", "insertions", "groups", "templates",
                     "distributions"):
            setattr(self, name, copy.copy(getattr(other, name)))
        self.restarted, self.fresh = other, False
        for insertion in self.insertions:
            insertion.end = min(insertion.end, self.time)

    def do_write_restart(self, words):
        self.harmless("write/snapshot")

    do_restart = do_write_restart

    def do_group(self, words):
        name, style = words[0], words[1]
        p = self.particles
        if style == "id":
            chosen = numpy.zeros(len(p), bool)
            for word in words[2:]:
                low, _, rest = word.partition(":")
                chosen |= (p.id >= int(low)) & (p.id <= int((rest or low).split(":")[0]))
        elif style == "type":
            chosen = numpy.isin(p.type, [int(word) for word in words[2:] if word.isdigit()])
        elif style == "region":
            chosen = self.find(self.regions, words[2], "region").contains(p.x)
        elif style == "empty":
            chosen = numpy.zeros(len(p), bool)
        elif style in ("union", "intersect", "subtract"):
            each = [self.chosen(other) for other in words[2:]]
            chosen = each[0]
            for other in each[1:]:
                chosen = chosen | other if style == "union" else \
                    chosen & other if style == "intersect" else chosen & ~other
        else:
            self.refuse("known: id, type, region, union, intersect, subtract, empty",
                        f"group {style}")
        self.groups[name] = p.id[chosen]
        self.translated("particles that are there")

    def chosen(self, group):
        if group == "all":
            return numpy.ones(len(self.particles), bool)
        return numpy.isin(self.particles.id, self.find(self.groups, group, "group"))

    def do_set(self, words):
        style, name, rest = words[0], words[1], list(words[2:])
        p = self.particles
        if style == "group":
            chosen = self.chosen(name)
        elif style in ("atom", "type"):
            low, _, high = name.partition("*")
            low, high = int(low or 1), int(
                high or low or 1) if "*" not in name else int(high or 10**9)
            of = p.id if style == "atom" else p.type
            chosen = (of >= low) & (of <= high)
        elif style == "region":
            chosen = self.find(self.regions, name, "region").contains(p.x)
        else:
            self.refuse("known: group, atom, type, region", f"set {style}")
        inserted = self.restarted is not None or \
            any(insertion.start <= self.time for insertion in self.insertions)
        kinds = {"diameter": "length", "density": "density", "vx": "velocity", "vy": "velocity",
                 "vz": "velocity", "omegax": "spin", "omegay": "spin", "omegaz": "spin",
                 "x": "length", "y": "length", "z": "length"}
        while rest:
            key = rest.pop(0)
            if key == "type":
                p.type[chosen] = int(rest.pop(0))
            elif key in kinds:
                value = self.number(rest.pop(0), kinds[key])
                if inserted and not self._same(key, value):
                    self.refuse(
    f"{key} of particles that fix insert/... has placed cannot be changed; write it in "
    "their template", f"set {key}")
                if key in ("diameter", "density"):
                    getattr(p, key)[chosen] = value
                else:
                    column = p.w if key.startswith("omega") else p.v if key.startswith("v") else p.x
                    column[chosen, "xyz".index(key[-1])] = value
            elif key.startswith("property/"):
                self.harmless(f"{rest.pop(0)} is read by no law that was translated", f"set {key}")
                del rest[:1]
            else:
                self.refuse(f"known: {', '.join(kinds)}, type", f"set {key}")
        self.translated("insert")

    def _same(self, key, value):
        """The inserted particles have this value anyway."""
        templates = [t for i in self.insertions for t in i.distribution.templates]
        if key == "density":
            return all(abs(t.density/value - 1) < 1e-9 for t in templates)
        return key == "diameter" and all(t.style == "constant"
                                         and abs(2*t.radius[0]/value - 1) < 1e-9 for t in templates)

    def do_velocity(self, words):
        chosen, p = self.chosen(words[0]), self.particles
        if words[1] == "set":
            for k, word in enumerate(words[2:5]):
                if word != "NULL":
                    p.v[chosen, k] = self.number(word, "velocity")
        elif words[1] == "angular":
            p.w[chosen] = self.numbers(words[2:5], "spin")
        else:
            self.refuse("known: set", f"velocity {words[1]}")
        if any(i.start <= self.time for i in self.insertions):
            self.refuse(
    "velocities of particles that fix insert/... has placed cannot be set; write vel constant "
    "in the fix")
        self.translated("insert")

    # ---- output ----------------------------------------------------------------------------------

    def do_dump(self, words):
        style = words[2]
        if style.split("/")[0] in ("custom", "atom", "xyz", "image",
                                   "local") or style.startswith("custom"):
            every = int(float(words[3]))
            if style != "local" and self.step and every > 0:
                interval = every*self.step
                self.interval = min(self.interval or math.inf, interval)
            self.translated("write/interval; particles.pvd")
        else:
            self.harmless("walls.pvd, write/walls; other meshes are not written", f"dump {style}")

    # ---- fixes, runs -----------------------------------------------------------------------------

    def do_fix(self, words):
        name, group, style = words[0], words[1], words[2].replace("/omp", "")
        if name in self.fixes:
            self._remove(name)
        liggghts_fixes.add(self, name, group, style, list(words[3:]))

    def do_unfix(self, words):
        if words[0] not in self.fixes:
            self.harmless("there is no such fix, or it was not translated")
            return
        self._remove(words[0])
        self.translated("from here on")

    def _remove(self, name):
        liggghts_fixes.remove(self, name)

    def do_clear(self, words):
        self.clear()
        self.translated("a scene of its own follows")

    def do_run(self, words):
        if self.step is None:
            self.refuse("there is no timestep before this line")
        steps = int(self.number(words[0]))
        if "upto" in words:
            steps = max(0, steps - self.steps)
        skipped = ("model", "gravity", "properties", "walls", "meshes", "boundary", "box", "lost",
                   "flat", "frozen", "integrated", "forces", "outlets", "fluid", "driven", "groups")
        state = {name: copy.copy(getattr(self, name)) for name in skipped}
        state["properties"] = self.properties.copy()
        state["particles"], state["insertions"] = self.particles, self.insertions
        state["interval"], state["wall_interval"] = self.interval, self.wall_interval
        end = self.time + steps*self.step
        last = self.stages[-1] if self.stages and not self.fresh else None
        if last and last.place == self.command.place and last.step == self.step and key(
            last.state) == key(state):
            last.end, last.steps, last.state = end, last.steps + steps, state       # a loop
        else:
            self.stages.append(Stage(self.time, end, self.step, steps, state, self.command.place,
                                     self.fresh))
        self.fresh, self.time, self.steps = False, end, self.steps + steps
        self.translated("time/end")


def writes_restart(script, name):
    """A script with `write_restart` of a file of this name. liggghts.restartCFDEM is written by the coupled run
    of a script (writeLiggghts of CFDEMcoupling)."""
    try:
        rows = [line.split() for line in script.read_text(errors="replace").splitlines()]
    except OSError:
        return False
    if "restartCFDEM" in name:
        return any(row[3:4] == ["couple/cfd"] for row in rows) and \
            not any("restartCFDEM" in word for row in rows for word in row)
    return any(row[0] == "write_restart" and row[1].split(
        "/")[-1] == name for row in rows if len(row) > 1)
