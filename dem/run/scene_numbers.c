/*
 * scene_numbers.c -- numbers of a scene for advice: particles, room between walls, fluid, laws, cost.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "case/simulation.h"
#include "dem_numbers.h"
#include "dem_plan.h"
#include "core/vec.h"
#include "input/dictionary.h"
#include "ranks/collect.h"
#include "records/bed_packing.h"
#include "records/inventory.h"
#include "run/effect_numbers.h"
#include "step/run_cost.h"
#include <fenv.h>
#include <float.h>
#include <math.h>
#include <string.h>

static const double pi = 3.14159265358979323846;

/* ---- room between walls ---------------------------------------------------------------------- */

/* m: between planes that face each other along an axis, or periodic faces; 0 unknown */
static double width(const struct dem_state *s, int axis)
{
    double low = -INFINITY, high = INFINITY;

    if (s->domain.periodic[axis])
    {
        return s->domain.length[axis];
    }
    for (int k = 0; k < s->walls.walls; k++)
    {
        const struct dem_wall *const w = &s->walls.wall[k];
        const double along = w->shape == DEM_SHAPE_PLANE ? w->normal[axis] : 0.0;

        low = along == 1.0 ? fmax(low, w->point[axis]) : low;
        high = along == -1.0 ? fmin(high, w->point[axis]) : high;
    }
    return isfinite(high - low) && high > low ? high - low : 0.0;
}

/* 1 if the cross-section normal to an axis may vary because of this wall: it is neither a plane
   normal or parallel to the axis nor a cylinder around it. */
static int varies(const struct dem_wall *w, int axis)
{
    const double along = fabs(w->normal[axis]);

    return w->shape == DEM_SHAPE_PLANE ? along != 1.0 && along != 0.0
         : w->shape == DEM_SHAPE_CYLINDER ? w->outside || along != 1.0 : 1;
}

/* m2: constant cross-section normal to an axis: of the narrowest tube, between planes, or periodic;
   0 unknown */
static double section(const struct dem_walls *walls, const double widths[3], int axis)
{
    const double flat = widths[(axis + 1)%3]*widths[(axis + 2)%3];
    double least = flat > 0.0 ? flat : INFINITY;

    for (int k = 0; k < walls->walls; k++)
    {
        const struct dem_wall *const w = &walls->wall[k];

        if (varies(w, axis))
        {
            return 0.0;
        }
        least = w->shape == DEM_SHAPE_CYLINDER ? fmin(least, pi*w->radius*w->radius) : least;
    }
    return isfinite(least) ? least : 0.0;
}

static void set_room(const struct dem_state *s, struct dem_scene_numbers *n)
{
    double tube = INFINITY;

    for (int axis = 0; axis < 3; axis++)
    {
        n->width[axis] = width(s, axis);
        n->periodic[axis] = s->domain.periodic[axis];
    }
    for (int axis = 0; axis < 3; axis++)
    {
        n->section[axis] = section(&s->walls, n->width, axis);
    }
    for (int k = 0; k < s->walls.walls; k++)
    {
        const struct dem_wall *const w = &s->walls.wall[k];

        tube = w->shape == DEM_SHAPE_CYLINDER && !w->outside ? fmin(tube, 2.0*w->radius) : tube;
    }
    n->tube = isfinite(tube) ? tube : 0.0;
}

/* ---- particles, fluid, laws ------------------------------------------------------------------ */

static void set_particles(struct dem *d, const struct dem_inventory *inventory,
                          struct dem_scene_numbers *n)
{
    const struct dem_material_inventory *const all = &inventory->all;
    const struct dem_parcels_entry *const parcels = &d->state.interaction_table.parcels;

