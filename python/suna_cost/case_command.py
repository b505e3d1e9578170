"""case_command.py -- `demCost -case DIR`: the options, and the report.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import math
from pathlib import Path
from types import SimpleNamespace

from suna.command import Refused, read_options

from .case import Case
from .case_study import SERIES, UNITS, CaseStudy
from .case_target import copy_name, write_copy
from .options import fraction, levels, make_folder, number, whole, words
from .report import report
from .target import search

HELP = """Usage: demCost [OPTION VALUE] ...

Accuracy against computing time of an OpenFOAM case with particles: runs a short window of
copies of the case at several levels of each parameter (a refinement series). Prints for
each level the error of usual quantities and the processor time, and at the end the
cheapest settings that reach the target error.

    -case DIR            the case; default: this folder. It is copied, never changed
    -window T            simulated time from its start on [s]; default: to its endTime
    -series LIST         refinement series: of interval, step, kernel, width, mesh,
                         stiffness, separated by commas; default: interval
    -intervals LIST      levels, in deltaT of the case; default 4,2,1,0.5
    -steps LIST          levels, in the DEM step of the case; default 1,0.5,0.25
    -kernels LIST        kernels, as in diffusion:3,linear (width after the colon);
                         default divided,linear,diffusion:1.5,diffusion:3
    -widths LIST         levels, in the width of the case's kernel; default 2,1.41,1,0.71
    -meshes LIST         levels, in the case's cells along each edge of blockMeshDict;
                         default 0.5,0.71,1,1.41
    -stiffnesses LIST    levels, in the case's Young's moduli; default 0.0625,0.25,1,4
    -settle SCENE        makes the case's snapshot by `dem run SCENE`, one for each stiffness
    -runs N              per level, with deltaT up to 4 % longer and shorter; default 3
    -target E            target of the relative error, as in 0.01 or 1%; default 0.01. If given,
                         finer intervals (with -series step: DEM steps) are added until one
                         reaches it, and the choice is written into a copy beside the case,
                         DIR.accurate
    -budget S            s of processor time that the runs of a finer level may take; default
                         600
    -of LIST             quantities: kinetic, height, level, overlap, force, void, drop;
                         default: all that the case has
    -closed LIST         exact values, as in kinetic=1e-3: errors are against these
    -folder NAME         the only folder written; default: the case's name and .cost
    -arguments WORDS     passed to the solver, in one string, as in "-cloud idle"
    -keep                keeps the copies of the case and the log of each run in the folder
    -continue            reuses the runs of a call with -keep, of the same window, runs and
                         samples, and adds those asked for now

Runs are made one after the other on one core. Stiffness has no error of overlap, since
hard spheres have no overlap. Needs demPimpleFoam or a solver with demCloud, and `dem`.
"""

VALUES = ("-case", "-window", "-series", "-intervals", "-steps", "-kernels", "-widths", "-meshes",
          "-stiffnesses", "-settle", "-runs", "-target", "-budget", "-of", "-closed", "-folder",
          "-arguments")
LEVELS = {"intervals": "4,2,1,0.5", "steps": "1,0.5,0.25", "widths": "2,1.41,1,0.71",
          "meshes": "0.5,0.71,1,1.41", "stiffnesses": "0.0625,0.25,1,4"}
KERNELS = "divided,linear,diffusion:1.5,diffusion:3"


def kernel_words(text):
    """(kernel, width) of each; width None: none given."""
    found = []
    for word in text.split(","):
        kernel, _, width = word.partition(":")
        found.append((kernel, number(f"-kernels {word}: width", width or None, 1e-6, 1e6, None)))
    return found


def closed_values(text):
    found = {}
    for part in text.split(",") if text else ():
        name, _, value = part.partition("=")
        words("quantity", "-closed", name, tuple(UNITS))
        found[name] = number(f"-closed {name}", value, -math.inf, math.inf, None)
    return found


def read_command(arguments):
    """Folder of the case, options."""
    given, rest = read_options(arguments, "demCost", VALUES, ("-keep", "-continue"))
    if rest:
        raise Refused(f"the word {rest[0]} is no option; the case is given as -case {rest[0]}")
    case = given.get("-case", ".")
    options = {name: levels("-" + name, given.get("-" + name), default, "case")
               for name, default in LEVELS.items()}
    series = words("series", "-series", given.get("-series"), SERIES) or ("interval",)
    return case, SimpleNamespace(
        **options, window=number("-window", given.get("-window"), 0, math.inf, None),
        series=series, search="-target" in given and series[0] in ("interval", "step"),
        budget=number("-budget", given.get("-budget"), 0.1, 1e9, 600.0),
        kernels=kernel_words(given.get("-kernels", KERNELS)), settle=given.get("-settle"),
        runs=whole("-runs", given.get("-runs"), 1, 32, 3),
        target=fraction("-target", given.get("-target"), 0.01),
        of=words("quantity", "-of", given.get("-of"), tuple(UNITS)),
        closed=closed_values(given.get("-closed")),
        folder=given.get("-folder") or Path(case).resolve().name + ".cost",
        arguments=given.get("-arguments", ""), keep="-keep" in given, go_on="-continue" in given)


def main(arguments):
    case, options = read_command(arguments)
    work = CaseStudy(Case(case), options)
    copy = copy_name(work.case) if options.search else None
    make_folder(options.folder)
    study = work.study()
    why = search(work, study) if options.search else study.evaluate()
    work.finish()
    report(study)
    if why:
        print(f"target {study.target:g} is not reached: {why}")
    if copy:
        write_copy(work, study, copy, why)
        print(f"case: {copy}")
