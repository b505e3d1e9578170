/*
 * wall_scalars.c -- read what a wall gives to particle scalars.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "walls/wall_scalars.h"
#include "core/error.h"
#include "core/memory.h"
#include "particles/scalar_entry.h"
#include <math.h>

static int read_condition(const struct dem_dict *dict, const struct dem_interaction_table *r, int k,
                          struct dem_wall_scalar *w)
{
    const bool value = dem_dict_has(dict, "value"), flux = dem_dict_has(dict, "flux"),
               film = dem_dict_has(dict, "film");

    DEM_REQUIRE((value && !flux) || (flux && !value && !film), DEM_ERROR_INPUT,
                "%s: %s: give value, or value and film, or flux", dem_dict_where(dict),
                dem_dict_path(dict));
    DEM_REQUIRE(!value || !(r->scalar[k]->flags & DEM_SCALAR_AMOUNT), DEM_ERROR_INPUT,
                "%s: %s: a wall has no %s of its own; give flux, in %s per m2 and s",
                dem_dict_where(dict), dem_dict_path(dict), r->scalar[k]->name, r->scalar[k]->unit);
    DEM_TRY(dem_dict_number_or(dict, "value", r->scalar[k]->unit, 0.0, &w->value));
    DEM_TRY(dem_dict_number_or(dict, "flux", "per m2 and s", 0.0, &w->flux));
    DEM_TRY(dem_dict_number_or(dict, "film", "per m2 and s", 0.0, &w->film));
    DEM_TRY(dem_dict_number_or(dict, "start", "s", -INFINITY, &w->start));
    DEM_TRY(dem_dict_number_or(dict, "end", "s", INFINITY, &w->end));
    DEM_REQUIRE(w->film >= 0.0, DEM_ERROR_INPUT, "%s: %s: film %g; give a number of 0 or more",
                dem_dict_where(dict), dem_dict_path(dict), w->film);
    DEM_REQUIRE(w->start < w->end, DEM_ERROR_INPUT, "%s: %s: start %g s is not before end %g s",
                dem_dict_where(dict), dem_dict_path(dict), w->start, w->end);
    w->given = value && !film;
    return value ? dem_scalar_require(r, k, w->value, dem_dict_where(dict)) : DEM_OK;
}

int dem_scalar_wall_read(const struct dem_dict *dict, const struct dem_interaction_table *r,
                         struct dem_wall *wall)
{
    const struct dem_dict *sub;

    /* what a wall gives is a rate of a contact */
    DEM_TRY(dem_scalar_refuse_unused(dict, r, DEM_STAGE_SCALAR));
    for (int k = 0; k < r->scalars; k++)
    {
        const unsigned of_contacts = DEM_SCALAR_PARTNERS | DEM_SCALAR_RATE;

        sub = NULL;
        DEM_TRY(r->scalar[k]->fluid_entry || !(r->scalar[k]->flags & of_contacts)
                    ? DEM_OK
                    : dem_dict_sub_if(dict, r->scalar[k]->name, &sub));
        if (!sub)
        {
            continue;
        }
        if (!wall->scalars)
        {
            DEM_TRY(DEM_NEW(wall->scalars, r->scalars));
            for (int m = 0; m < r->scalars; m++)
            {
                wall->scalars[m].end = -INFINITY;
            }
        }
        DEM_TRY(read_condition(sub, r, k, &wall->scalars[k]));
    }
    return DEM_OK;
}
