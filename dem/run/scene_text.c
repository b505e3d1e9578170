/*
 * scene_text.c -- a scene as text: effects, materials, contacts, walls, particles; streams and
 * outlets are in flows_text.c.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "run/scene_text.h"
#include "dem_numbers.h"
#include "core/vec.h"
#include "ranks/collect.h"
#include "records/inventory.h"
#include <fenv.h>
#include <math.h>
#include <string.h>

/* ---- effects ------------------------------------------------------------------------------------------------- */

static const double *numbers(const struct dem_setting *f, const void *settings)
{
    return (const double *)(const void *)((const char *)settings + f->offset);
}

static int choice(const struct dem_setting *f, const void *settings)
{
    return *(const int *)(const void *)((const char *)settings + f->offset);
}

static int is_default(const struct dem_setting *f, const void *settings)
{
    int same = 1;

    if (isnan(f->default_value))
    {
        return 0;
    }
    if (f->kind == DEM_SETTING_CHOICE || f->kind == DEM_SETTING_SWITCH)
    {
        return choice(f, settings) == (int)f->default_value;
    }
    for (int k = 0; k < (f->kind == DEM_SETTING_VECTOR ? 3 : 1); k++)
    {
        same &= numbers(f, settings)[k] == f->default_value;
    }
    return same;
}

static void write_value(struct dem_text *t, const struct dem_setting *f, const void *settings)
{
    const double *const v = numbers(f, settings);
    const char *const unit = strcmp(f->unit, "1") == 0 ? "" : f->unit;
    const char *const gap = unit[0] ? " " : "";

    switch (f->kind)
    {
    case DEM_SETTING_NUMBER:
        if (isnan(v[0]))
        {
            dem_text_add(t, "%s given in pairs", f->name);
            break;
        }
        dem_text_add(t, "%s %g%s%s", f->name, v[0], gap, unit);
        break;
    case DEM_SETTING_VECTOR:
        dem_text_add(t, "%s (%g %g %g)%s%s", f->name, v[0], v[1], v[2], gap, unit);
        break;
    case DEM_SETTING_CHOICE:
        dem_text_add(t, "%s %s", f->name, f->choices[choice(f, settings)]);
        break;
    default:
        dem_text_add(t, "%s %s", f->name, choice(f, settings) ? "yes" : "no");
    }
}

/* Largest coefficient of friction of a tangential law; -1 in a scene with rolling resistance. */
static double friction_alone(const struct dem_interaction_table *r)
{
    double largest = 0.0;

    for (int c = 0; c < r->classes; c++)
    {
        for (int k = 0; k < r->list[c].entries; k++)
        {
            const struct dem_effect_entry *const e = &r->list[c].entry[k];

            if (e->effect->stage == DEM_STAGE_MOMENT)
            {
                return -1.0;
            }
            largest = fmax(largest, e->effect->stage == DEM_STAGE_TANGENT
                                        ? dem_settings_number(e->effect->settings, e->settings, "friction")
                                        : 0.0);
        }
    }
    return largest;
}

/* Grains with such a friction are seldom round: beads have 0.1 to 0.3. */
static const double rough = 0.4;

static void write_rolling(struct dem_text *t, const struct dem *d, int64_t particles)
{
    const struct dem_interaction_table *const r = &d->state.interaction_table;
    const double friction = friction_alone(r);
    double g[3];

    dem_interaction_table_gravity(r, g);
    if (friction >= rough && dem_vec_norm(g) > 0.0 && d->state.walls.walls > 0 && particles > 1 &&
        d->scene.shapes.n == 0)
    {
        dem_text_add(t,
                     "    no rolling resistance at a friction of %g: spheres roll where the shape "
                     "of rough grains holds them, and slopes of heaps are too low; rollingSpring "
                     "holds them\n",
                     friction);
    }
}

