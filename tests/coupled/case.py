"""Cases of the coupled tests: write, run, read fields and tables, compare.

A test is tests/coupled/NAME/test.py. It prints TAP; ./run runs all of them, `./run NAME ...` some.

    from case import *

    case = Case()                        # shared/ and the test's folder, copied into a folder of its own
    case.edit("system/controlDict", endTime=0.002)
    case.run("blockMesh")
    claim_runs("runs", case, "demPimpleFoam", ranks=2)
    claim("exchange closes", worst(case.log("demPimpleFoam"), "exchange error") < 1e-12)
    U = case.field("0.04/U.particles")   # one row a cell
    finish()

A claim about numbers that are not there fails: a missing file or line gives an exception, which
fails the claim when the condition is a function, `claim("what", lambda: ...)`, and else ends the
test with a line "not ok".

SUNA_KEEP=1 keeps the cases, SUNA_TEST_LIMIT is the limit of one command [s].

SPDX-License-Identifier: GPL-3.0-or-later
"""
import atexit
import csv
import math
import os
import re
import runpy
import shutil
import signal
import subprocess
import sys
import tempfile
import time
import traceback
from pathlib import Path

import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parent.parent))
import tap
from tap import claim, finish, skip

__all__ = ["Case", "Path", "Run", "agrees", "brief", "claim", "claim_ran", "claim_runs", "claim_refused",
           "claim_tables", "close", "difference", "finish", "function_object", "head", "here", "largest", "math", "np",
           "os", "re", "read_field", "shutil", "signal", "skip", "snapshot_hash", "subprocess", "sys", "thorough",
           "time", "until", "vector", "work", "worst"]

here = Path(sys.argv[0]).resolve().parent             # the folder of the test
coupled = Path(__file__).resolve().parent
limit = float(os.environ.get("SUNA_TEST_LIMIT", 600))
thorough = bool(os.environ.get("SUNA_LONG"))          # ./Alltest -long: all ranks, compilers and cases
brief = bool(os.environ.get("SUNA_QUICK"))            # ./Alltest quick
work = Path(tempfile.mkdtemp())
if not os.environ.get("SUNA_KEEP"):
    atexit.register(shutil.rmtree, work, True)
signal.signal(signal.SIGTERM, lambda *_: sys.exit(1))

# couples a solver of OpenFOAM; an entry of controlDict
function_object = 'functions { particles { type demCloud; libs ("libdemCoupling.so"); } }\n'

# ---- claims ----------------------------------------------------------------------------------------


def claim_ran(what, case, command="demPimpleFoam"):
    """The last run of this command in the case has ended with the line End; else show the end of its log."""
    log = case.log(command)
    claim(what, re.search("^End", log, re.M), *log.splitlines()[-25:])


def claim_runs(what, case, *command, **options):
    """This command, demPimpleFoam if none is given, runs in the case and ends with the line End."""
    command = command or ("demPimpleFoam",)
    case.run(*command, **options)
    claim_ran(what, case, command[0])


def claim_refused(what, case, words, *command, **options):
    """The command ends with an error before its first time step and prints these words; " ... " is any text."""
    run = case.run(*command, **options)
    sentence = ".*".join(re.escape(part) for part in words.split(" ... "))
    claim(what, run.status not in (0, 124) and re.search(sentence, " ".join(run.log.split()))
          and not re.search("^(ExecutionTime|End)|sigFpe", run.log, re.M), *run.log.splitlines()[-12:])


def claim_tables(what, folder, *names):
    """These tables are CSV that any reader takes without options: Python's, and pandas where it is installed."""
    check = [coupled.parent/"csv_tables.py", *(folder/f"{name}.csv" for name in names)]
    claim(f"{what}, plain CSV", subprocess.run([sys.executable, *check]).returncode == 0)
    for python in (sys.executable, "/usr/bin/python3"):
        if subprocess.run([python, "-c", "import pandas"], stderr=subprocess.DEVNULL).returncode == 0:
            claim(f"{what}, as pandas.read_csv(FILE) takes them",
                  subprocess.run([python, check[0], "-pandas", *check[1:]]).returncode == 0)
            return
    skip(f"{what}, as pandas.read_csv(FILE) takes them", "no Python here has pandas (Debian: python3-pandas)")


