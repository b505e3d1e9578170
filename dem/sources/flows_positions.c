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
#include "sources/inlet_walls.h"
#include "core/error.h"
#include "core/memory.h"
#include "core/vec.h"
#include "walls/wall_path.h"
#include "ranks/collect.h"
#include "ranks/dem_state.h"
#include <math.h>
#include <string.h>

enum
{
    TRIALS = 200,  /* positions for one particle at one check */
    MAX_CELLS = 1 << 18,
    NONE = -1
};

/* The amount due is a floating-point number: a particle is due when at most this fraction of it is
   missing. */
static const double tolerance = 1e-9;

/* Factor on distances, far above the round-off of a distance and of rounding a position to a
   multiple of the domain's unit of length. */
static const double margin = 1.0 + 1e-12;

/* Walls within this fraction of the radius of the inlet are taken to lie on it. */
static const double on_inlet = 1e-3;

struct body                                               /* a sphere near the inlet */
{
    double x[3], radius;
};

struct inlet_grid    /* spheres around the inlet of one stream */
{
    const struct dem_domain *domain;
    const struct dem_stream *stream;
    double min[3], max[3];  /* m: of centres that trials may produce */
    double max_radius;      /* m: of all spheres gathered or inserted */
    double edge;            /* m: of a cell */
    int cells[3];
    int *head, *next;       /* first body of each cell; next body of each body */
    size_t n, body_capacity, next_capacity;
    struct body *body;
    struct dem_inlet_walls walls;
};

/* ---- spheres near the inlet ------------------------------------------------------------------ */

static int is_near(const struct inlet_grid *grid, const double x[3], double reach)
{
    int near = 1;

    for (int k = 0; k < 3; k++)
    {
        near &= x[k] >= grid->min[k] - reach && x[k] <= grid->max[k] + reach;
    }
    return near;
}

/* Add all periodic images of a sphere that are near the inlet. */
static int add_images(struct inlet_grid *grid, const double x[3], double radius, double reach)
{
    const struct dem_domain *const d = grid->domain;
    int from[3] = {0, 0, 0}, to[3] = {0, 0, 0}, at[3];

    for (int k = 0; k < 3; k++)
    {
        if (d->periodic[k])
        {
            from[k] = (int)ceil((grid->min[k] - reach - x[k])/d->length[k]);
            to[k] = (int)floor((grid->max[k] + reach - x[k])/d->length[k]);
        }
    }
    for (at[2] = from[2]; at[2] <= to[2]; at[2]++)
    {
        for (at[1] = from[1]; at[1] <= to[1]; at[1]++)
        {
            for (at[0] = from[0]; at[0] <= to[0]; at[0]++)
            {
                const double there[3] = {x[0] + at[0]*d->length[0], x[1] + at[1]*d->length[1],
                                         x[2] + at[2]*d->length[2]};

                if (is_near(grid, there, reach))
                {
                    DEM_TRY(DEM_GROW(grid->body, grid->body_capacity, grid->n + 1));
                    grid->body[grid->n] = (struct body){.radius = radius};
                    memcpy(grid->body[grid->n++].x, there, sizeof there);
                }
            }
        }
    }
    return DEM_OK;
}

/* Collective; `status`: of this rank. The spheres of all ranks replace this rank's. */
static int gather(struct dem_state *p, struct inlet_grid *grid, int status)
{
    const struct dem_collect_items own = {"particles near the inlet of a stream", grid->body,
                                          grid->n, sizeof *grid->body};
    void *all;

    if (p->decomposition.ranks == 1)
    {
        return status;
    }
    DEM_TRY(dem_collect_gather(&p->decomposition, status, &own, &all, &grid->n));
    dem_memory_free(grid->body);
    grid->body = all;
    grid->body_capacity = grid->n;
    return DEM_OK;
}

static int find_bodies(struct dem_state *p, struct inlet_grid *grid, int status)
{
    for (size_t i = 0; i < p->particles.n && !status; i++)
    {
        const struct dem_particle *const q = &p->particles.record[i];

        status = add_images(grid, q->x, q->radius, q->radius + grid->max_radius);
    }
    for (size_t k = 0; k < p->flows->arrivals && p->decomposition.rank == 0 && !status; k++)
    {
        const struct dem_particle *const q = &p->flows->arrival[k].particle;

        status = add_images(grid, q->x, q->radius, q->radius + grid->max_radius);
    }
    return gather(p, grid, status);
}

/* ---- grid ------------------------------------------------------------------------------------ */

static int cell_along(const struct inlet_grid *grid, int k, double x)
{
    const double at = (x - grid->min[k])/grid->edge;

    return !(at > 0.0) ? 0 : at >= grid->cells[k] ? grid->cells[k] - 1 : (int)at;
}

