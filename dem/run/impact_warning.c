/*
 * impact_warning.c -- largest overlap of an impact at a speed, and the stiffness that it needs.
 *
 * Largest overlap d of an impact at v, with the contact time t_c at impactSpeed v_0 and the exponent p
 * of the normal law (F ~ d^p):
 *
 *   d = v_0 t_c/c (v/v_0)^(2/(p + 1)),   c = 2.943 for p = 3/2 (Hertz), pi for p = 1
 *
 * so that the stiffness for an overlap of d_1 is (d/d_1)^(p + 1) times the present one.
 *
 * Source: Johnson, Contact Mechanics (1985), section 11.4.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "case/simulation.h"
#include "dem_numbers.h"
#include "dem_plan.h"
#include "core/vec.h"
#include "ranks/collect.h"
#include <fenv.h>
#include <math.h>

/* of a diameter; above it contacts are too soft: forces, packings and times of contact change */
static const double max_overlap = 0.05;

static const double far_overlap = 0.2;         /* reported also below impactSpeed */
static const double too_soft = 1.0;            /* reported at impactSpeed, though nothing moves yet */
static const double margin = 1.01;             /* of numbers that were printed with three digits */
static const double reported = 0.1;            /* of a diameter: reported during the run */

struct impact    /* an impact at a speed, of the pair class in which it overlaps most */
{
    const struct dem_effect *law;        /* NULL: no normal law has a contact time */
    const struct dem_pair_class *pair;
    double impact_speed;                 /* m/s  setting */
    double stiffness;                    /* its setting `stiffness`; 0: from the materials */
    double overlap;                      /* 1  of the smaller diameter */
    double factor;                       /* 1  on the stiffness, for 5 % */
};

static double setting(const struct dem_effect_entry *entry, const char *name)
{
    return dem_settings_number(entry->effect->settings, entry->settings, name);
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

/* speed < 0: each law at its impactSpeed */
static void impact_at(const struct dem_interaction_table *r, double speed, struct impact *m)
{
    *m = (struct impact){.law = NULL};
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
            const double at = speed < 0.0 ? setting(entry, "impactSpeed") : speed;
            const double overlap = overlap_of(entry, &r->list[c].pair, at);

            if (!m->law || overlap > m->overlap)
            {
                *m = (struct impact){.law = entry->effect,
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
static void advise(const struct impact *m, double speed, double factor, struct dem_text *t)
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

/* 1 if it overlaps too much. Then the text gets the end of a sentence: overlap, and what to take. */
static int describe(const struct impact *m, double speed, struct dem_text *t)
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

/* The sentence on an overlap [1] that was measured, while the fastest particle has this speed. */
static void describe_overlap(const struct impact *m, double overlap, double speed,
                             struct dem_text *t)
{
    dem_text_add(t, "contacts overlap by %.3g %% of a diameter, with particles of up to %.4g m/s",
                 100.0*overlap, speed);
    if (m->law)
    {
        advise(m, speed, pow(overlap/max_overlap, m->law->exponent + 1.0), t);
    }
}

int dem_impact_warning(struct dem *d, double overlap, const char **text)
{
    struct impact impact;
    fenv_t caller;

    dem_text_free(&d->impact);
    feholdexcept(&caller);
    const double speed = dem_totals_max_speed(&d->state);

    impact_at(&d->state.interaction_table, speed, &impact);
    if (overlap > reported && overlap > 1.5*d->said_overlap)
    {
        d->said_overlap = overlap;
        describe_overlap(&impact, overlap, speed, &d->impact);
    }
    else if (speed > 1.5*d->said_speed && describe(&impact, speed, &d->impact))
    {
        d->said_speed = speed;
    }
    fesetenv(&caller);
    *text = d->impact.text ? d->impact.text : "";
    return d->impact.status ? d->impact.status : dem_collect_status(&d->state.decomposition);
}

/* ---- before the run -------------------------------------------------------------------------- */

static double stream_speed(const struct dem_stream *s, double fluid)
{
    double v[3];

    for (int k = 0; k < 3; k++)
    {
        v[k] = fabs(s->velocity[k]) + s->spread[k];
    }
    return s->with_fluid ? fluid : dem_vec_norm(v);
}

static void add_line(const struct dem *d, const char *what, const char *name, double speed,
                     struct dem_text *t)
{
    struct impact impact;
    struct dem_text end = {.text = NULL};

    impact_at(&d->state.interaction_table, speed, &impact);
    if (speed > 0.0 && describe(&impact, speed, &end) && end.text)
    {
        dem_text_add(t, "%s%s: %s\n", what, name, end.text);
    }
    dem_text_free(&end);
}

/* In a scene that begins at rest no speed shows a modulus that was given in GPa: take impactSpeed. */
static void add_at_impact_speed(const struct dem *d, struct dem_text *t)
{
    struct impact m;

    impact_at(&d->state.interaction_table, -1.0, &m);
    if (m.law && m.overlap > too_soft)
    {
        dem_text_add(t, "effects/%s/impactSpeed is ", m.law->name);
        (void)describe(&m, m.impact_speed, t);
        dem_text_add(t, ", or a lower impactSpeed if nothing moves as fast\n");
    }
}

static int has_drag(const struct dem_interaction_table *r)
{
    int drag = 0;

    for (int k = 0; k < r->chosen; k++)
    {
        drag |= r->effect[k]->drag != DEM_DRAG_NONE;
    }
    return drag;
}

int dem_impact_text(struct dem *d, double fluid_speed, const char **text)
{
    static _Thread_local struct dem_text t;
    const struct dem_walls *const walls = &d->state.walls;
    const struct dem_streams *const s = &d->scene.streams;
    int fastest = 0;

    dem_text_free(&t);
    add_line(d, "the fastest particle", "", dem_totals_max_speed(&d->state), &t);
    for (int k = 0; k < walls->walls; k++)
    {
        fastest = walls->wall[k].push > walls->wall[fastest].push ? k : fastest;
    }
    if (walls->walls > 0)
    {
        add_line(d, "walls/", walls->wall[fastest].name, walls->wall[fastest].push, &t);
    }
    for (int k = 0; k < s->streams; k++)
    {
        add_line(d, "insert/", s->stream[k].name, stream_speed(&s->stream[k], fluid_speed), &t);
    }
    if (has_drag(&d->state.interaction_table))
    {
        add_line(d, "the fluid", "", fluid_speed, &t);
    }
    if (!t.text)
    {
        add_at_impact_speed(d, &t);
    }
    *text = t.text ? t.text : "";
    return t.status ? t.status : dem_collect_status(&d->state.decomposition);
}
