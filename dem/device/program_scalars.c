/*
 * program_scalars.c -- text of a program for particle scalars.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "device/program_scalars.h"
#include <float.h>
#include <math.h>

void dem_device_scalars_before(struct dem_text *out, const struct dem_effect_entry *e, int contact)
{
    for (int m = 0; m < e->scalars; m++)
    {
        const int k = e->scalar[m];

        if (contact)
        {
            dem_text_add(out,
                         "    r->scalars[%d].i = q->value[0][%d];\n"
                         "    r->scalars[%d].j = q->value[1][%d];\n"
                         "    r->scalars[%d].rate_i = q->rate[0][%d];\n"
                         "    r->scalars[%d].rate_j = q->rate[1][%d];\n"
                         "    r->scalars[%d].radius_i = q->radius[0];\n"
                         "    r->scalars[%d].radius_j = q->radius[1];\n",
                         m, k, m, k, m, k, m, k, m, m);
            continue;
        }
        dem_text_add(out,
                     "    r->scalars[%d].value = q->value[%d];\n"
                     "    r->scalars[%d].rate = q->rate[%d];\n"
                     "    r->scalars[%d].coefficient = q->coefficient[%d];\n"
                     "    r->scalars[%d].to_target = q->to_target[%d];\n",
                     m, k, m, k, m, k, m, k);
    }
}

void dem_device_scalars_after(struct dem_text *out, const struct dem_effect_entry *e, int contact)
{
    const int k = e->scalar[0];

    if (e->scalars > 0 && contact)
    {
        dem_text_add(out,
                     "    q->rate[0][%d] = r->scalars[0].rate_i;\n"
                     "    q->rate[1][%d] = r->scalars[0].rate_j;\n", k, k);
    }
    else if (e->scalars > 0)
    {
        dem_text_add(out,
                     "    q->rate[%d] = r->scalars[0].rate;\n"
                     "    q->coefficient[%d] = r->scalars[0].coefficient;\n"
                     "    q->to_target[%d] = r->scalars[0].to_target;\n", k, k, k);
    }
}

void dem_device_scalars_text(struct dem_text *out, const struct dem_interaction_table *r)
{
    int exchange = r->scalars, heat = -1;

    for (int k = 0; k < r->scalars; k++)
    {
        heat = r->scalar[k]->flags & DEM_SCALAR_HEAT ? k : heat;
    }

    dem_text_add(out, "#define SCALARS %d\n#define RATES %d\n", r->listed, r->contact_scalars);
    if (r->listed == 0)
    {
        return;
    }
    dem_text_add(out, "constant int dem_scalar_column[] = {");
    for (int k = 0; k < r->listed; k++)
    {
        dem_text_add(out, "COLUMN_FURTHER_%d, ", k);
    }
    dem_text_add(out, "};\nconstant int dem_scalar_exchange[] = {");
    for (int k = 0; k < r->listed; k++)
    {
        dem_text_add(out, r->exchanged[k] ? "COLUMN_FURTHER_%d, " : "-1, ", exchange);
        exchange += r->exchanged[k] ? DEM_SCALAR_COLUMNS : 0;
    }
    dem_text_add(out, "};\nconstant int dem_scalar_rated[] = {");
    for (int k = 0; k < r->listed; k++)
    {
        dem_text_add(out, "%d, ", (r->scalar[k]->flags & DEM_SCALAR_RATE) != 0);
    }
    dem_text_add(out, "};\n#define dem_scalar_heat %d\nconstant double dem_scalar_limits[] = {", heat);
    for (int k = 0; k < r->listed; k++)
    {
        dem_text_add(out, "%a, %a, ", fmax(r->scalar[k]->min, -DBL_MAX),
                     fmin(r->scalar[k]->max, DBL_MAX));
    }
    dem_text_add(out, "};\nconstant double dem_scalar_capacity[] = {");
    for (int k = 0; k < r->listed*DEM_MATERIALS; k++)
    {
        dem_text_add(out, "%a, ", r->capacity[k/DEM_MATERIALS][k%DEM_MATERIALS]);
    }
    dem_text_add(out, "};\n");
}
