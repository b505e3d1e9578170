/*
 * scene_fluid.c -- the entry fluid: a uniform fluid for drag laws and other fluid effects.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "core/error.h"
#include "case/scene_internal.h"
#include "laws/effects.h"
#include <float.h>
#include <stdio.h>
#include <string.h>

/* Entries that only some effects need; without such an effect they are refused as unread. */
static int read_fluid_derivatives(struct dem_uniform_fluid *f, const struct dem_dict *dict,
                                  unsigned needs)
{
    static const double zero[3] = {0.0, 0.0, 0.0};

    DEM_TRY(needs & DEM_NEEDS_ACCELERATION
                ? dem_dict_vector_or(dict, "acceleration", "m/s2", zero, f->acceleration)
                : DEM_OK);
    DEM_TRY(needs & DEM_NEEDS_VORTICITY
                ? dem_dict_vector_or(dict, "vorticity", "1/s", zero, f->vorticity)
                : DEM_OK);
    if (needs & DEM_NEEDS_TURBULENCE)
    {
        DEM_TRY(dem_dict_number_or(dict, "turbulentEnergy", "m2/s2", 0.0, &f->turbulence[0]));
        DEM_TRY(dem_dict_number_or(dict, "dissipation", "m2/s3", 0.0, &f->turbulence[1]));
        DEM_REQUIRE(f->turbulence[0] >= 0.0
                        && f->turbulence[1] >= (f->turbulence[0] > 0.0 ? DBL_MIN : 0.0),
                    DEM_ERROR_INPUT,
                    "%s: fluid: turbulentEnergy %g m2/s2, dissipation %g m2/s3; both must be above"
                    " 0, or both 0",
                    dem_dict_where(dict), f->turbulence[0], f->turbulence[1]);
    }
    return needs & DEM_NEEDS_STRESS
             ? dem_dict_vector_or(dict, "viscousStress", "N/m3", zero, f->stress)
             : DEM_OK;
}

static int uses(const struct dem_effect *effect, const char *entry)
{
    int found = 0;

    for (const struct dem_scalar *const *s = effect->scalars; s && *s; s++)
    {
        found |= (*s)->fluid_entry && strcmp((*s)->fluid_entry, entry) == 0;
    }
    return found;
}

/* A value that no effect of the scene reads. */
static int refuse_unused(const struct dem_dict *dict, const struct dem_interaction_table *r)
{
    for (size_t k = 0; k < dem_dict_count(dict); k++)
    {
        const struct dem_entry *const e = dem_dict_entry(dict, k);
        char effects[256] = "";
        int used = strcmp(dem_entry_name(e), "viscosity") == 0;

        for (int m = 0; m < r->chosen; m++)
        {
            used |= uses(r->effect[m], dem_entry_name(e));
        }
        for (int m = 0; !used && dem_effects[m]; m++)
        {
            const size_t n = strlen(effects);

            if (uses(dem_effects[m], dem_entry_name(e)))
            {
                snprintf(effects + n, sizeof effects - n, "%s%s", n > 0 ? ", " : "", dem_effects[m]->name);
            }
        }
        DEM_REQUIRE(!*effects, DEM_ERROR_INPUT,
                    "%s: fluid/%s acts only with one of these effects: %s; add one, or remove the entry",
                    dem_entry_where(e), dem_entry_name(e), effects);
    }
    return DEM_OK;
}

/* Values of the fluid that are scalars of the effects. */
static int read_fluid_scalars(struct dem_uniform_fluid *f, const struct dem_dict *dict,
                              const struct dem_interaction_table *r)
{
    DEM_TRY(refuse_unused(dict, r));
    for (int k = 0; k < r->scalars; k++)
    {
        const struct dem_scalar *const s = r->scalar[k];
        double *const value = &f->value[f->scalars];

        if (s->fluid_entry)
        {
            DEM_TRY(dem_dict_number(dict, s->fluid_entry, s->unit, value));
            DEM_REQUIRE(*value > 0.0 && *value <= s->max, DEM_ERROR_INPUT,
                        "%s: fluid: %s %g %s; give a number above 0, at most %g",
                        dem_dict_where(dict), s->fluid_entry, *value, s->unit, s->max);
            f->scalar[f->scalars++] = k;
        }
    }
    return DEM_OK;
}

int dem_scene_read_fluid(struct dem_uniform_fluid *f, const struct dem_dict *scene,
                         const struct dem_interaction_table *r)
{
    static const double zero[3] = {0.0, 0.0, 0.0};
    const struct dem_dict *dict;
    double hydrostatic[3];

    DEM_TRY(dem_dict_sub_if(scene, "fluid", &dict));
    if (!dict)
    {
        return DEM_OK;
    }
    f->given = 1;
    DEM_TRY(dem_dict_vector_or(dict, "velocity", "m/s", zero, f->velocity));
    DEM_TRY(dem_dict_number(dict, "density", "kg/m3", &f->density));
    DEM_TRY(dem_dict_number(dict, "viscosity", "Pa s", &f->viscosity));
    DEM_TRY(dem_dict_number_or(dict, "voidFraction", "1", 1.0, &f->void_fraction));
    DEM_REQUIRE(f->density > 0.0 && f->viscosity > 0.0 && f->void_fraction > 0.0
                    && f->void_fraction <= 1.0,
                DEM_ERROR_INPUT,
                "%s: fluid: density %g kg/m3, viscosity %g Pa s, voidFraction %g; all must be "
                "above 0, the last at most 1",
                dem_dict_where(dict), f->density, f->viscosity, f->void_fraction);
    DEM_TRY(read_fluid_derivatives(f, dict, dem_interaction_table_needs(r)));
    DEM_TRY(read_fluid_scalars(f, dict, r));
    /* the default: a fluid at rest under the scene's gravity, gradient rho g */
    dem_interaction_table_gravity(r, hydrostatic);
    for (int k = 0; k < 3; k++)
    {
        hydrostatic[k] *= f->density;
    }
    return dem_dict_vector_or(dict, "pressureGradient", "Pa/m", hydrostatic, f->pressure_gradient);
}
