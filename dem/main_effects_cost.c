/*
 * main_effects_cost.c -- `dem effects -cost`: what each effect takes, measured now.
 *
 * A bed of 2000 spheres of 1 mm with what the effect leans on (a law of damping leans on a normal law, one of rolling on friction ...), once
 * with the effect and once without, in a block at rest in which each sphere touches 8 (plan/marginal.h). The first row is the bed against
 * itself: what is no larger can't be told from nothing.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "main_effects.h"
#include "dem.h"
#include "base/error.h"
#include "effects/effects.h"
#include "plan/marginal.h"
#include "plan/text.h"
#include <math.h>
#include <stdio.h>
#include <string.h>

static const double long_enough = 0.5;                    /* s of processor time an effect */

/* What stands in for the numbers that each scene must give; others get a tenth. They change no time. */
static const struct
{
    const char *effect, *settings;
} usual[] =
{
    {"hookeHysteresis", "unloading 5; adhesion 0.1;"}, {"dry", "restitution 0.9;"}, {"viscous", "coefficient 1e-4;"},
    {"stokes", "restitution 0.9;"}, {"rollingViscous", "time 1e-3;"}, {"sjkr", "energyDensity 1e3;"}, {"jkr", "workOfAdhesion 1e-3;"},
    {"bondLinear", "normalStiffness 1e9; shearStiffness 1e9;"}, {"lubrication", "roughness 1e-6; cutOff 5e-5;"},
    {"gravity", "acceleration (0 0 -9.81);"},
};

/* ---- scenes ---------------------------------------------------------------------------------------------------- */

static void add_settings(struct dem_text *t, const struct dem_effect *e)
{
    for (size_t k = 0; k < sizeof usual/sizeof usual[0]; k++)
    {
        if (strcmp(usual[k].effect, e->name) == 0)
        {
            dem_text_add(t, "%s", usual[k].settings);
            return;
        }
    }
    for (const struct dem_field *f = e->settings; f && f->name; f++)
    {
        if (isnan(f->def))
        {
            dem_text_add(t, f->kind == DEM_FIELD_VECTOR ? "%s (0.1 0.1 0.1); " : "%s 0.1; ", f->name);
        }
    }
}

static void add_effect(struct dem_text *t, const char *name)
{
    dem_text_add(t, "%s { ", name);
    add_settings(t, dem_effects_find(name));
    dem_text_add(t, " }");
}

/* The effects that this one leans on. */
static void add_base(struct dem_text *t, const struct dem_effect *e)
{
    static const struct
    {
        const char *name;
        enum dem_stage from;                              /* effects of this stage and later ones lean on it */
    } base[] = {{"hertz", DEM_STAGE_DAMP}, {"dry", DEM_STAGE_TANGENT}, {"mindlin", DEM_STAGE_MOMENT}, {"gravity", DEM_STAGE_FLUID},
                {"pressureGradient", DEM_STAGE_FLUID}};

    for (size_t k = 0; k < sizeof base/sizeof base[0]; k++)
    {
        if (e->stage >= base[k].from && strcmp(e->name, base[k].name) != 0)
        {
            add_effect(t, base[k].name);
        }
    }
    if (e->stage == DEM_STAGE_FLUID && !e->drag)
    {
        add_effect(t, "gidaspow");
    }
}

static int bed(struct dem **d, const struct dem_effect *e, int with)
{
    struct dem_text t = {.n = 0};

    dem_text_add(&t, "materials { glass { density 2500; youngsModulus 1e7; } } fluid { density 1000; viscosity 1e-3; velocity (0 0 0.1); } "
                 "insert { bed { type lattice; count 2000; diameter 1e-3; min (0 0 0); max (0.02 0.02 0.02); } } time { step 1e-6; } effects {");
    if (e)
    {
        add_base(&t, e);
    }
    else
    {
        add_effect(&t, "hertz");
        add_effect(&t, "dry");
        add_effect(&t, "mindlin");
    }
    if (with)
    {
        add_effect(&t, e->name);
    }
    dem_text_add(&t, " }");
    int status = t.status ? t.status : dem_create(d, MPI_COMM_NULL);

    if (!status)
    {
        status = dem_scene_text(*d, t.text, e ? e->name : "the bed");
        status = status ? status : dem_ready(*d);
        if (status)
        {
            dem_free(*d);
        }
    }
    dem_text_free(&t);
    return status;
}

/* ---- measuring ------------------------------------------------------------------------------------------------- */

static void tell_base(const struct dem_effect *e)
{
    struct dem_text t = {.n = 0};

    add_base(&t, e);
    for (char *at = t.text; at && (at = strchr(at, '{')); )      /* the words alone */
    {
        char *const end = strchr(at, '}');

        memmove(at, end + 1, strlen(end + 1) + 1);
    }
    printf(" %s\n", t.n > 0 ? t.text : "nothing");
    dem_text_free(&t);
}

static int measure(const struct dem_effect *e)
{
    struct dem_marginal m, bare;
    struct dem *d;

    DEM_TRY(bed(&d, e, 1));
    int status = dem_marginal(d, e->name, long_enough, &m);

    dem_free(d);
    DEM_TRY(status);
    DEM_TRY(bed(&d, e, 0));
    status = dem_marginal(d, NULL, 0.0, &bare);
    dem_free(d);
    DEM_TRY(status);
    printf("%-18s %7.1f %9.1f %+8.1f %%  %8.0f %9.0f   ", e->name, 1e9*m.without, 1e9*(m.with - m.without), 100.0*(m.with/m.without - 1.0),
           m.particle - bare.particle, m.row - bare.row);
    if (e->stage < DEM_STAGE_BODY)
    {
        printf("%7.1f  ", 1e9*(m.with - m.without)/DEM_MARGINAL_CONTACTS);
    }
    else
    {
        printf("%7s  ", "");
    }
    tell_base(e);
    fflush(stdout);
    return DEM_OK;
}

static int measure_noise(void)
{
    struct dem_marginal m;
    struct dem *d;

    DEM_TRY(bed(&d, NULL, 0));
    const int status = dem_marginal(d, NULL, long_enough, &m);

    dem_free(d);
    DEM_TRY(status);
    printf("%-18s %7s %9s %10s  %8s %9s   %7s  %s\n", "effect", "ns", "ns more", "more", "bytes", "bytes", "ns", "beside");
    printf("%-18s %7s %9s %10s  %8s %9s   %7s\n", "", "without", "with it", "", "particle", "contact", "contact");
    printf("%-18s %7.1f %9.1f %+8.1f %%  %8d %9d   %7.1f   hertz dry mindlin\n", "(nothing)", 1e9*m.without, 1e9*(m.with - m.without),
           100.0*(m.with/m.without - 1.0), 0, 0, 1e9*(m.with - m.without)/DEM_MARGINAL_CONTACTS);
    return DEM_OK;
}

int dem_effects_cost(int argc, char **argv)
{
    for (int k = 0; k < argc; k++)
    {
        if (!dem_effects_find(argv[k]))
        {
            return dem_effects_unknown("dem effects -cost", argv[k]);
        }
    }
    printf("Time of one processor a particle and step in a bed at rest, %d contacts a particle; quickest of turns\n", DEM_MARGINAL_CONTACTS);
    DEM_TRY(measure_noise());
    for (int k = 0; k < argc; k++)
    {
        DEM_TRY(measure(dem_effects_find(argv[k])));
    }
    for (const struct dem_effect *const *e = dem_effects; argc == 0 && *e; e++)
    {
        DEM_TRY(measure(*e));
    }
    return DEM_OK;
}
