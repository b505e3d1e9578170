/*
 * profile.c -- phases, counts and traffic of all ranks.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "step/profile.h"
#include "base/clock.h"
#include "step/measure.h"
#include "step/survey.h"
#include <math.h>

enum
{
    WORK = DEM_PHASES,                                    /* s: advancing without waiting for others */
    PROCESSOR,
    SECONDS
};

_Static_assert((int)DEM_PHASES == (int)DEM_PROFILE_PHASES, "dem.h tells of all phases");

/* Means and largest values of each phase, of the time at work and of the processor's. */
static void gather_times(const struct dem_parts *p, double mean[SECONDS], double most[SECONDS])
{
    dem_phases_shares(&p->phases, mean);
    mean[DEM_PHASE_OUTSIDE] += dem_clock_wall() - p->phases.last;
    mean[PROCESSOR] = dem_clock_processor() - p->phases.processor;
    mean[WORK] = 0.0;
    for (int k = 0; k < DEM_PHASE_OUTSIDE; k++)
    {
        mean[WORK] += k == DEM_PHASE_AGREE || k == DEM_PHASE_REFRESH ? 0.0 : mean[k];
    }
    for (int k = 0; k < SECONDS; k++)
    {
        most[k] = mean[k];
    }
    if (p->pieces.ranks > 1)
    {
        MPI_Allreduce(MPI_IN_PLACE, most, SECONDS, MPI_DOUBLE, MPI_MAX, p->pieces.comm);
        MPI_Allreduce(MPI_IN_PLACE, mean, SECONDS, MPI_DOUBLE, MPI_SUM, p->pieces.comm);
    }
    for (int k = 0; k < SECONDS; k++)
    {
        mean[k] /= p->pieces.ranks;
    }
}

static void gather_counts(const struct dem_parts *p, struct dem_profile *f)
{
    const struct dem_traffic *const refreshed = &p->halo.refreshed, *const letters = &p->halo.in.sent;
    int64_t count[8] = {(int64_t)p->particles.n, dem_measure_touching(p), p->phases.particle_steps, p->phases.row_steps,
                        refreshed->messages, refreshed->bytes, letters->messages, letters->bytes};

    if (p->pieces.ranks > 1)
    {
        MPI_Allreduce(MPI_IN_PLACE, count, 8, MPI_INT64_T, MPI_SUM, p->pieces.comm);
    }
    f->particles = count[0];
    f->contacts = count[1];
    f->particle_steps = count[2];
    f->row_steps = count[3];
    f->messages = count[4];
    f->message_bytes = count[5];
    f->letters = count[6];
    f->letter_bytes = count[7];
}

void dem_profile_take(struct dem_parts *p, struct dem_profile *f)
{
    double mean[SECONDS], most[SECONDS];
    struct dem_survey survey;

    gather_times(p, mean, most);
    dem_survey_take(p, &survey);
    *f = (struct dem_profile){.ranks = p->pieces.ranks, .outside = mean[DEM_PHASE_OUTSIDE], .processor = mean[PROCESSOR]*p->pieces.ranks,
                              .busiest = mean[WORK] > 0.0 ? most[WORK]/mean[WORK] : 1.0, .steps = p->phases.steps,
                              .rebuilds = p->rebuilds - p->phases.rebuilds, .prunes = p->prunes - p->phases.prunes,
                              .outer_skin = 2.0*p->pairs.half_outer, .inner_skin = 2.0*p->pairs.half_inner,
                              .diameter = 2.0*p->pairs.most_radius, .bytes = survey.bytes, .agreements = p->phases.agreements,
                              .cuts = p->balance.cuts};
    for (int k = 0; k < DEM_PHASES; k++)
    {
        f->phase[k].name = dem_phase_name((enum dem_phase)k);
        f->phase[k].mean = mean[k];
        f->phase[k].most = most[k];
        f->wall += mean[k];
    }
    gather_counts(p, f);
    f->largest_overlap = fmax(p->watch.most, p->watch.overlap);
    dem_measure_most(p, &f->largest_overlap, 1);
    dem_durations_tell(p, &f->watched, &f->longer, &f->least_steps, &f->median_steps);
}
