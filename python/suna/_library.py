"""_library.py -- loads the core, with the declarations of its public headers.

It reads the headers themselves, so structs and calls cannot differ from the library's.
In the source tree these are dem/include and dem/build/libdem.so (make -C dem); an installed package
has copies beside this file.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import os
import re
from pathlib import Path

import cffi

HERE = Path(__file__).resolve().parent
HEADERS = ("dem_types.h", "dem.h", "dem_query.h", "dem_fluid.h", "dem_tables.h", "dem_plan.h")


def declarations(text):
    """What cffi takes of a header: no directives, no bodies, constants as numbers."""
    text = re.sub(r"/\*.*?\*/", "", text, flags=re.S)
    text = re.sub(r"static inline .*?\n}\n", "", text, flags=re.S)
    text = re.sub(r'extern "C" \{|^\}$', "", text, flags=re.M)
    return re.sub(r"^#(?!define \w+ [0-9]).*\n", "", text, flags=re.M).replace(
        "#define DEM_BED_VOID_FRACTION 0.6", "static const double DEM_BED_VOID_FRACTION;")


def find():
    """Folder of the headers and path of the library; SUNA_LIBRARY names another one."""
    core = HERE.parent.parent/"dem"
    if (HERE/"include"/"dem.h").exists():
        # installed by pip, or by ./Allwmake beside the library
        headers = HERE/"include"
        library = HERE/"libdem.so" if (HERE/"libdem.so").exists() else \
            HERE.parent.parent/"libdem.so"
    else:
        headers, library = core/"include", core/"build"/"libdem.so"
    library = Path(os.environ.get("SUNA_LIBRARY", library))
    if not library.exists():
        raise ImportError(f"suna: there is no library {library}; build it with make -C dem in the "
                          "source tree, or set SUNA_LIBRARY")
    return headers, library


def load():
    headers, library = find()
    ffi = cffi.FFI()
    ffi.cdef("typedef struct ompi_communicator_t *MPI_Comm; typedef int sig_atomic_t;")
    for name in HEADERS:
        ffi.cdef(declarations((headers/name).read_text()))
    try:
        return ffi, ffi.dlopen(str(library))
    except OSError as error:
        raise ImportError(f"suna: {error}; build it again with make -C dem") from None


ffi, lib = load()
