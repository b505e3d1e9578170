"""case_target.py -- `demCost -target E`: put the settings that the search has chosen into a copy of the
case, CASE.accurate beside it.

The copy has no results. Settings are appended to its dictionaries, where the last one counts:

    interval    deltaT and maxDeltaT; writeInterval, if it counts steps, so that outputs stay in time
    step        time/step of demProperties

SPDX-License-Identifier: GPL-3.0-or-later
"""
import shutil

from suna.command import Refused

from .best_buy import choose
from .case_study import NO_COPY, append
from .target import remark


def copy_name(case):
    """The folder of the copy, which must not be there."""
    copy = case.folder.with_name(case.folder.name + ".accurate")
    if copy.exists():
        raise Refused(f"{copy} is there already and would be overwritten by -target; move or delete it")
    return copy


def write_copy(work, study, copy, why):
    case, (_, level) = work.case, choose(study)

    def without(folder, names):
        return [name for name in names if str(case.folder) == folder and NO_COPY.fullmatch(name)
                and name != case.start_name and not name.endswith(".orig")]

    try:
        shutil.copytree(case.folder, copy, symlinks=True, ignore=without)
    except OSError as error:
        raise Refused(f"cannot write {copy}: {error}; copy the case to a folder that can be written") \
            from None
    text = remark("demCost", study, why)
    if study.series[0].parameter == "interval":
        text += f"deltaT {level.step:.12g};\nmaxDeltaT {level.step:.12g};\n"
        every = case.number("system/controlDict", "writeInterval", 0)
        if case.dictionary("system/controlDict", "writeControl") == "timeStep" and every/level.size >= 1:
            text += f"writeInterval {round(every/level.size)};\n"
        append(copy/"system/controlDict", text)
    else:
        force = " force yes;" if level.size > 1 else ""
        append(copy/"constant/demProperties", text + f"time {{ step {level.step:.12g};{force} }}\n")
