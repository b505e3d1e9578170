/*
 * effect_cost.c -- the processor time that an effect of a scene takes.
 *
 * Two blocks (sample_block.h), with the effect and without, run in alternation, 10 steps each. The
 * result is the fastest measurement of each, because other load on the machine can only make a
 * measurement longer. The block is at rest and each sphere touches 8 others: an effect that costs
 * more where particles move is more expensive than reported.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "step/run_cost.h"
#include "core/error.h"
#include "laws/effects.h"
#include "records/totals.h"
#include "step/sample_block.h"
#include "step/step.h"
#include <math.h>
#include <string.h>
#include <time.h>

enum
{
    STEPS = 10,                                           /* of one measurement */
    MIN_MEASUREMENTS = 5
};

static const double long_enough = 0.2;                    /* s of processor time */

static double now(void)
{
    return (double)clock()/CLOCKS_PER_SEC;
}

static int measure(struct dem_state *q, double dt, double *fastest)
{
    const double start = now();

    DEM_TRY(dem_step_window(q, dt, STEPS));
    *fastest = fmin(*fastest, now() - start);
    return DEM_OK;
}

/* Fraction of processor time that is saved without the effect of block 0. */
static int alternate(struct dem_sample block[2], double dt, double *share)
{
    const double start = now();
    double with = INFINITY, without = INFINITY, ignored = INFINITY;

    for (int k = 0; k < 2; k++)                           /* fills caches and allocates memory */
    {
        DEM_TRY(measure(&block[k].state, dt, &ignored));
    }
    for (int k = 0; k < MIN_MEASUREMENTS || now() - start < long_enough; k++)
    {
        DEM_TRY(measure(&block[0].state, dt, &with));
        DEM_TRY(measure(&block[1].state, dt, &without));
    }
    *share = fmax(0.0, 1.0 - without/with);
    return DEM_OK;
}

static int measure_share(const struct dem_state *p, const struct dem_inventory *s, double dt,
                         const char *effect, double *share)
{
    struct dem_sample block[2];

    memset(block, 0, sizeof block);
    int status = dem_sample_block_make(&block[0], p, s, DEM_SAMPLE_SMALL, NULL);

    status = status ? status : dem_sample_block_make(&block[1], p, s, DEM_SAMPLE_SMALL, effect);
    status = status ? status : alternate(block, dt, share);
    dem_sample_block_free(&block[0]);
    dem_sample_block_free(&block[1]);
    return status;
}

int dem_effect_cost_measure(const struct dem_state *p, const struct dem_inventory *s, double dt,
                            const char *name, double *share)
{
    const struct dem_effect *const effect = dem_effects_find(name);

    *share = NAN;
    if (!effect || effect->stage == DEM_STAGE_NORMAL)    /* other effects need the normal law */
    {
        return DEM_OK;
    }
    const int status = measure_share(p, s, dt, name, share);

    *share = status ? INFINITY : *share;
    dem_totals_reduce_max(p, share, 1);
    DEM_REQUIRE(status || isfinite(*share), DEM_ERROR_STATE,
                "another rank failed; see the message of that rank");
    return status;
}
