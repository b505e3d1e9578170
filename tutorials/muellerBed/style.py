"""style.py -- the style of all pictures, suna_plot.style of the Python packages: of the source tree, of
./Allwmake, or installed.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import os
import sys
from pathlib import Path

for folder in (Path(__file__).resolve().parents[2]/"python", Path(os.environ.get("FOAM_USER_LIBBIN", "."))/"python"):
    if (folder/"suna_plot").is_dir():
        sys.path.append(str(folder))
        break
from suna_plot.style import *       # noqa: E402, F401, F403
from suna_plot.style import plt     # noqa: E402, F401
