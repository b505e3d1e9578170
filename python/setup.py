"""setup.py -- build the core (make) and put library and headers into the package suna; put its sources
into a source distribution, which has no dem/ beside it.

    pip install ./python
    python3 -c 'from setuptools.build_meta import build_sdist; build_sdist("dist")'     in python/

SPDX-License-Identifier: GPL-3.0-or-later
"""
import re
import shutil
import subprocess
from pathlib import Path

from setuptools import setup
from setuptools.command.build_py import build_py
from setuptools.command.sdist import sdist
from setuptools.dist import Distribution

HERE = Path(__file__).resolve().parent
# of a source distribution, or of the tree
CORE = HERE/"core" if (HERE/"core").is_dir() else HERE.parent/"dem"
VERSION = re.search(r'#define DEM_VERSION "(.*)"', (CORE/"include"/"dem.h").read_text()).group(1)
# what `make shared` reads: sources lie at most three folders deep
SOURCES = ("Makefile", "install/*", "*/*.[ch]", "*/*/*.[ch]")


class WithCore(build_py):
    def run(self):
        super().run()
        subprocess.check_call(["make", "-C", str(CORE), "-j2", "shared"])
        target = Path(self.build_lib)/"suna"
        shutil.copy(CORE/"build"/"libdem.so", target)
        (target/"include").mkdir(exist_ok=True)
        for header in (CORE/"include").glob("*.h"):
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
        licence = HERE.parent/"COPYING"
        if licence.exists():
            shutil.copy(licence, base_dir)


class HasLibrary(Distribution):
    def has_ext_modules(self):
        return True


setup(version=VERSION, cmdclass={"build_py": WithCore, "sdist": WithSources}, distclass=HasLibrary)
