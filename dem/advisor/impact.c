/*
 * impact.c -- largest overlap of an impact at a speed, and the stiffness that it needs; formula in
 * warnings.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "advisor/warnings.h"
#include <math.h>

/* of a diameter; above it contacts are too soft: forces, packings and times of contact change */
static const double max_overlap = 0.05;

static const double far_overlap = 0.2;         /* reported also below impactSpeed */
static const double margin = 1.01;             /* of numbers that were printed with three digits */

static double setting(const struct dem_effect_entry *entry, const char *name)
{
    const struct dem_setting *const f =
        entry->effect->settings ? dem_settings_find(entry->effect->settings, name) : NULL;

    return f ? *(const double *)(const void *)((const char *)entry->settings + f->offset) : 0.0;
}

/* Overlap over the diameter of the smallest body. */
static double overlap_of(const struct dem_effect_entry *entry, const struct dem_pair_class *pair,
                         double speed)
{
    const double p = entry->effect->exponent, at = setting(entry, "impactSpeed");
    const double time = entry->effect->contact_time(entry->settings, pair);
    const double diameter = pair->min_radius*(pair->with_wall ? 2.0 : 4.0);
    const double c = p > 1.0 ? 2.9432751 : 3.14159265358979324;

    return at*time/c*pow(speed/at, 2.0/(p + 1.0))/diameter;
}

void dem_impact_at(const struct dem_interaction_table *r, double speed, struct dem_impact *m)
{
    *m = (struct dem_impact){.law = NULL};
    for (int c = 0; c < r->classes; c++)
    {
        for (int k = 0; k < r->list[c].entries; k++)
        {
            const struct dem_effect_entry *const entry = &r->list[c].entry[k];

            if (entry->effect->stage != DEM_STAGE_NORMAL || !entry->effect->contact_time
                || !(setting(entry, "impactSpeed") > 0.0))
            {
                continue;
            }
            const double overlap = overlap_of(entry, &r->list[c].pair, speed);

            if (!m->law || overlap > m->overlap)
            {
                *m = (struct dem_impact){.law = entry->effect,
                                         .pair = &r->list[c].pair,
                                         .impact_speed = setting(entry, "impactSpeed"),
                                         .stiffness = setting(entry, "stiffness"),
                                         .overlap = overlap};
            }
        }
    }
    m->factor = m->law ? pow(m->overlap/max_overlap, m->law->exponent + 1.0) : 0.0;
}

/* The material of the pair with the smaller modulus: it decides the stiffness. */
static const struct dem_material *softer(const struct dem_pair_class *pair)
{
    return pair->b->youngs_modulus < pair->a->youngs_modulus ? pair->b : pair->a;
}

/* "take impactSpeed 26 and materials/glass/youngsModulus 3.7e9 Pa for 5 %" */
static void advise(const struct dem_impact *m, double speed, double factor, struct dem_text *t)
{
    dem_text_add(t, "; take ");
    if (speed > margin*m->impact_speed)
    {
        dem_text_add(t, "effects/%s/impactSpeed %.3g and ", m->law->name, speed);
    }
    if (m->stiffness > 0.0)
    {
        dem_text_add(t, "effects/%s/stiffness %.3g", m->law->name, m->stiffness*factor);
    }
    else
    {
        const struct dem_material *const soft = softer(m->pair);

        dem_text_add(t, "materials/%s/youngsModulus %.3g Pa", soft->name,
                     soft->youngs_modulus*factor);
    }
    dem_text_add(t, " for overlaps of %g %%", 100.0*max_overlap);
}

int dem_impact_describe(const struct dem_impact *m, double speed, struct dem_text *t)
{
    const int faster = m->law && speed > margin*m->impact_speed;

    if (!m->law || m->overlap <= (faster ? margin*max_overlap : far_overlap))
    {
        return 0;
    }
    dem_text_add(t, "%.4g m/s%s", speed, faster ? " is above " : ": ");
    if (faster)
    {
        dem_text_add(t, "effects/%s/impactSpeed %g m/s, and ", m->law->name, m->impact_speed);
    }
    dem_text_add(t, "an impact at it overlaps by %.3g %% of a diameter%s", 100.0*m->overlap,
                 m->overlap > 0.5 ? ", so that particles pass through walls" : "");
    advise(m, speed, m->factor, t);
    return 1;
}

void dem_impact_describe_overlap(const struct dem_impact *m, double overlap, double speed,
                                 struct dem_text *t)
{
    dem_text_add(t, "contacts overlap by %.3g %% of a diameter, with particles of up to %.4g m/s",
                 100.0*overlap, speed);
    if (m->law)
    {
        advise(m, speed, pow(overlap/max_overlap, m->law->exponent + 1.0), t);
    }
}
