"""test_suna.py -- the package suna returns the numbers of the core and of its files. Prints TAP.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import os
import signal
import sys
import tempfile
import threading
import time
from pathlib import Path

import numpy

import suna
from tap import finish, run_tests

SCENE = """
materials { glass { density 2500; youngsModulus 1e7; poissonsRatio 0.25; } }
effects { gravity { acceleration (0 0 -9.81); } hertz {} dry { restitution 0.7; } mindlin { friction 0.4; } }
walls { floor { type plane; material glass; point (0 0 0); normal (0 0 1); } }
insert { grains { type random; count 300; diameter 1e-3; min (-0.004 -0.004 0); max (0.004 0.004 0.02); seed 1; } }
"""


def refused(call, *words):
    """The sentence of the error that the call must raise."""
    try:
        call()
    except suna.SunaError as error:
        assert all(word in str(error) for word in words), str(error)
        return
    raise AssertionError("nothing was raised")


def copies():
    """arrays hold the core's state at the moment of the call"""
    sim = suna.Simulation(SCENE)
    x, m, r = sim.position, sim.mass, sim.radius
    assert x.shape == (300, 3) and len(sim) == 300
    assert numpy.allclose(m, 2500*4/3*numpy.pi*r**3, rtol=1e-14)
    before = x[numpy.argsort(sim.id), 2]
    sim.advance(1e-3)
    assert (before - sim.position[numpy.argsort(sim.id), 2] > 0).sum() > 200


def free_fall():
    """a falling grain has the closed form"""
    sim = suna.Simulation(SCENE.split("insert")[0])
    sim.add_particles([[0, 0, 1]], 1e-3, "glass", velocity=(0.3, 0, 0))
    sim.advance(0.1)
    assert numpy.allclose(sim.position[0], [0.03, 0, 1 - 0.5*9.81*0.01], atol=1e-12)
    assert numpy.allclose(sim.velocity[0], [0.3, 0, -0.981], atol=1e-12)
    assert abs(sim.time - 0.1) < 1e-12


def scenes():
    """a scene as dict, as text and as file is the same; settings override it"""
    entries = {"materials": {"glass": {"density": 2500, "youngsModulus": 1e7, "poissonsRatio": 0.25}},
               "effects": {"gravity": {"acceleration": (0, 0, -9.81)}, "hertz": {},
                           "dry": {"restitution": 0.7}, "mindlin": {"friction": 0.4}},
               "walls": {"floor": {"type": "plane", "material": "glass", "point": (0, 0, 0),
                                   "normal": numpy.array([0, 0, 1])}},
               "insert": {"grains": {"type": "random", "count": 300, "diameter": 1e-3,
                                     "min": (-0.004, -0.004, 0), "max": (0.004, 0.004, 0.02),
                                     "seed": 1}}}
    Path("scene.dem").write_text(SCENE)
    hashes = []
    for scene in (SCENE, entries, "scene.dem", Path("scene.dem")):
        sim = suna.Simulation(scene)
        sim.advance(0.005)
        hashes.append(sim.hash)
    assert len(set(hashes)) == 1
    other = suna.Simulation(SCENE, {"insert/grains/count": 10, "effects/dry/restitution": 0.5})
    assert len(other) == 10


def errors():
    """errors have the core's sentence"""
    refused(lambda: suna.Simulation("effects { herz {} }").setup(), "materials")
    refused(lambda: suna.Simulation(SCENE.replace("hertz", "herz")).setup(), "hertz")
    refused(lambda: suna.Simulation("no-such-file.dem"), "no-such-file.dem")
    sim = suna.Simulation(SCENE).setup()
    refused(lambda: sim.add_particles([0, 0, 0], 1e-3, "glass"), "set up already")
    refused(lambda: sim.energy, "energy")


def restart():
    """a run that continues from a snapshot has the same bits"""
    whole = suna.Simulation(SCENE)
    whole.advance(0.01)
    whole.save("half.dem")
    whole.advance(0.01)
    again = suna.Simulation(SCENE, start="half.dem")
    assert abs(again.time - 0.01) < 1e-12
    again.advance(0.01)
    assert again.hash == whole.hash


