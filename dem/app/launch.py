#!/usr/bin/env python3
"""launch.py -- beside the program as dem-cost, dem-plot and demCost: starts suna.cost with a python3
that has what it needs.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import os
import shutil
import sys

HERE = os.path.dirname(os.path.realpath(__file__))
NEEDS = {"dem-cost": ("cffi", "numpy", "scipy"), "demCost": ("cffi", "numpy", "scipy"),
         "dem-plot": ("matplotlib",)}
NAME = os.path.basename(__file__)


def lacks():
    from importlib.util import find_spec
    return [module for module in NEEDS[NAME] if find_spec(module) is None]


if lacks():
    # another Python may come first in PATH than the one that has the packages
    other = shutil.which(os.environ.get("SUNA_PYTHON") or "/usr/bin/python3")
    if other is None or os.path.realpath(other) == os.path.realpath(sys.executable):
        sys.exit(f"{NAME} needs python3 with {', '.join(NEEDS[NAME])} (Debian: "
                 f"{' '.join('python3-' + module for module in NEEDS[NAME])})")
    os.execv(other, [other, *sys.argv])

# in the source tree, or beside the installed library
for folder in (os.path.join(HERE, "..", "python"),
               os.path.join(os.environ.get("FOAM_USER_LIBBIN", ""), "python")):
    if os.path.isdir(os.path.join(folder, "suna")):
        sys.path.insert(0, folder)
        break
else:
    sys.exit(f"{NAME}: no package suna; build Suna with ./Allwmake or make -C dem")

if NAME == "dem-plot":
    if len(sys.argv) != 2:
        sys.exit("Usage: dem-plot FOLDER/cost.csv")
    from suna.cost.plot import plot
    plot(sys.argv[1])
    sys.exit()

from suna.cost.__main__ import command

if NAME == "demCost":
    from suna.cost.case_command import main
    sys.exit(command(sys.argv[1:], NAME, main))
sys.exit(command(sys.argv[1:]))
