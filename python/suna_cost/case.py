"""case.py -- an OpenFOAM case with particles as it is: what a study of it needs to know.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import os
import re
import shutil
import subprocess
from pathlib import Path

import numpy

from suna.command import Refused


PROGRAMS = ("dem", "blockMesh", "foamDictionary")


def call(command, folder, out, err=subprocess.STDOUT):
    """A program in this folder, which OpenFOAM also reads from PWD."""
    return subprocess.run(command, cwd=folder, env={**os.environ, "PWD": str(folder)}, text=True,
                          stdout=out, stderr=err)


class Case:
    """What a study needs to know about a case."""

    def __init__(self, folder):
        self.folder = Path(folder)
        if not self.folder.is_dir():
            raise Refused(f"no folder {folder}")
        self.folder = self.folder.resolve()
        for name in ("system/controlDict", "constant/demProperties"):
            if not (self.folder/name).is_file():
                raise Refused(f"{self.folder} has no {name}")
        for program in PROGRAMS:
            if shutil.which(program) is None:
                raise Refused(f"no program {program} on PATH; build Suna and source OpenFOAM's "
                              "environment")
        self.read_control()
        self.read_particles()

    def dictionary(self, file, path, *what):
        """What foamDictionary prints; empty if there is no such entry."""
        done = call(["foamDictionary", "-entry", path, *(what or ["-value"]), file], self.folder,
                    subprocess.PIPE, subprocess.DEVNULL)
        return done.stdout.strip().rstrip(";") if done.returncode == 0 else ""

    def number(self, file, path, default=None):
        text = self.dictionary(file, path)
        if default is not None and not text:
            return default
        try:
            return float(text)
        except ValueError:
            raise Refused(f'{file} has {path} "{text}"; give a number') from None

    def read_control(self):
        self.solver = self.dictionary("system/controlDict", "application")
        if not self.solver or shutil.which(self.solver) is None:
            raise Refused(f'controlDict names the application "{self.solver}", which is not a program '
                          "found on PATH")
        self.step, self.end, self.start = (self.number("system/controlDict", name)
                                           for name in ("deltaT", "endTime", "startTime"))
        self.start_name = self.dictionary("system/controlDict", "startTime")
        scheme = self.dictionary("system/fvSchemes", "ddtSchemes/default")
        if re.search("steadyState|localEuler|CoEuler|SLTS", scheme):
            raise Refused("the solver is steady (ddtSchemes): its iterations have no time step and so "
                          "no window; take a transient case")
        begins = self.dictionary("system/controlDict", "startFrom")
        if begins != "startTime":
            raise Refused(f"controlDict starts from {begins}; give startFrom startTime, at which the "
                          "window begins")

    def read_particles(self):
        file = "constant/demProperties"
        self.kernel = self.dictionary(file, "coupling/kernel") or "diffusion"
        self.width = self.number(file, "coupling/width", 3.0)
        g = (self.dictionary("constant/g", "value")
             or self.dictionary(file, "effects/gravity/acceleration") or "(0 0 0)")
        self.gravity = numpy.array(re.findall(r"[-+.\deE]+", g)[-3:], float)
        self.snapshot = self.dictionary(file, "start/snapshot").strip('"')
        if self.snapshot and self.snapshot[0] not in "/$<":
            self.snapshot = str(self.folder/self.snapshot)
        self.moduli = {name: self.number(file, f"materials/{name}/youngsModulus")
                       for name in self.dictionary(file, "materials", "-keywords").split()
                       if self.dictionary(file, f"materials/{name}/youngsModulus")}
        self.mesh = self.folder/"system/blockMeshDict"
        self.has_pressure = any((self.folder/at/name).exists() for at in (self.start_name, "0.orig")
                                for name in ("p", "p.gz"))


def finer(text, factor, cells):
    """blockMeshDict with factor times the cells along each edge; a single cell stays one. cells: in
    place of $cells."""
    def times(match):
        own = match[2].replace("$cells", cells).strip("() \n").split()
        many = [1 if n == "1" else max(1, int(float(n)*factor + 0.5)) for n in own]
        return f"{match[1]}({' '.join(map(str, many))})"
    return re.sub(r"(\bhex\s*\([^)]*\)\s*[A-Za-z_]*\s*)(\([^)]*\)|\$cells\b)", times, text)


def patches(folder):
    """Names of the patches of type patch of the mesh in this folder."""
    text = (folder/"constant/polyMesh/boundary").read_text()
    return re.findall(r"(\w+)\s*\{[^}]*?\btype\s+patch\s*;", text)
