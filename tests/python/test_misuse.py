"""test_misuse.py -- no misuse of the package ends the process or mistakes a value: arrays that
outlive their simulation, copies, closed simulations, exceptions of callbacks, threads. Wrong
arguments are refused with a sentence. Prints TAP.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import copy
import os
import pickle
import sys
import tempfile
import threading
from pathlib import Path

import numpy

import suna
from tap import finish, run_tests

PHYSICS = """
materials { glass { density 2500; youngsModulus 1e7; poissonsRatio 0.25; } }
effects { gravity { acceleration (0 0 -9.81); } hertz {} dry { restitution 0.7; } }
"""
SCENE = PHYSICS + """
walls { floor { type plane; point (0 0 0); normal (0 0 1); } }
insert { grains { type lattice; count 5000; diameter 1e-3; spacing 1.5; min (0 0 0); max (0.03 0.03 0.05); } }
"""
# grows from 100 to 20000 grains
GROWING = PHYSICS + """
insert
{
    first { type lattice; count 100; diameter 1e-3; spacing 1.5; min (0 0 0); max (0.02 0.02 0.02); }
    later { type stream; rate 2e7; count 19900; diameter 1e-3; velocity (0 0 -1); min (0 0 0.1); max (0.1 0.1 0.2); }
}
"""
WARM = PHYSICS.replace("effects {", "effects { conduction {}").replace(
    "density 2500;", "density 2500; conductivity 1; heatCapacity 800;")


def refused(call, *words):
    """The call raises a SunaError that has these words, in one line."""
    try:
        value = call()
    except suna.SunaError as error:
        assert all(word in str(error) for word in words) and "\n" not in str(error), str(error)
        return
    raise AssertionError(f"nothing was raised; it returned {value!r}")


def of_a_temporary():
    """an array is valid when nothing else holds its simulation"""
    x = suna.Simulation(SCENE).position
    other = suna.Simulation(SCENE)       # takes the memory that is free now
    assert abs(x[:, 0].mean() - other.position[:, 0].mean()) < 1e-15 and x.min() > 0
    assert suna.Simulation(SCENE).mass.sum() > 0 and suna.Simulation(SCENE).walls["floor"].load


def kept():
    """arrays keep their values over an insertion, an advance and the end of the simulation"""
    sim = suna.Simulation(GROWING)
    names = ("position", "velocity", "spin", "radius", "mass", "id", "force", "torque", "material")
    found = {name: getattr(sim, name) for name in names}
    before = {name: array.copy() for name, array in found.items()}
    sim.advance(2e-3)
    assert len(sim) > 10000
    for name in names:
        assert (found[name] == before[name]).all(), name
    state = sim.hash
    sim.close()
    other = suna.Simulation(GROWING)
    other.advance(2e-3)
    for name in names:
        assert (found[name] == before[name]).all(), name
    assert other.hash == state


def read_only():
    """an array cannot be written; set_scalar sets a particle scalar within its limits"""
    sim = suna.Simulation(WARM)
    sim.add_particles(2e-3*numpy.eye(3), 1e-3, "glass")
    for array in (sim.position, sim.mass, sim.scalar("temperature")):
        try:
            array[:] = 1.0
            raise AssertionError("it was written")
        except ValueError as error:
            assert "read-only" in str(error)
    sim.set_scalar("temperature", [300, 310, 320])
    assert list(sim.scalar("temperature")) == [300, 310, 320]
    sim.set_scalar("temperature", 295)
    assert abs(sim.total("temperature")/(sim.mass.sum()*800*295) - 1) < 1e-14
    for value in (-1, numpy.nan, numpy.inf, [300, 310, -1e9]):
        refused(lambda: sim.set_scalar("temperature", value), "temperature", "K", "give a number from")
    refused(lambda: sim.set_scalar("temperature", [300, 310]), "temperature", "shape (2,)", "(3,)")
    refused(lambda: sim.set_scalar("temperature", "hot"), "temperature", "hot", "numbers")
    refused(lambda: sim.scalar("temperatur"), "temperatur", "it has temperature")
    assert (sim.scalar("temperature") == 295).all()


def copies():
    """a simulation is neither copied nor pickled, and continues after the attempt"""
    sim = suna.Simulation(SCENE).setup()
    for call in (copy.copy, copy.deepcopy, pickle.dumps, lambda sim: copy.deepcopy(sim.walls)):
        try:
            call(sim)
            raise AssertionError("it was copied")
        except TypeError as error:
            assert "copied or pickled" in str(error) and "start=" in str(error), error
    try:
        sim.__init__(SCENE)
        raise AssertionError("it was created twice")
    except suna.SunaError:
        pass
    sim.advance(1e-4)


class Fault(Exception):
    """raised by a callback"""


def callbacks():
    """an exception in progress ends the advance after a step and reaches the caller; the rest has the
    same bits as without it, also after a force that fails"""
    whole = suna.Simulation(SCENE)
    whole.advance(0.01)
    for kind in (Fault, KeyboardInterrupt, SystemExit):
        def progress(time, steps):
            raise kind("halt")
        sim = suna.Simulation(SCENE)
        try:
            sim.advance(0.01, progress, interval=0)
            raise AssertionError("nothing was raised")
        except kind as error:
            assert str(error) == "halt"
        assert 0 < sim.time < 0.01, sim.time
        before, hash = sim.time, sim.hash
        for force in (progress, lambda p: p.force.fill(numpy.nan)):
            sim.add_force(lambda p: force(p, 0) if force is progress else force(p))
            try:
                sim.advance(0.005)
                raise AssertionError("nothing was raised")
            except (kind, suna.SunaError) as error:
                assert str(error) == "halt" or "not a number" in str(error) and "before this advance" in str(error), error
            assert sim.time == before and sim.hash == hash
            sim.remove_force(sim._forces[0])
        refused(lambda: sim.remove([0]), "by a step", "or by the rest")
        sim.advance(0.01 - sim.time)
        assert abs(sim.time - 0.01) < 1e-12 and sim.hash == whole.hash
    sim = suna.Simulation(SCENE)
    for call in (lambda *_: sim.position, lambda *_: sim.advance(1), lambda *_: sim.close(),
                 lambda *_: sim.walls):
        refused(lambda: sim.advance(0.01, call, interval=0), "advancing", "progress")
    refused(lambda: sim.advance(0.01, "progress"), "progress", "function")
    sim.advance(1e-4)


def every_use(sim):
    """Each public method and property, with arguments that it takes: name and call."""
    arguments = {"add_particles": ([0, 0, 0], 1e-3, "glass"), "add_wall": ("w", "glass", numpy.eye(3)),
                 "value": ("time/end",), "advance": (1e-6,), "scalar": ("temperature",),
                 "add_clumps": ([0, 0, 1], "rod", "glass"), "entries": ("time",),
                 "set_scalar": ("temperature", 1), "total": ("temperature",), "averages": (".",),
                 "warnings": (1,), "plan": (1,), "save": ("x",), "to_vtk": ("x.vtp",),
                 "add": ([0, 0, 0], 1e-3, "glass"), "remove": ([1],), "set": ([1],), "change": ({},),
                 "allow_diameters": ("glass", 1e-3, 1e-3), "wall": ("floor",)}
    for name in dir(suna.Simulation):
        if name.startswith("_") or name in ("close", "add_force", "remove_force", "to_pyvista"):
            continue
        if name == "view":
            yield name, lambda: sim.view().__enter__()
            continue
        if isinstance(getattr(suna.Simulation, name), property):
            yield name, lambda: getattr(sim, name)
        else:
            yield name, lambda: getattr(sim, name)(*arguments.get(name, ()))
    yield "len", lambda: len(sim)


def closed():
    """each use of a closed simulation, and of its walls, says that it is closed"""
    sim = suna.Simulation(SCENE)
    wall = sim.walls["floor"]
    sim.close()
    sim.close()
    uses = list(every_use(sim))
    assert len(uses) > 40, len(uses)
    for name, call in every_use(sim):
        refused(call, "closed")
    for call in (lambda: wall.load, lambda: wall.impulse, lambda: wall.corners):
        refused(call, "closed")
    assert repr(sim) == "Simulation(closed)" and wall.name == "floor"
    for name, call in every_use(suna.Simulation.__new__(suna.Simulation)):
        refused(call, "never created")


def threads():
    """a second thread is refused while the first one advances"""
    sim = suna.Simulation(SCENE).setup()
    started, end = threading.Event(), threading.Event()

    def progress(time, steps):
        started.set()
        if end.is_set():
            raise Fault

    def advance():
        try:
            sim.advance(1e3, progress, interval=0)
        except Fault:
            pass

    thread = threading.Thread(target=advance, daemon=True)
    thread.start()
    assert started.wait(60)
    try:
        for name, call in every_use(sim):
            refused(call, "another thread")
        refused(sim.close, "another thread")
    finally:
        end.set()
        thread.join(60)
    assert not thread.is_alive() and sim.time > 0
    sim.advance(1e-4)


def arguments():
    """wrong types and values of arguments are refused, none is taken for another one"""
    def added(**given):
        sim = suna.Simulation(PHYSICS)
        sim.add_particles(**{"position": [0, 0, 0], "diameter": 1e-3, "material": "glass", **given})
        return sim.setup()

    for value in (1.5, 1.0, True, "1", -1, -2**63, 2**63 - 1, 2**63, 10**30, numpy.nan, [1, "2"], {}):
        refused(lambda: added(id=value), "id", "whole numbers")
    assert added(id=2**62).id[0] == 2**62 and added(id=numpy.uint8(7)).id[0] == 7
    # a short vector is not filled up with zeros
    for value in ([0, 0], [[0, 0], [1, 1]], 0, [0, 0, 0, 0], [[[0, 0, 0]]], "abc", [[0, 0, 0], [1]], [None]*3):
        refused(lambda: added(position=value), "position")
    for value in ("1e-3", None, True, [1e-3, 2e-3], 1e-3j, b"1", {}):
        refused(lambda: added(diameter=value), "diameter")
    refused(lambda: added(diameter=numpy.nan), "diameter")
    for value in (5, None, b"glass", "gl\0ass", "\ud800", ["glass", "glass"], "steel"):
        refused(lambda: added(material=value))
    for value in ("no", 2, None, [True, False], 0.5):
        refused(lambda: added(frozen=value), "frozen")
    for value in ([1, 2], "fast", numpy.ones((2, 3))):
        refused(lambda: added(velocity=value), "velocity")
        refused(lambda: added(spin=value), "spin")
    assert len(added(position=numpy.eye(3))) == 3
    none = suna.Simulation(PHYSICS, {"time/step": 1e-6})
    none.add_particles([], 1e-3, "glass")
    assert len(none) == 0 and none.position.shape == (0, 3) and none.material.shape == (0,)

    sim = suna.Simulation(PHYSICS)
    for value in (numpy.eye(2), [[0, 0, 0]], "abc", numpy.ones((2, 9)), [1]*9):
        refused(lambda: sim.add_wall("w", "glass", value), "triangles", "numbers" if isinstance(value, str) else "(n, 3, 3)")
    refused(lambda: sim.add_wall("w\0x", "glass", numpy.eye(3)), "NUL")
    sim = suna.Simulation(SCENE)
    for value in ("1", None, True, [1, 2], numpy.nan, -1, 0, numpy.inf, 1j, 10**400):
        refused(lambda: sim.advance(value), "duration")
    refused(lambda: sim.advance(1e-6, print, interval="often"), "interval")
    for value in ("x", None, True):
        refused(lambda: sim.plan(value), "duration")
        refused(lambda: sim.warnings(value), "duration")


def texts():
    """a text with NUL or of another type is refused; names need not be UTF-8"""
    sim = suna.Simulation(SCENE).setup()
    for call in (sim.save, sim.to_vtk, sim.averages, sim.value, sim.names, sim.scalar, sim.total):
        refused(lambda: call("a\0b"), "NUL")
        for value in (5, None, 1.5, ["x"], True):
            refused(lambda: call(value), repr(value) if value != ["x"] else "['x']")
    assert not Path("a").exists()
    sim.save(os.fsdecode(b"gr\xfcn.dem"))
    assert os.path.exists(b"gr\xfcn.dem")
    for folder in (".", Path.cwd()):
        refused(lambda: sim.save(folder), str(folder), "is a folder")
    assert not Path("..part").exists()
    refused(lambda: sim.energy, "Simulation(..., energy=True)")
    Path("wrong.dem").write_bytes(SCENE.encode().replace(b"hertz", b"h\xe4rtz"))
    refused(lambda: suna.Simulation("wrong.dem").setup(), "did you mean hertz")
    for scene in (5, None, [], "a\0b", "materials {\0}", b"no-such-file", {1: {}}, {"a": {"b": None}},
                  {"a": {2: 3}}, {"a": b"x"}, {"a": "x\0y"}, {"a": Path('x"y')}, {"a": object()}, {}, ""):
        refused(lambda: suna.Simulation(scene).setup())
    for name in ("settings", "start", "comm", "energy", "orientation", "virial", "without"):
        for value in ("x\0y", 5, object()):
            refused(lambda: suna.Simulation(SCENE, **{name: value}).setup(), name)
    assert suna.Simulation(SCENE, {"time": {"step": 1e-6}}).step[0] == 1e-6
    refused(lambda: suna.Simulation(SCENE, {5: 1}), "settings", "5")
    refused(lambda: suna.Simulation(SCENE, energy="no"), "energy", "True or False")
    refused(lambda: sim.orientation, "orientation=True")
    assert suna.Simulation(SCENE, {"effects/dry/restitution": numpy.array(0.5),
                                   "insert/grains/count": numpy.array(7)}).id.size == 7


def failed():
    """a failed set-up is not repeated on its remains; a scene reports why"""
    sim = suna.Simulation(PHYSICS)
    sim.add_particles([[0, 0, 0], [1e-4, 0, 0]], 1e-3, "glass")
    refused(sim.setup, "overlap")
    for name, call in every_use(sim):
        if name not in ("value", "names"):
            refused(call, "failed", "start again")


if __name__ == "__main__":
    os.chdir(tempfile.mkdtemp(dir=sys.argv[1]))
    run_tests(of_a_temporary, kept, read_only, copies, callbacks, closed, threads, arguments,
        texts, failed)
    finish()
