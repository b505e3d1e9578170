"""study.py -- series, levels and runs of a study; from them the errors of all quantities over their
scales, processor times, Pareto front.

Paired series (laws of friction, effects) are compared with the base run
by run, with the same steps in both: the error is the root mean square of the differences. If the
trajectories have diverged (it exceeds a quarter of the scatter of runs), the means are compared.

The processor time of a level is the time per step of its fastest run, as other work on the machine can
only add to it.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import math
from dataclasses import dataclass, field

import numpy

from . import refinement


@dataclass
class Run:
    steps: int
    seconds: float                  # processor time of the steps, all ranks
    values: dict                    # by quantity


@dataclass
class Level:
    name: str                       # "1/2"
    size: float                     # what the error goes to zero with; 1 for the scene as it is
    step: float                     # s
    runs: list = field(default_factory=list)
    failed: str = ""                # the sentence, if there are no runs
    seconds: float = math.nan       # smallest time at the level's step
    spread: float = math.nan        # largest over smallest
    error: dict = field(default_factory=dict)           # over the scale
    uncertainty: dict = field(default_factory=dict)
    worst: str = ""                 # the quantity with the largest error
    pareto: bool = False            # no other level of the series is both better and cheaper

    def measure(self, window):
        per_step = [run.seconds/run.steps for run in self.runs]
        if per_step:
            self.seconds = min(per_step)*window/self.step
            self.spread = max(per_step)/min(per_step) if min(per_step) > 0 else math.inf

    def bound(self):
        """Largest error + uncertainty of its quantities, and which; infinite without any."""
        if not self.runs or not self.worst:
            return math.inf, self.worst
        bounds = {q: e + self.uncertainty[q] for q, e in self.error.items() if math.isfinite(e)}
        of = max(bounds, key=bounds.get)
        return bounds[of], of


@dataclass
class Series:
    parameter: str                  # "step"
    description: str
    entry: str = "time/step"        # what a user changes
    exact: bool = False             # the exact solution is the scene's: closed forms hold
    paired: bool = False            # levels are compared with the base, the last one, run by run
    levels: list = field(default_factory=list)          # from coarse to fine
    base: int = -1                  # level of the scene as it is; -1: none
    without: tuple = ()             # quantities that have no error here
    analysis: dict = field(default_factory=dict)        # by quantity that is reported

    def times(self, level):
        """Its processor time over the base's."""
        return level.seconds/self.levels[self.base].seconds if self.base >= 0 else math.nan


@dataclass
class Study:
    noun: str                       # "scene" or "case"
    title: str
    window: float                   # s
    target: float
    units: dict                     # quantities, with their units
    folder: str = ""
    runs: int = 1                   # of a level
    limit: float = math.inf         # largest stable step [s]
    closed: dict = field(default_factory=dict)          # exact values by quantity
    scale: dict = field(default_factory=dict)           # of errors, in the quantity's unit
    series: list = field(default_factory=list)
    untouched: bool = False         # a contact law acts, but no contact happened in any run
    # scale of a quantity for a reference, where `scale` has none
    find_scale: object = staticmethod(lambda quantity, reference: abs(reference))

    def scale_of(self, quantity, reference):
        if not self.scale.get(quantity, 0) > 0:
            self.scale[quantity] = self.find_scale(quantity, reference)
        return self.scale[quantity]

    def evaluate(self):
        for series in self.series:
            for level in series.levels:
                level.measure(self.window)
            for quantity in self.units:
                if quantity not in series.without:
                    (self.compare if series.paired else self.converge)(series, quantity)
            for level in series.levels:
                reported = {q: e for q, e in level.error.items() if math.isfinite(e)}
                level.worst = max(reported, key=reported.get) if reported else ""
            if not series.paired:
                find_front(series.levels)

    def collect(self, series, quantity):
        """The levels that have this quantity, with their values; none if it is zero in all runs, for
        example rotation without friction."""
        found = []
        for level in series.levels:
            values = [run.values.get(quantity, math.nan) for run in level.runs]
            if values and numpy.isfinite(values).all():
                found.append((level, refinement.Level(level.size, values)))
        return found if any(part.values.any() for _, part in found) else []

    def converge(self, series, quantity):
        found = self.collect(series, quantity)
        if not found:
            return
        # the result at other stiffnesses differs from the scene's closed form; of a case it is given as
        # the exact value for all
        closed = self.closed.get(quantity) if series.exact or self.noun == "case" else None
        analysis = refinement.analyze([part for _, part in found], closed)
        scale = self.scale_of(quantity, analysis.reference)
        if not scale > 0:
            return
        series.analysis[quantity] = analysis
        for level, part in found:
            level.error[quantity] = part.error/scale
            level.uncertainty[quantity] = part.uncertainty/scale

    def compare(self, series, quantity):
        found = self.collect(series, quantity)
        if len(found) < 2 or found[-1][0] is not series.levels[series.base]:
            return
        base = found[-1][1]
        scale = self.scale_of(quantity, base.mean)
        if not scale > 0:
            return
        # so that an interval is reported
        series.analysis[quantity] = refinement.Analysis([part for _, part in found], base.mean, 0.0,
                                                        refinement.STATISTICS)
        for level, part in found:
            n = min(len(part.values), len(base.values))
            difference = part.values[:n] - base.values[:n]
            part.error, part.uncertainty = math.sqrt((difference**2).mean()), 0.0
            if 4*part.error > base.scatter > 0:     # the trajectories have diverged
                part.error = abs(difference.mean())
                part.uncertainty = refinement.half_width(difference)
            level.error[quantity] = part.error/scale
            level.uncertainty[quantity] = part.uncertainty/scale


def find_front(levels):
    for level in levels:
        level.pareto = bool(level.worst) and not any(
            other is not level and other.worst and other.seconds <= level.seconds
            and other.error[other.worst] <= level.error[level.worst] for other in levels)