def _unexpected(kind, value, trace):
    claim("the test runs to its end", False, "".join(traceback.format_exception(kind, value, trace)))
    print(f"1..{tap.claims}", flush=True)


sys.excepthook = _unexpected

# ---- cases -----------------------------------------------------------------------------------------


class Run:
    """A command that has ended: .status (124: ended at the limit) and .log, the text that it printed."""

    def __init__(self, status, log):
        self.status, self.log = status, log

    def __bool__(self):
        return self.status == 0


class Case:
    """A fresh copy of shared/ and of a test's folder, whose make.py, if it has one, makes mesh and fields; paths of all
    calls are relative to it. A stock case, a folder of OpenFOAM's tutorials, is copied alone:
    Case("cavity", FOLDER, shared=False)."""

    patches = ""                  # entries of patches that initial() and flow() add to each field

    def __init__(self, name="case", source=here, shared=True):
        self.path = work/name
        shutil.rmtree(self.path, ignore_errors=True)
        for folder in [coupled/"shared"]*shared + [coupled/source]:
            shutil.copytree(folder, self.path, dirs_exist_ok=True, ignore=shutil.ignore_patterns("__pycache__"))
        if (self/"0.orig").is_dir():
            shutil.copytree(self/"0.orig", self/"0", dirs_exist_ok=True)
        if (self/"make.py").exists():
            runpy.run_path(self/"make.py")["make"](self)

    def __truediv__(self, name):
        return self.path/name

    def read(self, name):
        return (self/name).read_text(errors="replace")

    def write(self, name, text):
        (self/name).parent.mkdir(parents=True, exist_ok=True)
        (self/name).write_text(text)

    def dictionary(self, name, text, kind="dictionary"):
        """Write a file of OpenFOAM: its head, then this text."""
        self.write(name, head(kind, Path(name).name) + text + "\n")

    def mesh(self, vertices, blocks, patches, edges="", scale=1):
        """Make a mesh with blockMesh: vertices (x, y, z), blocks "(0 1 ...) (5 5 5)", with simpleGrading (1 1 1)
        unless they have another one, and patches {name: "type wall; faces (...);"}."""
        blocks = [f"hex {block}" + ("" if "Grading" in block else " simpleGrading (1 1 1)") for block in blocks]
        self.dictionary("system/blockMeshDict", f"scale {scale};\nvertices (" + "\n".join(map(vector, vertices))
                        + ");\nblocks (" + "\n".join(blocks) + f");\nedges ({edges});\nboundary ("
                        + "\n".join(f"{name} {{ {entries} }}" for name, entries in patches.items())
                        + ");\nmergePatchPairs ();")
        return self.run("blockMesh")

    def box(self, size, cells, patches={}, grading="1 1 1", cyclic=""):
        """Make a mesh of a box from the origin, with patches {name: ("wall", "x- y+")} of these sides. Along the axes
        `cyclic` it is periodic, with patches x0, x1, ...: cyclic in all fields from then on."""
        for axis in cyclic:
            patches = {**patches, f"{axis}0": (f"cyclic; neighbourPatch {axis}1", axis + "-"),
                       f"{axis}1": (f"cyclic; neighbourPatch {axis}0", axis + "+")}
            self.patches = '".*" { type cyclic; }'
        sides = {"x-": "(0 4 7 3)", "x+": "(1 2 6 5)", "y-": "(0 1 5 4)", "y+": "(3 7 6 2)",
                 "z-": "(0 3 2 1)", "z+": "(4 5 6 7)"}
        x, y, z = size
        return self.mesh([(a, b, c) for c in (0, z) for a, b in ((0, 0), (x, 0), (x, y), (0, y))],
                         [f"(0 1 2 3 4 5 6 7) {vector(cells)} simpleGrading ({grading})"],
                         {name: f"type {kind}; faces ({' '.join(sides[side] for side in faces.split())});"
                          for name, (kind, faces) in patches.items()})

    def initial(self, name, dimensions, value, patches=""):
        """Write 0/NAME, uniform."""
        self.dictionary(f"0/{name}", f"dimensions [{dimensions}];\ninternalField uniform {value};\n"
                        f"boundaryField\n{{\n    {self.patches} {patches}\n}}",
                        "volVectorField" if str(value).startswith("(") else "volScalarField")

    def flow(self, velocity, U="", p=""):
        """Write 0/U, uniform, and 0/p with these patches."""
        self.initial("U", "0 1 -1 0 0 0 0", velocity, U)
        self.initial("p", "0 2 -2 0 0 0 0", 0, p)

    def duct(self, size, cells, speed, start=0, grading="1 1 1"):
        """A box with an inlet below, of this velocity [m/s], an outlet above and slippery sides; `start`: the velocity
        everywhere at the beginning."""
        self.box(size, cells, {"inlet": ("patch", "z-"), "sides": ("wall", "y- x+ y+ x-"), "outlet": ("patch", "z+")},
                 grading)
        self.flow(f"(0 0 {start})", f"""inlet {{ type fixedValue; value uniform (0 0 {speed}); }}
    sides {{ type slip; }}
    outlet {{ type zeroGradient; }}""", """inlet { type fixedFluxPressure; }
    sides { type fixedFluxPressure; }
    outlet { type fixedValue; value uniform 0; }""")

    def tank(self, size, cells):
        """A box of fluid at rest with walls, open above, and gravity."""
        self.box(size, cells, {"walls": ("wall", "y- x+ y+ x- z-"), "top": ("patch", "z+")})
        self.flow("(0 0 0)",
                  "walls { type noSlip; }\n    top { type pressureInletOutletVelocity; value uniform (0 0 0); }",
                  "walls { type fixedFluxPressure; }\n    top { type fixedValue; value uniform 0; }")
        self.gravity()

    def periodic(self, size, cells):
        """A box of fluid at rest, periodic along all axes."""
        self.box(size, cells, cyclic="xyz")
        self.flow("(0 0 0)")

    def gravity(self, value="(0 0 -9.81)"):
        self.dictionary("constant/g", f"dimensions [0 1 -2 0 0 0 0]; value {value};", "uniformDimensionedVectorField")

    def controls(self, end, step, write=None, functions="", nu=None, precision=16):
        """Write controlDict: the end, the step and the interval of written times, `end` if not given [s], and
        these function objects; and the fluid's viscosity."""
        self.dictionary("system/controlDict", f"""startFrom startTime;
startTime 0;
stopAt endTime;
endTime {end};
deltaT {step};
writeControl runTime;
writeInterval {write or end};
writePrecision {precision};
timePrecision 12;
runTimeModifiable no;
functions {{ {functions} }}""")
        if nu is not None:
            self.edit("constant/transportProperties", nu=nu)

    def properties(self, materials, effects, insert, coupling, more=""):
        """Write demProperties."""
        self.dictionary("constant/demProperties", f"materials {{ {materials} }}\neffects {{ {effects} }}\n"
                        f"insert {{ {insert} }}\ncoupling {{ {coupling} }}\n{more}")

    def append(self, name, text):
        with open(self/name, "a") as file:
            file.write(text)

    def copy(self, source, name):
        """Copy a file or folder, given relative to tests/coupled or absolute, into the case."""
        source = coupled/source
        (self/name).parent.mkdir(parents=True, exist_ok=True)
        if source.is_dir():
            shutil.copytree(source, self/name, dirs_exist_ok=True)
        else:
            shutil.copy(source, self/name)

    def remove(self, *patterns):
        """Remove files and folders, given as glob patterns."""
        for pattern in patterns:
            for path in self.path.glob(pattern):
                shutil.rmtree(path) if path.is_dir() else path.unlink()

    def sub(self, name, pattern, to, count=0):
        """Replace a regular expression (^ and $ match at lines) in a file. An error when nothing matches."""
        text, n = re.subn(pattern, to, self.read(name), count, re.M)
        if n == 0:
            raise ValueError(f"{name} has nothing like '{pattern}'")
        self.write(name, text)

    def edit(self, name, **entries):
        """Set entries that stand at the beginning of a line of a dictionary: edit("system/controlDict", endTime=1).
        An entry that is not there is added."""
        text = self.read(name)
        for key, value in entries.items():
            text, n = re.subn(rf"^{key}\b[^;]*;", lambda _: f"{key} {value};", text, 0, re.M)
            if n == 0:
                text += f"\n{key} {value};\n"
        self.write(name, text)

    def run(self, *command, ranks=1, log=None, limit=limit, env=None, options=()):
        """Run a command; on several ranks with -parallel, under mpirun with these options. What it prints is in
        log.<command>, or in `log`; returns a Run."""
        name = log or "log." + command[0]
        command = [str(word) for word in command]
        if command[0] == "decomposePar":              # docs/openfoam-versions.md
            env = {"FOAM_SIGFPE": "false", **(env or {})}
        if ranks > 1:
            command = ["mpirun", "-np", str(ranks), *options, *command, "-parallel"]
        with open(self/name, "w") as out:
            process = subprocess.Popen(command, cwd=self.path, stdin=subprocess.DEVNULL, stdout=out,
                                       stderr=subprocess.STDOUT,
                                       env={**os.environ, "PWD": str(self.path), **(env or {})},
                                       start_new_session=True)
            status = _wait(process, limit)
        return Run(status, self.read(name))

    def start(self, *command, ranks=1, log=None):
        """Start a command in the background; returns the process, for which ended() waits. At the end of the test it is
        killed."""
        command = [str(word) for word in command]
        if ranks > 1:
            command = ["mpirun", "-np", str(ranks), *command, "-parallel"]
        with open(self/(log or "log." + command[0]), "w") as out:
            process = subprocess.Popen(command, cwd=self.path, stdin=subprocess.DEVNULL, stdout=out,
                                       stderr=subprocess.STDOUT, env={**os.environ, "PWD": str(self.path)})
        atexit.register(process.kill)
        return process

    def ended(self, process, limit=limit):
        """Wait for a process; returns its status, or None when it had to be killed at the limit."""
        status = _wait(process, limit)
        return None if status == 124 else status

    def log(self, command="demPimpleFoam"):
        """What the last run of this command has printed."""
        return self.read("log." + command)

    def found(self, pattern, command="demPimpleFoam"):
        """The match of the last line of the log that has this expression, or None."""
        last = None
        for last in re.finditer(pattern, self.log(command), re.M):
            pass
        return last

    def numbers(self, pattern, command="demPimpleFoam"):
        """All that the groups of an expression match in the log, as an array: one row a match."""
        return np.array([[float(group) for group in match.groups()]
                         for match in re.finditer(pattern, self.log(command), re.M)])

    def vectors(self, word, line, command="demPimpleFoam"):
        """The vectors after this word, `word (x y z)`, in the lines of the log that have `line` before it."""
        found = re.findall(rf"{line}.* {word} \(([^)]*)\)", self.log(command))
        return np.array([[float(x) for x in vector.split()] for vector in found])

    def times(self, folder="."):
        """The names of the written times, in ascending order, without 0."""
        names = [path.name for path in (self/folder).iterdir()
                 if path.is_dir() and re.fullmatch(r"[0-9.]+(e[-+]?[0-9]+)?", path.name) and float(path.name) > 0]
        return sorted(names, key=float)

    def field(self, name, cells=None):
        """The internal field of an ASCII field file, or the list of a lagrangian one: a vector of numbers for a
        scalar, one row an entry for others. A uniform field has one entry, or as many as `cells`."""
        return read_field(self/name, cells)

    def boundary(self, name, patch):
        """The values of a field on a patch; of a uniform patch one entry."""
        text = self.read(name)
        found = re.search(rf"\n\s*{patch}\s*\{{.*?\bvalue\s+(uniform|nonuniform List<\w+>)\s*([^;]*);", text, re.S)
        if found[1] == "uniform":
            return _repeated(found[2], 1)
        return _listed(found[2], f"{patch} of {name}")


    def particles(self, time, *fields):
        """The particles in a time folder, sorted by id: one row a particle, its id and then these fields of it."""
        columns = {name: self.field(f"{time}/lagrangian/particles/{name}") for name in ("id", *fields)}
        if "positions" in columns:
            columns["positions"] = columns["positions"][:, :3]                  # without their cells
        rows = np.column_stack(list(columns.values()))
        return rows[rows[:, 0].argsort()]

    def names_effects(self, effects, *names):
        """Each of these files names these effects, an expression: a table by effects.csv beside it, others at their
        beginning."""
        for path in (self/name for name in names):
            if path.suffix == ".csv" and path.stat().st_size:
                path = path.with_name("effects.csv")
            lines = path.read_text(errors="replace").split("\n")[:16]
            if not any(re.search(f"(effects: |^[-0-9.e]*,).*{effects}", line) for line in lines):
                return False
        return True

    def table(self, name):
        """A CSV file as a dictionary of columns by the names of its first line, without units in brackets; of the
        pattern `name`, the first file. Columns that are not numbers are lists of text."""
        path = next(iter(sorted(self.path.glob(name))), self/name)
        with open(path, newline="") as file:
            rows = list(csv.reader(file))
        columns = {}
        for k, head in enumerate(rows[0]):
            column = [row[k] for row in rows[1:]]
            try:
                column = np.array([float(x) for x in column])
            except ValueError:
                pass
            columns[re.sub(r"\[.*\]$", "", head.strip())] = column
        return columns


