/*
 * effects_api.c -- the list of effects as text: settings, and measured cost.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "api/internal.h"
#include "advisor/effect_cost.h"
#include "advisor/effect_text.h"
#include "core/error.h"
#include "effects/effects.h"
#include "parallel/collect.h"

const char *dem_effect_name(int k)
{
    const struct dem_effect *const *e = dem_effects;

    while (*e && k > 0)
    {
        e++;
        k--;
    }
    return k >= 0 && *e ? (*e)->name : NULL;
}

/* The effect of this name; *text is to be set to d->effect, which is empty then. */
static int begin_text(struct dem *d, const char *name, const struct dem_effect **e)
{
    dem_text_free(&d->effect);
    *e = name ? dem_effects_find(name) : NULL;
    return name && !*e ? dem_effects_unknown("effects", name) : DEM_OK;
}

int dem_effect_text(struct dem *d, const char *effect, const char **text)
{
    const struct dem_effect *e;

    DEM_TRY(begin_text(d, effect, &e));
    for (const struct dem_effect *const *other = dem_effects; *other; other++)
    {
        if (!e || e == *other)
        {
            dem_effect_text_add(&d->effect, *other);
        }
    }
    *text = d->effect.text;
    return d->effect.status;
}

int dem_effect_cost_text(struct dem *d, const char *effect, double seconds, const char **text)
{
    const struct dem_effect *e;

    DEM_TRY(begin_text(d, effect, &e));
    DEM_TRY(e ? dem_effect_cost_row(&d->effect, e, seconds)
              : dem_effect_cost_heading(&d->effect, seconds));
    *text = d->effect.text;
    return DEM_OK;
}

int dem_effect_cost(struct dem *d, const char *effect, double seconds, struct dem_effect_cost *m)
{
    struct dem_inventory inventory;

    DEM_REQUIRE(d->is_set_up, DEM_ERROR_STATE, "dem_effect_cost comes after dem_setup");
    dem_inventory_take(&d->state, &inventory);
    DEM_TRY(dem_collect_status(&d->state.decomposition));
    return dem_effect_cost_measure(&d->state, &inventory, d->step, effect, seconds, m);
}
