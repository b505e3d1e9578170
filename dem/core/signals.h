/*
 * signals.h -- signals that ask a run to save its state and to end: SIGTERM, which batch systems
 * and mpirun send before they kill; SIGUSR1; SIGINT (Ctrl-C), of which a second one ends the
 * program at once. A file asks the same of a run that no signal reaches. dem.h describes the
 * functions.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_CORE_SIGNALS_H
#define DEM_CORE_SIGNALS_H

#include <signal.h>

const volatile sig_atomic_t *dem_catch_signals(const int *except, int exceptions);
void dem_keep_signals(void);
const volatile sig_atomic_t *dem_repeated_signal(void);
const char *dem_signal_name(int signal);
int dem_stop_file_clear(const char *path, int *found);
void dem_stop_file_look(const char *path);

#endif
