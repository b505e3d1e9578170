"""suna -- discrete elements in Python: the core of Suna with numpy arrays.

    import suna
    sim = suna.Simulation("drop.dem")
    sim.advance(0.01)
    print(sim.position.mean(axis=0), sim.totals["kinetic"])

SPDX-License-Identifier: GPL-3.0-or-later
"""
try:
    import cffi as _cffi
    import numpy as _numpy
except ModuleNotFoundError as fault:
    raise ImportError(f"suna needs numpy and cffi, and this Python has no {fault.name}; on Debian they are "
                      "python3-numpy and python3-cffi, of /usr/bin/python3") from fault

from ._library import ffi, lib
from .files import (FileError, read_cloud, read_record, read_snapshot, read_table, read_vtp, tables,
                    times)
from .particles import Forces, View
from .simulation import Simulation, SunaError
from .walls import Wall

__version__ = ffi.string(lib.dem_version()).decode()
__all__ = ["FileError", "Forces", "Simulation", "SunaError", "View", "Wall", "read_cloud", "read_record",
           "read_snapshot", "read_table", "read_vtp", "tables", "times"]
