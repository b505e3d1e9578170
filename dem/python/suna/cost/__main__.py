"""__main__.py -- `dem cost SCENE`: run a window of the scene over refinement series and report errors
and processor time of each level. Also python3 -m suna.cost.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import difflib
import math
import os
import sys
from types import SimpleNamespace

from ..simulation import SunaError
from .report import report
from .scene import SERIES, UNITS, Alone, Refused, SceneStudy, Together
from .table import read_study

HELP = """Usage: dem cost [OPTION VALUE] ... [-restart SNAPSHOT] [-set PATH VALUE] ... SCENE

Accuracy against cost: runs a window of the scene in refinement series of the time step,
the contact stiffness and the precision, and reports for each level the errors of mean
quantities and the processor time; then, in one sentence, the best buy. The only output is
the folder named at the end: cost.csv, cost.png and cost.svg (these need matplotlib).

    -window T          s of simulated time; default: time/end, or what the budget allows
    -restart SNAPSHOT  the window begins at a snapshot and not at the scene's start:
                       settle a bed first, then run this
    -budget S          s of processor time for all runs together; default 60
    -runs N            runs of each level, with steps up to 4 % longer and shorter;
                       default 5, 3 to 32
    -target E          error that the best buy must not exceed; default 0.01
    -of LIST           quantities, separated by commas: kinetic, rotation, height, overlap,
                       force, contacts, restitution; default: all that the scene has
    -series LIST       series, separated by commas: step, stiffness, precision, friction
                       (its three laws); default: all. -ladders is accepted too
    -effects           instead: the scene with each effect left out, the change of results
                       and the time saved
    -steps LIST        levels, as multiples of the scene's step; default 2,1,0.5,0.25,0.125
    -stiffnesses LIST  levels, as multiples of all Young's moduli;
                       default 0.0625,0.25,1,4,16
    -folder NAME       default: the scene's name without its extension, and .cost

For an OpenFOAM case: demCost -help. It makes the runs and calls
    dem cost -judge TABLE FOLDER      errors, times and the best buy of a table of runs
                                      (suna/cost/table.py has its format)
    dem cost -record FILE GX GY GZ    height, level and kinetic energy from a record of
                                      particles, with this gravity
