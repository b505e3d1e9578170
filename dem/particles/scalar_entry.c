/*
 * scalar_entry.c -- read values of particle scalars.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "particles/scalar_entry.h"
#include "core/error.h"
#include "laws/effects.h"
#include <math.h>
#include <stdio.h>
#include <string.h>

int dem_scalar_require(const struct dem_interaction_table *r, int scalar, double value,
                       const char *where)
{
    const struct dem_scalar *const s = r->scalar[scalar];

    DEM_REQUIRE(value >= s->min && value <= s->max && isfinite(value), DEM_ERROR_INPUT,
                "%s: %s %g %s; give a number from %g to %g", where, s->name, value, s->unit, s->min,
                s->max);
    return DEM_OK;
}

/* `last`: the last stage that counts. */
static bool has_scalar(const struct dem_effect *effect, enum dem_stage last, const char *name)
{
    for (const struct dem_scalar *const *s = effect->scalars; s && *s; s++)
    {
        if (!(*s)->fluid_entry && effect->stage <= last && strcmp((*s)->name, name) == 0)
        {
            return true;
        }
    }
    return false;
}

int dem_scalar_refuse_unused(const struct dem_dict *dict, const struct dem_interaction_table *r,
                             enum dem_stage last)
{
    for (size_t k = 0; k < dem_dict_count(dict); k++)
    {
        const struct dem_entry *const e = dem_dict_entry(dict, k);
        char effects[256] = "";
        bool used = false;

        for (int m = 0; m < r->chosen; m++)
        {
            used = used || has_scalar(r->effect[m], last, dem_entry_name(e));
        }
        for (int m = 0; !used && dem_effects[m]; m++)
        {
            const size_t n = strlen(effects);

            if (has_scalar(dem_effects[m], last, dem_entry_name(e)))
            {
                snprintf(effects + n, sizeof effects - n, "%s%s", n > 0 ? ", " : "",
                         dem_effects[m]->name);
            }
        }
        DEM_REQUIRE(!*effects, DEM_ERROR_INPUT,
                    "%s: unknown entry \"%s\" in %s; it acts only with one of these effects: %s. "
                    "Add one, or remove the entry", dem_entry_where(e), dem_entry_name(e),
                    dem_dict_path(dict), effects);
    }
    return DEM_OK;
}

static int read_entry(const struct dem_dict *dict, const struct dem_scalar *s,
                      struct dem_scalar_entry *e)
{
    const struct dem_dict *range;

    e->given = 1;
    if (!dem_dict_has_dict(dict, s->name))
    {
        DEM_TRY(dem_dict_number(dict, s->name, s->unit, &e->min));
        e->max = e->min;
        return DEM_OK;
    }
    DEM_TRY(dem_dict_sub(dict, s->name, &range));
    DEM_TRY(dem_dict_number(range, "min", s->unit, &e->min));
    DEM_TRY(dem_dict_number(range, "max", s->unit, &e->max));
    DEM_REQUIRE(e->min <= e->max, DEM_ERROR_INPUT, "%s: %s: min %g %s is above max %g %s",
                dem_dict_where(range), dem_dict_path(range), e->min, s->unit, e->max, s->unit);
    return DEM_OK;
}

int dem_scalar_entries_read(const struct dem_dict *dict, const struct dem_interaction_table *r,
                            int required, struct dem_scalar_entry entry[DEM_SCALARS])
{
    DEM_TRY(dem_scalar_refuse_unused(dict, r, DEM_STAGES));
    for (int k = 0; k < r->scalars; k++)
    {
        const struct dem_scalar *const s = r->scalar[k];
        const double value = dem_interaction_table_default(r, k);

        entry[k] = (struct dem_scalar_entry){.min = value, .max = value};
        if (!s->fluid_entry && dem_dict_has(dict, s->name))
        {
            DEM_TRY(read_entry(dict, s, &entry[k]));
            DEM_TRY(dem_scalar_require(r, k, entry[k].min, dem_dict_where(dict)));
            DEM_TRY(dem_scalar_require(r, k, entry[k].max, dem_dict_where(dict)));
        }
        DEM_REQUIRE(!required || !isnan(entry[k].min), DEM_ERROR_INPUT,
                    "%s: %s has no %s, which the effects need; add %s and a number in %s",
                    dem_dict_where(dict), dem_dict_path(dict), s->name, s->name, s->unit);
    }
    return DEM_OK;
}

int dem_scalar_entries_parcel_ratio(const struct dem_interaction_table *r,
                                    const struct dem_scalar_entry entry[DEM_SCALARS],
                                    const char *where, double *ratio)
{
    const struct dem_scalar_entry *const e = &entry[r->parcels.scalar];

    *ratio = r->parcels.used ? e->min : 1.0;
    DEM_REQUIRE(!r->parcels.used || e->min == e->max, DEM_ERROR_INPUT,
                "%s: parcelRatio from %g to %g; give one number, by which the diameters of the "
                "grains are multiplied", where, e->min, e->max);
    return DEM_OK;
}
