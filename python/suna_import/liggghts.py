"""liggghts.py -- an input script of LIGGGHTS, command by command, as the state of a simulation
at each `run`.

`Translation(path, report).read()` executes the script: each command changes the state, each `run`
adds a Stage with a copy of it. liggghts_head.py, liggghts_atoms.py, liggghts_restart.py and
liggghts_fixes.py have the commands, liggghts_scene.py makes scenes of the stages.

A command is translated, approximated, without effect on the answer, or refused: none is left out in
silence. Refusals are collected, so all faults of a script are told at once.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import copy
import math
from pathlib import Path

import numpy

from .liggghts_atoms import Atoms
from .liggghts_contact import Properties
from .liggghts_expression import Dynamic
from .liggghts_head import Head
from .liggghts_particles import Particles
from .liggghts_restart import Restart
from .liggghts_script import Script, is_file
from .liggghts_state import Stage, key, motions
from .liggghts_words import MOST, BadWords, as_number, as_whole
from .report import CannotTranslate, Place, collected
from .scene_text import Names
from .units import Units
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
    "partition": "another partition",
    "partitioner_style": "",
    "balance": "",
    "modify_timing": "",
    "thermo_log": "",
    "neighbor": "lists tune themselves",
    "atom_modify": "",
    "thermo": "a line every ten seconds; write/energy",
    "thermo_style": "write/energy, averages",
    "compute": "output",
    "uncompute": "output",
    "compute_modify": "",
    "dump_modify": "",
    "soft_particles": "maxOverlap is a setting of the scene",
    "hard_particles": "any Young's modulus is taken",
    "pair_coeff": "",
    "mass": "mass follows from size and density",
    "undump": "",
    "special_bonds": "",
    "write_dump": "output",
    "hardware": "",
    "timers": ""}
LACKING = {
    "displace_atoms": "write the positions",
    "delete_atoms": "outlets take particles away during a run, and "
    "a group is placed where it is wanted",
    "minimize": "the packing is made without overlap",
    "coarsegraining": "it is parcels { ratio NUMBER; } in the scene (docs/parcels.md), with the "
    "sizes of the grains",
    "bond_style": "bonds of this package are not translated; see bondLinear in docs/effects.md",
    "bond_coeff": "bonds of this package are not translated; see bondLinear in docs/effects.md",
    "kspace_style": "Suna has no long-range forces",
    "rerun": "",
    "read_dump": "import the dump by itself"}

MOST_TYPES = 1000


class Translation(Head, Atoms, Restart):
    def __init__(self, path, report, variables=(), seen=()):
        self.path, self.report, self.given, self.seen = Path(path), report, variables, seen
        self.stages, self.before, self.in_run = [], None, False
        self.faulty = set()     # (command, name) of refused lines that define something
        self.clear()

    def clear(self):
        self.units, self.time, self.steps, self.step = Units(), 0.0, 0, None
        self.boundary, self.box, self.flat = ["m", "m", "m"], None, False
        self.planar = False
        self.lost = "error"
        self.properties, self.model, self.gravities, self.drags = Properties(), None, {}, {}
        self.regions, self.templates, self.distributions = {}, {}, {}
        self.meshes, self.walls, self.insertions, self.fixes = {}, {}, [], {}
        self.particles, self.groups, self.integrated, self.frozen = Particles(), {}, [], []
        self.unknown = set()        # groups with particles of fix insert/..., known only in a run
        self.forces, self.outlets, self.dump_every, self.wall_interval = {}, {}, None, None
        self.lattice, self.fresh, self.restarted = None, True, None
        self.driven, self.heat, self.names = {}, None, Names()

    # ---- the script ------------------------------------------------------------------------------

    def read(self):
        self.script = Script(self.path, self.report, self.keyword, self.given)
        for command in self.script:
            self.command = command
            self.report.at = command.place
            defined = (command.name, command.words.get(0))
            self.faulty.add(defined)
            with collected():
                try:
                    self.execute(command)
                except Dynamic as error:
                    self.refuse(
                        f"{error} is known only in a run of LIGGGHTS; write its value instead")
                except BadWords as error:
                    self.refuse(str(error))
                self.faulty.discard(defined)
        if not self.stages and not self.is_faulty("run"):
            with collected():
                self.report.refuse(self.script.place or Place(self.path.name), "run",
                                   "the script runs no step that can be translated")
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
        if c.name != "fix":
            return c.name
        style = c.words.get(2)
        return f"fix {style}{' ' + c.words.get(3) if style.startswith('property') else ''}".rstrip()

    def translated(self, text):
        self.report.translated(self.command.place, self.word(), text)

    def approximated(self, text, word=None):
        self.report.approximated(self.command.place, word or self.word(), text)

    def harmless(self, text="", word=None):
        self.report.harmless(self.command.place, word or self.word(), text)

    def refuse(self, text, word=None):
        self.report.refuse(self.command.place, word or self.word(), text)

    def keyword(self, name):
        """Thermo keywords that the script alone decides."""
        if self.in_run and name in ("step", "time"):
            raise Dynamic(name)
        if name == "step":
            return float(self.steps)
        if name == "dt" and self.step:
            return self.step/self.units.si("time", 1.0)
        if name == "time":
            return self.time/self.units.si("time", 1.0)
        raise Dynamic(name)

    def number(self, word, kind="number"):
        if word.startswith("v_"):
            self.in_run = True          # LIGGGHTS evaluates it in each step
            try:
                value = self.script.number(word[2:])
            finally:
                self.in_run = False
        else:
            value = as_number(word)
        value = self.units.si(kind, value)
        if not math.isfinite(value):
            raise BadWords(f'"{word}" is too large')
        return value

    def numbers(self, words, kind="number"):
        return tuple(self.number(word, kind) for word in words)

    def positive(self, word, kind="number"):
        value = self.number(word, kind)
        if value <= 0:
            raise BadWords(f'"{word}" is not above 0')
        return value

    def nonzero(self, word, kind="number"):
        value = self.number(word, kind)
        if value == 0:
            raise BadWords(f'"{word}" is 0')
        return value

    def direction(self, words):
        """A vector of length 1."""
        vector = numpy.array(self.numbers(words))
        size = numpy.linalg.norm(vector)
        if not 0 < size < math.inf:
            raise BadWords(f'"{" ".join(words)}" is no direction')
        return vector/size

    def no_more(self, words):
        """The words that are left have to be `units box`."""
        if words and words != ["units", "box"]:
            raise BadWords(f'"{words[0]}" is not known here')

    def whole(self, word, low=0, high=MOST):
        text = self.script.text(word[2:]) if word.startswith("v_") else word
        return as_whole(text, low, high)

    def atom_type(self, word):
        return self.whole(word, 1, MOST_TYPES)

    def is_faulty(self, command, name=None):
        return any(command == line[0] and name in (None, line[1]) for line in self.faulty)

    def lacks(self, what, command, name=None):
        """Refuses the line because nothing defines what it needs. The line that should is refused
        itself: skips this one, whose fault may vanish with the other one."""
        if self.is_faulty(command, name):
            raise CannotTranslate(f"{what} is refused")
        self.refuse(f"there is no {what} before this line")

    def find(self, of, name, what):
        if name not in of:
            self.lacks(f"{what} {name}", what if what in ("region", "group") else "fix", name)
        return of[name]

    def file(self, name):
        """A file that the script reads, relative to its folder or to where dem import runs."""
        for folder in (self.script.path.parent, self.path.parent, Path(".")):
            if is_file(folder/name):
                return folder/name
        self.refuse(f"there is no file {name}; give it, relative to the script's folder")

    def do_neigh_modify(self, words):
        rest = words[words.after("exclude"):] if "exclude" in words else ["none"]
        frozen = {group for _, group in self.frozen}
        if rest[0] != "none" and not (rest[0] == "group" and set(rest[1:3]) <= frozen):
            self.refuse("Suna leaves no contact out, except between frozen particles; remove it, or write fix freeze "
                        "of these groups before", f"neigh_modify exclude {rest[0]}")
        self.harmless("lists tune themselves")

    # ---- output ----------------------------------------------------------------------------------

    def do_dump(self, words):
        style = words[2]
        if style.startswith("custom") or \
                style.split("/")[0] in ("atom", "xyz", "image", "local"):
            every = self.whole(words[3])
            if style != "local" and every > 0:
                self.dump_every = min(self.dump_every or every, every)
            self.translated("write/interval; particles.pvd")
        else:
            self.harmless("walls.pvd, write/walls; other meshes are not written", f"dump {style}")

    # ---- fixes, runs -----------------------------------------------------------------------------

    def do_fix(self, words):
        name, group, style = words[0], words[1], words[2].replace("/omp", "")
        if name in self.fixes:
            self._remove(name)
        liggghts_fixes.add(self, name, group, style, words[3:])

    def do_unfix(self, words):
        if words[0] not in self.fixes:
            self.harmless("there is no such fix, or it was not translated")
            return
        self._remove(words[0])
        self.translated("from here on")

    def _remove(self, name):
        liggghts_fixes.remove(self, name)

    def do_fix_modify(self, words):
        if words[1] == "integrate":
            self.translated(liggghts_fixes.hold(self, words[0], words[2]))
        else:
            self.harmless()

    def do_reset_timestep(self, words):
        self.steps = self.whole(words[0])
        self.harmless("time goes on")

    def do_clear(self, words):
        self.clear()
        self.translated("a scene of its own follows")

    @property
    def gravity(self):
        """Sum of the accelerations, and the line of the last one; None without."""
        fixes = list(self.gravities.values())
        return (numpy.sum([fix.value for fix in fixes], axis=0), fixes[-1].place) if fixes else None

    def set_steps(self):
        """Numbers of steps of the insertions that begin with this run, as times."""
        for i in self.insertions:
            if i.step is None:
                i.step, i.every = self.step, i.every + i.every_steps*self.step
                i.start = max(self.time, self.time + ((i.start_step or self.steps) - self.steps)*self.step)
            elif i.every_steps and i.step != self.step and i.end > self.time:
                self.report.refuse(i.place, f"fix insert/{i.style} insert_every", "counts steps, whose length changes "
                                   "at a later run; write insert_every_time")

    def do_run(self, words):
        if self.step is None:
            self.lacks("timestep", "timestep")
        asked = as_number(words[0], "number of steps")
        steps = as_whole(str(math.floor(asked)))
        if steps != asked:
            self.harmless(f"{steps} steps: LIGGGHTS cuts off the fraction, too")
        if "upto" in words:
            steps = max(0, steps - self.steps)
        if "every" in words and words[words.after("every") + 1:] != ["NULL"]:
            self.refuse("commands during a run are not followed; write several runs", "run every")
        self.set_steps()
        copied = ("model", "gravity", "gravities", "drags", "properties", "walls", "meshes", "boundary", "box",
                  "lost", "flat", "frozen", "integrated", "forces", "outlets", "driven", "groups", "heat")
        state = {name: copy.copy(getattr(self, name)) for name in copied}
        state["properties"] = self.properties.copy()
        state["particles"], state["insertions"] = self.particles, self.insertions
        state["interval"] = self.dump_every and self.dump_every*self.step
        state["wall_interval"] = self.wall_interval
        end = self.time + steps*self.step
        last = self.stages[-1] if self.stages and not self.fresh else None
        before = last or (self.restarted and self.restarted.stages and self.restarted.stages[-1])
        there = [i for i in self.insertions if i.start < self.time], self.particles
        if before and motions(before.state, *there) != motions(state, *there):
            self.refuse("since the last run fix freeze, fix move or the fix that integrates a group has changed, but"
                        " particles of Suna are frozen, driven or free from their insertion on; begin another script"
                        " with them, from a data file (read_data)")
        if last and last.place == self.command.place and last.step == self.step and \
                key(last.state) == key(state):
            last.end, last.steps, last.state = end, last.steps + steps, state       # a loop
        else:
            self.stages.append(Stage(self.time, end, self.step, steps, state, self.command.place,
                                     self.fresh))
        self.fresh, self.time, self.steps = False, end, self.steps + steps
        self.translated("time/end")