    n->particles = (double)all->n;
    n->min_diameter = all->n > 0 ? all->min_diameter : 0.0;
    n->max_diameter = all->max_diameter;
    n->squares = all->squares;
    n->volume = all->volume;
    n->mass = all->mass;
    n->moving_volume = all->moving_volume;
    n->moving_mass = all->moving_mass;
    n->grains = all->grains;
    n->grain_squares = all->grain_squares;
    n->min_parcel_ratio = parcels->used ? parcels->min : 0.0;
    n->max_parcel_ratio = parcels->used ? parcels->max : 0.0;
    n->max_speed = dem_totals_max_speed(&d->state);
    n->frozen = all->frozen > 0;
    n->wall_bodies = d->state.walls.bodies;
    n->driven = dem_totals_any_driven(&d->state);
    n->streams = d->scene.streams.streams;
}

static void set_fluid(const struct dem *d, const struct dem_inventory *inventory,
                      struct dem_scene_numbers *n)
{
    const struct dem_uniform_fluid *const given = &d->scene.fluid;

    n->uniform = given->given;
    n->coupled = d->coupled;
    n->fluid_density = given->given ? given->density : inventory->fluid_density;
    n->viscosity = given->given ? given->viscosity : inventory->fluid_viscosity;
    if (given->given)
    {
        n->fluid_speed = dem_vec_norm(given->velocity);
        n->vorticity = dem_vec_norm(given->vorticity);
        n->stress = dem_vec_norm(given->stress);
    }
}

/* The effect in use of a stage, NULL without one. */
static const struct dem_effect *effect_at(const struct dem_interaction_table *r,
                                          enum dem_stage stage)
{
    for (int k = 0; k < r->chosen; k++)
    {
        if (r->effect[k]->stage == stage)
        {
            return r->effect[k];
        }
    }
    return NULL;
}

/* A number of the effect of a stage; not a number without one, or if it has no such setting. */
static double number_at(const struct dem_interaction_table *r, enum dem_stage stage,
                        const char *entry)
{
    const struct dem_effect *const effect = effect_at(r, stage);
    const void *const settings = effect ? dem_effect_settings(r, effect) : NULL;

    return settings ? dem_settings_number(effect->settings, settings, entry) : NAN;
}

static double zero_or(double number)
{
    return isgreater(number, 0.0) ? number : 0.0;
}

static int is_adhesive(const struct dem_interaction_table *r)
{
    int adhesive = 0;

    for (int k = 0; r->classes > 0 && k < r->list[0].entries; k++)
    {
        const struct dem_effect_entry *const entry = &r->list[0].entry[k];

        adhesive |= entry->effect->adhesive && entry->effect->adhesive(entry->settings);
    }
    return adhesive;
}

static void set_laws(const struct dem_interaction_table *r, struct dem_scene_numbers *n)
{
    const struct dem_effect *const normal = effect_at(r, DEM_STAGE_NORMAL);
    double yield = INFINITY;

    for (int k = 0; k < r->chosen; k++)
    {
        n->drag_law = r->effect[k]->drag ? r->effect[k]->name : n->drag_law;
    }
    for (int m = 0; m < r->materials; m++)
    {
        yield = r->material[m].yield_strength > 0.0 ? fmin(yield, r->material[m].yield_strength)
                                                    : yield;
    }
    n->pressure_gradient = dem_interaction_table_has_pressure_gradient(r);
    n->modulus = r->classes > 0 ? r->list[0].pair.reduced_modulus : 0.0;
    n->exponent = normal ? normal->exponent : 0.0;
    n->impact_speed = zero_or(number_at(r, DEM_STAGE_NORMAL, "impactSpeed"));
    n->friction = zero_or(number_at(r, DEM_STAGE_TANGENT, "friction"));
    n->restitution = number_at(r, DEM_STAGE_DAMP, "restitution");
    n->damped = effect_at(r, DEM_STAGE_DAMP) != NULL;
    n->adhesive = is_adhesive(r);
    n->yield_strength = isfinite(yield) ? yield : 0.0;
    n->limit = r->step_limit < DBL_MAX ? r->step_limit : INFINITY;
    n->next_limit = r->next_limit < DBL_MAX ? r->next_limit : INFINITY;
    n->why = r->why;
    n->next_why = r->next_why;
}