def energies():
    """the energy balance: its terms add up, and nothing is created"""
    sim = suna.Simulation(SCENE, energy=True)
    sim.advance(0.05)
    energy = sim.energy
    assert abs(energy["residual"]) < 0.01*abs(energy["gravity"])
    assert abs(energy["kinetic_translation"] + energy["kinetic_rotation"]
               - sim.totals["kinetic"]) < 1e-12


def load():
    """the floor bears the weight"""
    sim = suna.Simulation(SCENE.replace("restitution 0.7", "restitution 0.1"))
    sim.advance(0.3)
    sim.reset_impulses()
    sim.advance(0.2)
    impulse, _ = sim.walls["floor"].impulse
    assert abs(abs(impulse[2])/0.2/(9.81*sim.mass.sum()) - 1) < 0.02


def files():
    """a snapshot that was written holds the particles of the simulation"""
    sim = suna.Simulation(SCENE)
    sim.advance(0.01)
    sim.save("state.dem")
    state = suna.read_snapshot("state.dem")
    a, b = numpy.argsort(state["particles"]["id"]), numpy.argsort(sim.id)
    for name in ("position", "velocity", "radius", "mass", "spin"):
        assert (state["particles"][name][a] == getattr(sim, name)[b]).all(), name
    assert state["time"] == sim.time and state["materials"] == ["glass"]
    sim.advance(0.12)
    sim.save("state.dem")
    keys = suna.read_snapshot("state.dem")["contacts"]
    assert len(keys) > 0 and set(keys["low"]) <= set(sim.id) and all(h in sim.id or h < 0 for h in keys["high"])
    whole = Path("state.dem").read_bytes()
    flipped = bytearray(whole)
    flipped[-9] ^= 1
    for damaged, words in ((whole[:-8], "damaged"), (bytes(flipped), "damaged")):
        Path("damaged.dem").write_bytes(damaged)
        try:
            suna.read_snapshot("damaged.dem")
            raise AssertionError("a damaged file was read")
        except suna.FileError as error:
            assert words in str(error), error
    assert sim.lost()["position"].shape == (0, 3) and sim.lost()["id"].dtype == numpy.int64
    Path("short.dem").write_bytes(Path("state.dem").read_bytes()[:100])
    try:
        suna.read_snapshot("short.dem")
        raise AssertionError("a short file was read")
    except suna.FileError as error:
        assert "100 bytes" in str(error)
    try:
        suna.tables(".")
        raise AssertionError("there are no tables")
    except suna.FileError as error:
        assert "postProcessing/dem" in str(error) and "effects.csv" in str(error)


def program():
    """tables and pictures of the program dem are read with names, units and effects"""
    assert os.system(f'{os.environ["DEM"]} run -set write/interval 0.01 -set write/walls 0.01 '
                     '-set write/energy 0.01 -set write/csv yes -set write/folder \'"out"\' -set time/end 0.03 scene.dem > log 2>&1') == 0
    walls = suna.read_table("out/walls.csv")
    assert len(walls) == 3 and walls.attrs["units"]["fz"] == "N"
    assert walls.attrs["effects"] == ["hertz", "dry", "mindlin", "gravity"]
    tables = suna.tables("out")
    assert set(tables) == {"walls", "energy"} and tables["walls"].equals(walls), set(tables)
    assert tables["energy"].attrs["effects"] == walls.attrs["effects"]
    last = suna.read_vtp(sorted(Path("out").glob("particles_*.vtp"))[-1])
    state = suna.read_snapshot("out/snapshot.dem")["particles"]
    a, b = numpy.argsort(last["id"]), numpy.argsort(state["id"])
    assert numpy.allclose(last["points"][a], state["position"][b], rtol=1e-14)
    assert numpy.allclose(last["velocity"][a], state["velocity"][b], rtol=1e-6, atol=1e-6)


def vtk():
    """to_vtk writes the points and arrays that the program writes of the same state"""
    program_step = "-set write/interval 0.03 -set write/folder '\"vtk\"' -set time/end 0.03"
    assert os.system(f'{os.environ["DEM"]} run {program_step} scene.dem > log 2>&1') == 0
    sim = suna.Simulation(Path("scene.dem"))
    sim.advance(0.03)
    sim.to_vtk("own.vtp")
    own, other = (suna.read_vtp(name) for name in ("own.vtp", "vtk/particles_000001.vtp"))
    assert set(other) == set(own), set(other) ^ set(own)
    a, b = numpy.argsort(own["id"]), numpy.argsort(other["id"])
    for name in ("id", "material", "points", "diameter", "velocity", "spin", "force"):
        assert numpy.array_equal(own[name][a].astype(other[name].dtype), other[name][b]), name
    assert numpy.array_equal(own["connectivity"], other["connectivity"])


