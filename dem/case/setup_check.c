/*
 * setup_check.c -- check a scene before its particles are placed, which may take long.
 *
 * Unknown entries, effects that lack a setting, walls without an area, a time step that is too
 * long, groups outside the domain. The radii follow from the scene; with them the interaction table
 * is frozen and the walls are finished. A snapshot brings its own radii: then both wait until it
 * has been read (setup.c).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "case/dem_case.h"
#include "core/error.h"
#include "walls/wall_periods.h"
#include <float.h>
#include <math.h>

/* The first wall with a reference frame; all walls when none has it. */
static int wall_with_frame(const struct dem_walls *w, int frame)
{
    int wall = 0;

    while (wall < w->walls && w->wall[wall].frame != frame)
    {
        wall++;
    }
    return wall;
}

/* Rows that the step of the contacts, or a shorter one of the scene, does not resolve. */
static int check_rows(const struct dem *d)
{
    const struct dem_interaction_table *const r = &d->state.interaction_table;
    const struct dem_walls *const w = &d->state.walls;
    const double step = d->scene.step > 0.0 ? fmin(d->scene.step, r->step_limit) : r->step_limit;
    double time[2];

    for (int k = 0; k < w->frames && !r->motionless && step < DBL_MAX; k++)
    {
        const int wall = wall_with_frame(w, k);

        DEM_REQUIRE(wall == w->walls || !w->frame[k].compound
                        || !dem_compound_motion_dense_rows(w->frame[k].compound, step, time), DEM_ERROR_INPUT,
                    "wall %s: the rows of %.9g and %.9g s of its motion are nearer than 4 steps of %.3g s (%s); "
                    "give fewer rows, or a shorter time/step", w->wall[wall].name, time[0], time[1], step,
                    d->scene.step > 0.0 && step < r->step_limit ? "time/step" : r->why);
    }
    return DEM_OK;
}

/* The step resolves oscillations and rotations of walls. */
static void limit_step_by_walls(struct dem_interaction_table *r, const struct dem_walls *w)
{
    const char *why = "";

    for (int k = 0; k < w->frames && !r->motionless; k++)
    {
        const double limit = w->frame[k].compound
                                 ? dem_compound_motion_time_limit(w->frame[k].compound, &why)
                                 : dem_motion_time_limit(&w->frame[k].motion, &why);
        const int wall = wall_with_frame(w, k);

        if (wall < w->walls)
        {
            dem_interaction_table_limit_step(r, limit, why, w->wall[wall].name);
        }
    }
}

/* Refuse a wall that moves by more than the smallest radius in a step. */
static int check_wall_speeds(const struct dem *d, double radius)
{
    const struct dem_walls *const w = &d->state.walls;

    for (int k = 0; k < w->frames; k++)
    {
        const int wall = wall_with_frame(w, k);

        if (!w->frame[k].compound || wall == w->walls || !isfinite(radius))
        {
            continue;
        }
        const struct dem_wall *const of = &w->wall[wall];
        const double point[2][3] = {{of->point[0], of->point[1], of->point[2]},
                                    {of->point[0], of->point[1], of->point[2]}};
        const double speed = dem_compound_motion_speed(
            w->frame[k].compound, w->frame[k].triangles ? (const double (*)[3])w->frame[k].box : point);

        DEM_REQUIRE(speed*d->step <= radius, DEM_ERROR_INPUT,
                    "wall %s: its motion reaches %.3g m/s, %.3g m in a step of %.3g s; the limit is "
                    "%.3g m, the radius of the smallest particle; use a time/step of at most %.3g s, "
                    "or a slower motion",
                    of->name, speed, speed*d->step, d->step, radius, radius/speed);
    }
    return DEM_OK;
}

