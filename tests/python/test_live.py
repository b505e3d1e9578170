"""test_live.py -- changes between two advances: particles added, removed and set by id, walls that move
and go, entries of the scene. Prints TAP.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import os
import sys
import tempfile

import numpy

import suna
from tap import finish, run_tests
from test_misuse import refused

PHYSICS = """
materials { glass { density 2500; youngsModulus 1e7; poissonsRatio 0.25; } steel { density 7800; youngsModulus 1e7; } }
effects { gravity { acceleration (0 0 -9.81); } hertz {} dry { restitution 0.7; } mindlin { friction 0.4; } }
domain { min (-0.05 -0.05 -0.01); max (0.05 0.05 0.2); }
"""
SCENE = PHYSICS + """
walls { floor { type plane; material glass; point (0 0 0); normal (0 0 1); }
        box { type triangles; material glass; corners (%s); } }
insert { grains { type random; material glass; count 300; diameter 1e-3; min (-0.003 -0.003 0); max (0.003 0.003 0.03); seed 1; } }
""" % " ".join(f"({x} {y} {z})" for (x, y), (u, v) in zip(((-4e-3, -4e-3), (4e-3, -4e-3), (4e-3, 4e-3), (-4e-3, 4e-3)),
                                                         ((4e-3, -4e-3), (4e-3, 4e-3), (-4e-3, 4e-3), (-4e-3, -4e-3)))
               for x, y, z in ((x, y, 0), (u, v, 0), (u, v, 0.04), (x, y, 0), (u, v, 0.04), (x, y, 0.04)))


def of(sim, ids, name):
    """A quantity of the particles that have the ids, in their order."""
    order = numpy.argsort(sim.id)
    return getattr(sim, name)[order][numpy.searchsorted(sim.id[order], ids)]


def added():
    """an added particle falls as if it had been there from the start, and takes the next free id"""
    sim = suna.Simulation(SCENE)
    sim.advance(0.05)
    ids = sim.add(position=[[0.02, 0, 0.1], [0.03, 0, 0.1]], diameter=1e-3, material="glass",
                  velocity=[[0, 0, 0], [0.1, 0, 0]])
    assert list(ids) == [300, 301] and len(sim) == 302
    sim.advance(0.1)
    assert numpy.allclose(of(sim, ids, "position"), [[0.02, 0, 0.1 - 0.5*9.81*0.01],
                                                     [0.04, 0, 0.1 - 0.5*9.81*0.01]], atol=1e-12)
    assert numpy.allclose(of(sim, ids, "velocity")[:, 2], -0.981, atol=1e-12)
    assert list(sim.add([0.03, 0, 0.15], 1e-3, "glass", id=1000, frozen=True)) == [1000]
    sim.advance(0.01)
    assert (of(sim, [1000], "position") == [0.03, 0, 0.15]).all()
    assert sim.add([[-0.03, 0, 0.15]], 1e-3, "glass")[0] == 1001
    assert len(sim.add([], 1e-3, "glass")) == 0


def ids_over_restarts():
    """an id is never used twice: not of a removed particle, nor after a restart"""
    sim = suna.Simulation(SCENE)
    sim.remove([299, 5])
    assert len(sim) == 298 and 299 not in sim.id
    sim.save("ids.dem")
    again = suna.Simulation(SCENE, start="ids.dem")
    for one in (sim, again):
        assert one.add([0.03, 0, 0.1], 1e-3, "glass")[0] == 300
        one.advance(1e-3)
    assert sim.hash == again.hash
    refused(lambda: sim.add([0.03, 0, 0.15], 1e-3, "glass", id=299), "299", "none is used twice")


def snapshots():
    """edits before and after a save give the same bits; a snapshot right after edits holds them"""
    def edit(sim):
        sim.remove(numpy.arange(0, 300, 7))
        sim.add([[0.02, 0, 0.001*k] for k in range(1, 30)], 1e-3, "glass", spin=(0, 300, 0))
        sim.set([1, 2, 3], velocity=[0, 0, 1])
        sim.set([4], position=[0, 0, 0.05], frozen=True)

    one, two = suna.Simulation(SCENE), suna.Simulation(SCENE)
    one.advance(0.05)
    two.advance(0.05)
    edit(one)
    two.save("before.dem")
    two = suna.Simulation(SCENE, start="before.dem")
    edit(two)
    assert one.hash == two.hash
    two.save("after.dem")
    two = suna.Simulation(SCENE, start="after.dem")
    assert one.hash == two.hash
    one.advance(0.05)
    two.advance(0.05)
    assert one.hash == two.hash
    state = suna.read_snapshot("after.dem")
    assert len(state["particles"]["id"]) == 300 - 43 + 29


def history():
    """a bed at rest keeps the springs of its contacts when a grain is added and removed elsewhere"""
    sim = suna.Simulation(SCENE, {"effects/dry/restitution": 0.2})
    sim.advance(0.4)
    sim.save("rest.dem")
    whole = suna.Simulation(SCENE, {"effects/dry/restitution": 0.2}, start="rest.dem")
    ids = sim.add([0.03, 0, 0.1], 1e-3, "glass")
    sim.remove(ids)
    assert sim.hash == whole.hash
    sim.advance(0.01)
    whole.advance(0.01)
    assert sim.hash == whole.hash


def energy():
    """what an edit supplies is in the energy balance: kinetic and elastic energy, exactly"""
    sim = suna.Simulation(SCENE, energy=True)
    sim.advance(0.1)
    before, mass = sim.energy, sim.mass[0]
    assert "edited" not in before
    sim.add([0.03, 0, 0.1], 1e-3, "glass", velocity=(0, 0, 2))
    after = sim.energy
    assert abs(after["edited"]/(2*mass) - 1) < 1e-9 and abs(after["residual"] - before["residual"]) < 1e-15
    sim.remove(sim.id[sim.id != 300])
    after = sim.energy
    kinetic = before["kinetic_translation"] + before["kinetic_rotation"]
    elastic = sum(value for name, value in before.items() if name.startswith("elastic"))
    assert elastic > 0 and abs(after["edited"] - 2*mass + kinetic + elastic) < 1e-12*kinetic
    sim.set([300], velocity=(0, 0, 0))
    assert abs(sim.energy["edited"] + kinetic + elastic) < 1e-12*kinetic
    sim.advance(0.01)
    assert abs(sim.energy["residual"] - before["residual"]) < 1e-12*mass


def moved():
    """a particle that is set is there at once, keeps its id, and loses the forces of its old contacts"""
    sim = suna.Simulation(SCENE)
    sim.advance(0.3)
    sim.set([7, 3], position=[[0.02, 0, 0.1], [0.03, 0, 0.1]], velocity=0, spin=0)
    assert (of(sim, [3, 7], "position") == [[0.03, 0, 0.1], [0.02, 0, 0.1]]).all()
    sim.advance(0.01)
    assert numpy.allclose(of(sim, [3, 7], "position")[:, 2], 0.1 - 0.5*9.81*1e-4, atol=1e-12)
    sim.set([7], frozen=True)
    sim.advance(0.01)
    assert (of(sim, [7], "velocity") == 0).all() and of(sim, [7], "frozen")[0]
    sim.set([7], frozen=False)
    sim.advance(0.01)
    assert abs(of(sim, [7], "velocity")[0, 2] + 0.0981) < 1e-12


def scalars():
    """a particle scalar is set by id; an added particle has its default"""
    warm = suna.Simulation(PHYSICS.replace("effects {", "effects { conduction {}").replace(
        "density 2500;", "density 2500; conductivity 1; heatCapacity 800;").replace(
        "density 7800;", "density 7800; conductivity 1; heatCapacity 800;"), energy=True)
    warm.add_particles(2e-3*numpy.eye(3), 1e-3, "glass")
    warm.set([2, 0], temperature=[310, 300])
    warm.add([0, 0, 0.02], 1e-3, "glass")
    assert list(of(warm, range(4), "id")) == [0, 1, 2, 3]
    order = numpy.argsort(warm.id)
    assert list(warm.scalar("temperature")[order]) == [300, 293.15, 310, 293.15]
    warm.advance(1e-3)
    assert abs(warm.energy["residual"]) < 1e-13*warm.total("temperature")
    edited, heat = warm.energy["edited"], warm.total("temperature")
    warm.set_scalar("temperature", warm.scalar("temperature") + 5)
    gain = warm.total("temperature") - heat
    assert gain > 0 and abs(warm.energy["edited"] - edited - gain) < 1e-12*heat
    assert abs(warm.energy["residual"]) < 1e-12*heat
    refused(lambda: warm.set([1], temperature=-5), "temperature", "from")
    refused(lambda: warm.set([1], colour=5), "colour", "temperature")


def refusals():
    """what cannot be is refused with a sentence, and leaves the simulation as it was"""
    sim = suna.Simulation(SCENE)
    sim.advance(0.2)
    sim.save("kept.dem")
    before = sim.hash
    top = sim.position[numpy.argmax(sim.position[:, 2])]
    refused(lambda: sim.add(top + [0, 0, 2e-4], 1e-3, "glass"), "overlap")
    refused(lambda: sim.add([0.0039, 0, 0.03], 1e-3, "glass"), "overlaps wall box", "move it, or raise")
    refused(lambda: sim.add([0, 0, 1], 1e-3, "glass"), "outside the domain")
    refused(lambda: sim.add([0, 0, 0.1], 2e-3, "glass"), "0.002", "0.001", "allow_diameters")
    refused(lambda: sim.add([0, 0, 0.1], 1e-3, "steel"), "steel", "allow_diameters")
    refused(lambda: sim.add([0, 0, 0.1], 1e-3, "wood"), "wood", "glass")
    refused(lambda: sim.add([0, 0, numpy.nan], 1e-3, "glass"), "number")
    refused(lambda: sim.add([0, 0, 0.1], 1e-3, "glass", frozen=True, velocity=1), "frozen")
    refused(lambda: sim.remove([1000]), "1000")
    refused(lambda: sim.remove([1, 1]), "twice")
    refused(lambda: sim.remove("all"), "ids")
    refused(lambda: sim.remove([1.5]), "ids")
    refused(lambda: sim.set([1, 1000], velocity=1), "1000")
    refused(lambda: sim.set([1], velocity=[1, 2]), "velocity", "shape")
    refused(lambda: sim.set([1], velocity=1e9), "light")
    refused(lambda: sim.set([1], position=top), "overlap")
    assert sim.hash == before
    other = suna.Simulation(SCENE, start="kept.dem")
    sim.advance(0.02)
    other.advance(0.02)
    assert sim.hash == other.hash

    def halt(time, steps):
        raise KeyboardInterrupt
    try:
        sim.advance(0.1, halt, 0)
    except KeyboardInterrupt:
        pass
    refused(lambda: sim.remove([1]), "rest of it")


def clumps():
    """spheres of clumps: which belong together, bonds between them, temperatures of whole clumps, new ones by change"""
    sim = suna.Simulation(PHYSICS.replace("density", "heatCapacity 500; conductivity 1; density").replace("mindlin", """
        conduction {} bondLinear { normalStiffness 1e8; shearStiffness 5e7; make listed; } mindlin""") + """
        shapes { rod { spheres ((-2e-3 0 0 1e-3) (0 0 0 1e-3) (2e-3 0 0 1e-3)); } }
        bonds { pairs (2 3  5 6); }
        insert { rods { type list; material glass; shape rod; orientation (1 0 0 0); temperature 320;
                        positions ((0 0 0.1) (0.006 0 0.1)); }
                 ball { type list; material glass; diameter 2e-3; positions ((0.01 0 0.1)); temperature 300; } }
        """, energy=True)
    assert list(of(sim, range(7), "clump")) == [1, 1, 1, 4, 4, 4, 0]
    assert sorted(map(tuple, sim.bonds["id"])) == [(2, 3), (5, 6)]
    sim.advance(0.001)
    before, heat, C = sim.hash, sim.total("temperature"), 500*sim.mass[sim.clump == 1].sum()
    refused(lambda: sim.set([0], temperature=400), "clump", "one temperature", "particle 0")
    refused(lambda: sim.set([3, 4, 5], temperature=[400, 400, 401]), "clump", "one temperature", "particle 3")
    refused(lambda: sim.set_scalar("temperature", numpy.arange(300, 307)), "clump", "different temperatures")
    refused(lambda: sim.set([0, 1, 2], velocity=0), "moves as one body", "clump of particle 0")
    refused(lambda: sim.remove([0, 1]), "particle 2", "moves as one body", "all its spheres")
    refused(lambda: sim.remove([4]), "particle 4", "all its spheres")
    assert sim.hash == before
    sim.set([2, 0, 6, 1], temperature=[350, 350, 310, 350])
    order = numpy.argsort(sim.id)
    assert list(sim.scalar("temperature")[order]) == [350]*3 + [320]*3 + [310]
    gain = sim.total("temperature") - heat
    assert abs(gain - 30*C - 10*500*sim.mass[sim.clump == 0].sum()) < 1e-12*heat
    assert abs(sim.energy["edited"] - gain) < 1e-9*gain
    sim.add_force(lambda p: p.force.__iadd__(1e-3*(p.id[:, None] == 3)*[0, 1, 0]))
    sim.advance(1e-4)
    assert abs(sim.mass @ sim.velocity[:, 1]/1e-7 - 1) < 1e-9 and of(sim, [4], "spin")[0, 2] < 0
    sim.remove_force(sim._forces[0])
    sim.set_scalar("temperature", 320)
    sim.change({"insert/more": {"type": "list", "material": "glass", "shape": "rod", "temperature": 280,
                                "positions": "((0 0 0.05))"}})
    sim.advance(0.001)
    table = sim.to_dataframe()
    assert list(table.clump) == [1, 1, 1, 4, 4, 4, 0, 8, 8, 8] and list(table.temperature[7:]) == [280]*3
    sim.to_vtk("clumps.vtp")
    assert (suna.read_vtp("clumps.vtp")["clump"] == sim.clump).all() and sim.totals["clumps"] == 3


CLUMPS = PHYSICS + """
    shapes { rod { spheres ((-2e-3 0 0 1e-3) (0 0 0 1e-3) (2e-3 0 0 1e-3)); } bead { spheres ((0 0 0 1e-4)); } }
    insert { rods { type list; material glass; shape rod; orientation (1 0 0 0); positions ((0 0 0.1) (0 0.006 0.1)); }
             ball { type list; material glass; diameter 2e-3; positions ((0 0.012 0.1)); } }"""


def live_clumps():
    """clumps are added, moved, frozen and removed whole, with their energies; a restart gives the same bits"""
    sim, half = suna.Simulation(CLUMPS, {"effects/gravity/acceleration": (0, 0, 0)}, energy=True), numpy.sqrt(0.5)
    ids = sim.add_clumps([[0, 0.02, 0.1], [0, 0.03, 0.1]], "rod", "glass", orientation=[[1, 0, 0, 0], [half, 0, half, 0]],
                         velocity=[[0, 0, 1], [0, 0, 0]], spin=[[0, 0, 0], [0, 0, 50]])
    assert list(ids) == [7, 10] and list(of(sim, range(7, 13), "clump")) == [8, 8, 8, 11, 11, 11] and len(sim) == 13
    # the second one stands upright and spins about its axis: I = 6/5 m R^2
    m = sim.mass[sim.clump == 0][0]
    assert abs(of(sim, range(10, 13), "position")[:, 2] - [0.102, 0.1, 0.098]).max() < 1e-9
    given = 0.5*3*m + 0.5*1.2*m*1e-6*50**2
    assert abs(sim.energy["edited"]/given - 1) < 1e-9
    sim.set([0], velocity=(0.1, 0, 0), spin=(0, 0, 100), position=(0, 0, 0.15))
    assert abs(of(sim, range(3), "velocity") - [[0.1, -0.2, 0], [0.1, 0, 0], [0.1, 0.2, 0]]).max() < 1e-12
    assert abs(of(sim, range(3), "position")[:, 2] - 0.15).max() < 1e-9
    given += 0.5*3*m*0.01 + 0.5*9.2*m*1e-6*100**2
    assert abs(sim.energy["edited"]/given - 1) < 1e-9
    sim.set([7], frozen=True)
    sim.save("clumps.dem")
    other = suna.Simulation(CLUMPS, {"effects/gravity/acceleration": (0, 0, 0)}, start="clumps.dem")
    for one in (sim, other):
        one.advance(0.01)
        one.set([7], frozen=False, velocity=(0, 0, 1))
        one.remove([3, 4, 5, 6])
        one.advance(0.01)
    assert sim.hash == other.hash and sorted(sim.id) == [0, 1, 2, 7, 8, 9, 10, 11, 12]
    assert abs(of(sim, [8], "position")[0] - [0, 0.02, 0.11]).max() < 1e-9
    assert abs(sim.energy["residual"]) < 1e-6*given
    before = sim.hash
    add = lambda at, shape="rod", **more: sim.add_clumps(at, shape, "glass", **more)
    refused(lambda: add([0, 0.02, 0.11]), "overlap")
    refused(lambda: add([0, 0, 1]), "outside the domain")
    refused(lambda: add([0, 0, 0.05], "nut"), "nut", "rod")
    refused(lambda: add([0, 0, 0.05], "bead"), "bead", "group or stream")
    refused(lambda: add([0, 0, 0.05], orientation=(2, 0, 0, 0)), "quaternion")
    refused(lambda: add([0, 0, 0.05], spin=1e7), "turns by")
    refused(lambda: add([0, 0, 0.05], id=9), "none is used twice")
    refused(lambda: sim.set([0], frozen=True, velocity=1), "frozen")
    refused(lambda: sim.set([0], position=(0, 0.03, 0.1)), "overlap")
    assert sim.hash == before


def diameters():
    """allow_diameters makes time step and lists for other particles, also in a running simulation"""
    sim = suna.Simulation(SCENE)
    sim.advance(0.1)
    before, step = sim.hash, sim.step[0]
    sim.allow_diameters("steel", 0.5e-3, 4e-3)
    assert sim.hash == before and sim.step[0] < step
    sim.add([[0, 0, 0.1], [0.02, 0, 0.1]], [4e-3, 0.5e-3], "steel")
    sim.advance(0.2)
    assert len(sim) == 302 and of(sim, [300], "position")[0, 2] < 0.05
    early = suna.Simulation(PHYSICS, {"time/step": 1e-6})
    early.allow_diameters("glass", 1e-3, 1e-3)
    assert early.add([0, 0, 0.1], 1e-3, "glass")[0] == 0
    refused(lambda: early.allow_diameters("glass", 2e-3, 1e-3), "smaller first")


def walls():
    """a wall that gets a motion goes on from where it stands; one that is removed lets the bed fall"""
    gate = SCENE.replace("floor {", "gate {")
    sim = suna.Simulation(gate, {"effects/dry/restitution": 0.2})
    sim.advance(0.3)
    weight = 9.81*sim.mass.sum()
    wall = sim.wall("gate")
    assert abs(-wall.force[2]/weight - 1) < 0.3 and wall.motion == {}
    wall.motion = {"type": "translation", "velocity": (0, 0, 0.01)}
    start, low = sim.time, sim.position[:, 2].min()
    sim.advance(0.1)
    assert abs(sim.position[:, 2].min() - low - 0.001) < 1e-5 and wall.motion["type"] == "translation"
    wall.motion = {"type": "translation", "velocity": (0, 0, -0.01), "start": sim.time}
    sim.advance(0.1)
    assert abs(sim.position[:, 2].min() - low) < 1e-5
    wall.motion = None
    sim.advance(0.02)
    wall.remove()
    refused(lambda: wall.load, "no wall gate any more")
    assert list(sim.walls) == ["box"]
    height = sim.position[:, 2].mean()
    sim.advance(0.02)
    assert 0.7 < (height - sim.position[:, 2].mean())/(0.5*9.81*0.02**2) < 1.05
    refused(lambda: sim.wall("gate"), "gate", "box")


def motions():
    """the motion of a wall is a dict, a list of several, and that of the box for its faces; wear by triangles"""
    sim = suna.Simulation(PHYSICS + """walls {
        box { type box; material glass; min (-0.04 -0.04 -0.005); max (0.04 0.04 0.1); motion { type translation; velocity (0 0 0.1); } }
        jar { type triangles; material glass; corners ((0.02 0 0) (0.03 0 0) (0.02 0.01 0)); wear { coefficient 1; hardness 1e9; }
              motion ( { type rotation; origin (0 0 0); axis (0 0 1); omega 3; }
                       { type translation; velocity (0 0 0.1); } ); } }
        insert { ball { type list; material glass; diameter 1e-3; positions ((0.0225 0.0025 0.00049)); } }""")
    jar = sim.wall("jar")
    assert [one["type"] for one in jar.motion] == ["rotation", "translation"] and jar.motion[0]["omega"] == "3"
    assert sim.wall("boxMaxX").motion == {"type": "translation", "velocity": "( 0 0 0.1 )"}
    for motion in (None, {"type": "translation", "velocity": (0, 0, 1)}):
        def set_face(motion=motion):
            sim.wall("boxMaxX").motion = motion
        refused(set_face, "boxMaxX", "walls/box/motion")
    sim.change({"walls/box/motion": None})
    sim.wall("boxMaxZ").motion = {"type": "translation", "velocity": (0, 0, -1)}
    assert sim.wall("boxMaxZ").motion["velocity"] == "( 0 0 -1 )" and sim.wall("boxMinZ").motion == {}
    sim.advance(1e-3)
    assert jar.wear.shape == (1,) and jar.wear[0] > 0
    refused(lambda: sim.wall("boxMaxZ").wear, "boxMaxZ", "wear")
    jar.motion = jar.motion[1:]
    assert jar.motion[0]["type"] == "translation"
    corners = jar.corners
    jar.motion = None
    sim.advance(1e-3)
    assert jar.motion == {} and abs(jar.corners - corners).max() < 1e-15


def loads():
    """a wall becomes a servo and its force changes between advances: it holds each"""
    sim = suna.Simulation(SCENE.replace("walls {", "walls { lid { type plane; material glass; point (0 0 0.035); normal (0 0 -1); }"),
                          {"effects/dry/restitution": 0.3})
    sim.advance(0.1)
    for force in (0.02, 0.05):
        sim.wall("lid").motion = {"type": "servo", "force": force, "maxSpeed": 0.2}
        sim.advance(0.25)
        assert abs(sim.wall("lid").force[2]/force - 1) < 0.03, sim.wall("lid").force


def entries():
    """an entry of the scene changes: the law acts from then on; what the start refuses changes nothing"""
    sim = suna.Simulation(PHYSICS, {"effects/mindlin/friction": 0.0}, energy=True)
    sim.add_particles([0, 0, 0.1], 1e-3, "glass", velocity=(0.1, 0, 0))
    sim.advance(0.01)
    energy = sim.energy
    sim.change({"effects/gravity/acceleration": (0, 0, 0)})
    before = sim.velocity[0]
    sim.advance(0.01)
    assert (sim.velocity[0] == before).all() and sim.value("effects/gravity/acceleration") == "( 0 0 0 )"
    assert sim.energy["gravity"] == energy["gravity"] and abs(sim.energy["residual"]) < 1e-15
    state = sim.hash
    for entries in ({"effects/dry/restitution": 2}, {"effects/drie": {}}, {"walls/gate": None}, {"time/step": 1.0}):
        refused(lambda: sim.change(entries))
    refused(lambda: sim.change("x"), "dict")
    assert sim.hash == state
    for friction in (0.1, 0.2, 0.0):
        sim.change({"effects/mindlin/friction": friction})
    assert float(sim.value("effects/mindlin/friction")) == 0 and "given again" not in sim.warnings(1.0)
    sim.change({"walls/floor": {"type": "plane", "material": "steel", "point": (0, 0, 0), "normal": (0, 0, 1)},
                "insert/more": {"type": "lattice", "count": 9, "diameter": 2e-3, "spacing": 1.5, "material": "glass",
                                "min": (0.02, 0.02, 0.1), "max": (0.04, 0.04, 0.11)}})
    assert list(sim.walls) == ["floor"] and len(sim) == 10
    sim.add_wall("lid", "glass", 0.01*numpy.eye(3))
    assert sorted(sim.walls) == ["floor", "lid"]
    refused(lambda: sim.add_wall("lid", "glass", numpy.eye(3)), "has a wall lid")
    sim.wall("lid").motion = {"type": "translation", "velocity": (0, 0, 2), "start": sim.time}
    before = sim.wall("lid").corners
    sim.advance(1e-3)
    assert abs(sim.wall("lid").corners - before - (0, 0, 2e-3)).max() < 1e-15
    sim.wall("lid").remove()
    assert list(sim.walls) == ["floor"]
    sim.change({"walls/box": {"type": "box", "material": "glass", "min": (-1, -1, -1), "max": (1, 1, 1)}})
    sim.wall("boxMaxZ").motion = {"type": "servo", "force": 1, "maxSpeed": 1, "start": sim.time}
    assert sim.value("walls/box/faces/maxZ/motion/type") == "servo" and sim.wall("boxMaxZ").motion["force"] == "1"
    refused(lambda: sim.wall("boxMaxZ").remove(), "face of a box")


FREE = PHYSICS.replace("gravity { acceleration (0 0 -9.81); }", "").replace("-0.05 -0.05 -0.01", "-1 -1 -1").replace(
    "0.05 0.05 0.2", "1 1 1")


def trapped(**settings):
    """A grain in a harmonic trap of 50 rad/s, and the trap."""
    sim = suna.Simulation(FREE, {"time/step": 1e-4, "time/force": True}, energy=True, **settings)
    sim.add_particles([[0.01, 0, 0], [-0.02, 0.03, 0]], 1e-3, "glass")

    @sim.add_force
    def trap(p):
        p.force -= 2500*p.mass[:, None]*p.position
    return sim, trap


def forces():
    """a force of a function is integrated as others: the period of a trap, energy of second order, work"""
    sim, trap = trapped()
    k, start = 2500*sim.mass[0], of(sim, [0, 1], "position")
    sim.advance(0.02)
    assert numpy.allclose(of(sim, [0, 1], "position"), start*numpy.cos(1), atol=2e-7)
    assert numpy.allclose(of(sim, [0, 1], "velocity"), -50*start*numpy.sin(1), atol=1e-5)
    energy, potential = sim.energy, 0.5*k*(start**2).sum()
    lost = potential - 0.5*k*(sim.position**2).sum()
    assert abs(energy["work_forces"]/lost - 1) < 1e-5 and abs(energy["residual"]) < 1e-14
    other, _ = trapped()
    other.advance(0.01)
    other.save("trap.dem")
    other.advance(0.01)
    again = suna.Simulation(FREE, {"time/step": 1e-4, "time/force": True}, start="trap.dem")
    again.add_force(trap)
    again.advance(0.01)
    assert again.hash == other.hash
    sim.remove_force(trap)
    before = sim.velocity
    sim.advance(0.01)
    assert (sim.velocity == before).all()
    refused(lambda: sim.remove_force(trap), "no force")
    refused(lambda: sim.add_force(5), "function")
    turned, _ = trapped()
    turned.add_force(lambda p: setattr(p, "torque", [0, 0, 1e-9]))
    turned.advance(0.01)
    assert numpy.allclose(turned.spin[:, 2], 1e-11/(0.4*turned.mass*turned.radius**2), rtol=1e-12)


def force_faults():
    """an exception of a force, or a failure, puts back the state before the advance; it sees copies only"""
    sim, trap = trapped()
    sim.advance(0.01)
    before, time, kept = sim.hash, sim.time, []

    def fault(p):
        kept.append(p)
        if len(kept) == 30:
            raise ZeroDivisionError("halt")
    sim.add_force(fault)
    try:
        sim.advance(0.01)
        raise AssertionError("nothing was raised")
    except ZeroDivisionError as error:
        assert str(error) == "halt"
    assert sim.hash == before and sim.time == time
    sim.remove_force(fault)
    sim.advance(0.01)
    other, _ = trapped()
    other.advance(0.01)
    other.advance(0.01)
    assert sim.hash == other.hash
    for call, words in ((lambda p: p.position.__setitem__(0, 1), "read-only"), (lambda p: sim.position, "advancing"),
                        (lambda p: setattr(p, "force", [1, 2]), "force has the shape"),
                        (lambda p: 0*p.position, "returned an array of shape (2, 3)"),
                        (len, "returned 2; a returned value does not act")):
        sim.add_force(call)
        try:
            sim.advance(1e-3)
            raise AssertionError("nothing was raised")
        except (suna.SunaError, ValueError) as error:
            assert words in str(error), error
        sim.remove_force(call)
    time, state = sim.time, sim.hash
    sim.add_force(lambda p: setattr(p, "force", numpy.nan))
    refused(lambda: sim.advance(1e-3), "not a number", f"back at time {time:.9g} s")
    assert sim.hash == state and sim.time == time
    sim.remove_force(sim._forces[-1])
    sim.advance(1e-3)
    other.advance(1e-3)
    assert sim.hash == other.hash


def records():
    """the impulses on walls and the energy balance go back with the state, and go on as without the fault"""
    def pile():
        sim = suna.Simulation(SCENE, {"time/force": True}, energy=True).setup()
        sim.add_force(lambda p: setattr(p, "force", -1e-3*p.mass[:, None]*p.velocity))
        sim.reset_impulses()
        return sim.advance(0.05)

    def close(one, two, bits):
        impulse, balance = (abs(a - b).max()/abs(b).max() for a, b in zip(one, two))
        assert impulse <= bits*1e-13 and balance <= bits*1e-13, (impulse, balance)

    def state(sim):
        return (numpy.concatenate([numpy.ravel(sim.wall(name).impulse) for name in ("floor", "box")]),
                numpy.array(list(sim.energy.values())))

    def fault(p):
        if p.time > start + 1e-3:
            raise ZeroDivisionError("halt")
    sim, other = pile(), pile()
    before, start = state(sim), sim.time
    sim.add_force(fault)
    for duration in (0.01, 0.002):
        try:
            sim.advance(duration)
            raise AssertionError("nothing was raised")
        except ZeroDivisionError:
            pass
        close(state(sim), before, 0)
    sim.remove_force(fault)
    for one in (sim, other):
        one.advance(0.01)
    assert sim.hash == other.hash
    close(state(sim), state(other), 1)


def until():
    """until ends an advance at the first test that is true; its exceptions leave the run sound"""
    sim = suna.Simulation(SCENE)
    counts = []
    sim.advance(1, until=lambda s: counts.append(s.totals["steps"]) or s.wall("floor").force[2] < -1e-3, every=50)
    assert set(numpy.diff(counts)) == {50} and sim.wall("floor").force[2] < -1e-3 and sim.time < 0.1
    start = sim.time
    sim.advance(0.0123, until=lambda s: False, every=50)
    assert abs(sim.time - start - 0.0123) < 1e-12
    try:
        sim.advance(1, until=lambda s: 1/0)
        raise AssertionError("nothing was raised")
    except ZeroDivisionError:
        pass
    sim.advance(1e-3)
    for given in ({"until": 5}, {"until": len, "every": 0}, {"until": len, "every": 1.5}):
        refused(lambda: sim.advance(1e-3, **given), "until" if given["until"] == 5 else "every")


def views():
    """a view shows the particles without copy; kept arrays keep their values when the simulation goes on"""
    sim = suna.Simulation(SCENE, energy=True)
    sim.advance(0.05)
    with sim.view() as p:
        assert len(p) == 300
        kept = {name: getattr(p, name) for name in ("position", "velocity", "spin", "radius", "mass", "id", "force", "torque")}
        piece = p.position[5:9, 2]
        for name, array in kept.items():
            assert (array == getattr(sim, name)).all() and not array.flags.owndata, name
        for call in (lambda: sim.advance(1e-3), lambda: sim.remove([1]), lambda: sim.set([1], velocity=0),
                     lambda: sim.change({"time/end": 1})):
            refused(call, "view", "open")
        try:
            p.position[0] = 0
            raise AssertionError("it was written")
        except ValueError as error:
            assert "read-only" in str(error)
    refused(lambda: p.position, "closed")
    refused(lambda: len(p), "closed")
    before = {name: array.copy() for name, array in kept.items()}
    tail, other = piece.copy(), suna.Simulation(SCENE)
    other.advance(0.05)
    for one in (sim, other):
        one.advance(0.05)
    assert other.hash == sim.hash
    sim.add([0.03, 0, 0.1], 1e-3, "glass")
    sim.close()
    rubbish = [suna.Simulation(SCENE).setup() for _ in range(5)]
    assert len(rubbish) == 5 and (piece == tail).all()
    for name, array in kept.items():
        assert (array == before[name]).all(), name


def tables():
    """to_dataframe has a row for each id with units; to_pyvista hands points and arrays over; the
    table for notebooks names what there is"""
    sim = suna.Simulation(SCENE)
    sim.advance(0.05)
    table = sim.to_dataframe()
    assert list(table.index) == list(range(300)) and table.attrs["units"]["velocity_z"] == "m/s"
    assert (table[["x", "y", "z"]].to_numpy() == of(sim, range(300), "position")).all()
    assert (table.diameter == 1e-3).all() and set(table.material) == {"glass"}

    class PolyData(dict):
        def __init__(self, points):
            self.points = points
    sys.modules["pyvista"] = type(sys)("pyvista")
    sys.modules["pyvista"].PolyData = PolyData
    mesh = sim.to_pyvista()
    assert (mesh.points == sim.position).all() and (mesh["velocity"] == sim.velocity).all() and "diameter" in mesh
    del sys.modules["pyvista"]
    hidden, sys.path[:] = sys.path[:], []
    try:
        sim.to_pyvista()
        raise AssertionError("pyvista was found")
    except ImportError as error:
        assert "pip install pyvista" in str(error)
    finally:
        sys.path[:] = hidden
    text = sim._repr_html_()
    assert text.startswith("<table>") and "300" in text and "floor, box" in text and "hertz" in text
    assert "not set up" in suna.Simulation(SCENE)._repr_html_()


if __name__ == "__main__":
    os.chdir(tempfile.mkdtemp(dir=sys.argv[1]))
    run_tests(added, ids_over_restarts, snapshots, history, energy, moved, scalars, refusals, clumps, live_clumps, diameters,
              walls, motions, loads, entries, forces, force_faults, records, until, views, tables)
    finish()
