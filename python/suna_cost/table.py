"""table.py -- a study as a table of runs that another program made.

One statement a line, its words separated by commas.

  title,TEXT                         first line of the report
  window,S                           simulated time of each run [s]
  target,E                           error that the best buy must not exceed [1]
  closed,QUANTITY,VALUE              exact value; reference of all series except compared ones
  series,KIND,NAME,ENTRY,TEXT        begins a series. KIND: step (one of its levels is the best buy),
                                     limit (the error of another model parameter, which no step
                                     removes), compared (changes against its last level, run by
                                     run). ENTRY: what a user changes. TEXT: description
  level,NAME,BASE,SIZE,STEP          begins a level of it, from coarse to fine. BASE 1: the case as it
                                     is. SIZE: what the error goes to zero with. STEP [s]
  run,STEPS,SECONDS                  begins a run of it: steps in the window, processor time
  value,QUANTITY,UNIT,SCALE,VALUE    of this run; errors are divided by SCALE, or by the reference if
                                     that is 0
  failed,TEXT                        the sentence of a level without runs

SPDX-License-Identifier: GPL-3.0-or-later
"""
import math

from suna.command import Refused

from .study import Level, Run, Series, Study

WORDS = {"title": 2, "window": 2, "target": 2, "closed": 3, "series": 5, "level": 5, "run": 3,
         "value": 5, "failed": 2}


class Reader:
    def __init__(self, path):
        self.path, self.line = path, 0
        self.study = Study("case", "", 0.0, 0.01, {}, runs=0)

    def refuse(self, what):
        raise Refused(f"{self.path}, line {self.line}: {what}")

    def number(self, statement, text, least):
        try:
            value = float(text)
        except ValueError:
            value = math.nan
        if not (math.isfinite(value) and value >= least):
            self.refuse(f'"{text}" where {statement} has a number of at least {least:g}')
        return value

    def level(self, what):
        if not self.study.series or not self.study.series[-1].levels:
            self.refuse(f"{what} without a level")
        return self.study.series[-1].levels[-1]

    def read(self, text):
        statement = text.split(",", 1)[0]
        if statement not in WORDS:
            self.refuse("begins with none of " + ", ".join(WORDS))
        words = text.split(",", WORDS[statement] - 1)[1:]
        if len(words) < WORDS[statement] - 1:
            self.refuse(f"{len(words) + 1} words where {statement} has {WORDS[statement]}")
        getattr(self, "read_" + statement)(*words)

    def read_title(self, text):
        self.study.title = text

    def read_window(self, text):
        self.study.window = self.number("window", text, 1e-300)

    def read_target(self, text):
        self.study.target = self.number("target", text, 1e-12)

    def read_closed(self, quantity, value):
        self.study.units.setdefault(quantity, "1")
        self.study.closed[quantity] = self.number("closed", value, -math.inf)

    def read_series(self, kind, name, entry, text):
        if kind not in ("step", "limit", "compared"):
            self.refuse(f'a series of kind "{kind}"; give step, limit or compared')
        self.study.series.append(Series(name, text, entry, kind == "step", kind == "compared"))

    def read_level(self, name, base, size, step):
        if not self.study.series:
            self.refuse("a level without a series")
        levels = self.study.series[-1].levels
        levels.append(Level(name, self.number("level", size, 1e-300),
                            self.number("level", step, 1e-300)))
        if self.number("level", base, 0.0) > 0:
            self.study.series[-1].base = len(levels) - 1
        if len(levels) > 1 and levels[-1].size >= levels[-2].size:
            self.refuse(f"level {name} of size {levels[-1].size:g} after {levels[-2].size:g}; from "
                        "coarse to fine the size falls")

    def read_run(self, steps, seconds):
        runs = self.level("a run").runs
        runs.append(Run(int(self.number("run", steps, 1.0)), self.number("run", seconds, 0.0), {}))
        self.study.runs = max(self.study.runs, len(runs))

    def read_value(self, quantity, unit, scale, value):
        if not self.level("a value").runs:
            self.refuse("a value without a run")
        self.study.units[quantity] = unit
        self.study.scale[quantity] = self.number("value", scale, 0.0)
        self.level("a value").runs[-1].values[quantity] = self.number("value", value, -math.inf)

    def read_failed(self, text):
        level = self.level("a failure")
        level.runs, level.failed = [], text

    def check(self):
        if not self.study.window > 0 or not self.study.series:
            raise Refused(f"{self.path}: no window or no series")
        for series in self.study.series:
            base = series.levels[series.base] if series.base >= 0 else None
            if base is None or not base.runs:
                raise Refused(f"{self.path}: series {series.parameter} lacks the case as it is"
                              + (f", which failed: {base.failed}" if base else ""))
            if series.paired and (base is not series.levels[-1] or any(
                    level.runs and len(level.runs) != len(base.runs) for level in series.levels)):
                raise Refused(f"{self.path}: series {series.parameter} is compared run by run; give "
                              "the case as it is last, and as many runs in all levels")


def read_study(path):
    """The study in a table."""
    reader = Reader(path)
    try:
        with open(path) as file:
            for text in file:
                reader.line += 1
                reader.read(text.rstrip("\n"))
    except OSError as error:
        raise Refused(f"cannot read {path}: {error.strerror}") from None
    reader.check()
    return reader.study
