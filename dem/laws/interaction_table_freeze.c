/*
 * interaction_table_freeze.c -- builds the effect list of each pair class from the chosen effects.
 *
 * 1. Give each effect its history columns; they are the same in all classes, so a contact row has
 *    one layout.
 * 2. For each pair of materials present, and each material with a wall: copy the settings, apply
 *    the pair's own, let each effect prepare itself. Frictionless walls have a class of their own
 *    without the effects along the wall and past touching.
 * 3. Collect the limit of the time step and the largest reach past touching.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "laws/interaction_table_internal.h"
#include "core/memory.h"
#include <float.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

int dem_effect_history_columns(const struct dem_effect *effect)
{
    int n = 0;

    while (effect->history && effect->history[n])
    {
        n++;
    }
    return n;
}

static double sphere_mass(double density, double radius)
{
    return density*4.0/3.0*3.14159265358979323846*radius*radius*radius;
}

/* Mass [kg] of the smallest particle of a material, for limits of the time step. */
static double min_mass(const struct dem_interaction_table *r, int m, double density)
{
    const double sphere = sphere_mass(density, r->min_radius[m]);

    return r->body_volume[m] > 0.0 ? fmin(sphere, density*r->body_volume[m]) : sphere;
}

/* Radius [m] of the sphere that bonds limit like the particles of a material. */
static double bond_radius(const struct dem_interaction_table *r, int m)
{
    return r->body_volume[m] > 0.0 ? fmin(r->min_radius[m], r->bond_radius) : r->min_radius[m];
}

static double reduced(int with_wall, double a, double b)
{
    return with_wall ? a : 1.0/(1.0/a + 1.0/b);
}

static struct dem_pair_class pair_class(const struct dem_interaction_table *r, int with_wall, int a,
                                        int b)
{
    const struct dem_material *const m = &r->material[a], *const o = &r->material[b];
    const double nm = m->poissons_ratio, no = o->poissons_ratio, Em = m->youngs_modulus,
                 Eo = o->youngs_modulus;
    const double Ra = r->min_radius[a], Rb = r->min_radius[b];
    struct dem_pair_class c = {
        .a = m, .b = o, .with_wall = with_wall, .fluid_density = r->fluid_density,
        .min_parcel_ratio = r->parcels.min, .max_parcel_ratio = r->parcels.max};
    int turned = 0;

    c.reduced_modulus = 1.0/((1.0 - nm*nm)/Em + (1.0 - no*no)/Eo);
    c.reduced_shear = 1.0/(2.0*(2.0 - nm)*(1.0 + nm)/Em + 2.0*(2.0 - no)*(1.0 + no)/Eo);
    c.min_radius = with_wall ? Ra : Ra*Rb/(Ra + Rb);
    c.max_radius_sum = r->max_radius[a] + (with_wall ? 0.0 : r->max_radius[b]);
    for (int k = 0; k < r->chosen; k++)
    {
        const struct dem_effect *const e = r->effect[k];

        c.inertia_has_added_mass |= e->has_added_mass;
        turned |= e->stage > DEM_STAGE_NORMAL && e->stage < DEM_STAGE_BODY &&
                  e->stage != DEM_STAGE_DAMP;
        c.added_density +=
            e->least_added_mass ? e->least_added_mass(r->settings[k])*r->fluid_density : 0.0;
    }
    /* no added mass resists turning: springs that turn particles set the step as without it */
    c.added_density = turned ? 0.0 : c.added_density;
    const double of_a = min_mass(r, a, m->density + c.added_density),
                 of_b = min_mass(r, b, o->density + c.added_density);

    c.min_mass = reduced(with_wall, of_a, of_b);
    const double bond_a = bond_radius(r, a), bond_b = bond_radius(r, b);

    /* as min_radius, to the last bit: bonds of spheres keep their step */
    c.bond_radius = with_wall ? bond_a : bond_a*bond_b/(bond_a + bond_b);
    c.bond_mass = reduced(with_wall, sphere_mass(m->density + c.added_density, bond_a),
                          sphere_mass(o->density + c.added_density, bond_b));
    return c;
}

/* A mean diameter is the parcels': with one ratio, l times the grains'. */
static int check_parcels(const struct dem_interaction_table *r, const struct dem_effect_entry *e)
{
    const struct dem_effect *const effect = e->effect;
    const unsigned extra = effect->extra_needs ? effect->extra_needs(e->settings) : 0;

    DEM_REQUIRE(effect->parcels != DEM_PARCELS_REFUSED, DEM_ERROR_INPUT,
                "%s has no rule for parcels (docs/parcels.md); leave it out of the effects, or "
                "leave out parcels", effect->name);
    DEM_REQUIRE(r->parcels.min == r->parcels.max ||
                    !((effect->needs | extra) & DEM_NEEDS_MEAN_DIAMETER),
                DEM_ERROR_INPUT,
                "%s needs the mean diameter of the grains, which is not known with parcels of "
                "ratios from %g to %g; give all the same parcelRatio, or choose another setting",
                effect->name, r->parcels.min, r->parcels.max);
    return DEM_OK;
}

