/*
 * verdicts_cost.c -- measured cost of the negligible effects of a scene (effect_cost.h).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "advisor/regime.h"
#include "laws/effects.h"
#include "advisor/effect_cost.h"
#include "records/totals.h"
#include <math.h>

static const double long_enough = 0.2;                    /* s of processor time */

/* Fraction of processor time that is saved without the effect; infinite if the measurement
   failed. */
static int measure(const struct dem_plan *p, const char *effect, double *share)
{
    struct dem_effect_cost m;
    const int status =
        dem_effect_cost_measure(p->state, &p->inventory, p->step, effect, long_enough, &m);

    *share = status ? INFINITY : fmax(0.0, 1.0 - m.without/m.with);
    return status;
}

int dem_verdicts_measure_costs(struct dem_plan *p)
{
    int status = DEM_OK;

    for (int k = 0; k < p->verdicts.n; k++)
    {
        struct dem_verdict *const v = &p->verdicts.verdict[k];
        const struct dem_effect *const effect =
            v->word == DEM_NEGLIGIBLE ? dem_effects_find(v->effect) : NULL;

        if (effect && effect->stage != DEM_STAGE_NORMAL)  /* other effects need the normal law */
        {
            status = status ? status : measure(p, v->effect, &v->cost);
            v->cost = status ? INFINITY : v->cost;
            dem_totals_reduce_max(p->state, &v->cost, 1);
            DEM_REQUIRE(status || isfinite(v->cost), DEM_ERROR_STATE,
                        "another rank failed; see the message of that rank");
        }
    }
    return status;
}
