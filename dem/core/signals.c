/*
 * signals.c -- catch signals that ask a run to save its state and to end: SIGTERM, which batch
 * systems and mpirun send before they kill; SIGUSR1; SIGINT (Ctrl-C), of which a second one ends
 * the program at once. The handler stores the signal's number, which the run reads after each step
 * on all ranks. A stop file that the run finds stores another number there.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#define _POSIX_C_SOURCE 200809L                           /* sigaction */

#include "core/clock.h"
#include "core/error.h"
#include "dem_tables.h"
#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

static const int signals[] = {SIGTERM, SIGUSR1, SIGINT};

enum
{
    SIGNALS = (int)(sizeof signals/sizeof *signals)
};

static int ours[SIGNALS];        /* 1: dem_catch_signals has taken this signal */

static volatile sig_atomic_t caught, repeated;
static volatile time_t first;

/* One request may arrive twice at once, from mpirun and from the batch system. */
static const time_t apart = 2;   /* s */

/* time() may be called in a handler. */
static void store(int request)
{
    if (!caught)
    {
        first = time(NULL);
    }
    else if (time(NULL) - first >= apart)
    {
        repeated = request;
    }
    caught = request;
}

static void take(int signal)
{
    struct sigaction action;

    memset(&action, 0, sizeof action);
    action.sa_handler = store;
    sigemptyset(&action.sa_mask);
    action.sa_flags = SA_RESTART | (signal == SIGINT ? (int)SA_RESETHAND : 0);
    /* fails only for signals that do not exist */
    (void)sigaction(signal, &action, NULL);
}

const volatile sig_atomic_t *dem_catch_signals(const int *except, int exceptions)
{
    for (int k = 0; k < SIGNALS; k++)
    {
        int excepted = 0;

        for (int j = 0; j < exceptions; j++)
        {
            excepted |= except[j] == signals[k];
        }
        ours[k] = !excepted;
        if (ours[k])
        {
            take(signals[k]);
        }
    }
    return &caught;
}

/* A SIGINT that has come has set its handler to the default, which stays. */
void dem_keep_signals(void)
{
    for (int k = 0; k < SIGNALS; k++)
    {
        struct sigaction present;

        if (ours[k] && sigaction(signals[k], NULL, &present) == 0 && present.sa_handler != store
            && (signals[k] != SIGINT || present.sa_handler != SIG_DFL))
        {
            take(signals[k]);
        }
    }
}

const volatile sig_atomic_t *dem_repeated_signal(void)
{
    return &repeated;
}

const char *dem_signal_name(int signal)
{
    return signal == SIGTERM         ? "SIGTERM"
         : signal == SIGUSR1       ? "SIGUSR1"
         : signal == SIGINT        ? "SIGINT"
         : signal == DEM_STOP_FILE ? "the file stop"
                                   : "";
}

/* ---- the file -------------------------------------------------------------------------------- */

int dem_stop_file_clear(const char *path, int *found)
{
    *found = access(path, F_OK) == 0;
    DEM_REQUIRE(!*found || remove(path) == 0, DEM_ERROR_FILE,
                "the file %s would end the run at once, and cannot be removed: %s; remove it", path,
                strerror(errno));
    return DEM_OK;
}

void dem_stop_file_look(const char *path)
{
    static const double between = 1.0;    /* s of the clock: a look costs file systems a request */
    static double last = -INFINITY;
    const double now = dem_clock_wall();

    if (now - last < between)
    {
        return;
    }
    last = now;
    if (access(path, F_OK) == 0)
    {
        (void)remove(path);    /* the run ends in any case */
        store(DEM_STOP_FILE);
    }
}
