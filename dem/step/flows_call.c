/*
 * flows_call.c -- finding room: who is in the way, gathered from all ranks, and the same trials on each of them.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "step/flows.h"
#include "base/error.h"
#include "base/memory.h"
#include "base/vec.h"
#include "step/parts.h"
#include <limits.h>
#include <math.h>
#include <string.h>

enum
{
    TRIALS = 200,                                         /* places for one particle at one look */
    MOST_CELLS = 1 << 18,
    NOBODY = -1
};

/* Owed is what a count comes to when it is taken in doubles: this share of a particle less is none. */
static const double nearly = 1e-9;

/* Far above the round-off of a distance and of bringing a position to a multiple of the domain's unit. */
static const double surely = 1.0 + 1e-12;

struct body                                               /* in the way */
{
    double x[3], radius;
};

struct room                                               /* around one mouth */
{
    const struct dem_domain *domain;
    const struct dem_stream *stream;
    double min[3], max[3];                                /* m: of centres that a trial may give */
    double most;                                          /* m: largest radius of all that are in the way or come */
    double edge;
    int cells[3];
    int *head, *next;                                     /* by cell; by body */
    size_t n, body_room, next_room;
    struct body *body;
};

/* ---- who is in the way --------------------------------------------------------------------------------------- */

static int is_near(const struct room *r, const double x[3], double reach)
{
    int near = 1;

    for (int k = 0; k < 3; k++)
    {
        near &= x[k] >= r->min[k] - reach && x[k] <= r->max[k] + reach;
    }
    return near;
}

/* Each image of a sphere that is near the mouth is one of those in the way. */
static int add_images(struct room *r, const double x[3], double radius, double reach)
{
    const struct dem_domain *const d = r->domain;
    int from[3] = {0, 0, 0}, to[3] = {0, 0, 0}, at[3];

    for (int k = 0; k < 3; k++)
    {
        if (d->periodic[k])
        {
            from[k] = (int)ceil((r->min[k] - reach - x[k])/d->length[k]);
            to[k] = (int)floor((r->max[k] + reach - x[k])/d->length[k]);
        }
    }
    for (at[2] = from[2]; at[2] <= to[2]; at[2]++)
    {
        for (at[1] = from[1]; at[1] <= to[1]; at[1]++)
        {
            for (at[0] = from[0]; at[0] <= to[0]; at[0]++)
            {
                const double there[3] = {x[0] + at[0]*d->length[0], x[1] + at[1]*d->length[1], x[2] + at[2]*d->length[2]};

                if (is_near(r, there, reach))
                {
                    DEM_TRY(DEM_GROW(r->body, r->body_room, r->n + 1));
                    r->body[r->n] = (struct body){.radius = radius};
                    memcpy(r->body[r->n++].x, there, sizeof there);
                }
            }
        }
    }
    return DEM_OK;
}

static int gather(struct dem_parts *p, struct room *r, int status)
{
    int *count, *start, all = 0, worst = status ? INT_MAX/4 : (int)(4*r->n);
    const int mine = worst;
    struct body *body;

    if (p->pieces.ranks == 1)
    {
        return status;
    }
    DEM_TRY(DEM_NEW(count, p->pieces.ranks));
    DEM_TRY(DEM_NEW(start, p->pieces.ranks));
    MPI_Allgather(&mine, 1, MPI_INT, count, 1, MPI_INT, p->pieces.comm);
    for (int k = 0; k < p->pieces.ranks && all >= 0; k++)
    {
        start[k] = all;
        all = count[k] >= INT_MAX/4 || all > INT_MAX - count[k] ? -1 : all + count[k];
    }
    status = status ? status : all < 0 ? dem_error(DEM_ERROR_MEMORY, "another rank failed, or too many particles are at the mouth of a stream; "
                                                   "its message tells why") : DEM_OK;
    if (!status)
    {
        DEM_TRY(DEM_NEW(body, (size_t)all/4 + 1));
        MPI_Allgatherv(r->body, mine, MPI_DOUBLE, body, count, start, MPI_DOUBLE, p->pieces.comm);
        dem_memory_free(r->body);
        r->body = body;
        r->n = (size_t)all/4;
        r->body_room = r->n + 1;
    }
    dem_memory_free(count);
    dem_memory_free(start);
    return status;
}

