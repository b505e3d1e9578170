/*
 * advice.c -- the public calls that advise: plan, verdicts, warnings.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "advisor/plan.h"
#include "advisor/warnings.h"
#include "case/internal.h"
#include "core/error.h"
#include "core/memory.h"
#include "records/totals.h"
#include "input/dictionary.h"
#include "ranks/collect.h"
#include <fenv.h>
#include <string.h>

int dem_plan(struct dem *d, const struct dem_run_info *run, const char **text)
{
    struct dem_plan plan = {.state = &d->state, .scene = &d->scene, .run = *run, .step = d->step};
    fenv_t caller;

    dem_text_free(&d->plan);
    feholdexcept(&caller);
    int status = d->verdicts ? DEM_OK : DEM_NEW(d->verdicts, 1);

    status = status ? status : dem_plan_write(&d->plan, &plan);
    status = status ? status : dem_collect_status(&d->state.decomposition);
    fesetenv(&caller);
    *text = d->plan.text;
    if (d->verdicts)
    {
        *d->verdicts = plan.verdicts;
    }
    return status;
}

int dem_warnings(struct dem *d, const struct dem_run_info *run, int n, const char *const *own,
                 const char **text)
{
    struct dem_plan plan = {.state = &d->state, .scene = &d->scene, .run = *run, .step = d->step};
    const char *const *repeats, **sentences;
    fenv_t caller;

    DEM_TRY(dem_api_require_count("dem_warnings", "sentences", n));
    const size_t repeated = dem_dict_repeats(d->dict, &repeats), told = repeated + d->notes;

    DEM_TRY(DEM_NEW(sentences, told + (size_t)n + 1));
    for (size_t k = 0; k < told + (size_t)n; k++)
    {
        sentences[k] = k < repeated ? repeats[k]
                     : k < told ? d->note[k - repeated] : own[k - told];
    }
    dem_text_free(&d->warnings);
    feholdexcept(&caller);
    int status = dem_warnings_write(&d->warnings, &plan, d->coupled, (int)told + n, sentences);

    status = status ? status : dem_collect_status(&d->state.decomposition);
    fesetenv(&caller);
    dem_memory_free(sentences);
    *text = d->warnings.text ? d->warnings.text : "";
    return status;
}

int dem_impact_warning(struct dem *d, double overlap, const char **text)
{
    struct dem_impact impact;
    fenv_t caller;

    dem_text_free(&d->impact);
    feholdexcept(&caller);
    const double speed = dem_totals_max_speed(&d->state);

    dem_impact_at(&d->state.interaction_table, speed, &impact);
    if (overlap > DEM_IMPACT_OVERLAP && overlap > 1.5*d->said_overlap)
    {
        d->said_overlap = overlap;
        dem_impact_describe_overlap(&impact, overlap, speed, &d->impact);
    }
    else if (speed > 1.5*d->said_speed && dem_impact_describe(&impact, speed, &d->impact))
    {
        d->said_speed = speed;
    }
    fesetenv(&caller);
    *text = d->impact.text ? d->impact.text : "";
    return d->impact.status ? d->impact.status : dem_collect_status(&d->state.decomposition);
}

int dem_verdicts(const struct dem *d, const struct dem_verdict **verdict)
{
    *verdict = d->verdicts ? d->verdicts->verdict : NULL;
    return d->verdicts ? d->verdicts->n : 0;
}

int dem_bed_slab(const struct dem *d, double up[3], double *low, double *high)
{
    struct dem_bed_packing bed;
    const int found = dem_bed_packing_measure(&d->state, &bed);

    memset(up, 0, 3*sizeof *up);
    *low = *high = 0.0;
    if (found)
    {
        memcpy(up, bed.up, sizeof bed.up);
        *low = bed.low;
        *high = bed.high;
    }
    return found;
}
