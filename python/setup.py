"""setup.py -- build the core (make) and put library and headers into the package suna; put its sources
into a source distribution, which has no dem/ beside it.

    pip install ./python
    python3 -c 'from setuptools.build_meta import build_sdist; build_sdist("dist")'     in python/
    SUNA_MPI=no pip wheel --no-deps ./python

SUNA_MPI=no builds the core without an MPI library, for one process; so does a machine without mpicc. Such a
wheel needs nothing but the C library, and its name says from which version on (manylinux_2_N).

SPDX-License-Identifier: GPL-3.0-or-later
"""
import os
import re
import shutil
import subprocess
from pathlib import Path

from setuptools import setup
from setuptools.command.build_py import build_py
from setuptools.command.sdist import sdist
from setuptools.dist import Distribution

try:
    from wheel.bdist_wheel import bdist_wheel
except ImportError:                       # no package wheel, or a setuptools that has the command itself
    try:
        from setuptools.command.bdist_wheel import bdist_wheel
    except ImportError:
        bdist_wheel = None

HERE = Path(__file__).resolve().parent
# of a source distribution, or of the tree
CORE = HERE/"core" if (HERE/"core").is_dir() else HERE.parent/"dem"
VERSION = re.search(r'#define DEM_VERSION "(.*)"', (CORE/"include"/"dem.h").read_text()).group(1)
# what `make shared` reads: sources lie at most three folders deep
SOURCES = ("Makefile", "install/*", "*/*.[ch]", "*/*/*.[ch]", "device/*.cl")
MPI = os.environ.get("SUNA_MPI") or ("yes" if shutil.which("mpicc") else "no")
LIBRARY = CORE/("build" if MPI == "yes" else "build/serial")/"libdem.so"


def licence():
    return next(path for path in (HERE/"COPYING", HERE.parent/"COPYING") if path.exists())


class WithCore(build_py):
    def run(self):
        super().run()
        subprocess.check_call(["make", "-C", str(CORE), "-j2", "shared", f"MPI={MPI}",
                               f"BUILD={LIBRARY.parent.relative_to(CORE)}"])
        target = Path(self.build_lib)/"suna"
        shutil.copy(LIBRARY, target)
        shutil.copy(licence(), target)
        (target/"include").mkdir(exist_ok=True)
        headers = [*(CORE/"include").glob("*.h"), *([CORE/"ranks/serial/mpi.h"] if MPI == "no" else [])]
        for header in headers:
            shutil.copy(header, target/"include")


class WithSources(sdist):
    def make_release_tree(self, base_dir, files):
        super().make_release_tree(base_dir, files)
        for pattern in SOURCES:
            for file in CORE.glob(pattern):
                name = file.relative_to(CORE)
                if file.is_file() and "build" not in name.parts:
                    target = Path(base_dir)/"core"/name
                    target.parent.mkdir(parents=True, exist_ok=True)
                    shutil.copy(file, target)
        shutil.copy(licence(), base_dir)


class HasLibrary(Distribution):
    def has_ext_modules(self):
        return True


def platform(own):
    """The platform of a wheel: manylinux_2_N if the library needs the C library only, from version 2.N on; else this
    machine's."""
    listed = subprocess.check_output(["objdump", "-p", str(LIBRARY)], text=True)
    if not all(re.match(r"(libc|libm|ld-linux.*)\.so\.", name) for name in re.findall(r"NEEDED +(\S+)", listed)):
        return own
    return own.replace("linux_", f"manylinux_2_{max(17, *map(int, re.findall('GLIBC_2.([0-9]+)', listed)))}_")


commands = {"build_py": WithCore, "sdist": WithSources}
if bdist_wheel:
    class ForEachPython(bdist_wheel):
        """cffi loads the library when the package is imported, so it belongs to no version of Python."""
        def get_tag(self):
            return "py3", "none", platform(super().get_tag()[2])

    commands["bdist_wheel"] = ForEachPython

setup(version=VERSION, cmdclass=commands, distclass=HasLibrary)