int dem_scene_numbers(struct dem *d, struct dem_scene_numbers *n)
{
    struct dem_inventory inventory;

    *n = (struct dem_scene_numbers){.step = d->step};
    dem_inventory_take(&d->state, &inventory);
    (void)dem_interaction_table_gravity(&d->state.interaction_table, n->gravity);
    set_particles(d, &inventory, n);
    set_room(&d->state, n);
    set_fluid(d, &inventory, n);
    set_laws(&d->state.interaction_table, n);
    return dem_collect_status(&d->state.decomposition);
}

/* ---- single questions ------------------------------------------------------------------------ */

const char *dem_scene_note(const struct dem *d, int k)
{
    const char *const *repeats;
    const size_t n = dem_dict_repeats(d->dict, &repeats), at = (size_t)k;

    return k < 0 || at >= n + d->notes ? NULL : at < n ? repeats[at] : d->note[at - n];
}

int dem_scene_material(const struct dem *d, int k, struct dem_scene_material *m)
{
    const struct dem_interaction_table *const r = &d->state.interaction_table;

    if (k < 0 || k >= r->materials)
    {
        return 0;
    }
    *m = (struct dem_scene_material){.name = r->material[k].name,
                                     .density = r->material[k].density,
                                     .youngs_modulus = r->material[k].youngs_modulus,
                                     .present = r->max_radius[k] > 0.0};
    return 1;
}

int dem_stream_info(const struct dem *d, int k, struct dem_stream_info *info)
{
    const struct dem_streams *const all = &d->scene.streams;

    if (k < 0 || k >= all->streams)
    {
        return 0;
    }
    const struct dem_stream *const s = &all->stream[k];
    const struct dem_interaction_table *const r = &d->state.interaction_table;
    const double density = r->material[s->material].density,
                 sphere = cbrt(6.0/pi*dem_clump_source_volume(&s->clump, s->sizes.max)),
                 mass_rate = s->by_mass ? s->rate : s->rate*dem_stream_mean_mass(s, r);

    *info = (struct dem_stream_info){.name = s->name,
                                     .patch = s->inlet.patch,
                                     .by_mass = s->by_mass,
                                     .with_fluid = s->with_fluid,
                                     .rate = s->rate,
                                     .volume_rate = s->at_once ? 0.0 : mass_rate/density,
                                     .density = density,
                                     .min_diameter = s->clump.shape ? sphere : s->sizes.min/s->ratio,
                                     .max_diameter = s->clump.shape ? sphere : s->sizes.max/s->ratio};
    memcpy(info->velocity, s->velocity, sizeof info->velocity);
    memcpy(info->spread, s->spread, sizeof info->spread);
    return 1;
}

int dem_wall_has_law(const struct dem *d, int wall)
{
    const struct dem_walls *const w = &d->state.walls;

    return wall >= 0 && wall < w->walls
        && dem_interaction_table_wall_has_law(&d->state.interaction_table,
                                              w->wall[wall].frictionless ? DEM_PARTNER_FRICTIONLESS
                                                                         : DEM_PARTNER_WALL,
                                              w->wall[wall].material);
}

int dem_bed_slab(const struct dem *d, double up[3], double *low, double *high)
{
    struct dem_bed_packing bed;
    const int found = dem_bed_packing_measure(&d->state, &bed);

    memset(up, 0, 3*sizeof *up);
    *low = *high = 0.0;
    if (found)
    {
        memcpy(up, bed.up, sizeof bed.up);
        *low = bed.low;
        *high = bed.high;
    }
    return found;
}

double dem_bed_void_fraction(const struct dem *d, double area)
{
    struct dem_bed_packing bed;

    return area > 0.0 && dem_bed_packing_measure(&d->state, &bed) && bed.high > bed.low
             ? dem_bed_packing_void_fraction(&bed, area)
             : 0.0;
}

int dem_run_cost(struct dem *d, struct dem_run_cost *cost)
{
    struct dem_inventory inventory;
    fenv_t caller;

    feholdexcept(&caller);
    dem_inventory_take(&d->state, &inventory);
    const int status = dem_run_cost_measure(&d->state, &inventory, d->step, cost);

    fesetenv(&caller);
    return status ? status : dem_collect_status(&d->state.decomposition);
}
