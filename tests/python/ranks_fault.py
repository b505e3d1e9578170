"""ranks_fault.py -- an exception in the progress function of one rank ends the advance on all
ranks, in its course and in its last step, and the run can continue. The first rank prints "ended".
On a single rank only the exception itself is tested.

SPDX-License-Identifier: GPL-3.0-or-later
"""
from mpi4py import MPI

import suna
from test_suna import SCENE


class Fault(Exception):
    """raised by a callback"""


def fault(*_):
    raise Fault


def outcome(sim, duration):
    """What the advance raises on this rank; the last one has a progress function."""
    try:
        sim.advance(duration, fault if world.rank == world.size - 1 else None, interval=0)
    except (Fault, suna.SunaError) as error:
        return f"{type(error).__name__} {error}"
    return "nothing"


world = MPI.COMM_WORLD
expected = "Fault" if world.rank == world.size - 1 else "SunaError a function of another rank"
sim = suna.Simulation(SCENE, comm=world)
step = sim.step[0]
# progress is reported after each 16 steps: in the last step of the first advance, then in the middle
found = [outcome(sim, 16*step), outcome(sim, 64*step)]
sim.advance(step)
all_ranks = world.gather(all(text.startswith(expected) for text in found) or found)
if world.rank == 0:
    print("ended" if all(one is True for one in all_ranks) else all_ranks)
# not closed: the end of the interpreter frees it
