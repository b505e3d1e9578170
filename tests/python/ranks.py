"""ranks.py -- the hash of a run with a communicator of mpi4py; the first rank prints it.

SPDX-License-Identifier: GPL-3.0-or-later
"""
from mpi4py import MPI

import suna
from test_suna import SCENE

sim = suna.Simulation(SCENE, comm=MPI.COMM_WORLD)
sim.advance(0.01)
value = sim.hash
total = MPI.COMM_WORLD.allreduce(len(sim))
if MPI.COMM_WORLD.rank == 0:
    print(total, value)
sim.close()