static void write_effects(struct dem_text *t, const struct dem *d, int64_t particles)
{
    const struct dem_interaction_table *const r = &d->state.interaction_table;

    dem_text_add(t, "Effects\n");
    for (int k = 0; k < r->chosen; k++)
    {
        dem_text_add(t, "    %-18s %s\n", r->effect[k]->name, r->effect[k]->summary);
        for (const struct dem_setting *f = r->effect[k]->settings; f && f->name; f++)
        {
            dem_text_add(t, "%-23s", "");
            write_value(t, f, r->settings[k]);
            dem_text_add(t, "%s\n", is_default(f, r->settings[k]) ? ", default" : "");
        }
        if (r->effect[k]->limitation)
        {
            dem_text_add(t, "%-23slimitation: %s\n", "", r->effect[k]->limitation);
        }
    }
    if (r->chosen == 0)
    {
        dem_text_add(t, "    none\n");
    }
    write_rolling(t, d, particles);
}

/* ---- materials and contacts ---------------------------------------------------------------------------------- */

/* Settings that may differ between pairs: required numbers such as restitution and friction. */
static void write_required(struct dem_text *t, const struct dem_effect_entry *link)
{
    for (const struct dem_setting *f = link->effect->settings; f && f->name; f++)
    {
        if (f->kind == DEM_SETTING_NUMBER && isnan(f->default_value))
        {
            dem_text_add(t, ", ");
            if (link->effect->stage == DEM_STAGE_MOMENT)
            {
                dem_text_add(t, "%s ", link->effect->name);    /* rolling and sliding both have a friction */
            }
            write_value(t, f, link->settings);
        }
    }
}

static void write_contact(struct dem_text *t, const struct dem_effect_list *chain)
{
    const struct dem_pair_class *const pair = &chain->pair;
    char line[256];

    dem_text_add(t, "    %s and %s%s: ", pair->a->name, pair->with_wall ? "walls of " : "",
                 pair->b->name);
    if (chain->entries == 0)
    {
        dem_text_add(t, "nothing acts between them\n");
        return;
    }
    dem_text_add(t, "reduced modulus %.4g Pa", pair->reduced_modulus);
    for (int k = 0; k < chain->entries; k++)
    {
        const struct dem_effect_entry *const link = &chain->entry[k];

        if (link->effect->contact_time)
        {
            dem_text_add(t, ", contact time %.4g s",
                         link->effect->contact_time(link->settings, pair));
        }
        write_required(t, link);
        if (link->effect->describe_pair)
        {
            link->effect->describe_pair(link->settings, pair, line, sizeof line);
            dem_text_add(t, "%s", line);
        }
    }
    dem_text_add(t, "\n");
}

static void write_contacts(struct dem_text *t, const struct dem_interaction_table *r)
{
    dem_text_add(t, "Materials\n");
    for (int k = 0; k < r->materials; k++)
    {
        const struct dem_material *const m = &r->material[k];

        dem_text_add(t, "    %-18s density %g kg/m3, youngsModulus %g Pa, poissonsRatio %g",
                     m->name, m->density, m->youngs_modulus, m->poissons_ratio);
        dem_text_add(t, m->yield_strength > 0.0 ? ", yieldStrength %g Pa\n" : "\n",
                     m->yield_strength);
    }
    dem_text_add(t, "Contacts%s\n",
                 r->classes > 0 ? " (times: the smallest partners at impactSpeed)" : "");
    for (int c = 0; c < r->classes; c++)
    {
        write_contact(t, &r->list[c]);
    }
    if (r->classes == 0)
    {
        dem_text_add(t, "    none: no particles\n");
    }
}

/* ---- walls --------------------------------------------------------------------------------------------------- */

static void write_triangles(struct dem_text *t, const struct dem_walls *w, int wall)
{
    const struct dem_wall *const of = &w->wall[wall];
    dem_text_add(t, "    %-18s %zu triangles in %d flat facet%s", of->name, of->triangles, of->facets,
                 of->facets == 1 ? "" : "s");
    if (of->flat + of->repeats > 0)
    {
        dem_text_add(t, " (ignored: %zu without area, %zu duplicates)", of->flat, of->repeats);
    }
}

