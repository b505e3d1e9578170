"""target.py -- `-target E` of `dem cost` and `demCost`: search the longest step within the target error;
for a scene, put it into a copy (for a case: case_target.py).

The copy has the scene's text, and after it the chosen settings; of repeated entries the last one
counts. Its entry `accuracy` tells `dem run` what was found:

    accuracy { target 0.01; reached 0.0054; of kinetic; window 0.01; step 1.2e-6; }

    reached   error + uncertainty of `of`, the worst quantity, over `window` [s] at `step` [s]

SPDX-License-Identifier: GPL-3.0-or-later
"""
import os
import sys
from pathlib import Path

from suna.command import Refused

from .best_buy import choose, percent

MAX_LEVELS = 16
MORE_LEVELS = 3     # until scatter counts as chaos: that by the phase of an impact falls with the step


def search(work, study):
    """Add finer levels, work.finer(series), until one is within the target, or chaos hides the effect of
    the step, or the next one would take longer than the budget. Returns why it ended, empty if within
    the target."""
    series, budget = study.series[0], work.options.budget
    chaos = len(series.levels) + MORE_LEVELS
    given = dict(study.scale)
    while True:
        study.scale = dict(given)
        study.evaluate()
        how, level = choose(study)
        if how == "within":
            return ""
        if how == "indistinct" and len(series.levels) >= chaos:
            return f"the scatter of chaotic runs is larger than the error of the {series.parameter}"
        finest = series.levels[-1]
        if not finest.runs:
            return f"the finest {series.parameter} fails"
        seconds = 2*sum(run.seconds for run in finest.runs)
        if seconds > budget:
            return (f"half the finest {series.parameter} would take {seconds:.2g} s, more than the -budget "
                    f"of {budget:g} s")
        if len(series.levels) == MAX_LEVELS:
            return f"{MAX_LEVELS} levels have been tried"
        series.levels.append(work.finer(series))


def remark(command, study, why):
    """Comment lines for a copy: what was found."""
    bound, of = choose(study)[1].bound()
    return (f"// chosen by {command} -target {study.target:g}: {of}, the worst quantity, is within "
            f"{percent(bound)}\n" + (f"// the target is not reached: {why}\n" if why else ""))


def settings(work, study):
    """Entries of the chosen level, by path."""
    _, level = choose(study)
    bound, of = level.bound()
    found = {"time/step": f"{level.step:.9g}"}
    if level.step > work.limit*(1 - 1e-9):
        found["time/force"] = "yes"
    return {**found, "accuracy/target": f"{study.target:g}", "accuracy/reached": f"{bound:.3g}",
            "accuracy/of": of, "accuracy/window": f"{study.window:.9g}",
            "accuracy/step": f"{level.step:.9g}"}


def write_copy(work, study, why):
    """The copy beside the scene, whose relative paths hold there; returns its path."""
    scene = Path(work.scene)
    copy = scene.with_name(f"{scene.stem}.accurate{scene.suffix}")
    text = scene.read_text().rstrip("\n") + "\n\n" + remark("dem cost", study, why)
    blocks = {}
    for path, value in {**work.settings, **settings(work, study)}.items():
        folder, _, name = path.rpartition("/")
        blocks.setdefault(folder, []).append(f"{name} {value};")
    for folder, entries in blocks.items():
        inner = " ".join(entries)
        for name in reversed(folder.split("/")):
            inner = f"{name} {{ {inner} }}"
        text += inner + "\n"
    try:
        copy.write_text(text)
    except OSError as error:
        raise Refused(f"cannot write {copy}: {error.strerror}; copy the scene to a folder that can be "
                      "written") from None
    return copy


def run_scene(work, study):
    """`dem run` of the scene with the chosen settings, in place of this program."""
    words = [word for path, value in {**work.settings, **settings(work, study)}.items()
             for word in ("-set", path, str(value))]
    if work.restart:
        words += ["-restart", work.restart]
    beside = Path(sys.argv[0]).with_name("dem")         # of the script that dem cost starts
    program = str(beside) if beside.is_file() else "dem"
    os.execvp(program, [program, "run", *words, work.scene])
