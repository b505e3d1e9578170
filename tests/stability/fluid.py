"""fluid.py -- small OpenFOAM cases for the checks: a box of cells, written as files, so that a user
can run them again (blockMesh, then the solver).

    case = fluid.Case(c, "name", cells=(4, 4, 4), size=(0.04, 0.04, 0.04), patches={...},
                      scene="materials ...", step=1e-3, end=0.1)
    case.run()                     blockMesh and demPimpleFoam, or the given solver
    case.particles(time)           id -> (x, v)
    case.worst("exchange error")   the largest number after these words in the log

Patches: name -> (faces, type, U, p); faces of the box are x0 x1 y0 y1 z0 z1. Faces without a patch
are periodic in pairs.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import csv
import os
import re
import shutil
import subprocess
import results

FACES = {"x0": "(0 4 7 3)", "x1": "(1 2 6 5)", "y0": "(0 1 5 4)", "y1": "(3 7 6 2)",
         "z0": "(0 3 2 1)", "z1": "(4 5 6 7)"}
HEAD = "// SPDX-License-Identifier: GPL-3.0-or-later\nFoamFile { version 2.0; format ascii; class %s; object %s; }\n"
SHARED = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "coupled", "shared")
WALL = ("wall", "noSlip;", "fixedFluxPressure;")


def from_folder(c, name, *places):
    """A copy of a case of tests/coupled: its files, and those shared by all cases there."""
    case = object.__new__(Case)
    case.folder = c.place(name)
    shutil.copytree(SHARED, case.folder)
    for place in places:
        shutil.copytree(os.path.join(SHARED, "..", place), case.folder, dirs_exist_ok=True)
    start = os.path.join(case.folder, "0.orig")
    if os.path.isdir(start):
        shutil.copytree(start, os.path.join(case.folder, "0"))
    return case


def there():
    """True if the solver can be run."""
    return shutil.which("demPimpleFoam") and shutil.which("blockMesh")


class Case:
    def __init__(self, c, name, **k):
        self.folder = c.place(name.replace(" ", "_"))
        shutil.copytree(SHARED, self.folder, ignore=shutil.ignore_patterns("tetrahedra"))
        os.makedirs(os.path.join(self.folder, "0"))
        self.size, self.cells, self.patches = k["size"], k["cells"], k.get("patches", {})
        self.mesh(k.get("grading", "(1 1 1)"))
        self.file("dictionary", "constant/demProperties", k["scene"])
        self.file("dictionary", "constant/transportProperties",
                  "transportModel Newtonian; nu %.9g;" % k.get("nu", 1e-5))
        if "g" in k:
            self.file("uniformDimensionedVectorField", "constant/g",
                      "dimensions [0 1 -2 0 0 0 0]; value (%g %g %g);" % k["g"])
        self.control(k["step"], k["end"], k.get("write"), k.get("control", ""))
        self.file("volVectorField", "0/U",
                  "dimensions [0 1 -1 0 0 0 0]; internalField %s; boundaryField { %s }" % (
            k.get("U", "uniform (0 0 0)"), self.fields(2)))
        self.file("volScalarField", "0/p",
            "dimensions [0 2 -2 0 0 0 0]; internalField uniform 0; boundaryField { %s }" %
            self.fields(3))
        for old, new in k.get("solution", {}).items():
            self.edit("system/fvSolution", old, new)

    def file(self, kind, path, text):
        with open(os.path.join(self.folder, path), "w") as file:
            file.write(HEAD % (kind, os.path.basename(path)) + text + "\n")

    def edit(self, path, old, new):
        path = os.path.join(self.folder, path)
        with open(path) as file:
            text = file.read()
        if old not in text:
            raise ValueError("%s has no %s" % (path, old))
        with open(path, "w") as file:
            file.write(text.replace(old, new))

    def set(self, path, name, value):
        """Change the value of an entry that has its own line."""
        path = os.path.join(self.folder, path)
        with open(path) as file:
            text = file.read()
        new = re.sub(r"^%s\s.*;" % name, lambda m: "%s %s;" % (name, value), text, flags=re.M)
        with open(path, "w") as file:
            file.write(new)

    def table(self, name):
        """A .csv of postProcessing/dem/0: a list of dicts, without units."""
        with open(os.path.join(self.folder, "postProcessing", "dem", "0", name)) as file:
            lines = (line for line in file if not line.startswith("#"))      # line of effects
            return [{re.sub(r"\[.*", "", k): results.value(v) for k, v in row.items()}
                    for row in csv.DictReader(lines)]

    def pairs(self):
        named = [f for faces, _, _, _ in self.patches.values() for f in faces]
        return [a for a in "xyz" if a + "0" not in named]

    def fields(self, which):
        parts = ["%s { type %s }" % (name, patch[which]) for name, patch in self.patches.items()]
        return " ".join(parts + ["%s%d { type cyclic; }" % (a, k) for a in self.pairs()
                                 for k in (0, 1)])

    def mesh(self, grading):
        x, y, z = self.size
        corners = [(0, 0, 0), (x, 0, 0), (x, y, 0), (0, y, 0), (0, 0, z), (x, 0, z), (x, y, z),
                   (0, y, z)]
        parts = ["%s { type %s; faces ( %s ); }" % (n, kind, " ".join(FACES[f] for f in faces))
                 for n, (faces, kind, _, _) in self.patches.items()]
        parts += ["%s%d { type cyclic; neighbourPatch %s%d; faces ( %s ); }" %
                  (a, k, a, 1 - k, FACES[a + str(k)]) for a in self.pairs() for k in (0, 1)]
        self.file("dictionary", "system/blockMeshDict",
            "scale 1; vertices ( %s ); blocks ( hex (0 1 2 3 4 5 6 7) (%d %d %d) simpleGrading %s ); edges (); boundary ( %s );" % (
            " ".join("(%.9g %.9g %.9g)" % v for v in corners), *self.cells, grading,
            "\n".join(parts)))

    def control(self, step, end, write, more):
        self.file("dictionary", "system/controlDict",
            "application demPimpleFoam; startFrom startTime; startTime 0; stopAt endTime; endTime %.9g; deltaT %.9g;\n"
                  "writeControl adjustable; writeInterval %.9g; writePrecision 16; timeFormat general; timePrecision 9; runTimeModifiable no;\n%s" % (
                      end, step, write or end, more))

    def command(self, *words, limit=3000):
        try:
            done = subprocess.run(words, cwd=self.folder, env=dict(os.environ, PWD=self.folder),
                stdin=subprocess.DEVNULL, capture_output=True, text=True, timeout=limit)
        except subprocess.TimeoutExpired:
            self.log = "did not end within %g s" % limit
            return False
        self.log = done.stdout + done.stderr
        with open(os.path.join(self.folder, "log." + words[0]), "w") as log:
            log.write(self.log)
        return done.returncode == 0

    def run(self, solver="demPimpleFoam", ranks=1, split=None):
        """1 if it ends well. On several ranks the box is decomposed into `split` parts."""
        good = self.command("blockMesh")
        if good and ranks > 1:
            self.file("dictionary", "system/decomposeParDict",
                "numberOfSubdomains %d; method hierarchical; coeffs { n (%d %d %d); delta 0.001; order xyz; }" % (ranks, *split))
            good = self.command("decomposePar") and self.command("mpirun", "-np", str(ranks),
                solver, "-parallel") and re.search(r"^End|^\[0\] End", self.log, re.M)
            log = self.log
            good = good and self.command("reconstructPar")
            self.log = log
        elif good:
            good = self.command(solver) and "\nEnd" in self.log
        return bool(good)

    def numbers(self, words):
        return [float(x) for x in re.findall(re.escape(words) + r" (-?[0-9.]+(?:e[-+]?\d+)?)",
                                             self.log)]

    def worst(self, words):
        found = self.numbers(words)
        return max(map(abs, found)) if found else float("nan")

    def field(self, time, name):
        """Rows of numbers of a field; one row for a uniform field."""
        with open(os.path.join(self.folder, time, name)) as file:
            text = file.read()
        number = r"-?[0-9.]+(?:e[-+]?\d+)?"
        same = re.search(r"internalField\s+uniform\s+\(?([^;)]*)\)?;", text)
        if same:
            return [[float(x) for x in same.group(1).split()]]
        alike = re.search(r"(?:>\s*|^)(\d+)\s*\{\(?([^})]*)\)?\}", text, re.M)
        if alike:
            return [[float(x) for x in re.findall(number, alike.group(2))]]*int(alike.group(1))
        body = text[text.index("}") + 1:].split("boundaryField")[0]
        found = re.search(r"(?:>\s*|^)\d+\s*\n?\(", body, re.M)
        if not found:
            return []
        inner = body[found.end():]
        if inner.lstrip().startswith("("):
            return [[float(x) for x in row.split()] for row in re.findall(r"\(([^()]*)\)", inner)]
        return [[float(x)] for x in inner[:inner.index(")")].split()]

    def particles(self, time):
        place = os.path.join(time, "lagrangian", "particles")
        ids = [int(r[0]) for r in self.field(place, "id")]
        where, fast = self.field(place, "positions"), self.field(place, "U")
        return {n: (x[:3], v) for n, x, v in zip(ids, where, fast)}