static int find_bodies(struct dem_parts *p, struct room *r)
{
    int status = DEM_OK;

    for (size_t i = 0; i < p->particles.n && !status; i++)
    {
        const struct dem_particle *const q = &p->particles.record[i];

        status = add_images(r, q->x, q->radius, q->radius + r->most);
    }
    for (size_t k = 0; k < p->flows.arrivals && p->pieces.rank == 0 && !status; k++)
    {
        const struct dem_particle *const q = &p->flows.arrival[k].particle;

        status = add_images(r, q->x, q->radius, q->radius + r->most);
    }
    return gather(p, r, status);
}

/* ---- a grid of them ------------------------------------------------------------------------------------------ */

static int cell_on(const struct room *r, int k, double x)
{
    const double at = (x - r->min[k])/r->edge;

    return !(at > 0.0) ? 0 : at >= r->cells[k] ? r->cells[k] - 1 : (int)at;
}

static int enter(struct room *r, size_t b)
{
    const double *const x = r->body[b].x;
    int *const head = &r->head[(cell_on(r, 2, x[2])*r->cells[1] + cell_on(r, 1, x[1]))*r->cells[0] + cell_on(r, 0, x[0])];

    DEM_TRY(DEM_GROW(r->next, r->next_room, b + 1));
    r->next[b] = *head;
    *head = (int)b;
    return DEM_OK;
}

/* Cells are as wide as the largest sphere, or more where there would be too many. */
static int make_grid(struct room *r)
{
    double cells;

    for (size_t b = 0; b < r->n; b++)
    {
        r->most = fmax(r->most, r->body[b].radius);
    }
    r->edge = 2.0*r->most;
    do
    {
        cells = 1.0;
        for (int k = 0; k < 3; k++)
        {
            cells *= r->cells[k] = (int)fmin(MOST_CELLS, (r->max[k] - r->min[k])/r->edge) + 1;
        }
        r->edge *= cells > MOST_CELLS ? 1.26 : 1.0;
    } while (cells > MOST_CELLS);
    DEM_TRY(DEM_NEW(r->head, (size_t)cells));
    for (size_t c = 0; c < (size_t)cells; c++)
    {
        r->head[c] = NOBODY;
    }
    for (size_t b = 0; b < r->n; b++)
    {
        DEM_TRY(enter(r, b));
    }
    return DEM_OK;
}