def _wait(process, limit):
    try:
        return process.wait(limit)
    except subprocess.TimeoutExpired:
        pass
    group = os.getpgid(process.pid) == process.pid
    for number in (signal.SIGTERM, signal.SIGKILL):
        (os.killpg if group else os.kill)(process.pid, number)
        try:
            process.wait(5)
            break
        except subprocess.TimeoutExpired:
            pass
    return 124


def until(condition, seconds=60):
    """Wait until the condition, a function, is true; returns what it returned last."""
    end = time.monotonic() + seconds
    while not (value := condition()) and time.monotonic() < end:
        time.sleep(0.05)
    return value

# ---- fields, tables, snapshots ---------------------------------------------------------------------


def read_field(path, cells=None):
    """See Case.field."""
    text = Path(path).read_text()
    text = text[text.index("}", text.index("FoamFile")) + 1:]
    if (start := text.find("internalField")) >= 0:
        text = text[start:]
        if uniform := re.match(r"internalField\s+uniform\s+([^;]*);", text):
            return _repeated(uniform[1], cells or 1)
    return _listed(text, path)


def _listed(text, name):
    """The numbers of OpenFOAM's N(...) or N{...}."""
    listed = re.search(r"(\d+)\s*([({])", text)
    if not listed:
        raise ValueError(f"{name} has no list of numbers")
    n, text = int(listed[1]), text[listed.end():]
    if listed[2] == "{":                              # N{entry}: all are equal
        return _repeated(text[:text.index("}")], n)
    depth = 1
    for bracket in re.finditer("[()]", text):
        depth += 1 if bracket[0] == "(" else -1
        if depth == 0:
            break
    values = _numbers(text[:bracket.start()])
    return values if values.size == n else values.reshape(n, -1)