static int add_to_cell(struct inlet_grid *grid, size_t b)
{
    const double *const x = grid->body[b].x;
    const int at[3] = {cell_along(grid, 0, x[0]), cell_along(grid, 1, x[1]),
                       cell_along(grid, 2, x[2])};
    int *const head = &grid->head[(at[2]*grid->cells[1] + at[1])*grid->cells[0] + at[0]];

    DEM_TRY(DEM_GROW(grid->next, grid->next_capacity, b + 1));
    grid->next[b] = *head;
    *head = (int)b;
    return DEM_OK;
}

/* Cells are as wide as the largest sphere, or wider if there would be too many. */
static int make_grid(struct inlet_grid *grid)
{
    double cells;

    for (size_t b = 0; b < grid->n; b++)
    {
        grid->max_radius = fmax(grid->max_radius, grid->body[b].radius);
    }
    grid->edge = 2.0*grid->max_radius;
    do
    {
        cells = 1.0;
        for (int k = 0; k < 3; k++)
        {
            cells *= grid->cells[k] =
                (int)fmin(MAX_CELLS, (grid->max[k] - grid->min[k])/grid->edge) + 1;
        }
        grid->edge *= cells > MAX_CELLS ? 1.26 : 1.0;
    } while (cells > MAX_CELLS);
    DEM_TRY(DEM_NEW(grid->head, (size_t)cells));
    for (size_t c = 0; c < (size_t)cells; c++)
    {
        grid->head[c] = NONE;
    }
    for (size_t b = 0; b < grid->n; b++)
    {
        DEM_TRY(add_to_cell(grid, b));
    }
    return DEM_OK;
}

static int is_clear(const struct inlet_grid *grid, const double x[3], double radius)
{
    const double reach = radius + grid->max_radius;
    int from[3], to[3];

    for (int k = 0; k < 3; k++)
    {
        from[k] = cell_along(grid, k, x[k] - reach);
        to[k] = cell_along(grid, k, x[k] + reach);
    }
    for (int z = from[2]; z <= to[2]; z++)
    {
        for (int y = from[1]; y <= to[1]; y++)
        {
            for (int c = from[0]; c <= to[0]; c++)
            {
                for (int b = grid->head[(z*grid->cells[1] + y)*grid->cells[0] + c]; b != NONE;
                     b = grid->next[b])
                {
                    const double apart = margin*(radius + grid->body[b].radius);
                    double d[3];

                    dem_vec_minus(x, grid->body[b].x, d);
                    if (dem_vec_dot(d, d) < apart*apart)
                    {
                        return 0;
                    }
                }
            }
        }
    }
    return 1;
}

static void free_grid(struct inlet_grid *grid)
{
    dem_inlet_walls_free(&grid->walls);
    dem_memory_free(grid->head);
    dem_memory_free(grid->next);
    dem_memory_free(grid->body);
}

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
static double next_mass(const struct dem_state *p, int k)
{
    const struct dem_stream *const s = &p->flows->plan->stream[k];

    return p->interaction_table.material[s->material].density*
           dem_sphere_volume(0.5*dem_stream_diameter(s, p->flows->flow[k].count));
}

/* particles or kg  due now and not yet inserted */
static double amount_owed(const struct dem_state *p, int k)
{
    const struct dem_stream *const s = &p->flows->plan->stream[k];
    const struct dem_snapshot_flow *const row = &p->flows->flow[k];

    return row->owed + dem_stream_amount_due(s, row->since, p->time) -
           (s->by_mass ? row->mass : (double)row->count);
}

/* 1 in `clear` when the particle overlaps no sphere and no wall and lies in the domain; then it is
   wrapped. */
static int test_position(struct dem_state *p, const struct inlet_grid *grid,
                         struct dem_particle *q, int *clear)
{
    *clear = 0;
    if (!dem_domain_project(&p->domain, q) || !is_near(grid, q->x, 0.0) ||
        !is_clear(grid, q->x, q->radius))
    {
        return DEM_OK;
    }
    dem_domain_wrap(&p->domain, q);
    if (!dem_domain_contains(&p->domain, q->x) ||
        dem_flows_outlet_at(p->flows, q->x) != DEM_FLOW_NONE)
    {
        return DEM_OK;
    }
    return dem_wall_search_is_clear(grid->walls.search, grid->walls.walls, q, clear);
}

/* 1 in `passes` when the path from the inlet to x leads through a wall. A wall on the inlet itself
   does not count. */
static int path_passes(struct dem_state *p, const struct inlet_grid *grid, double radius,
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
    dem_domain_project(&p->domain, &from);
    dem_domain_project(&p->domain, &to);
    return dem_wall_path_passes(grid->walls.search, grid->walls.walls, &p->domain, radius, from.x,
                                to.x, passes);
}

