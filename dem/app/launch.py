#!/usr/bin/env python3
"""launch.py -- beside the program as dem-cost, dem-import, dem-plot and demCost: starts suna_cost or
suna_import with a python3 that has what it needs. `dem cost` starts dem-cost.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import glob
import os
import shutil
import sys
from importlib.util import find_spec

HERE = os.path.dirname(os.path.realpath(__file__))
NEEDS = {"dem-cost": ("cffi", "numpy", "scipy"), "demCost": ("cffi", "numpy", "scipy"),
         "dem-import": ("cffi", "numpy"), "dem-plot": ("cffi", "numpy", "matplotlib")}
NAME = os.path.basename(__file__)
COMMAND = NAME.replace("-", " ")

# a second Python that has been tried already
second = os.environ.pop("SUNA_SECOND_PYTHON", None)
missing = [module for module in NEEDS[NAME] if find_spec(module) is None]
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
    from suna_cost.__main__ import command, main
except ImportError as error:
    sys.exit(f"{COMMAND}: {error}")
if NAME == "dem-import":
    from suna_import.__main__ import main
elif NAME == "demCost":
    from suna_cost.case_command import main
elif NAME == "dem-plot":
    from suna_cost.plot import main
sys.exit(command(sys.argv[1:], "dem" if NAME == "dem-cost" else COMMAND, main))
