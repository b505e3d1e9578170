/*
 * flows_positions.c -- find free positions for the particles of streams.
 *
 * 1. Gather the spheres near the inlet from all ranks, with their periodic images, into a grid of
 * cells, and the triangles of walls.
 * 2. For each particle due, in order of its number: random trials, the same on each rank, until one
 * is clear of spheres and walls.
 * 3. Stop at the first particle without a free position; it waits, and the following ones with it.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "sources/flows.h"
#include "sources/inlet_grid.h"
#include "core/error.h"
#include "core/memory.h"
#include "core/vec.h"
#include "walls/wall_path.h"
#include "ranks/dem_state.h"
#include <math.h>
#include <string.h>

enum
{
    TRIALS = 200    /* positions for one particle at one check */
};

/* The amount due is a floating-point number: a particle is due when at most this fraction of it is
   missing. */
static const double tolerance = 1e-9;

/* Walls within this fraction of the radius of the inlet are taken to lie on it. */
static const double on_inlet = 1e-3;

/* ---- a stream -------------------------------------------------------------------------------- */

/* 1 when the next particle, of this mass, is within the limits of the stream. */
static int is_within(const struct dem_stream *s, const struct dem_snapshot_flow *f, double mass)
{
    return f->count < s->count && !(f->mass + 0.5*mass > s->mass);
}

/* 1 when it is due, too. */
static int is_due(const struct dem_stream *s, const struct dem_snapshot_flow *f, double due,
                  double mass)
{
    return is_within(s, f, mass) &&
           (s->by_mass ? due + tolerance*mass >= mass : due + tolerance >= 1.0);
}

/* kg  of the next particle */
static double next_mass(const struct dem_state *state, int k)
{
    const struct dem_stream *const s = &state->flows->plan->stream[k];

    return dem_stream_mass(s, &state->interaction_table, state->flows->flow[k].count);
}

int dem_flows_insert_by(const struct dem_state *state, double begun)
{
    const struct dem_streams *const plan = state->flows->plan;
    int any = 0;

    for (int k = 0; k < plan->streams; k++)
    {
        const struct dem_stream *const s = &plan->stream[k];

        any |= s->start <= begun && is_within(s, &state->flows->flow[k], next_mass(state, k))
            && (s->at_once || state->time < s->end);
    }
    return any;
}

/* particles or kg  due now and not yet inserted */
static double amount_owed(const struct dem_state *state, int k)
{
    const struct dem_stream *const s = &state->flows->plan->stream[k];
    const struct dem_snapshot_flow *const row = &state->flows->flow[k];

    return row->owed + dem_stream_amount_due(s, row->since, state->time) -
           (s->by_mass ? row->mass : (double)row->count);
}

/* 1 in `clear` when the particle overlaps no sphere and no wall and lies in the domain; then it is
   wrapped. */
static int test_position(struct dem_state *state, const struct dem_inlet_grid *grid,
                         struct dem_particle *q, int *clear)
{
    *clear = 0;
    if (!dem_domain_project(&state->domain, q) || !dem_inlet_grid_is_clear(grid, q->x, q->radius))
    {
        return DEM_OK;
    }
    dem_domain_wrap(&state->domain, q);
    if (!dem_domain_contains(&state->domain, q->x) ||
        dem_flows_outlet_at(state->flows, q->x) != DEM_FLOW_NONE)
    {
        return DEM_OK;
    }
    return dem_wall_search_is_clear(grid->walls.search, grid->walls.walls, q, clear);
}

/* 1 in `passes` when the path from the inlet to x leads through a wall. A wall on the inlet itself
   does not count. */
static int path_passes(struct dem_state *state, const struct dem_inlet_grid *grid, double radius,
                       const double start[3], const double x[3], int *passes)
{
    struct dem_particle from = {.radius = radius}, to = {.radius = radius};
    double along[3];

    *passes = 0;
    dem_vec_minus(x, start, along);
    const double length = dem_vec_norm(along);

    if (length <= on_inlet*radius)
    {
        return DEM_OK;
    }
    for (int k = 0; k < 3; k++)
    {
        from.x[k] = start[k] + on_inlet*radius/length*along[k];
        to.x[k] = x[k];
    }
    dem_domain_project(&state->domain, &from);
    dem_domain_project(&state->domain, &to);
    return dem_wall_path_passes(grid->walls.search, grid->walls.walls, &state->domain, radius, from.x,
                                to.x, passes);
}

/* Trials of a position and a velocity, until one is free. `found`: 1 if one was. A particle that
   would have hit a wall since it entered begins on the inlet. */
static int find_position(struct dem_state *state, const struct dem_stream_trial *first,
                         const struct dem_inlet_grid *grid, struct dem_particle *q, int *found)
{
    struct dem_stream_trial t = *first;
    const struct dem_particle sphere = *q;
    double x[3], start[3];
    int passes;

    *found = 0;
    for (t.trial = 0; t.trial < TRIALS && !*found; t.trial++)
    {
        *q = sphere;
        if (!dem_stream_draw_position(grid->stream, &t, x, q->v, start))
        {
            continue;
        }
        memcpy(q->x, x, sizeof x);
        DEM_TRY(test_position(state, grid, q, found));
        if (*found)
        {
            DEM_TRY(path_passes(state, grid, q->radius, start, x, &passes));
            if (passes)
            {
                memcpy(q->x, start, sizeof start);
                q->image = sphere.image;
                DEM_TRY(test_position(state, grid, q, found));
            }
        }
    }
    return DEM_OK;
}

