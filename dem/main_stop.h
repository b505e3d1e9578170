/*
 * main_stop.h -- signals that end `dem run` after the step at hand, with a snapshot: SIGTERM, which batch systems and mpirun send
 * before they kill, SIGUSR1, and SIGINT, of which a second one ends the run at once.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_MAIN_STOP_H
#define DEM_MAIN_STOP_H

#include "dem.h"
#include "main.h"
#include "main_output.h"
#include <signal.h>

/* From here on these signals are caught; the number of the last one, 0 before. */
const volatile sig_atomic_t *dem_stop_listen(void);

/* Collective. The snapshot of a run that dem_stopped, in place of that of the output that comes next, and a line that says so. */
int dem_stop_save(const struct dem_program *, const struct dem_output *, struct dem *, int64_t number);

#endif
