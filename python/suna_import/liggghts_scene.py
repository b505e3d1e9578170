"""liggghts_scene.py -- scenes of Suna from the stages of a script of LIGGGHTS.

Stages that follow each other are one scene as long as what changes between them has a time in a
scene: insertions that begin or end, one motion of a mesh. Another change (a wall added or removed,
another material, a second motion) begins a new scene that continues from the snapshot of the one
before.

Particles, walls, motions and streams have the time of the script, so a scene of a series is
the whole script from its own beginning on.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import math
import os
import shlex

import numpy

from .liggghts_scene_laws import Laws
from .liggghts_scene_particles import Groups
from .liggghts_scene_time import Times
from .liggghts_scene_walls import Walls
from .liggghts_state import acting, key
from .report import CannotTranslate
from .scene_text import Names, SceneText, as_name, text, vector


# ---- stages of one scene -----------------------------------------------

def one_motion(stages):
    start, end = stages[0].start, stages[-1].end
    return all(sum(m.start < end and m.end > start for m in mesh.motions) <= 1
               for mesh in stages[0].state["meshes"].values())


def series(translation, report):
    """Lists of stages, one for each scene."""
    stages = [s for s in translation.stages if s.steps > 0] or translation.stages[-1:]
    found = []
    for stage in stages:
        last = found[-1] if found and not stage.fresh else None
        if last and last[-1].steps <= 1 and len(last) == 1 and \
                key(last[0].state) != key(stage.state):
            report.harmless(last[0].place, "run", "the single step before other commands is part "
                            "of the scene that follows")
            stage.start, stage.fresh = last[0].start, last[0].fresh
            found[-1] = [stage]
        elif last and key(last[0].state) == key(stage.state) and one_motion([*last, stage]):
            last.append(stage)
        else:
            found.append([stage])
    return found


# ---- one scene ---------------------------------------------------------

class SceneMaker(Laws, Walls, Groups, Times):
    """One scene of a translation. `stages`: its stages; `name`: path without .dem; `restart`: the
    snapshot that it continues from, or empty."""

    def __init__(self, translation, stages, name, restart, report):
        self.t, self.stages, self.name, self.report = translation, stages, name, report
        self.state, self.start, self.end = stages[-1].state, stages[0].start, stages[-1].end
        self.restart, self.scene = restart, SceneText()
        self.materials, self.names = {}, Names()
        self.box = self.state["box"]

    def refuse(self, place, word, sentence):
        self.report.refuse(place, word, sentence)

    def lacks(self, place, word, sentence):
        """Refuses, unless a refused line may define what is missing here."""
        if self.t.faulty:
            raise CannotTranslate(sentence)
        self.refuse(place, word, sentence)

    def make(self):
        if self.state["model"] is None:
            self.refuse(self.stages[0].place, "run", "there is no pair_style gran before this line")
        self.particles = self.state["particles"]
        self.insertions = [i for i in self.state["insertions"] if i.start < self.end]
        self.check_heat()
        self.check_groups()
        self.find_materials()
        self.add_walls()
        self.add_domain()
        self.add_insert()
        self.add_outlets()
        self.add_forces()
        self.add_fluid()
        self.add_contacts()
        self.add_time()
        return self.scene

    def check_heat(self):
        """Temperatures begin with the particles: a snapshot without them has Suna's default."""
        heat, stages = self.state["heat"], self.t.stages
        k = stages.index(self.stages[0])
        before = stages[k - 1] if k else self.t.before.stages[-1] if self.t.before else None
        if heat and self.restart and before.state["heat"] is None:
            self.refuse(heat.place, "fix heat/gran", "begins after a run, and the snapshot has no "
                        "temperatures; write it before the first run")

    def check_groups(self):
        """Gravity, drag and walls of Suna act on all particles that move freely."""
        _, _, driven, frozen = self.states()
        for fix in acting(self.state):
            free = ~(driven | frozen | self.member(fix.group))
            if fix.group != "all" and (free.any() or not all(
                    i.group == fix.group or self.is_frozen(i.group) for i in self.insertions)):
                self.refuse(fix.place, f"group {fix.group}", "the fix acts on this group only, but in Suna it acts on "
                            "all particles that move freely; write all, or import the group by itself")

    def new_file(self, ending):
        """Path of a file beside the scene, a name with a dot and its kind."""
        name, _, kind = ending.rpartition(".")
        return f"{self.names.free('files', self.name + '_' + as_name(name))}.{kind}"

    def add_domain(self):
        if self.box is None:
            return
        limited = [k for k in range(3) if self.state["boundary"][k][0] in "pf"]
        flat = self.state["flat"]
        entries = []
        for k in range(3):
            if k in limited or flat and k == 2:
                entries.append(f"{'xyz'[k]} {vector(self.box[k])};")
        periodic = ["xyz"[k] for k in range(3)
                    if self.state["boundary"][k][0] == "p" and not (flat and k == 2)]
        if periodic:
            entries.append(f"periodic ({' '.join(periodic)});")
        if flat:
            entries.append("flat (z);")
        if len(periodic) < len(limited) and self.state["lost"] in ("ignore", "warn"):
            entries.append("leaving remove;")
        for entry in entries:
            self.scene.add("domain", entry)

    def add_outlets(self):
        for name, (point, normal, place) in self.state["outlets"].items():
            self.scene.named("outlets", as_name(name),
                             f"point {vector(point)}; normal {vector(normal)};", place)

    def add_forces(self):
        for name, (group, kind, values, place) in self.state["forces"].items():
            ids = ""
            if group != "all":
                chosen = self.state["groups"].get(group, ())
                if len(chosen) == 0:
                    self.lacks(place, f"fix {name}",
                               f"group {group} has no particles of create_atoms or read_data; a force on chosen "
                               "particles needs their ids")
                ids = f"ids ({' '.join(map(str, chosen))}); "
            self.scene.named("forces", as_name(name), f"{ids}{kind} {vector(values)};", place)

    def add_fluid(self):
        drags = list(self.state["drags"].values())
        if not drags:
            return
        gamma, place = sum(fix.value for fix in drags), drags[-1].place
        if any(i.has_clumps() for i in self.insertions):
            self.refuse(place, "fix viscous", "LIGGGHTS drags each sphere of a clump, Suna the clump; remove the fix")
        sizes = {round(2*t.range()[k], 15) for i in self.insertions
                 for t in i.distribution.templates for k in (0, 1)}
        sizes |= set(numpy.round(self.particles.diameter, 15))
        if len(sizes) != 1:
            refuse = self.refuse if sizes else self.lacks
            refuse(place, "fix viscous",
                   "stokesDrag grows with the diameter: it is the same only for one size")
        self.scene.add("effects", "stokesDrag {}", place)
        self.scene.add("fluid", f"density 1e-6; viscosity {text(gamma/(3*math.pi*sizes.pop()))};",
                       place)


