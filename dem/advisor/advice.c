/*
 * advice.c -- the public calls that advise: plan and warnings.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "advisor/plan.h"
#include "advisor/warnings.h"
#include "core/error.h"
#include <fenv.h>

/* The paragraphs in order. */
static int write_plan(struct dem_text *t, struct dem_plan *p)
{
    const char *scene;

    DEM_TRY(dem_scene_text(p->d, &scene));
    dem_text_add(t, "%s", scene);
    if (p->scene.particles > 0.0)
    {
        DEM_TRY(dem_run_cost(p->d, &p->cost));
    }
    dem_plan_parcels(t, p);
    dem_plan_bed(t, p);
    dem_plan_fluid(t, p);
    dem_plan_regime(t, p);
    dem_plan_step(t, p);
    dem_plan_cost(t, p);
    return t->status;
}

int dem_plan(struct dem *d, const struct dem_run_info *run, const char **text)
{
    static _Thread_local struct dem_text t;
    struct dem_plan plan;
    fenv_t caller;

    dem_text_free(&t);
    feholdexcept(&caller);
    int status = dem_plan_begin(&plan, d, run);

    status = status ? status : write_plan(&t, &plan);
    fesetenv(&caller);
    *text = t.text;
    return status;
}

int dem_warnings(struct dem *d, const struct dem_run_info *run, int n, const char *const *own,
                 const char **text)
{
    static _Thread_local struct dem_text t;
    struct dem_plan plan;
    fenv_t caller;

    DEM_REQUIRE(n >= 0, DEM_ERROR_INPUT, "dem_warnings: %d sentences; the number must be 0 or more",
                n);
    dem_text_free(&t);
    feholdexcept(&caller);
    int status = dem_plan_begin(&plan, d, run);

    status = status ? status : dem_warnings_write(&t, &plan, n, own);
    fesetenv(&caller);
    *text = t.text ? t.text : "";
    return status;
}
