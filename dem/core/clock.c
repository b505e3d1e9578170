/*
 * clock.c -- wall clock and processor clock by POSIX clock_gettime.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#define _POSIX_C_SOURCE 199309L
#include "core/clock.h"
#include <time.h>

static double read_clock(clockid_t id)
{
    struct timespec t = {0, 0};

    clock_gettime(id, &t);
    return (double)t.tv_sec + 1e-9*(double)t.tv_nsec;
}

double dem_clock_wall(void)
{
    return read_clock(CLOCK_MONOTONIC);
}

double dem_clock_processor(void)
{
    return read_clock(CLOCK_PROCESS_CPUTIME_ID);
}
