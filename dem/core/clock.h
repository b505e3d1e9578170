/*
 * clock.h -- wall clock and processor clock for timers. No result and no decision depends on them.
 *
 * dem_clock_wall is the monotonic clock of POSIX: it never jumps, needs no calibration and takes 20
 * to 40 ns a call. The processor's counter (rdtsc) would take 10 ns, on one kind of processor only.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

double dem_clock_wall(void);    /* [s] since some moment */

/* [s] of processor time of this process, all threads. A call takes 0.2 to 1.5 us. */
double dem_clock_processor(void);
