"""_scene.py -- the scene of a simulation: what reads it into a case, with settings and options.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import os

from ._arguments import SunaError, as_scene, as_text, file_name, text
from ._core import check
from ._library import lib

# entries of a scene that belong to the program dem
PROGRAM = ("time/end", "time/untilQuiet", "time/maxCreated", "write", "coupling",
           "accuracy")


def reader(scene):
    """What reads the scene into a case, also when it goes on with other entries later."""
    given = text("scene", as_scene(scene)) if isinstance(scene, dict) else file_name("scene", scene)
    if isinstance(scene, dict) or b"{" in given or b";" in given:
        return lambda c: check(lib.dem_case_scene_text(c, given, b"scene"))
    path = os.path.abspath(given)
    known = []

    def read(c):
        check(lib.dem_case_scene_file(c, path if known else given))
        with open(path, "rb") as file:
            content = file.read()
        if known and known[0] != content:
            raise SunaError(f"{os.fsdecode(path)} has been edited since the simulation read it; save a "
                            "snapshot and start from it with the new scene")
        known[:] = [content]

    return read


def override(settings):
    """What sets entries of the scene."""
    if not isinstance(settings, (dict, type(None))):
        raise SunaError(f"settings is {settings!r}; give a dict, {{\"time/step\": 1e-6}}")
    entries = [(text("a name in settings", entry), text(entry, as_text(f"settings, {entry}", value)))
               for entry, value in (settings or {}).items()]
    return lambda c: [check(lib.dem_case_set(c, *entry)) for entry in entries]


def options(c, without, wanted):
    """Entries of the program dem are not read; an effect is left out, and what only some runs need is asked for."""
    for entry in PROGRAM:
        lib.dem_scene_skip(lib.dem_case_dict(c), entry.encode())
    if without is not None:
        check(lib.dem_case_remove_effect(c, without))
    for call in wanted:
        check(call(c))
