"""case_study.py -- the study of an OpenFOAM case with particles: a window of copies of it over refinement
series of the interval of exchange (the fluid's step), DEM step, kernel, its width, mesh and
stiffness.

Each run is a copy of the case with settings appended to its dictionaries; the case is never changed.
A run's step is such that samples lie on steps. The processor time covers the steps; the first
one, which includes the start of the run, counts as the mean of the others.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import json
import math
import re
import shutil
import subprocess
import sys
from dataclasses import dataclass, replace
from pathlib import Path

from suna.command import Refused

from .case import call, finer, patches
from .case_results import failure_reason, processor_time, result_values
from .study import Level, Run, Series, Study

UNITS = {"kinetic": "m2/s2", "height": "m", "level": "m", "overlap": "1", "void": "1", "force": "N",
         "drop": "m2/s2"}
SERIES = ("interval", "step", "kernel", "width", "mesh", "stiffness")
MAX_SAMPLES, SAMPLE_STEPS, MIN_STEPS = 32, 12, 4    # steps of the coarsest level
WITH_WIDTH = ("diffusion", "gaussian")
NO_COPY = re.compile(r"[0-9.e-]+|processor.*|log.*|postProcessing|.*\.cost|.*\.orig")


@dataclass(frozen=True)
class Variant:
    """A run's settings, in multiples of the case's own."""

    interval: float = 1.0
    kernel: str = ""
    width: float = 0.0              # mean diameters; of kernels that have one
    mesh: float = 1.0               # cells along each edge
    stiffness: float = 1.0
    step: float = 1.0               # DEM step

    def name(self):
        return (f"{self.interval:g}_{self.kernel}_{self.width:g}_{self.mesh:g}_{self.stiffness:g}_"
                f"{self.step:g}")


class Failed(Exception):
    """A run that ended early: the sentence."""


class CaseStudy:
    """Options as the command has them: window, series, intervals, steps, kernels, widths, meshes,
    stiffnesses, settle, runs, target, budget, of, closed, folder, arguments, keep, go_on."""

    def __init__(self, case, options):
        self.case, self.options = case, options
        self.own = Variant(kernel=case.kernel, width=case.width)
        self.start, self.step = case.start, case.step
        self.window = case.end - case.start if options.window is None else options.window
        if not self.window > 0:
            raise Refused(f"-window {self.window:g}; give a number of seconds above 0")
        self.check()
        self.choose_samples()
        self.folder = Path(options.folder).absolute()

    def check(self):
        o, case = self.options, self.case
        if o.settle and not (case.folder/o.settle).is_file():
            raise Refused(f"-settle {o.settle}: no such scene in {case.folder}")
        if "width" in o.series and case.kernel not in WITH_WIDTH:
            raise Refused(f"-series width: the case's kernel {case.kernel} has none; leave it out, or "
                          "ask for kernel")
        if "stiffness" in o.series and not o.settle and case.snapshot:
            raise Refused("-series stiffness: the case starts from a snapshot, whose overlaps are "
                          "particles settled with its stiffness; -settle SCENE makes one for each")
        if "mesh" in o.series and not case.mesh.is_file():
            raise Refused("-series mesh: the case has no system/blockMeshDict; leave it out")

    def choose_samples(self):
        coarsest = max(self.options.intervals) if "interval" in self.options.series else 1.0
        steps = self.window/self.step/coarsest
        self.samples = int(min(MAX_SAMPLES, max(1, steps/SAMPLE_STEPS + 1e-9)))
        self.between = self.window/self.samples
        if steps < MIN_STEPS*(1 - 1e-9):
            raise Refused(f"a window of {self.window:g} s has fewer than {MIN_STEPS} steps of the "
                          "coarsest level; give a longer -window, or finer levels")
        if abs(self.start/self.between - round(self.start/self.between)) > 1e-6:
            raise Refused(f"the start, {self.start:g} s, is not a multiple of {self.between:g} s, the "
                          "time between two samples; give a -window that makes it one")

    def prepare_folder(self):
        """The folder of the results; with -continue, its runs belong to the same study."""
        o = self.options
        asked = (f"{self.case.folder} from {self.case.start_name} s, window {self.window:g} s, deltaT "
                 f"{self.step:g} s, {o.runs} runs, {self.samples} samples, kernel {self.case.kernel} "
                 f"{self.case.width:g}{', ' + o.arguments if o.arguments else ''}")
        runs, note = self.folder/"runs", self.folder/"runs/asked"
        if not o.go_on:
            self.remove_runs()
        elif note.is_file() and note.read_text() != asked:
            raise Refused(f"-continue: the runs in {self.folder} are of {note.read_text()}, not of "
                          f"{asked}")
        runs.mkdir(exist_ok=True)
        note.write_text(asked)

    def remove_runs(self):
        for name in ("runs", "settled"):
            shutil.rmtree(self.folder/name, ignore_errors=True)

    def settle(self, stiffness):
        """The folder with the results of the scene of -settle at this stiffness."""
        at = self.folder/"settled"/f"{stiffness:g}"
        log = at/"log"
        if not log.is_file():
            at.mkdir(parents=True)
            for each in self.case.folder.iterdir():     # files that the scene may read
                if each.is_file():
                    shutil.copy(each, at)
            shutil.copytree(self.case.folder/"constant", at/"constant")
            shutil.copy(self.case.folder/self.options.settle, at)
            settings = [word for name, modulus in self.case.moduli.items()
                        for word in ("-set", f"materials/{name}/youngsModulus",
                                     f"{modulus*stiffness:.12g}")]
            with open(log, "w") as out:
                call(["dem", "run", *settings, Path(self.options.settle).name], at, out)
        if not re.search("^hash", log.read_text(), re.M):
            raise Failed(f"the scene {self.options.settle} did not settle: "
                         + failure_reason(log.read_text()))
        return at

    def copy_case(self, to, stiffness):
        """The case with its initial state, without results of runs."""
        case = self.case
        shutil.rmtree(to, ignore_errors=True)        # of an interrupted call with -keep
        to.mkdir()
        for name in ("system", "constant"):
            shutil.copytree(case.folder/name, to/name)
        if self.start == 0 and (case.folder/"0.orig").is_dir():
            shutil.copytree(case.folder/"0.orig", to/"0")
        else:
            shutil.copytree(case.folder/case.start_name, to/case.start_name)
        for each in case.folder.iterdir():
            if not (to/each.name).exists() and not NO_COPY.fullmatch(each.name):
                (to/each.name).symlink_to(each)
        if self.options.settle:
            for each in self.settle(stiffness).iterdir():
                if each.is_dir() and each.name != "constant":
                    if (to/each.name).is_symlink():
                        (to/each.name).unlink()
                    (to/each.name).symlink_to(each)

    def set_up(self, at, variant, step, dem_step):
        """Append this run's settings to its dictionaries."""
        control = (
            f"startFrom startTime; startTime {self.case.start_name}; stopAt endTime; endTime "
            f"{self.start + self.window:.12g}; deltaT {step:.12g}; maxDeltaT {step:.12g}; "
            "adjustTimeStep no;\nwriteControl timeStep; writeInterval 1000000000; timePrecision 12; "
            "runTimeModifiable no;\nfunctions\n{\n")
        for name in patches(at) if self.case.has_pressure else ():
            control += (f'    cost_{name} {{ type surfaceFieldValue; libs '
                        '("libfieldFunctionObjects.so"); writeControl timeStep; writeInterval 1; log '
                        f"false; writeFields false; regionType patch; name {name}; operation "
                        "areaAverage; fields (p); }\n")
        append(at/"system/controlDict", control + "}\n")
        file = at/"constant/demProperties"
        settings = f"coupling {{ record {{ interval {self.between:.12g}; }} kernel {variant.kernel}; }}\n"
        if variant.kernel in WITH_WIDTH:
            settings += f"coupling {{ width {variant.width:.12g}; }}\n"
        else:
            call(["foamDictionary", "-entry", "coupling/width", "-remove", str(file)], at,
                 subprocess.DEVNULL)
        if variant.stiffness != 1:
            for name, modulus in self.case.moduli.items():
                settings += (f"materials {{ {name} {{ youngsModulus "
                             f"{modulus*variant.stiffness:.12g}; }} }}\n")
        if dem_step:
            settings += f"time {{ step {dem_step:.15g}; force yes; }}\n"
        if self.case.snapshot and not self.options.settle:
            settings += f'start {{ snapshot "{self.case.snapshot}"; }}\n'
        append(file, settings)

    def execute(self, at, *command):
        """Run a program in this folder; its text goes to the log."""
        with open(at/"log", "w") as out:
            done = call(command, at, out)
        text = (at/"log").read_text(errors="replace")
        return done.returncode, text

    def run_copy(self, at, variant, steps):
        """One run in the folder at: its result, as stored."""
        step, dem_step = self.window/steps, None
        if variant.step != 1:
            many = math.ceil(self.dem_steps/variant.step - 1e-9)
            dem_step = step/many*(1 + 1e-10)
        self.copy_case(at, variant.stiffness)
        if variant.mesh != 1:
            file = at/"system/blockMeshDict"
            cells = self.case.dictionary("system/blockMeshDict", "cells")
            file.write_text(finer(file.read_text(), variant.mesh, cells))
            shutil.rmtree(at/"constant/polyMesh", ignore_errors=True)
        if not (at/"constant/polyMesh").is_dir():
            status, log = self.execute(at, "blockMesh")
            if status:
                raise Failed(failure_reason(log))
        self.set_up(at, variant, step, dem_step)
        status, log = self.execute(at, self.case.solver, *self.options.arguments.split())
        ended = status == 0 and re.search("^End", log, re.M)
        if not ended:
            raise Failed(failure_reason(log))
        if not (at/"postProcessing/dem"/self.case.start_name/"particles.bin").exists():
            raise Failed("the run moved no particles: controlDict needs a function object of type "
                         "demCloud and its libs must load")
        values, scales = result_values(at, self.case)
        owner = (at/"constant/polyMesh/owner").read_text(errors="replace")
        return {"steps": steps, "seconds": processor_time(log, steps), "values": values,
                "scales": scales, "cells": int(re.search(r"nCells: *(\d+)", owner)[1]),
                "dem_steps": max([int(n) for n in
                                  re.findall(r"^Suna:.* (\d+) DEM steps", log, re.M)], default=0)}

    def run(self, variant, k):
        """The result of run k of a variant: read (-continue), or of a run made now. {"failed":
        sentence} if it failed."""
        at = self.folder/"runs"/f"{variant.name()}.{k}"
        stored = at.with_name(at.name + ".json")
        if stored.is_file():
            return json.loads(stored.read_text())
        if sys.stderr.isatty():
            print(".", end="", file=sys.stderr, flush=True)
        many = int(self.between/(self.step*variant.interval) + 0.5)
        spread = max(1, int(0.08*many/max(1, self.options.runs - 1) + 0.5))
        steps = max(1, many + spread*(k - (self.options.runs - 1)//2))*self.samples
        try:
            result = self.run_copy(at, variant, steps)
        except Failed as error:
            result = {"failed": str(error)}
        stored.write_text(json.dumps(result))
        if not self.options.keep:
            shutil.rmtree(at, ignore_errors=True)
        return result

    # ---- levels, series --------------------------------------------------------------------------

    def level(self, name, variant, size=None, step=None):
        """Its runs. size None: from the number of cells. step: the DEM step if that is what the level
        varies, of which a fluid step has many."""
        step = step or self.step*variant.interval
        many = int(self.step*variant.interval/step + 0.5)
        level, results = Level(name, size or 1e-9, step), []
        for k in range(self.options.runs):
            result = self.run(variant, k)
            if "failed" in result:
                level.failed = result["failed"]
                return level
            results.append(result)
        if size is None:
            level.size = (self.cells/results[0]["cells"])**(1/3)
        of = self.options.of or UNITS
        level.runs = [Run(r["steps"]*many, r["seconds"],
                          {q: x for q, x in r["values"].items() if q in of}) for r in results]
        return level

    def series(self, parameter, text, entry, levels, variants, **more):
        """The series of a parameter; levels from coarse to fine, 1 among them. sizes: what the error
        goes to zero with."""
        sizes = more.pop("sizes", levels)
        steps = more.pop("steps", [None]*len(levels))
        return Series(parameter, text, entry, base=levels.index(1.0), levels=[
            self.level(f"{x:g}", variant, size, step)
            for x, variant, size, step in zip(levels, variants, sizes, steps)], **more)

    def finer(self, series):
        """A level of half the finest interval, or DEM step."""
        size, of = series.levels[-1].size/2, series.parameter
        return self.level(f"{size:g}", replace(self.own, **{of: size}), size,
                          self.step/self.dem_steps*size if of == "step" else None)

    def interval(self):
        levels = self.options.intervals
        return self.series("interval", "interval of exchange (the fluid's step): in deltaT of the "
                           "case", "deltaT", levels,
                           [replace(self.own, interval=x) for x in levels], exact=True)

    def dem_step(self):
        levels = self.options.steps
        if not self.dem_steps:
            raise Refused("-series step: the solver does not say how many DEM steps it took; leave it "
                          "out")
        return self.series("step", "DEM step over the case's; deltaT as it is", "time/step",
                           levels, [replace(self.own, step=x) for x in levels],
                           steps=[self.step/self.dem_steps*x for x in levels], exact=True)

    def width(self):
        levels, own = self.options.widths, self.own
        return self.series("width", f"width of the kernel {own.kernel}: in the case's {own.width:g} "
                           "diameters; errors against no width", "coupling/width", levels,
                           [replace(own, width=own.width*x) for x in levels])

    def mesh(self):
        levels = sorted(self.options.meshes)
        narrows = "" if self.own.kernel in WITH_WIDTH else \
            f"; the kernel {self.own.kernel} narrows with them"
        return self.series("mesh", "cells along an edge over the case's; deltaT as it is"
                           + narrows, "blockMeshDict", levels,
                           [replace(self.own, mesh=x) for x in levels], sizes=[None]*len(levels))

    def stiffness(self):
        """The error of soft contacts scales as the contact time, E^-0.4. Hard spheres have no
        overlap."""
        levels = sorted(self.options.stiffnesses)
        return self.series("stiffness", "stiffness over the case's; errors against hard spheres",
                           "youngsModulus", levels,
                           [replace(self.own, stiffness=x) for x in levels],
                           sizes=[x**-0.4 for x in levels], without=("overlap",))

    @staticmethod
    def kernel_name(variant):
        return variant.kernel + (f":{variant.width:g}" if variant.kernel in WITH_WIDTH else "")

    def kernels(self):
        """The case's own comes last: the others are compared with it."""
        own, levels = self.kernel_name(self.own), []
        for kernel, width in self.options.kernels:
            variant = replace(self.own, kernel=kernel, width=width or 3.0)
            if self.kernel_name(variant) != own:
                levels.append(self.level(self.kernel_name(variant), variant, 99.0 - len(levels)))
        levels.append(self.level(own, self.own, 1.0))
        return Series("kernel", f"other kernels; changes against the case's {own}", "coupling/kernel",
                      levels=levels, base=len(levels) - 1, paired=True)

    # ---- the study -------------------------------------------------------------------------------

    def study(self):
        """Makes all runs. The case as it is comes first: its runs are a level of all series."""
        self.prepare_folder()
        o, first = self.options, self.run(self.own, 0)
        if "failed" in first:
            raise Refused(f"the case as it is fails: {first['failed']}")
        self.cells, self.dem_steps = first["cells"], first["dem_steps"]
        make = {"interval": self.interval, "step": self.dem_step, "kernel": self.kernels,
                "width": self.width, "mesh": self.mesh, "stiffness": self.stiffness}
        units = {q: unit for q, unit in UNITS.items() if q in (o.of or UNITS)}
        study = Study("case", "", self.window, o.target, units, runs=o.runs, closed=o.closed,
                      scale=dict(first["scales"]), series=[make[name]() for name in o.series],
                      folder=o.folder)
        study.title = (
            f"cost of {self.case.folder.name}, {self.case.solver}: a window of {self.window:g} s from "
            f"{self.start:g} s on; {self.window/self.step:.0f} fluid steps of {self.step:g} s with up "
            f"to {self.dem_steps} DEM steps; {self.cells} cells, kernel {self.case.kernel}; {o.runs} "
            f"run{'s' if o.runs > 1 else ''} of each level, {self.samples} "
            f"sample{'s' if self.samples > 1 else ''}")
        return study

    def finish(self):
        """After the last run: the copies of the case go, unless kept."""
        if not self.options.keep:
            self.remove_runs()
        if sys.stderr.isatty():
            print(file=sys.stderr)


def append(file, text):
    """Of repeated entries OpenFOAM takes the last one."""
    with open(file, "a") as out:
        out.write("\n" + text)
