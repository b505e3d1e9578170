/*
 * marginal.c -- two blocks in turns.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "plan/marginal.h"
#include "plan/cost.h"
#include "plan/sample.h"
#include "step/step.h"
#include <math.h>
#include <string.h>
#include <time.h>

enum
{
    STEPS = 10,                                           /* of a turn */
    LEAST_TURNS = 5
};

static double now(void)
{
    return (double)clock()/CLOCKS_PER_SEC;
}

static int turn(struct dem_parts *q, double dt, double *quickest)
{
    const double start = now();

    DEM_TRY(dem_step_window(q, dt, STEPS));
    *quickest = fmin(*quickest, (now() - start)/(STEPS*(double)q->particles.n));
    return DEM_OK;
}

static int take_turns(struct dem_parts block[2], double dt, double seconds, struct dem_marginal *m)
{
    const double start = now();
    double ignored = INFINITY;

    m->with = m->without = INFINITY;
    for (int k = 0; k < 2; k++)                           /* fills caches and memory */
    {
        DEM_TRY(turn(&block[k], dt, &ignored));
    }
    for (int k = 0; k < LEAST_TURNS || now() - start < seconds; k++)
    {
        DEM_TRY(turn(&block[0], dt, &m->with));
        DEM_TRY(turn(&block[1], dt, &m->without));
    }
    return DEM_OK;
}

int dem_marginal_take(const struct dem_parts *p, const struct dem_survey *s, double dt, const char *effect, double seconds, struct dem_marginal *m)
{
    struct dem_parts block[2];
    struct dem_need need;

    dem_need_count(p, s, &need);
    *m = (struct dem_marginal){.particle = need.particle, .pair = need.pair, .row = need.row};
    memset(block, 0, sizeof block);
    int status = dem_sample_make(&block[0], p, s, NULL);

    status = status ? status : dem_sample_make(&block[1], p, s, effect);
    status = status ? status : take_turns(block, dt, seconds, m);
    dem_sample_free(&block[0]);
    dem_sample_free(&block[1]);
    return status;
}