# ---- all scenes of a script --------------------------------------------

def write_scenes(translation, output, report):
    """Write the scenes; returns the names of the files and the commands that run them."""
    if translation.before is not None:
        folder = os.path.dirname(output)
        own = as_name(translation.before.path.name.removeprefix("in."))
        first = os.path.join(folder, own + ".dem")
        files, commands = write_scenes(translation.before, first, report)
        snapshot = f"{os.path.splitext(os.path.basename(files[-1]))[0]}/snapshot.dem"
    else:
        files, commands, snapshot = [], [], ""
    stem = output.removesuffix(".dem")
    groups = series(translation, report)
    made = []
    for k, stages in enumerate(groups):
        name = stem if len(groups) == 1 else f"{stem}_{k + 1}"
        restart = "" if stages[0].fresh else snapshot
        try:
            maker = SceneMaker(translation, stages, name, restart, report)
            made.append((name, restart, maker.make()))
        except CannotTranslate:
            pass
        snapshot = f"{os.path.basename(name)}/snapshot.dem"
    report.raise_refused()
    for name, restart, scene in made:
        command = shlex.join(["dem", "run", *(["-restart", restart] if restart else []), os.path.relpath(name + ".dem")])
        head = [f"// {os.path.basename(name)}.dem, translated from "
                f"{os.path.relpath(translation.path)} by dem import.",
                f"// Run where this was made: {command}", *report.comment()]
        with open(name + ".dem", "w") as file:
            file.write(scene.text(head))
        files.append(name + ".dem")
        commands.append(command)
    return files, commands
