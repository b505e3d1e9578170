"""ranks_live.py -- edits, forces and changes of the scene with a communicator of mpi4py: the first rank
prints the hashes. With more than one rank an exception on one ends the call on all.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import numpy
from mpi4py import MPI

import suna
from test_live import CLUMPS, SCENE

world = MPI.COMM_WORLD
sim = suna.Simulation(SCENE, comm=world, energy=True)
found = []
sim.advance(0.05)
sim.remove(range(0, 300, 7))
ids = sim.add([[0.02, 0.001*k, 0.01*k] for k in range(1, 15)], 1e-3, "glass", velocity=(0, 0, 1))
sim.set([1, 2, *ids[:2]], velocity=[0, 0, 0.5])
sim.set([4], position=[0, 0, 0.05])
found += [sim.hash, sim.energy["edited"]]
sim.advance(0.02)


@sim.add_force
def swirl(p):
    p.force += 1e-4*numpy.stack((-p.position[:, 1], p.position[:, 0], 0*p.mass), axis=1)


sim.advance(0.02, until=lambda s: s.totals["kinetic"] < 0, every=30)
sim.wall("floor").motion = {"type": "translation", "velocity": (0, 0, 0.01)}
sim.change({"effects/mindlin/friction": 0.1})
sim.advance(0.02)
found += [sim.hash, sim.energy["residual"], world.allreduce(len(sim)), list(ids)]


# other diameters, walls that come and go, load of a wall, views
sim.allow_diameters("glass", 5e-4, 1.5e-3)
sim.add([[0.03, 0, 0.1], [-0.03, 0, 0.1]], [1.5e-3, 5e-4], "glass")
sim.add_wall("lid", "glass", [[[-0.1, -0.1, 0.15], [0.1, -0.1, 0.15], [0, 0.1, 0.15]]])
sim.wall("lid").motion = {"type": "servo", "force": 1e-3, "maxSpeed": 0.1, "axis": (0, 0, -1)}
sim.advance(0.005)
found += [sim.hash, *sim.wall("floor").force, sim.wall("lid").corners.sum()]
sim.wall("lid").remove()
with sim.view() as p:
    count = world.allreduce(len(p))
sim.advance(0.005)
found += [sim.hash, count, sorted(sim.walls)]


def fails(call, kind):
    """On the last rank with this exception, on others with a SunaError."""
    try:
        call()
    except (kind if world.rank == world.size - 1 else suna.SunaError):
        return
    raise AssertionError("nothing was raised")


def fault(_):
    if world.rank == world.size - 1:
        raise ZeroDivisionError


before = sim.hash
sim.add_force(fault)
fails(lambda: sim.advance(1e-3), ZeroDivisionError)
assert sim.hash == before
sim.remove_force(fault)
fails(lambda: sim.advance(1e-3, until=fault), ZeroDivisionError)
fails(lambda: sim.remove([5000]), suna.SunaError)
fails(lambda: sim.change({"effects/dry/restitution": 2}), suna.SunaError)
assert sim.hash == before
sim.close()

# scalars, different on each rank
sim = suna.Simulation(SCENE, {"effects/conduction": "{}", "materials/glass/conductivity": 1,
                              "materials/glass/heatCapacity": 800, "materials/steel/conductivity": 1,
                              "materials/steel/heatCapacity": 800}, comm=world, energy=True)
sim.set_scalar("temperature", 300 + 1e3*sim.position[:, 2])
fails(lambda: sim.set_scalar("temperature", numpy.full(len(sim) + 2*(world.rank == world.size - 1), 300)), suna.SunaError)
sim.advance(0.01)
found += [sim.hash, sim.energy["edited"], sim.total("temperature")]
sim.close()

# clumps
sim = suna.Simulation(CLUMPS, comm=world, energy=True)
ids = sim.add_clumps([[0, 0.02 - 0.008*k, 0.15] for k in range(6)], "rod", "glass", spin=(10, 0, 20))
sim.add_force(lambda p: p.force.__iadd__(1e-6*(p.id%3 == 0)[:, None]))
sim.set(ids[:2], velocity=(0, 0, 0.5))
sim.remove([*range(ids[2], ids[2] + 3), 6])
sim.advance(0.02)
fails(lambda: sim.remove([0]), suna.SunaError)
found += [sim.hash, sim.energy["edited"], sim.energy["work_forces"], list(ids)]
if world.rank == 0:
    print(*found)
sim.close()