int dem_effect_prepare(const struct dem_effect *e, void *settings, const struct dem_pair_class *pair)
{
    DEM_REQUIRE(e->stage == DEM_STAGE_NORMAL || e->stage > DEM_STAGE_MOMENT || pair->exponent > 0.0,
                DEM_ERROR_INPUT,
                "%s between %s and %s: there is no normal law; add one to the effects, hertz for "
                "example", e->name, pair->a->name, pair->b->name);
    return e->prepare ? e->prepare(settings, pair) : DEM_OK;
}

static int append_effect(struct dem_interaction_table *r, struct dem_effect_list *list, int index,
                         int first_column, int a, int b)
{
    const struct dem_effect *const effect = r->effect[index];
    struct dem_effect_entry *const entry = &list->entry[list->entries];
    const int contact = effect->stage < DEM_STAGE_BODY;

    DEM_TRY(dem_memory_new(&entry->settings, 1, effect->size + 1));
    entry->effect = effect;
    entry->first_column = first_column;
    list->entries++;
    memcpy(entry->settings, r->settings[index], effect->size);
    for (int k = 0; contact && k < r->overrides; k++)
    {
        const struct dem_override *const o = &r->override[k];
        const int applies =
            (o->pair[0] == a && o->pair[1] == b) || (o->pair[0] == b && o->pair[1] == a);

        if (o->effect == effect && applies)
        {
            DEM_TRY(dem_override_apply(o, entry->settings));
        }
    }
    const int status =
        dem_settings_check_complete(effect->settings, entry->settings, effect->name);

    if (status && contact)
    {
        const char *const x = list->pair.a->name, *const y = list->pair.b->name;

        return dem_error_prefix(
            status, "contact %s-%s, by effects or by pairs between (%s %s): ", x, y, x, y);
    }
    DEM_TRY(status);
    DEM_TRY(r->parcels.used ? check_parcels(r, entry) : DEM_OK);
    entry->grains = r->parcels.used && effect->parcels == DEM_PARCELS_GRAINS;
    list->grains |= entry->grains;
    list->parcel_scalar = r->parcels.scalar;
    list->pair.exponent =
        effect->stage == DEM_STAGE_NORMAL ? effect->exponent : list->pair.exponent;
    for (int k = 0; effect->scalars && effect->scalars[k]; k++)
    {
        entry->scalar[entry->scalars++] =
            dem_interaction_table_find_scalar(r, effect->scalars[k]->name);
        list->scalars = 1;
    }
    list->needs |= effect->needs;
    list->moments |= effect->stage == DEM_STAGE_MOMENT || effect->stage == DEM_STAGE_BOND;
    list->past_touching |= contact && dem_effect_acts_past_touching(effect);
    return dem_effect_prepare(effect, entry->settings, contact ? &list->pair : NULL);
}

void dem_interaction_table_limit_step(struct dem_interaction_table *r, double limit,
                                      const char *why, const char *suffix)
{
    if (limit < r->step_limit)
    {
        r->next_limit = r->step_limit;
        memcpy(r->next_why, r->why, sizeof r->why);
        r->step_limit = limit;
        snprintf(r->why, sizeof r->why, "%s%s", why, suffix);
    }
    else if (limit < r->next_limit)
    {
        r->next_limit = limit;
        snprintf(r->next_why, sizeof r->next_why, "%s%s", why, suffix);
    }
}

/* Limit of the time step and reach of one entry. */
static void collect_limits(struct dem_interaction_table *r, const struct dem_effect_list *list,
                           const struct dem_effect_entry *entry)
{
    const char *why = entry->effect->name, *const suffix =
                                               list->pair.with_wall ? ", at a wall" : "";
    const double reach =
        entry->effect->reach ? entry->effect->reach(entry->settings, &list->pair) : 0.0;
    const int limits = entry->effect->time_limit && (entry->scalars > 0 || !r->motionless);
    const double limit = limits
                             ? entry->effect->time_limit(entry->settings, &list->pair, &why)
                             : DBL_MAX;

    r->reach = reach > r->reach ? reach : r->reach;
    dem_interaction_table_limit_step(r, limit, why, suffix);
}

/* Select the fused kernel of a list. */
static void select_kernel(struct dem_effect_list *list)
{
    const struct dem_effect *effect[DEM_EFFECT_LIST_LIMIT];

    for (int k = 0; k < list->entries; k++)
    {
        effect[k] = list->entry[k].effect;
    }
    list->kernel = dem_fused_find(effect, list->entries, &list->fused);
}

/* 1 when a frictionless wall has no effect of this stage. */
static int is_left_out(enum dem_stage stage)
{
    return stage == DEM_STAGE_TANGENT || stage == DEM_STAGE_MOMENT || stage == DEM_STAGE_BOND
        || stage == DEM_STAGE_FILM;
}

static int build_list(struct dem_interaction_table *r, struct dem_effect_list *list,
                      enum dem_partner partner, int a, int b, const int *first_column)
{
    const int bodies = list == &r->bodies;

