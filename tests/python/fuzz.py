"""fuzz.py SEED CALLS -- random calls of the package with random arguments, in a separate process:
each may only succeed, be refused with a SunaError or FileError, or raise what its callback raises; no
signal may end the process. The readers get random files, too.

Prints the number of calls and of refusals. Run it for longer after a change of the package:

    for seed in $(seq 100 200); do python3 fuzz.py $seed 2000 || echo "seed $seed"; done

SPDX-License-Identifier: GPL-3.0-or-later
"""
import copy
import os
import pickle
import random
import resource
import sys
import tempfile
from collections import Counter
from pathlib import Path

import numpy

import suna

PHYSICS = ("materials { glass { density 2500; youngsModulus 1e6; conductivity 1; heatCapacity 800; } }"
           "effects { gravity { acceleration (0 0 -9.81); } hertz {} dry { restitution 0.5; } %s }"
           "time { step 1e-5; maxOverlap 0.5; } domain { min (-1 -1 -1); max (1 1 1); leaving remove; }")
FLOOR = "walls { floor { type plane; point (0 0 0); normal (0 0 1); } }"
GRAINS = "insert { a { type lattice; count %d; diameter 1e-3; spacing 1.2; min (0 0 0); max (0.02 0.02 0.02); } %s }"
STREAM = "later { type stream; rate 1e5; count 500; diameter 1e-3; min (0 0 0.1); max (0.1 0.1 0.2); }"
SCENES = [PHYSICS % "" + FLOOR + GRAINS % (30, ""), PHYSICS % "conduction {}" + FLOOR + GRAINS % (8, ""),
          PHYSICS % "" + GRAINS % (5, STREAM), PHYSICS % "", PHYSICS % "" + FLOOR,
          PHYSICS % "" + GRAINS % (40, "") + "averages { box { min (0 0 0); max (0.02 0.02 0.02); interval 1e-4; } }",
          PHYSICS % "" + FLOOR + "shapes { rod { spheres ((0 0 0 5e-4) (8e-4 0 0 5e-4)); } } insert { rods { type list; "
          "shape rod; positions ((0 0 0.001) (0 0.01 0.01)); } }",
          {"materials": {"glass": {"density": 2500, "youngsModulus": 1e7}}, "effects": {"hertz": {}}},
          "materials {", "", "effects { herz {} }", "no-such-file"]


class Fault(Exception):
    """raised by a callback"""


def fault(*_):
    raise Fault


ODD = [None, True, False, 0, 3, -1, 7, 2**31, 2**63, -2**63, 10**400, 0.5, -0.0, 1e-3, 1e300, -1e300, 5e-324,
       float("nan"), float("inf"), float("-inf"), 1j, "", "glass", "temperature", "time/end", "a\0b", "\ud800", "%s%n",
       "x"*5000, "{", "(0 0 0)", b"", b"glass", b"a\0b", Path("."), Path("/no/such/folder"), [], [[]], [1, 2, 3], [1, [2]],
       ["glass", 5], {}, {"a": 1}, {1: {}}, set(), object(), fault, Fault, range(3), numpy.zeros(3), numpy.zeros((0, 3)),
       numpy.eye(3), numpy.ones((4, 3)), numpy.ones((2, 3, 3)), numpy.full((1, 3), numpy.nan), numpy.array("glass"),
       numpy.arange(12)[::4], numpy.ones(3, "f4"), numpy.ones(3, ">f8"), numpy.ones(3, bool), numpy.uint64(2**64 - 1),
       numpy.array([1e-3, None], object), numpy.float32(1e-3), numpy.array(5), numpy.ma.masked_array([1.0, 2.0], [0, 1])]
LONG = (1, 3, 5, 7, 2**31, 0.5)
# arguments that are taken, so that calls come as far as the core
GOOD = {"position": [[0.5, 0.5, 0.5], numpy.random.default_rng(1).random((5, 3)), [0, 0, 0.1]], "diameter": [1e-3, 2e-3],
        "material": ["glass"], "shape": ["rod"], "velocity": [0.0, [0, 0, -1]], "spin": [0.0, [9, 0, 0]], "id": [None, 1000, range(2000, 2005)],
        "frozen": [False, True], "name": ["w", "temperature", "floor"], "triangles": [numpy.eye(3), numpy.ones((2, 3, 3))],
        "duration": [1e-5, 1e-4, 1e-3], "progress": [None, fault, lambda *_: None], "interval": [0, 0.001], "until": [None, None, fault, lambda s: s.time > 1e-4], "every": [1, 10, 100], "path": ["out", "x.dem"],
        "folder": [".", "nowhere"], "values": [300, [300]*8], "scene": SCENES, "settings": [None, {"time/step": 5e-6}],
        "start": [None], "comm": [None], "energy": [False, True], "orientation": [False, True], "virial": [False, True],
        "without": [None, "dry"], "ids": [0, [1, 2], range(3), []], "smallest": [1e-3, 5e-4], "largest": [1e-3, 3e-3],
        "entries": [{"effects/dry/restitution": 0.9}, {"walls/floor": None}, {"time/step": 5e-6}, {"walls/floor/motion":
                    {"type": "translation", "velocity": (0, 0, -1)}}], "function": [fault, lambda p: setattr(p, "force", 1e-6)]}