static void write_walls(struct dem_text *t, const struct dem_state *state)
{
    static const char *const shape[] = {"", "plane", "cylinder", "sphere"};
    static const char *const moves[] = {"", ", translates", ", turns", ", oscillates", "",
                                        ", moves"};
    const struct dem_walls *const w = &state->walls;

    dem_text_add(t, "Walls\n");
    for (int k = 0; k < w->walls; k++)
    {
        const struct dem_wall *const of = &w->wall[k];

        if (of->shape == DEM_SHAPE_TRIANGLES)
        {
            write_triangles(t, w, k);
        }
        else
        {
            dem_text_add(t, "    %-18s %s", of->name, shape[of->shape]);
        }
        dem_text_add(t, ", %s%s%s\n", state->interaction_table.material[of->material].name,
                     of->frame < 0          ? ""
                     : dem_walls_body(w, k) ? ", moved by force"
                                            : moves[w->frame[of->frame].motion.kind],
                     of->driven ? ", with a surface velocity" : "");
    }
    if (w->walls == 0)
    {
        dem_text_add(t, "    none\n");
    }
}

/* ---- particles ----------------------------------------------------------------------------------------------- */

static void write_inventory(struct dem_text *t, const char *name, int64_t n, const char *of,
                            const double d[3], double mass, double volume)
{
    dem_text_add(t, "    %-18s %lld%s%s, diameter ", name, (long long)n, of[0] ? " of " : "", of);
    if (d[0] == d[2])
    {
        dem_text_add(t, "%g m", d[0]);
    }
    else
    {
        dem_text_add(t, "%g to %g m, mean %.4g m", d[0], d[2], d[1]);
    }
    dem_text_add(t, ", %.4g kg, %.4g m3\n", mass, volume);
}

static void write_groups(struct dem_text *t, const struct dem *d)
{
    const struct dem_initial_particles *const c = &d->scene.initial;
    const struct dem_interaction_table *const r = &d->state.interaction_table;

    for (size_t k = 0; k < c->groups; k++)
    {
        const struct dem_group_summary *const g = &c->group[k];
        const double size[3] = {g->min_diameter, g->sum/(double)(g->n > 0 ? g->n : 1),
                                g->max_diameter};

        if (g->n > 0)
        {
            write_inventory(t, g->name, g->n,
                            g->material < 0 ? "several materials" : r->material[g->material].name,
                            size, g->mass, g->volume);
        }
    }
}

static void write_particles(struct dem_text *t, const struct dem *d, const struct dem_inventory *s)
{
    const struct dem_interaction_table *const r = &d->state.interaction_table;

    dem_text_add(t, "Particles\n");
    if (s->all.n == 0)
    {
        dem_text_add(t, "    none\n");
        return;
    }
    write_groups(t, d);
    for (int m = 0; m < r->materials && d->scene.initial.groups == 0; m++)
    {
        const struct dem_material_inventory *const k = &s->material[m];
        const double size[3] = {k->min_diameter, k->diameters/(double)(k->n > 0 ? k->n : 1),
                                k->max_diameter};

        if (k->n > 0)
        {
            write_inventory(t, "from the snapshot", k->n, r->material[m].name, size, k->mass,
                            k->volume);
        }
    }
    const double size[3] = {s->all.min_diameter, s->all.diameters/(double)s->all.n,
                            s->all.max_diameter};

    write_inventory(t, "together", s->all.n, "", size, s->all.mass, s->all.volume);
    if (s->all.frozen > 0)
    {
        dem_text_add(t, "    %-18s %lld of them\n", "frozen", (long long)s->all.frozen);
    }
}

int dem_scene_text(struct dem *d, const char **text)
{
    static _Thread_local struct dem_text t;
    struct dem_inventory inventory;
    fenv_t caller;

    dem_text_free(&t);
    feholdexcept(&caller);
    dem_inventory_take(&d->state, &inventory);
    write_effects(&t, d, inventory.all.n);
    write_contacts(&t, &d->state.interaction_table);
    write_walls(&t, &d->state);
    write_particles(&t, d, &inventory);
    dem_flows_text_add(&t, d);
    fesetenv(&caller);
    *text = t.text;
    return t.status ? t.status : dem_collect_status(&d->state.decomposition);
}