    for (int k = 0; k < r->chosen; k++)
    {
        const enum dem_stage stage = r->effect[k]->stage;

        if (bodies == (stage >= DEM_STAGE_BODY)
            && !(partner == DEM_PARTNER_FRICTIONLESS && is_left_out(stage)))
        {
            DEM_TRY(append_effect(r, list, k, first_column[k], a, b));
            collect_limits(r, list, &list->entry[list->entries - 1]);
        }
    }
    select_kernel(list);
    r->needs |= list->needs;
    r->moments |= list->moments;
    r->past_touching |= list->past_touching;
    r->contact_scalars |= !bodies && list->scalars;
    return DEM_OK;
}

static int add_class(struct dem_interaction_table *r, enum dem_partner partner, int a, int b,
                     const int *first_column)
{
    struct dem_effect_list *const list = &r->list[r->classes];

    list->pair = pair_class(r, partner != DEM_PARTNER_PARTICLE, a, b);
    r->class_of[partner][a][b] = r->classes;
    if (partner == DEM_PARTNER_PARTICLE)
    {
        r->class_of[partner][b][a] = r->classes;
    }
    r->classes++;
    return build_list(r, list, partner, a, b, first_column);
}

static int add_wall_classes(struct dem_interaction_table *r, enum dem_partner partner,
                            const int materials[DEM_MATERIALS], const int *first_column)
{
    for (int a = 0; a < r->materials; a++)
    {
        for (int b = 0; b < r->materials; b++)
        {
            if (r->min_radius[a] > 0.0 && materials[b])
            {
                DEM_TRY(add_class(r, partner, a, b, first_column));
            }
        }
    }
    return DEM_OK;
}

static int assign_history_columns(struct dem_interaction_table *r, int *first_column)
{
    for (int k = 0; k < r->chosen; k++)
    {
        const int n = dem_effect_history_columns(r->effect[k]);

        DEM_REQUIRE(
            r->history_columns + n <= DEM_HISTORY_COLUMNS, DEM_ERROR_INPUT,
            "the chosen effects need more than %d history columns per contact; choose fewer effects",
            DEM_HISTORY_COLUMNS);
        first_column[k] = r->history_columns;
        for (int m = 0; m < n; m++)
        {
            r->history_name[r->history_columns++] = r->effect[k]->history[m];
        }
    }
    return DEM_OK;
}

static int set_capacities(struct dem_interaction_table *r)
{
    for (int k = 0; k < r->scalars; k++)
    {
        const struct dem_scalar *const s = r->scalar[k];

        for (int m = 0; m < r->materials && s->capacity; m++)
        {
            r->capacity[k][m] = s->capacity(&r->material[m]);
            DEM_REQUIRE(r->capacity[k][m] > 0.0 || r->min_radius[m] <= 0.0, DEM_ERROR_INPUT,
                        "materials/%s has no %s above 0, which particles with %s need; give it",
                        r->material[m].name, s->capacity_entry, s->name);
        }
    }
    return DEM_OK;
}

int dem_interaction_table_freeze(struct dem_interaction_table *r,
                                 int walls[DEM_PARTNERS][DEM_MATERIALS])
{
    int first_column[DEM_EFFECT_LIST_LIMIT];

    DEM_TRY(assign_history_columns(r, first_column));
    DEM_TRY(set_capacities(r));
    DEM_TRY(DEM_NEW(r->list, DEM_PARTNERS*r->materials*r->materials + 1));
    memset(r->class_of, -1, sizeof r->class_of);
    r->step_limit = r->next_limit = DBL_MAX;
    snprintf(r->why, sizeof r->why, "no effect bounds it");
    for (int a = 0; a < r->materials; a++)
    {
        for (int b = a; b < r->materials; b++)
        {
            if (r->min_radius[a] > 0.0 && r->min_radius[b] > 0.0)
            {
                DEM_TRY(add_class(r, DEM_PARTNER_PARTICLE, a, b, first_column));
            }
        }
    }
    for (enum dem_partner k = DEM_PARTNER_WALL; k < DEM_PARTNERS; k++)
    {
        DEM_TRY(add_wall_classes(r, k, walls[k], first_column));
    }
    return build_list(r, &r->bodies, DEM_PARTNER_PARTICLE, -1, -1, first_column);
}

int dem_interaction_table_share(const struct dem_interaction_table *r,
                                struct dem_interaction_table *to)
{
    *to = *r;
    to->list = NULL;
    DEM_TRY(DEM_NEW(to->list, r->classes + 1));
    memcpy(to->list, r->list, (size_t)r->classes*sizeof *to->list);
    for (int c = 0; c < r->classes; c++)
    {
        to->list[c].pair.a = to->material + (r->list[c].pair.a - r->material);
        to->list[c].pair.b = to->material + (r->list[c].pair.b - r->material);
    }
    return DEM_OK;
}

void dem_interaction_table_unshare(struct dem_interaction_table *r)
{
    dem_memory_free(r->list);
    memset(r, 0, sizeof *r);
}
