/*
 * progress.c -- print the progress of a run.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "app/progress.h"
#include "dem_tables.h"
#include <mpi.h>
#include <stdio.h>

/* s of the clock between lines of progress */
static const double progress_interval = 10.0;

static double seconds_left(const struct dem_progress *p, double time)
{
    const double done = time - p->from;

    return done > 0.0 ? (MPI_Wtime() - p->started)/done*(p->end - time) : 0.0;
}

static void report_progress(const struct dem_progress *p, double time, int64_t steps)
{
    const double rate = (double)(steps - p->steps)/(MPI_Wtime() - p->started);

    printf("progress %.1f %%, %.0f s left, %.3g steps/s, %.3g particle-steps/s\n",
           100.0*time/p->end, seconds_left(p, time), rate, rate*(double)p->particles);
    fflush(stdout);
}

void dem_progress_watch(void *of, double time, int64_t steps)
{
    struct dem_progress *const p = of;

    dem_stop_file_look(p->stop_file);
    dem_keep_signals();
    if (MPI_Wtime() - p->printed >= progress_interval)
    {
        p->printed = MPI_Wtime();
        report_progress(p, time, steps);
    }
}

static void report_bonds(const struct dem_totals *t)
{
    if (t->bonds > 0 || t->broken > 0.0 || t->lost != 0.0)
    {
        printf("        %lld bonds  %.0f broken  stored %.4g J  lost %.4g J\n", (long long)t->bonds,
               t->broken, t->stored, t->lost);
    }
}

const char *dem_progress_particles(const struct dem_totals *t, char text[80])
{
    if (t->clumps > 0)
    {
        snprintf(text, 80, "%lld spheres, %lld clumps", (long long)t->particles, (long long)t->clumps);
    }
    else
    {
        snprintf(text, 80, "%lld particles", (long long)t->particles);
    }
    return text;
}

void dem_progress_report(struct dem_progress *p, const struct dem_totals *t)
{
    char text[80];

    if (p->rank == 0)
    {
        printf("t %.6g s  %s  %lld contacts  %.0f steps/s  kinetic %.4g J  overlap "
               "%.3g %%  ETA %.0f s\n",
               t->time, dem_progress_particles(t, text), (long long)t->contacts,
               (double)(t->steps - p->steps)/(MPI_Wtime() - p->started), t->kinetic,
               100.0*p->overlap, seconds_left(p, t->time));
        report_bonds(t);
        fflush(stdout);
    }
    p->particles = t->particles;
    p->overlap = 0.0;
}
