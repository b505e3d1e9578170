#!/usr/bin/env python3
"""launch.py -- beside the program as dem-cost, dem-import, dem-plot and demCost: starts suna.cost or
suna.importer with a python3 that has what it needs.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import glob
import os
import shutil
import sys
from importlib.util import find_spec

HERE = os.path.dirname(os.path.realpath(__file__))
NEEDS = {"dem-cost": ("cffi", "numpy", "scipy"), "demCost": ("cffi", "numpy", "scipy"),
         "dem-import": ("cffi", "numpy"), "dem-plot": ("matplotlib",)}
NAME = os.path.basename(__file__)
PLOT_HELP = """Usage: dem-plot FOLDER/cost.csv

Draws a study of accuracy against cost: errors over processor time, as cost.png and cost.svg beside
the table. dem cost and demCost call it at their end; this draws a stored table again.
"""


def lacks():
    return [module for module in NEEDS[NAME] if find_spec(module) is None]


if NAME == "dem-plot" and (len(sys.argv) != 2 or sys.argv[1] in ("-help", "-h")):
    print(PLOT_HELP, end="", file=sys.stdout if len(sys.argv) == 2 else sys.stderr)
    sys.exit(len(sys.argv) != 2)

if lacks():
    # another Python may come first in PATH than the one that has the packages
    other = shutil.which(os.environ.get("SUNA_PYTHON") or "/usr/bin/python3")
    if other is None or os.path.realpath(other) == os.path.realpath(sys.executable):
        sys.exit(f"{NAME} needs python3 with {', '.join(NEEDS[NAME])} (Debian: "
                 f"{' '.join('python3-' + module for module in NEEDS[NAME])})")
    os.execv(other, [other, *sys.argv])

# in the source tree, below the same prefix (make install), or beside the library of ./Allwmake
for folder in (os.path.join(HERE, "..", "python"),
               *glob.glob(os.path.join(HERE, "..", "lib", "python3*", "*-packages")),
               os.path.join(os.environ.get("FOAM_USER_LIBBIN", HERE), "python")):
    if os.path.isdir(os.path.join(folder, "suna")):
        sys.path.insert(0, folder)
        break
else:
    if find_spec("suna") is None:
        sys.exit(f"{NAME}: no package suna; build Suna with ./Allwmake or make -C dem, or install it")

if NAME == "dem-plot":
    from suna.cost.plot import plot
    plot(sys.argv[1])
    sys.exit()

from suna.cost.__main__ import command

if NAME == "dem-import":
    from suna.importer.__main__ import main
    sys.exit(command(sys.argv[1:], "dem import", main))
if NAME == "demCost":
    from suna.cost.case_command import main
    sys.exit(command(sys.argv[1:], NAME, main))
sys.exit(command(sys.argv[1:]))
