/*
 * scene_quiet.c -- the entry time/untilQuiet, and the same settings of a stage; run/until_quiet.c tests
 * them.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "case/dem_case.h"
#include "case/scene_internal.h"
#include "core/error.h"
#include <math.h>

static int check_settings(const struct dem_quiet *q, const struct dem_dict *dict)
{
    DEM_REQUIRE(q->moving >= 0.0 && q->moving < 1.0, DEM_ERROR_INPUT, "%s: moving %g; give the "
                "fraction of particles that may still move, 0 to 1",
                dem_dict_where(dict), q->moving);
    DEM_REQUIRE(q->kinetic > 0.0 && q->speed >= 0.0
                    && (q->speed > 0.0 || !dem_dict_has(dict, "speed"))
                    && (q->lasting > 0.0 || !dem_dict_has(dict, "lasting"))
                    && q->imbalance > 0.0,
                DEM_ERROR_INPUT,
                "%s: kinetic %g, speed %g m/s, lasting %g s, imbalance %g; give numbers above 0",
                dem_dict_where(dict), q->kinetic, q->speed, q->lasting, q->imbalance);
    return DEM_OK;
}

int dem_scene_read_quiet(const struct dem_dict *dict, struct dem_quiet *q)
{
    *q = (struct dem_quiet){.kinetic = 1e-6, .moving = 0.01, .imbalance = 0.01, .since = INFINITY,
                            .tested = -INFINITY};
    if (!dict)
    {
        return DEM_OK;
    }
    q->wanted = 1;
    DEM_REQUIRE(!dem_dict_has(dict, "kinetic") || !dem_dict_has(dict, "speed"), DEM_ERROR_INPUT,
                "%s: both kinetic and speed; keep one", dem_dict_where(dict));
    DEM_TRY(dem_dict_number_or(dict, "kinetic", "1", q->kinetic, &q->kinetic));
    DEM_TRY(dem_dict_number_or(dict, "speed", "m/s", 0.0, &q->speed));
    DEM_TRY(dem_dict_number_or(dict, "lasting", "s", 0.0, &q->lasting));
    DEM_TRY(dem_dict_number_or(dict, "moving", "1", q->moving, &q->moving));
    DEM_TRY(dem_dict_number_or(dict, "imbalance", "1", q->imbalance, &q->imbalance));
    return check_settings(q, dict);
}

int dem_case_read_quiet(const struct dem_case *c, struct dem_quiet *q)
{
    const struct dem_dict *time, *dict = NULL;

    *q = (struct dem_quiet){.wanted = 0};
    DEM_REQUIRE(c->d->dict, DEM_ERROR_STATE, "time/untilQuiet is read after the scene has been "
                "read");
    DEM_TRY(dem_dict_sub_if(c->d->dict, "time", &time));
    DEM_TRY(time ? dem_dict_sub_if(time, "untilQuiet", &dict) : DEM_OK);
    return dem_scene_read_quiet(dict, q);
}