def _numbers(text):
    return np.array(re.sub("[()]", " ", text).split(), float)


def _repeated(text, n):
    value = _numbers(text)
    return np.tile(value, (n, 1)) if "(" in text else np.repeat(value, n)


def largest(values):
    """The largest magnitude; an error without values."""
    return float(np.max(np.abs(values)))


def difference(a, b):
    """The largest magnitude of a - b; an error when they differ in shape or have no values."""
    a, b = np.asarray(a), np.asarray(b)
    if a.shape != b.shape:
        raise ValueError(f"{a.shape} and {b.shape} are different shapes")
    return largest(a - b)


def close(a, b, share):
    """|a - b| <= share |b|"""
    return bool(abs(a - b) <= share*abs(b))


def worst(log, key):
    """The largest number after "key " in a log, nan when one of them is; an error when there is none."""
    return float(np.max([float(number) for number in re.findall(rf"{re.escape(key)} ([-+0-9.einfa]+)", log)]))


def agrees(a, b):
    """Both files exist, are not empty, and have the same bytes."""
    a, b = Path(a).read_bytes(), Path(b).read_bytes()
    return bool(a) and a == b


def snapshot_hash(path):
    """The fingerprint of a snapshot of the DEM core."""
    return subprocess.run(["dem", "hash", str(path)], check=True, capture_output=True, text=True).stdout.strip()


def vector(values):
    """(x y z), with all digits"""
    return "(" + " ".join(f"{x:.17g}" for x in values) + ")"


def head(kind, name):
    """The head of a file of OpenFOAM."""
    return f"FoamFile {{ version 2.0; format ascii; class {kind}; object {name}; }}\n"
