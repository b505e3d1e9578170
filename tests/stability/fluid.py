"""fluid.py -- boxes of fluid for the checks: Case of tests/coupled/case.py with a mesh of one block. A user can run
their files again (blockMesh, then the solver).

    case = fluid.Case(c, "name", cells=(4, 4, 4), size=(0.04, 0.04, 0.04), patches={...},
                      scene="materials ...", step=1e-3, end=0.1)
    if case.ends(c, "name"): ...   the solver runs; if it does not end well, a row of the check says so

Patches: name -> (sides, type, U, p), with sides x- x+ y- y+ z- z+. Sides without a patch are periodic in pairs.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import math
import os
import re
import shutil
import sys

sys.path.append(os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "coupled"))
import case as coupled                  # noqa: E402
from case import largest, vector, worst  # noqa: E402, F401

ALL = "x- x+ y- y+ z- z+"
BED = ("effects { gravity { acceleration (0 0 -9.81); } hertz { impactSpeed 5; } dry { restitution 0.8; } "
       "mindlin { friction 0.3; } gidaspow { } pressureGradient { } } ")
WALL = ("wall", "noSlip;", "fixedFluxPressure;")


def there():
    """True if the solver can be run."""
    return shutil.which("demPimpleFoam") and shutil.which("blockMesh")


class Folder(coupled.Case):
    """A case of tests/coupled, run for a check."""

    def __init__(self, c, name, source):
        super().__init__(c.place(name.replace(" ", "_")), source)

    def ends(self, c, what, solver="demPimpleFoam", split=None):
        """Run the solver, on as many ranks as `split`, (nx, ny, nz), has parts; a row if it does not end well."""
        ranks = math.prod(split or (1,))
        if split:
            self.dictionary("system/decomposeParDict", f"numberOfSubdomains {ranks}; method hierarchical; "
                            f"coeffs {{ n {vector(split)}; delta 0.001; order xyz; }}")
            self.run("decomposePar")
        run = self.run(solver, ranks=ranks, limit=3000)
        good = run and re.search(r"^(\[0\] )?End", run.log, re.M) and (not split or self.run("reconstructPar"))
        if not good:
            c.holds(what + ": runs", False, run.log)
        return bool(good)

    def worst(self, key):
        return worst(self.log(), key)


class Case(Folder):
    def __init__(self, c, name, cells, size, step, end, scene, patches={}, g=None, nu=1e-5, U="(0 0 0)", write=None,
                 functions="", grading="1 1 1"):
        super().__init__(c, name, "shared")
        taken = " ".join(sides for sides, *_ in patches.values())
        self.controls(end, step, write, functions, nu)
        self.box(size, cells, {name: (kind, at) for name, (at, kind, _, _) in patches.items()}, grading,
                 "".join(axis for axis in "xyz" if axis + "-" not in taken))
        self.flow(U, *(" ".join(f"{name} {{ type {patch[k]} }}" for name, patch in patches.items()) for k in (2, 3)))
        if g:
            self.gravity(vector(g))
        self.dictionary("constant/demProperties", scene)
