"""__main__.py -- `dem cost SCENE`: run a window of the scene over refinement series and report errors
and processor time of each level. Also python3 -m suna_cost.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import math
import os
import sys
from types import SimpleNamespace

from suna.command import Refused, command, read_options

from .best_buy import UNTOUCHED
from .options import fraction, levels, make_folder, number, whole, words
from .report import report
from .scene import ON_REQUEST, SERIES, UNITS, Alone, SceneStudy, Together
from .target import run_scene, search, write_copy

HELP = """Usage: dem cost [OPTION VALUE] ... [-restart SNAPSHOT] [-set PATH VALUE] ... SCENE

Accuracy against cost: runs a window of the scene in refinement series of the time step,
the contact stiffness and the law of friction, and reports for each level the errors of mean
quantities and the processor time; then, in one sentence, the best buy. The output is the
folder named at the end, with cost.csv, cost.png and cost.svg (these need matplotlib), and
with -target a scene.

    -window T          s of simulated time; default: time/end, or what the budget allows
    -restart SNAPSHOT  the window begins at a snapshot and not at the scene's start:
                       settle a bed first, then run this
    -budget S          s of processor time for all runs together; default 60
    -runs N            runs of each level, with steps up to 4 % longer and shorter;
                       default 5, 3 to 32
    -target E          error that the best buy must not exceed, as in 0.01 or 1%; default
                       0.01. If given, finer steps are added within the budget until one
                       reaches it, and the choice is written as SCENE.accurate beside the
                       scene: bed.accurate.dem
    -run               with -target: runs the scene with the choice, instead of writing it
    -of LIST           quantities, separated by commas: kinetic, rotation, height, overlap,
                       force, contacts, restitution; default: all that the scene has
    -series LIST       series, separated by commas: step, stiffness, friction
                       (its three laws); default: all. Only if named:
                       parcels, the ratio of parcels
    -effects           instead: the scene with each effect left out, the change of results
                       and the time saved
    -steps LIST        levels, as multiples of the scene's step; default 2,1,0.5,0.25,0.125
    -stiffnesses LIST  levels, as multiples of all Young's moduli;
                       default 0.0625,0.25,1,4,16
    -parcels LIST      levels, as multiples of parcels/ratio of the scene; default 3,2,1.5,1
    -folder NAME       default: the scene's name without its extension, and .cost

For an OpenFOAM case: demCost -help.
"""

VALUES = ("-window", "-restart", "-budget", "-runs", "-target", "-of", "-series", "-steps",
          "-stiffnesses", "-parcels", "-folder", "-set")


def read_command(arguments):
    """Scene, options, settings, restart."""
    given, scenes = read_options(arguments, "dem cost", VALUES, ("-effects", "-run"))
    if not scenes:
        raise Refused("no scene; see dem cost -help")
    if len(scenes) > 1:
        raise Refused(f"two scenes, {scenes[0]} and {scenes[1]}; give one")
    scene = scenes[0]
    if given.get("-effects") and given.get("-series"):
        raise Refused(f"-effects and -series {given['-series']}; give only one of them")
    window = number("-window", given.get("-window"), 0, math.inf, None)
    if window == 0:
        raise Refused("-window 0; give a number of seconds above 0")
    series = words("series", "-series", given.get("-series"), SERIES + ON_REQUEST)
    search = "-target" in given and not given.get("-effects") and (not series or "step" in series)
    if "-run" in given and not search:
        raise Refused("-run runs what -target has found: give -target, with the series of steps")
    name = os.path.basename(scene)
    options = SimpleNamespace(
        window=window, runs=whole("-runs", given.get("-runs"), 3, 32, 5),
        effects=bool(given.get("-effects")),
        budget=number("-budget", given.get("-budget"), 0.1, 1e9, 60.0),
        target=fraction("-target", given.get("-target"), 0.01),
        of=words("quantity", "-of", given.get("-of"), tuple(UNITS)),
        series=series, search=search, run="-run" in given,
        steps=levels("-steps", given.get("-steps"), "2,1,0.5,0.25,0.125"),
        stiffnesses=levels("-stiffnesses", given.get("-stiffnesses"), "0.0625,0.25,1,4,16"),
        parcels=levels("-parcels", given.get("-parcels"), "3,2,1.5,1"),
        folder=given.get("-folder") or (os.path.splitext(name)[0] or name) + ".cost")
    return scene, options, given["-set"], given.get("-restart")


def communicator():
    """Ranks, if mpirun has started some."""
    if int(os.environ.get("OMPI_COMM_WORLD_SIZE", os.environ.get("PMI_SIZE", "1"))) == 1:
        return Alone()
    try:
        from mpi4py import MPI
    except ImportError:
        raise Refused("several ranks need mpi4py (Debian: python3-mpi4py)") from None
    return Together(MPI.COMM_WORLD)


def finish_search(work, study, why):
    if why:
        print(f"target {study.target:g} is not reached: {why}")
    if work.options.run:
        sys.stdout.flush()
        run_scene(work, study)
    print(f"scene: {write_copy(work, study, why)}")


def main(arguments):
    ranks = communicator()
    scene, options, settings, restart = read_command(arguments)
    if options.run and ranks.size > 1:
        raise Refused("-run is for one rank; without it the choice is written, to be run on any "
                      "number of ranks")
    work = SceneStudy(scene, options, settings, restart, ranks)
    work.choose_window()
    if ranks.rank == 0:
        make_folder(options.folder)
    study = work.study()
    study.folder = options.folder
    if options.search and study.untouched:
        raise Refused(f"-target: {UNTOUCHED}")
    if options.search:
        why = search(work, study)
    else:
        study.evaluate()
    if ranks.rank == 0:
        report(study)
        if options.search:
            finish_search(work, study, why)


if __name__ == "__main__":
    sys.exit(command(sys.modules[__name__], "dem", sys.argv[1:]))
