/*
 * signals.h -- signals that end `dem run` after the present step, with a snapshot.
 *
 * SIGTERM, which batch systems and mpirun send before they kill; SIGUSR1; SIGINT (Ctrl-C), of which
 * a second one ends the program at once.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_APP_SIGNALS_H
#define DEM_APP_SIGNALS_H

#include "dem.h"
#include "app/main.h"
#include "app/output_files.h"
#include <signal.h>

/* Catch these signals from now on. Returns where the number of the last one is stored; 0 before
   the first. */
const volatile sig_atomic_t *dem_signals_catch(void);

/* Collective. Write the snapshot of a run that was stopped, under the name of the next output's,
   and print where it is. */
int dem_signals_save(const struct dem_program *, const struct dem_output *, struct dem *,
                     int64_t number);

#endif