static int choose_step(struct dem *d)
{
    struct dem_interaction_table *const r = &d->state.interaction_table;

    if (dem_sim_max_radius(d) == 0.0 && d->scene.step == 0.0 && d->state.steps > 0)
    {
        /* a restart after all particles have left */
        dem_interaction_table_limit_step(r, d->state.time/(double)d->state.steps, "mean step of the snapshot", "");
    }
    d->step = d->state.max_dt = d->scene.step > 0.0 ? d->scene.step : r->step_limit;
    DEM_REQUIRE(d->scene.step <= r->step_limit || d->scene.force, DEM_ERROR_INPUT,
                "time step %g s exceeds %.3g s (%s); use at most that, a softer material, or "
                "time/force yes",
                d->scene.step, r->step_limit, r->why);
    DEM_REQUIRE(d->step > DBL_MIN, DEM_ERROR_INPUT, "the time step is %g s (%s); check the "
                "materials, diameters and settings: one of them is unrealistic", d->step,
                d->scene.step > 0.0 ? "time/step" : r->why);
    DEM_REQUIRE(d->step < DBL_MAX || dem_sim_max_radius(d) > 0.0, DEM_ERROR_INPUT,
                "the scene has no particles, so no effect bounds the time step; give a group in insert (in Python "
                "add_particles before the start, or allow_diameters for those that come later), or time/step");
    DEM_REQUIRE(d->step < DBL_MAX, DEM_ERROR_INPUT,
                "no effect bounds the time step; give time/step");
    return DEM_OK;
}

/* Positions along a periodic axis are multiples of its unit of length. A unit of 1e-6 radii is a
   hundredth of an overlap of 1e-4 radii, a small one. */
static const double coarsest_unit = 1e-6;

static double min_radius(const struct dem *d)
{
    double min = INFINITY;

    for (int m = 0; m < DEM_MATERIALS; m++)
    {
        const double radius = d->state.interaction_table.min_radius[m];

        min = radius > 0.0 ? fmin(min, radius) : min;
    }
    return min;
}

/* In a periodic domain that is too narrow a particle touches its own image (contacts/pairs.c
   refuses it in a snapshot); in one that is too wide, overlaps are lost in rounding. */
static int check_periodic_widths(const struct dem *d, double radius)
{
    const struct dem_domain *const box = &d->state.domain;
    const double least = min_radius(d);
    const double min = 2.0*radius*(1.0 + d->scene.outer_skin) + d->state.interaction_table.reach;

    for (int k = 0; k < 3; k++)
    {
        DEM_REQUIRE(!box->periodic[k] || box->length[k] >= min, DEM_ERROR_INPUT,
                    "domain: periodic along %c and %g m wide, so that a particle of %g m reaches "
                    "its own periodic image; make the domain at least %g m wide, a diameter, the "
                    "outer skin and the reach of films and bonds",
                    "xyz"[k], box->length[k], 2.0*radius, min);
        DEM_REQUIRE(!box->periodic[k] || box->unit[k] <= coarsest_unit*least, DEM_ERROR_INPUT,
                    "domain: periodic along %c from %g to %g m, where positions are multiples of "
                    "%.3g m; the limit is %.3g m, %g of the smallest radius, or overlaps are lost "
                    "in rounding; make the domain smaller, or move it to the origin",
                    "xyz"[k], box->min[k], box->max[k], box->unit[k], coarsest_unit*least,
                    coarsest_unit);
    }
    return DEM_OK;
}

/* How far from a wall a particle can be that is compared with it: skins that are tuned are at most a
   diameter. */
static double wall_reach(const struct dem *d, double radius)
{
    const double skin = d->scene.tuned_skins ? 1.0 : fmax(1.0, d->scene.outer_skin);

    return radius + 2.0*radius*skin + d->state.interaction_table.reach;
}

/* The scene's own fluid is one. */
static int check_interface(const struct dem *d)
{
    DEM_REQUIRE(!d->scene.fluid.given ||
                    !(dem_interaction_table_needs(&d->state.interaction_table) & DEM_NEEDS_INTERFACE),
                DEM_ERROR_INPUT,
                "the scene has one fluid, but an effect acts at the interface of two; take that effect out, or run "
                "the case in demInterFoam");
    return DEM_OK;
}

