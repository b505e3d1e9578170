/*
 * signals.h -- signals that ask a run to save its state and to end: SIGTERM, which batch systems
 * and mpirun send before they kill; SIGUSR1; SIGINT (Ctrl-C), of which a second one ends the
 * program at once. The functions are those of dem.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_CORE_SIGNALS_H
#define DEM_CORE_SIGNALS_H

#include <signal.h>

const volatile sig_atomic_t *dem_catch_signals(const int *except, int exceptions);
const char *dem_signal_name(int signal);

#endif
