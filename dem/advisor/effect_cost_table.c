/*
 * effect_cost_table.c -- the table of `dem effects -cost`: processor time and memory of each effect.
 *
 * A bed of 2000 spheres of 1 mm with the effects that the measured one requires (damping a normal
 * law, rolling resistance friction ...), once with the effect and once without, in a block at rest
 * in which each sphere has 8 contacts (effect_cost.c). The first row compares the bed with itself:
 * it is the noise of the measurement.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "advisor/effect_cost.h"
#include "core/error.h"
#include "dem.h"
#include "laws/effects.h"
#include <string.h>

/* ---- scenes ---------------------------------------------------------------------------------- */

static void add_effect(struct dem_text *t, const struct dem_effect *e)
{
    dem_text_add(t, "%s { %s }", e->name, e->example ? e->example : "");
}

/* The effects that this one requires: the first ones of the stages before it, and in a fluid the
   pressure gradient and a drag law for beds. */
static void add_required(struct dem_text *t, const struct dem_effect *e)
{
    static const struct
    {
        enum dem_stage stage, from;                       /* effects of stage `from` and later ones
                                                             require one of `stage` */
    } base[] = {{DEM_STAGE_NORMAL, DEM_STAGE_DAMP},
                {DEM_STAGE_DAMP, DEM_STAGE_TANGENT},
                {DEM_STAGE_TANGENT, DEM_STAGE_MOMENT},
                {DEM_STAGE_BODY, DEM_STAGE_FLUID}};

    for (size_t k = 0; k < sizeof base/sizeof base[0]; k++)
    {
        if (e->stage >= base[k].from)
        {
            add_effect(t, dem_effects_first(base[k].stage));
        }
    }
    for (const struct dem_effect *const *other = dem_effects; *other && e->stage == DEM_STAGE_FLUID;
         other++)
    {
        if ((*other)->has_pressure_gradient && *other != e)
        {
            add_effect(t, *other);
        }
    }
    if (e->stage == DEM_STAGE_FLUID && !e->drag)
    {
        add_effect(t, dem_effects_drag_law(DEM_DRAG_BED));
    }
}

static int make_bed(struct dem **d, const struct dem_effect *e, int with)
{
    struct dem_text t = {.n = 0};

    dem_text_add(&t, "materials { glass { density 2500; youngsModulus 1e7; conductivity 1; "
                     "heatCapacity 800; emissivity 0.9; } } fluid { density 1000; viscosity 1e-3; "
                     "velocity (0 0 0.1); ");
    for (const struct dem_scalar *const *k = e ? e->scalars : NULL; k && *k; k++)
    {
        if ((*k)->fluid_entry)
        {
            dem_text_add(&t, "%s 1; ", (*k)->fluid_entry);
        }
    }
    dem_text_add(&t, "} insert { bed { type lattice; count 2000; diameter "
                     "1e-3; min (0 0 0); max (0.02 0.02 0.02); } } time { step 1e-6; } effects {");
    if (e)
    {
        add_required(&t, e);
    }
    else
    {
        add_effect(&t, dem_effects_first(DEM_STAGE_NORMAL));
        add_effect(&t, dem_effects_first(DEM_STAGE_DAMP));
        add_effect(&t, dem_effects_first(DEM_STAGE_TANGENT));
    }
    if (with)
    {
        add_effect(&t, e);
    }
    dem_text_add(&t, " }");
    int status = t.status ? t.status : dem_create(d, MPI_COMM_NULL);

    if (!status)
    {
        status = dem_scene_text(*d, t.text, e ? e->name : "the bed");
        status = status ? status : dem_setup(*d);
        if (status)
        {
            dem_free(*d);
        }
    }
    dem_text_free(&t);
    return status;
}

/* ---- measurement ----------------------------------------------------------------------------- */

static void add_names_required(struct dem_text *row, const struct dem_effect *e)
{
    struct dem_text t = {.n = 0};

    add_required(&t, e);
    for (char *at = t.text; at && (at = strchr(at, '{')); )    /* the names without settings */
    {
        char *const end = strchr(at, '}');

        memmove(at, end + 1, strlen(end + 1) + 1);
    }
    dem_text_add(row, " %s\n", t.n > 0 ? t.text : "nothing");
    dem_text_free(&t);
}

int dem_effect_cost_row(struct dem_text *t, const struct dem_effect *e, double seconds)
{
    struct dem_effect_cost m, bare;
    struct dem *d;

    DEM_TRY(make_bed(&d, e, 1));
    int status = dem_effect_cost(d, e->name, seconds, &m);

    dem_free(d);
    DEM_TRY(status);
    DEM_TRY(make_bed(&d, e, 0));
    status = dem_effect_cost(d, NULL, 0.0, &bare);
    dem_free(d);
    DEM_TRY(status);
    dem_text_add(t, "%-18s %7.1f %9.1f %+8.1f %%  %8.0f %9.0f   ", e->name, 1e9*m.without,
           1e9*(m.with - m.without), 100.0*(m.with/m.without - 1.0),
           m.particle - bare.particle, m.row - bare.row);
    if (e->stage < DEM_STAGE_BODY)
    {
        dem_text_add(t, "%7.1f  ", 1e9*(m.with - m.without)/DEM_EFFECT_COST_CONTACTS);
    }
    else
    {
        dem_text_add(t, "%7s  ", "");
    }
    add_names_required(t, e);
    return t->status;
}

int dem_effect_cost_heading(struct dem_text *t, double seconds)
{
    struct dem_effect_cost m;
    struct dem *d;

    DEM_TRY(make_bed(&d, NULL, 0));
    const int status = dem_effect_cost(d, NULL, seconds, &m);

    dem_free(d);
    DEM_TRY(status);
    dem_text_add(t, "Processor time per particle and step in a bed at rest, %d contacts per particle; "
                    "the fastest of several runs\n", DEM_EFFECT_COST_CONTACTS);
    dem_text_add(t, "%-18s %7s %9s %10s  %8s %9s   %7s  %s\n", "effect", "ns", "ns more", "more", "bytes",
           "bytes", "ns", "beside");
    dem_text_add(t, "%-18s %7s %9s %10s  %8s %9s   %7s\n", "", "without", "with it", "", "particle",
           "contact", "contact");
    dem_text_add(t, "%-18s %7.1f %9.1f %+8.1f %%  %8d %9d   %7.1f   %s %s %s\n", "(nothing)",
           1e9*m.without, 1e9*(m.with - m.without), 100.0*(m.with/m.without - 1.0), 0, 0,
           1e9*(m.with - m.without)/DEM_EFFECT_COST_CONTACTS,
           dem_effects_first(DEM_STAGE_NORMAL)->name, dem_effects_first(DEM_STAGE_DAMP)->name,
           dem_effects_first(DEM_STAGE_TANGENT)->name);
    return t->status;
}