"""

VALUES = ("-window", "-budget", "-runs", "-target", "-of", "-series", "-steps", "-stiffnesses",
          "-folder")


def unknown(what, word, known):
    near = difflib.get_close_matches(word, known, 1, 0.5)
    return Refused(f'unknown {what} "{word}"' + (f"; did you mean {near[0]}?" if near else ";")
                   + f" known: {', '.join(known)}")


def number(name, text, low, high, default):
    if text is None:
        return default
    try:
        value = float(text)
    except ValueError:
        value = math.nan
    if not low <= value <= high:
        raise Refused(f"{name} {text}; give a number from {low:g} to {high:g}")
    return value


def levels(name, text, default):
    """Numbers separated by commas, 1 among them; the largest, which is the coarsest, first."""
    given = text or default
    try:
        found = sorted((float(x) for x in given.split(",")), reverse=True)
    except ValueError:
        found = [math.nan]
    if not all(1e-6 <= x <= 1e6 for x in found):
        raise Refused(f"{name} {given}; give numbers from 1e-6 to 1e6 separated by commas, as in "
                      f"{default}")
    for a, b in zip(found, found[1:]):
        if a == b:
            raise Refused(f"{name} {given} has {a:g} twice; give each level once")
    if len(found) < 3 or 1.0 not in found:
        raise Refused(f"{name} {given}; give three levels or more, 1 (the scene as it is) among them")
    return found


def words(what, name, text, known):
    if text is None:
        return None
    if not text:
        raise Refused(f'{name} ""; give words separated by commas')
    for word in text.split(","):
        if word not in known:
            raise unknown(what, word, known)
    return tuple(word for word in known if word in text.split(","))


def read_command(arguments):
    """Scene, options, settings, restart."""
    given, settings, restart, scene, rest = {}, [], None, None, list(arguments)
    while rest:
        word = rest.pop(0)
        word = "-series" if word == "-ladders" else word
        if word in VALUES or word == "-restart":
            if not rest:
                raise Refused(f"{word} lacks its value; see dem cost -help")
            value = rest.pop(0)
            restart, given[word] = (value, None) if word == "-restart" else (restart, value)
        elif word == "-effects":
            given[word] = True
        elif word == "-set":
            if rest and "=" in rest[0]:
                settings.append(rest.pop(0).split("=", 1))
            elif len(rest) > 1:
                settings.append((rest.pop(0), rest.pop(0)))
            else:
                raise Refused("-set lacks its values; see dem cost -help")
        elif word.startswith("-"):
            raise unknown("option", word, ("-restart", "-set", "-help", *VALUES, "-effects"))
        elif scene is not None:
            raise Refused(f"two scenes, {scene} and {word}; give one")
        else:
            scene = word
    if scene is None:
        raise Refused("no scene; see dem cost -help")
    if given.get("-effects") and given.get("-series"):
        raise Refused(f"-effects and -series {given['-series']}; give only one of them")
    runs = number("-runs", given.get("-runs"), 3, 32, 5)
    if runs != int(runs):
        raise Refused(f"-runs {runs:g}; give a whole number")
    window = number("-window", given.get("-window"), 0, math.inf, None)
    if window == 0:
        raise Refused("-window 0; give a number of seconds above 0")
    name = os.path.basename(scene)
    options = SimpleNamespace(
        window=window, runs=int(runs), effects=bool(given.get("-effects")),
        budget=number("-budget", given.get("-budget"), 0.1, 1e9, 60.0),
        target=number("-target", given.get("-target"), 1e-12, 1.0, 0.01),
        of=words("quantity", "-of", given.get("-of"), tuple(UNITS)),
        series=words("series", "-series", given.get("-series"), SERIES),
        steps=levels("-steps", given.get("-steps"), "2,1,0.5,0.25,0.125"),
        stiffnesses=levels("-stiffnesses", given.get("-stiffnesses"), "0.0625,0.25,1,4,16"),
        folder=given.get("-folder") or (os.path.splitext(name)[0] or name) + ".cost")
    return scene, options, settings, restart


def communicator():
    """Ranks, if mpirun has started some."""
    if int(os.environ.get("OMPI_COMM_WORLD_SIZE", os.environ.get("PMI_SIZE", "1"))) == 1:
        return Alone()
    try:
        from mpi4py import MPI
    except ImportError:
        raise Refused("several ranks need mpi4py (Debian: python3-mpi4py)") from None
    return Together(MPI.COMM_WORLD)


def make_folder(folder):
    try:
        os.mkdir(folder)
    except FileExistsError:
        pass
    except OSError as error:
        raise Refused(f"cannot make the folder {folder}: {error.strerror}; give another -folder") \
            from None


def main(arguments):
    if arguments and arguments[0] in ("-help", "-h"):
        print(HELP, end="")
    elif arguments and arguments[0] == "-judge":
        if len(arguments) != 3:
            raise Refused("dem cost -judge takes a table and a folder; see dem cost -help")
        study = read_study(arguments[1])
        study.folder = arguments[2]
        make_folder(study.folder)
        study.evaluate()
        report(study)
    elif arguments and arguments[0] == "-record":
        from .record import report_record
        report_record(arguments[1:])
    else:
        ranks = communicator()
        scene, options, settings, restart = read_command(arguments)
        work = SceneStudy(scene, options, settings, restart, ranks)
        work.choose_window()
        if ranks.rank == 0:
            make_folder(options.folder)
        study = work.study()
        study.folder = options.folder
        study.evaluate()
        if ranks.rank == 0:
            report(study)


def command(arguments):
    """The exit status."""
    try:
        main(arguments)
    except (Refused, SunaError) as error:
        print(f"dem: {error}", file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(command(sys.argv[1:]))
