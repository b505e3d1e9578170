"""__main__.py -- `dem import`: recognises the input of another code and writes a scene or a case of
Suna. Also python3 -m suna_import.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import contextlib
import os
import sys
from pathlib import Path

from suna import SunaError
from suna.command import Refused, command, read_options

from .liggghts import Translation
from .liggghts_particles import BadFile, is_data, is_dump, read_data, read_dump, write_table
from .liggghts_scene import write_scenes
from .report import CannotTranslate, Place, Report
from .units import BASE, Units

HELP = """Usage: dem import [OPTION VALUE] ... FILE|CASE

Translates input of LIGGGHTS, CFDEMcoupling and OpenFOAM. The output runs, each entry names
its source line, and a table tells what was approximated and what has no effect. What
cannot be translated is an error that names line and word, and nothing is written.

    FILE    input script of LIGGGHTS: a scene, or several that follow each other
            its data file or dump (dump custom): a table of particles for a scene
    CASE    folder of a case of CFDEMcoupling (with CFD and DEM), or of OpenFOAM with a cloud of
            particles (kinematicCloudProperties, cloudProperties): a case for demPimpleFoam

    -o OUTPUT          scene, table or folder; default: the name of the input with .dem, .csv
                       or .suna, in the folder where this runs
    -report FILE       what became of each line, as CSV
    -var NAME=VALUE    a variable, as -var of LIGGGHTS; may be repeated
    -units NAME        of a data file or dump: si, cgs, micro, nano; default si
"""

VALUES = ("-o", "-report", "-var", "-units")
FAULT = "here the importer fails by a fault of its own"


def read_command(arguments):
    variables, rest, words = [], [], list(arguments)
    while words:
        word = words.pop(0)
        if word == "-var" and words:
            variables.append(tuple(words.pop(0).split("=", 1)) if "=" in words[0]
                             else (words.pop(0), words.pop(0)))
        else:
            rest.append(word)
    given, inputs = read_options(rest, "dem import", VALUES)
    if len(inputs) != 1:
        raise CannotTranslate("give one file or case; see dem import -help")
    return Path(inputs[0]), given, variables


def kind_of(path):
    """The translator of an input."""
    if path.is_dir():
        from .cfdem import is_cfdem, translate_cfdem
        from .cloud import find_cloud, translate_cloud
        if is_cfdem(path):
            return translate_cfdem
        if find_cloud(path) is not None:
            return translate_cloud
        raise CannotTranslate(
            f"{path}: neither CFD/constant/couplingProperties (CFDEMcoupling) nor "
            "constant/kinematicCloudProperties or cloudProperties (OpenFOAM); for a script of "
            "LIGGGHTS give the file")
    if not path.is_file():
        raise CannotTranslate(f"there is no {path}; give a file or the folder of a case")
    if is_dump(path) or is_data(path):
        return import_particles
    with open(path, "rb") as file:
        if b"\0" in file.read(4000):
            raise CannotTranslate(
                f"{path}: not text; restart files of LIGGGHTS are not read: import the script that "
                "writes it, or a dump")
    return import_script


def import_script(path, output, report, variables, units):
    translation = Translation(path, report, variables).read()
    files, commands = write_scenes(translation, output, report)
    return files, " && ".join(commands)


def import_particles(path, output, report, variables, units):
    place = Place(os.path.relpath(path))
    try:
        p = read_dump(path, units, place) if is_dump(path) else read_data(path, units, place)[0]
    except BadFile as error:
        report.refuse(place._replace(line=error.line), "Atoms", str(error))
    files, stem = [], output.removesuffix(".csv")
    kinds = sorted(set(p.type))
    for kind in kinds:
        of = p.type == kind
        name = stem + (f"_type{kind}" if len(kinds) > 1 else "") + ".csv"
        write_table(name, p.x[of], p.diameter[of], p.v[of], p.w[of], p.id[of])
        files.append(name)
        density = sorted(set(p.density[of]))
        report.translated(place, f"type {kind}", f"{of.sum()} particles" + (
            f" of density {', '.join(f'{x:g}' for x in density)} kg/m3" if density[-1] else
            "; the density is not in a dump"))
    groups = [f"type{kind}" for kind in kinds] if len(kinds) > 1 else ["particles"]
    return files, "in a scene: insert { " + " ".join(
        f'{group} {{ type table; material NAME; file "{file}"; }}' for group, file in zip(groups, files)) + " }"


def default_output(path, translate):
    if translate is import_script:
        name = path.name.removeprefix("in.")
        name = name.removesuffix(".in").removesuffix(".liggghts") or "scene"
        return name.replace(".", "_") + ".dem"
    if translate is import_particles:
        return path.stem + ".csv"
    return path.resolve().name + ".suna"


@contextlib.contextmanager
def sentences(path, report):
    """Faults of files, and of the importer itself, as sentences with the line that was read."""
    try:
        yield
    except (Refused, SunaError):
        raise
    except OSError as error:
        raise CannotTranslate(f"{error.filename or path}: {error.strerror or error}; check the "
                              "path and its permissions") from None
    except Exception as error:
        raise CannotTranslate(f"{report.at or path}: {FAULT} ({type(error).__name__}: {error}); "
                              "please report it with this input") from error


def main(arguments):
    path, given, variables = read_command(arguments)
    units = given.get("-units", "si")
    if units not in BASE:
        raise CannotTranslate(f"-units {units}; known: {', '.join(BASE)}")
    translate, report = kind_of(path), Report()
    output = given.get("-o") or default_output(path, translate)
    if path.is_file() and os.path.isdir(output):
        output = os.path.join(output, default_output(path, translate))
    try:
        with sentences(path, report):
            if path.is_dir():
                translate(path, Path(output), report)
                files, hint = [output], ""
            else:
                files, hint = translate(path, output, report, variables, Units(units))
    finally:
        if "-report" in given:
            report.write_csv(given["-report"])
    print(report.table())
    print("written: " + ", ".join(files))
    if hint:
        print(hint)


if __name__ == "__main__":
    sys.exit(command(sys.modules[__name__], "dem import", sys.argv[1:]))
