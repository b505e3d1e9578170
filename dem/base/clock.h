/*
 * clock.h -- two clocks, for telling what a run costs. No result and no decision depends on them.
 *
 * dem_clock_wall is POSIX' monotonic clock: it never jumps, needs no calibration and takes 20 to 40 ns. The processor's own
 * counter (rdtsc) would take 10 ns, on one kind of processor.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_BASE_CLOCK_H
#define DEM_BASE_CLOCK_H

double dem_clock_wall(void);                              /* s since some moment */
double dem_clock_processor(void);                         /* s that this process has been at work, all threads; takes 1 us */

#endif
