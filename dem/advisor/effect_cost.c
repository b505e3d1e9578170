/*
 * effect_cost.c -- measure the cost of one effect with two sample blocks.
 *
 * The blocks, with and without the effect, run in alternation.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "advisor/effect_cost.h"
#include "advisor/time_estimate.h"
#include "advisor/sample_block.h"
#include "step/step.h"
#include <math.h>
#include <string.h>
#include <time.h>

enum
{
    STEPS = 10,                                           /* of one measurement */
    MIN_MEASUREMENTS = 5
};

static double now(void)
{
    return (double)clock()/CLOCKS_PER_SEC;
}

static int measure(struct dem_state *q, double dt, double *fastest)
{
    const double start = now();

    DEM_TRY(dem_step_window(q, dt, STEPS));
    *fastest = fmin(*fastest, (now() - start)/(STEPS*(double)q->particles.n));
    return DEM_OK;
}

static int alternate(struct dem_sample block[2], double dt, double seconds,
                     struct dem_effect_cost *m)
{
    const double start = now();
    double ignored = INFINITY;

    m->with = m->without = INFINITY;
    for (int k = 0; k < 2; k++)                           /* fills caches and allocates memory */
    {
        DEM_TRY(measure(&block[k].state, dt, &ignored));
    }
    for (int k = 0; k < MIN_MEASUREMENTS || now() - start < seconds; k++)
    {
        DEM_TRY(measure(&block[0].state, dt, &m->with));
        DEM_TRY(measure(&block[1].state, dt, &m->without));
    }
    return DEM_OK;
}

int dem_effect_cost_measure(const struct dem_state *p, const struct dem_inventory *s, double dt,
                            const char *effect, double seconds, struct dem_effect_cost *m)
{
    struct dem_sample block[2];
    struct dem_memory_need need;

    dem_memory_need_count(p, s, &need);
    *m = (struct dem_effect_cost){.particle = need.particle, .pair = need.pair, .row = need.row};
    memset(block, 0, sizeof block);
    int status = dem_sample_block_make(&block[0], p, s, DEM_SAMPLE_SMALL, NULL);

    status = status ? status : dem_sample_block_make(&block[1], p, s, DEM_SAMPLE_SMALL, effect);
    status = status ? status : alternate(block, dt, seconds, m);
    dem_sample_block_free(&block[0]);
    dem_sample_block_free(&block[1]);
    return status;
}
