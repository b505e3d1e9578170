/*
 * yield.c -- waiting ranks of MPICH (Debian's, on UCX) sleep for a moment instead of polling: three
 * ranks that poll on one core take a hundred times their time.
 *
 *     gcc -shared -fPIC yield.c -o yield.so && LD_PRELOAD=$PWD/yield.so mpirun.mpich -np 3 ...
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#define _GNU_SOURCE
#include <dlfcn.h>
#include <time.h>

unsigned ucp_worker_progress(void *worker)
{
    static unsigned (*progress)(void *);
    if (!progress)
        *(void **)&progress = dlsym(RTLD_NEXT, "ucp_worker_progress");

    unsigned const events = progress(worker);
    if (events == 0)
        nanosleep(&(struct timespec){0, 1000}, NULL);
    return events;
}
