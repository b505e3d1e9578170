/*
 * signals.c -- catch signals: the handler stores the signal's number, which dem_advance reads after
 * each step on all ranks.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#define _POSIX_C_SOURCE 200809L                           /* sigaction */

#include "app/signals.h"
#include "core/error.h"
#include <stdio.h>
#include <string.h>

static volatile sig_atomic_t caught;

static void store(int signal)
{
    caught = signal;
}

const volatile sig_atomic_t *dem_signals_catch(void)
{
    static const int signals[] = {SIGTERM, SIGUSR1, SIGINT};
    struct sigaction action;

    memset(&action, 0, sizeof action);
    action.sa_handler = store;
    sigemptyset(&action.sa_mask);
    for (size_t k = 0; k < sizeof signals/sizeof *signals; k++)
    {
        action.sa_flags = SA_RESTART | (signals[k] == SIGINT ? (int)SA_RESETHAND : 0);
        /* fails only for signals that do not exist */
        (void)sigaction(signals[k], &action, NULL);
    }
    return &caught;
}

static const char *name_of(int signal)
{
    return signal == SIGTERM ? "SIGTERM" : signal == SIGUSR1 ? "SIGUSR1" : "SIGINT";
}

int dem_signals_save(const struct dem_program *prog, const struct dem_output *o, struct dem *d,
                     int64_t number)
{
    const double began = MPI_Wtime();
    struct dem_totals t;
    char path[640];

    DEM_TRY(dem_program_agree(prog, prog->rank == 0 ? dem_output_folder(o) : DEM_OK));
    dem_output_snapshot_name(o, number, path, sizeof path);
    DEM_TRY(dem_save(d, path));
    DEM_TRY(dem_totals(d, &t));
    if (prog->rank == 0)
    {
        printf("stopped by %s at t %.9g s, after step %lld: the state is in %s, written in %.2g s; "
               "-restart %s continues, with the same bits\n",
               name_of(dem_stopped(d)), t.time, (long long)t.steps, path, MPI_Wtime() - began,
               path);
        fflush(stdout);
    }
    return DEM_OK;
}
