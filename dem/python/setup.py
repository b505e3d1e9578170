"""setup.py -- pip install ./dem/python builds the core (make) and puts library and headers into the
package.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import re
import shutil
import subprocess
from pathlib import Path

from setuptools import find_packages, setup
from setuptools.command.build_py import build_py
from setuptools.dist import Distribution

CORE = Path(__file__).resolve().parent.parent
VERSION = re.search(r'#define DEM_VERSION "(.*)"', (CORE/"include"/"dem.h").read_text()).group(1)


class WithCore(build_py):
    def run(self):
        super().run()
        subprocess.check_call(["make", "-C", str(CORE), "-j2", "shared"])
        target = Path(self.build_lib)/"suna"
        shutil.copy(CORE/"build"/"libdem.so", target)
        (target/"include").mkdir(exist_ok=True)
        for header in ("dem.h", "dem_types.h"):
            shutil.copy(CORE/"include"/header, target/"include")


class HasLibrary(Distribution):
    def has_ext_modules(self):
        return True


setup(name="suna", version=VERSION, description="Discrete elements: the core of Suna in Python",
      license="GPL-3.0-or-later", packages=find_packages(include=["suna*"]),
      python_requires=">=3.9",
      install_requires=["numpy", "cffi"], cmdclass={"build_py": WithCore}, distclass=HasLibrary)
