/*
 * verdicts_cost.c -- what negligible effects cost (marginal.h).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "plan/regime.h"
#include "effects/effects.h"
#include "plan/marginal.h"
#include "step/measure.h"
#include <math.h>

static const double long_enough = 0.2;                    /* s of processor time */

/* Share of the time that goes when the effect does; infinite where it can't be told. */
static int measure(const struct dem_plan *p, const char *effect, double *share)
{
    struct dem_marginal m;
    const int status = dem_marginal_take(p->parts, &p->survey, p->step, effect, long_enough, &m);

    *share = status ? INFINITY : fmax(0.0, 1.0 - m.without/m.with);
    return status;
}

int dem_judge_costs(struct dem_plan *p)
{
    int status = DEM_OK;

    for (int k = 0; k < p->verdicts.n; k++)
    {
        struct dem_verdict *const v = &p->verdicts.verdict[k];
        const struct dem_effect *const effect = v->word == DEM_NEGLIGIBLE ? dem_effects_find(v->effect) : NULL;

        if (effect && effect->stage != DEM_STAGE_NORMAL)  /* others lean on that one */
        {
            status = status ? status : measure(p, v->effect, &v->cost);
            v->cost = status ? INFINITY : v->cost;
            dem_measure_most(p->parts, &v->cost, 1);
            DEM_REQUIRE(status || isfinite(v->cost), DEM_ERROR_STATE, "another rank failed; its message tells why");
        }
    }
    return status;
}