static int add_arrival(struct dem_state *state, int stream, struct dem_inlet_grid *grid,
                       const struct dem_particle *q)
{
    struct dem_flows *const f = state->flows;

    DEM_TRY(DEM_GROW(f->arrival, f->arrival_capacity, f->arrivals + 1));
    f->arrival[f->arrivals++] = (struct dem_arrival){
        .particle = *q, .stream = stream, .number = f->flow[stream].count};
    return dem_inlet_grid_insert(grid, q->x, q->radius);
}

/* Energy of rotation [J] of the next particle, which a body has in its orientation. */
static double rotation(const struct dem_stream *s, const struct dem_snapshot_flow *f, double density,
                       const struct dem_particle *q)
{
    struct dem_clump body;

    if (!s->clump.shape)
    {
        return 0.2*q->mass*q->radius*q->radius*dem_vec_dot(q->w, q->w);
    }
    dem_clump_source_make(&s->clump, (uint64_t)s->seed, f->count, density, q, &body);
    return 0.5*dem_vec_dot(body.momentum, q->w);
}

static void add_to_totals(struct dem_snapshot_flow *f, const struct dem_particle *q, double turning)
{
    f->count++;
    f->mass += q->mass;
    for (int k = 0; k < 3; k++)
    {
        f->momentum[k] += q->mass*q->v[k];
    }
    f->energy += 0.5*q->mass*dem_vec_dot(q->v, q->v) + turning;
}

/* One particle after the other, as they are due, until one finds no free position. */
static int insert_due(struct dem_state *state, int k, struct dem_inlet_grid *grid,
                      struct dem_stream_trial *t)
{
    struct dem_flows *const f = state->flows;
    const struct dem_stream *const s = &f->plan->stream[k];
    struct dem_snapshot_flow *const row = &f->flow[k];
    const double density = state->interaction_table.material[s->material].density,
                 zero[3] = {0.0, 0.0, 0.0};
    int found;

    for (;;)
    {
        struct dem_particle q =
            dem_particle_sphere(f->next_id, zero, dem_stream_diameter(s, row->count), density,
                                s->material);
        q.mass = dem_stream_mass(s, &state->interaction_table, row->count);
        const double due = row->owed + dem_stream_amount_due(s, row->since, state->time) -
                           (s->by_mass ? row->mass : (double)row->count);

        f->waiting[k] = is_due(s, row, due, q.mass) ? due : 0.0;
        if (f->waiting[k] == 0.0)
        {
            return DEM_OK;
        }
        t->number = row->count;
        t->radius = q.radius;
        memcpy(q.w, s->spin, sizeof q.w);
        DEM_TRY(find_position(state, t, grid, &q, &found));
        if (!found)
        {
            return DEM_OK;
        }
        DEM_REQUIRE(f->next_id < INT64_MAX - DEM_CLUMP_SPHERES, DEM_ERROR_INPUT,
                    "insert/%s: no 64-bit id is left for its next particle; give the initial "
                    "particles smaller ids", s->name);
        DEM_TRY(add_arrival(state, k, grid, &q));
        add_to_totals(row, &q, rotation(s, row, density, &q));
        f->next_id += dem_clump_source_ids(&s->clump);
    }
}

/* Collective; a rank that has failed before (`status`) takes part. Tests the amount due first: in
   the majority of checks nothing is due. */
static int check_stream(struct dem_state *state, int k, int64_t step, int status)
{
    struct dem_flows *const f = state->flows;
    const struct dem_stream *const s = &f->plan->stream[k];
    struct dem_snapshot_flow *const row = &f->flow[k];
    const double due = amount_owed(state, k), mass = next_mass(state, k);
    struct dem_stream_trial t = {.step = step,
                                 .ago = state->time - fmax(row->last, fmin(s->start, state->time))};
    struct dem_inlet_grid grid = {
        .domain = &state->domain, .stream = s, .max_radius = 0.5*s->sizes.max};
    const double travel = dem_stream_max_travel(s, t.ago, 0.5*s->sizes.max);

    row->last = state->time;
    f->waiting[k] = 0.0;
    if (!is_due(s, row, due, mass) || (s->inlet.kind == DEM_INLET_FACES && s->inlet.n == 0))
    {
        return status;
    }
    dem_inlet_shape_bounds(&s->inlet, grid.min, grid.max);
    for (int a = 0; a < 3; a++)
    {
        grid.min[a] -= travel;
        grid.max[a] += travel;
    }
    double box[2][3];

    memcpy(box[0], grid.min, sizeof box[0]);
    memcpy(box[1], grid.max, sizeof box[1]);
    status = dem_inlet_grid_gather(&grid, state, status);
    status = dem_inlet_walls_gather(&grid.walls, state, status, box, s->sizes.max);
    status = status ? status : dem_inlet_grid_make(&grid);
    status = status ? status : insert_due(state, k, &grid, &t);
    dem_inlet_grid_free(&grid);
    return status;
}

int dem_flows_find_positions(struct dem_state *state, int64_t step)
{
    int status = DEM_OK;

    for (int k = 0; k < state->flows->plan->streams; k++)
    {
        status = check_stream(state, k, step, status);
    }
    return status;
}
