"""liggghts_state.py -- what a script of LIGGGHTS has defined: walls, meshes and their motion; a
Stage is the state during one `run`.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import math
from dataclasses import dataclass, field
from pathlib import Path

import numpy

from .liggghts_mesh import rotated


@dataclass
class Wall:
    """A fix wall/gran: one primitive or some meshes."""
    name: str
    model: object
    place: object
    group: str = "all"
    type: int = 0
    primitive: str = ""
    numbers: tuple = ()
    meshes: tuple = ()
    velocity: tuple = ()            # shear: of the surface
    temperature: float = 0.0        # K; 0: none
    area: str = "overlap"           # of a contact that conducts

    def key(self):
        return (self.name, self.model.key(), self.group, self.type, self.primitive, self.numbers, self.meshes,
                self.velocity, self.temperature, self.area)


@dataclass
class Action:
    """A fix gravity or fix viscous."""
    group: str
    value: object                   # m/s2; kg/s
    place: object


@dataclass
class Motion:
    kind: str                       # linear, rotate, wiggle, servo, free
    values: object                  # SI; a dict for free, else a tuple
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
    temperature: float = 0.0        # K; 0: none
    wears: bool = False             # by Finnie's law
    motions: list = field(default_factory=list)

    def key(self):
        """What does not change with its motion; that is of this mesh, not of one that replaces it."""
        return (self.name, self.triangles.tobytes(), self.type, self.velocity, self.spin, self.temperature,
                self.wears, id(self) if self.motions else 0)

    def at(self, time):
        """Corners at a time, and whether any motion has moved them."""
        x, moved = self.triangles, False
        for m in self.motions:
            t = min(time, m.end) - m.start
            if t <= 0 or m.kind in ("servo", "free"):     # where the load has moved it is not known
                continue
            moved = True
            if m.kind == "linear":
                x = x + numpy.array(m.values)*t
            elif m.kind == "rotate":
                x = rotated(x, numpy.array(m.values[:3]), m.values[3:6], m.values[6]*t)
            else:
                x = x + numpy.array(m.values[:3])*math.sin(2*math.pi*m.values[3]*t)
        return x, moved


def motions(state, insertions, particles):
    """Whether the particles of these insertions, and single ones, are integrated, frozen and driven."""
    def of_group(group):
        def named(fixes):
            return [speed for g, speed in fixes if g in ("all", group)]
        return (bool(named((g, 1) for _, g in state["integrated"])), bool(named((g, 1) for _, g in state["frozen"])),
                [list(speed) for speed in named(state["driven"].values())])

    def member(group):
        return numpy.ones(len(particles), bool) if group == "all" else numpy.isin(
            particles.id, state["groups"].get(group, ()))

    def any_of(groups):
        return numpy.any([numpy.zeros(len(particles), bool), *map(member, groups)], axis=0).tolist()
    return ([of_group(i.group) for i in insertions], any_of(g for _, g in state["integrated"]),
            any_of(g for _, g in state["frozen"]),
            [(member(g).tolist(), list(speed)) for g, speed in state["driven"].values()])


def acting(state):
    """The fixes that act on a group, apart from what moves or forces it."""
    return [*state["gravities"].values(), *state["drags"].values(), *state["walls"].values()]


def key(state):
    """What a scene cannot change while it runs: all that the fixes of a run say, not where their lines stand."""
    groups = {fix.group for fix in acting(state)} | {group for group, *_ in state["forces"].values()}
    said = {
        "model": state["model"] and state["model"].key(),
        "properties": state["properties"].key(),
        "gravity": [list(fix.value) for fix in state["gravities"].values()],
        "drag": [fix.value for fix in state["drags"].values()],
        "on": [fix.group for fix in acting(state)],
        "groups": {name: list(state["groups"].get(name, ())) for name in groups},
        "walls": [wall.key() for wall in state["walls"].values()],
        "meshes": [state["meshes"][name].key() for wall in state["walls"].values() for name in wall.meshes],
        "outlets": [(name, list(point), list(normal)) for name, (point, normal, _) in state["outlets"].items()],
        "forces": [(name, *force[:3]) for name, force in state["forces"].items()],
        "heat": state["heat"] and state["heat"].key()}
    return said, *(state[name] for name in ("boundary", "lost", "flat", "frozen", "integrated", "driven"))


@dataclass(eq=False)
class Stage:
    """Between the beginning and the end of one `run`."""
    start: float
    end: float
    step: float
    steps: int
    state: dict
    place: object
    fresh: bool                     # no stage before belongs to it
