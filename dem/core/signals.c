/*
 * signals.c -- catch signals: the handler stores the signal's number, which the run reads after each
 * step on all ranks.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#define _POSIX_C_SOURCE 200809L                           /* sigaction */

#include "core/signals.h"
#include <stddef.h>
#include <string.h>

static volatile sig_atomic_t caught;

static void store(int signal)
{
    caught = signal;
}

const volatile sig_atomic_t *dem_catch_signals(const int *except, int exceptions)
{
    static const int signals[] = {SIGTERM, SIGUSR1, SIGINT};
    struct sigaction action;

    memset(&action, 0, sizeof action);
    action.sa_handler = store;
    sigemptyset(&action.sa_mask);
    for (size_t k = 0; k < sizeof signals/sizeof *signals; k++)
    {
        int excepted = 0;

        for (int j = 0; j < exceptions; j++)
        {
            excepted |= except[j] == signals[k];
        }
        action.sa_flags = SA_RESTART | (signals[k] == SIGINT ? (int)SA_RESETHAND : 0);
        if (!excepted)
        {
            /* fails only for signals that do not exist */
            (void)sigaction(signals[k], &action, NULL);
        }
    }
    return &caught;
}

const char *dem_signal_name(int signal)
{
    return signal == SIGTERM ? "SIGTERM"
         : signal == SIGUSR1 ? "SIGUSR1"
         : signal == SIGINT  ? "SIGINT"
                             : "";
}