TAKES = {"add_particles": ("position", "diameter", "material", "velocity", "spin", "id", "frozen"),
         "add_wall": ("name", "material", "triangles"), "value": ("path",), "names": ("path",),
         "advance": ("duration", "progress", "interval", "until", "every"), "scalar": ("name",), "set_scalar": ("name", "values"),
         "total": ("name",), "averages": ("folder",), "warnings": ("duration",), "plan": ("duration",), "save": ("path",),
         "to_vtk": ("path",), "add": ("position", "diameter", "material", "velocity", "spin", "id", "frozen"),
         "add_clumps": ("position", "shape", "material", "velocity", "spin", "id", "frozen"), "entries": ("path",),
         "remove": ("ids",), "set": ("ids", "position", "velocity", "spin", "frozen"), "change": ("entries",),
         "wall": ("name",), "allow_diameters": ("material", "smallest", "largest"), "add_force": ("function",),
         "remove_force": ("function",)}
NEW = ("scene", "settings", "start", "comm", "energy", "orientation", "virial", "without")
USES = [name for name in dir(suna.Simulation) if not name.startswith("_") and name not in ("plot", "to_pyvista")]
READERS = (suna.read_table, suna.read_vtp, suna.read_snapshot, lambda path: list(suna.read_record(path)))


def argument(name, odd):
    """A value for this argument; a duration is short, or refused."""
    value = random.choice(ODD if random.random() < odd else GOOD[name])
    return 1e300 if name == "duration" and not isinstance(value, list) and numpy.ndim(value) == 0 and value in LONG \
        else value


def arguments(names, odd):
    return {name: argument(name, odd) for name in names if name in names[:1] or random.random() < 0.5}


def create():
    return suna.Simulation(**arguments(NEW, 0.1))


def use(sim):
    """A call of the simulation; what it returns is read."""
    name = random.choice(USES)
    if name in ("plan", "close", "change", "allow_diameters", "add_wall") and random.random() < 0.8:    # the one is slow, the other final
        name = "advance"
    if isinstance(getattr(suna.Simulation, name), property):
        value = getattr(sim, name)
    else:
        odd = random.choice((0, 0, 0.2, 0.5))
        given = {k: argument(k, odd) for k in TAKES.get(name, ())}
        value = getattr(sim, name)(**given)
    if name == "view":
        with value as p:
            value = [getattr(p, random.choice(("position", "id", "force"))), use(sim)][0]
    if name == "walls":
        value = [(wall.load, wall.corners, wall.name) for wall in value.values()]
    return value


def refuse_copy(sim):
    try:
        random.choice((copy.copy, copy.deepcopy, pickle.dumps))(sim)
    except TypeError:
        return
    raise AssertionError("a simulation was copied")


def spoilt(sims):
    """A reader gets a file of a simulation, with some bytes changed or cut off."""
    kept = sorted(Path(".").glob("kept.*"))
    if not kept:
        sim = suna.Simulation(SCENES[0])
        sim.save("kept.dem")
        sim.to_vtk("kept.vtp")
        return
    raw = bytearray(random.choice(kept).read_bytes())
    for _ in range(random.choice((0, 1, 1, 3, 30))):
        raw[random.randrange(len(raw))] = random.randrange(256)
    Path("spoilt").write_bytes(raw[:random.choice((len(raw), random.randrange(len(raw) + 1)))])
    if random.random() < 0.3:
        suna.Simulation(SCENES[0], start="spoilt").setup()
    else:
        random.choice(READERS)("spoilt")


def main():
    seed, calls = map(int, sys.argv[1:])
    random.seed(seed)
    os.chdir(tempfile.mkdtemp(dir=os.environ.get("TMPDIR")))
    resource.setrlimit(resource.RLIMIT_AS, (4 << 30, 4 << 30))
    sims, outcomes, kept = [], Counter(), []
    for k in range(calls):
        state = random.getstate()
        try:
            if not sims or random.random() < 0.1:
                sims.append(create())
            elif random.random() < 0.1:
                sims.pop(random.randrange(len(sims)))
            elif random.random() < 0.05:
                refuse_copy(random.choice(sims))
            elif random.random() < 0.1:
                spoilt(sims)
            else:
                kept.append(use(random.choice(sims)))
            outcomes["done"] += 1
        except (suna.SunaError, suna.FileError, Fault, OSError) as error:
            assert str(error) or isinstance(error, Fault)
            outcomes[type(error).__name__] += 1
            if "closed" in str(error) or "failed" in str(error):
                sims = [sim for sim in sims if random.random() < 0.3]
        except BaseException:
            random.setstate(state)
            print(f"call {k} of seed {seed}", file=sys.stderr)
            raise
        for value in kept[-20:]:
            if isinstance(value, numpy.ndarray) and value.dtype != object:
                value.sum()
    print(dict(outcomes))


if __name__ == "__main__":
    main()