static int is_clear(const struct room *r, const double x[3], double radius)
{
    const double reach = radius + r->most;
    int from[3], to[3];

    for (int k = 0; k < 3; k++)
    {
        from[k] = cell_on(r, k, x[k] - reach);
        to[k] = cell_on(r, k, x[k] + reach);
    }
    for (int z = from[2]; z <= to[2]; z++)
    {
        for (int y = from[1]; y <= to[1]; y++)
        {
            for (int c = from[0]; c <= to[0]; c++)
            {
                for (int b = r->head[(z*r->cells[1] + y)*r->cells[0] + c]; b != NOBODY; b = r->next[b])
                {
                    const double apart = surely*(radius + r->body[b].radius);
                    double d[3];

                    dem_vec_minus(x, r->body[b].x, d);
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

static void free_room(struct room *r)
{
    dem_memory_free(r->head);
    dem_memory_free(r->next);
    dem_memory_free(r->body);
}

/* ---- a stream ------------------------------------------------------------------------------------------------ */

/* Number k is owed whole. */
static int is_owed(const struct dem_stream *s, const struct dem_snapshot_flow *f, double owed, double mass)
{
    const int within = f->count < s->count && !(f->mass + 0.5*mass > s->mass);

    return within && (s->by_mass ? owed + nearly*mass >= mass : owed + nearly >= 1.0);
}

/* Many trials, each of them a sphere at x with v, until it has room. */
static int find_place(struct dem_parts *p, const struct dem_stream_trial *first, const struct room *r, struct dem_particle *q, int *found)
{
    struct dem_stream_trial t = *first;

    *found = 0;
    for (t.trial = 0; t.trial < TRIALS && !*found; t.trial++)
    {
        if (!dem_stream_place(r->stream, &t, q->x, q->v) || !dem_domain_lay(&p->domain, q) || !is_near(r, q->x, 0.0) || !is_clear(r, q->x, q->radius))
        {
            continue;
        }
        dem_domain_wrap(&p->domain, q);
        if (dem_domain_holds(&p->domain, q->x) && dem_flows_outlet(&p->flows, q->x) == DEM_FLOW_NONE)
        {
            DEM_TRY(dem_wall_search_is_clear(&p->pairs.search, &p->walls, q, found));
        }
    }
    return DEM_OK;
}

static int take_place(struct dem_parts *p, int stream, struct room *r, const struct dem_particle *q)
{
    struct dem_flows *const f = &p->flows;
    const size_t before = r->n;

    DEM_TRY(DEM_GROW(f->arrival, f->arrival_room, f->arrivals + 1));
    f->arrival[f->arrivals++] = (struct dem_arrival){.particle = *q, .stream = stream};
    DEM_TRY(add_images(r, q->x, q->radius, q->radius + r->most));
    for (size_t b = before; b < r->n; b++)
    {
        DEM_TRY(enter(r, b));
    }
    return DEM_OK;
}

static void count_in(struct dem_snapshot_flow *f, const struct dem_particle *q)
{
    f->count++;
    f->mass += q->mass;
    for (int k = 0; k < 3; k++)
    {
        f->momentum[k] += q->mass*q->v[k];
    }
    f->energy += 0.5*q->mass*dem_vec_dot(q->v, q->v) + 0.2*q->mass*q->radius*q->radius*dem_vec_dot(q->w, q->w);
}

/* One after the other, as they are owed, until one finds no room. */
static int fill(struct dem_parts *p, int k, struct room *r, struct dem_stream_trial *t)
{
    struct dem_flows *const f = &p->flows;
    const struct dem_stream *const s = &f->plan->stream[k];
    struct dem_snapshot_flow *const row = &f->flow[k];
    const double density = p->recipe.material[s->material].density, zero[3] = {0.0, 0.0, 0.0};
    int found;

    for (;;)
    {
        struct dem_particle q = dem_particle_sphere(f->next_id, zero, dem_stream_diameter(s, row->count), density, s->material);
        const double owed = row->owed + dem_stream_owes(s, row->since, p->time) - (s->by_mass ? row->mass : (double)row->count);

        f->waiting[k] = is_owed(s, row, owed, q.mass) ? owed : 0.0;
        if (f->waiting[k] == 0.0)
        {
            return DEM_OK;
        }
        t->number = row->count;
        t->radius = q.radius;
        memcpy(q.w, s->spin, sizeof q.w);
        DEM_TRY(find_place(p, t, r, &q, &found));
        if (!found)
        {
            return DEM_OK;
        }
        DEM_REQUIRE(f->next_id < INT64_MAX, DEM_ERROR_INPUT, "insert/%s: no id is left for its next particle", s->name);
        DEM_TRY(take_place(p, k, r, &q));
        count_in(row, &q);
        f->next_id++;
    }
}

/* Looks at one number first: most looks find nothing owed. */
static int call_stream(struct dem_parts *p, int k, int64_t step)
{
    struct dem_flows *const f = &p->flows;
    const struct dem_stream *const s = &f->plan->stream[k];
    struct dem_snapshot_flow *const row = &f->flow[k];
    const double owed = row->owed + dem_stream_owes(s, row->since, p->time) - (s->by_mass ? row->mass : (double)row->count);
    const double mass = p->recipe.material[s->material].density*dem_sphere_volume(0.5*dem_stream_diameter(s, row->count));
    struct dem_stream_trial t = {.step = step, .ago = p->time - fmax(row->last, fmin(s->start, p->time))};
    struct room r = {.domain = &p->domain, .stream = s, .most = 0.5*s->sizes.most};
    const double way = dem_stream_way(s, t.ago, 0.5*s->sizes.most);

    row->last = p->time;
    f->waiting[k] = 0.0;
    if (!is_owed(s, row, owed, mass) || (s->mouth.kind == DEM_MOUTH_FACES && s->mouth.n == 0))
    {
        return DEM_OK;
    }
    dem_mouth_box(&s->mouth, r.min, r.max);
    for (int a = 0; a < 3; a++)
    {
        r.min[a] -= way;
        r.max[a] += way;
    }
    int status = find_bodies(p, &r);

    status = status ? status : make_grid(&r);
    status = status ? status : fill(p, k, &r, &t);
    free_room(&r);
    return status;
}

int dem_flows_call(struct dem_parts *p, int64_t step)
{
    for (int k = 0; k < p->flows.plan->streams; k++)
    {
        DEM_TRY(call_stream(p, k, step));
    }
    return DEM_OK;
}
