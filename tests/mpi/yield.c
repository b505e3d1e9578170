/*
 * yield.c -- ranks of MPICH (Debian's, on UCX) that wait give up their core, as ranks of Open MPI do with
 * mpi_yield_when_idle. Without it three ranks on one core take a hundred times their time.
 *
 *     gcc -shared -fPIC yield.c -o yield.so && LD_PRELOAD=$PWD/yield.so mpirun.mpich -np 3 ...
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#define _GNU_SOURCE
#include <dlfcn.h>
#include <sched.h>

unsigned ucp_worker_progress(void *worker)
{
    static unsigned (*progress)(void *);
    if (!progress)
        *(void **)&progress = dlsym(RTLD_NEXT, "ucp_worker_progress");

    unsigned const events = progress(worker);
    if (events == 0)
        sched_yield();
    return events;
}
