"""scene.py -- the study of a scene of the program dem: its window, its series, and the runs of their
levels, each from a fresh start of the scene.

Nothing is written by the runs, and there is no energy balance. The processor time covers the
steps, with neighbor lists and migration; reading the scene and sampling are not counted. Impulses on
walls are summed only if forces on walls are reported.

Scales of errors: in general the reference value. Kinetic energy: at least 1e-6 of the energy of a
fall by one diameter (untilQuiet's criterion for rest), so that noise at rest is not an error.
Rotation: at least the target error times the scale of the kinetic energy, so that a trace of spin is
not one. Height: the mean diameter. Contacts: at least one for each particle. Restitution: 1.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import math
import sys
import time

import numpy

from suna import Simulation, SunaError
from suna.command import Refused

from .closed_forms import closed_forms, find_impact, vector
from .study import Level, Run, Series, Study

UNITS = {"kinetic": "J", "rotation": "J", "height": "m", "overlap": "1", "force": "N",
         "contacts": "1", "restitution": "1"}
NORMAL, TANGENT = ("hertz", "hooke", "hookeHysteresis"), ("linear", "mindlin", "mindlinIncremental")
FRICTION = ("friction", "tangentialDamping", "adhesion")        # settings that all laws have
SERIES = ("step", "stiffness", "friction")
ON_REQUEST = ("parcels",)           # series that are run only if they are named
MAX_SAMPLES = 32
MIN_STEPS, SAMPLE_STEPS = 10, 40    # of the coarsest level: in the window, between two samples


class Alone:
    """In place of a communicator: one rank."""

    rank, size = 0, 1

    def sum(self, value):
        return value


class Together:
    """The ranks of a communicator of mpi4py."""

    def __init__(self, comm):
        self.comm, self.rank, self.size = comm, comm.rank, comm.size

    def sum(self, value):
        return self.comm.allreduce(value)


class SceneStudy:
    """Options as the command has them: window, budget, runs, target, of, series, effects, steps,
    stiffnesses; settings: (path, value); restart: a snapshot."""

    def __init__(self, scene, options, settings, restart, ranks):
        self.scene, self.options, self.restart = scene, options, restart
        self.settings, self.ranks = dict(settings), ranks
        self.comm = getattr(ranks, "comm", None)
        self.wanted = () if options.effects else options.series or SERIES
        self.read()

    # ---- the scene as it is ----------------------------------------------------------------------

    def open(self, settings=None, without=None):
        return Simulation(self.scene, {**self.settings, **(settings or {})}, self.restart,
                          self.comm, without=without).setup()

    def read(self):
        sim, o = self.open(), self.options
        totals, end = sim.totals, sim.value("time/end")
        if not totals["particles"]:
            raise Refused("the scene has no particles at its start; begin with -restart from a "
                          "snapshot that has some")
        g = vector(sim.value("effects/gravity/acceleration") or "0 0 0")
        self.up = -g/numpy.linalg.norm(g) if g.any() else g
        self.from_snapshot = self.restart is not None or "start" in sim.names()
        if self.from_snapshot and o.series and "stiffness" in o.series:
            raise Refused("-series stiffness from a snapshot, whose overlaps belong to its own "
                          "stiffness: with another one the bed would expand or sink; leave it out, "
                          "or begin at the scene's start")
        if end is None:
            raise Refused("the scene has no time/end; give one, or -set time/end=1")
        self.start, self.end = totals["time"], float(end)
        self.step, self.limit, _ = sim.step
        self.fall, self.particles = totals["fall_energy"], totals["particles"]
        self.diameter = (6*totals["volume"]/(math.pi*self.particles))**(1/3)
        if not self.end > self.start:
            raise Refused(f"the snapshot is of {self.start:g} s, not before time/end {self.end:g} s; "
                          "give a later end")
        if o.window and o.window > (self.end - self.start)*(1 + 1e-12):
            raise Refused(f"-window {o.window:g} s is longer than the {self.end - self.start:g} s to "
                          "time/end; give at most that, or a later end with -set time/end")
        self.impact = find_impact(sim) if self.ranks.size == 1 else None
        self.choose_quantities(sim)
        self.closed = {q: x for q, x in closed_forms(sim, self.impact).items() if q in self.units}
        self.ended_in_contact = False       # a run, in which an impact is not over
        self.touched = False                # bodies, in one of the runs
        self.acting = sim.effects
        self.find_moduli(sim)
        self.find_friction(sim)
        if o.series and "parcels" in o.series:
            self.check_parcels(sim, totals)
        sim.close()

    def choose_quantities(self, sim):
        lacking = {
            "height": (not self.up.any(), "the scene has no gravity, so no height"),
            "force": (not sim.walls, "the scene has no walls"),
            "restitution": (self.impact is None, "for two bodies in head-on impact without other "
                            "forces, on one rank"),
            "contacts": (self.particles <= 2, "for scenes of more than two particles")}
        for quantity, (lacks, reason) in lacking.items():
            if lacks and self.options.of and quantity in self.options.of:
                raise Refused(f"-of {quantity}: {reason}; leave it out")
        self.units = {q: unit for q, unit in UNITS.items()
                      if not lacking.get(q, (False,))[0] and q in (self.options.of or UNITS)}

    def find_moduli(self, sim):
        """All Young's moduli, and the stiffness of the normal law if the scene gives one."""
        self.moduli = {}
        for name in sim.names("materials"):
            path = f"materials/{name}/youngsModulus"
            self.moduli[path] = float(sim.value(path))
        for law in NORMAL:
            value = sim.value(f"effects/{law}/stiffness")
            if value is not None:
                self.moduli[f"effects/{law}/stiffness"] = float(value)

    def find_friction(self, sim):
        """The scene's law of friction with the settings that all laws have; None: none, or not the
        same for all pairs."""
        self.friction, effects = None, sim.names("effects")
        for law in TANGENT:
            if law in effects and "pairs" not in sim.names():
                found = {name: sim.value(f"effects/{law}/{name}") for name in FRICTION}
                self.friction = law, {k: v for k, v in found.items() if v is not None}
        if self.friction is None and self.options.series and "friction" in self.options.series:
            raise Refused("-series friction: the scene has no law of friction, or settings of its "
                          "own for some pairs; leave it out")

    def check_parcels(self, sim, totals):
        """The ratio of the scene; one level must have the mass of another."""
        if self.from_snapshot:
            raise Refused("-series parcels from a snapshot, whose particles have their sizes; leave it "
                          "out, or begin at the scene's start")
        self.ratio = float(sim.value("parcels/ratio") or 1)
        if min(self.options.parcels)*self.ratio < 1:
            raise Refused(f"-parcels {min(self.options.parcels):g} times the scene's ratio "
                          f"{self.ratio:g} is below single grains; give larger levels")
        with self.open(self.parcel_settings(self.options.parcels[0])) as other:
            coarse = other.totals["mass"]
        if not 0.95*totals["mass"] < coarse < 1.05*totals["mass"]:
            raise Refused(f"-series parcels: the coarsest level has {coarse:.4g} kg, the scene "
                          f"{totals['mass']:.4g} kg, so they are no longer the same bed; give mass "
                          "or solidFraction in insert, not count or positions")

    def parcel_settings(self, level):
        return {"parcels/ratio": level*self.ratio}

    # ---- one run ---------------------------------------------------------------------------------

    def run(self, steps, settings=None, without=None):
        """One run of the window in samples*steps equal steps."""
        between = self.window/self.samples
        # slightly longer than wanted: advance divides the interval into the wanted number of steps
        sim = self.open({"time/step": between/steps*(1 + 1e-10), "time/force": True,
                         **(settings or {})}, without)
        with_walls = "force" in self.units
        sums = dict.fromkeys(UNITS, 0.0)
        force = seconds = 0.0
        if with_walls:
            sim.reset_impulses()
        totals = sim.totals         # resets the largest overlap
        for _ in range(self.samples):
            began = time.process_time()
            sim.advance(between)
            seconds += time.process_time() - began
            totals = sim.totals
            moving, m = ~sim.frozen, sim.mass
            rotation = 0.2*(m*sim.radius**2*(sim.spin**2).sum(axis=1)).sum()
            height, mass = (m[moving]*(sim.position[moving] @ self.up)).sum(), m[moving].sum()
            rotation, height, mass = (self.ranks.sum(x) for x in (rotation, height, mass))
            sums["kinetic"] += totals["kinetic"]
            sums["rotation"] += rotation
            sums["height"] += height/mass if mass > 0 else 0.0
            sums["overlap"] += totals["largest_overlap"]
            sums["contacts"] += 2*totals["contacts"]/max(totals["particles"], 1)
            if with_walls:
                force = max([force] + [numpy.linalg.norm(wall.impulse[0])/between
                                       for wall in sim.walls.values()])
                sim.reset_impulses()
        self.ended_in_contact |= totals["contacts"] > 0
        self.touched |= sums["overlap"] > 0 or sums["contacts"] > 0
        values = {q: x/self.samples for q, x in sums.items() if q in self.units}
        if with_walls:
            values["force"] = force
        if "restitution" in self.units:
            separation = self.impact.separation(sim) if totals["contacts"] == 0 else 0.0
            values["restitution"] = separation/self.impact.speed if separation > 0 else math.nan
        sim.close()
        return Run(steps*self.samples, self.ranks.sum(seconds), values)

    # ---- the window ------------------------------------------------------------------------------

    def wants_stiffness(self):
        # its overlaps belong to its own stiffness; without a step limit no contact is stiff; the
        # result of a head-on impact does not depend on stiffness
        return ("stiffness" in self.wanted and not self.from_snapshot
                and self.limit < sys.float_info.max
                and (self.impact is None or bool(self.options.series)))

    def relative_cost(self):
        """Processor time of all series in units of one run of the window of the scene as it is."""
        o = self.options
        if o.effects:
            return o.runs*(len(self.acting) + 1)
        total = sum(1/x for x in o.steps) if "step" in self.wanted else 0.0
        # number of steps: contact time ~ E^-0.4
        total += sum(x**0.4 for x in o.stiffnesses) if self.wants_stiffness() else 0.0
        # number of parcels, and of steps
        total += sum(x**-4 for x in o.parcels) if "parcels" in self.wanted else 0.0
        total += 3.0 if "friction" in self.wanted and self.friction else 0.0
        return o.runs*total

    def affordable_window(self, span):
        """The window that the budget allows. Later steps may cost more than the first ones (a bed
        forms), so repeat with the result."""
        steps = min(200.0, span/self.step)
        for k in range(3):
            many = math.ceil(steps)
            self.samples, self.window = 1, many*self.step
            second = self.run(many).seconds/many
            if self.comm is not None:
                second = self.comm.bcast(second)
            affordable = min(span/self.step,
                             self.options.budget/self.relative_cost()/max(second, 1e-9))
            if k > 0 and affordable >= 0.8*steps:
                break
            steps = affordable
        return min(span, steps*self.step)

    def choose_window(self):
        """The window of the options, or the one that the budget allows."""
        o = self.options
        window = o.window or self.affordable_window(self.end - self.start)
        coarsest = max(1.0, o.steps[0] if "step" in self.wanted else 1.0,
                       o.parcels[0] if "parcels" in self.wanted else 1.0)
        steps = window/self.step/coarsest
        if steps < MIN_STEPS:
            raise Refused(f"a window of {window:.3g} s has only {steps:.3g} steps of the coarsest "
                          "level; give a longer -window, a larger -budget, or finer levels")
        self.window = window
        self.samples = 1 if self.impact else int(max(1, min(MAX_SAMPLES, steps//SAMPLE_STEPS)))

    # ---- levels, series --------------------------------------------------------------------------

    def level(self, name, size, step, settings=None, without=None):
        """Runs of a level: with up to 4 % more and fewer steps, at least one step apart. A run that
        fails ends the level, and its sentence is kept."""
        level, runs = Level(name, size, step), self.options.runs
        steps = max(1, round(self.window/self.samples/step))
        spacing = max(1, round(0.08*steps/max(1, runs - 1)))
        for k in range(runs):
            try:
                level.runs.append(self.run(max(1, steps + spacing*(k - (runs - 1)//2)), settings,
                                           without))
            except SunaError as error:
                level.runs, level.failed = [], str(error)
                break
        if self.ranks.rank == 0 and sys.stderr.isatty():
            print(".", end="", file=sys.stderr, flush=True)
        return level

    def finer(self, series):
        """A level of half the finest step."""
        size = series.levels[-1].size/2
        return self.level(f"{size:.4g}", size, self.step*size)

    def steps(self):
        steps = self.options.steps
        return Series("step", "time step, in steps of the scene as it is", exact=True,
                      levels=[self.level(f"{x:.4g}", x, self.step*x) for x in steps],
                      base=steps.index(1.0))

    def stiffnesses(self):
        """The step over its limit is the same in all levels, so the error of the step is much the
        same in all. Soft first."""
        series = Series("stiffness", "stiffness over the scene's; errors against hard spheres",
                        without=("overlap",))       # hard spheres have none
        for k, x in enumerate(sorted(self.options.stiffnesses)):
            settings = {} if x == 1 else {path: x*e for path, e in self.moduli.items()}
            with self.open({"time/step": "auto", **settings}) as sim:
                size = sim.step[1]/self.limit
            series.levels.append(self.level(f"{x:.4g}", size, self.step*size, settings))
            series.base = k if x == 1 else series.base
        return series

    def frictions(self):
        """The scene's own law comes last: the others are compared with it."""
        own, settings = self.friction
        levels = [self.level(law, 18.0 - k, self.step,
                             {f"effects/{law}/{name}": x for name, x in settings.items()}, own)
                  for k, law in enumerate(law for law in TANGENT if law != own)]
        levels.append(self.level(own, 1.0, self.step))
        return Series("friction", "law of friction, with the same settings; changes against the "
                      "scene's", levels=levels, base=len(levels) - 1, paired=True)

    def parcels(self):
        """The step over its limit is the same in all levels. The finest last: the others are compared
        with it."""
        series = Series("parcels", "ratio of parcels over the scene's; changes against the finest",
                        "parcels/ratio", paired=True, without=("restitution",))
        for x in self.options.parcels:
            settings = self.parcel_settings(x) if x != 1 or self.ratio != 1 else {}
            with self.open({"time/step": "auto", **settings}) as sim:
                size = sim.step[1]/self.limit
            series.levels.append(self.level(f"{x:.4g}", x, self.step*size, settings))
        series.base = len(series.levels) - 1
        return series

    def effects(self):
        levels = [self.level(name, 40.0 - k, self.step, without=name)
                  for k, name in enumerate(self.acting)]
        levels.append(self.level("all", 1.0, self.step))
        return Series("effects", "without each effect in turn; changes against the scene as it is",
                      levels=levels, base=len(levels) - 1, paired=True)

    # ---- the study -------------------------------------------------------------------------------

    def find_scale(self, study):
        def scale(quantity, reference):
            size = abs(reference)
            return {"kinetic": max(size, 1e-6*self.fall),
                    "rotation": max(size, study.target*study.scale.get("kinetic", 0.0)),
                    "height": self.diameter, "restitution": 1.0,
                    "contacts": max(size, 1.0)}.get(quantity, size)
        return scale

    def study(self):
        """Makes all runs; after choose_window."""
        o, series = self.options, []
        if o.effects:
            series.append(self.effects())
        if "step" in self.wanted:
            series.append(self.steps())
        if self.wants_stiffness():
            series.append(self.stiffnesses())
        if "friction" in self.wanted and self.friction:
            series.append(self.frictions())
        if "parcels" in self.wanted:
            series.append(self.parcels())
        closed = {} if self.ended_in_contact else self.closed
        study = Study("scene", "", self.window, o.target, self.units, runs=o.runs, limit=self.limit,
                      closed=closed, series=series,
                      untouched=not self.touched and any(law in self.acting for law in NORMAL))
        study.find_scale = self.find_scale(study)
        study.title = (
            f"cost of {self.scene}: a window of {self.window:.4g} s from {self.start:.4g} s on, of "
            f"{self.end - self.start:.4g} s to time/end; {self.window/self.step:.0f} steps of "
            f"{self.step:.4g} s; {o.runs} runs of each level, {self.samples} "
            f"sample{'s' if self.samples > 1 else ''}")
        return study
