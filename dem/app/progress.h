/*
 * progress.h -- the progress of a run on the terminal: lines at outputs, and between them every 10 s.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "dem_types.h"

/* s of the clock between looks for the file `stop` */
#define DEM_LOOK_INTERVAL 1.0

struct dem_progress
{
    double started, printed;   /* s  wall clock at the start, at the last line */
    char stop_file[640];
    double from, end;          /* s  simulated time at the start, at the end */
    double overlap;            /* 1  largest since the last line; dem_totals resets its own */
    int64_t steps, particles;  /*    steps at the start; particles at the last output */
    int rank;
};

/* Called by dem_set_progress on the first rank: look for the file `stop`, print a line when it is
   due. */
void dem_progress_watch(void *progress, double time, int64_t steps);

/* "140 particles"; in a scene with clumps "140 spheres, 40 clumps". */
const char *dem_progress_particles(const struct dem_totals *, char text[80]);

/* The line of an output, printed by the first rank. */
void dem_progress_report(struct dem_progress *, const struct dem_totals *);