def resting():
    """a grain at rest on a floor: its virial is -weight times radius; the heat of three grains is m c T"""
    sim = suna.Simulation(SCENE.split("insert")[0].replace("restitution 0.7", "restitution 0.2"),
                          virial=True)
    sim.add_particles([[0, 0, 0.499e-3]], 1e-3, "glass")
    sim.advance(0.3)
    expected = -sim.mass[0]*9.81*sim.position[0, 2]
    assert abs(sim.virial[0, 2]/expected - 1) < 1e-3, (sim.virial[0], expected)
    assert abs(sim.virial[0, :2]).max() < 1e-3*abs(expected)
    assert "particle-steps" in sim.profile() and sim.warnings(1.0) == ""
    assert "WARNINGS" in suna.Simulation(SCENE.replace("-9.81", "9.81")).warnings(1.0)
    warm = suna.Simulation(SCENE.split("walls")[0].replace("effects {", "effects { conduction {}").replace(
        "density 2500;", "density 2500; conductivity 1; heatCapacity 800;"))
    warm.add_particles(2e-3*numpy.eye(3), 1e-3, "glass")
    warm.set_scalar("temperature", 300)
    assert abs(warm.total("temperature")/(warm.mass.sum()*800*300) - 1) < 1e-14


def grid():
    """averages of the scene's grids are written where the program says"""
    sim = suna.Simulation(SCENE + "averages { box { min (-0.005 -0.005 0); max (0.005 0.005 0.02); cells (1 1 2); interval 1e-3; } }")
    sim.advance(2e-3)
    Path("averages").mkdir()
    sim.averages("averages")
    assert "solid" in suna.read_table("averages/box.csv").columns.str.cat(), suna.read_table("averages/box.csv").columns
    warm = suna.Simulation(SCENE.split("walls")[0].replace("effects {", "effects { conduction {}").replace(
        "density 2500;", "density 2500; conductivity 1; heatCapacity 800;") +
        "averages { warm { min (-0.005 -0.005 0); max (0.005 0.005 0.02); interval 1e-3; } }")
    warm.add_particles([[0, 0, 0.005], [0, 0, 0.012]], [1e-3, 2e-3], "glass")
    warm.set_scalar("temperature", [300, 390])
    warm.advance(1e-3)
    warm.averages("averages")
    table = suna.read_table("averages/warm.csv")
    mean = table["particleTemperature"][0]
    assert abs(mean/((300 + 8*390)/9) - 1) < 1e-8 and table.attrs["units"]["particleTemperature"] == "K", mean


def progress():
    """a callback is called while it advances"""
    calls = []
    sim = suna.Simulation(SCENE)
    sim.advance(0.05, progress=lambda time, steps: calls.append((time, steps)), interval=0.01)
    assert calls and 0 < calls[-1][0] <= 0.05 and calls[-1][1] > 0


def interrupted():
    """Ctrl-C ends an advance after a step; the run can continue"""
    sim = suna.Simulation(SCENE).setup()
    threading.Timer(0.3, os.kill, (os.getpid(), signal.SIGINT)).start()
    began = time.monotonic()
    try:
        sim.advance(1e3)
        raise AssertionError("it was not interrupted")
    except KeyboardInterrupt:
        pass
    assert time.monotonic() - began < 10 and 0 < sim.time < 1e3
    sim.advance(1e-3)


def plots():
    """plot draws all particles; the repr tells what there is"""
    import matplotlib
    matplotlib.use("Agg")
    sim = suna.Simulation(SCENE)
    axes = sim.plot()
    assert len(axes.collections[0].get_offsets()) == 300
    assert "300 particles, 1 wall, " in repr(sim) and "hertz" in repr(sim)
    assert "effects" in sim.plan(1.0).lower()


if __name__ == "__main__":
    os.chdir(tempfile.mkdtemp(dir=sys.argv[1]))
    run_tests(copies, free_fall, scenes, errors, restart, energies, load, files, program, vtk,
        resting, grid, progress, interrupted, plots)
    finish()
