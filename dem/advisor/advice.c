/*
 * advice.c -- the public calls that advise: plan and warnings.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "advisor/plan.h"
#include "advisor/warnings.h"
#include "core/error.h"
#include <fenv.h>

int dem_plan(struct dem *d, const struct dem_run_info *run, const char **text)
{
    static _Thread_local struct dem_text t;
    struct dem_plan plan;
    fenv_t caller;

    dem_text_free(&t);
    feholdexcept(&caller);
    int status = dem_plan_begin(&plan, d, run);

    status = status ? status : dem_plan_write(&t, &plan);
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