int dem_sim_finish_physics(struct dem *d)
{
    struct dem_state *const state = &d->state;
    int made_of[DEM_PARTNERS][DEM_MATERIALS] = {{0}};
    const double radius = dem_sim_max_radius(d);

    for (int w = 0; w < state->walls.walls; w++)
    {
        const struct dem_wall *const wall = &state->walls.wall[w];

        made_of[DEM_PARTNER_WALL + wall->frictionless][wall->material] = 1;
    }
    int status = dem_interaction_table_freeze(&state->interaction_table, made_of);

    status = status ? status : check_rows(d);
    status = status ? status : check_interface(d);
    if (!status)
    {
        limit_step_by_walls(&state->interaction_table, &state->walls);
    }
    status = status ? status : choose_step(d);
    status = status ? status : check_periodic_widths(d, radius);
    dem_stages_limit_motions(d);
    dem_domain_make_walls_periodic(&state->domain, wall_reach(d, radius), &state->walls);
    status = status ? status : dem_walls_finish(&state->walls, radius > 0.0 ? radius : 1.0);
    status = status ? status : dem_domain_check_walls(&state->domain, &state->walls, radius);
    DEM_TRY(dem_wall_store_finish(&state->wall_store, status, &state->walls));
    return check_wall_speeds(d, min_radius(d));
}

/* Diameters that the program may add later. */
static int add_allowed(const struct dem_case *c)
{
    struct dem_interaction_table *const r = &c->d->state.interaction_table;
    int m;

    for (size_t k = 0; k < c->alloweds; k++)
    {
        const struct dem_allowed_diameters *const a = &c->allowed[k];

        DEM_TRY(dem_interaction_table_find_material(r, a->material, "dem_case_allow_diameters", &m));
        r->min_radius[m] = r->min_radius[m] > 0.0 ? fmin(r->min_radius[m], 0.5*a->min) : 0.5*a->min;
        r->max_radius[m] = fmax(r->max_radius[m], 0.5*a->max);
    }
    return DEM_OK;
}

/* Radii by material and ratios of parcels, of particles that the scene inserts and of those that the program added. */
int dem_sim_add_radii(struct dem_case *c)
{
    struct dem *const d = c->d;
    struct dem_interaction_table *const r = &d->state.interaction_table;
    int m;

    dem_insert_radii(&d->scene.insertion, r->min_radius, r->max_radius, r->body_volume);
    dem_streams_radii(&d->scene.streams, r->min_radius, r->max_radius, r->body_volume);
    for (size_t k = 0; k < c->initial.n; k++)
    {
        const double radius = c->initial.particle[k].radius;

        DEM_TRY(dem_interaction_table_find_material(r, c->initial_material[k],
                                                    "dem_case_add_particles", &m));
        r->min_radius[m] = r->min_radius[m] > 0.0 ? fmin(r->min_radius[m], radius) : radius;
        r->max_radius[m] = fmax(r->max_radius[m], radius);
        if (r->parcels.used)
        {
            dem_interaction_table_add_parcel(r, r->parcels.ratio);
        }
    }
    dem_insert_ratios(&d->scene.insertion, r);
    dem_streams_ratios(&d->scene.streams, r);
    return add_allowed(c);
}

/* Without particles of the program all ids are known from the scene. */
static int check_bonds(const struct dem_case *c)
{
    const struct dem *const d = c->d;
    const int64_t *const id = d->scene.bond_ids, n = dem_insert_next_id(&d->scene.insertion);

    for (size_t k = 0; k + 1 < d->scene.bond_id_count && c->initial.n == 0; k += 2)
    {
        DEM_REQUIRE(id[k] < n && id[k + 1] < n, DEM_ERROR_INPUT,
                    "bonds/pairs: %lld and %lld, but the scene has ids below %lld only; correct "
                    "the list",
                    (long long)id[k], (long long)id[k + 1], (long long)n);
    }
    return DEM_OK;
}

/* An entry `coupling` is for a coupled run: it is compared at a restart, but not read. */
static int accept_coupling(const struct dem_dict *scene)
{
    const struct dem_dict *coupling;

    DEM_TRY(dem_dict_sub_if(scene, "coupling", &coupling));
    if (coupling)
    {
        dem_dict_mark_read(coupling);
    }
    return DEM_OK;
}

int dem_sim_check_scene(struct dem_case *c)
{
    struct dem *const d = c->d;

    DEM_TRY(accept_coupling(d->dict));
    DEM_TRY(dem_dict_refuse_unread(d->dict));
    DEM_TRY(dem_sim_check_clumps(c));
    DEM_TRY(dem_streams_check(&d->scene.streams, &d->state.domain));
    if (c->load_path[0])
    {
        return DEM_OK;
    }
    DEM_TRY(check_bonds(c));
    DEM_TRY(dem_insert_check_domain(&d->scene.insertion, &d->state.domain));
    return dem_sim_add_radii(c);
}
