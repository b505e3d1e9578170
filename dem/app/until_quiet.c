/*
 * until_quiet.c -- read time/untilQuiet, test whether particles are at rest, print the result.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "app/until_quiet.h"
#include "core/error.h"
#include <math.h>
#include <stdio.h>

int dem_quiet_read(struct dem_quiet *q, const struct dem_dict *time)
{
    const struct dem_dict *dict;

    DEM_TRY(dem_dict_sub_if(time, "untilQuiet", &dict));
    if (!dict)
    {
        return DEM_OK;
    }
    q->wanted = 1;
    q->since = INFINITY;
    DEM_REQUIRE(!dem_dict_has(dict, "kinetic") || !dem_dict_has(dict, "speed"), DEM_ERROR_INPUT,
                "%s: both kinetic and speed; keep one", dem_dict_where(dict));
    DEM_TRY(dem_dict_number_or(dict, "kinetic", "1", 1e-6, &q->kinetic));
    DEM_TRY(dem_dict_number_or(dict, "speed", "m/s", 0.0, &q->speed));
    DEM_TRY(dem_dict_number(dict, "lasting", "s", &q->lasting));
    DEM_TRY(dem_dict_number_or(dict, "moving", "1", 0.01, &q->moving));
    DEM_REQUIRE(q->moving >= 0.0 && q->moving < 1.0, DEM_ERROR_INPUT, "%s: moving %g; give the "
                "fraction of particles that may still move, 0 to 1",
                dem_dict_where(dict), q->moving);
    DEM_REQUIRE(q->kinetic > 0.0 && q->speed >= 0.0 && q->lasting > 0.0
                    && (q->speed > 0.0 || !dem_dict_has(dict, "speed")),
                DEM_ERROR_INPUT, "%s: kinetic %g, speed %g m/s, lasting %g s; give numbers above 0",
                dem_dict_where(dict), q->kinetic, q->speed, q->lasting);
    return DEM_OK;
}

/* Without gravity there is no energy of falling to compare with. */
int dem_quiet_check(const struct dem_quiet *q, const double gravity[3])
{
    DEM_REQUIRE(!q->wanted || q->speed > 0.0 || gravity[0] != 0.0 || gravity[1] != 0.0
                    || gravity[2] != 0.0,
                DEM_ERROR_INPUT,
                "time/untilQuiet compares with the energy of falling by a diameter, but there is "
                "no gravity; give speed, or add gravity");
    return DEM_OK;
}

int64_t dem_quiet_tests(const struct dem_quiet *q, double interval)
{
    return q->wanted ? (int64_t)fmax(1.0, ceil(5.0*interval/q->lasting)) : 1;
}

int dem_quiet_test(struct dem_quiet *q, struct dem *d, const struct dem_totals *t)
{
    const double n = t->particles > 0 ? (double)t->particles : 1.0;

    if (!q->wanted)
    {
        return DEM_OK;
    }
    DEM_TRY(dem_count_moving(d,
                             q->speed > 0.0 ? 0.5*t->mass/n*q->speed*q->speed
                                            : q->kinetic*t->fall_energy/n,
                             &q->move));
    q->since = (double)q->move > q->moving*(double)t->particles ? INFINITY
             : isfinite(q->since) ? q->since
                                                                  : t->time;
    q->reached = t->time - q->since >= q->lasting*(1.0 - 1e-9);
    return DEM_OK;
}

void dem_quiet_print(const struct dem_quiet *q, const struct dem_program *prog,
                     const struct dem_totals *t)
{
    if (q->wanted && prog->rank == 0)
    {
        printf("%s at t %.6g s: %lld of %lld particles move\n", q->reached ? "quiet" : "not quiet",
               t->time, (long long)q->move, (long long)t->particles);
    }
}