/* Trials of a position and a velocity, until one is free. `found`: 1 if one was. A particle that
   would have hit a wall since it entered begins on the inlet. */
static int find_position(struct dem_state *p, const struct dem_stream_trial *first,
                         const struct inlet_grid *grid, struct dem_particle *q, int *found)
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
        DEM_TRY(test_position(p, grid, q, found));
        if (*found)
        {
            DEM_TRY(path_passes(p, grid, q->radius, start, x, &passes));
            if (passes)
            {
                memcpy(q->x, start, sizeof start);
                q->image = sphere.image;
                DEM_TRY(test_position(p, grid, q, found));
            }
        }
    }
    return DEM_OK;
}

static int add_arrival(struct dem_state *p, int stream, struct inlet_grid *grid,
                       const struct dem_particle *q)
{
    struct dem_flows *const f = p->flows;
    const size_t before = grid->n;

    DEM_TRY(DEM_GROW(f->arrival, f->arrival_capacity, f->arrivals + 1));
    f->arrival[f->arrivals++] = (struct dem_arrival){
        .particle = *q, .stream = stream, .number = f->flow[stream].count};
    DEM_TRY(add_images(grid, q->x, q->radius, q->radius + grid->max_radius));
    for (size_t b = before; b < grid->n; b++)
    {
        DEM_TRY(add_to_cell(grid, b));
    }
    return DEM_OK;
}

static void add_to_totals(struct dem_snapshot_flow *f, const struct dem_particle *q)
{
    f->count++;
    f->mass += q->mass;
    for (int k = 0; k < 3; k++)
    {
        f->momentum[k] += q->mass*q->v[k];
    }
    f->energy += 0.5*q->mass*dem_vec_dot(q->v, q->v) +
                 0.2*q->mass*q->radius*q->radius*dem_vec_dot(q->w, q->w);
}

/* One particle after the other, as they are due, until one finds no free position. */
static int insert_due(struct dem_state *p, int k, struct inlet_grid *grid,
                      struct dem_stream_trial *t)
{
    struct dem_flows *const f = p->flows;
    const struct dem_stream *const s = &f->plan->stream[k];
    struct dem_snapshot_flow *const row = &f->flow[k];
    const double density = p->interaction_table.material[s->material].density,
                 zero[3] = {0.0, 0.0, 0.0};
    int found;

    for (;;)
    {
        struct dem_particle q =
            dem_particle_sphere(f->next_id, zero, dem_stream_diameter(s, row->count), density,
                                s->material);
        const double due = row->owed + dem_stream_amount_due(s, row->since, p->time) -
                           (s->by_mass ? row->mass : (double)row->count);

        f->waiting[k] = is_due(s, row, due, q.mass) ? due : 0.0;
        if (f->waiting[k] == 0.0)
        {
            return DEM_OK;
        }
        t->number = row->count;
        t->radius = q.radius;
        memcpy(q.w, s->spin, sizeof q.w);
        DEM_TRY(find_position(p, t, grid, &q, &found));
        if (!found)
        {
            return DEM_OK;
        }
        DEM_REQUIRE(f->next_id < INT64_MAX, DEM_ERROR_INPUT,
                    "insert/%s: no 64-bit id is left for its next particle; give the initial "
                    "particles smaller ids", s->name);
        DEM_TRY(add_arrival(p, k, grid, &q));
        add_to_totals(row, &q);
        f->next_id++;
    }
}

/* Collective; a rank that has failed before (`status`) takes part. Tests the amount due first: in
   the majority of checks nothing is due. */
static int check_stream(struct dem_state *p, int k, int64_t step, int status)
{
    struct dem_flows *const f = p->flows;
    const struct dem_stream *const s = &f->plan->stream[k];
    struct dem_snapshot_flow *const row = &f->flow[k];
    const double due = amount_owed(p, k), mass = next_mass(p, k);
    struct dem_stream_trial t = {.step = step,
                                 .ago = p->time - fmax(row->last, fmin(s->start, p->time))};
    struct inlet_grid grid = {.domain = &p->domain, .stream = s, .max_radius = 0.5*s->sizes.max};
    const double travel = dem_stream_max_travel(s, t.ago, 0.5*s->sizes.max);

    row->last = p->time;
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
    status = find_bodies(p, &grid, status);
    status = dem_inlet_walls_gather(&grid.walls, p, status, box, s->sizes.max);
    status = status ? status : make_grid(&grid);
    status = status ? status : insert_due(p, k, &grid, &t);
    free_grid(&grid);
    return status;
}

int dem_flows_find_positions(struct dem_state *p, int64_t step)
{
    int status = DEM_OK;

    for (int k = 0; k < p->flows->plan->streams; k++)
    {
        status = check_stream(p, k, step, status);
    }
    return status;
}
