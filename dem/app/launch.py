#!/usr/bin/env python3
"""launch.py -- beside the program as dem-cost, dem-import, dem-plot and demCost: starts suna_cost,
suna_import or suna_plot with a python3 that has what it needs. `dem cost` starts dem-cost.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import glob
import os
import shutil
import sys
from importlib import import_module
from importlib.util import find_spec

HERE = os.path.dirname(os.path.realpath(__file__))
# module of each command, and what it needs
COMMANDS = {"dem-cost": ("suna_cost.__main__", "cffi", "numpy", "scipy"),
            "demCost": ("suna_cost.case_command", "cffi", "numpy", "scipy"),
            "dem-plot": ("suna_plot.table", "cffi", "numpy", "matplotlib"),
            "dem-import": ("suna_import.__main__", "cffi", "numpy", "scipy")}
NAME = os.path.basename(__file__)
COMMAND = NAME.replace("-", " ")
MODULE, *NEEDS = COMMANDS[NAME]

# a second Python that has been tried already
second = os.environ.pop("SUNA_SECOND_PYTHON", None)
missing = [module for module in NEEDS if find_spec(module) is None]
if missing:
    # another Python may come first in PATH than the one that has the packages
    other = shutil.which(os.environ.get("SUNA_PYTHON") or "/usr/bin/python3")
    if second is None and other is not None:
        os.environ["SUNA_SECOND_PYTHON"] = other
        os.execv(other, [other, *sys.argv])
    sys.exit(f"{COMMAND}: {sys.executable} has no {', no '.join(missing)}; install "
             f"{' '.join('python3-' + module for module in missing)} (Debian, for /usr/bin/python3), or "
             "name another Python by SUNA_PYTHON")

# in the source tree, below the same prefix (make install), or beside the library of ./Allwmake
for folder in (os.path.join(HERE, "..", "..", "python"),
               *glob.glob(os.path.join(HERE, "..", "lib", "python3*", "*-packages")),
               os.path.join(HERE, "..", "lib", "python"),
               os.path.join(os.environ.get("FOAM_USER_LIBBIN", HERE), "python")):
    if os.path.isdir(os.path.join(folder, "suna")):
        sys.path.insert(0, folder)
        break
else:
    if find_spec("suna") is None:
        sys.exit(f"{COMMAND}: no package suna; build Suna with ./Allwmake or make -C dem, or install it")

try:
    program = import_module(MODULE)
    from suna.command import command
except ImportError as error:
    sys.exit(f"{COMMAND}: {error}")
sys.exit(command(program, "dem" if NAME == "dem-cost" else COMMAND, sys.argv[1:]))
